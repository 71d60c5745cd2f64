// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of the Voronoi diagram at the ends of the range of double, and where rounding could
// show: the same cells at every scale, and none with an edge of length zero that need not have one.
#include "CellShapes.h"
#include "Distributions.h"
#include "EngineRun.h"
#include "ListOf.h"
#include "Triangulation/State.h"
#include "Voronoi/Diagram.h"
#include "Voronoi/Voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ahd::test
{
namespace
{

VoronoiCells cellsOf(const std::vector<Point>& points, VoronoiClip clip)
{
  Engine engine;
  EXPECT_EQ(engine.run(viewOf(points)), Status::Ok);
  VoronoiCells cells;
  EXPECT_EQ(voronoiCells(engine.made, clip, cells, {}), Status::Ok);
  return cells;
}

std::vector<Point> scaled(std::vector<Point> points, int exponent)
{
  for (Point& p : points)
  {
    p = { std::ldexp(p.x, exponent), std::ldexp(p.y, exponent) };
  }
  return points;
}

TEST(VoronoiScales, SameAtEveryScale)
{
  for (const Distribution distribution : { Distribution::Uniform, Distribution::Lattice,
         Distribution::OnParabola, Distribution::OnIntegerCircle, Distribution::NestedClusters })
  {
    for (const std::size_t n : { 3, 5, 60 })
    {
      const std::vector<Point> points = makePoints(distribution, n, 3);
      for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
      {
        const VoronoiCells expected = cellsOf(points, clip);
        for (const int exponent : { -860, -700, -520, -250, 250, 500, 520, 700, 990 })
        {
          SCOPED_TRACE(testing::Message() << nameOf(distribution) << ", " << n << " points, clip "
                                          << int(clip) << ", 2^" << exponent);
          const VoronoiCells cells = cellsOf(scaled(points, exponent), clip);
          EXPECT_EQ(listOf(cells.points), scaled(listOf(expected.points), exponent));
          EXPECT_EQ(listOf(cells.corners), listOf(expected.corners));
          EXPECT_EQ(listOf(cells.offsets), listOf(expected.offsets));
        }
      }
    }
  }
}

/// Two vertices that are near, the others as far away as can be: their bisector leaves the box far
/// away.
TEST(VoronoiScales, NearVerticesInAHugeBox)
{
  const std::vector<Point> points = { { 0, 0 }, { 0, 1e-3 }, { 1e308, 1.7e308 },
    { -1e308, -1.7e308 } };
  const VoronoiCells cells = cellsOf(points, VoronoiClip::Bounds);
  ASSERT_EQ(cells.sites.size(), 4u);
  for (const Point& p : cells.points)
  {
    EXPECT_TRUE(std::fabs(p.x) <= 1e308 && std::fabs(p.y) <= 1.7e308) << p.x << ", " << p.y;
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    double farthest = 0.0;
    for (const Point& p : cellOf(cells, k))
    {
      farthest = std::fabs(p.y) < 1.0 ? std::max(farthest, std::fabs(p.x)) : farthest;
    }
    EXPECT_EQ(farthest, 1e308) << "cell " << k << " does not reach the side along its bisector";
  }
}

/// One triangle so flat that its centre is beyond all doubles, beside others whose centres are
/// inside.
TEST(VoronoiScales, CentresBeyondAllDoubles)
{
  constexpr int kExponent = 1000;
  for (const double sign : { 1.0, -1.0 })
  {
    const std::vector<Point> points = { { -1, 0 }, { 1, 0 }, { 0, sign * -0x1p-35 },
      { 0, sign * -1 } };
    for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
    {
      const VoronoiCells cells = cellsOf(scaled(points, kExponent), clip);
      ASSERT_EQ(cells.sites.size(), 4u);
      const auto area = [&](std::size_t k) { return areaOf(scaled(cellOf(cells, k), -kExponent)); };
      EXPECT_NEAR(area(2), 0.5, 1e-9) << "a rectangle of 1 x 1/2, clip " << int(clip);
      EXPECT_NEAR(area(0), clip == VoronoiClip::Hull ? 0.125 : 0.375, 1e-9) << int(clip);
    }
  }
}

/// The centres of the two halves of a turned square differ in their last bits: they are one corner.
TEST(VoronoiScales, CellsOfATurnedLatticeHaveFourCorners)
{
  constexpr int kSide = 12;
  std::vector<Point> points;
  for (int i = 0; i < kSide; ++i)
  {
    for (int j = 0; j < kSide; ++j)
    {
      points.push_back({ 1000.0 + 0.06 * i - 0.08 * j, 2000.0 + 0.08 * i + 0.06 * j });
    }
  }
  const VoronoiCells cells = cellsOf(points, VoronoiClip::Hull);
  ASSERT_EQ(cells.sites.size(), points.size());
  for (int i = 1; i + 1 < kSide; ++i)
  {
    for (int j = 1; j + 1 < kSide; ++j)
    {
      EXPECT_EQ(cellOf(cells, static_cast<std::size_t>(kSide * i + j)).size(), 4u)
        << i << ", " << j;
    }
  }
}

/// Centres that are joined do not drift away in steps: each is near to the one that stands for it.
TEST(VoronoiScales, CentresAreNearWhatStandsForThem)
{
  std::size_t joined = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed)
  {
    const std::vector<Point> points = makePoints(Distribution::OnCircle, 20 + seed % 60, seed);
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
    const auto& state = *TriangulationAccess::stateOf(std::as_const(engine.made));
    Diagram diagram(state.tables, state.ranked.xy.data(), state.ranked.bounds, true);
    Ticker ticker(nullptr, Phase::Outputs, 0);
    ASSERT_TRUE(diagram.build(ticker));
    for (std::size_t t = 0; t < diagram.triangles(); ++t)
    {
      const Point own = diagram.centre(t), other = diagram.centre(diagram.standIn(t));
      constexpr double kMost = 0x1p-51; // two units of coordinates below 1
      EXPECT_TRUE(std::fabs(own.x - other.x) <= kMost && std::fabs(own.y - other.y) <= kMost) << t;
      joined += diagram.standIn(t) != t ? 1 : 0;
    }
  }
  EXPECT_GT(joined, 1000u);
}

/// Vertices one unit in the last place apart: two corners on the border of the box are in reverse
/// order, but no cell passes the whole border.
TEST(VoronoiScales, NoCellPassesTheWholeBorderByRounding)
{
  const std::vector<Point> points = { { -2, 4 }, { 3, 9 }, { -2, 0x1.0000000000001p+2 }, { -4, 16 },
    { -2, 0x1.ffffffffffffep+1 }, { -3, 9 } };
  const VoronoiCells cells = cellsOf(points, VoronoiClip::Bounds);
  double area = 0.0;
  for (std::size_t k = 0; k < cells.sites.size(); ++k)
  {
    area += areaOf(cellOf(cells, k));
  }
  EXPECT_NEAR(area, 7.0 * 12.0, 1e-9);
}

void expectCornersWithinTheBounds(const std::vector<Point>& points)
{
  const auto [left, right] = std::minmax_element(
    points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const auto [low, high] = std::minmax_element(
    points.begin(), points.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
  {
    SCOPED_TRACE(testing::Message() << points[0].x << ", clip " << int(clip));
    const VoronoiCells cells = cellsOf(points, clip);
    EXPECT_EQ(cells.sites.size(), points.size());
    for (const Point& p : cells.points)
    {
      EXPECT_TRUE(p.x >= left->x && p.x <= right->x && p.y >= low->y && p.y <= high->y)
        << p.x << " " << p.y;
    }
  }
}

/// Bisectors of points whose distance is negligible beside the box in doubles, or below half of the
/// smallest double: corners within the bounds of the points all the same.
TEST(VoronoiScales, NearPointsInAHugeBox)
{
  const std::vector<Point> drawings[] = { { { 0x1p-995, 0 }, { 0x1p-995, 0x1p-995 }, { 0, 0 },
                                            { 0x1p996, 0x1p996 }, { -0x1p996, -0x1p996 },
                                            { 0x1p996, -0x1p996 } },
    { { 0x1p496, 5e-324 }, { 0x1p496, -5e-324 }, { 0x1p549, 9.0 } },
    { { 0x1p556, -5e-324 }, { 0x1p556, 0x1.8p558 }, { 5e-324, -0x1p194 }, { 0, -0x1p194 },
      { 0x1.dp557, -0x1p557 }, { 0x1p-1050, 0x1p-1050 } } };
  for (std::vector<Point> points : drawings)
  {
    expectCornersWithinTheBounds(points);
    for (Point& p : points)
    {
      p = { p.y, p.x };
    }
    expectCornersWithinTheBounds(points);
  }
}

/// Nearly on one line: crossings with two edges of the hull that round to one place are one corner.
TEST(VoronoiScales, CrossingsAtOnePlaceAreOneCorner)
{
  const std::vector<Point> points = { { 0x1.e54669192778p-4, 0x1.e54669192778p-4 },
    { 0x1.29accbd562d9fp-1, 0x1.29accbd562d9fp-1 }, { 0x1.2bd0d0e6ceep-8, 0x1.2bd0d0e6cee8p-8 },
    { 0x1.cce49c0d6c1bap-1, 0x1.cce49c0d6c1b9p-1 } };
  const VoronoiCells cells = cellsOf(points, VoronoiClip::Hull);
  for (std::size_t k = 0; k < cells.sites.size(); ++k)
  {
    const std::vector<Point> corners = cellOf(cells, k);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      EXPECT_FALSE(corners[i] == corners[(i + 1) % corners.size()]) << "cell " << k << ", " << i;
    }
  }
}

} // namespace
} // namespace ahd::test
