// SPDX-License-Identifier: BSD-3-Clause
//
// Every predicate and every stage of it against integer arithmetic (PredicatesOracle.h), on inputs
// made to break them: about 10^6 quadruples of points.
#include "Predicates/Predicates.h"
#include "Predicates/Stages.h"

#include "ExactSigns.h"
#include "PredicatesCases.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

namespace ahd::test
{
namespace
{

using OptionalSign = std::optional<int>;

struct Volume
{
  Family family;
  int cases;
};

std::ostream& operator<<(std::ostream& out, const Volume& volume)
{
  return out << nameOf(volume.family);
}

std::string textOf(const Quadruple& p)
{
  return "a = " + hexText(p[0]) + "\nb = " + hexText(p[1]) + "\nc = " + hexText(p[2]) +
    "\nd = " + hexText(p[3]);
}

/// A stage may decline, but must not be wrong.
bool agrees(const OptionalSign& answer, int expected)
{
  return !answer || *answer == expected;
}

class PredicatesOn : public testing::TestWithParam<Volume>
{
protected:
  static int cases()
  {
#ifdef AHD_REDUCED_TESTS
    return GetParam().cases / 20;
#else
    return GetParam().cases;
#endif
  }
};

TEST_P(PredicatesOn, OrientIsExactAtEveryStage)
{
  Cases source(GetParam().family);
  for (int i = 0; i < cases(); ++i)
  {
    const Quadruple q = source.draw();
    const Point &a = q[0], &b = q[1], &c = q[2];
    const int expected = oracleOrient2d(a, b, c);
    ASSERT_TRUE(agrees(stages::orient2dByFilter(a, b, c), expected)) << i << "\n" << textOf(q);
    ASSERT_TRUE(agrees(stages::orient2dOnGrid(a, b, c), expected)) << i << "\n" << textOf(q);
    ASSERT_EQ(stages::orient2dUnbounded(a, b, c), expected) << i << "\n" << textOf(q);
    ASSERT_EQ(orient2dExact(a, b, c), expected) << i << "\n" << textOf(q);
    ASSERT_EQ(orient2d(a, b, c), expected) << i << "\n" << textOf(q);
  }
}

TEST_P(PredicatesOn, FlatnessIsExactAtEveryStage)
{
  Cases source(GetParam().family);
  for (int i = 0; i < cases(); ++i)
  {
    const Quadruple q = source.draw();
    const Point &a = q[0], &b = q[1], &c = q[2];
    const int expected = oracleFlatness(a, b, c);
    ASSERT_TRUE(agrees(stages::flatnessByFilter(a, b, c), expected)) << i << "\n" << textOf(q);
    ASSERT_TRUE(agrees(stages::flatnessOnGrid(a, b, c), expected)) << i << "\n" << textOf(q);
    ASSERT_EQ(stages::flatnessUnbounded(a, b, c), expected) << i << "\n" << textOf(q);
    ASSERT_EQ(isFlat(a, b, c), expected < 0) << i << "\n" << textOf(q);
  }
}

TEST_P(PredicatesOn, InCircleIsExactAtEveryStage)
{
  Cases source(GetParam().family);
  for (int i = 0; i < cases(); ++i)
  {
    const Quadruple q = source.draw();
    const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
    const int expected = oracleInCircle(a, b, c, d);
    ASSERT_TRUE(agrees(stages::inCircleByFilter(a, b, c, d), expected)) << i << "\n" << textOf(q);
    ASSERT_TRUE(agrees(stages::inCircleOnGrid(a, b, c, d), expected)) << i << "\n" << textOf(q);
    ASSERT_EQ(stages::inCircleUnbounded(a, b, c, d), expected) << i << "\n" << textOf(q);
    ASSERT_EQ(inCircleExact(a, b, c, d), expected) << i << "\n" << textOf(q);
    ASSERT_EQ(inCircle(a, b, c, d), expected) << i << "\n" << textOf(q);
  }
}

TEST_P(PredicatesOn, ConflictFollowsThePerturbation)
{
  Cases source(GetParam().family);
  for (int i = 0; i < cases() / 4; ++i)
  {
    Quadruple q = source.draw();
    const int turn = oracleOrient2d(q[0], q[1], q[2]);
    if (turn < 0)
    {
      std::swap(q[0], q[1]);
    }
    const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
    if (turn == 0 || d == a || d == b || d == c)
    {
      continue;
    }
    const bool expected = oracleInConflict(a, b, c, d);
    ASSERT_EQ(inConflict(a, b, c, d), expected) << i << "\n" << textOf(q);
    ASSERT_EQ(inConflictExact(a, b, c, d), expected) << i << "\n" << textOf(q);
  }
}

/// The parity of a permutation of four.
int parity(const std::array<std::size_t, 4>& order)
{
  int result = 1;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      result = order[k] > order[i] ? -result : result;
    }
  }
  return result;
}

TEST_P(PredicatesOn, PermutedArgumentsChangeTheSignByTheirParity)
{
  Cases source(GetParam().family);
  for (int i = 0; i < cases() / 20; ++i)
  {
    const Quadruple q = source.draw();
    const int sign = inCircle(q[0], q[1], q[2], q[3]);
    const int turn = orient2d(q[0], q[1], q[2]);
    std::array<std::size_t, 4> order = { 0, 1, 2, 3 };
    do
    {
      const Point &a = q[order[0]], &b = q[order[1]], &c = q[order[2]], &d = q[order[3]];
      ASSERT_EQ(inCircle(a, b, c, d), parity(order) * sign) << i << "\n" << textOf(q);
      if (order[3] == 3)
      {
        ASSERT_EQ(orient2d(a, b, c), parity(order) * turn) << i << "\n" << textOf(q);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

INSTANTIATE_TEST_SUITE_P(Families, PredicatesOn,
  testing::Values(Volume{ Family::AnyExponents, 6000 }, Volume{ Family::AnyBits, 6000 },
    Volume{ Family::Extremes, 10000 }, Volume{ Family::TinyAndHuge, 10000 },
    Volume{ Family::Subnormals, 40000 }, Volume{ Family::WideExponents, 60000 },
    Volume{ Family::Uniform, 20000 }, Volume{ Family::UlpsApart, 60000 },
    Volume{ Family::Lattice, 60000 }, Volume{ Family::ScaledLattice, 60000 },
    Volume{ Family::ShiftedLattice, 20000 }, Volume{ Family::DecimalLattice, 120000 },
    Volume{ Family::MapLattice, 120000 }, Volume{ Family::SinglePrecision, 60000 },
    Volume{ Family::NearlyCollinear, 120000 }, Volume{ Family::NearlyCircular, 120000 },
    Volume{ Family::FarCircular, 120000 }),
  [](const testing::TestParamInfo<Volume>& volume) { return nameOf(volume.param.family); });

TEST(Predicates, MinusZeroIsZero)
{
  const Point zero{ 0.0, 0.0 }, minus{ -0.0, -0.0 }, right{ 1.0, -0.0 }, up{ -0.0, 1.0 };
  EXPECT_EQ(orient2d(zero, minus, up), 0);
  EXPECT_EQ(orient2d(minus, right, up), 1);
  EXPECT_EQ(inCircle(minus, right, up, zero), 0);
  EXPECT_EQ(inCircle(minus, right, { 1.0, 1.0 }, up), 0);
  EXPECT_EQ(
    inConflict(minus, right, { 1.0, 1.0 }, up), inConflict(zero, { 1, 0 }, { 1, 1 }, { 0, 1 }));
}

TEST(Predicates, FlatIsBeyondFiveToTwo)
{
  const Point at{ 0, 0 };
  for (const double scale : { 1.0, 3.0, 0.1, 0x1p-1000, 0x1p+1000 })
  {
    const Point left{ -4 * scale, 0 }, right{ 5 * scale, 2 * scale };
    const Point further{ std::nextafter(right.x, HUGE_VAL), right.y };
    EXPECT_FALSE(isFlat(right, left, at)) << "just as wide as it may be";
    EXPECT_TRUE(isFlat(further, left, at)) << scale;
    EXPECT_FALSE(isFlat({ 0, scale }, left, at)) << "a right angle";
  }
  EXPECT_TRUE(isFlat({ 1, 0 }, { -1, 0 }, at)) << "collinear, between the two";
  EXPECT_FALSE(isFlat({ 1, 0 }, { 2, 0 }, at)) << "collinear, beyond";
}

TEST(Predicates, LargestAndSmallestNumbersTogether)
{
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(orient2d({ -huge, -huge }, { huge, huge }, { 0, 0 }), 0);
  EXPECT_EQ(orient2d({ -huge, -huge }, { huge, huge }, { 0, tiny }), 1);
  EXPECT_EQ(orient2d({ -huge, -huge }, { huge, huge }, { tiny, 0 }), -1);
  // Three of four corners of a square, and the centre's neighbourhood of the fourth.
  EXPECT_EQ(inCircle({ -huge, -huge }, { huge, -huge }, { huge, huge }, { -huge, huge }), 0);
  EXPECT_EQ(inCircle({ -huge, -huge }, { huge, -huge }, { huge, huge }, { tiny, tiny }), 1);
  EXPECT_EQ(inCircle({ 0, 0 }, { tiny, 0 }, { 0, tiny }, { tiny, tiny }), 0);
  EXPECT_EQ(inCircle({ 0, 0 }, { tiny, 0 }, { 0, tiny }, { huge, tiny }), -1);
}

} // namespace
} // namespace ahd::test
