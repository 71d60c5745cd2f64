// SPDX-License-Identifier: BSD-3-Clause
//
// Allocations of the Voronoi diagram: no more than estimated, and a failed one is reported and
// leaves nothing. This program's operator new counts, and fails on demand.
#include "Distributions.h"
#include "EngineRun.h"
#include "OwnMemory.h"

#include "Voronoi/ConvexPolygon.h"
#include "Voronoi/Voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ahd
{
namespace test
{
namespace
{

/// A triangulation, with the tables that the diagram needs.
struct Given
{
  explicit Given(const std::vector<Point>& where)
    : points(where)
  {
    EXPECT_EQ(engine.run(viewOf(points)), Status::Ok);
    EXPECT_EQ(engine.made.makeNeighbors({}), Status::Ok);
  }

  std::vector<Point> points;
  Engine engine;
};

const VoronoiClip kClips[] = { VoronoiClip::Hull, VoronoiClip::Bounds, VoronoiClip::Polygon };

/// With a box of the caller's own, in which half of the vertices lie, as polygon.
Status makeCells(Given& given, VoronoiClip clip, VoronoiCells& cells)
{
  static const ConvexPolygon box({ { 0.1, 0.2 }, { 0.8, 0.9 } });
  Triangulation& delaunay = given.engine.made;
  return clip == VoronoiClip::Polygon ? voronoiCells(delaunay, box, cells, {})
                                      : voronoiCells(delaunay, clip, cells, {});
}

TEST(VoronoiMemory, NoMoreThanEstimated)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice,
         Distribution::OnCircle, Distribution::OnParabola, Distribution::NearlyCollinear,
         Distribution::Spiral, Distribution::Collinear })
  {
    for (const std::size_t n : { std::size_t(3), std::size_t(100), reduced(50000) })
    {
      Given given(makePoints(d, n, 1));
      for (const VoronoiClip clip : kClips)
      {
        const std::size_t before = account.held;
        account.peak = before;
        VoronoiCells cells;
        ASSERT_EQ(makeCells(given, clip, cells), Status::Ok);
        const std::size_t corners = clip == VoronoiClip::Polygon ? 4 : 0;
        EXPECT_LE(account.peak - before, voronoiMemoryEstimate(n + corners))
          << nameOf(d) << ", " << n << ", clip " << int(clip);
      }
    }
  }
}

/// The estimate is for points all on the hull, where it is closest; others take not much less.
TEST(VoronoiMemory, NotMuchMoreIsEstimatedThanTaken)
{
  Given given(makePoints(Distribution::Uniform, 50000, 1));
  for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
  {
    const std::size_t before = account.held;
    account.peak = before;
    VoronoiCells cells;
    ASSERT_EQ(makeCells(given, clip, cells), Status::Ok);
    EXPECT_GE(3 * (account.peak - before), 2 * voronoiMemoryEstimate(50000));
  }
}

TEST(VoronoiMemory, FailureOfAnyAllocationIsReported)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::OnCircle })
  {
    Given given(makePoints(d, 200, 1));
    for (const VoronoiClip clip : kClips)
    {
      VoronoiCells cells;
      Status status = Status::OutOfMemory;
      std::size_t failures = 0;
      const std::size_t before = account.held;
      for (std::size_t at = 1; status != Status::Ok; ++at)
      {
        account.allocations = 0;
        account.failAt = at;
        status = makeCells(given, clip, cells);
        account.failAt = 0;
        if (status != Status::Ok)
        {
          ASSERT_EQ(status, Status::OutOfMemory);
          ASSERT_TRUE(cells.corners.empty() && cells.points.empty() && cells.sites.empty());
          ASSERT_EQ(account.held, before) << "something leaked";
          ++failures;
        }
      }
      EXPECT_GT(failures, 10u);
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
