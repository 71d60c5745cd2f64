// SPDX-License-Identifier: BSD-3-Clause
#include "Weights.h"

#include "../Arithmetic/DoubleDouble.h"
#include "../Arithmetic/WideQuotient.h"
#include "../Arithmetic/WideVectors.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace ahd
{

namespace
{

/// The power of two that makes the larger extent of the points about 1, as far as doubles reach.
double unitScale(std::initializer_list<Point> points)
{
  Point low = *points.begin(), high = low;
  for (const Point& p : points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y) };
  }
  // Of quarters, so that nothing overflows.
  const double extent = std::max(0.25 * high.x - 0.25 * low.x, 0.25 * high.y - 0.25 * low.y);
  int exponent = 0;
  std::frexp(std::max(extent, 0x1p-1000), &exponent);
  return std::ldexp(1.0, -std::max(exponent + 2, -1000));
}

/// A coordinate that both ends of an edge share may be so much larger than the edge is long that it
/// overflows; those that differ are at most 2^53 times as large as their difference.
double scaledDifference(double a, double b, double scale)
{
  return a == b ? 0.0 : a * scale - b * scale;
}

DoubleDoubleVector between(const Point& from, const Point& to, double scale)
{
  return { exactDifference(to.x * scale, from.x * scale),
    exactDifference(to.y * scale, from.y * scale) };
}

/// Each area exactly, and its part of all, rounded once.
void exactWeights(
  const Point& a, const Point& b, const Point& c, const Point& p, double (&weights)[3])
{
  using namespace stages;
  const Unit unit{ &a, &b, &c, &p };
  const WideVector A(unit, p, a), B(unit, p, b), C(unit, p, c);
  const auto all = crossUnbounded(WideVector(unit, a, b), WideVector(unit, a, c));
  weights[0] = roundedQuotient(crossUnbounded(B, C), all, 0);
  weights[1] = roundedQuotient(crossUnbounded(C, A), all, 0);
  weights[2] = roundedQuotient(crossUnbounded(A, B), all, 0);
}

/// Areas in units of the longest edge's square below this are not worth 40 bits, of 100.
constexpr double kLeastArea = 0x1p-50;

/// A power of two that values are multiplied by, so that neither products of them nor those that
/// are taken of them for their rounding overflow, nor what is left of differences underflows.
double powerFor(std::initializer_list<double> values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = std::max(largest, std::fabs(value));
  }
  const bool isSmall = largest > 0.0 && largest < 0x1p-400;
  return largest > 0x1p400 ? 0x1p-700 : isSmall ? 0x1p700 : 1.0;
}

/// From a slope of values times `power` in coordinates times `scale`, both powers of two. What is
/// between them may overflow or underflow where the slope does not.
Point scaledSlope(const Point& slope, double scale, double power)
{
  if (power == 1.0)
  {
    return { slope.x * scale, slope.y * scale };
  }
  const int exponent = std::ilogb(scale) - std::ilogb(power);
  return { std::ldexp(slope.x, exponent), std::ldexp(slope.y, exponent) };
}

/// Numerators and area exactly; each quotient is rounded once.
Point exactSlope(const Point& a, const Point& b, const Point& c, const double (&value)[3])
{
  using namespace stages;
  if (!std::isfinite(value[0]) || !std::isfinite(value[1]) || !std::isfinite(value[2]))
  {
    return { kNaN, kNaN };
  }
  const Unit unit{ &a, &b, &c };
  const auto area = crossUnbounded(WideVector(unit, a, b), WideVector(unit, a, c));
  // The differences of both edges, as vectors: of values, of x and of y.
  const Point from{ value[0], value[0] }, to{ value[1], value[2] };
  const Unit unitOfValues{ &from, &to };
  const WideVector rise(unitOfValues, from, to);
  const WideVector x(unit, { a.x, a.x }, { b.x, c.x }), y(unit, { a.y, a.y }, { b.y, c.y });
  const int exponent = unitOfValues.exponent() - unit.exponent();
  return { roundedQuotient(crossUnbounded(rise, y), area, exponent),
    roundedQuotient(crossUnbounded(x, rise), area, exponent) };
}

} // namespace

void hardWeights(
  const Point& a, const Point& b, const Point& c, const Point& p, double (&weights)[3])
{
  const double scale = unitScale({ a, b, c });
  const DoubleDoubleVector A = between(p, a, scale), B = between(p, b, scale),
                           C = between(p, c, scale);
  const DoubleDouble u = cross(B, C), v = cross(C, A), w = cross(A, B);
  const double all = (u + v + w).value();
  if (!(all > kLeastArea))
  {
    exactWeights(a, b, c, p, weights);
    return;
  }
  weights[0] = std::max(0.0, u.value() / all);
  weights[1] = std::max(0.0, v.value() / all);
  weights[2] = std::max(0.0, w.value() / all);
}

void edgeWeights(const Point& a, const Point& b, const Point& p, double (&weights)[2])
{
  const double scale = unitScale({ a, b });
  const double x = scaledDifference(b.x, a.x, scale), y = scaledDifference(b.y, a.y, scale);
  if (std::fabs(x) >= std::fabs(y))
  {
    weights[0] = (b.x * scale - p.x * scale) / x;
    weights[1] = (p.x * scale - a.x * scale) / x;
  }
  else
  {
    weights[0] = (b.y * scale - p.y * scale) / y;
    weights[1] = (p.y * scale - a.y * scale) / y;
  }
}

void footWeights(const Point& a, const Point& b, const Point& p, double (&weights)[2])
{
  constexpr double kFar = 0x1p40; // in lengths of the edge: 60 bits are left
  const double scale = unitScale({ a, b });
  if (std::max(std::fabs(0.5 * p.x - 0.5 * a.x), std::fabs(0.5 * p.y - 0.5 * a.y)) * scale < kFar)
  {
    const DoubleDoubleVector way = between(a, b, scale), back = between(b, a, scale);
    const DoubleDouble square = dot(way, way);
    weights[0] = std::max(0.0, (dot(between(b, p, scale), back) / square).value());
    weights[1] = std::max(0.0, (dot(between(a, p, scale), way) / square).value());
    return;
  }
  using namespace stages;
  const Unit unit{ &a, &b, &p };
  const WideVector way(unit, a, b), back(unit, b, a);
  const auto square = dotUnbounded(way, way);
  weights[0] = roundedQuotient(dotUnbounded(WideVector(unit, b, p), back), square, 0);
  weights[1] = roundedQuotient(dotUnbounded(WideVector(unit, a, p), way), square, 0);
}

Point slopeIn(const Point& a, const Point& b, const Point& c, const double (&value)[3])
{
  const double scale = unitScale({ a, b, c });
  const DoubleDoubleVector U = between(a, b, scale), V = between(a, c, scale);
  const double area = cross(U, V).value();
  if (!(area > kLeastArea))
  {
    return exactSlope(a, b, c, value);
  }
  const double power = powerFor({ value[0], value[1], value[2] });
  const DoubleDouble u = exactDifference(value[1] * power, value[0] * power);
  const DoubleDouble v = exactDifference(value[2] * power, value[0] * power);
  const double x = (u * V.y - v * U.y).value(), y = (v * U.x - u * V.x).value();
  return scaledSlope({ x / area, y / area }, scale, power);
}

Point slopeAlong(const Point& a, const Point& b, double atA, double atB)
{
  const double scale = unitScale({ a, b });
  const double x = scaledDifference(b.x, a.x, scale), y = scaledDifference(b.y, a.y, scale);
  const double power = powerFor({ atA, atB });
  const double rise = (atB * power - atA * power) / (x * x + y * y);
  return scaledSlope({ x * rise, y * rise }, scale, power);
}

} // namespace ahd
