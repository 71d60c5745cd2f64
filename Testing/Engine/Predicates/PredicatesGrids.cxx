// SPDX-License-Identifier: BSD-3-Clause
//
// Points on a grid, one triangle at a time and two: up to the largest bound below which
// determinants are taken for exact they are, and ties are broken as everywhere, in every order of
// the corners.
#include "Predicates/FilterPairs.h"

#include "ExactSigns.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ahd::test
{
namespace
{

using Quadruple = std::array<Point, 4>;

#ifdef AHD_REDUCED_TESTS
constexpr int kCases = 100;
#else
constexpr int kCases = 1000;
#endif

constexpr double kGuard = 0x1p-1000; // less than a kernel has: the bounds are lower

/// Draws four points of a kind; their coordinates are integers.
class GridCases
{
public:
  enum class Kind
  {
    Near,         ///< of a small square
    OnCircle,     ///< of a circle, the larger ones with bounds beyond the limit
    BesideCircle, ///< the same, one of them moved by a unit
    NearTie,      ///< far from each other, and the determinant is hardly more than 0
    Rectangle,    ///< the corners of a long one
    Needle        ///< the last 2^25 units away from the others, which are neighbours
  };

  explicit GridCases(Kind kind)
    : kind_(kind)
  {
  }

  /// Four places.
  Quadruple draw()
  {
    Quadruple q;
    bool areFour = false;
    while (!areFour)
    {
      q = drawAny();
      areFour = true;
      for (std::size_t i = 1; i < 4; ++i)
      {
        areFour = areFour && std::find(&q[0], &q[i], q[i]) == &q[i];
      }
    }
    return q;
  }

private:
  double whole(int low, int high)
  {
    return double(low + int(random_() % std::uint64_t(high - low + 1)));
  }

  Quadruple drawAny()
  {
    switch (kind_)
    {
      case Kind::Near:
        return { near(3), near(3), near(3), near(3) };
      case Kind::Rectangle:
        return rectangle();
      case Kind::Needle:
        return needle();
      case Kind::NearTie:
        return nearTie();
      default:
        return onCircle();
    }
  }

  Point near(int width) { return { whole(0, width), whole(0, width) }; }

  /// x^2 + y^2 = 5 13 17 29 37, times the square of a factor.
  Quadruple onCircle()
  {
    static const std::vector<Point> all = pointsOfCircle(1185665);
    const double factor = whole(3, 7);
    Quadruple q;
    for (Point& p : q)
    {
      const Point& some = all[std::size_t(random_() % all.size())];
      p = { factor * some.x, factor * some.y };
    }
    if (kind_ == Kind::BesideCircle)
    {
      (random_() % 2 != 0 ? q[0].x : q[0].y) += random_() % 2 != 0 ? 1.0 : -1.0;
    }
    return q;
  }

  static std::vector<Point> pointsOfCircle(int squared)
  {
    std::vector<Point> all;
    const int radius = int(std::sqrt(double(squared)));
    for (int x = -radius; x <= radius; ++x)
    {
      const int y = int(std::lround(std::sqrt(double(squared - x * x))));
      if (x * x + y * y == squared)
      {
        all.push_back({ double(x), double(y) });
        all.push_back({ double(x), double(-y) });
      }
    }
    return all;
  }

  Quadruple rectangle()
  {
    const double width = whole(1, 3), length = whole(9000, 10500);
    const double w = random_() % 2 != 0 ? width : length, h = width + length - w;
    return { Point{ 0, 0 }, { w, 0 }, { w, h }, { 0, h } };
  }

  Quadruple needle()
  {
    const double far = 0x1p25 - whole(2, 9);
    const double side = random_() % 2 != 0 ? far : -far;
    const Point tip = random_() % 2 != 0 ? Point{ side, whole(-2, 2) }
                                         : Point{ whole(-2, 2), side };
    return { near(2), near(2), near(2), tip };
  }

  /// (0, 0), (1, 0), (m, n) and a place so near to their circle that the determinant is below 500.
  Quadruple nearTie()
  {
    for (;;)
    {
      const double m = whole(3000, 7000), n = whole(10, 60), y = whole(0, int(n));
      const double over = n * y * y - y * (m * m + n * n - m); // n (x - x^2) - over is 0
      const double x = std::round(0.5 - std::sqrt(std::max(0.25 - over / n, 0.0)));
      const double det = n * (x - x * x) - over;
      if (det != 0.0 && std::fabs(det) < 500.0)
      {
        const double mirror = random_() % 2 != 0 ? 1.0 : -1.0;
        return { Point{ 0, 0 }, { mirror, 0 }, { mirror * m, n }, { mirror * x, y } };
      }
    }
  }

  Kind kind_;
  std::mt19937_64 random_{ 7 };
};

struct Tally
{
  int exact = 0;      ///< taken for exact
  int atTheLimit = 0; ///< of these, those with a bound of more than half of the limit
  int ties = 0;       ///< of those, those whose determinant is 0
  int beyond = 0;     ///< not taken for exact, nor certain
};

/// The kernel's data of a grid with this unit.
Exactly exactlyOf(double unit)
{
  return { exactErrorBound(unit), perturbationFor(unit) };
}

/// Is P in conflict with the counterclockwise triangle q0, q1, q2?
void askOne(const Quadruple& q, double unit, Tally& tally)
{
  const Lifted a = liftedFrom(q[3], q[0]), b = liftedFrom(q[3], q[1]), c = liftedFrom(q[3], q[2]);
  const double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  const double det = inCircleDeterminant(a, b, c, ab, bc, ca);
  const double bound = inCircleErrorBound(a.z, b.z, c.z, kGuard);
  const Exactly exactly = exactlyOf(unit);
  if (bound < exactly.below)
  {
    ++tally.exact;
    tally.atTheLimit += bound > 0.5 * exactly.below;
    tally.ties += det == 0.0 && bound > 0.5 * exactly.below;
    ASSERT_EQ(perturbedDeterminant(det, a, b, c, ab, bc, ca, exactly.perturbation) > 0,
      oracleInConflict(q[0], q[1], q[2], q[3]));
  }
  else
  {
    tally.beyond += std::fabs(det) <= bound;
  }
}

/// The same of two triangles at once, across their edges q1 q0 and q2 q1.
void askTwo(const Quadruple& q, double unit)
{
  const VectorPair p{ both(q[3].x), both(q[3].y) };
  const LiftedPair a = liftedFrom(p, q[1], q[2]), b = liftedFrom(p, q[0], q[1]);
  const LiftedPair c = liftedFrom(p, q[2], q[0]);
  const EdgePair edges{ a, b, cross(a, b) };
  const Exactly exactly = exactlyOf(unit);
  const InCirclePair seen = perturbedInCircle(edges, c, both(kGuard), exactly);
  const Pair bound = inCircleErrorBound(edges, c, both(kGuard));
  const double bounds[2] = { low(bound), high(bound) };
  for (unsigned i = 0; i < 2; ++i)
  {
    const bool isCertain = (seen.certain >> i & 1) != 0;
    ASSERT_TRUE(isCertain || bounds[i] >= exactly.below);
    if (isCertain)
    {
      ASSERT_EQ((seen.inside >> i & 1) != 0, oracleInConflict(q[0], q[1], q[2], q[3]));
    }
  }
}

/// Each of the four as P, the other three from each of their corners on.
void askInEveryOrder(const Quadruple& points, double unit, Tally& tally)
{
  for (std::size_t k = 0; k < 12; ++k)
  {
    const std::size_t p = k / 3;
    std::array<std::size_t, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
    {
      corner[i] = (p + 1 + (k + i) % 3) % 4;
    }
    const int side = oracleOrient2d(points[corner[0]], points[corner[1]], points[corner[2]]);
    if (side == 0)
    {
      continue; // no triangle
    }
    const Quadruple q = { points[corner[0]], points[corner[side > 0 ? 1 : 2]],
      points[corner[side > 0 ? 2 : 1]], points[p] };
    askOne(q, unit, tally);
    askTwo(q, unit);
    ASSERT_FALSE(testing::Test::HasFatalFailure())
      << hexText(q[0]) << hexText(q[1]) << hexText(q[2]) << hexText(q[3]);
  }
}

Tally askAll(GridCases::Kind kind, double unit)
{
  GridCases source(kind);
  Tally tally;
  for (int i = 0; i < kCases && !testing::Test::HasFatalFailure(); ++i)
  {
    Quadruple q = source.draw();
    for (Point& p : q)
    {
      p = { unit * p.x, unit * p.y };
    }
    askInEveryOrder(q, unit, tally);
  }
  return tally;
}

/// From the finest unit that there may be to the coarsest (Frame.cxx).
const double kUnits[] = { 0x1p-151, 0x1p-60, 0.25, 1.0, 8.0, 0x1p75 };

TEST(PredicatesGrids, NeighboursAreAllExact)
{
  for (const double unit : kUnits)
  {
    const Tally tally = askAll(GridCases::Kind::Near, unit);
    EXPECT_GT(tally.exact, 10 * kCases);
    EXPECT_EQ(tally.beyond, 0) << unit;
  }
}

TEST(PredicatesGrids, TiesAreBrokenUpToTheLimit)
{
  for (const double unit : kUnits)
  {
    for (const GridCases::Kind kind : { GridCases::Kind::OnCircle, GridCases::Kind::Rectangle })
    {
      const Tally tally = askAll(kind, unit);
      EXPECT_GT(tally.ties, kCases / 10) << unit;
      EXPECT_EQ(tally.ties, tally.atTheLimit) << unit;
      EXPECT_GT(tally.beyond, kCases / 10) << unit;
    }
  }
}

TEST(PredicatesGrids, WhatIsNoTieIsNotPerturbed)
{
  for (const double unit : kUnits)
  {
    const Tally beside = askAll(GridCases::Kind::BesideCircle, unit);
    EXPECT_GT(beside.atTheLimit, kCases / 10) << unit;
    EXPECT_LT(beside.ties, kCases / 100) << unit;
    const Tally nearTies = askAll(GridCases::Kind::NearTie, unit);
    EXPECT_GT(nearTies.exact, 10 * kCases) << unit;
    const Tally needles = askAll(GridCases::Kind::Needle, unit);
    EXPECT_GT(needles.atTheLimit, kCases / 10) << unit;
  }
}

} // namespace
} // namespace ahd::test
