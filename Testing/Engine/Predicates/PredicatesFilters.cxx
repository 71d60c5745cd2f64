// SPDX-License-Identifier: BSD-3-Clause
//
// The filters the insertion kernel inlines: never certain and wrong, uncertain about the vertex at
// infinity, and certain often enough to be useful.
#include "Predicates/FilterPairs.h"

#include "ExactSigns.h"
#include "PredicatesCases.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <limits>

namespace ahd::test
{
namespace
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

#ifdef AHD_REDUCED_TESTS
constexpr int kCases = 2000;
#else
constexpr int kCases = 20000;
#endif

/// The squared length of the diagonal of all, times 4.
double mostOf(const Quadruple& q)
{
  double low[2] = { q[0].x, q[0].y }, high[2] = { q[0].x, q[0].y };
  for (const Point& p : q)
  {
    low[0] = std::min(low[0], p.x);
    low[1] = std::min(low[1], p.y);
    high[0] = std::max(high[0], p.x);
    high[1] = std::max(high[1], p.y);
  }
  return 4 * squaredLength(high[0] - low[0], high[1] - low[1]);
}

/// The guards a kernel takes for a whole point set.
double guardOf(const Quadruple& q)
{
  return inCircleGuard(mostOf(q));
}

double squaredGuardOf(const Quadruple& q)
{
  bool isInFrame = true;
  for (const Point& p : q)
  {
    isInFrame &= std::max(std::fabs(p.x), std::fabs(p.y)) < std::ldexp(1.0, kFrameExponent);
  }
  return isInFrame ? inCircleSquaredGuard(mostOf(q)) : kInfinity;
}

struct Tally
{
  int certain = 0;
  int asked = 0;
};

/// Tests both filters on q in each cyclic order of its first three points, as a kernel does.
void askFilters(const Quadruple& q, Tally& tally)
{
  const double guard = guardOf(q);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point &p0 = q[k], &p1 = q[(k + 1) % 3], &p2 = q[(k + 2) % 3];
    const Lifted a = liftedFrom(q[3], p0), b = liftedFrom(q[3], p1), c = liftedFrom(q[3], p2);
    const double axb = cross(a, b);
    if (orientIsCertain(axb, a.z, b.z))
    {
      ASSERT_EQ(signOf(axb), oracleOrient2d(q[3], p0, p1))
        << "orientation of " << hexText(q[3]) << hexText(p0) << hexText(p1);
    }
    const double det = inCircleDeterminant(a, b, c, axb);
    ++tally.asked;
    if (inCircleIsCertain(det, a.z, b.z, c.z, guard))
    {
      ++tally.certain;
      ASSERT_EQ(signOf(det), oracleInCircle(p0, p1, p2, q[3]))
        << "in-circle of " << hexText(p0) << hexText(p1) << hexText(p2) << hexText(q[3]);
    }
  }
}

VectorPair twice(const Point& p)
{
  return { both(p.x), both(p.y) };
}

EdgePair edgesFrom(const VectorPair& p, const Point (&from)[2], const Point (&to)[2])
{
  const LiftedPair a = liftedFrom(p, from[0], from[1]), b = liftedFrom(p, to[0], to[1]);
  return { a, b, cross(a, b) };
}

/// Tests the filter of two triangles at once, on each cyclic order of the first three points
/// beside the next.
void askPairs(const Quadruple& q, Tally& tally)
{
  const Pair guard = both(squaredGuardOf(q));
  const VectorPair p = twice(q[3]);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point corners[4] = { q[k], q[(k + 1) % 3], q[(k + 2) % 3], q[k] };
    const EdgePair edges = edgesFrom(p, { corners[0], corners[1] }, { corners[1], corners[2] });
    const InCirclePair seen = inCircle(edges, liftedFrom(p, corners[2], corners[3]), guard);
    for (unsigned i = 0; i < 2; ++i)
    {
      ++tally.asked;
      if ((seen.certain >> i & 1) != 0)
      {
        ++tally.certain;
        const int sign = oracleInCircle(corners[i + 1], corners[i], q[(k + 2 + i) % 3], q[3]);
        ASSERT_EQ((seen.inside >> i & 1) != 0 ? 1 : -1, sign)
          << "in-circle " << i << " of " << hexText(corners[i + 1]) << hexText(corners[i])
          << hexText(q[(k + 2 + i) % 3]) << hexText(q[3]);
      }
    }
  }
}

void askAll(const Quadruple& q, Tally& tally)
{
  askFilters(q, tally);
  askPairs(q, tally);
}

TEST(PredicatesFilters, WhatIsCertainIsRight)
{
  for (const Family family : { Family::AnyExponents, Family::AnyBits, Family::Extremes,
         Family::TinyAndHuge, Family::Subnormals, Family::WideExponents, Family::UlpsApart,
         Family::Lattice, Family::DecimalLattice, Family::MapLattice, Family::SinglePrecision,
         Family::NearlyCollinear, Family::NearlyCircular, Family::FarCircular })
  {
    SCOPED_TRACE(nameOf(family));
    const bool slowOracle = family <= Family::TinyAndHuge;
    Cases source(family);
    Tally tally;
    for (int i = 0; i < (slowOracle ? kCases / 10 : kCases); ++i)
    {
      askAll(source.draw(), tally);
      if (HasFatalFailure())
      {
        return;
      }
    }
  }
}

/// The same shapes at every scale of double: on the way down everything underflows in turn, on the
/// way up it overflows.
TEST(PredicatesFilters, WhatIsCertainIsRightAtEveryScale)
{
  for (const Family family : { Family::Uniform, Family::NearlyCircular, Family::Lattice })
  {
    SCOPED_TRACE(nameOf(family));
    Cases source(family);
    for (int exponent = -1074; exponent <= 1023; exponent += 1)
    {
      Quadruple q = source.draw();
      for (Point& p : q)
      {
        p = { std::ldexp(p.x, exponent), std::ldexp(p.y, exponent) };
      }
      Tally tally;
      if (std::isfinite(q[0].x + q[1].x + q[2].x + q[3].x + q[0].y + q[1].y + q[2].y + q[3].y))
      {
        askAll(q, tally);
      }
      ASSERT_FALSE(HasFatalFailure()) << "scale 2^" << exponent;
    }
  }
}

/// Two of the points so near to P that their cross product underflows, the third so far away that
/// it multiplies what was lost back into the range of normal numbers.
TEST(PredicatesFilters, UnderflowIsNotMagnifiedByAFarPoint)
{
  Cases source(Family::AnyExponents);
  for (int i = 0; i < kCases; ++i)
  {
    const int nearby = -500 - static_cast<int>(source.below(60));
    const int faraway = static_cast<int>(source.below(510));
    const auto digit = [&] { return double(source.below(1 << 20)) - 0x1p19; };
    Quadruple q;
    q[0] = { std::ldexp(digit(), faraway - 20), std::ldexp(digit(), faraway - 20) };
    q[1] = { std::ldexp(digit(), nearby - 20), std::ldexp(digit(), nearby - 20) };
    q[2] = { std::ldexp(q[1].x, 1) + std::ldexp(digit(), nearby - 60),
      std::ldexp(q[1].y, 1) + std::ldexp(digit(), nearby - 60) };
    q[3] = { 0, 0 };
    Tally tally;
    askAll(q, tally);
    ASSERT_FALSE(HasFatalFailure()) << "case " << i << ", 2^" << nearby << " and 2^" << faraway;
  }
}

/// Two of the points so near to P that the squared bound on pairs underflows, but not the square of
/// the determinant, as the third is far away; and the two so nearly in line that rounding decides.
TEST(PredicatesFilters, TheSquaredBoundMayUnderflow)
{
  Cases source(Family::AnyExponents);
  Tally tally;
  for (int i = 0; i < kCases; ++i)
  {
    const int nearby = -320 + static_cast<int>(source.below(70));
    const int faraway = kFrameExponent - 1 - static_cast<int>(source.below(30));
    const auto digits = [&]
    { return 1.0 + 0x1p-52 * double(source.below(std::uint64_t(1) << 52)); };
    const double factor = digits();
    Quadruple q;
    q[0] = { std::ldexp(digits(), faraway - 1), std::ldexp(-digits(), faraway - 1) };
    q[1] = { std::ldexp(digits(), nearby), std::ldexp(digits(), nearby) };
    q[3] = { std::ldexp(-digits(), nearby), std::ldexp(-digits(), nearby) };
    q[2] = { q[3].x + factor * (q[1].x - q[3].x), q[3].y + factor * (q[1].y - q[3].y) };
    askPairs(q, tally);
    ASSERT_FALSE(HasFatalFailure()) << "case " << i << ", 2^" << nearby << " and 2^" << faraway;
  }
}

TEST(PredicatesFilters, ThePointAtInfinityIsUncertain)
{
  const Point p{ 0.25, 0.5 };
  const Lifted ghost = liftedFrom(p, { kNan, kNan });
  const Lifted a = liftedFrom(p, { 0, 0 }), b = liftedFrom(p, { 1, 0 });
  const double guard = inCircleGuard(10.0);
  const Lifted triples[3][3] = { { ghost, a, b }, { a, ghost, b }, { a, b, ghost } };
  for (const auto& t : triples)
  {
    const double det = inCircleDeterminant(t[0], t[1], t[2], cross(t[0], t[1]));
    EXPECT_FALSE(inCircleIsCertain(det, t[0].z, t[1].z, t[2].z, guard));
  }
  EXPECT_FALSE(orientIsCertain(cross(ghost, a), ghost.z, a.z));
  EXPECT_FALSE(orientIsCertain(cross(a, ghost), a.z, ghost.z));
}

/// Of two triangles at once, the other one remains certain.
TEST(PredicatesFilters, OfAPairOnlyThePointAtInfinityIsUncertain)
{
  const Point ghost{ kNan, kNan }, a{ 0, 0 }, b{ 1, 0 }, c{ 0.5, -2 };
  const VectorPair p = twice({ 0.25, 0.5 });
  const Pair guard = both(inCircleSquaredGuard(10.0));
  const Point triples[3][3] = { { ghost, b, c }, { a, ghost, c }, { a, b, ghost } };
  for (const auto& t : triples)
  {
    const EdgePair first = edgesFrom(p, { t[0], a }, { t[1], b });
    EXPECT_EQ(inCircle(first, liftedFrom(p, t[2], c), guard).certain, 2u);
    const EdgePair second = edgesFrom(p, { a, t[0] }, { b, t[1] });
    EXPECT_EQ(inCircle(second, liftedFrom(p, c, t[2]), guard).certain, 1u);
  }
}

TEST(PredicatesFilters, InfinityIsUncertain)
{
  EXPECT_FALSE(orientIsCertain(kInfinity, kInfinity, 1.0));
  EXPECT_FALSE(orientIsCertain(kNan, kInfinity, 1.0));
  EXPECT_FALSE(inCircleIsCertain(kInfinity, kInfinity, 1.0, 1.0, inCircleGuard(1.0)));
  EXPECT_FALSE(inCircleIsCertain(1e300, 1.0, 1.0, 1.0, inCircleGuard(kInfinity)));
  EXPECT_FALSE(inCircleIsCertain(1e300, 1.0, 1.0, 1.0, inCircleGuard(kNan)));
}

TEST(PredicatesFilters, RandomPointsAreNearlyAlwaysCertain)
{
  Cases source(Family::Uniform);
  Tally tally;
  for (int i = 0; i < kCases; ++i)
  {
    askAll(source.draw(), tally);
  }
  EXPECT_GT(tally.certain, tally.asked - tally.asked / 1000);
}

} // namespace
} // namespace ahd::test
