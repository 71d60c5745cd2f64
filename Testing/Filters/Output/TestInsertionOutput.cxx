// SPDX-License-Identifier: BSD-3-Clause
//
// The second output as a whole: the curve of the insertion; when it is empty; memory, threads,
// abort.
#include "FilterTestSupport.h"
#include "ProgressWatch.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertDelaunay2D;

namespace
{
bool isEmpty(vtkPolyData* output)
{
  return output->GetNumberOfPoints() == 0 && output->GetNumberOfCells() == 0 &&
    output->GetPointData()->GetNumberOfArrays() == 0 &&
    output->GetCellData()->GetNumberOfArrays() == 0;
}
}

TEST(InsertionOutput, IsEmptyUnlessAskedFor)
{
  WatchedFilter filter;
  ASSERT_EQ(filter->GetNumberOfOutputPorts(), 3);
  filter->SetInputData(makeCloud(scatteredPoints(100)));
  filter->GenerateFateOn();
  filter->GenerateInsertionRankOn();
  filter->Update();
  ASSERT_NE(filter->GetOutput(1), nullptr);
  EXPECT_TRUE(isEmpty(filter->GetOutput(1)));
  ASSERT_NE(filter->GetOutput(2), nullptr);
  EXPECT_TRUE(isEmpty(filter->GetOutput(2)));
  filter->GenerateInsertionCurveOn();
  filter->GenerateBoxesOn();
  filter->Update();
  EXPECT_FALSE(isEmpty(filter->GetOutput(1)));
  filter->GenerateInsertionCurveOff();
  filter->GenerateBoxesOff();
  filter->Update();
  EXPECT_TRUE(isEmpty(filter->GetOutput(1))) << "left over from the run before";
}

TEST(InsertionOutput, DoesNotChangeTheSurface)
{
  auto cloud = makeCloud(latticePoints(20000, 100));
  WatchedFilter plain;
  plain->SetInputData(cloud);
  plain->Update();
  for (int order = Filter::ADAPTIVE_HILBERT; order <= Filter::AS_GIVEN; ++order)
  {
    WatchedFilter filter;
    filter->SetInputData(cloud);
    filter->SetInsertionOrder(order);
    filter->GenerateInsertionCurveOn();
    filter->GenerateBoxesOn();
    filter->GenerateInsertionRankOn();
    filter->SetNumberOfThreads(3);
    filter->Update();
    EXPECT_EQ(trianglesOf(filter->GetOutput()), trianglesOf(plain->GetOutput())) << order;
    EXPECT_TRUE(filter.Said->Warnings.empty());
  }
}

TEST(InsertionOutput, CurvePassesThePointsByTheirRank)
{
  std::vector<Xyz> points = scatteredPoints(500);
  for (Xyz& p : points)
  {
    p[2] = 3.0 - p[0];
  }
  points[100] = points[7];
  points[200][1] = std::numeric_limits<double>::quiet_NaN();
  for (int order = Filter::ADAPTIVE_HILBERT; order <= Filter::AS_GIVEN; ++order)
  {
    for (vtkIdType limit : { 0, 2, 123 })
    {
      SCOPED_TRACE("InsertionOrder " + std::to_string(order) + ", limit " + std::to_string(limit));
      WatchedFilter filter;
      filter->SetInputData(makeCloud(points));
      filter->SetInsertionOrder(order);
      filter->SetInsertionLimit(limit);
      filter->GenerateInsertionRankOn();
      filter->GenerateInsertionCurveOn();
      filter->Update();
      vtkPolyData* curve = filter->GetOutput(1);
      const vtkIdType count = filter->GetNumberOfPointsInserted();
      EXPECT_EQ(count, limit > 0 ? limit : 498);
      ASSERT_EQ(curve->GetNumberOfPoints(), count);
      ASSERT_EQ(curve->GetNumberOfCells(), 1);
      EXPECT_EQ(curve->GetCellType(0), count == 2 ? VTK_LINE : VTK_POLY_LINE);
      EXPECT_EQ(curve->GetCellData()->GetArray("Level")->GetTuple1(0), -1);
      EXPECT_EQ(idsOf(curve->GetCellData(), "Count"), std::vector<vtkIdType>{ count });
      const auto inSurface = idsOf(filter->GetOutput()->GetPointData(), "InsertionRank");
      const auto ranks = idsOf(curve->GetPointData(), "InsertionRank");
      const auto ids = idsOf(curve->GetPointData(), "OriginalPointIds");
      vtkIdType size = 0;
      const vtkIdType* passed = nullptr;
      curve->GetCellPoints(0, size, passed);
      ASSERT_EQ(size, count);
      for (vtkIdType i = 0; i < count; ++i)
      {
        ASSERT_EQ(passed[i], i);
        ASSERT_EQ(ranks[i], i);
        ASSERT_EQ(inSurface[ids[i]], i);
        Xyz p;
        curve->GetPoint(i, p.data());
        ASSERT_EQ(p, points[ids[i]]) << "with its z";
      }
    }
  }
}

TEST(InsertionOutput, BoxesAloneHaveTheirCornersOnly)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(2000)));
  filter->GenerateBoxesOn();
  filter->Update();
  vtkPolyData* alone = filter->GetOutput(1);
  const vtkIdType boxes = alone->GetNumberOfPolys();
  ASSERT_GT(boxes, 10);
  EXPECT_EQ(alone->GetNumberOfCells(), boxes);
  ASSERT_EQ(alone->GetNumberOfPoints(), 4 * boxes);
  EXPECT_TRUE(alone->GetPolys()->IsValid());
  for (const char* name : { "InsertionRank", "OriginalPointIds" })
  {
    EXPECT_EQ(idsOf(alone->GetPointData(), name), std::vector<vtkIdType>(4 * boxes, -1)) << name;
  }
  WatchedFilter both;
  both->SetInputData(filter->GetInputDataObject(0, 0));
  both->GenerateBoxesOn();
  both->GenerateInsertionCurveOn();
  both->Update();
  vtkPolyData* behind = both->GetOutput(1);
  ASSERT_EQ(behind->GetNumberOfPolys(), boxes);
  for (vtkIdType i = 0; i < boxes; ++i)
  {
    double here[6], there[6];
    alone->GetCellBounds(i, here);
    behind->GetCellBounds(1 + i, there);
    EXPECT_TRUE(std::equal(here, here + 6, there)) << "box " << i;
  }
}

TEST(InsertionOutput, IsOfTheDocumentedTypes)
{
  for (int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    WatchedFilter filter;
    filter->SetInputData(makeCloud(latticePoints(300, 1000), type));
    filter->GenerateInsertionCurveOn();
    filter->GenerateBoxesOn();
    filter->Update();
    vtkPolyData* order = filter->GetOutput(1);
    EXPECT_EQ(order->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_NE(vtkIntArray::SafeDownCast(order->GetCellData()->GetArray("Level")), nullptr);
    EXPECT_EQ(order->GetCellData()->GetNumberOfTuples(), order->GetNumberOfCells());
    EXPECT_EQ(order->GetPointData()->GetNumberOfTuples(), order->GetNumberOfPoints());
    EXPECT_TRUE(order->GetLines()->IsValid());
    EXPECT_TRUE(order->GetPolys()->IsValid());
    EXPECT_FALSE(order->GetPolys()->IsStorage64Bit());
    Xyz p, given;
    const auto ids = idsOf(order->GetPointData(), "OriginalPointIds");
    for (vtkIdType i = 0; i < filter->GetNumberOfPointsInserted(); ++i)
    {
      order->GetPoint(i, p.data());
      filter->GetOutput()->GetPoint(ids[i], given.data());
      ASSERT_EQ(p, given) << "type " << type;
    }
  }
}

TEST(InsertionOutput, IsTheSameForAnyNumberOfThreads)
{
  auto cloud = makeCloud(scatteredPoints(300000));
  std::vector<vtkIdType> ids;
  std::vector<double> xyz;
  for (int threads : { 1, 4 })
  {
    WatchedFilter filter;
    filter->SetInputData(cloud);
    filter->SetNumberOfThreads(threads);
    filter->GenerateInsertionCurveOn();
    filter->GenerateBoxesOn();
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfThreadsUsed(), threads);
    vtkPolyData* made = filter->GetOutput(1);
    const auto* begin = static_cast<double*>(made->GetPoints()->GetVoidPointer(0));
    const std::vector<double> found(begin, begin + 3 * made->GetNumberOfPoints());
    ASSERT_GT(found.size(), 900000u);
    xyz = xyz.empty() ? found : xyz;
    ids = ids.empty() ? idsOf(made->GetPointData(), "OriginalPointIds") : ids;
    EXPECT_TRUE(xyz == found) << threads << " threads";
    EXPECT_TRUE(idsOf(made->GetPointData(), "OriginalPointIds") == ids) << threads << " threads";
  }
}

TEST(InsertionOutput, IsEmptyWhereTheRunIsRefused)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(10000)));
  filter->GenerateInsertionCurveOn();
  filter->SetMemoryLimit(100);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_TRUE(isEmpty(filter->GetOutput(1)));
  EXPECT_TRUE(isEmpty(filter->GetOutput(0)));
}

TEST(InsertionOutput, BoxesThatDoNotFitAreRefused)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(10000)));
  filter->SetNmax(1);
  filter->GenerateBoxesOn();
  filter->Update();
  const vtkTypeInt64 needed = filter->GetMemoryEstimate();
  EXPECT_FALSE(isEmpty(filter->GetOutput(1)));
  filter->SetMemoryLimit(needed - 1); // enough for all but the boxes
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  for (const char* part : { "The grid of 10000 points has more than ", " boxes. Writing more ",
         "MemoryLimit allows ", "Nothing was computed", "Switch GenerateBoxes off" })
  {
    EXPECT_NE(filter.Said->Errors[0].find(part), std::string::npos) << filter.Said->Errors[0];
  }
  EXPECT_TRUE(isEmpty(filter->GetOutput(0)));
  EXPECT_TRUE(isEmpty(filter->GetOutput(1)));
  EXPECT_EQ(filter->GetNumberOfTriangles(), 0);
  EXPECT_EQ(filter->GetMemoryEstimate(), needed) << "what it was refused";

  filter->SetMemoryLimit(needed);
  filter->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_FALSE(isEmpty(filter->GetOutput(1)));
  filter->SetMemoryLimit(needed - 1);
  filter->GenerateBoxesOff();
  filter->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_LT(filter->GetMemoryEstimate(), needed);
  EXPECT_FALSE(isEmpty(filter->GetOutput(0)));
}

TEST(InsertionOutput, IsPartOfTheMemoryEstimate)
{
  const auto estimate = [](auto set)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(makeCloud(scatteredPoints(20000)));
    set(filter.GetPointer());
    filter->Update();
    vtkPolyData* made = filter->GetOutput(1);
    return std::make_pair(filter->GetMemoryEstimate(), vtkTypeInt64(made->GetActualMemorySize()));
  };
  const vtkTypeInt64 plain = estimate([](Filter*) {}).first;
  // 8 bytes a point are output, and 4 are the order
  const vtkTypeInt64 rank = estimate([](Filter* f) { f->GenerateInsertionRankOn(); }).first;
  EXPECT_GE(rank, plain + 12 * 20000 / 1024);
  EXPECT_LE(rank, plain + 13 * 20000 / 1024); // memory of arrays is rounded up
  const auto curve = estimate([](Filter* f) { f->GenerateInsertionCurveOn(); });
  EXPECT_GE(curve.first, plain + curve.second);
  EXPECT_LE(curve.first, plain + curve.second + 12 * 20000 / 1024);
  const auto boxes = estimate(
    [](Filter* f)
    {
      f->GenerateBoxesOn();
      f->SetNmax(1);
    });
  EXPECT_GE(boxes.first, plain + boxes.second);
  EXPECT_LE(boxes.first, plain + 2 * boxes.second);
  const auto limited = estimate(
    [](Filter* f)
    {
      f->GenerateInsertionCurveOn();
      f->SetInsertionLimit(100);
    });
  EXPECT_LT(limited.first, (plain + curve.first) / 2);
}

TEST(InsertionOutput, IsEmptyAfterAnAbort)
{
  auto cloud = makeCloud(scatteredPoints(100000));
  vtkNew<Filter> filter;
  filter->SetInputData(cloud);
  filter->GenerateFateOn();
  filter->GenerateInsertionRankOn();
  filter->GenerateInsertionCurveOn();
  filter->GenerateBoxesOn();
  for (int threads : { 1, 3 })
  {
    filter->SetNumberOfThreads(threads);
    for (double at : { 0.1, 0.5, 0.95, 0.98, 0.99 })
    {
      vtkNew<ProgressWatch> watch;
      watch->AbortAt = at;
      const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, watch);
      filter->SetAbortExecute(0);
      filter->Modified();
      filter->Update();
      filter->RemoveObserver(tag);
      EXPECT_TRUE(watch->Aborted) << at;
      EXPECT_TRUE(isEmpty(filter->GetOutput(0))) << at;
      EXPECT_TRUE(isEmpty(filter->GetOutput(1))) << at;
      EXPECT_EQ(filter->GetNumberOfPointsInserted(), 0) << at;
    }
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput(1)->GetNumberOfLines(), 1);
    EXPECT_GT(filter->GetOutput(1)->GetNumberOfPolys(), 2000);
  }
}

namespace
{
/// Aborts at the `AbortAt`-th poll, from 1.
class AskingFilter : public vtkAdaptiveHilbertDelaunay2D
{
public:
  static AskingFilter* New();
  vtkTypeMacro(AskingFilter, vtkAdaptiveHilbertDelaunay2D);
  vtkTypeBool GetAbortExecute() override { return ++this->Askings >= this->AbortAt; }

  int Askings = 0;
  int AbortAt = VTK_INT_MAX;
};
vtkStandardNewMacro(AskingFilter);
}

TEST(InsertionOutput, IsEmptyWhereverTheAbortIsHeard)
{
  vtkNew<AskingFilter> filter;
  filter->SetInputData(makeCloud(scatteredPoints(30000)));
  filter->SetNumberOfThreads(1);
  filter->SetNmax(1);
  filter->GenerateInsertionCurveOn();
  filter->GenerateBoxesOn();
  filter->Update();
  EXPECT_FALSE(isEmpty(filter->GetOutput(1)));
  const int askings = filter->Askings;
  ASSERT_GT(askings, 50);
  for (int at = 1; at < askings - 1; at += at < askings / 2 ? 7 : 1) // VTK polls once at each end
  {
    filter->Askings = 0;
    filter->AbortAt = at;
    filter->Modified();
    filter->Update();
    EXPECT_TRUE(isEmpty(filter->GetOutput(0))) << "asking " << at << " of " << askings;
    EXPECT_TRUE(isEmpty(filter->GetOutput(1))) << "asking " << at << " of " << askings;
  }
}

TEST(InsertionOutput, OfBlocksIsInBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud(scatteredPoints(100)));
  blocks->SetBlock(2, vtkNew<vtkImageData>());
  blocks->SetBlock(3, makeCloud(scatteredPoints(70)));
  WatchedFilter filter;
  filter->SetInputDataObject(blocks);
  filter->GenerateInsertionCurveOn();
  filter->GenerateBoxesOn();
  filter->Update();
  for (int port : { 0, 1 })
  {
    auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    ASSERT_NE(made, nullptr) << "port " << port;
    EXPECT_EQ(made->GetBlock(1), nullptr);
    for (unsigned int block : { 0u, 2u, 3u })
    {
      auto* piece = vtkPolyData::SafeDownCast(made->GetBlock(block));
      ASSERT_NE(piece, nullptr) << "port " << port << ", block " << block;
      EXPECT_EQ(isEmpty(piece), block == 2) << "port " << port << ", block " << block;
    }
  }
  auto* order = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  auto* last = vtkPolyData::SafeDownCast(order->GetBlock(3));
  EXPECT_EQ(idsOf(last->GetCellData(), "Count")[0], 70);
}
