// SPDX-License-Identifier: BSD-3-Clause
//
// The frame of an insertion: scales are exact or not taken, the ghost is where the filter decides
// for it, units are found, and all changes are undone.
#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"

#include "Insert/Frame.h"
#include "Order/Rank.h"
#include "Predicates/Filters.h"
#include "Predicates/Predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace ahd::test
{
namespace
{

/// Points as ranking leaves them.
struct Ranked
{
  explicit Ranked(const std::vector<Point>& points, Executor* executor = nullptr)
    : ticker(nullptr, Phase::Insert, points.size(), executor)
  {
    EXPECT_EQ(readPoints(viewOf(points), ticker, ranked), Status::Ok);
    EXPECT_EQ(rankPoints(viewOf(points), ticker, ranked), Status::Ok);
  }

  const Point& ghost() { return ranked.xy[ranked.count]; }

  RankedPoints ranked;
  Ticker ticker;
};

std::vector<Point> uniformTimes(double x, double y, std::size_t n = 20000)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, n, 3);
  for (Point& p : points)
  {
    p = { p.x * x, p.y * y };
  }
  return points;
}

std::vector<Point> latticeOf(double pitch, double origin)
{
  std::vector<Point> points;
  for (int i = 0; i < 20000; ++i)
  {
    points.push_back({ origin + pitch * (i % 150), origin + pitch * (i / 150) });
  }
  return points;
}

TEST(Frame, PutsBackEveryBit)
{
  BackwardExecutor threads(3);
  for (const double scale : { 1.0, 1e-310, 1e-300, 1e-150, 1e100, 1e307 })
  {
    Ranked made(uniformTimes(scale, scale), &threads);
    const std::vector<Point> before(
      made.ranked.xy.data(), made.ranked.xy.data() + made.ranked.count);
    Framing framing(made.ranked);
    ASSERT_TRUE(framing.begin(made.ticker));
    EXPECT_EQ(scale == 1.0,
      std::memcmp(before.data(), made.ranked.xy.data(), before.size() * sizeof(Point)) == 0);
    EXPECT_TRUE(std::isfinite(made.ghost().y)) << scale;
    ASSERT_TRUE(framing.end(made.ticker));
    EXPECT_EQ(std::memcmp(before.data(), made.ranked.xy.data(), before.size() * sizeof(Point)), 0)
      << scale;
    EXPECT_TRUE(std::isnan(made.ghost().x) && std::isnan(made.ghost().y)) << scale;
  }
}

/// Framed coordinates are the original ones times a power of two, the same for all.
TEST(Frame, ScalesByOnePowerOfTwo)
{
  for (const double scale : { 1e-300, 1e-150, 1e100, 1e307 })
  {
    Ranked made(uniformTimes(scale, scale));
    const Point before = made.ranked.xy[17], other = made.ranked.xy[4711];
    Framing framing(made.ranked);
    ASSERT_TRUE(framing.begin(made.ticker));
    const double ratio = made.ranked.xy[17].x / before.x;
    int exponent;
    EXPECT_EQ(std::frexp(ratio, &exponent), 0.5) << scale;
    EXPECT_EQ(made.ranked.xy[4711].y, other.y * ratio) << scale;
    EXPECT_LT(std::fabs(made.ranked.xy[17].x), std::ldexp(1.0, kFrameExponent)) << scale;
    EXPECT_GT(std::fabs(made.ranked.xy[17].x), std::ldexp(1.0, -kFrameExponent - 30)) << scale;
  }
}

/// One coordinate that would lose bits is enough: then all stay unchanged.
TEST(Frame, TakesNoScaleThatIsNotExact)
{
  std::vector<Point> points = uniformTimes(1e300, 1e300);
  points[12345].y = 0x1.23456789abcdfp-40;
  Ranked made(points);
  const std::vector<Point> before(made.ranked.xy.data(), made.ranked.xy.data() + made.ranked.count);
  Framing framing(made.ranked);
  ASSERT_TRUE(framing.begin(made.ticker));
  EXPECT_EQ(std::memcmp(before.data(), made.ranked.xy.data(), before.size() * sizeof(Point)), 0);
  EXPECT_TRUE(std::isnan(made.ghost().y));
  EXPECT_FALSE(framing.frame().isOnGrid());
  EXPECT_TRUE(std::isinf(framing.frame().squaredGuard)); // as squares may overflow
  ASSERT_TRUE(framing.end(made.ticker));
  EXPECT_EQ(std::memcmp(before.data(), made.ranked.xy.data(), before.size() * sizeof(Point)), 0);
}

TEST(Frame, FindsTheUnit)
{
  for (const double pitch : { 1.0, 0.25, 0x1p-70, 0x1p80, 0x1p-400, 0x1p500, 3.0 })
  {
    for (const double origin : { 0.0, -75.0, 400000.0 })
    {
      Ranked made(latticeOf(pitch, origin * pitch));
      Framing framing(made.ranked);
      const double before = made.ranked.xy[3].x;
      ASSERT_TRUE(framing.begin(made.ticker));
      const double scale = before == 0.0 ? 0.0 : made.ranked.xy[3].x / before;
      EXPECT_TRUE(framing.frame().isOnGrid()) << pitch << ", " << origin;
      if (scale != 0.0)
      {
        const double unit = scale * (pitch == 3.0 ? 1.0 : pitch);
        EXPECT_EQ(framing.frame().exactBelow, exactErrorBound(unit)) << pitch << ", " << origin;
      }
    }
  }
}

TEST(Frame, FindsNoUnitThatIsTooFine)
{
  EXPECT_FALSE(
    []
    {
      Ranked made(uniformTimes(1.0, 1.0));
      Framing framing(made.ranked);
      EXPECT_TRUE(framing.begin(made.ticker));
      return framing.frame().isOnGrid();
    }());
  // One coordinate off the grid, by bits that the others' unit has not, or by more than 51.
  for (const double off : { 0x1p-30, 0x1p-60 })
  {
    std::vector<Point> points = latticeOf(1.0, 0.0);
    points[19999].x = off;
    Ranked made(points);
    Framing framing(made.ranked);
    ASSERT_TRUE(framing.begin(made.ticker));
    EXPECT_FALSE(framing.frame().isOnGrid()) << off;
  }
}

/// For the ghost in its place the filter gives the orientation, or no answer.
TEST(Frame, TheFilterAnswersForTheGhost)
{
  Random random(5);
  for (int exponent = -kFrameExponent; exponent <= kFrameExponent; exponent += 10)
  {
    const Point ghost{ 0.0, std::ldexp(kGhostDistance, exponent) };
    const double guard = inCircleGuard(2 * ghost.y * ghost.y);
    int certain = 0;
    for (int i = 0; i < 2000; ++i)
    {
      Point q[3];
      for (Point& p : q)
      {
        p = { std::ldexp(2 * random.unit() - 1, exponent),
          std::ldexp(2 * random.unit() - 1, exponent) };
      }
      if (i % 2 == 1) // nearly on one line
      {
        q[2] = { 0.5 * (q[0].x + q[1].x), 0.5 * (q[0].y + q[1].y) };
      }
      const Lifted a = liftedFrom(q[2], q[0]), b = liftedFrom(q[2], q[1]);
      const Lifted g = liftedFrom(q[2], ghost);
      const double det = inCircleDeterminant(a, b, g, cross(a, b));
      if (inCircleIsCertain(det, a.z, b.z, g.z, guard))
      {
        ++certain;
        ASSERT_EQ(det > 0 ? 1 : -1, orient2d(q[0], q[1], q[2])) << exponent;
      }
    }
    EXPECT_GE(certain, 990) << exponent;
    EXPECT_LT(certain, 2000) << exponent;
  }
}

/// Integers around each other: exact determinants, ties included, in every order of the corners.
TEST(Frame, PerturbedDeterminantsAreThoseOfTheTieBreak)
{
  Random random(6);
  for (const double unit : { 1.0, 0.25, 0x1p-90, 0x1p60, 64.0 })
  {
    int ties = 0;
    for (int i = 0; i < 20000; ++i)
    {
      const std::uint64_t width = i % 3 == 0 ? 1000 : 4;
      Point q[4];
      for (Point& p : q)
      {
        p = { unit * double(random.below(width)), unit * double(random.below(width)) };
      }
      if (orient2d(q[0], q[1], q[2]) <= 0 || q[3] == q[0] || q[3] == q[1] || q[3] == q[2])
      {
        continue;
      }
      const Lifted a = liftedFrom(q[3], q[0]), b = liftedFrom(q[3], q[1]),
                   c = liftedFrom(q[3], q[2]);
      const double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
      const double det = inCircleDeterminant(a, b, c, ab, bc, ca);
      ASSERT_LT(inCircleErrorBound(a.z, b.z, c.z, 0.0), exactErrorBound(unit));
      ties += det == 0.0;
      EXPECT_EQ(perturbedDeterminant(det, a, b, c, ab, bc, ca, perturbationFor(unit)) > 0,
        inConflict(q[0], q[1], q[2], q[3]));
    }
    EXPECT_GT(ties, 100) << unit;
  }
}

} // namespace
} // namespace ahd::test
