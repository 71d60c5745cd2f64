// SPDX-License-Identifier: BSD-3-Clause
//
// The stage of a predicate that decides: cheap stages must decide the data they are meant for, and
// must decline cases that they cannot decide exactly.
#include "Arithmetic/WideInteger.h"
#include "Predicates/Stages.h"

#include "PredicatesCases.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <string>

namespace ahd::test
{
namespace
{

enum class Stage
{
  Filter,
  Grid,
  Unbounded
};

std::ostream& operator<<(std::ostream& out, Stage stage)
{
  static const char* const names[] = { "Filter", "Grid", "Unbounded" };
  return out << names[static_cast<int>(stage)];
}

Stage orientStage(const Point& a, const Point& b, const Point& c)
{
  return stages::orient2dByFilter(a, b, c) ? Stage::Filter
    : stages::orient2dOnGrid(a, b, c)      ? Stage::Grid
                                           : Stage::Unbounded;
}

Stage inCircleStage(const Quadruple& q)
{
  return stages::inCircleByFilter(q[0], q[1], q[2], q[3]) ? Stage::Filter
    : stages::inCircleOnGrid(q[0], q[1], q[2], q[3])      ? Stage::Grid
                                                          : Stage::Unbounded;
}

Stage flatnessStage(const Point& a, const Point& b, const Point& c)
{
  return stages::flatnessByFilter(a, b, c) ? Stage::Filter
    : stages::flatnessOnGrid(a, b, c)      ? Stage::Grid
                                           : Stage::Unbounded;
}

Quadruple scaled(const Quadruple& q, int exponent)
{
  Quadruple result = q;
  for (Point& p : result)
  {
    p = { std::ldexp(p.x, exponent), std::ldexp(p.y, exponent) };
  }
  return result;
}

const Quadruple kSquare = { Point{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
const Quadruple kInside = { Point{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.25, 0.5 } };

#ifdef AHD_HAS_INT128
constexpr Stage kGridOrLater = Stage::Grid;
#else
constexpr Stage kGridOrLater = Stage::Unbounded; // there is no grid stage without 128-bit integers
#endif

TEST(PredicatesStages, FilterSettlesWhatIsFarFromDegenerate)
{
  // Scales at which neither a determinant of degree 4 nor a guard against underflow interferes.
  for (int exponent = -225; exponent <= 250; exponent += 5)
  {
    EXPECT_EQ(inCircleStage(scaled(kInside, exponent)), Stage::Filter) << exponent;
  }
  for (int exponent = -500; exponent <= 500; exponent += 5)
  {
    const Quadruple q = scaled(kSquare, exponent);
    EXPECT_EQ(orientStage(q[0], q[1], q[2]), Stage::Filter) << exponent;
  }
}

TEST(PredicatesStages, FilterLeavesTiesAlone)
{
  for (int exponent = -1074; exponent <= 1023; ++exponent)
  {
    const Quadruple q = scaled(kSquare, exponent);
    EXPECT_NE(inCircleStage(q), Stage::Filter) << exponent;
    EXPECT_NE(orientStage(q[0], q[2], { 0, 0 }), Stage::Filter) << exponent;
  }
}

TEST(PredicatesStages, GridSettlesTiesOfLatticesAtAnyUsualScale)
{
  for (int exponent = -890; exponent <= 1000; exponent += 10)
  {
    const Quadruple q = scaled(kSquare, exponent);
    EXPECT_EQ(inCircleStage(q), kGridOrLater) << exponent;
    EXPECT_EQ(orientStage(q[0], q[2], { q[2].x / 2, q[2].y / 2 }), kGridOrLater) << exponent;
  }
}

/// All of a family of nearly degenerate neighbours, near the axes and away from them.
TEST(PredicatesStages, GridSettlesDecimalsMapsAndShiftedLattices)
{
  for (const Family family : { Family::Lattice, Family::ShiftedLattice, Family::DecimalLattice,
         Family::MapLattice, Family::UlpsApart, Family::FarCircular })
  {
    Cases source(family);
    int atFilter = 0;
    for (int i = 0; i < 2000; ++i)
    {
      const Quadruple q = source.draw();
      if (q[0] == q[3] && q[1] == q[3] && q[2] == q[3])
      {
        continue;
      }
      const Stage stage = inCircleStage(q);
      atFilter += stage == Stage::Filter;
      ASSERT_LE(stage, kGridOrLater) << nameOf(family) << ", case " << i;
    }
    EXPECT_LT(atFilter, 2000) << nameOf(family) << " does not reach the stages behind the filter";
  }
}

TEST(PredicatesStages, GridTakesUpWhatRoundingADifferenceLeaves)
{
  // 1 + 2^-60 is no double: the vector from d to b is 1 + 2^-60 wide, of 61 bits.
  const Quadruple q = { Point{ 0, 0 }, { 1, 0 }, { 1, 1 }, { -0x1p-60, 1 } };
  EXPECT_EQ(inCircleStage(q), kGridOrLater);
  EXPECT_EQ(inCircle(q[0], q[1], q[2], q[3]), -1);
  EXPECT_EQ(inCircle(q[0], q[1], q[2], { 0x1p-60, 1 }), 1);
  EXPECT_EQ(orientStage(q[1], { 0x1p-60, 0x1p-60 }, q[3]), Stage::Filter);
  EXPECT_EQ(orientStage({ 1, -1 }, { 0, 0x1p-60 }, { -0x1p-60, 0x1p-60 }), Stage::Filter);
  EXPECT_EQ(orientStage({ 1, 1 }, { 0x1p-60, 0x1p-60 }, { -0x1p-60, -0x1p-60 }), kGridOrLater);
  EXPECT_EQ(orientStage({ 1, 1 }, { 0, 0x1p-60 }, { -0x1p-60, 0 }), kGridOrLater);
  EXPECT_EQ(orient2d({ 1, 1 }, { 0, 0x1p-60 }, { -0x1p-60, 0 }), 1); // the area is 2^-120
}

/// The circle through a, b, c touches the x axis at the origin, all but 2^-60 of it: the
/// determinant is 2^-119, and 2^121 in units of the grid. It is decided in the low half of 256
/// bits.
TEST(PredicatesStages, GridSeesTheLastBits)
{
  const Point origin{ 0, 0 }, beside{ 0x1p-60, 0 }, right{ 1, 1 }, left{ -1, 1 };
  EXPECT_EQ(inCircleStage({ beside, right, left, origin }), kGridOrLater);
  EXPECT_EQ(inCircle(beside, right, left, origin), 1);
  EXPECT_EQ(inCircleStage({ origin, right, left, beside }), kGridOrLater);
  EXPECT_EQ(inCircle(origin, right, left, beside), -1);
}

TEST(PredicatesStages, UnboundedSettlesWhatSpansMoreThan61Bits)
{
  const Quadruple wide = { Point{ 0, 0 }, { 1, 0 }, { 1, 1 }, { -0x1p-70, 1 } };
  EXPECT_EQ(inCircleStage(wide), Stage::Unbounded);
  EXPECT_EQ(inCircle(wide[0], wide[1], wide[2], wide[3]), -1);
  EXPECT_EQ(inCircle(wide[0], wide[1], wide[2], { 0x1p-70, 1 }), 1);
  EXPECT_EQ(orientStage({ 1, 1 }, { 0, 0x1p-70 }, { -0x1p-70, 0 }), Stage::Unbounded);
  EXPECT_EQ(orient2d({ 1, 1 }, { 0, 0x1p-70 }, { -0x1p-70, 0 }), 1); // the area is 2^-140
  EXPECT_EQ(orientStage({ 1e300, 1e300 }, { 1e-300, 1e-300 }, { 0, 0 }), Stage::Unbounded);
}

TEST(PredicatesStages, UnboundedSettlesTheEndsOfTheExponentRange)
{
  for (const int exponent : { -1074, -1073, -1000, -910, 1005, 1023 })
  {
    EXPECT_EQ(inCircleStage(scaled(kSquare, exponent)), Stage::Unbounded) << exponent;
  }
  // Differences that overflow.
  const double big = 0x1.8p1023;
  EXPECT_EQ(orientStage({ -big, -big }, { big, big }, { 0x1p1000, 0x1p1000 }), Stage::Unbounded);
  EXPECT_EQ(orient2d({ -big, -big }, { big, big }, { 0x1p1000, 0x1p1000 }), 0);
}

/// Around the limit of 61 bits, in every coordinate: the grid stage must be exact or decline.
TEST(PredicatesStages, GridIsExactUpToItsLimit)
{
  int answered = 0, declined = 0;
  for (int bits = 50; bits < 70; ++bits)
  {
    for (int place = 0; place < 8; ++place)
    {
      Quadruple q = { Point{ 0, 0 }, { 0x1.8p0, 0 }, { 0x1.8p0, 0x1.8p0 }, { 0, 0x1.8p0 } };
      double& coordinate = place % 2 == 0 ? q[std::size_t(place / 2)].x
                                          : q[std::size_t(place / 2)].y;
      coordinate += coordinate == 0.0 ? std::ldexp(1.0, -bits) : std::ldexp(1.0, -52);
      const std::optional<int> sign = stages::inCircleOnGrid(q[0], q[1], q[2], q[3]);
      answered += sign.has_value();
      declined += !sign.has_value();
      const int expected = oracleInCircle(q[0], q[1], q[2], q[3]);
      EXPECT_EQ(sign.value_or(expected), expected) << bits << " bits, coordinate " << place;
    }
  }
  EXPECT_GT(declined, 0);
  if (kGridOrLater == Stage::Grid)
  {
    EXPECT_GT(answered, 0);
  }
}

/// Triangles as wide as can be without being flat: seen from c, b lies in the direction (5, -2)
/// where a lies in the direction (-1, 0).
const Quadruple kWidest = { Point{ -3, 1 }, { 3, -1 }, { -2, 1 }, { 0, 0 } };

TEST(PredicatesStages, FilterSettlesWhatIsClearlyFlatOrNot)
{
  for (int exponent = -500; exponent <= 500; exponent += 5)
  {
    const Quadruple q = scaled({ Point{ 1, 0 }, { -3, 1 }, { -1, 1 }, { 0, 0 } }, exponent);
    EXPECT_EQ(flatnessStage(q[0], q[1], q[3]), Stage::Filter) << exponent;
    EXPECT_TRUE(isFlat(q[0], q[1], q[3])) << exponent;
    EXPECT_EQ(flatnessStage(q[0], q[2], q[3]), Stage::Filter) << exponent;
    EXPECT_FALSE(isFlat(q[0], q[2], q[3])) << exponent;
  }
}

TEST(PredicatesStages, GridSettlesWhatIsNearlyFlatAtAnyUsualScale)
{
  for (int exponent = -890; exponent <= 990; exponent += 10)
  {
    const Quadruple q = scaled(kWidest, exponent);
    EXPECT_EQ(flatnessStage(q[0], q[1], q[2]), kGridOrLater) << exponent;
    EXPECT_FALSE(isFlat(q[0], q[1], q[2])) << exponent;
  }
  // b a last bit lower than (-5, 2); then c and a raised by 2^-57, of 60 bits.
  EXPECT_TRUE(isFlat({ 1, 0 }, { -5, 2 - 0x1p-52 }, { 0, 0 }));
  EXPECT_EQ(flatnessStage({ 1, 0x1p-57 }, { -5, 2 }, { 0, 0x1p-57 }), kGridOrLater);
  EXPECT_TRUE(isFlat({ 1, 0x1p-57 }, { -5, 2 }, { 0, 0x1p-57 }));
  EXPECT_FALSE(isFlat({ 1, -0x1p-57 }, { -5, 2 }, { 0, -0x1p-57 }));
}

TEST(PredicatesStages, UnboundedSettlesWhatIsNearlyFlatBeyondTheGrid)
{
  EXPECT_EQ(flatnessStage({ 1, 0x1p-70 }, { -5, 2 }, { 0, 0x1p-70 }), Stage::Unbounded);
  EXPECT_TRUE(isFlat({ 1, 0x1p-70 }, { -5, 2 }, { 0, 0x1p-70 }));
  EXPECT_FALSE(isFlat({ 1, -0x1p-70 }, { -5, 2 }, { 0, -0x1p-70 }));
  for (const int exponent : { -1074, -1073, -1000, 1022 })
  {
    const Quadruple q = scaled(kWidest, exponent);
    EXPECT_EQ(flatnessStage(q[0], q[1], q[2]), Stage::Unbounded) << exponent;
    EXPECT_FALSE(isFlat(q[0], q[1], q[2])) << exponent;
  }
}

// -------------------------------------------------------------------------------- WideInteger

mpz_class asGmp(const std::uint64_t* words, int count, bool negative)
{
  mpz_class result = 0;
  for (int i = count - 1; i >= 0; --i)
  {
    mpz_class high(static_cast<unsigned long>(words[i] >> 32));
    result = ((result << 32) + high) << 32;
    result += static_cast<unsigned long>(words[i] & 0xFFFFFFFFu);
  }
  return negative ? mpz_class(-result) : result;
}

template <int N>
mpz_class asGmp(const WideInteger<N>& a)
{
  return asGmp(a.word, a.size, a.negative);
}

/// Words that provoke carries.
template <int N>
WideInteger<N> awkward(std::mt19937_64& random)
{
  const std::uint64_t words[] = { 0, 1, ~std::uint64_t(0), std::uint64_t(1) << 63, random() };
  WideInteger<N> result;
  result.negative = random() % 2 == 0;
  for (std::uint64_t left = random() % (N + 1); left > 0; --left)
  {
    result.push(words[random() % 5]);
  }
  result.dropLeadingZeros();
  return result;
}

TEST(WideIntegers, SumsDifferencesAndProductsAreThoseOfGmp)
{
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i)
  {
    const WideInteger<5> a = awkward<5>(random);
    const WideInteger<3> b = awkward<3>(random);
    const std::string where = asGmp(a).get_str(16) + " and " + asGmp(b).get_str(16);
    ASSERT_EQ(asGmp(a + b), asGmp(a) + asGmp(b)) << where;
    ASSERT_EQ(asGmp(b + a), asGmp(a) + asGmp(b)) << where;
    ASSERT_EQ(asGmp(a - b), asGmp(a) - asGmp(b)) << where;
    ASSERT_EQ(asGmp(b - a), asGmp(b) - asGmp(a)) << where;
    ASSERT_EQ((a - a).sign(), 0) << where;
    ASSERT_EQ(asGmp(a * b), asGmp(a) * asGmp(b)) << where;
    ASSERT_EQ((a * b).sign(), sgn(asGmp(a)) * sgn(asGmp(b))) << where;
  }
}

TEST(WideIntegers, ShiftedMantissas)
{
  using Wide = WideInteger<4>;
  for (int shift = 0; shift <= 192; ++shift)
  {
    for (const std::uint64_t mantissa : { std::uint64_t(0), std::uint64_t(1), ~std::uint64_t(0) })
    {
      const mpz_class expected = asGmp(&mantissa, 1, true) << static_cast<unsigned long>(shift);
      ASSERT_EQ(asGmp(wideFrom<Wide>(mantissa, shift, true)), expected) << shift;
    }
  }
}

} // namespace
} // namespace ahd::test
