// SPDX-License-Identifier: BSD-3-Clause
//
// Constraints by the ids of the input's points: the results of lines and polygons, and the messages
// about impossible ones.
#include "ConstraintTestSupport.h"
#include "ProgressWatch.h"

#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertDelaunay2D;

namespace
{
/// The loop around the lattice's points from (low, low) to (high, high), counterclockwise.
Chain ring(int side, int low, int high)
{
  Chain loop;
  const auto add = [&](int x, int y) { loop.push_back(vtkIdType(x) * side + y); };
  for (int x = low; x < high; ++x)
  {
    add(x, low);
  }
  for (int y = low; y < high; ++y)
  {
    add(high, y);
  }
  for (int x = high; x > low; --x)
  {
    add(x, high);
  }
  for (int y = high; y > low; --y)
  {
    add(low, y);
  }
  return loop;
}

Chain reversed(Chain chain)
{
  std::reverse(chain.begin(), chain.end());
  return chain;
}

const std::vector<Xyz> kSquare = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } };
}

TEST(Constraints, ALineIsAnEdge)
{
  // (0, 0) to (9, 7): no other lattice point on it
  ConstrainedFilter filter(squareLattice(10), makeSource({ { 0, 97 } }, {}));
  vtkPolyData* surface = filter.Run();
  EXPECT_TRUE(hasEdge(surface, 0, 97));
  EXPECT_EQ(areaOf(surface), 81.0);
  EXPECT_EQ(filter->GetNumberOfTriangles(), 162);
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);
  EXPECT_GT(filter->GetConstrainSeconds(), 0.0);
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(Constraints, PointsOnALineSplitIt)
{
  // (0, 0) to (8, 4), and there and back again along a polyline
  ConstrainedFilter filter(squareLattice(9), makeSource({ { 0, 76 }, { 76, 38, 0 } }, {}));
  vtkPolyData* surface = filter.Run();
  for (vtkIdType x = 0; x < 8; x += 2)
  {
    EXPECT_TRUE(hasEdge(surface, x * 9 + x / 2, (x + 2) * 9 + x / 2 + 1)) << x;
  }
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 4);
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 0);
}

TEST(Constraints, ALoneClockwiseLoopIsAHole)
{
  // from VTK's example ConstrainedDelaunay2D
  const Chain hole = { 22, 23, 24, 25, 35, 45, 44, 43, 42, 32 };
  ConstrainedFilter filter(squareLattice(10), makeSource({}, { hole }));
  EXPECT_EQ(areaOf(filter.Run()), 81.0 - 6.0);
  EXPECT_EQ(filter->GetNumberOfTriangles(), 150);
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 10);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 100);
  EXPECT_EQ(idsOf(filter->GetOutput()->GetFieldData(), "NumberOfTriangles"), Chain{ 150 });

  filter->SetSourceData(makeSource({}, { reversed(hole) }));
  EXPECT_EQ(areaOf(filter.Run()), 6.0);
  EXPECT_EQ(filter->GetNumberOfTriangles(), 12);

  for (const Chain& loop : { hole, reversed(hole) })
  {
    filter->SetFillRuleToEvenOdd();
    filter->SetSourceData(makeSource({}, { loop }));
    EXPECT_EQ(areaOf(filter.Run()), 6.0);
  }
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(Constraints, ASquareWithAHole)
{
  const std::vector<Chain> loops = { ring(12, 1, 10), reversed(ring(12, 4, 7)) };
  ConstrainedFilter filter(squareLattice(12), makeSource({}, loops));
  EXPECT_EQ(areaOf(filter.Run()), 81.0 - 9.0);
  EXPECT_EQ(filter->GetNumberOfUnfilledLoops(), 0);

  // no diagonal needs to be a point's: corners are enough
  const int side = 12;
  const auto corners = [](int low, int high) {
    return Chain{ low * side + low, high * side + low, high * side + high, low * side + high };
  };
  filter->SetSourceData(makeSource({}, { corners(1, 10), reversed(corners(4, 7)) }));
  EXPECT_EQ(areaOf(filter.Run()), 81.0 - 9.0);
}

TEST(Constraints, LoopsAreNestedThreeDeep)
{
  const std::vector<Chain> loops = { reversed(ring(20, 3, 16)), ring(20, 6, 12), ring(20, 0, 19),
    reversed(ring(20, 8, 10)) };
  ConstrainedFilter filter(squareLattice(20), makeSource({}, loops));
  EXPECT_EQ(areaOf(filter.Run()), 361.0 - 169.0 + 36.0 - 4.0);
  // the same without any orientation
  filter->SetSourceData(
    makeSource({}, { ring(20, 3, 16), ring(20, 6, 12), ring(20, 0, 19), ring(20, 8, 10) }));
  filter->SetFillRuleToEvenOdd();
  EXPECT_EQ(areaOf(filter.Run()), 361.0 - 169.0 + 36.0 - 4.0);
}

TEST(Constraints, OfTwoThatCrossTheLaterIsLeftOut)
{
  ConstrainedFilter filter(kSquare, makeSource({ { 0, 2 }, { 1, 3 } }, {}));
  vtkPolyData* surface = filter.Run();
  EXPECT_TRUE(hasEdge(surface, 0, 2));
  EXPECT_FALSE(hasEdge(surface, 1, 3));
  EXPECT_EQ(filter->GetNumberOfCrossings(), 1);
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 1);
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("1 of 2 segments"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("in cell 1 and crosses cell 0."), std::string::npos)
    << filter.Said->Warnings[0];
  EXPECT_EQ(idsOf(surface->GetFieldData(), "Crossings"), (Chain{ 1, 0 }));
  EXPECT_EQ(idsOf(surface->GetFieldData(), "NumberOfCrossings"), Chain{ 1 });

  filter->SetSourceData(makeSource({ { 1, 3 }, { 0, 2 } }, {}));
  EXPECT_TRUE(hasEdge(filter.Run(), 1, 3));
}

TEST(Constraints, ALoopThatIsCrossedFillsNothing)
{
  // The ids of cells: two verts, a line, two polygons, of which the line crosses the first.
  auto source = makeSource({ { 0, 121 } }, { ring(13, 2, 6), reversed(ring(13, 9, 11)) });
  source->SetVerts(makeCells({ { 0 }, { 1 } }));
  ConstrainedFilter filter(squareLattice(13), source);
  vtkPolyData* surface = filter.Run(); // (0, 0) to (9, 4)
  EXPECT_TRUE(hasEdge(surface, 0, 121));
  EXPECT_EQ(areaOf(surface), 144.0 - 4.0);
  EXPECT_EQ(filter->GetNumberOfUnfilledLoops(), 1);
  EXPECT_EQ(filter->GetNumberOfCrossings(), 2);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("in cell 3 and crosses cell 2."), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("1 polygon bounds nothing"), std::string::npos)
    << filter.Said->Warnings[0];
  EXPECT_EQ(idsOf(surface->GetFieldData(), "Crossings"), (Chain{ 3, 2, 3, 2 }));
}

TEST(Constraints, NoMoreThanAThousandCrossingsAreListed)
{
  const int side = 50;
  std::vector<Xyz> points;
  std::vector<Chain> lines;
  for (vtkIdType i = 0; i < side; ++i)
  {
    const double along = double(i) + 0.5;
    points.insert(points.end(),
      { { along, 0, 0 }, { along, double(side), 0 }, { 0, along, 0 }, { double(side), along, 0 } });
    lines.push_back({ 4 * i, 4 * i + 1 });
  }
  for (int repeat = 0; repeat < 25; ++repeat)
  {
    for (vtkIdType i = 0; i < side; ++i)
    {
      lines.push_back({ 4 * i + 2, 4 * i + 3 });
    }
  }
  ConstrainedFilter filter(points, makeSource(lines, {}));
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfCrossings(), 25 * side);
  EXPECT_EQ(idsOf(filter->GetOutput()->GetFieldData(), "Crossings").size(), 2000u);
}

TEST(Constraints, DuplicatesAtTheirEndsStandForThePointTheyCoincideWith)
{
  std::vector<Xyz> points = squareLattice(10);
  points.push_back(points[0]);  // 100
  points.push_back(points[97]); // 101
  ConstrainedFilter filter(points, makeSource({ { 100, 101 }, { 100, 0 } }, {}));
  EXPECT_TRUE(hasEdge(filter.Run(), 0, 97));
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 0);
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(Constraints, IdsThatAreNoPointsAreSaid)
{
  ConstrainedFilter filter(kSquare, makeSource({ { 0, 2 }, { 3, 4 } }, { { 0, 1, -7 } }));
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 3);
  EXPECT_EQ(filter->GetNumberOfUnfilledLoops(), 1);
  EXPECT_EQ(filter->GetNumberOfTriangles(), 2);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  for (const char* part :
    { "3 of 5 segments", "2 of the ids", "first is 4 in cell 1", "1 polygon" })
  {
    EXPECT_NE(filter.Said->Warnings[0].find(part), std::string::npos)
      << part << " in " << filter.Said->Warnings[0];
  }
}

TEST(Constraints, EndsThatAreNoVertexAreSaid)
{
  std::vector<Xyz> points = kSquare;
  points.push_back({ std::numeric_limits<double>::quiet_NaN(), 0, 0 });
  ConstrainedFilter filter(points, makeSource({ { 0, 4 }, { 0, 2 } }, {}));
  EXPECT_TRUE(hasEdge(filter.Run(), 0, 2));
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 1);
  ASSERT_EQ(filter.Said->Warnings.size(), 2u) << "the rejected point is one";
  EXPECT_NE(filter.Said->Warnings[1].find("1 of 2 segments"), std::string::npos);

  ConstrainedFilter limited(squareLattice(10), makeSource({ { 0, 97 } }, {}));
  limited->SetInsertionOrderToAsGiven();
  limited->SetInsertionLimit(50);
  limited.Run();
  EXPECT_EQ(limited->GetNumberOfConstraintsLeftOut(), 1);
  ASSERT_EQ(limited.Said->Warnings.size(), 1u);
  EXPECT_NE(limited.Said->Warnings[0].find("InsertionLimit"), std::string::npos);
  for (const auto& [limit, told] : { std::pair(60, 0u), { 97, 0u }, { 0, 0u }, { 60, 1u } })
  {
    limited->SetInsertionLimit(limit); // as in an animation
    limited.Run();
    EXPECT_EQ(limited->GetNumberOfConstraintsLeftOut(), limit == 0 ? 0 : 1);
    EXPECT_EQ(limited.Said->Warnings.size(), told) << limit;
  }
}

TEST(Constraints, WithoutATriangleOnlyThatIsSaid)
{
  ConstrainedFilter filter({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } }, makeSource({ { 0, 2 } }, {}));
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 1);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("collinear"), std::string::npos);
}

TEST(Constraints, LoopsThatKeepNothingAreSaid)
{
  ConstrainedFilter filter(kSquare, makeSource({}, { { 3, 2, 1, 0 } })); // all of it a hole
  EXPECT_EQ(filter.Run()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 4);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("keep none of the 2 triangles"), std::string::npos);
}

TEST(Constraints, ASourceWithoutSegmentsChangesNothing)
{
  const std::vector<Xyz> points = latticePoints(3000, 60);
  const std::vector<Triangle> expected = triangulate(points);
  vtkNew<vtkPolyData> empty;
  auto others = makeSource({ { 3 }, {} }, {}, kSquare);
  others->SetVerts(makeCells({ { 0, 1 }, { 2 } }));
  others->SetStrips(makeCells({ { 0, 1, 2, 3 } }));
  for (vtkPolyData* source : { empty.Get(), others.Get() })
  {
    ConstrainedFilter filter(points, source);
    EXPECT_EQ(trianglesOf(filter.Run()), expected);
    EXPECT_EQ(
      filter->GetOutput()->GetPoints(), vtkPolyData::SafeDownCast(filter->GetInput())->GetPoints());
    EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 0);
    EXPECT_EQ(filter.Said->Warnings.size(), source == empty.Get() ? 0u : 1u);
  }
}

TEST(Constraints, NoSettingChangesTheResult)
{
  const std::vector<Xyz> points = latticePoints(4000, 80);
  std::vector<Chain> lines;
  for (vtkIdType i = 0; i + 50 < 4000; i += 50)
  {
    lines.push_back({ i, i + 25, i + 49 });
  }
  ConstrainedFilter filter(points, makeSource(lines, { { 10, 20, 30 } }));
  const std::vector<Triangle> expected = trianglesOf(filter.Run());
  const std::vector<vtkIdType> crossings = idsOf(filter->GetOutput()->GetFieldData(), "Crossings");
  ASSERT_FALSE(crossings.empty());
  filter->RandomPointInsertionOn();
  filter->UseHilbertSorterOn();
  filter->SetOffset(3.0);
  for (int order = Filter::ADAPTIVE_HILBERT; order <= Filter::AS_GIVEN; ++order)
  {
    filter->SetInsertionOrder(order);
    filter->SetNumberOfThreads(1 + order);
    filter->GenerateFateOn();
    EXPECT_EQ(trianglesOf(filter.Run()), expected) << order;
    EXPECT_EQ(idsOf(filter->GetOutput()->GetFieldData(), "Crossings"), crossings);
  }
}

TEST(Constraints, TheSourceIsAnInputLikeOthers)
{
  WatchedFilter filter;
  EXPECT_EQ(filter->GetSource(), nullptr);
  filter->SetInputData(makeCloud(squareLattice(10)));
  filter->Update();
  EXPECT_FALSE(hasEdge(filter->GetOutput(), 0, 97));
  auto source = makeSource({ { 0, 97 } }, {});
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(source);
  filter->SetSourceConnection(producer->GetOutputPort());
  EXPECT_EQ(filter->GetSource(), source);
  filter->Update();
  EXPECT_TRUE(hasEdge(filter->GetOutput(), 0, 97));
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);
  filter->SetSourceConnection(nullptr);
  EXPECT_EQ(filter->GetSource(), nullptr);
  filter->Update();
  EXPECT_FALSE(hasEdge(filter->GetOutput(), 0, 97));
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 0) << "left over from the run before";
  EXPECT_EQ(idsOf(filter->GetOutput()->GetFieldData(), "NumberOfConstraintEdges"), Chain{ 0 });
}

TEST(Constraints, AnAbortAtAnyMomentLeavesNothing)
{
  std::vector<Chain> lines;
  for (vtkIdType i = 0; i + 1 < 30000; i += 30)
  {
    lines.push_back({ i, i + 1 });
  }
  ConstrainedFilter filter(scatteredPoints(30000), makeSource(lines, {}));
  const std::vector<Triangle> expected = trianglesOf(filter.Run());
  for (double at = 0.05; at < 1.0; at += 0.05)
  {
    vtkNew<ProgressWatch> watch;
    watch->AbortAt = at;
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Modified();
    EXPECT_EQ(filter.Run()->GetNumberOfPoints(), 0) << at;
    EXPECT_TRUE(watch->Aborted) << at;
    EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 0) << at;
    EXPECT_TRUE(filter.Said->Errors.empty());
    filter->RemoveObserver(tag);
    filter->SetAbortExecute(0);
  }
  filter->Modified();
  EXPECT_EQ(trianglesOf(filter.Run()), expected);
}

TEST(Constraints, CountForTheMemoryThatIsNeeded)
{
  ConstrainedFilter filter(scatteredPoints(5000), nullptr);
  filter.Run();
  const vtkTypeInt64 without = filter->GetMemoryEstimate();
  filter->SetSourceData(makeSource({ { 0, 1 } }, {}));
  filter.Run();
  EXPECT_GT(filter->GetMemoryEstimate(), without);
  filter->SetMemoryLimit(filter->GetMemoryEstimate() - 1);
  EXPECT_EQ(filter.Run()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
}

TEST(Constraints, WhereLoopsKeepNothingAlphaDrawsNoLines)
{
  ConstrainedFilter filter({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 0 } },
    makeSource({}, { { 0, 3, 2, 1 } }));
  filter->SetAlpha(10.0);
  vtkPolyData* surface = filter.Run();
  EXPECT_EQ(surface->GetNumberOfPolys(), 0);
  EXPECT_EQ(surface->GetNumberOfLines(), 0);
  EXPECT_EQ(surface->GetNumberOfVerts(), 5);
}

TEST(Constraints, PiecesOfSplitSegmentsAreNotCountedAsTheSources)
{
  ConstrainedFilter filter({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } },
    makeSource({ { 0, 2 }, { 1, 3 }, { 0, 99 } }, {}));
  filter.Run();
  ASSERT_EQ(filter.Said->Warnings.size(), 2u);
  EXPECT_NE(filter.Said->Warnings[1].find("1 of 3 segments"), std::string::npos);
  filter->SetCrossingModeToSplit();
  filter.Run();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(
    filter.Said->Warnings[0].find("1 segments or pieces of segments of the source were left"),
    std::string::npos)
    << filter.Said->Warnings[0];
}

TEST(SplitCrossings, WhatBendsIsCountedAndNamed)
{
  // The second segment of cell 2 passes above (1, 1/3), which is rounded down; the last one goes
  // through (1, 1) exactly.
  const std::vector<Xyz> points = { { 0, 0, 0 }, { 3, 1, 0 }, { 1, 1 / 3.0, 0 }, { 1, -1, 0 },
    { 1, 2, 0 }, { 2, 2, 0 }, { 1, 1, 0 }, { 2, 0, 0 } };
  ConstrainedFilter filter(points, makeSource({ { 3, 2 }, { 2, 4 }, { 7, 0, 1 }, { 0, 5 } }, {}));
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfBentConstraints(), 0);
  filter.Said->Warnings.clear();
  filter->SetCrossingModeToSplit();
  vtkPolyData* surface = filter.Run();
  EXPECT_EQ(filter->GetNumberOfBentConstraints(), 1);
  EXPECT_EQ(idsOf(surface->GetFieldData(), "NumberOfBentConstraints"), Chain{ 1 });
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("1 segment of the source bends"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("the first is in cell 2."), std::string::npos);
  filter->SetSourceData(makeSource({ { 0, 5 } }, {}));
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfBentConstraints(), 0);
}

/// The table of the edges of loops is requested when their number is known.
TEST(Constraints, WhatTheyNeedBeyondTheLimitIsRefused)
{
  constexpr vtkIdType kSquares = 600; // within each other
  std::vector<Xyz> points;
  std::vector<Chain> loops;
  for (vtkIdType i = 0; i < kSquares; ++i)
  {
    const double half = double(i) + 1.0;
    points.insert(points.end(),
      { { -half, -half, 0 }, { half, -half, 0 }, { half, half, 0 }, { -half, half, 0 } });
    loops.push_back({ 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3 });
  }
  ConstrainedFilter filter(points, makeSource({}, loops));
  filter->SetNumberOfThreads(1);
  filter.Run();
  const vtkTypeInt64 needed = filter->GetMemoryEstimate();
  for (const vtkTypeInt64 limit : { needed - 1, needed, needed - 1 })
  {
    filter->SetMemoryLimit(limit);
    EXPECT_EQ(filter.Run()->GetNumberOfPoints(), limit == needed ? 4 * kSquares : 0) << limit;
    EXPECT_GE(filter->GetMemoryEstimate(), limit == needed ? needed : limit + 1);
    EXPECT_EQ(filter.Said->Errors.size(), limit == needed ? 0u : 1u);
    for (const std::string& error : filter.Said->Errors)
    {
      EXPECT_NE(error.find("Triangulating 2400 points may take"), std::string::npos) << error;
      EXPECT_NE(error.find("but MemoryLimit allows"), std::string::npos) << error;
    }
  }
}
