// SPDX-License-Identifier: BSD-3-Clause
#include "Circumcentre.h"

#include "../Arithmetic/DoubleDouble.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

/// Differences of points, all times the same power of two: the largest is then about 1, and neither
/// their products nor products of these overflow.
class Differences
{
public:
  explicit Differences(const Point& origin)
    : origin_(origin)
  {
  }

  /// Takes a point into account. All have to be known before the first from().
  void add(const Point& p)
  {
    const double far = std::max(half(p.x, origin_.x), half(p.y, origin_.y));
    largest_ = std::max(largest_, far);
  }

  void scale()
  {
    int exponent = 0;
    // Of half the largest difference, which may round to zero.
    std::frexp(std::max(largest_, std::numeric_limits<double>::denorm_min()), &exponent);
    // Differences of huge numbers are taken of their quarters.
    before_ = exponent > 1000 ? 0.25 : 1.0;
    const int shift = exponent > 1000 ? exponent - 1 : exponent + 1;
    first_ = std::ldexp(1.0, -shift / 2);
    second_ = std::ldexp(1.0, -(shift - shift / 2));
    back_ = shift + (exponent > 1000 ? 2 : 0);
  }

  DoubleDoubleVector between(const Point& from, const Point& to) const
  {
    return { one(to.x, from.x), one(to.y, from.y) };
  }

  /// origin + v, unscaled and rounded.
  Point apply(const DoubleDoubleVector& v) const
  {
    return { back(origin_.x, v.x), back(origin_.y, v.y) };
  }

private:
  static double half(double a, double b) { return std::fabs(0.5 * a - 0.5 * b); }

  DoubleDouble one(double a, double b) const
  {
    const DoubleDouble d = exactDifference(before_ * a, before_ * b);
    return scaled(scaled(d, first_), second_);
  }

  double back(double origin, const DoubleDouble& v) const
  {
    const double a = std::ldexp(v.high, back_);
    const double b = std::ldexp(v.low, back_);
    if (!std::isfinite(a))
    {
      return backByHalves(origin, std::ldexp(v.high, back_ - 1), b);
    }
    const DoubleDouble sum = exactSum(origin, a);
    return std::isfinite(sum.low) ? sum.high + (sum.low + b) : origin + a;
  }

  /// origin + 2 half + rest: the way from one end of the range of double to the other is no double.
  static double backByHalves(double origin, double half, double rest)
  {
    const DoubleDouble sum = exactSum(origin, half);
    const DoubleDouble whole = exactSum(sum.high, half);
    const double low = sum.low + whole.low + rest;
    return std::isfinite(low) ? whole.high + low : whole.high;
  }

  Point origin_;
  double largest_ = 0.0;
  double before_ = 1.0;
  double first_ = 1.0, second_ = 1.0; ///< their product may be no double
  int back_ = 0;
};

/// The circumcentre is corner a + offset / divisor.
struct Centre
{
  DoubleDoubleVector offset;
  DoubleDouble divisor; ///< four times the area of the triangle
};

Centre centreOf(const Differences& differences, const Corners& triangle)
{
  const DoubleDoubleVector u = differences.between(triangle.a, triangle.b);
  const DoubleDoubleVector v = differences.between(triangle.a, triangle.c);
  const DoubleDouble uu = dot(u, u);
  const DoubleDouble vv = dot(v, v);
  Centre result;
  result.offset = { uu * v.y - vv * u.y, vv * u.x - uu * v.x };
  result.divisor = scaled(cross(u, v), 2.0);
  return result;
}

/// Is it zero, or so far from the ends of the range that neither products of three differences of
/// such numbers nor the rounding errors of these overflow or underflow?
bool isModest(double x)
{
  const double size = std::fabs(x);
  return (size >= 0x1p-60 && size <= 0x1p60) || size == 0.0;
}

bool areModest(const Corners& t)
{
  return isModest(t.a.x) && isModest(t.a.y) && isModest(t.b.x) && isModest(t.b.y) &&
    isModest(t.c.x) && isModest(t.c.y);
}

/// A number in plain double precision, and how far it may be from what it stands for.
struct Estimate
{
  double value;
  double error;
};

/// origin + offset, rounded to nearest. False if the error leaves open what that is.
bool roundedSum(double origin, const Estimate& offset, double& result)
{
  const DoubleDouble sum = exactSum(origin, offset.value);
  // The second term is for what is rounded here, and where circumcentre() adds with 100 bits.
  const double error = offset.error + 0x1p-100 * std::fabs(sum.high);
  result = sum.high + (sum.low - error);
  return error > 0.0 && result == sum.high + (sum.low + error);
}

/// What circumcentre() finds, where plain double precision is enough to tell: nearly always. False
/// if not. REQUIRES: areModest().
///
/// With e = 2^-53, the sides u and v of the triangle are known to 1 e of their coordinates, the
/// squares of their lengths to 4 e, a product of both kinds to 6 e, and a difference of two such
/// products to 7 e of the sum of their sizes; the divisor to 4 e of the sum of the sizes of its two
/// products. The constants below are larger by what the bounds themselves are rounded, and by the
/// terms of second order, the divisor's error being at most 2^-10 of it.
bool quickCentre(const Corners& t, Point& result)
{
  constexpr double kProducts = 8.0 * 0x1p-53, kDivisor = 5.0 * 0x1p-53, kQuotient = 0x1p-51;
  const Point u{ t.b.x - t.a.x, t.b.y - t.a.y }, v{ t.c.x - t.a.x, t.c.y - t.a.y };
  const double uu = u.x * u.x + u.y * u.y, vv = v.x * v.x + v.y * v.y;
  const double first = u.x * v.y, second = u.y * v.x;
  const double half = first - second;
  const double halfError = kDivisor * (std::fabs(first) + std::fabs(second));
  if (!(halfError <= 0x1p-10 * std::fabs(half)))
  {
    return false;
  }
  const double scale = 0.5 / half;
  const auto quotient = [&](double plus, double minus)
  {
    const double value = (plus - minus) * scale;
    const double products = kProducts * (std::fabs(plus) + std::fabs(minus));
    const double error = products * std::fabs(scale) +
      std::fabs(value) * (halfError * 2.0 * std::fabs(scale) + kQuotient);
    return Estimate{ value, 1.01 * error };
  };
  return roundedSum(t.a.x, quotient(uu * v.y, vv * u.y), result.x) &&
    roundedSum(t.a.y, quotient(vv * u.x, uu * v.x), result.y);
}

/// The nearest number to `value` from a to b.
double between(double value, double a, double b)
{
  return std::min(std::max(value, std::min(a, b)), std::max(a, b));
}

} // namespace

Point circumcentre(const Corners& triangle)
{
  if (Point quick; areModest(triangle) && quickCentre(triangle, quick))
  {
    return quick;
  }
  Differences differences(triangle.a);
  differences.add(triangle.b);
  differences.add(triangle.c);
  differences.scale();
  const Centre centre = centreOf(differences, triangle);
  return differences.apply({ centre.offset.x / centre.divisor, centre.offset.y / centre.divisor });
}

int sideOfCircumcentre(const Corners& triangle, const Point& from, const Point& to)
{
  Differences differences(triangle.a);
  differences.add(triangle.b);
  differences.add(triangle.c);
  differences.add(from);
  differences.add(to);
  differences.scale();
  const Centre centre = centreOf(differences, triangle);
  const DoubleDoubleVector along = differences.between(from, to);
  const DoubleDoubleVector corner = differences.between(from, triangle.a);
  return signOf(cross(along, corner) * centre.divisor + cross(along, centre.offset));
}

Point bisectorOnSegment(const Point& p, const Point& q, const Point& from, const Point& to)
{
  Differences differences(from);
  differences.add(p);
  differences.add(q);
  differences.add(to);
  differences.scale();
  const DoubleDoubleVector along = differences.between(from, to);
  const DoubleDoubleVector apart = differences.between(p, q);
  const DoubleDoubleVector toP = differences.between(from, p);
  const DoubleDoubleVector toQ = differences.between(from, q);
  const DoubleDoubleVector twiceMiddle = { toP.x + toQ.x, toP.y + toQ.y };
  const DoubleDouble steep = scaled(dot(along, apart), 2.0);
  DoubleDouble part{ 0.5, 0.0 };
  if (signOf(steep) != 0)
  {
    part = dot(twiceMiddle, apart) / steep;
  }
  if (!(part.high > 0.0))
  {
    return from;
  }
  if (!(signOf(part - DoubleDouble{ 1.0, 0.0 }) < 0)) // its high part alone may be 1
  {
    return to;
  }
  const Point meets = differences.apply({ along.x * part, along.y * part });
  return { between(meets.x, from.x, to.x), between(meets.y, from.y, to.y) };
}

} // namespace ahd
