// SPDX-License-Identifier: BSD-3-Clause
//
// The second filters: never wrong, and they decide nearly all slivers that the first leave open.
#include "Predicates/TighterFilterPairs.h"
#include "Predicates/TighterFilters.h"

#include "ExactSigns.h"
#include "PredicatesCases.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ahd::test
{
namespace
{

#ifdef AHD_REDUCED_TESTS
constexpr int kCases = 2000;
#else
constexpr int kCases = 20000;
#endif

struct Answers
{
  int asked = 0;
  int byFirst = 0; ///< by the filter of Filters.h
  int byLengths = 0;
  int bySharpCrosses = 0;
  int orientations = 0;
  int bySharpPairs = 0; ///< decided by sharp crosses

  int open() const { return asked - byFirst; }
};

/// Tests the filter for two triangles at once on q's first three points, from the k-th on, and
/// the next three. @pre the guard is enough for them.
InCirclePair askPair(const Quadruple& q, std::size_t k, double guard)
{
  const Point &a = q[k], &c = q[(k + 1) % 3], &b = q[(k + 2) % 3];
  const InCirclePair seen = inCircleBySharpCrosses(q[3], { a, c, b, b, a }, guard);
  if (seen.certain != 0)
  {
    const int inside = oracleInCircle(c, a, b, q[3]) > 0 ? 3 : 0; // b, c, a is in the same order
    const unsigned wrong = (seen.inside ^ static_cast<unsigned>(inside)) & seen.certain;
    EXPECT_EQ(wrong, 0u) << "pair: " << hexText(a) << hexText(b) << hexText(c) << hexText(q[3]);
    EXPECT_NE(oracleInCircle(c, a, b, q[3]), 0);
  }
  return seen;
}

/// Tests all filters on q in each cyclic order of its first three points.
void ask(const Quadruple& q, Answers& answers)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point &a = q[k], &b = q[(k + 1) % 3], &c = q[(k + 2) % 3], &p = q[3];
    const std::string text = hexText(a) + hexText(b) + hexText(c) + hexText(p);
    const Lifted A = liftedFrom(p, a), B = liftedFrom(p, b), C = liftedFrom(p, c);
    const double guard = inCircleGuard(4 * (A.z + B.z + C.z));
    const bool first = inCircleIsCertain(
      inCircleDeterminant(A, B, C, cross(A, B)), A.z, B.z, C.z, guard);
    ++answers.asked;
    answers.byFirst += first ? 1 : 0;
    const auto byLengths = inCircleByLengths(a, b, c, p);
    const auto sharp = inCircleBySharpCrosses(a, b, c, p);
    if (byLengths || sharp)
    {
      const int sign = oracleInCircle(a, b, c, p);
      ASSERT_EQ(byLengths.value_or(sign), sign) << "by lengths: " << text;
      ASSERT_EQ(sharp.value_or(sign), sign) << "by sharp crosses: " << text;
    }
    const InCirclePair pair = askPair(q, k, guard);
    ASSERT_FALSE(testing::Test::HasFailure());
    answers.bySharpPairs += sharp && pair.certain == 3 ? 1 : 0;
    answers.byLengths += !first && byLengths ? 1 : 0;
    answers.bySharpCrosses += !first && !byLengths && sharp ? 1 : 0;
    if (const auto side = orient2dBySharpCross(a, b, p))
    {
      ASSERT_EQ(*side, oracleOrient2d(a, b, p)) << "orientation: " << text;
      ++answers.orientations;
    }
  }
}

TEST(PredicatesTighter, WhatIsDecidedIsRight)
{
  for (const Family family : { Family::AnyExponents, Family::AnyBits, Family::Extremes,
         Family::TinyAndHuge, Family::Subnormals, Family::WideExponents, Family::Uniform,
         Family::UlpsApart, Family::Lattice, Family::ShiftedLattice, Family::DecimalLattice,
         Family::MapLattice, Family::SinglePrecision, Family::NearlyCollinear,
         Family::NearlyCircular, Family::FarCircular })
  {
    SCOPED_TRACE(nameOf(family));
    Cases source(family);
    Answers answers;
    for (int i = 0; i < (family <= Family::TinyAndHuge ? kCases / 10 : kCases); ++i)
    {
      ask(source.draw(), answers);
      ASSERT_FALSE(HasFatalFailure());
    }
  }
}

/// On the way down everything underflows in turn, on the way up it overflows.
TEST(PredicatesTighter, WhatIsDecidedIsRightAtEveryScale)
{
  for (const Family family : { Family::Uniform, Family::NearlyCollinear, Family::NearlyCircular })
  {
    SCOPED_TRACE(nameOf(family));
    Cases source(family);
    Answers answers;
    for (int exponent = -1074; exponent <= 1000; ++exponent)
    {
      Quadruple q = source.draw();
      for (Point& p : q)
      {
        p = { std::ldexp(p.x, exponent), std::ldexp(p.y, exponent) };
      }
      ask(q, answers);
      ASSERT_FALSE(HasFatalFailure()) << "scale 2^" << exponent;
    }
  }
}

/// Each point at a scale of its own: products of the near ones underflow, and are multiplied by the
/// far one.
TEST(PredicatesTighter, WhatIsDecidedIsRightWhereScalesDiffer)
{
  Cases source(Family::Uniform);
  Answers answers;
  for (int i = 0; i < kCases; ++i)
  {
    Quadruple q = source.draw();
    const int middle = 60 - static_cast<int>(source.below(120));
    for (Point& p : q)
    {
      const int exponent = middle + 60 - static_cast<int>(source.below(120));
      p = { std::ldexp(p.x - 0.5, exponent), std::ldexp(p.y - 0.5, exponent) };
    }
    ask(q, answers);
    ASSERT_FALSE(HasFatalFailure()) << "case " << i;
  }
  EXPECT_GT(answers.byLengths, 0);
}

/// A so near to P that its squared length underflows, on the tangent of the circle of P, b and c.
TEST(PredicatesTighter, UnderflowIsNotTakenForCertainty)
{
  Cases source(Family::Lattice);
  const auto digit = [&] { return double(source.below(std::uint64_t(1) << 53)) - 0x1p52; };
  Answers answers;
  for (int i = 0; i < kCases; ++i)
  {
    const Point b{ digit(), digit() }, c{ digit(), digit() };
    const double lb = squaredLength(b.x, b.y), lc = squaredLength(c.x, c.y);
    const int exponent = -700 - static_cast<int>(source.below(100));
    const Point a{ std::ldexp(lb * c.x - lc * b.x, exponent),
      std::ldexp(lb * c.y - lc * b.y, exponent) };
    ask({ a, b, c, { 0, 0 } }, answers);
    ASSERT_FALSE(HasFatalFailure()) << "case " << i;
  }
}

/// P, b and c near each other, a on their circle on the other side: rounded as P sees it.
TEST(PredicatesTighter, WhatIsSeenRoundedIsNotTakenForExact)
{
  Cases source(Family::Lattice);
  const auto onCircle = [&](double angle) {
    return Point{ 1.0 / 3 + std::cos(angle), 1.0 / 7 + std::sin(angle) };
  };
  const auto unit = [&] { return double(source.below(std::uint64_t(1) << 53)) * 0x1p-53; };
  Answers answers;
  for (int i = 0; i < kCases; ++i)
  {
    const double angle = 6.28 * unit();
    ask({ onCircle(angle + 2 + 2 * unit()), onCircle(angle + 0.01), onCircle(angle + 0.02),
          onCircle(angle) },
      answers);
    ASSERT_FALSE(HasFatalFailure()) << "case " << i;
  }
}

#if defined(__FMA__)
/// Of two triangles at once, each with the point that is not seen exactly in each place: only the
/// one that has it is left open.
TEST(PredicatesTighter, OfAPairOnlyWhatIsRoundedIsLeftOpen)
{
  const Point p{ 0x1p-70, 0 }, a{ 0x1p-70, 1 }, b{ 0x1p-69, -1 }, c{ 0, 0x1p-60 };
  const Point f{ 0x1p-68, 3 }, g{ 0x1p-65, 5 };
  const Point rounded{ 1, 0x1p-20 };
  const double guard = inCircleGuard(1000);
  EXPECT_EQ(inCircleBySharpCrosses(p, { a, c, b, f, g }, guard).certain, 3u);
  EXPECT_EQ(inCircleBySharpCrosses(p, { rounded, c, b, f, g }, guard).certain, 2u);
  EXPECT_EQ(inCircleBySharpCrosses(p, { a, rounded, b, f, g }, guard).certain, 0u);
  EXPECT_EQ(inCircleBySharpCrosses(p, { a, c, rounded, f, g }, guard).certain, 1u);
  EXPECT_EQ(inCircleBySharpCrosses(p, { a, c, b, rounded, g }, guard).certain, 2u);
  EXPECT_EQ(inCircleBySharpCrosses(p, { a, c, b, f, rounded }, guard).certain, 1u);
}
#endif

/// Places between -1 and 1, sorted, each once.
std::vector<double> places(Cases& source)
{
  std::vector<double> x(100000);
  for (double& place : x)
  {
    place = double(source.below(std::uint64_t(1) << 53)) * 0x1p-52 - 1.0;
  }
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  return x;
}

/// Two neighbours on one side of y = x^2 and two on the other, near the circle of the first three.
TEST(PredicatesTighter, PointsOfAParabolaAreDecidedByLengths)
{
  Cases source(Family::Lattice);
  const std::vector<double> x = places(source);
  const auto at = [&](std::size_t i) { return Point{ x[i], x[i] * x[i] }; };
  Answers answers;
  for (int i = 0; i < kCases; ++i)
  {
    const std::size_t k = 1000 + source.below(x.size() / 2 - 2000);
    const auto mirrored = std::lower_bound(x.begin(), x.end(), -x[k]);
    const auto m = static_cast<std::size_t>(mirrored - x.begin());
    ask({ at(k), at(k + 1), at(m), at(m + 1) }, answers);
    ASSERT_FALSE(HasFatalFailure()) << "case " << i;
  }
  EXPECT_GT(answers.open(), answers.asked / 10);
  EXPECT_GT(answers.byLengths, answers.open() * 9 / 10);
}

#if defined(__FMA__)
/// Points of y = x / 3, rounded: most lie on three lines, a third of a unit in the last place
/// apart.
TEST(PredicatesTighter, NearlyCollinearPointsAreDecidedBySharpCrosses)
{
  Cases source(Family::Lattice);
  const std::vector<double> x = places(source);
  const auto at = [&](std::size_t i) { return Point{ (3 + x[i]) / 4, (3 + x[i]) / 4 / 3 }; };
  const auto isTie = [](const Quadruple& q) { return oracleInCircle(q[0], q[1], q[2], q[3]) == 0; };
  Answers answers;
  for (int i = 0; i < kCases; ++i)
  {
    const std::size_t k = source.below(x.size() - 3), far = source.below(x.size());
    const Quadruple q = { at(k), at(k + 2), at(far), at(k + 1) };
    if ((far < k || far > k + 2) && !isTie(q))
    {
      ask(q, answers);
      ASSERT_FALSE(HasFatalFailure()) << "case " << i;
    }
  }
  EXPECT_GT(answers.open(), answers.asked / 20);
  EXPECT_GT(answers.byLengths + answers.bySharpCrosses, answers.open() * 9 / 10);
  EXPECT_GT(answers.bySharpCrosses, answers.open() / 2);
  EXPECT_GT(answers.bySharpPairs, answers.asked * 9 / 10);
  EXPECT_GT(answers.orientations, answers.asked * 9 / 10);
}
#else
TEST(PredicatesTighter, WithoutFusedMultiplyAddsSharpCrossesAreNotUsed)
{
  EXPECT_FALSE(inCircleBySharpCrosses({ 0, 0 }, { 1, 0 }, { 0, 1 }, { 0.5, 0.5 }));
  EXPECT_FALSE(orient2dBySharpCross({ 0, 0 }, { 1, 0 }, { 0.5, 0.5 }));
  const Point p{ 0, 0 }, a{ 1, 0 }, b{ 0, 1 }, c{ 1, 2 };
  EXPECT_EQ(inCircleBySharpCrosses(p, { a, c, b, b, a }, inCircleGuard(20)).certain, 0u);
}
#endif

} // namespace
} // namespace ahd::test
