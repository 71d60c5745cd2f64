// SPDX-License-Identifier: BSD-3-Clause
//
// What must not be passed on from one execution to another, and must not be held longer than it is
// of use.
#include "KeptTestSupport.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkWeakPointer.h"

#include <gtest/gtest.h>

#include <functional>

using namespace ahdtest;

namespace
{
void setTime(vtkDataObject* data, double time)
{
  vtkNew<vtkDoubleArray> value;
  value->SetName("TimeValue");
  value->InsertNextValue(time);
  data->GetFieldData()->AddArray(value);
}

double timeOf(vtkDataObject* data)
{
  vtkDataArray* value = data->GetFieldData()->GetArray("TimeValue");
  return value ? value->GetComponent(0, 0) : -1;
}

/// Does something at the first progress from a given one on.
class AtProgress : public vtkCommand
{
public:
  static AtProgress* New() { return new AtProgress; }

  void Execute(vtkObject*, unsigned long, void* amount) override
  {
    if (this->Do && *static_cast<double*>(amount) >= this->From)
    {
      this->Do();
      this->Do = nullptr;
    }
  }

  std::function<void()> Do;
  double From = 0.0;
};
}

TEST(KeptStale, FieldDataAreThoseOfNow)
{
  Line line;
  vtkNew<Relay> source;
  vtkNew<vtkPolyData> crossing;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ vtkIdType(0), vtkIdType(1) });
  lines->InsertNextCell({ vtkIdType(2), vtkIdType(3) });
  crossing->SetLines(lines);
  source->Send(crossing);
  line.Filter->SetSourceConnection(source->GetOutputPort());
  for (int step = 0; step < 4; ++step)
  {
    auto cloud = makeCloud({ { 0, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 2, 0, 0 }, { 3, 1, 0 } });
    setTime(cloud, step);
    EXPECT_EQ(line.Runs(cloud), step < 2);
    for (int port = 0; port < 3; ++port)
    {
      EXPECT_EQ(timeOf(line.Filter->GetOutput(port)), step) << "port " << port;
    }
    vtkFieldData* data = line.Surface()->GetFieldData();
    EXPECT_EQ(idsOf(data, "Crossings"), (std::vector<vtkIdType>{ 1, 0 }));
    EXPECT_EQ(idsOf(data, "NumberOfCrossings"), std::vector<vtkIdType>{ 1 });
    EXPECT_EQ(line.Filter->GetOutput(2)->GetFieldData()->GetNumberOfArrays(), 1);
  }
  auto without = makeCloud({ { 0, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 2, 0, 0 }, { 3, 1, 0 } });
  EXPECT_FALSE(line.Runs(without));
  EXPECT_EQ(timeOf(line.Surface()), -1);
}

TEST(KeptStale, BlocksWithTheSamePointsHaveTheirOwnFieldData)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned b = 0; b < 4; ++b)
  {
    auto cloud = makeCloud(scatteredPoints(50));
    setTime(cloud, b);
    blocks->SetBlock(b, cloud);
  }
  filter->SetInputDataObject(blocks);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (unsigned b = 0; b < 4; ++b)
  {
    EXPECT_EQ(timeOf(made->GetBlock(b)), b);
  }
}

TEST(KeptStale, ASettingChangedWhileItRunsCounts)
{
  auto cloud = makeCloud(scatteredPoints(2000));
  Line line;
  vtkNew<AtProgress> watch;
  line.Filter->AddObserver(vtkCommand::ProgressEvent, watch);
  EXPECT_TRUE(line.Runs(cloud));
  watch->From = 0.5; // points have been merged before
  watch->Do = [&line] { line.Filter->SetTolerance(0.1); };
  EXPECT_TRUE(line.Runs(cloud));
  ASSERT_EQ(line.Filter->GetTolerance(), 0.1);
  ASSERT_EQ(line.Filter->GetNumberOfMergedPoints(), 0);
  EXPECT_TRUE(line.Runs(cloud)) << "the result of other settings was passed on";
  EXPECT_GT(line.Filter->GetNumberOfMergedPoints(), 0);
}

TEST(KeptStale, WhatDoesNotFitIsLetGoBeforeTheNextIsMade)
{
  Line line;
  EXPECT_TRUE(line.RunsTwice(makeCloud(scatteredPoints(1000))));
  vtkWeakPointer<vtkDataArray> old = line.Surface()->GetPolys()->GetConnectivityArray();
  vtkNew<AtProgress> watch;
  bool isThere = true;
  watch->From = 0.1; // before that, it is the pipeline that speaks
  watch->Do = [&] { isThere = old != nullptr; };
  line.Filter->AddObserver(vtkCommand::ProgressEvent, watch);
  EXPECT_TRUE(line.Runs(makeCloud(scatteredPoints(1000, 2))));
  EXPECT_FALSE(isThere);
  ASSERT_FALSE(watch->Do) << "there was no progress";
  EXPECT_FALSE(line.Runs(makeCloud(scatteredPoints(1000, 2)))) << "that one is kept again";
}

TEST(KeptStale, AnEmptyVoronoiDiagramHasTheArraysOfNow)
{
  Line line;
  vtkNew<Messages> said; // "all distinct points are collinear"
  said->Watch(line.Filter);
  line.Filter->GenerateVoronoiOn();
  for (int step = 0; step < 3; ++step)
  {
    auto cloud = makeCloud({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } });
    vtkNew<vtkIntArray> array;
    const std::string name = "step" + std::to_string(step);
    array->SetName(name.c_str());
    array->SetNumberOfValues(3);
    array->FillValue(step);
    cloud->GetPointData()->AddArray(array);
    EXPECT_EQ(line.Runs(cloud), step < 2);
    vtkCellData* data = line.Filter->GetOutput(2)->GetCellData();
    EXPECT_EQ(line.Filter->GetOutput(2)->GetNumberOfCells(), 0);
    EXPECT_EQ(data->GetNumberOfArrays(), 2);
    EXPECT_TRUE(data->HasArray("OriginalPointIds"));
    EXPECT_TRUE(data->HasArray(name.c_str())) << name;
  }
}

TEST(KeptStale, ASingleExecutionKeepsNothing)
{
  vtkWeakPointer<vtkDataArray> corners;
  Line line;
  EXPECT_TRUE(line.Runs(makeCloud(scatteredPoints(100))));
  corners = line.Surface()->GetPolys()->GetConnectivityArray();
  line.Surface()->Initialize();
  EXPECT_EQ(corners, nullptr);
}
