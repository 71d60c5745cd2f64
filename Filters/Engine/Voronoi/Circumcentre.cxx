// SPDX-License-Identifier: BSD-3-Clause
#include "Circumcentre.h"

#include "../Arithmetic/DoubleDouble.h"
#include "../Arithmetic/WideQuotient.h"
#include "../Arithmetic/WideVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

using namespace stages;

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

  /// Takes a point into account. All must be added before the first from().
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
    power_ = std::ldexp(1.0, back_);
  }

  DoubleDoubleVector between(const Point& from, const Point& to) const
  {
    return { one(to.x, from.x), one(to.y, from.y) };
  }

  /// A scaled number, unscaled; infinite if that overflows.
  double unscaled(double x) const
  {
    return std::isfinite(power_) ? x * power_ : std::ldexp(x, back_);
  }

  /// origin + v, unscaled and rounded.
  double added(double origin, const DoubleDouble& v) const
  {
    const double a = unscaled(v.high);
    const double b = unscaled(v.low);
    if (!std::isfinite(a))
    {
      return addedByHalves(origin, std::ldexp(v.high, back_ - 1), b);
    }
    const DoubleDouble sum = exactSum(origin, a);
    return std::isfinite(sum.low) ? sum.high + (sum.low + b) : origin + a;
  }

private:
  static double half(double a, double b) { return std::fabs(0.5 * a - 0.5 * b); }

  DoubleDouble one(double a, double b) const
  {
    const DoubleDouble d = exactDifference(before_ * a, before_ * b);
    return scaled(scaled(d, first_), second_);
  }

  /// origin + 2 half + rest: the way from one end of the range of double to the other is no double.
  static double addedByHalves(double origin, double half, double rest)
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
  double power_ = 1.0; ///< 2^back_, which may be infinite
};

/// The same for points whose differences need no scaling: areModest(). The results are the same, as
/// nothing underflows and powers of two are exact.
class ModestDifferences
{
public:
  static DoubleDoubleVector between(const Point& from, const Point& to)
  {
    return { exactDifference(to.x, from.x), exactDifference(to.y, from.y) };
  }
  static double unscaled(double x) { return x; }
  static double added(double origin, const DoubleDouble& v)
  {
    const DoubleDouble sum = exactSum(origin, v.high);
    return sum.high + (sum.low + v.low);
  }
};

/// Upper bound of the error of products and sums of scaled differences by underflow.
constexpr double kLost = 0x1p-1000;

/// A quotient to compute, and bounds on the errors of its parts.
struct Quotient
{
  DoubleDouble over;
  double overError;
  DoubleDouble under;
  double underError;
};

/// origin + quotient, unscaled and rounded once. False if the errors leave that open, or if it is
/// not finite.
///
/// The quotient is wrong by the errors of both parts, where those of second order are paid for by
/// twice as much, and by 2^-100 of itself; adding it and rounding the sum's low part, by less than
/// 2^-100 of it, and by 2^-1074 where its parts become subnormal.
template <typename Scale>
bool addedTo(double origin, const Quotient& quotient, const Scale& differences, double& result)
{
  const double size = std::fabs(quotient.under.high);
  if (!(quotient.underError <= 0x1p-20 * size))
  {
    return false;
  }
  const DoubleDouble value = quotient.over / quotient.under;
  const double way = std::fabs(value.high);
  const double error = 2.0 * (quotient.overError + way * quotient.underError) / size +
    0x1p-98 * way;
  result = differences.added(origin, value);
  // A unit in the last place is at least 2^-53 of the result.
  return std::isfinite(result) &&
    differences.unscaled(error) + 0x1p-1073 <= 0x1p-64 * std::fabs(result);
}

/// The terms of a 2x2 determinant or a scalar product, by their sizes.
double sizeOf(
  const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& c, const DoubleDouble& d)
{
  return std::fabs(a.high * b.high) + std::fabs(c.high * d.high);
}

/// circumcentre() with about 100 bits; false where these do not decide.
///
/// The sides of the triangle are exact. A product of two DoubleDoubles is wrong by less than 2^-103
/// of itself, a sum by 2^-104 of its operands: so the divisor by less than 2^-102 of the size of
/// its products, a squared length by as much of itself, and the offset by less than 2^-101.
template <typename Scale>
bool longCentre(const Corners& t, const Scale& differences, Point& result)
{
  const DoubleDoubleVector u = differences.between(t.a, t.b);
  const DoubleDoubleVector v = differences.between(t.a, t.c);
  const DoubleDouble uu = dot(u, u), vv = dot(v, v);
  const DoubleDouble divisor = scaled(cross(u, v), 2.0);
  const double divisorError = 0x1p-99 * sizeOf(u.x, v.y, u.y, v.x) + kLost;
  const auto coordinate = [&](double origin, const DoubleDouble& plus, const DoubleDouble& minus,
                            double size, double& where)
  {
    const Quotient quotient{ plus - minus, 0x1p-99 * size + kLost, divisor, divisorError };
    return addedTo(origin, quotient, differences, where);
  };
  return coordinate(t.a.x, uu * v.y, vv * u.y, sizeOf(uu, v.y, vv, u.y), result.x) &&
    coordinate(t.a.y, vv * u.x, uu * v.x, sizeOf(vv, u.x, uu, v.x), result.y);
}

Differences differencesIn(const Corners& t)
{
  Differences differences(t.a);
  differences.add(t.b);
  differences.add(t.c);
  differences.scale();
  return differences;
}

bool areModest(const Corners& t)
{
  return isModest(t.a) && isModest(t.b) && isModest(t.c);
}

/// A number in plain double precision, and a bound on its error.
struct Estimate
{
  double value;
  double error;
};

/// origin + offset, rounded to nearest. False if the error leaves that open.
bool roundedSum(double origin, const Estimate& offset, double& result)
{
  const DoubleDouble sum = exactSum(origin, offset.value);
  // The second term is for rounding here, and where circumcentre() adds with 100 bits.
  const double error = offset.error + 0x1p-100 * std::fabs(sum.high);
  result = sum.high + (sum.low - error);
  return error > 0.0 && result == sum.high + (sum.low + error);
}

/// circumcentre() in plain double precision, which nearly always suffices. False if not. @pre
/// areModest().
///
/// With e = 2^-53, the sides u and v of the triangle are known to 1 e of their coordinates, the
/// squares of their lengths to 4 e, a product of both kinds to 6 e, and a difference of two such
/// products to 7 e of the sum of their sizes; the divisor to 4 e of the sum of the sizes of its two
/// products. The constants below are larger for the rounding of the bounds themselves, and for the
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

} // namespace

/// The centre is a + offset / divisor, with divisor = 2 (u x v), u = b - a, v = c - a, and offset =
/// (|u|^2 v.y - |v|^2 u.y, |v|^2 u.x - |u|^2 v.x).
Point stages::circumcentreUnbounded(const Corners& t)
{
  const Unit unit{ &t.a, &t.b, &t.c };
  const WideVector u(unit, t.a, t.b), v(unit, t.a, t.c);
  const auto uu = dotUnbounded(u, u), vv = dotUnbounded(v, v);
  const auto half = crossUnbounded(u, v);
  const auto divisor = half + half;
  const auto x = unit.integer(t.a.x) * divisor + (uu * v.y - vv * u.y);
  const auto y = unit.integer(t.a.y) * divisor + (vv * u.x - uu * v.x);
  return { roundedQuotient(x, divisor, unit.exponent()),
    roundedQuotient(y, divisor, unit.exponent()) };
}

Point circumcentre(const Corners& triangle)
{
  Point result;
  const bool isKnown = areModest(triangle)
    ? quickCentre(triangle, result) || longCentre(triangle, ModestDifferences(), result)
    : longCentre(triangle, differencesIn(triangle), result);
  return isKnown ? result : stages::circumcentreUnbounded(triangle);
}

namespace
{

/// bisectorOnLine() with about 100 bits; false where these do not decide. With d the way along the
/// line and s that from p to q, it is from + d (2 middle . s) / (2 d . s), the middle seen from
/// `from`. Errors as in longCentre().
bool longBisector(const Point& p, const Point& q, const Line& line, Point& result)
{
  Differences differences(line.from);
  differences.add(p);
  differences.add(q);
  differences.add(line.to);
  differences.scale();
  const DoubleDoubleVector along = differences.between(line.from, line.to);
  const DoubleDoubleVector apart = differences.between(p, q);
  const DoubleDoubleVector toP = differences.between(line.from, p);
  const DoubleDoubleVector toQ = differences.between(line.from, q);
  const DoubleDouble over = dot({ toP.x + toQ.x, toP.y + toQ.y }, apart);
  const double overError = 0x1p-100 *
      (sizeOf(toP.x, apart.x, toP.y, apart.y) + sizeOf(toQ.x, apart.x, toQ.y, apart.y)) +
    kLost;
  const DoubleDouble under = scaled(dot(along, apart), 2.0);
  const double underError = 0x1p-99 * sizeOf(along.x, apart.x, along.y, apart.y) + kLost;
  const auto coordinate = [&](double from, double to, const DoubleDouble& way, double& where)
  {
    const double size = std::fabs(way.high);
    const Quotient quotient{ way * over,
      2.0 * size * overError + 0x1p-100 * size * std::fabs(over.high) + kLost, under, underError };
    where = from; // along a side of the box one of the coordinates is known
    return from == to || addedTo(from, quotient, differences, where);
  };
  return coordinate(line.from.x, line.to.x, along.x, result.x) &&
    coordinate(line.from.y, line.to.y, along.y, result.y);
}

} // namespace

/// As longBisector(); 2 middle . s is |q|^2 - |p|^2.
Point stages::bisectorUnbounded(const Point& p, const Point& q, const Line& line)
{
  const Unit unit{ &p, &q, &line.from, &line.to };
  const WideVector along(unit, line.from, line.to), apart(unit, p, q);
  const WideVector toP(unit, line.from, p), toQ(unit, line.from, q);
  const auto over = dotUnbounded(toQ, toQ) - dotUnbounded(toP, toP);
  const auto half = dotUnbounded(along, apart);
  const auto under = half + half;
  const auto x = unit.integer(line.from.x) * under + along.x * over;
  const auto y = unit.integer(line.from.y) * under + along.y * over;
  return { roundedQuotient(x, under, unit.exponent()), roundedQuotient(y, under, unit.exponent()) };
}

Point bisectorOnLine(const Point& p, const Point& q, const Line& line)
{
  Point result;
  return longBisector(p, q, line, result) ? result : stages::bisectorUnbounded(p, q, line);
}

} // namespace ahd
