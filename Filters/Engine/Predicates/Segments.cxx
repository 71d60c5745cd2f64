// SPDX-License-Identifier: BSD-3-Clause
#include "Segments.h"

#include "../Arithmetic/DoubleDouble.h"
#include "../Arithmetic/WideQuotient.h"
#include "../Arithmetic/WideVectors.h"
#include "Predicates.h"
#include "SegmentStages.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace ahd
{

using namespace stages;

namespace
{

// ------------------------------------------------------------------------------ heights at a line

// With O = orient2d(left, right, p) and D = right.x - left.x, a segment lies O / D below p. So s is
// above t by O_t / D_t - O_s / D_s, which has the sign of O_t D_s - O_s D_t.

/// The two products of O, and D, rounded.
struct Drop
{
  double product1;
  double product2;
  double width;

  Drop(const Segment& s, const Point& p)
    : product1((s.left.x - p.x) * (s.right.y - p.y))
    , product2((s.left.y - p.y) * (s.right.x - p.x))
    , width(s.right.x - s.left.x)
  {
  }
  double orient() const { return product1 - product2; }
  double size() const { return std::fabs(product1) + std::fabs(product2); }
};

} // namespace

/// Proof. Let u = 2^-53. A product in O has three roundings, O itself one more, D one, the product
/// O D one: each of the two terms is wrong by less than 6.01 u size() width. Their difference has
/// one more, as has the bound 4 of its own; 16 u pays for all. Underflow adds at most 2^-1074 to a
/// product, which is less than u / 2^10 of a size of 2^-1000; and where something overflows `bound`
/// does, or is NaN, and the comparison fails.
std::optional<int> stages::heightsByFilter(const Segment& s, const Segment& t, const Point& p)
{
  const Drop S(s, p), T(t, p);
  const double difference = T.orient() * S.width - S.orient() * T.width;
  const double sizeS = S.size(), sizeT = T.size();
  const double bound = sizeT * S.width + sizeS * T.width;
  constexpr double kSmall = 0x1p-1000;
  const bool underflows = sizeS < kSmall || sizeT < kSmall || bound < kSmall;
  if (!underflows && std::fabs(difference) > 16 * 0x1p-53 * bound)
  {
    return difference > 0.0 ? 1 : -1;
  }
  return std::nullopt;
}

int stages::heightsUnbounded(const Segment& s, const Segment& t, const Point& p)
{
  const Unit unit{ &s.left, &s.right, &t.left, &t.right, &p };
  const auto orient = [&](const Segment& segment)
  { return crossUnbounded(WideVector(unit, p, segment.left), WideVector(unit, p, segment.right)); };
  const auto width = [&](const Segment& segment)
  { return unit.difference(segment.right.x, segment.left.x); };
  return (orient(t) * width(s) - orient(s) * width(t)).sign();
}

namespace
{

// ------------------------------------------------------------------------------- what rounds to p

/// Twice how far the numbers that round to `value` reach, down and up.
struct Reach
{
  double down;
  double up;

  explicit Reach(double value)
    : down(value - std::nextafter(value, -std::numeric_limits<double>::infinity()))
    , up(std::nextafter(value, std::numeric_limits<double>::infinity()) - value)
  {
    down = std::isfinite(down) ? down : up;
    up = std::isfinite(up) ? up : down;
  }
};

} // namespace

/// With u = 2^-53, the computed determinant is wrong by less than 4.01 u times its size, the
/// threshold by less than 4 u of itself. A number that rounds to a value is at most u of it away,
/// and 2^-1075 where it is subnormal; `reach` is more than twice that.
bool stages::passesByFilter(const Segment& s, const Point& p)
{
  const auto reach = [](double value) { return 0x1p-52 * std::fabs(value) + 0x1p-1060; };
  const Drop drop(s, p);
  const double threshold = reach(p.x) * std::fabs(s.right.y - s.left.y) + reach(p.y) * drop.width;
  const double bound = threshold + 8 * 0x1p-53 * drop.size();
  return drop.size() > 0x1p-1000 && threshold > 0x1p-1000 && std::fabs(drop.orient()) > bound;
}

// The points that round to p form a rectangle, of which the interior counts. Of its corners, those
// to the upper left and to the lower right are farthest from a line that rises; cross(corner -
// s.left, s.right - s.left) is negative above the line and positive below.
bool stages::meetsUnbounded(const Segment& s, const Point& p)
{
  const Reach x(p.x), y(p.y);
  const Point downs{ x.down, y.down }, ups{ x.up, y.up };
  const Unit unit{ &s.left, &s.right, &p, &downs, &ups };
  const WideVector way(unit, s.left, s.right);
  const bool rises = !way.y.negative;
  const auto atP = crossUnbounded(WideVector(unit, s.left, p), way);
  const auto below = way.y * unit.integer(rises ? x.up : -x.down) + way.x * unit.integer(y.down);
  const auto above = way.y * unit.integer(rises ? x.down : -x.up) + way.x * unit.integer(y.up);
  return (atP + atP + below).sign() > 0 && (atP + atP - above).sign() < 0;
}

bool roundsTo(const Segment& s, const Point& p)
{
  const double low = std::min(s.left.y, s.right.y), high = std::max(s.left.y, s.right.y);
  const bool isInBox = s.left.x <= p.x && p.x <= s.right.x && low <= p.y && p.y <= high;
  if (!isInBox || p == s.left || p == s.right)
  {
    return false;
  }
  return !passesByFilter(s, p) && meetsUnbounded(s, p);
}

int orderAt(const Segment& s, int sideOfS, const Segment& t, int sideOfT, const Point& p)
{
  if (sideOfS != sideOfT)
  {
    return sideOfS < sideOfT ? 1 : -1;
  }
  if (sideOfS == 0)
  {
    return 0;
  }
  // Neither is vertical.
  const std::optional<int> filtered = heightsByFilter(s, t, p);
  const int heights = filtered ? *filtered : heightsUnbounded(s, t, p);
  if (heights != 0)
  {
    return heights;
  }
  // They meet above p or below it, which the line of p passes to the left of or to the right of.
  const int steeper = steepness(
    orient2d(t.left, t.right, s.left), orient2d(t.left, t.right, s.right));
  return sideOfS < 0 ? -steeper : steeper;
}

namespace
{

/// A number that differs from the true one by less than `error`.
struct Approximation
{
  DoubleDouble value;
  double error;
};

/// The cross product of two vectors; twice as much is allowed as its roundings add up to.
Approximation approximateCross(const DoubleDoubleVector& a, const DoubleDoubleVector& b)
{
  const double size = std::fabs(a.x.high * b.y.high) + std::fabs(a.y.high * b.x.high);
  return { cross(a, b), 0x1p-100 * size };
}

DoubleDoubleVector wayBetween(const Point& from, const Point& to)
{
  return { exactDifference(to.x, from.x), exactDifference(to.y, from.y) };
}

/// The double to which all numbers within the error of a + b c round; `errorOfC` is the error of c,
/// which is at most 1. None if there is no such double, or it is tiny.
std::optional<double> roundedSum(
  double a, const DoubleDouble& b, const DoubleDouble& c, double errorOfC)
{
  const DoubleDouble sum = DoubleDouble{ a, 0.0 } + b * c;
  const double way = std::fabs(b.high);
  const double error = way * errorOfC + 0x1p-99 * (std::fabs(a) + way);
  const double low = sum.high + (sum.low - error), high = sum.high + (sum.low + error);
  return low == high && std::fabs(low) > 0x1p-800 ? std::optional<double>(low) : std::nullopt;
}

} // namespace

// With u, v the vectors along s and t, and w that from s.left to t.left, they meet at
// s.left + u (w x v) / (u x v).

/// Proof. The vectors are exact. A product of two DoubleDoubles is wrong by less than 2^-103 of
/// itself, a sum by 2^-104 of its operands: so a cross product by less than 2^-102 of its size, and
/// what is added for underflow, at most 2^-1000, is negligible beside 2^-100 of a size above
/// 2^-700. The quotient is at most 1, as they cross; it is wrong by the errors of both cross
/// products over `whole`, and by 2^-100 of itself: twice as much is allowed, which pays for terms
/// of second order, as these errors are below 2^-20 of `whole`. Sum and product in roundedSum are
/// wrong by less than 2^-102 of |a| + |b|, rounding the sum's low part by less than 2^-105 of it.
std::optional<Point> stages::crossingByFilter(const Segment& s, const Segment& t)
{
  const DoubleDoubleVector u = wayBetween(s.left, s.right), v = wayBetween(t.left, t.right);
  const DoubleDoubleVector w = wayBetween(s.left, t.left);
  const Approximation along = approximateCross(w, v), whole = approximateCross(u, v);
  const double size = std::fabs(whole.value.high), error = along.error + whole.error;
  constexpr double kSmall = 0x1p-800, kLarge = 0x1p400;
  if (!(along.error > kSmall && whole.error > kSmall && error < 0x1p-20 * size && size < kLarge &&
        error < kLarge))
  {
    return std::nullopt;
  }
  const DoubleDouble quotient = along.value / whole.value;
  const double errorOfQuotient = 2.0 * error / size + 0x1p-98;
  const std::optional<double> x = roundedSum(s.left.x, u.x, quotient, errorOfQuotient);
  const std::optional<double> y = roundedSum(s.left.y, u.y, quotient, errorOfQuotient);
  return x && y ? std::optional<Point>(Point{ *x, *y }) : std::nullopt;
}

Point stages::crossingUnbounded(const Segment& s, const Segment& t)
{
  const Unit unit{ &s.left, &s.right, &t.left, &t.right };
  const WideVector u(unit, s.left, s.right), v(unit, t.left, t.right), w(unit, s.left, t.left);
  const auto along = crossUnbounded(w, v);
  const auto whole = crossUnbounded(u, v);
  const auto coordinate = [&](double from, const Difference& way)
  { return roundedQuotient(whole * unit.integer(from) + along * way, whole, unit.exponent()); };
  return { coordinate(s.left.x, u.x), coordinate(s.left.y, u.y) };
}

Point crossingOf(const Segment& s, const Segment& t)
{
  const std::optional<Point> filtered = crossingByFilter(s, t);
  return filtered ? *filtered : crossingUnbounded(s, t);
}

double fractionOfWay(const Point& from, const Point& to, const Point& p)
{
  // Where a difference overflows, that of the halves does not.
  const bool overflows = !std::isfinite(to.x - from.x) || !std::isfinite(to.y - from.y);
  const auto way = [&](double a, double b) { return overflows ? 0.5 * b - 0.5 * a : b - a; };
  const double x = way(from.x, to.x), y = way(from.y, to.y);
  const bool byX = std::fabs(x) >= std::fabs(y);
  const double fraction = byX ? way(from.x, p.x) / x : way(from.y, p.y) / y;
  return std::min(1.0, std::max(0.0, fraction));
}

} // namespace ahd
