// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of the Voronoi diagram against their definition: convex, counterclockwise, with the
// total area of the clipping border, and each nearer to its own vertex than to any other.
#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"
#include "ListOf.h"

#include "Voronoi/ConvexPolygon.h"
#include "Voronoi/Voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

using Cell = std::vector<Point>;

const VoronoiClip kClips[] = { VoronoiClip::Hull, VoronoiClip::Bounds };

/// The triangle across each edge, by search.
std::vector<std::int64_t> neighborsOf(const std::vector<std::int32_t>& triples)
{
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> owners;
  const auto edge = [&](std::size_t i)
  { return std::make_pair(triples[i], triples[i % 3 == 2 ? i - 2 : i + 1]); };
  for (std::size_t i = 0; i < triples.size(); ++i)
  {
    owners[edge(i)] = i / 3;
  }
  std::vector<std::int64_t> result(triples.size(), -1);
  for (std::size_t i = 0; i < triples.size(); ++i)
  {
    const auto [from, to] = edge(i);
    const auto found = owners.find({ to, from });
    result[i] = found == owners.end() ? -1 : static_cast<std::int64_t>(found->second);
  }
  return result;
}

/// Points, their triangulation and their diagram.
struct Made
{
  Made(std::vector<Point> given, VoronoiClip clip, Executor* executor = nullptr)
    : points(std::move(given))
    , outcome(triangulate(engine, viewOf(points)))
    , neighbors(neighborsOf(outcome.triples))
  {
    EXPECT_EQ(voronoiCells(engine.made, clip, cells, { nullptr, executor }), Status::Ok);
  }

  Cell cell(std::size_t k) const
  {
    Cell result;
    for (const std::int32_t corner : ids(k))
    {
      result.push_back(cells.points[static_cast<std::size_t>(corner)]);
    }
    return result;
  }

  std::vector<std::int32_t> ids(std::size_t k) const
  {
    return { cells.corners.begin() + cells.offsets[k],
      cells.corners.begin() + cells.offsets[k + 1] };
  }

  Point site(std::size_t k) const { return points[static_cast<std::size_t>(cells.sites[k])]; }

  std::vector<Point> points;
  Engine engine;
  Outcome outcome;
  std::vector<std::int64_t> neighbors;
  VoronoiCells cells;
};

double cross(const Point& a, const Point& b, const Point& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double distance(const Point& a, const Point& b)
{
  return std::hypot(a.x - b.x, a.y - b.y);
}

double areaOf(const Cell& cell)
{
  double twice = 0.0;
  for (std::size_t i = 2; i < cell.size(); ++i)
  {
    twice += cross(cell[0], cell[i - 1], cell[i]);
  }
  return 0.5 * twice;
}

/// Of the area that the cells must fill.
double areaToFill(const Made& made, VoronoiClip clip)
{
  if (clip == VoronoiClip::Bounds)
  {
    const auto byX = [](const Point& a, const Point& b) { return a.x < b.x; };
    const auto byY = [](const Point& a, const Point& b) { return a.y < b.y; };
    const auto x = std::minmax_element(made.points.begin(), made.points.end(), byX);
    const auto y = std::minmax_element(made.points.begin(), made.points.end(), byY);
    return (x.second->x - x.first->x) * (y.second->y - y.first->y);
  }
  double area = 0.0;
  for (std::size_t t = 0; t < made.outcome.triples.size(); t += 3)
  {
    const auto corner = [&](std::size_t i)
    { return made.points[static_cast<std::size_t>(made.outcome.triples[t + i])]; };
    area += areaOf({ corner(0), corner(1), corner(2) });
  }
  return area;
}

double sizeOf(const std::vector<Point>& points)
{
  double size = 0.0;
  for (const Point& p : points)
  {
    size = std::max(size, std::max(std::fabs(p.x), std::fabs(p.y)));
  }
  return size;
}

/// The fault of the cell, or "". `rounding`: how far a corner may be from its place.
std::string faultOfShape(const Cell& cell, const Point& site, double rounding)
{
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    const Point& a = cell[i];
    const Point& b = cell[(i + 1) % cell.size()];
    const Point& c = cell[(i + 2) % cell.size()];
    // Twice the area of a triangle changes by this when its corners move by the rounding.
    const double slack = 4.0 * rounding * (distance(a, b) + distance(b, c) + rounding);
    if (cross(a, b, c) < -slack)
    {
      return "not convex or not counterclockwise";
    }
    if (cross(a, b, site) < -4.0 * rounding * (distance(a, b) + distance(b, site) + rounding))
    {
      return "does not contain its vertex";
    }
    if (a == b)
    {
      return "has an edge of length zero";
    }
  }
  return "";
}

/// Is any other vertex nearer to some point of the cell than its own?
std::string faultOfPlace(const Made& made, std::size_t k, double rounding)
{
  const Cell cell = made.cell(k);
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    for (const double part : { 0.0, 0.5, 0.9 })
    {
      const Point p{ cell[i].x + part * (made.site(k).x - cell[i].x),
        cell[i].y + part * (made.site(k).y - cell[i].y) };
      const double own = distance(p, made.site(k));
      for (const Point& other : made.points)
      {
        if (distance(p, other) < own - 4.0 * rounding)
        {
          return "has a point that is nearer to another";
        }
      }
    }
  }
  return "";
}

/// Both of each cell, and whether there is one for each vertex.
void expectRight(const Made& made, VoronoiClip clip, double rounding, bool withPlace)
{
  ASSERT_EQ(made.cells.sites.size(), made.outcome.report.inserted);
  ASSERT_EQ(made.cells.offsets.size(), made.cells.sites.size() + 1);
  EXPECT_TRUE(std::is_sorted(made.cells.sites.begin(), made.cells.sites.end()));
  double area = 0.0;
  for (std::size_t k = 0; k < made.cells.sites.size(); ++k)
  {
    const Cell cell = made.cell(k);
    ASSERT_GE(cell.size(), 3u) << "cell of point " << made.cells.sites[k];
    area += areaOf(cell);
    ASSERT_EQ(faultOfShape(cell, made.site(k), rounding), "")
      << "cell of point " << made.cells.sites[k];
    if (withPlace)
    {
      ASSERT_EQ(faultOfPlace(made, k, rounding), "") << "cell of point " << made.cells.sites[k];
    }
  }
  const double toFill = areaToFill(made, clip);
  const double border = 8.0 * sizeOf(made.points);
  EXPECT_NEAR(area, toFill, 1e-12 * toFill + border * rounding);
}

class VoronoiOf : public testing::TestWithParam<Distribution>
{
};

TEST_P(VoronoiOf, AFewPoints)
{
  for (const VoronoiClip clip : kClips)
  {
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
    {
      for (const std::size_t n : { 3, 4, 7, 40, 300 })
      {
        SCOPED_TRACE(testing::Message()
          << nameOf(GetParam()) << ", " << n << " points, seed " << seed << ", clip " << int(clip));
        const Made made(makePoints(GetParam(), n, seed), clip);
        if (made.outcome.report.triangles > 0)
        {
          expectRight(made, clip, 1e-15 * sizeOf(made.points), true);
        }
      }
    }
  }
}

TEST_P(VoronoiOf, ManyPoints)
{
  for (const VoronoiClip clip : kClips)
  {
    SCOPED_TRACE(testing::Message() << nameOf(GetParam()) << ", clip " << int(clip));
    const Made made(makePoints(GetParam(), reduced(20000), 7), clip);
    expectRight(made, clip, 1e-15 * sizeOf(made.points), false);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, VoronoiOf,
  testing::Values(Distribution::Uniform, Distribution::Line, Distribution::Cross,
    Distribution::Circle, Distribution::Spiral, Distribution::Mixed, Distribution::KuzminDisc,
    Distribution::NestedClusters, Distribution::Lattice, Distribution::DecimalLattice,
    Distribution::OnCircle, Distribution::OnIntegerCircle, Distribution::OnParabola,
    Distribution::RepeatedDraws, Distribution::Utm, Distribution::UtmRaster),
  [](const auto& kind) { return nameOf(kind.param); });

/// Whatever the coordinates: corners within the bounds, and three of them.
TEST(Voronoi, EndsOfTheExponentRange)
{
  for (const Distribution d : { Distribution::Tiny, Distribution::Huge, Distribution::TinyAndHuge,
         Distribution::AnyFinite, Distribution::NearlyCollinear, Distribution::Slivers })
  {
    for (const VoronoiClip clip : kClips)
    {
      SCOPED_TRACE(testing::Message() << nameOf(d) << ", clip " << int(clip));
      const Made made(makePoints(d, 300, 5), clip);
      const double size = sizeOf(made.points);
      ASSERT_EQ(made.cells.sites.size(), made.outcome.report.inserted);
      for (std::size_t k = 0; k < made.cells.sites.size(); ++k)
      {
        EXPECT_GE(made.cell(k).size(), 3u);
        for (const Point& p : made.cell(k))
        {
          EXPECT_TRUE(
            std::fabs(p.x) <= size * (1.0 + 1e-15) && std::fabs(p.y) <= size * (1.0 + 1e-15))
            << p.x << " " << p.y;
        }
      }
    }
  }
}

std::vector<Point> lattice(int n, double step, double origin)
{
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      points.push_back({ origin + step * i, origin + step * j });
    }
  }
  return points;
}

TEST(Voronoi, CellsOfALatticeAreSquares)
{
  for (const double step : { 1.0, 0.1 })
  {
    const Made made(lattice(12, step, step == 1.0 ? 0.0 : 411000.3), VoronoiClip::Hull);
    ASSERT_EQ(made.cells.sites.size(), 144u);
    EXPECT_EQ(made.cells.points.size(), 11u * 11u + 4u * 11u + 4u * 11u)
      << "centres of squares, middles of border edges, points of the border";
    for (std::size_t k = 0; k < 144; ++k)
    {
      const int i = int(k) / 12;
      const int j = int(k) % 12;
      const int sides = (i == 0 || i == 11) + (j == 0 || j == 11);
      EXPECT_EQ(made.cell(k).size(), sides == 0 ? 4u : sides == 1 ? 5u : 4u) << i << ", " << j;
      if (step == 1.0)
      {
        EXPECT_EQ(areaOf(made.cell(k)), sides == 0 ? 1.0 : sides == 1 ? 0.5 : 0.25);
      }
    }
  }
}

TEST(Voronoi, NeighboursShareTwoCorners)
{
  const Made made(makePoints(Distribution::Uniform, 2000, 3), VoronoiClip::Hull);
  std::map<std::int32_t, std::size_t> cellOf;
  for (std::size_t k = 0; k < made.cells.sites.size(); ++k)
  {
    cellOf[made.cells.sites[k]] = k;
  }
  std::size_t shared = 0;
  for (std::size_t i = 0; i < made.neighbors.size(); ++i)
  {
    const auto& triples = made.outcome.triples;
    const auto a = made.ids(cellOf[triples[i]]);
    const auto b = made.ids(cellOf[triples[i % 3 == 2 ? i - 2 : i + 1]]);
    const std::set<std::int32_t> ofA(a.begin(), a.end());
    const auto common = std::count_if(
      b.begin(), b.end(), [&](std::int32_t corner) { return ofA.count(corner) > 0; });
    EXPECT_TRUE(common == 2 || (common == 0)) << "edge " << i << ": " << common;
    shared += common == 2 ? 1 : 0;
  }
  // Only near the hull may an edge of the diagram lie outside.
  EXPECT_GT(shared, made.neighbors.size() - 400);
  // Every corner inside is a corner of three cells, on the border of two or, at a vertex, one.
  std::vector<int> uses(made.cells.points.size(), 0);
  for (const std::int32_t corner : made.cells.corners)
  {
    ++uses[static_cast<std::size_t>(corner)];
  }
  EXPECT_GT(std::count(uses.begin(), uses.end(), 3), 3800);
  EXPECT_EQ(std::count_if(uses.begin(), uses.end(), [](int n) { return n < 1 || n > 3; }), 0);
}

/// The number of corners stays linear where all cells but one reach the border, and where the
/// centres lie far outside.
TEST(Voronoi, LinearOnCircleAndParabola)
{
  const std::size_t n = reduced(30000);
  for (const Distribution d : { Distribution::OnCircle, Distribution::OnParabola })
  {
    for (const VoronoiClip clip : kClips)
    {
      const Made made(makePoints(d, n, 1), clip);
      EXPECT_LT(made.cells.corners.size(), 9 * n);
      expectRight(made, clip, 1e-15 * sizeOf(made.points), false);
    }
  }
  std::vector<Point> wheel = makePoints(Distribution::OnCircle, n, 1);
  wheel.push_back({ 0.0, 0.0 });
  for (const VoronoiClip clip : kClips)
  {
    const Made made(wheel, clip);
    EXPECT_LT(made.cells.corners.size(), 9 * n);
    expectRight(made, clip, 1e-15, false);
  }
}

TEST(Voronoi, StripsOfCollinearPoints)
{
  // The diagonal of a box of 4 x 2; the points in no order, one twice.
  const std::vector<Point> points = { { 4, 2 }, { 0, 0 }, { 1, 0.5 }, { 4, 2 }, { 2, 1 } };
  const Made made(points, VoronoiClip::Bounds);
  ASSERT_EQ(listOf(made.cells.sites), (std::vector<std::int32_t>{ 0, 1, 2, 4 }));
  double area = 0.0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    EXPECT_EQ(faultOfShape(made.cell(k), made.site(k), 1e-15), "");
    EXPECT_EQ(faultOfPlace(made, k, 1e-15), "");
    area += areaOf(made.cell(k));
  }
  EXPECT_NEAR(area, 8.0, 1e-14);
  EXPECT_TRUE(Made(points, VoronoiClip::Hull).cells.sites.empty()) << "a hull without area";
}

TEST(Voronoi, FewPoints)
{
  const std::vector<Point> two = { { 0, 0 }, { 2, 1 } };
  const Made made(two, VoronoiClip::Bounds);
  ASSERT_EQ(made.cells.sites.size(), 2u);
  EXPECT_NEAR(areaOf(made.cell(0)), 1.0, 1e-15);
  EXPECT_NEAR(areaOf(made.cell(1)), 1.0, 1e-15);
  for (const std::vector<Point>& points : { std::vector<Point>{}, { { 1, 2 } },
         { { 0, 0 }, { 3, 0 } }, { { 0, 0 }, { 0, 1 }, { 0, 3 } } })
  {
    for (const VoronoiClip clip : kClips)
    {
      const Made none(points, clip);
      EXPECT_TRUE(none.cells.sites.empty());
      EXPECT_EQ(listOf(none.cells.offsets), std::vector<std::int32_t>{ 0 });
    }
  }
  EXPECT_TRUE(Made(two, VoronoiClip::Hull).cells.sites.empty());
}

TEST(Voronoi, CentreOutsideTheHull)
{
  // Flat: the circumcentre lies far below; the cell of the middle vertex reaches through the base.
  const std::vector<Point> points = { { 0, 0 }, { 8, 0 }, { 4, 1 } };
  const Made made(points, VoronoiClip::Hull);
  ASSERT_EQ(made.cells.sites.size(), 3u);
  expectRight(made, VoronoiClip::Hull, 1e-15, true);
  // The bisectors of the sides meet the base at 4 +- 15/8.
  EXPECT_NEAR(areaOf(made.cell(0)), 0.5 * (4.0 - 1.875) * 0.5, 1e-14);
  EXPECT_NEAR(areaOf(made.cell(2)), 4.0 - 2 * 0.5 * (4.0 - 1.875) * 0.5, 1e-14);
}

TEST(Voronoi, RightAngleOnTheHull)
{
  // The centre is the middle of the base, exactly: one corner, not two.
  const Made made({ { -1, 0 }, { 1, 0 }, { 0, 1 } }, VoronoiClip::Hull);
  expectRight(made, VoronoiClip::Hull, 0.0, true);
  EXPECT_EQ(made.cells.points.size(), 3u + 3u);
}

TEST(Voronoi, SameWithThreads)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, reduced(40000), 2);
  const Made one(points, VoronoiClip::Hull);
  ThreadExecutor executor(3);
  const Made three(points, VoronoiClip::Hull, &executor);
  EXPECT_EQ(listOf(one.cells.points), listOf(three.cells.points));
  EXPECT_EQ(listOf(one.cells.corners), listOf(three.cells.corners));
}

/// Cancels at one poll.
class StopAt : public Progress
{
public:
  explicit StopAt(std::size_t at)
    : at_(at)
  {
  }
  bool advance(Phase, double) override { return ++asked != at_; }
  std::size_t asked = 0;

private:
  std::size_t at_;
};

TEST(Voronoi, CanBeCancelledAtAnyAsking)
{
  // as many under sanitizers, too: with fewer it polls too seldom
  Made made(makePoints(Distribution::Uniform, 6000, 2), VoronoiClip::Hull);
  const ConvexPolygon polygon({ { 0.1, 0.1 }, { 2.0, 0.7 }, { 0.3, 0.8 } });
  VoronoiCells cells;
  const auto make = [&](VoronoiClip clip, Progress& progress)
  {
    const Context context{ &progress, nullptr };
    return clip == VoronoiClip::Polygon ? voronoiCells(made.engine.made, polygon, cells, context)
                                        : voronoiCells(made.engine.made, clip, cells, context);
  };
  for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds, VoronoiClip::Polygon })
  {
    StopAt never(0);
    ASSERT_EQ(make(clip, never), Status::Ok);
    ASSERT_GT(never.asked, 3u);
    for (std::size_t at = 1; at <= never.asked; ++at)
    {
      StopAt progress(at);
      EXPECT_EQ(make(clip, progress), Status::Cancelled);
      EXPECT_TRUE(cells.sites.empty() && cells.points.empty() && cells.corners.empty());
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
