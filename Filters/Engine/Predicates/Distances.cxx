// SPDX-License-Identifier: BSD-3-Clause
#include "Distances.h"

#include "../Arithmetic/WideVectors.h"
#include "Circles.h"

#include <algorithm>
#include <cmath>

namespace ahd
{

using namespace stages;

namespace
{

/// Numbers that a squared distance lies between.
struct Interval
{
  double low = -HUGE_VAL, high = HUGE_VAL;
};

/// From `low` to `high`, each but for some roundings, and for what underflow takes.
Interval around(double low, double high, double rounding)
{
  constexpr double kUnit = 0x1p-53, kGuard = 0x1p-560;
  return { low * (1.0 - rounding * kUnit) - kGuard, high * (1.0 + rounding * kUnit) + kGuard };
}

/// The squared distance from the point of a segment that is nearest to a place.
///
/// Proof. Let u = 2^-53. A squared length v is known to 4 u, so it lies between v (1 - 8 u) and
/// v (1 + 8 u). From a place between the ends the distance is c / l, where c is a cross product,
/// known to 4.01 u of the sum of the sizes of its products, and l the length. 8 u of that sum pays
/// for the rounding of the bound, 16 u for that of square, quotient and l. Underflow adds at most
/// 2^-1072 to c, v and the square of c; with l^2 above 2^-500 less than 2^-570 to the quotient.
/// Where something may overflow, nothing is known.
Interval squaredDistance(const Segment& s, const Point& p)
{
  constexpr double kUnit = 0x1p-53;
  const NearestPart part = nearestPartOf(s, p);
  if (part != NearestPart::Inside)
  {
    const Point& end = part == NearestPart::Left ? s.left : s.right;
    const double x = end.x - p.x, y = end.y - p.y, v = x * x + y * y;
    return v < 0x1p1000 ? around(v, v, 8.0) : Interval();
  }
  const double x = s.right.x - s.left.x, y = s.right.y - s.left.y;
  const double first = x * (p.y - s.left.y), second = y * (p.x - s.left.x);
  const double c = std::fabs(first - second), length = x * x + y * y;
  const double error = 8.0 * kUnit * (std::fabs(first) + std::fabs(second)) + 0x1p-1060;
  const double low = std::max(0.0, c - error), high = c + error;
  const bool isModest = length > 0x1p-500 && length < 0x1p1000 && high < 0x1p500;
  return isModest ? around(low * low / length, high * high / length, 16.0) : Interval();
}

constexpr int kWords = (1024 + 1074 + 63) / 64 + 1;
/// A squared distance: a quotient of integers, in units squared.
struct Fraction
{
  WideInteger<4 * kWords + 2> over;
  WideInteger<2 * kWords + 1> under;
};

Fraction exactSquaredDistance(const Segment& s, const Point& p, const Unit& unit)
{
  const NearestPart part = nearestPartOf(s, p);
  Fraction result;
  if (part == NearestPart::Inside)
  {
    const WideVector way(unit, s.left, s.right);
    const auto c = crossUnbounded(way, WideVector(unit, s.left, p));
    multiply(c, c, result.over);
    result.under = dotUnbounded(way, way);
    return result;
  }
  const WideVector way(unit, part == NearestPart::Left ? s.left : s.right, p);
  result.under.push(1);
  multiply(dotUnbounded(way, way), result.under, result.over);
  return result;
}

/// The end that is nearest to a place; null if none is.
const Point* nearestEnd(const Segment& s, const Point& place)
{
  const NearestPart part = nearestPartOf(s, place);
  return part == NearestPart::Inside ? nullptr : part == NearestPart::Left ? &s.left : &s.right;
}

} // namespace

NearestPart nearestPartOf(const Segment& s, const Point& place)
{
  return acuteness(place, s.left, s.right) <= 0 ? NearestPart::Left
    : acuteness(place, s.right, s.left) <= 0    ? NearestPart::Right
                                                : NearestPart::Inside;
}

std::optional<int> stages::nearerByFilter(const Segment& s, const Segment& t, const Point& place)
{
  const Interval ofS = squaredDistance(s, place), ofT = squaredDistance(t, place);
  return ofS.high < ofT.low ? std::optional<int>(1)
    : ofT.high < ofS.low    ? std::optional<int>(-1)
                            : std::nullopt;
}

int stages::nearerUnbounded(const Segment& s, const Segment& t, const Point& place)
{
  const Unit unit{ &s.left, &s.right, &t.left, &t.right, &place };
  const Fraction ofS = exactSquaredDistance(s, place, unit);
  const Fraction ofT = exactSquaredDistance(t, place, unit);
  return (ofT.over * ofS.under - ofS.over * ofT.under).sign();
}

/// At a corner of a rim the nearest place is mostly the vertex that both edges have.
int nearerOf(const Segment& s, const Segment& t, const Point& place)
{
  const std::optional<int> sign = nearerByFilter(s, t, place);
  if (sign)
  {
    return *sign;
  }
  const Point *ofS = nearestEnd(s, place), *ofT = nearestEnd(t, place);
  return ofS && ofT && *ofS == *ofT ? 0 : nearerUnbounded(s, t, place);
}

double roundingAt(double largest)
{
  constexpr double kUnits = 16.0;
  constexpr int kPrecision = 52, kLeast = -1022;
  return std::ldexp(
    kUnits, std::max(largest > 0.0 ? std::ilogb(largest) : kLeast, kLeast) - kPrecision);
}

double roundingAt(const Segment& s, const Point& place)
{
  double largest = 0.0;
  for (const Point& p : { s.left, s.right, place })
  {
    largest = std::max({ largest, std::fabs(p.x), std::fabs(p.y) });
  }
  return roundingAt(largest);
}

std::optional<bool> stages::withinByFilter(const Segment& s, double distance, const Point& place)
{
  const double squared = distance * distance;
  if (!(squared > 0x1p-900 && squared < 0x1p900))
  {
    return std::nullopt;
  }
  const Interval found = squaredDistance(s, place);
  constexpr double kRounding = 0x1p-50; // of the square
  return found.high < squared * (1.0 - kRounding) ? std::optional<bool>(true)
    : found.low > squared * (1.0 + kRounding)     ? std::optional<bool>(false)
                                                  : std::nullopt;
}

bool stages::withinUnbounded(const Segment& s, double distance, const Point& place)
{
  const Point limit{ distance, distance };
  const Unit unit{ &s.left, &s.right, &place, &limit };
  const Fraction found = exactSquaredDistance(s, place, unit);
  const auto most = unit.integer(distance);
  return (most * most * found.under - found.over).sign() >= 0;
}

bool isWithin(const Segment& s, double distance, const Point& place)
{
  const std::optional<bool> filtered = withinByFilter(s, distance, place);
  return filtered ? *filtered : withinUnbounded(s, distance, place);
}

} // namespace ahd
