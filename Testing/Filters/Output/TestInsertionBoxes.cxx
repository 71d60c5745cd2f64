// SPDX-License-Identifier: BSD-3-Clause
//
// The boxes of the grid in the second output: their places, their order, and their points.
#include "FilterTestSupport.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertDelaunay2D;

namespace
{
const double kNan = std::numeric_limits<double>::quiet_NaN();

/// A box of the second output, read through VTK's own interface.
struct Box
{
  double xmin, xmax, ymin, ymax;
  int level;
  vtkIdType count;

  double area() const { return (xmax - xmin) * (ymax - ymin); }
  bool holds(const Xyz& p) const
  {
    return xmin <= p[0] && p[0] < xmax && ymin <= p[1] && p[1] < ymax;
  }
};

/// The boxes in their order; expects four corners each, counterclockwise from the lower left, at
/// the height z.
std::vector<Box> boxesOf(vtkPolyData* order, double z)
{
  std::vector<Box> boxes;
  vtkDataArray* levels = order->GetCellData()->GetArray("Level");
  const std::vector<vtkIdType> counts = idsOf(order->GetCellData(), "Count");
  for (vtkIdType cell = order->GetNumberOfLines(); cell < order->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    order->GetCellPoints(cell, size, ids);
    EXPECT_EQ(order->GetCellType(cell), VTK_QUAD);
    EXPECT_EQ(size, 4);
    Xyz corner[4];
    for (int i = 0; i < 4; ++i)
    {
      order->GetPoint(ids[i], corner[i].data());
      EXPECT_EQ(corner[i][2], z) << "cell " << cell;
    }
    const Box box{ corner[0][0], corner[2][0], corner[0][1], corner[2][1],
      static_cast<int>(levels->GetTuple1(cell)), counts[cell] };
    EXPECT_EQ(corner[1], (Xyz{ box.xmax, box.ymin, z })) << "cell " << cell;
    EXPECT_EQ(corner[3], (Xyz{ box.xmin, box.ymax, z })) << "cell " << cell;
    boxes.push_back(box);
  }
  return boxes;
}

/// Do two boxes share a piece of border longer than a rounding error?
bool touch(const Box& a, const Box& b)
{
  const double dx = std::min(a.xmax, b.xmax) - std::max(a.xmin, b.xmin);
  const double dy = std::min(a.ymax, b.ymax) - std::max(a.ymin, b.ymin);
  return std::min(dx, dy) > -1e-9 && std::max(dx, dy) > 1e-9;
}

/// The number of boxes that do not touch the one before.
std::size_t jumps(const std::vector<Box>& boxes)
{
  std::size_t found = 0;
  for (std::size_t i = 1; i < boxes.size(); ++i)
  {
    found += !touch(boxes[i - 1], boxes[i]);
  }
  return found;
}

/// Crowded around the origin, so that boxes are divided again and again; x, y in [0, 1), z from 2.
std::vector<Xyz> crowdedPoints(std::size_t count)
{
  std::vector<Xyz> points = scatteredPoints(count);
  for (Xyz& p : points)
  {
    p = { std::pow(p[0], 6), std::pow(p[1], 6), 2.0 + p[0] };
  }
  points[5][2] = -3.5;
  points[6][2] = kNan;
  return points;
}

/// Checks the boxes of any run: they tile a rectangle and each point is in one.
void expectTiling(const std::vector<Box>& boxes, const std::vector<Xyz>& points)
{
  Box whole = boxes.front();
  double area = 0.0;
  vtkIdType count = 0;
  for (const Box& box : boxes)
  {
    whole = { std::min(whole.xmin, box.xmin), std::max(whole.xmax, box.xmax),
      std::min(whole.ymin, box.ymin), std::max(whole.ymax, box.ymax), 0, 0 };
    area += box.area();
    count += box.count;
    const auto inside = std::count_if(
      points.begin(), points.end(), [&box](const Xyz& p) { return box.holds(p); });
    EXPECT_EQ(box.count, inside) << "[" << box.xmin << ", " << box.xmax << ") x [" << box.ymin
                                 << ", " << box.ymax << ")";
  }
  EXPECT_NEAR(area, whole.area(), 1e-9 * area) << "boxes overlap or leave gaps";
  EXPECT_EQ(count, vtkIdType(points.size()));
}
}

TEST(InsertionBoxes, TileTheGridAndHoldThePoints)
{
  const std::vector<Xyz> points = crowdedPoints(1500);
  for (int order : { Filter::ADAPTIVE_HILBERT, Filter::MULTI_GRID, Filter::REGULAR_GRID })
  {
    for (int control = Filter::NO_CONTROL_POINTS; control <= Filter::EVERY_LEVEL; ++control)
    {
      for (int nmax : { 1, 50 })
      {
        SCOPED_TRACE("InsertionOrder " + std::to_string(order) + ", ControlPoints " +
          std::to_string(control) + ", Nmax " + std::to_string(nmax));
        WatchedFilter filter;
        filter->SetInputData(makeCloud(points));
        filter->SetInsertionOrder(order);
        filter->SetControlPoints(control);
        filter->SetNmax(nmax);
        filter->GenerateBoxesOn();
        filter->Update();
        vtkPolyData* made = filter->GetOutput(1);
        EXPECT_EQ(made->GetNumberOfLines(), 0);
        const std::vector<Box> boxes = boxesOf(made, -3.5);
        ASSERT_EQ(made->GetNumberOfPoints(), vtkIdType(4 * boxes.size()));
        expectTiling(boxes, points);
        int deepest = 0;
        const vtkIdType most = order == Filter::REGULAR_GRID ? 1500
          : control == Filter::SINGLE_LEVEL                  ? nmax + 1
                                                             : nmax;
        for (const Box& box : boxes)
        {
          deepest = std::max(deepest, box.level);
          EXPECT_GE(box.level, 1);
          EXPECT_LE(box.count, most);
        }
        EXPECT_EQ(deepest > 1, order != Filter::REGULAR_GRID);
        // Corners are no points of the input.
        const auto ids = idsOf(made->GetPointData(), "OriginalPointIds");
        const auto ranks = idsOf(made->GetPointData(), "InsertionRank");
        EXPECT_EQ(std::count(ids.begin(), ids.end(), -1), vtkIdType(4 * boxes.size()));
        EXPECT_EQ(std::count(ranks.begin(), ranks.end(), -1), vtkIdType(4 * boxes.size()));
      }
    }
  }
}

TEST(InsertionBoxes, AreVisitedByTheirOrder)
{
  const std::vector<Xyz> points = crowdedPoints(1500);
  for (int order : { Filter::ADAPTIVE_HILBERT, Filter::MULTI_GRID, Filter::REGULAR_GRID })
  {
    for (bool gene : { true, false })
    {
      SCOPED_TRACE("InsertionOrder " + std::to_string(order) + (gene ? "" : ", no gene"));
      WatchedFilter filter;
      filter->SetInputData(makeCloud(points));
      filter->SetInsertionOrder(order);
      filter->SetControlPointsToNone();
      filter->SetGeneRotation(gene);
      filter->GenerateInsertionCurveOn();
      filter->GenerateBoxesOn();
      filter->Update();
      const std::vector<Box> boxes = boxesOf(filter->GetOutput(1), -3.5);
      // Without control points the curve takes one box after the other.
      const auto ids = idsOf(filter->GetOutput(1)->GetPointData(), "OriginalPointIds");
      std::size_t at = 0;
      vtkIdType left = boxes[0].count;
      for (vtkIdType i = 0; i < 1500; ++i, --left)
      {
        while (left == 0)
        {
          left = boxes.at(++at).count;
        }
        ASSERT_TRUE(boxes[at].holds(points[ids[i]])) << "point " << i << " of the curve";
      }
      if (order == Filter::ADAPTIVE_HILBERT)
      {
        EXPECT_EQ(jumps(boxes) == 0, gene) << jumps(boxes) << " jumps";
      }
      else
      {
        EXPECT_GT(jumps(boxes), 0u) << "lines are begun anew at the left";
      }
    }
  }
}

TEST(InsertionBoxes, StayWhereTheyAreWhileTheLimitChanges)
{
  const std::vector<Xyz> points = crowdedPoints(800);
  const auto run = [&points](vtkIdType limit)
  {
    WatchedFilter filter;
    filter->SetInputData(makeCloud(points));
    filter->SetInsertionLimit(limit);
    filter->GenerateBoxesOn();
    filter->Update();
    EXPECT_EQ(
      filter->GetOutput(1)->GetNumberOfPoints(), 4 * filter->GetOutput(1)->GetNumberOfCells());
    return boxesOf(filter->GetOutput(1), -3.5);
  };
  const std::vector<Box> all = run(0);
  for (vtkIdType limit : { 1, 2, 300 })
  {
    const std::vector<Box> some = run(limit);
    ASSERT_EQ(some.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      EXPECT_EQ(some[i].xmin, all[i].xmin);
      EXPECT_EQ(some[i].ymax, all[i].ymax);
      EXPECT_EQ(some[i].count, all[i].count);
    }
  }
}

TEST(InsertionBoxes, LieAtTheLowestHeightThatCounts)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Xyz> points = scatteredPoints(300);
  points[5] = { kNan, 0.5, -100.0 }; // rejected
  points[6] = { 0.5, infinity, -100.0 };
  points[7][2] = -infinity;
  points[8][2] = kNan;
  points[9][2] = -100.0; // a ghost
  points[10] = { points[11][0], points[11][1], -2.0 };
  auto cloud = makeCloud(points);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(300);
  marks->FillValue(0);
  marks->SetValue(9, vtkDataSetAttributes::DUPLICATEPOINT);
  cloud->GetPointData()->AddArray(marks);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->GenerateBoxesOn();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 1);
  EXPECT_FALSE(boxesOf(filter->GetOutput(1), -2.0).empty()); // expects this height
}

TEST(InsertionBoxes, FewPointsAreOneBox)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(50)));
  filter->GenerateBoxesOn();
  filter->Update();
  const std::vector<Box> boxes = boxesOf(filter->GetOutput(1), 0.0);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].level, 0);
  EXPECT_EQ(boxes[0].count, 50);
}

TEST(InsertionBoxes, AsGivenHasNone)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(100)));
  filter->SetInsertionOrderToAsGiven();
  filter->GenerateBoxesOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

TEST(InsertionBoxes, OfHardlyAnyPoints)
{
  struct Case
  {
    const char* Name;
    std::vector<Xyz> Points;
    vtkIdType Distinct;
    double Lowest;
  };
  const std::vector<Case> cases = { { "none", {}, 0, 0.0 },
    { "only NaN", { { kNan, 0, 7 }, { 0, kNan, 7 } }, 0, 0.0 }, { "one", { { 3, 4, 5 } }, 1, 5.0 },
    { "no z", { { 3, 4, kNan } }, 1, 0.0 },
    { "all equal", { { 3, 4, 5 }, { 3, 4, 2 }, { 3, 4, 9 } }, 1, 2.0 },
    { "two", { { 3, 4, 5 }, { 3, 4, 5 }, { -1, 0, 5 } }, 2, 5.0 },
    { "collinear", { { 0, 0, 1 }, { 4, 4, 1 }, { 1, 1, 1 }, { 2, 2, 1 } }, 4, 1.0 } };
  for (const Case& c : cases)
  {
    for (int order = Filter::ADAPTIVE_HILBERT; order <= Filter::AS_GIVEN; ++order)
    {
      SCOPED_TRACE(std::string(c.Name) + ", InsertionOrder " + std::to_string(order));
      WatchedFilter filter;
      filter->SetInputData(makeCloud(c.Points));
      filter->SetInsertionOrder(order);
      filter->GenerateInsertionRankOn();
      filter->GenerateInsertionCurveOn();
      filter->GenerateBoxesOn();
      filter->Update();
      EXPECT_TRUE(filter.Said->Errors.empty());
      EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
      vtkPolyData* made = filter->GetOutput(1);
      EXPECT_EQ(made->GetNumberOfLines(), c.Distinct >= 2 ? 1 : 0);
      vtkIdType held = 0;
      const std::vector<Box> boxes = boxesOf(made, c.Lowest);
      for (const Box& box : boxes)
      {
        held += box.count;
      }
      EXPECT_EQ(held, order == Filter::AS_GIVEN ? 0 : c.Distinct);
      EXPECT_EQ(made->GetNumberOfPoints(), vtkIdType(c.Distinct + 4 * boxes.size()));
    }
  }
}
