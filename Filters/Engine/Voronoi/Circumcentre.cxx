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

/// The nearest number to `value` from a to b.
double between(double value, double a, double b)
{
  return std::min(std::max(value, std::min(a, b)), std::max(a, b));
}

} // namespace

Point circumcentre(const Corners& triangle)
{
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
