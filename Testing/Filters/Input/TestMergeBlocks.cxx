// SPDX-License-Identifier: BSD-3-Clause
//
// The blocks of a composite data set triangulated together, through the pipeline.
#include "FilterTestSupport.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

using namespace ahdtest;

namespace
{
struct Tiles
{
  Tiles()
  {
    this->All = latticePoints(900, 60); // some at the same place
    for (unsigned tile = 0; tile < 3; ++tile)
    {
      const std::vector<Xyz> part(
        this->All.begin() + 300 * tile, this->All.begin() + 300 * (tile + 1));
      auto cloud = makeCloud(part);
      vtkNew<vtkDoubleArray> number;
      number->SetName("number");
      for (unsigned i = 0; i < 300; ++i)
      {
        number->InsertNextValue(300 * tile + i);
      }
      cloud->GetPointData()->AddArray(number);
      this->Blocks->SetBlock(tile + 1, cloud); // the first is missing
    }
  }

  std::vector<Xyz> All;
  vtkNew<vtkMultiBlockDataSet> Blocks;
};
}

TEST(MergeBlocks, AllPointsBecomeOneSurface)
{
  Tiles tiles;
  WatchedFilter filter;
  filter->SetInputDataObject(tiles.Blocks);
  filter->MergeBlocksOn();
  filter->Update();
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(trianglesOf(surface), triangulate(tiles.All));
  ASSERT_EQ(surface->GetNumberOfPoints(), 900);
  for (vtkIdType i = 0; i < 900; ++i)
  {
    EXPECT_EQ(surface->GetPointData()->GetArray("number")->GetComponent(i, 0), double(i));
  }
  EXPECT_TRUE(filter.Said->Warnings.empty());
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
}

TEST(MergeBlocks, ItCanBeSwitchedOnAndOff)
{
  Tiles tiles;
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputDataObject(tiles.Blocks);
  EXPECT_FALSE(filter->GetMergeBlocks());
  for (int round = 0; round < 3; ++round)
  {
    filter->MergeBlocksOff();
    filter->Update();
    auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(made, nullptr);
    EXPECT_EQ(made->GetNumberOfBlocks(), 4u);
    EXPECT_EQ(vtkPolyData::SafeDownCast(made->GetBlock(1))->GetNumberOfPoints(), 300);
    filter->MergeBlocksOn();
    filter->Update();
    auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(surface, nullptr);
    EXPECT_EQ(trianglesOf(surface), triangulate(tiles.All));
  }
}

TEST(MergeBlocks, OnePointSetIsTakenAsItIs)
{
  auto cloud = makeCloud(scatteredPoints(100));
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->MergeBlocksOn();
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPoints(), cloud->GetPoints());
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(scatteredPoints(100)));
  Tiles tiles; // and from one to the other
  filter->SetInputDataObject(tiles.Blocks);
  filter->Update();
  EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 900);
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPoints(), cloud->GetPoints());
}

TEST(MergeBlocks, PartitionsAndCollectionsAreMerged)
{
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, makeCloud({ { 0, 0, 0 }, { 1, 0, 0 } }));
  parts->SetPartition(1, makeCloud({ { 0, 1, 0 } }));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, parts);
  for (vtkDataObject* data :
    { static_cast<vtkDataObject*>(parts.Get()), static_cast<vtkDataObject*>(collection.Get()) })
  {
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->MergeBlocksOn();
    filter->SetInputDataObject(data);
    filter->Update();
    EXPECT_EQ(trianglesOf(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))),
      (std::vector<Triangle>{ { 0, 1, 2 } }))
      << data->GetClassName();
  }
}

TEST(MergeBlocks, GhostsOfABlockAreLeftOut)
{
  Tiles tiles;
  auto* cloud = vtkPolyData::SafeDownCast(tiles.Blocks->GetBlock(2));
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(300);
  marks->FillValue(0);
  marks->SetValue(7, vtkDataSetAttributes::DUPLICATEPOINT);
  cloud->GetPointData()->AddArray(marks);
  WatchedFilter filter;
  filter->MergeBlocksOn();
  filter->GenerateFateOn();
  filter->SetInputDataObject(tiles.Blocks);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 1);
  EXPECT_EQ(idsOf(filter->GetOutput()->GetPointData(), "Fate")[307], -2);
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(MergeBlocks, MarksThatDoNotFitAreWarnedOf)
{
  Tiles tiles;
  for (unsigned tile : { 1u, 3u })
  {
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfValues(4);
    marks->FillValue(vtkDataSetAttributes::HIDDENPOINT);
    vtkPolyData::SafeDownCast(tiles.Blocks->GetBlock(tile))->GetPointData()->AddArray(marks);
  }
  WatchedFilter filter;
  filter->MergeBlocksOn();
  filter->SetInputDataObject(tiles.Blocks);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 0);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("In 2 blocks"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("vtkGhostType"), std::string::npos);
}

TEST(MergeBlocks, OneWarningForAllBlocksWithoutPoints)
{
  Tiles tiles;
  tiles.Blocks->SetBlock(4, vtkNew<vtkImageData>());
  tiles.Blocks->SetBlock(5, vtkNew<vtkPolyData>());
  tiles.Blocks->SetBlock(6, vtkNew<vtkImageData>());
  WatchedFilter filter;
  filter->MergeBlocksOn();
  filter->SetInputDataObject(tiles.Blocks);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 900);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("2 blocks"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("vtkImageData"), std::string::npos);
}

TEST(MergeBlocks, NoBlocksNoTriangles)
{
  WatchedFilter filter;
  filter->MergeBlocksOn();
  filter->SetInputDataObject(vtkNew<vtkMultiBlockDataSet>());
  filter->Update();
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(surface->GetNumberOfCells(), 0);
  EXPECT_TRUE(filter.Said->Warnings.empty());
  EXPECT_TRUE(filter.Said->Errors.empty());
}

/// As many as no execution takes are refused before they are copied.
TEST(MergeBlocks, TooManyPointsAreRefused)
{
  vtkNew<vtkPoints> points; // never read
  points->SetNumberOfPoints(vtkIdType(1) << 20);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned k = 0; k < 256; ++k)
  {
    blocks->SetBlock(k, cloud);
  }
  WatchedFilter filter;
  filter->MergeBlocksOn();
  filter->SetMemoryLimit(1000); // for the copy of so many there is none
  filter->SetInputDataObject(blocks);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(filter.Said->Errors[0].find("268435456 points are too many"), std::string::npos)
    << filter.Said->Errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(MergeBlocks, TheCopyIsPartOfTheEstimate)
{
  Tiles tiles;
  WatchedFilter filter;
  filter->SetInputData(makeCloud(tiles.All));
  filter->Update();
  const vtkTypeInt64 without = filter->GetMemoryEstimate();
  filter->MergeBlocksOn();
  filter->SetInputDataObject(tiles.Blocks);
  filter->Update();
  const vtkTypeInt64 with = filter->GetMemoryEstimate();
  EXPECT_GE(with, without + (24 + 8) * 900 / 1024);
  for (vtkTypeInt64 limit : { vtkTypeInt64(1), with - 1 })
  {
    filter->SetMemoryLimit(limit);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0) << "limit " << limit;
    ASSERT_EQ(filter.Said->Errors.size(), 1u) << "limit " << limit;
    filter.Said->Errors.clear();
    EXPECT_TRUE(filter.PipelineSaid->Errors.empty());
  }
  filter->SetMemoryLimit(with);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MergeBlocks, TheCopiesOfInputAndSourceAreBothPartOfTheEstimate)
{
  Tiles tiles, source;
  WatchedFilter filter;
  const auto estimate = [&filter](vtkDataObject* input)
  {
    filter->SetInputDataObject(input);
    filter->Update();
    return filter->GetMemoryEstimate();
  };
  filter->MergeBlocksOn();
  filter->SetSourceModeToCoordinates();
  filter->SetInputDataObject(1, source.Blocks);
  const vtkTypeInt64 ofSource = estimate(makeCloud(tiles.All));
  const vtkTypeInt64 ofBoth = estimate(tiles.Blocks);
  filter->SetInputDataObject(1, makeCloud(source.All));
  const vtkTypeInt64 ofInput = estimate(tiles.Blocks);
  const vtkTypeInt64 ofNone = estimate(makeCloud(tiles.All));
  // coordinates and array; the same again and some for rounding at most
  const vtkTypeInt64 least = (24 + 8) * 900 / 1024, most = 2 * least + 10;
  for (const vtkTypeInt64 copy :
    { ofSource - ofNone, ofBoth - ofInput, ofInput - ofNone, ofBoth - ofSource })
  {
    EXPECT_GE(copy, least);
    EXPECT_LE(copy, most);
  }
}

TEST(MergeBlocks, TilesThatStayAreKept)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->MergeBlocksOn();
  vtkNew<vtkTrivialProducer> producer;
  filter->SetInputConnection(producer->GetOutputPort());
  for (int step = 0; step < 4; ++step)
  {
    Tiles tiles; // new objects
    vtkPolyData::SafeDownCast(tiles.Blocks->GetBlock(1))
      ->GetPointData()
      ->GetArray("number")
      ->SetComponent(0, 0, 100.0 + step);
    producer->SetOutput(tiles.Blocks);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfTriangulations(), step == 0 ? 1 : 2);
    EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(tiles.All));
    EXPECT_EQ(
      filter->GetOutput()->GetPointData()->GetArray("number")->GetComponent(0, 0), 100.0 + step);
  }
}
