// SPDX-License-Identifier: BSD-3-Clause
//
// Corners of Voronoi cells, each cell against the exact one, clipped at the hull, the box and
// polygons whose corners lie on, between and beside the vertices: for vertices a few units in the
// last place apart, in tiny clusters, on rounded lattices, and at the ends of the range of double.
#include "Distributions.h"
#include "EngineRun.h"
#include "ExactSigns.h"
#include "VoronoiOracle.h"

#include "Voronoi/ConvexPolygon.h"
#include "Voronoi/Voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace ahd::test
{
namespace
{

/// Small sets of one kind each, the same for the same seed.
class Sets
{
public:
  explicit Sets(std::uint64_t seed)
    : random_(seed)
  {
  }

  std::size_t below(std::size_t end) { return random_() % end; }
  /// From -1 to 1.
  double any() { return std::ldexp(double(random_() >> 11), -52) - 1.0; }
  double moved(double value, std::size_t most)
  {
    const double to = below(2) == 0 ? -1e300 : 1e300;
    for (std::size_t steps = below(most + 1); steps > 0; --steps)
    {
      value = std::nextafter(value, to);
    }
    return value;
  }

  std::vector<Point> uniform()
  {
    std::vector<Point> result(3 + below(10));
    for (Point& p : result)
    {
      p = { any(), any() };
    }
    return result;
  }

  /// Crowds 1e-12 wide, some at the origin.
  std::vector<Point> clusters()
  {
    const double place = below(2) == 0 ? 0.0 : 100.0;
    std::vector<Point> result;
    for (std::size_t cluster = 0; cluster < 3; ++cluster)
    {
      const Point at{ place * any() * 10.0, place * any() * 10.0 };
      for (std::size_t i = 0; i < 2 + below(3); ++i)
      {
        result.push_back({ at.x + 1e-12 * any(), at.y + 1e-12 * any() });
      }
    }
    result.push_back({ 1000.0 * any(), 1000.0 * any() });
    return result;
  }

  /// Decimals, some of them up to four units in the last place away: often two nearly at one place.
  std::vector<Point> pairs()
  {
    const double bases[] = { 0.0, 10.0, 431234.0, -3.0 };
    const double base = bases[below(4)];
    const auto draw = [&] { return moved(base + 0.1 * double(1 + below(5)), below(2) * 4); };
    std::vector<Point> result(4 + below(3));
    for (Point& p : result)
    {
      p = { draw(), draw() };
    }
    const Point& first = result[0];
    result.push_back({ moved(first.x, 4), moved(first.y, 4) });
    return result;
  }

  /// Some points of a lattice, each line of which is where the step has been added again and again,
  /// or where it should be: often two lines a few units apart.
  std::vector<Point> lattice()
  {
    const double steps[] = { 0.1, 1.0 / 3.0, 0.7 }, starts[] = { 0.1, 10.1, 431234.1 };
    const double step = steps[below(3)], start = starts[below(3)];
    std::vector<double> lines{ start };
    for (int i = 1; i < 5; ++i)
    {
      lines.push_back(lines[lines.size() - 1] + step);
    }
    for (int i = 1; i < 5; ++i)
    {
      lines.push_back(start + i * step);
    }
    std::vector<Point> result(5 + below(2));
    for (Point& p : result)
    {
      p = { lines[below(lines.size())], lines[below(lines.size())] };
    }
    return result;
  }

  /// Few exponents, from one end of the range to the other, and few mantissas.
  std::vector<Point> extremes()
  {
    const int exponents[] = { -1074, -1022, -600, -60, 0, 1, 60, 500, 1000, 1023 };
    std::vector<Point> result(3 + below(4));
    const auto draw = [&]
    {
      const double mantissa = below(2) == 0 ? any() : double(below(3)) - 1.0;
      return moved(std::ldexp(mantissa, exponents[below(10)]), 1);
    };
    for (Point& p : result)
    {
      p = { draw(), draw() };
    }
    return result;
  }

private:
  std::mt19937_64 random_;
};

std::string textOf(const std::vector<Point>& points)
{
  std::string result;
  for (const Point& p : points)
  {
    result += " " + hexText(p);
  }
  return result;
}

std::string faultsOf(const std::vector<Point>& points, VoronoiClip clip)
{
  Engine engine;
  VoronoiCells cells;
  if (engine.run(viewOf(points)) != Status::Ok ||
    voronoiCells(engine.made, clip, cells, {}) != Status::Ok)
  {
    return "no cells";
  }
  return faultsOfCells(viewOf(points), clip, cells);
}

std::string faultsIn(const std::vector<Point>& points, const std::vector<Point>& corners)
{
  const ConvexPolygon polygon(corners);
  Engine engine;
  VoronoiCells cells;
  if (polygon.fault() != PolygonFault::None || engine.run(viewOf(points)) != Status::Ok ||
    voronoiCells(engine.made, polygon, cells, {}) != Status::Ok)
  {
    return "no cells";
  }
  const auto inserted = engine.made.report().inserted;
  return cells.sites.size() != inserted ? "not a cell for each vertex"
                                        : faultsOfCells(viewOf(points), corners, cells);
}

/// Their convex hull, counterclockwise, without corners on straight sides; without an area, none.
std::vector<Point> hullOf(std::vector<Point> points)
{
  std::sort(points.begin(), points.end(), lexicographicallyLess);
  std::vector<Point> hull;
  for (int half = 0; half < 2; ++half)
  {
    const std::size_t begin = hull.size();
    for (const Point& p : points)
    {
      while (hull.size() > begin + 1 && orientSign(hull[hull.size() - 2], hull.back(), p) <= 0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull.size() < 3 ? std::vector<Point>() : hull;
}

/// A polygon around some of the vertices, middles of two, and others with the x of one and the y of
/// another: its sides are often edges of the diagram, and its corners centres.
std::vector<Point> polygonNear(const std::vector<Point>& points, Sets& sets)
{
  const auto any = [&] { return points[sets.below(points.size())]; };
  std::vector<Point> corners;
  for (std::size_t count = 3 + sets.below(5); count > 0; --count)
  {
    const Point p = any(), q = any();
    const std::size_t kind = sets.below(4);
    corners.push_back(kind == 0 ? p
        : kind == 1             ? Point{ p.x, q.y }
        : kind == 2             ? Point{ 0.5 * p.x + 0.5 * q.x, 0.5 * p.y + 0.5 * q.y }
                                : Point{ 1.5 * p.x - 0.5 * q.x, 1.5 * p.y - 0.5 * q.y });
  }
  corners.erase(
    std::remove_if(corners.begin(), corners.end(), [](const Point& p) { return !isFinite(p); }),
    corners.end());
  return hullOf(corners);
}

void expectRight(const std::vector<Point>& points, std::uint64_t seed = 1)
{
  for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
  {
    EXPECT_EQ(faultsOf(points, clip), "") << "clip " << int(clip) << ":" << textOf(points);
  }
  Sets sets(seed);
  const std::vector<Point> polygon = polygonNear(points, sets);
  if (!polygon.empty())
  {
    EXPECT_EQ(faultsIn(points, polygon), "") << textOf(points) << " in" << textOf(polygon);
  }
}

/// All cells of so many sets, clipped in any way.
template <typename Draw>
void expectAllRight(std::size_t count, Draw draw)
{
  for (std::uint64_t seed = 1; seed <= reduced(count); ++seed)
  {
    Sets sets(seed);
    expectRight(draw(sets), seed);
  }
}

TEST(VoronoiCorners, OfUniformPoints)
{
  expectAllRight(100, [](Sets& sets) { return sets.uniform(); });
}

TEST(VoronoiCorners, OfTinyClusters)
{
  expectAllRight(300, [](Sets& sets) { return sets.clusters(); });
}

TEST(VoronoiCorners, OfPairsAFewUnitsApart)
{
  expectAllRight(1500, [](Sets& sets) { return sets.pairs(); });
}

TEST(VoronoiCorners, OfLatticesByRepeatedAddition)
{
  expectAllRight(2500, [](Sets& sets) { return sets.lattice(); });
}

TEST(VoronoiCorners, AtTheEndsOfTheRange)
{
  expectAllRight(120, [](Sets& sets) { return sets.extremes(); });
}

/// Collinear vertices, two and one have cells in a polygon.
TEST(VoronoiCorners, OfLinesAndSinglePoints)
{
  expectAllRight(300,
    [](Sets& sets)
    {
      const Point start{ double(sets.below(5)), double(sets.below(5)) };
      const double x = double(sets.below(3)), y = double(sets.below(3));
      std::vector<Point> result(1 + sets.below(4), start);
      for (Point& p : result)
      {
        const double along = double(sets.below(6));
        p = { start.x + along * x, start.y + along * y };
      }
      return result;
    });
  const std::vector<Point> triangle = { { 0, 0 }, { 6, 0 }, { 0, 6 } };
  for (const std::vector<Point>& points : { std::vector<Point>{ { 1, 1 } }, { { 9, 9 } },
         { { 1, 1 }, { 2, 2 } }, { { 7, 7 }, { 8, 8 } }, { { 1, 1 }, { 5, 5 }, { 9, 9 } },
         { { 2, 2 }, { 2, 2 } }, { { -1, 1 }, { 1, 1 } }, { { 0, 6 }, { 0, -6 } } })
  {
    EXPECT_EQ(faultsIn(points, triangle), "") << textOf(points);
  }
}

/// Whatever lies in small whole numbers: edges along sides and through corners, centres on both.
TEST(VoronoiCorners, OfSmallLattices)
{
  expectAllRight(600,
    [](Sets& sets)
    {
      std::vector<Point> result(1 + sets.below(9));
      for (Point& p : result)
      {
        p = { double(sets.below(5)), double(sets.below(5)) };
      }
      return result;
    });
}

/// Found in users' data: cells that reached along the border up to the far corner.
TEST(VoronoiCorners, NoSpikeAlongTheBorder)
{
  expectRight({ { 10.499999999999998, 10.2 }, { 10.499999999999998, 10.4 },
    { 10.4, 10.299999999999999 }, { 10.5, 10.2 }, { 10.1, 10.4 } });
  expectRight({ { 431234.5, 431234.4999999999 }, { 431234.39999999997, 431234.39999999997 },
    { 431234.5, 431234.5 }, { 431234.29999999993, 431234.4999999999 },
    { 431234.1, 431234.4999999999 } });
}

} // namespace
} // namespace ahd::test
