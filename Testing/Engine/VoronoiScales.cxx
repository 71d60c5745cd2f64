// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of the Voronoi diagram at the ends of the range of double, and where rounding could
// show: the same cells at every scale, and none with an edge of length zero that need not have one.
#include "Distributions.h"
#include "EngineRun.h"
#include "Voronoi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ahd::test
{
namespace
{

VoronoiCells cellsOf(const std::vector<Point>& points, VoronoiClip clip)
{
  Triangulator triangulator;
  const Outcome outcome = triangulate(triangulator, viewOf(points));
  std::vector<std::int64_t> neighbors(outcome.triples.size());
  EXPECT_EQ(triangulator.writeNeighbors(neighbors.data(), nullptr), Status::Ok);
  DelaunayView view;
  view.points = viewOf(points);
  view.fates = outcome.fates.data();
  view.corners = outcome.triples.data();
  view.neighbors = neighbors.data();
  view.triangles = outcome.triples.size() / 3;
  VoronoiCells cells;
  EXPECT_EQ(voronoiCells(view, clip, cells, nullptr), Status::Ok);
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

std::vector<Point> cell(const VoronoiCells& cells, std::size_t k)
{
  std::vector<Point> result;
  for (std::int64_t i = cells.offsets[k]; i < cells.offsets[k + 1]; ++i)
  {
    result.push_back(
      cells.points[static_cast<std::size_t>(cells.corners[static_cast<std::size_t>(i)])]);
  }
  return result;
}

double areaOf(const std::vector<Point>& corners)
{
  double twice = 0.0;
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    const Point &a = corners[0], &b = corners[i - 1], &c = corners[i];
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return twice / 2;
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
          EXPECT_EQ(cells.points, scaled(expected.points, exponent));
          EXPECT_EQ(cells.corners, expected.corners);
          EXPECT_EQ(cells.offsets, expected.offsets);
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
    for (const Point& p : cell(cells, k))
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
  constexpr double kFar = 0x1p500;
  for (const double sign : { 1.0, -1.0 })
  {
    const std::vector<Point> points = { { -kFar, 0 }, { kFar, 0 }, { 0, sign * -0x1p-520 },
      { 0, sign * -kFar } };
    for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
    {
      const VoronoiCells cells = cellsOf(points, clip);
      ASSERT_EQ(cells.sites.size(), 4u);
      // In units of kFar: squares of 1 x 1/2 around the middle one, triangles and more at the
      // others.
      EXPECT_NEAR(areaOf(cell(cells, 2)) / kFar / kFar, 0.5, 1e-12) << int(clip) << sign;
      EXPECT_NEAR(
        areaOf(cell(cells, 0)) / kFar / kFar, clip == VoronoiClip::Hull ? 0.125 : 0.375, 1e-12);
    }
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
    const std::vector<Point> corners = cell(cells, k);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      EXPECT_FALSE(corners[i] == corners[(i + 1) % corners.size()]) << "cell " << k << ", " << i;
    }
  }
}

} // namespace
} // namespace ahd::test
