// SPDX-License-Identifier: BSD-3-Clause
//
// The arithmetic of the Voronoi diagram, against rationals: centres, bisectors, their sums of two
// doubles, and the clipping box.
#include "Arithmetic/DoubleDouble.h"
#include "Voronoi/Circumcentre.h"
#include "Voronoi/ConvexPolygon.h"

#include "ExactSigns.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace ahd::test
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

class Numbers
{
public:
  /// With all its bits, from -1 to 1.
  double any() { return std::ldexp(double(random_() >> 11), -52) - 1.0; }
  Point point(const Point& centre, double size)
  {
    return { centre.x + size * any(), centre.y + size * any() };
  }
  std::size_t below(std::size_t end) { return random_() % end; }

private:
  std::mt19937_64 random_{ 7 };
};

struct ExactPoint
{
  explicit ExactPoint(const Point& p)
    : x(p.x)
    , y(p.y)
  {
  }
  ExactPoint(const mpq_class& itsX, const mpq_class& itsY)
    : x(itsX)
    , y(itsY)
  {
  }
  mpq_class x, y;
};

ExactPoint operator-(const ExactPoint& a, const ExactPoint& b)
{
  return { a.x - b.x, a.y - b.y };
}
mpq_class dot(const ExactPoint& a, const ExactPoint& b)
{
  return a.x * b.x + a.y * b.y;
}
mpq_class cross(const ExactPoint& a, const ExactPoint& b)
{
  return a.x * b.y - a.y * b.x;
}

ExactPoint exactCentre(const Corners& t)
{
  const ExactPoint a(t.a), u = ExactPoint(t.b) - a, v = ExactPoint(t.c) - a;
  const mpq_class twice = 2 * cross(u, v);
  return { a.x + (dot(u, u) * v.y - dot(v, v) * u.y) / twice,
    a.y + (dot(v, v) * u.x - dot(u, u) * v.x) / twice };
}

/// Is it the exact number, rounded to nearest, up to a thousandth of a unit in the last place?
testing::AssertionResult isRounded(double value, const mpq_class& exact)
{
  if (abs(exact) > mpq_class(kLargest))
  {
    return std::isfinite(value) ? testing::AssertionFailure() << value << " is finite"
                                : testing::AssertionSuccess();
  }
  if (!std::isfinite(value))
  {
    return testing::AssertionFailure() << value << " for " << exact.get_d();
  }
  const double below = std::nextafter(std::fabs(value), 0.0);
  const mpq_class unit = mpq_class(std::fabs(value)) - mpq_class(value == 0.0 ? -0x1p-1074 : below);
  const mpq_class error = abs(mpq_class(value) - exact);
  // A power of two has a larger unit above than below.
  return error * 1000 <= unit * 501 || error * 1000 <= 2 * unit * 501 ? testing::AssertionSuccess()
                                                                      : testing::AssertionFailure()
      << value << " for " << exact.get_d() << ", wrong by " << mpq_class(error / unit).get_d()
      << " units";
}

/// Counterclockwise triangles of all sizes and places: around the origin and far from it, tiny,
/// huge, flat.
Corners triangle(Numbers& numbers, int exponent, std::size_t kind)
{
  const double size = std::ldexp(1.0, exponent);
  const Point place = kind == 1 ? Point{ size * 4e5, size * 5e6 } : Point{ 0.0, 0.0 };
  Corners t{ numbers.point(place, size), numbers.point(place, size), numbers.point(place, size) };
  if (kind == 2) // flat: c nearly on the line a - b
  {
    t.c = { 0.5 * t.a.x + 0.5 * t.b.x, 0.5 * t.a.y + 0.5 * t.b.y + size * 0x1p-20 * numbers.any() };
  }
  if (cross(ExactPoint(t.b) - ExactPoint(t.a), ExactPoint(t.c) - ExactPoint(t.a)) < 0)
  {
    std::swap(t.a, t.b);
  }
  return t;
}

TEST(VoronoiGeometry, CentresAreTheExactOnesRoundedOnce)
{
  Numbers numbers;
  for (int exponent = -1040; exponent <= 1023; exponent += 7)
  {
    for (std::size_t kind = 0; kind < 3; ++kind)
    {
      if (kind == 1 && exponent > 1000)
      {
        continue;
      }
      const Corners t = triangle(numbers, exponent, kind);
      const ExactPoint exact = exactCentre(t);
      const Point centre = circumcentre(t);
      EXPECT_TRUE(isRounded(centre.x, exact.x)) << "2^" << exponent << ", kind " << kind;
      EXPECT_TRUE(isRounded(centre.y, exact.y)) << "2^" << exponent << ", kind " << kind;
    }
  }
}

/// A centre that is a corner of a lattice, far from the origin: no rounding at all.
TEST(VoronoiGeometry, CentresOfRightAnglesAreMiddles)
{
  for (const double at : { 0.0, 1048576.0, 0x1p1000 })
  {
    const double step = at == 0x1p1000 ? 0x1p960 : 2.0;
    const Point centre = circumcentre({ { at, at }, { at + step, at }, { at, at + step } });
    EXPECT_EQ(centre.x, at + step / 2);
    EXPECT_EQ(centre.y, at + step / 2);
  }
}

TEST(VoronoiGeometry, SideOfACentreIsExact)
{
  Numbers numbers;
  int zeros = 0;
  for (int exponent = -1040; exponent <= 1020; exponent += 5)
  {
    for (std::size_t kind = 0; kind < 3; ++kind)
    {
      const Corners t = triangle(numbers, std::min(exponent, 990), kind);
      const ExactPoint from(t.a), to(t.b);
      const int side = sgn(cross(to - from, exactCentre(t) - from));
      EXPECT_EQ(sideOfCircumcentre(t, t.a, t.b), side) << "2^" << exponent << ", kind " << kind;
    }
    const double s = std::ldexp(3.0, exponent);
    zeros += sideOfCircumcentre({ { 0, 0 }, { s, 0 }, { 0, s } }, { s, 0 }, { 0, s }) == 0;
    EXPECT_EQ(sideOfCircumcentre({ { 0, 0 }, { s, 0 }, { 0, s } }, { 0, s }, { 0, 0 }), 1);
    EXPECT_EQ(sideOfCircumcentre({ { 0, 0 }, { s, 0 }, { 0, s } }, { 0, 0 }, { 0, s }), -1);
  }
  EXPECT_EQ(zeros, 413) << "the centre is the middle of the long side";
}

TEST(VoronoiGeometry, BisectorsMeetLinesWhereTheyDo)
{
  Numbers numbers;
  for (int i = 0; i < 2000; ++i)
  {
    const double size = std::ldexp(1.0, static_cast<int>(numbers.below(1900)) - 950);
    const Point origin = i % 2 == 0 ? Point{ 0, 0 } : Point{ 1e6 * size, 1e6 * size };
    const Point p = numbers.point(origin, size), q = numbers.point(origin, size);
    const Point from = numbers.point(origin, size), to = numbers.point(origin, size);
    const ExactPoint P(p), Q(q), F(from), T(to);
    const ExactPoint apart = Q - P;
    const ExactPoint fromMiddle{ (P.x + Q.x) / 2 - F.x, (P.y + Q.y) / 2 - F.y };
    const mpq_class part = dot(fromMiddle, apart) / dot(T - F, apart);
    const Point met = bisectorOnLine(p, q, { from, to });
    EXPECT_TRUE(isRounded(met.x, F.x + part * (T.x - F.x))) << "case " << i;
    EXPECT_TRUE(isRounded(met.y, F.y + part * (T.y - F.y))) << "case " << i;
  }
}

/// Where about 100 bits do not decide: flat triangles far away, bisectors along a side, and places
/// that are nearly 0.
TEST(VoronoiGeometry, PlacesThatTakeManyBits)
{
  Numbers numbers;
  for (int i = 0; i < 500; ++i)
  {
    const double tiny = std::ldexp(numbers.any(), -60 - int(numbers.below(900)));
    const Corners flat{ { -1.0, 0.0 }, { 1.0, std::fabs(tiny) }, { 0.5, 1.0 + numbers.any() } };
    const Corners needle{ { 0.0, 0.0 }, { 0.25, -std::fabs(tiny) }, { 0.5, 0.0 } };
    for (const Corners& t : { flat, needle })
    {
      const ExactPoint exact = exactCentre(t);
      const Point centre = circumcentre(t);
      EXPECT_TRUE(isRounded(centre.x, exact.x)) << i;
      EXPECT_TRUE(isRounded(centre.y, exact.y)) << i;
    }
    const Point p{ 0.25, 0.5 + numbers.any() }, q{ 0.25 + tiny, -p.y };
    const mpq_class steep = 2 * (mpq_class(q.x) - p.x);
    const mpq_class far = dot(ExactPoint(q), ExactPoint(q)) - dot(ExactPoint(p), ExactPoint(p));
    const Point met = bisectorOnLine(p, q, { { 0.0, 0.0 }, { 1.0, 0.0 } });
    EXPECT_TRUE(q.x == p.x || isRounded(met.x, far / steep)) << i;
  }
}

mpq_class exactly(const DoubleDouble& a)
{
  return mpq_class(a.high) + mpq_class(a.low);
}

TEST(VoronoiGeometry, SumsOfTwoDoublesHaveAHundredBits)
{
  Numbers numbers;
  const mpq_class small = mpq_class(1) / (mpz_class(1) << 98);
  for (int i = 0; i < 5000; ++i)
  {
    const auto draw = [&]
    { return exactSum(numbers.any(), std::ldexp(numbers.any(), -50 - int(numbers.below(10)))); };
    const DoubleDouble a = draw(), b = draw();
    const mpq_class A = exactly(a), B = exactly(b);
    EXPECT_LE(abs(exactly(a * b) - A * B), small * abs(A * B)) << "case " << i;
    EXPECT_LE(abs(exactly(a / b) - A / B), small * abs(A / B)) << "case " << i;
    EXPECT_LE(abs(exactly(a + b) - (A + B)), small * (abs(A) + abs(B))) << "case " << i;
    EXPECT_LE(abs(exactly(a - b) - (A - B)), small * (abs(A) + abs(B))) << "case " << i;
    EXPECT_EQ(exactly(exactProduct(a.high, b.high)), mpq_class(a.high) * mpq_class(b.high));
    EXPECT_EQ(exactly(exactDifference(a.high, b.low)), mpq_class(a.high) - mpq_class(b.low));
  }
}

std::uint32_t exitOf(const ConvexPolygon& polygon, const Point& p, const Point& q)
{
  ConvexPolygon::Crossing crossing, back;
  EXPECT_TRUE(polygon.isCrossed(p, q, crossing) && polygon.isCrossed(q, p, back));
  EXPECT_TRUE(crossing.entry == back.exit && crossing.exit == back.entry);
  return crossing.exit;
}

/// Where a bisector leaves the box, and the corners passed.
TEST(VoronoiGeometry, OneLeavesTheBoxWhereTheBisectorDoes)
{
  Numbers numbers;
  for (int i = 0; i < 5000; ++i)
  {
    const double size = i % 3 == 0 ? kLargest : i % 3 == 1 ? 0.1 : 1.0;
    const ConvexPolygon box({ { size, -size * 0.7 }, { -size, size } });
    const Point p{ size * numbers.any(), 0.7 * size * numbers.any() };
    const Point q = i % 2 == 0 ? Point{ p.x, std::nextafter(p.y, size) }
                               : Point{ size * numbers.any(), 0.7 * size * numbers.any() };
    const std::uint32_t at = exitOf(box, p, q);
    ASSERT_LT(at, 8u);
    if (at % 2 == 0)
    {
      continue; // in a corner: below
    }
    const Line side = box.side(at / 2);
    const Point left = bisectorOnLine(p, q, side);
    const ExactPoint from(side.from), to(side.to), P(p), Q(q);
    const auto nearer = [&](const ExactPoint& z)
    { return sgn(dot(z - Q, z - Q) - dot(z - P, z - P)); };
    EXPECT_LT(nearer(from), 0) << hexText(p) << hexText(q);
    EXPECT_GT(nearer(to), 0) << hexText(p) << hexText(q);
    EXPECT_TRUE(left.x >= std::min(side.from.x, side.to.x) &&
      left.x <= std::max(side.from.x, side.to.x) && left.y >= std::min(side.from.y, side.to.y) &&
      left.y <= std::max(side.from.y, side.to.y))
      << hexText(left);
  }
}

TEST(VoronoiGeometry, OneLeavesTheBoxInACorner)
{
  const ConvexPolygon box({ { 0, 0 }, { 4, 4 } });
  EXPECT_EQ(exitOf(box, { 1, 2 }, { 2, 1 }), 4u) << "to the upper right";
  EXPECT_EQ(exitOf(box, { 2, 1 }, { 1, 2 }), 0u) << "to the lower left";
  EXPECT_EQ(exitOf(box, { 1, 2 }, { 2, 3 }), 6u) << "to the upper left";
  EXPECT_EQ(exitOf(box, { 2, 3 }, { 1, 2 }), 2u) << "to the lower right";
  EXPECT_EQ(exitOf(box, { 1, 2 }, { 2, std::nextafter(1.0, 2.0) }), 5u) << "nearly, above";
  EXPECT_EQ(exitOf(box, { 1, 2 }, { 2, std::nextafter(1.0, 0.0) }), 3u) << "nearly, to the right";
}

/// Centres rounded onto a side are decided by their sign.
TEST(VoronoiGeometry, ABoxHasTheCentresThatAreInIt)
{
  const Point a{ 0.0, 0.0 }, b{ 3.0, 0.0 };
  for (const double y : { 1.5, std::nextafter(1.5, 2.0), std::nextafter(1.5, 1.0) })
  {
    const Corners t{ a, b, { 1.5, y } };
    const Point centre = circumcentre(t);
    const ConvexPolygon box({ { 0, 0 }, { 3, 9 } });
    const bool isInside = y > 1.5;
    EXPECT_EQ(box.sideBeyond(t, centre), isInside ? ConvexPolygon::kNoSide : 0u) << y;
    EXPECT_EQ(box.sideBeyond(t, { 1.5, 0.0 }), isInside ? ConvexPolygon::kNoSide : 0u)
      << "if it is rounded onto the side, " << y;
    EXPECT_EQ(box.sideOf(0, t, centre), y > 1.5 ? 1 : y < 1.5 ? -1 : 0);
  }
}

} // namespace
} // namespace ahd::test
