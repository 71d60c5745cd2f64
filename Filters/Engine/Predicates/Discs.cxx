// SPDX-License-Identifier: BSD-3-Clause
#include "Discs.h"

#include "../Arithmetic/WideVectors.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace ahd
{

// With u = b - a and v = c - a the circumcentre is a + offset / divisor, where divisor = 2 (u x v),
// which is positive, and offset = (|u|^2 v.y - |v|^2 u.y, |v|^2 u.x - |u|^2 v.x). So the radius
// times the divisor is |offset|. A box leaves the centre on its left by (xmin - a.x) divisor -
// offset.x, times the divisor, where that is positive, on its right by offset.x - (xmax - a.x)
// divisor, and so on. With p and q the larger of these and 0, in x and in y, the disc meets the box
// if and only if p^2 + q^2 <= |offset|^2.

namespace
{

/// A power of two that scales a number of this size to [1, 2), or towards it. 0 for the largest
/// numbers, infinity and NaN.
double scaleFor(double size)
{
  std::uint64_t bits;
  std::memcpy(&bits, &size, sizeof bits);
  const std::uint64_t biased = bits >> 52 & 0x7FF;
  bits = biased >= 2046 ? 0 : (2046 - biased) << 52;
  double scale;
  std::memcpy(&scale, &bits, sizeof scale);
  return scale;
}

constexpr double kRoundoff = 0x1p-53;
/// Above any effect of underflow; see meetsByFilter.
constexpr double kGuard = 0x1p-500;

} // namespace

Circumdisc::Circumdisc(const Corners& triangle)
  : triangle_(triangle)
{
  const Point& a = triangle.a;
  double ux = triangle.b.x - a.x, uy = triangle.b.y - a.y;
  double vx = triangle.c.x - a.x, vy = triangle.c.y - a.y;
  scale_ = scaleFor(
    std::max(std::max(std::fabs(ux), std::fabs(uy)), std::max(std::fabs(vx), std::fabs(vy))));
  ux *= scale_;
  uy *= scale_;
  vx *= scale_;
  vy *= scale_;
  const double uu = ux * ux + uy * uy, vv = vx * vx + vy * vy;
  const double left = ux * vy, right = uy * vx;
  const double x1 = uu * vy, x2 = vv * uy, y1 = vv * ux, y2 = uu * vx;
  x_ = x1 - x2;
  y_ = y1 - y2;
  divisor_ = 2.0 * (left - right);
  radius_ = std::sqrt(x_ * x_ + y_ * y_);
  sizeOfDivisor_ = 2.0 * (std::fabs(left) + std::fabs(right));
  sizeOfOffset_ = (std::fabs(x1) + std::fabs(x2)) + (std::fabs(y1) + std::fabs(y2));
}

/// Proof. Let e = 2^-53, and let all numbers be the scaled ones. Without underflow first.
/// 1. Coordinates of u, v and of the ways w from a to the sides of the box are known to 1 e,
///    relatively. So are, to 3 e, products of two, each of x1, x2, y1, y2 to 7 e (a square 3 e,
///    their sum 4 e, times a coordinate 6 e, second order 7 e), x_ and y_ to 8 e of the sum of the
///    two sizes, and the divisor to 4 e of its size.
/// 2. radius_: |(x, y)| moves by no more than x and y do, 8 e sizeOfOffset_ in all; its own
/// roundings
///    add 3 e |(x_, y_)|, which is at most 3 e sizeOfOffset_: 12 e sizeOfOffset_.
/// 3. w divisor: 4 e for the divisor, 1 e for w, 1 e for the product: 7 e |w| sizeOfDivisor_. Less
///    x_, and rounded once more: p is known to 8 e |w| sizeOfDivisor_ + 10 e sizeOfOffset_, and so
///    is the larger of several of this kind, and of 0.
/// 4. |(p, q)| moves by no more than p and q do, and its own roundings add 3 e (p + q), where p + q
///    is at most the sum of |w| sizeOfDivisor_ and sizeOfOffset_ each: 12 e (|w.x| + |w.y|)
///    sizeOfDivisor_ + 24 e sizeOfOffset_. Less radius_: 13 e and 38 e. 64 e for either pays for
///    terms of second order, for what the sizes have lost, and for the rounding of the bound.
/// 5. Underflow: scaling adds at most 2^-1075 to a coordinate, and a product 2^-1075 more, where
/// the
///    others in its term are below 2^8, or 2^400 for w. This is below 2^-660 in p, q and radius_,
///    but for the square roots: where squares underflow, the root of their sum is wrong by less
///    than 2^-530. So a margin below 2^-500 is not certain.
/// 6. Overflow: scale_ is 0 if coordinates of u or v are 2^1023 or more: then sizes are 0 or NaN,
/// and
///    nothing exceeds the bound. Else u and v are below 2, sizes below 2^8, and with sizeOfWays
///    below 2^400 nothing overflows.
std::optional<bool> Circumdisc::meetsByFilter(const Bounds& box) const
{
  const Point& a = triangle_.a;
  const double x1 = (box.xmin - a.x) * scale_, x2 = (box.xmax - a.x) * scale_;
  const double y1 = (box.ymin - a.y) * scale_, y2 = (box.ymax - a.y) * scale_;
  const double sizeOfWays = std::max(std::fabs(x1), std::fabs(x2)) +
    std::max(std::fabs(y1), std::fabs(y2));
  const double p = std::max(0.0, std::max(x1 * divisor_ - x_, x_ - x2 * divisor_));
  const double q = std::max(0.0, std::max(y1 * divisor_ - y_, y_ - y2 * divisor_));
  const double gap = std::sqrt(p * p + q * q) - radius_;
  const double bound = 64 * kRoundoff * (sizeOfWays * sizeOfDivisor_ + sizeOfOffset_);
  const bool isCertain = sizeOfWays < 0x1p400 && std::fabs(gap) > bound + kGuard;
  return isCertain ? std::optional<bool>(gap < 0.0) : std::nullopt;
}

/// As above: each of the four distances is known to 8 e |w| sizeOfDivisor_ + 10 e sizeOfOffset_.
bool Circumdisc::isCertainlyWithin(const Bounds& box) const
{
  const auto isBefore = [&](double line, double way, double offset)
  {
    const double scaled = way * scale_;
    const double room = scaled * divisor_ - offset - radius_;
    const double bound = 64 * kRoundoff * (std::fabs(scaled) * sizeOfDivisor_ + sizeOfOffset_);
    return std::isinf(line) || (std::fabs(scaled) < 0x1p400 && room > bound + kGuard);
  };
  const Point& a = triangle_.a;
  return isBefore(box.xmax, box.xmax - a.x, x_) && isBefore(box.xmin, a.x - box.xmin, -x_) &&
    isBefore(box.ymax, box.ymax - a.y, y_) && isBefore(box.ymin, a.y - box.ymin, -y_);
}

bool Circumdisc::meets(const Bounds& box) const
{
  const std::optional<bool> answer = meetsByFilter(box);
  return answer ? *answer : stages::discMeetsUnbounded(triangle_, box);
}

namespace
{

using stages::Difference;
using Sum = decltype(stages::dotUnbounded(
  std::declval<stages::WideVector>(), std::declval<stages::WideVector>()));
using Offset = decltype(std::declval<Sum>() * std::declval<Difference>() -
  std::declval<Sum>() * std::declval<Difference>());
using Divisor = decltype(std::declval<Sum>() + std::declval<Sum>());
using Way = decltype(std::declval<Difference>() * std::declval<Divisor>());
using Excess = decltype(std::declval<Way>() *
  (std::declval<Way>() - (std::declval<Offset>() + std::declval<Offset>())));

/// p^2 - offset^2 of one coordinate: with w the way to the side of the box that is next to the
/// centre, (w divisor - offset)^2 - offset^2. `toLow`, `toHigh`: from corner a to the sides.
Excess excess(
  const Difference& toLow, const Difference& toHigh, const Offset& offset, const Divisor& divisor)
{
  const Way low = toLow * divisor;
  if ((low - offset).sign() > 0)
  {
    return low * (low - (offset + offset));
  }
  const Way high = toHigh * divisor;
  if ((offset - high).sign() > 0)
  {
    return high * (high - (offset + offset));
  }
  const decltype(offset + offset) zero;
  const Way same = offset;
  return same * (zero - offset);
}

} // namespace

bool stages::discMeetsUnbounded(const Corners& triangle, const Bounds& box)
{
  const Point low{ box.xmin, box.ymin }, high{ box.xmax, box.ymax };
  const Unit unit{ &triangle.a, &triangle.b, &triangle.c, &low, &high };
  const WideVector u(unit, triangle.a, triangle.b), v(unit, triangle.a, triangle.c);
  const WideVector toLow(unit, triangle.a, low), toHigh(unit, triangle.a, high);
  const Sum uu = dotUnbounded(u, u), vv = dotUnbounded(v, v), half = crossUnbounded(u, v);
  const Divisor divisor = half + half;
  const Offset x = uu * v.y - vv * u.y, y = vv * u.x - uu * v.x;
  return (excess(toLow.x, toHigh.x, x, divisor) + excess(toLow.y, toHigh.y, y, divisor)).sign() <=
    0;
}

/// Two convex sets are apart if and only if a line along an edge of one of them parts them, or
/// along the segment: the edges of their Minkowski difference have these directions.
bool touches(const Corners& triangle, const Point& p, const Point& q)
{
  const Point& a = triangle.a;
  const Point& b = triangle.b;
  const Point& c = triangle.c;
  const auto isBeside = [](double low, double high, double r, double s, double t)
  { return (r < low && s < low && t < low) || (r > high && s > high && t > high); };
  if (isBeside(std::min(p.x, q.x), std::max(p.x, q.x), a.x, b.x, c.x) ||
    isBeside(std::min(p.y, q.y), std::max(p.y, q.y), a.y, b.y, c.y))
  {
    return false;
  }
  const auto isBeyond = [&](const Point& from, const Point& to)
  { return orient2d(from, to, p) < 0 && orient2d(from, to, q) < 0; };
  const int side = p == q ? 0 : orient2d(p, q, a);
  const bool isOnOneSide = side != 0 && orient2d(p, q, b) == side && orient2d(p, q, c) == side;
  return !isOnOneSide && !isBeyond(a, b) && !isBeyond(b, c) && !isBeyond(c, a);
}

} // namespace ahd
