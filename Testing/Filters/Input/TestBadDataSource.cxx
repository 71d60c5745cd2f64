// SPDX-License-Identifier: BSD-3-Clause
//
// Sources as users have them: ids that are no points', cells of too few points, cells of other
// kinds, places that are not finite. Each has its documented message and result.
#include "BadDataSupport.h"

#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

using namespace ahdtest;

namespace
{
const std::vector<Xyz> kSquare = { { 0, 0, 1 }, { 4, 0, 2 }, { 4, 4, 3 }, { 0, 4, 4 } };
constexpr vtkIdType kFar = std::numeric_limits<vtkIdType>::max();
}

TEST(BadDataSource, IdsBeyondAllBoundsAreSaid)
{
  for (int mode : { 0, 1 })
  {
    for (vtkIdType bad : { vtkIdType(4), vtkIdType(-1), kFar, -kFar - 1, vtkIdType(1) << 32 })
    {
      SCOPED_TRACE("mode " + std::to_string(mode) + ", id " + std::to_string(bad));
      ConstrainedFilter filter(
        { kSquare[0] }, makeSource({ { 0, 2 }, { 0, bad } }, { { 0, 1, 2, 3 } }, kSquare));
      if (mode == 0)
      {
        filter->SetInputData(makeCloud(kSquare));
      }
      filter->SetSourceMode(mode);
      filter->SetCrossingMode(mode);
      filter.Run();
      expectWarnings(filter, 1,
        { "1 of the ids", "first is " + std::to_string(bad) + " in cell 1",
          mode == 0 ? "points of the input" : "points of the source" });
      EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 1);
      EXPECT_EQ(filter->GetNumberOfTriangles(), 2);
      EXPECT_EQ(areaOf(filter->GetOutput()), 16.0);
    }
  }
}

TEST(BadDataSource, CellsOfTooFewPointsAreNoConstraintsAndNothingIsSaid)
{
  for (int mode : { 0, 1, 2 })
  {
    SCOPED_TRACE(mode);
    auto source = makeSource({ { 2 }, {}, { 1, 1, 1 }, { 3 } }, { {}, { 0 }, { 0, 0 } }, kSquare);
    ConstrainedFilter filter(kSquare, source);
    filter->SetSourceMode(mode % 2);
    filter->SetCrossingMode(mode % 2);
    filter->SetFillRule(mode / 2);
    filter.Run();
    expectWarnings(filter, 0);
    EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 0);
    EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 0);
    EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(kSquare));
  }
}

TEST(BadDataSource, APolygonOfTwoPointsIsAnEdgeAndBoundsNothing)
{
  for (int rule : { 0, 1 })
  {
    std::vector<Xyz> points = kSquare;
    points.push_back({ 2.5, 2, 0 });
    ConstrainedFilter filter(points, makeSource({}, { { 1, 3 } }));
    filter->SetFillRule(rule);
    filter.Run();
    EXPECT_TRUE(hasEdge(filter->GetOutput(), 1, 3));
    EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);
    EXPECT_EQ(filter->GetNumberOfTriangles(), 4);
    expectWarnings(filter, 0);
  }
}

TEST(BadDataSource, VertsAndStripsMeanNothing)
{
  auto source = makeSource({ { 0, 2 } }, {});
  source->SetVerts(makeCells({ { 77 }, { -5, 3 }, {} }));
  source->SetStrips(makeCells({ { 0, 1, 3, 99 }, {} }));
  ConstrainedFilter filter(kSquare, source);
  filter.Run();
  expectWarnings(filter, 1, { "2 triangle strips of the source are ignored" });
  EXPECT_TRUE(hasEdge(filter->GetOutput(), 0, 2));
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);

  source->SetLines(makeCells({ { 0, 50 } })); // behind three verts
  source->Modified();
  filter.Run();
  expectWarnings(filter, 2, { "first is 50 in cell 3" });
}

TEST(BadDataSource, OfNothingIsNone)
{
  for (int mode : { 0, 1 })
  {
    for (bool withPoints : { false, true })
    {
      vtkNew<vtkPolyData> source;
      if (withPoints)
      {
        source->SetPoints(vtkNew<vtkPoints>());
      }
      ConstrainedFilter filter(kSquare, source);
      filter->SetSourceMode(mode);
      filter.Run();
      expectWarnings(filter, 0);
      EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(kSquare));
      filter->SetSourceData(nullptr);
      EXPECT_EQ(filter->GetSource(), nullptr);
      filter.Run();
      expectWarnings(filter, 0);
    }
  }
}

TEST(BadDataSource, PointsThatAreNoNumbersAreRejectedWithTheirSegments)
{
  std::vector<Xyz> own = { { 0, 2, kNan }, { 4, 2, 0 }, { kInf, 1, 0 }, { 1, kNan, 0 } };
  ConstrainedFilter filter(
    kSquare, makeSource({ { 0, 1 }, { 1, 2 }, { 3, 2 } }, { { 0, 1, 3 } }, own));
  filter->SetSourceModeToCoordinates();
  filter->SetCrossingModeToSplit();
  filter->GenerateFateOn();
  filter.Run();
  ASSERT_EQ(filter.Said->Warnings.size(), 3u);
  EXPECT_NE(filter.Said->Warnings[0].find("2 of 8 points were rejected"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("first is point 6"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[1].find("1 of 8 points have a z"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[2].find("rejected"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[2].find("1 polygon bounds nothing"), std::string::npos);
  expectCountsOfFates(filter.Filter);
  EXPECT_TRUE(hasEdge(filter->GetOutput(), 4, 5));
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 4);
}

TEST(BadDataSource, OfHugeCoordinatesCrossesAndIsSplit)
{
  const double big = 1.7e308;
  ConstrainedFilter filter({ { 0, 5, 0 } },
    makeSource({ { 0, 1 }, { 2, 3 } }, {},
      { { -big, -big, 0 }, { big, big, 0 }, { -big, big, 0 }, { big, -big, 0 } }));
  filter->SetSourceModeToCoordinates();
  filter->SetCrossingModeToSplit();
  filter->GenerateFateOn();
  filter.Run();
  expectWarnings(filter, 0);
  EXPECT_EQ(filter->GetNumberOfCrossings(), 1);
  expectCountsOfFates(filter.Filter);
  const double* p = filter->GetOutput()->GetPoint(5);
  EXPECT_EQ(p[0], 0.0);
  EXPECT_EQ(p[1], 0.0);
}

TEST(BadDataSource, OfBlocksIsOneSourceWhateverTheInputIs)
{
  vtkNew<vtkMultiBlockDataSet> sources; // ids of the input: no points of their own
  sources->SetBlock(0, makeSource({ { 0, 2 } }, {}));
  sources->SetBlock(1, makeSource({ { 1, 3 } }, {}));
  vtkNew<vtkMultiBlockDataSet> inputs;
  inputs->SetBlock(0, makeCloud(kSquare));
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(sources);
  for (int kind : { 0, 1, 2 })
  {
    SCOPED_TRACE(kind);
    WatchedFilter filter;
    filter->SetMergeBlocks(kind == 2);
    filter->SetInputDataObject(
      kind == 0 ? static_cast<vtkDataObject*>(makeCloud(kSquare)) : inputs);
    filter->SetSourceConnection(source->GetOutputPort());
    filter->Update();
    EXPECT_TRUE(filter.PipelineSaid->Errors.empty());
    vtkDataObject* made = filter->GetOutputDataObject(0);
    auto* parts = vtkMultiBlockDataSet::SafeDownCast(made);
    EXPECT_EQ(parts != nullptr, kind == 1) << "the input's blocks, not the source's";
    EXPECT_TRUE(hasEdge(vtkPolyData::SafeDownCast(parts ? parts->GetBlock(0) : made), 0, 2));
    EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
    EXPECT_EQ(filter->GetNumberOfCrossings(), 1) << "of lines of different blocks";
  }
}
