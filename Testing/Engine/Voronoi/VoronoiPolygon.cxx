// SPDX-License-Identifier: BSD-3-Clause
//
// Cells of the Voronoi diagram in a polygon of one's own: which polygons are taken, the same cells
// however it is given, on many threads, in any order of the points and at every scale; cells of
// many points. VoronoiCorners compares those of few with exact ones.
#include "CellShapes.h"
#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"
#include "ListOf.h"

#include "Voronoi/ConvexPolygon.h"
#include "Voronoi/Voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace ahd::test
{
namespace
{

using Corners = std::vector<Point>;

VoronoiCells cellsIn(
  const Corners& polygon, const std::vector<Point>& points, Executor* executor = nullptr)
{
  Engine engine;
  EXPECT_EQ(engine.run(viewOf(points)), Status::Ok);
  const ConvexPolygon convex(polygon);
  EXPECT_EQ(convex.fault(), PolygonFault::None);
  VoronoiCells cells;
  EXPECT_EQ(voronoiCells(engine.made, convex, cells, { nullptr, executor }), Status::Ok);
  return cells;
}

Corners regularPolygon(std::size_t count, Point middle, double radius)
{
  Corners corners;
  for (std::size_t k = 0; k < count; ++k)
  {
    const double angle = 6.283185307179586 * double(k) / double(count);
    corners.push_back({ middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle) });
  }
  return corners;
}

void expectEqual(const VoronoiCells& one, const VoronoiCells& two)
{
  EXPECT_EQ(listOf(one.points), listOf(two.points));
  EXPECT_EQ(listOf(one.corners), listOf(two.corners));
  EXPECT_EQ(listOf(one.offsets), listOf(two.offsets));
  EXPECT_EQ(listOf(one.sites), listOf(two.sites));
}

TEST(VoronoiPolygon, FaultsAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto faultOf = [](const Corners& corners) { return ConvexPolygon(corners).fault(); };
  for (const Corners& corners :
    { Corners{}, { { 1, 2 } }, { { 1, 2 }, { 1, 5 } }, { { 0, 0 }, { 1, 1 }, { 5, 5 } },
      { { 0, 0 }, { 1, 1 }, { 0, 0 } }, { { 1, 1 }, { 1, 1 }, { 1, 1 } } })
  {
    EXPECT_EQ(faultOf(corners), PolygonFault::NoArea) << corners.size();
  }
  for (const double bad : { nan, infinity, -infinity })
  {
    EXPECT_EQ(faultOf({ { 0, 0 }, { bad, 0 }, { 0, 1 } }), PolygonFault::NotFinite);
    EXPECT_EQ(faultOf({ { 0, bad }, { 1, 1 } }), PolygonFault::NotFinite);
  }
  const Corners star = { { 0, 3 }, { 2, -3 }, { -3, 1 }, { 3, 1 }, { -2, -3 } };
  const Corners spikes[] = { { { 0, 0 }, { 4, 0 }, { 3, 0 }, { 0, 3 } },
    { { 0, 0 }, { 4, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } },
    { { 0, 0 }, { 2, 0 }, { 2, 5 }, { 2, 2 } } };
  const Corners twice = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 }, { 1, 0 }, { 0, 1 } };
  const Corners dent = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 2, std::nextafter(4.0, 0.0) }, { 0, 4 } };
  const Corners bow = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } };
  for (const Corners& corners : { star, spikes[0], spikes[1], spikes[2], twice, dent, bow })
  {
    EXPECT_EQ(faultOf(corners), PolygonFault::NotConvex) << corners.size() << corners[2].x;
  }
}

/// The direction, the first corner, corners on sides and repeated ones change nothing.
TEST(VoronoiPolygon, TheSameHoweverItIsGiven)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 200, 1);
  const Corners square = { { 0.2, 0.1 }, { 0.9, 0.1 }, { 0.9, 0.7 }, { 0.2, 0.7 } };
  const VoronoiCells expected = cellsIn(square, points);
  for (const Corners& corners : { Corners{ { 0.9, 0.1 }, { 0.2, 0.7 } },
         { { 0.9, 0.7 }, { 0.9, 0.1 }, { 0.2, 0.1 }, { 0.2, 0.7 } },
         { { 0.9, 0.1 }, { 0.9, 0.3 }, { 0.9, 0.7 }, { 0.9, 0.7 }, { 0.2, 0.7 }, { 0.2, 0.1 },
           { 0.5, 0.1 }, { 0.9, 0.1 } } })
  {
    expectEqual(cellsIn(corners, points), expected);
  }
}

TEST(VoronoiPolygon, TheBoxAroundTheVerticesIsTheBounds)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::UtmRaster,
         Distribution::OnIntegerCircle, Distribution::Cross })
  {
    const std::vector<Point> points = makePoints(d, 500, 3);
    Point low = points[0], high = points[0];
    for (const Point& p : points)
    {
      low = { std::min(low.x, p.x), std::min(low.y, p.y) };
      high = { std::max(high.x, p.x), std::max(high.y, p.y) };
    }
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    VoronoiCells cells;
    ASSERT_EQ(voronoiCells(engine.made, VoronoiClip::Bounds, cells, {}), Status::Ok);
    expectEqual(cellsIn({ high, low }, points), cells);
  }
}

/// Cells are convex, and fill the polygon; those of vertices far away are empty.
TEST(VoronoiPolygon, CellsOfManyPointsFillIt)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice,
         Distribution::OnCircle, Distribution::NestedClusters, Distribution::Spiral })
  {
    const std::vector<Point> points = makePoints(d, reduced(20000), 7);
    for (const Corners& polygon : { regularPolygon(3, { 0.4, 0.45 }, 0.3),
           regularPolygon(200, { 0.5, 0.5 }, 0.2), regularPolygon(5, { 0.5, 0.5 }, 40.0) })
    {
      SCOPED_TRACE(testing::Message() << nameOf(d) << ", " << polygon.size() << " corners");
      const VoronoiCells cells = cellsIn(polygon, points);
      double area = 0.0;
      for (std::size_t k = 0; k < cells.sites.size(); ++k)
      {
        const std::vector<Point> cell = cellOf(cells, k);
        ASSERT_TRUE(cell.empty() || cell.size() >= 3) << cell.size();
        for (std::size_t i = 0; i < cell.size(); ++i)
        {
          const Point &b = cell[(i + 1) % cell.size()], &c = cell[(i + 2) % cell.size()];
          ASSERT_GT(areaOf({ cell[i], b, c }), -1e-12) << k;
        }
        area += areaOf(cell);
      }
      EXPECT_NEAR(area, areaOf(polygon), 1e-12 * std::max(1.0, areaOf(polygon)));
    }
  }
}

/// Without an edge of the diagram inside: the polygon is in one cell.
TEST(VoronoiPolygon, MayBeWithinOneCell)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 3000, 5);
  for (const std::size_t at : { 0, 1500, 2999 })
  {
    const Point p = points[at];
    const Corners polygon = regularPolygon(7, p, 1e-9);
    const VoronoiCells cells = cellsIn(polygon, points);
    for (std::size_t k = 0; k < cells.sites.size(); ++k)
    {
      EXPECT_EQ(cellOf(cells, k).size(), cells.sites[k] == std::int32_t(at) ? 7u : 0u) << k;
    }
    EXPECT_EQ(areaOf(cellOf(cells, at)), areaOf(listOf(cells.points)));
  }
  // Two sides away from all points: that of the nearest one.
  const VoronoiCells cells = cellsIn({ { 1e6, 5 }, { 1e6 + 1, 6 } }, points);
  EXPECT_EQ(cells.corners.size(), 4u);
}

TEST(VoronoiPolygon, SameWithThreadsAndInAnyOrder)
{
  std::vector<Point> points = makePoints(Distribution::Mixed, reduced(40000), 2);
  const Corners polygon = regularPolygon(30, { 0.5, 0.5 }, 0.35);
  const VoronoiCells one = cellsIn(polygon, points);
  ThreadExecutor executor(3);
  expectEqual(one, cellsIn(polygon, points, &executor));
  std::map<std::pair<double, double>, std::vector<Point>> cells;
  for (std::size_t k = 0; k < one.sites.size(); ++k)
  {
    const Point site = points[static_cast<std::size_t>(one.sites[k])];
    cells[{ site.x, site.y }] = cellOf(one, k);
  }
  std::shuffle(points.begin(), points.end(), std::mt19937_64(3));
  const VoronoiCells two = cellsIn(polygon, points);
  ASSERT_EQ(two.sites.size(), one.sites.size());
  for (std::size_t k = 0; k < two.sites.size(); ++k)
  {
    const Point site = points[static_cast<std::size_t>(two.sites[k])];
    ASSERT_EQ(cellOf(two, k), (cells[{ site.x, site.y }])) << k;
  }
}

TEST(VoronoiPolygon, SameAtEveryScale)
{
  const auto scaled = [](std::vector<Point> points, int exponent)
  {
    for (Point& p : points)
    {
      p = { std::ldexp(p.x, exponent), std::ldexp(p.y, exponent) };
    }
    return points;
  };
  const Corners polygon = { { 0.1, 0.3 }, { 0.75, 0.25 }, { 0.9, 1.5 } };
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice })
  {
    const std::vector<Point> points = makePoints(d, 60, 3);
    const VoronoiCells expected = cellsIn(polygon, points);
    for (const int exponent : { -860, -250, 250, 990 })
    {
      const VoronoiCells cells = cellsIn(scaled(polygon, exponent), scaled(points, exponent));
      EXPECT_EQ(listOf(cells.corners), listOf(expected.corners));
      EXPECT_EQ(listOf(cells.offsets), listOf(expected.offsets));
      ASSERT_EQ(cells.points.size(), expected.points.size());
      for (std::size_t i = 0; i < cells.points.size(); ++i)
      {
        const Point p = scaled({ Point(expected.points[i]) }, exponent)[0];
        EXPECT_TRUE(Point(cells.points[i]) == p) << i;
      }
    }
  }
}

TEST(VoronoiPolygon, EmptyCellsCanBeLeftOut)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 500, 1);
  const Corners polygon = regularPolygon(3, { 0.4, 0.4 }, 0.1);
  VoronoiCells cells = cellsIn(polygon, points);
  const VoronoiCells all = cellsIn(polygon, points);
  EXPECT_EQ(all.sites.size(), 500u);
  leaveOutEmpty(cells);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < all.sites.size(); ++k)
  {
    if (!cellOf(all, k).empty())
    {
      ASSERT_LT(kept, cells.sites.size());
      EXPECT_EQ(cells.sites[kept], all.sites[k]);
      EXPECT_EQ(cellOf(cells, kept++), cellOf(all, k));
    }
  }
  EXPECT_EQ(kept, cells.sites.size());
  EXPECT_LT(kept, 100u);
}

} // namespace
} // namespace ahd::test
