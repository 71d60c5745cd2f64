// SPDX-License-Identifier: BSD-3-Clause
//
// The ghost as a point far away: where the in-circle filter is certain of a triangle that has it,
// one at a time or two, that is the exact orientation, for the hardest points: at the ends of their
// range, and hardly off one line.
#include "Predicates/FilterPairs.h"

#include "ExactSigns.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace ahd::test
{
namespace
{

#ifdef AHD_REDUCED_TESTS
constexpr int kCases = 20000;
#else
constexpr int kCases = 100000;
#endif

/// Coordinates below 2^exponent, and the guard and ghost that go with them (Frame.cxx).
struct Range
{
  explicit Range(int exponent)
    : end(std::ldexp(1.0, exponent))
    , ghost{ 0.0, std::ldexp(kGhostDistance, exponent) }
    , guard(inCircleGuard(2 * ghost.y * ghost.y))
    , squaredGuard(inCircleSquaredGuard(2 * ghost.y * ghost.y))
  {
  }

  double end;
  Point ghost;
  double guard;
  double squaredGuard;
};

struct Triple
{
  Point a, b, p;
};

class TripleCases
{
public:
  explicit TripleCases(const Range& range)
    : range_(range)
  {
  }

  /// p is between a and b or beyond one of them, and a few units in the last place off their line.
  Triple draw()
  {
    const Point a = anywhere(), b = anywhere();
    const double way = random_() % 4 == 0 ? 1.0 - 0x1p-20 * unit() : unit();
    return { a, b, { moved(a.x + way * (b.x - a.x)), moved(a.y + way * (b.y - a.y)) } };
  }

private:
  double unit() { return double(random_() >> 11) * 0x1p-53; }
  double within(double value) const
  {
    const double last = std::nextafter(range_.end, 0.0);
    return value > last ? last : value < -last ? -last : value;
  }
  /// Mostly at an end of the range, or near it.
  double coordinate()
  {
    const double sign = random_() % 2 != 0 ? 1.0 : -1.0;
    const double inwards = random_() % 4 == 0 ? unit() : 0x1p-50 * double(random_() % 64);
    return within(sign * range_.end * (1.0 - inwards));
  }
  Point anywhere()
  {
    const double x = coordinate();
    return { x, coordinate() };
  }
  double moved(double value)
  {
    return within(value + (double(random_() % 129) - 64.0) * 0x1p-52 * range_.end);
  }

  const Range& range_;
  std::mt19937_64 random_{ 3 };
};

struct Tally
{
  int certain = 0;
  int nearly = 0; ///< certain by less than four times the bound
  int asked = 0;
};

/// `det` may be the square of a determinant, then `bound` is that of a bound.
void count(double det, double bound, double nearly, Tally& tally)
{
  ++tally.asked;
  tally.certain += std::fabs(det) > bound;
  tally.nearly += std::fabs(det) > bound && std::fabs(det) < nearly * bound;
}

/// The triangle a, b, ghost, from each of its corners on.
void askOne(const Triple& t, const Range& range, int side, Tally& tally)
{
  const Lifted corners[3] = { liftedFrom(t.p, t.a), liftedFrom(t.p, t.b),
    liftedFrom(t.p, range.ghost) };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Lifted &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
    const double det = inCircleDeterminant(a, b, c, cross(a, b));
    const double bound = inCircleErrorBound(a.z, b.z, c.z, range.guard);
    count(det, bound, 4.0, tally);
    ASSERT_TRUE(std::fabs(det) <= bound || (det > 0 ? 1 : -1) == side) << "corner " << k;
  }
}

/// Two of the three ways at a time.
void askTwo(const Triple& t, const Range& range, int side, Tally& tally)
{
  const VectorPair p{ both(t.p.x), both(t.p.y) };
  const Point corners[3] = { t.a, t.b, range.ghost };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point &q0 = corners[k], &q1 = corners[(k + 1) % 3], &q2 = corners[(k + 2) % 3];
    const LiftedPair a = liftedFrom(p, q1, q2), b = liftedFrom(p, q0, q1);
    const LiftedPair c = liftedFrom(p, q2, q0);
    const EdgePair edges{ a, b, cross(a, b) };
    const InCirclePair seen = inCircle(edges, c, both(range.squaredGuard));
    const Pair det = inCircleDeterminant(edges, c);
    const Pair bound = inCircleSquaredBound(edges, c, both(range.squaredGuard));
    count(low(det * det), low(bound), 16.0, tally);
    for (unsigned i = 0; i < 2; ++i)
    {
      const bool isCertain = (seen.certain >> i & 1) != 0;
      ASSERT_TRUE(!isCertain || ((seen.inside >> i & 1) != 0 ? 1 : -1) == side)
        << "corner " << k << ", " << i;
    }
  }
}

TEST(PredicatesGhost, WhatIsCertainIsTheOrientation)
{
  for (const int exponent : { -kFrameExponent, -1, 0, kFrameExponent })
  {
    const Range range(exponent);
    TripleCases source(range);
    Tally tally;
    for (int i = 0; i < kCases; ++i)
    {
      const Triple t = source.draw();
      const int side = oracleOrient2d(t.a, t.b, t.p);
      askOne(t, range, side, tally);
      askTwo(t, range, side, tally);
      ASSERT_FALSE(HasFatalFailure())
        << hexText(t.a) << hexText(t.b) << hexText(t.p) << ", 2^" << exponent;
    }
    EXPECT_GT(tally.nearly, tally.asked / 50) << "the cases are too easy, 2^" << exponent;
    EXPECT_GT(tally.asked - tally.certain, tally.asked / 50) << "2^" << exponent;
  }
}

/// On a grid the ghost's triangles are never taken for exact ones, however coarse or fine it is.
TEST(PredicatesGhost, IsNotTakenForAPointOfTheGrid)
{
  for (const int exponent : { -kFrameExponent, 0, kFrameExponent })
  {
    const Range range(exponent);
    // The unit is half of the whole extent, or the finest that is found.
    for (const double unit : { 0.5 * range.end, 0x1p-51 * range.end })
    {
      const Exactly exactly{ exactErrorBound(unit), perturbationFor(unit) };
      const VectorPair p{ both(0.0), both(0.0) };
      const LiftedPair a = liftedFrom(p, { unit, 0.0 }, range.ghost);
      const LiftedPair b = liftedFrom(p, { 0.0, unit }, { 0.0, -unit });
      const LiftedPair c = liftedFrom(p, range.ghost, { -unit, 0.0 });
      const Pair bound = inCircleErrorBound({ a, b, cross(a, b) }, c, both(range.guard));
      EXPECT_GT(low(bound), exactly.below) << exponent << ", " << unit;
      EXPECT_GT(high(bound), exactly.below) << exponent << ", " << unit;
    }
  }
}

} // namespace
} // namespace ahd::test
