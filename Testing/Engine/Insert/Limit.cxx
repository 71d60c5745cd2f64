// SPDX-License-Identifier: BSD-3-Clause
//
// Outputs that show the algorithm: the order, a limit on the insertions, and the boxes of the grid
// against a literal implementation of the paper's section 3.
#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"
#include "Order/Quantise.h"
#include "PaperOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

using Triangles = std::set<std::array<std::int64_t, 3>>;

/// The triangles, each from its smallest id on, after `nameOf` each id.
template <typename Name>
Triangles trianglesOf(const Outcome& outcome, Name nameOf)
{
  Triangles triangles;
  for (std::size_t i = 0; i < outcome.triples.size(); i += 3)
  {
    std::array<std::int64_t, 3> t;
    std::transform(&outcome.triples[i], &outcome.triples[i] + 3, t.begin(), nameOf);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.insert(t);
  }
  return triangles;
}

Bounds boundsOf(const std::vector<Point>& points)
{
  Bounds b;
  const double infinity = std::numeric_limits<double>::infinity();
  b.xmin = b.ymin = infinity;
  b.xmax = b.ymax = -infinity;
  for (const Point& p : points)
  {
    b.xmin = std::min(b.xmin, p.x);
    b.xmax = std::max(b.xmax, p.x);
    b.ymin = std::min(b.ymin, p.y);
    b.ymax = std::max(b.ymax, p.y);
  }
  return b;
}

std::vector<std::int64_t> orderOf(Engine& engine)
{
  std::vector<std::int64_t> ids(engine.report().inserted);
  EXPECT_EQ(engine.writeOrder(ids.data(), nullptr), Status::Ok);
  return ids;
}

std::vector<std::int64_t> ranksOf(Engine& engine, std::size_t points)
{
  std::vector<std::int64_t> ranks(points, -7);
  EXPECT_EQ(engine.writeInsertionRanks(ranks.data(), nullptr), Status::Ok);
  return ranks;
}

/// Points with duplicates, and one that is rejected.
std::vector<Point> pointsWithFaults(Distribution distribution, std::size_t n)
{
  std::vector<Point> points = makePoints(distribution, n, 5);
  points.insert(points.begin() + 10, points[20]);
  points.push_back(points[3]);
  points[7].x = std::numeric_limits<double>::quiet_NaN();
  return points;
}

/// The order that an unlimited run keeps is one of all vertices.
TEST(Limit, OrderIsAPermutationAndRanksItsInverse)
{
  const std::vector<Point> points = pointsWithFaults(Distribution::Mixed, 700);
  for (Options options : everySetting({ 1, 50 }))
  {
    SCOPED_TRACE(describe(options));
    options.keepOrder = true;
    Engine engine;
    const Outcome outcome = triangulate(engine, viewOf(points), options);
    EXPECT_EQ(faultsOf(points, outcome), "");
    const std::vector<std::int64_t> order = orderOf(engine);
    const std::vector<std::int64_t> ranks = ranksOf(engine, points.size());
    ASSERT_EQ(order.size(), points.size() - 3); // two duplicates and one that is not finite
    std::vector<std::int64_t> expected(points.size(), kRankNone);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      ASSERT_EQ(outcome.pointStatus[order[i]], order[i]);
      expected[order[i]] = std::int64_t(i);
    }
    EXPECT_EQ(ranks, expected);
    EXPECT_EQ(std::count(ranks.begin(), ranks.end(), kRankNone), 3);
    if (options.order == InsertionOrder::AsGiven)
    {
      EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
    }
  }
}

TEST(Limit, OrderIsTheSameForAnyNumberOfThreads)
{
  const std::vector<Point> points = makePoints(Distribution::Spiral, reduced(100000), 3);
  Options options;
  options.keepOrder = true;
  Engine alone;
  ASSERT_EQ(alone.run(viewOf(points), options, nullptr), Status::Ok);
  ThreadExecutor executor(3);
  Engine shared;
  ASSERT_EQ(shared.run(viewOf(points), options, nullptr, &executor), Status::Ok);
  std::vector<std::int64_t> ids(points.size());
  ASSERT_EQ(shared.writeOrder(ids.data(), nullptr, &executor), Status::Ok);
  EXPECT_EQ(ids, orderOf(alone));
  std::vector<std::int64_t> ranks(points.size());
  ASSERT_EQ(shared.writeInsertionRanks(ranks.data(), nullptr, &executor), Status::Ok);
  EXPECT_EQ(ranks, ranksOf(alone, points.size()));
}

/// The status of points names vertices; the others are not finite, or points beyond the limit and
/// duplicates of them.
void expectPointStatusAtALimit(const std::vector<Point>& points, const Outcome& limited)
{
  std::set<std::pair<double, double>> placesBeyond;
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const std::int64_t status = limited.pointStatus[i];
    vertices += status == std::int64_t(i) ? 1 : 0;
    if (status >= 0)
    {
      ASSERT_EQ(limited.pointStatus[std::size_t(status)], status) << "point " << i;
    }
    else if (status == kStatusNotInserted)
    {
      placesBeyond.insert({ points[i].x, points[i].y });
    }
  }
  EXPECT_EQ(vertices, limited.report.inserted);
  EXPECT_EQ(placesBeyond.size(), limited.report.beyondLimit);
}

/// The first k points of the order, triangulated by themselves, give the triangles of limit k.
void expectMeshOfTheFirst(const std::vector<Point>& points, Options options, std::size_t limit)
{
  options.keepOrder = true;
  options.insertionLimit = limit;
  Engine engine;
  const Outcome limited = triangulate(engine, viewOf(points), options);
  ASSERT_EQ(limited.status, Status::Ok);
  const std::vector<std::int64_t> order = orderOf(engine);
  std::vector<Point> first;
  for (const std::int64_t id : order)
  {
    first.push_back(points[id]);
  }
  const Outcome expected = triangulate(first);
  EXPECT_EQ(faultsOf(first, expected), "");
  EXPECT_EQ(trianglesOf(limited, [](std::int32_t id) { return std::int64_t(id); }),
    trianglesOf(expected, [&](std::int32_t i) { return order[i]; }));
  EXPECT_EQ(limited.report.triangles, expected.report.triangles);
  EXPECT_EQ(limited.report.inserted, order.size());
  EXPECT_EQ(limited.report.inserted + limited.report.beyondLimit + limited.report.duplicates +
      limited.report.notFinite,
    points.size());
  expectPointStatusAtALimit(points, limited);
}

TEST(Limit, GivesTheTriangulationOfTheFirstPoints)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice,
         Distribution::OnCircle, Distribution::Collinear, Distribution::NestedClusters })
  {
    const std::vector<Point> points = pointsWithFaults(d, 400);
    for (const Options& options : everyDistinctSetting({ 1, 50 }))
    {
      for (const std::size_t limit : { 1, 2, 3, 4, 50, 399, 400, 5000 })
      {
        SCOPED_TRACE(
          std::string(nameOf(d)) + ", limit " + std::to_string(limit) + ", " + describe(options));
        expectMeshOfTheFirst(points, options, limit);
      }
    }
  }
}

/// A run that keeps no order does not write that of the run before.
TEST(Limit, TheNextRunForgetsOrderAndBoxes)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 300, 1);
  Options options;
  options.keepOrder = options.keepBoxes = true;
  options.insertionLimit = 20;
  Engine engine;
  ASSERT_EQ(engine.run(viewOf(points), options, nullptr), Status::Ok);
  EXPECT_FALSE(engine.boxes().empty());
  const Outcome next = triangulate(engine, viewOf(points));
  EXPECT_EQ(faultsOf(points, next), "");
  EXPECT_TRUE(engine.boxes().empty());
  Engine fresh;
  ASSERT_EQ(fresh.run(viewOf(points), Options(), nullptr), Status::Ok);
  engine.reclaim();
  fresh.reclaim();
  EXPECT_EQ(engine.workspace.bytes(), fresh.workspace.bytes());
  EXPECT_EQ(next.triples, triangulate(points).triples);
}

TEST(Limit, NothingIsWrittenOnceTheTriangulationIsReclaimed)
{
  const std::vector<Point> points = pointsWithFaults(Distribution::Uniform, 50);
  Options options;
  options.keepOrder = true;
  options.insertionLimit = 20;
  Engine engine;
  ASSERT_EQ(engine.run(viewOf(points), options, nullptr), Status::Ok);
  engine.reclaim();
  const std::vector<std::int64_t> untouched(points.size(), -7);
  std::vector<std::int64_t> ids = untouched;
  EXPECT_EQ(engine.writePointStatus(ids.data(), nullptr), Status::Ok);
  EXPECT_EQ(engine.writeOrder(ids.data(), nullptr), Status::Ok);
  EXPECT_EQ(engine.writeInsertionRanks(ids.data(), nullptr), Status::Ok);
  EXPECT_EQ(engine.writeTriangles(ids.data(), nullptr), Status::Ok);
  EXPECT_EQ(ids, untouched);
}

std::size_t countIn(const PaperBox& box, const std::vector<Point>& points, const Grid& grid)
{
  const unsigned rest = 32 - box.levels;
  return std::size_t(std::count_if(points.begin(), points.end(),
    [&](const Point& p)
    {
      return std::uint64_t(grid.column(p.x)) >> rest == box.column &&
        std::uint64_t(grid.row(p.y)) >> rest == box.row;
    }));
}

TEST(Limit, BoxesAreThoseOfThePaper)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Line, Distribution::Mixed,
         Distribution::KuzminDisc, Distribution::Collinear })
  {
    const std::vector<Point> points = makePoints(d, 600, 2);
    Engine engine;
    for (Options options : everyDistinctSetting({ 2, 50, 1000 }))
    {
      SCOPED_TRACE(std::string(nameOf(d)) + ", " + describe(options));
      options.keepBoxes = true;
      ASSERT_EQ(engine.run(viewOf(points), options, nullptr), Status::Ok);
      const std::vector<GridBox>& boxes = engine.boxes();
      if (options.order == InsertionOrder::AsGiven)
      {
        EXPECT_TRUE(boxes.empty());
        continue;
      }
      const std::vector<PaperBox> expected = paperOrder(points, options).boxes;
      const Grid grid(boundsOf(points));
      ASSERT_EQ(boxes.size(), expected.size());
      std::size_t sum = 0;
      for (std::size_t i = 0; i < boxes.size(); ++i)
      {
        const unsigned rest = 32 - expected[i].levels;
        ASSERT_EQ(boxes[i].xmin, grid.column.begin(std::uint64_t(expected[i].column) << rest));
        ASSERT_EQ(boxes[i].ymax, grid.row.begin((std::uint64_t(expected[i].row) + 1) << rest));
        ASSERT_EQ(boxes[i].count, countIn(expected[i], points, grid));
        ASSERT_EQ(boxes[i].level, expected[i].divisions);
        sum += boxes[i].count;
      }
      EXPECT_EQ(sum, points.size());
    }
  }
}

/// A box holds its points also by its drawn edges, up to rounding; at the ends of the range too.
TEST(Limit, BoxesAreFiniteAndCoverThePoints)
{
  std::vector<std::vector<Point>> sets{ { { 0, 0 }, { 1e-300, 1e200 }, { 0, 1 } },
    { { 0, 0 }, { 1e-300, 1e308 }, { 0, -1e308 } } };
  for (const Distribution d : { Distribution::Tiny, Distribution::Huge, Distribution::TinyAndHuge,
         Distribution::AnyFinite, Distribution::AllEqual, Distribution::Slivers })
  {
    sets.push_back(makePoints(d, 200, 4));
  }
  for (const std::vector<Point>& points : sets)
  {
    SCOPED_TRACE(&points - sets.data());
    Options options;
    options.nmax = points.size() < 10 ? 1 : 50;
    options.keepBoxes = true;
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points), options, nullptr), Status::Ok);
    const Bounds bounds = boundsOf(points);
    double xmin = std::numeric_limits<double>::infinity();
    double ymax = -xmin;
    for (const GridBox& box : engine.boxes())
    {
      ASSERT_TRUE(std::isfinite(box.xmin) && std::isfinite(box.xmax) && std::isfinite(box.ymin) &&
        std::isfinite(box.ymax));
      ASSERT_LE(box.xmin, box.xmax);
      ASSERT_LE(box.ymin, box.ymax);
      xmin = std::min(xmin, box.xmin);
      ymax = std::max(ymax, box.ymax);
    }
    EXPECT_EQ(xmin, bounds.xmin);
    EXPECT_GE(ymax, bounds.ymax);
  }
}

} // namespace
} // namespace test
} // namespace ahd
