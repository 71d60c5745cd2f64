// SPDX-License-Identifier: BSD-3-Clause
#include "Circles.h"

#include "../Arithmetic/WideVectors.h"

#include <cmath>

namespace ahd
{

namespace
{

/// A vector whose coordinates have been rounded once.
struct Way
{
  Way(const Point& from, const Point& to)
    : x(to.x - from.x)
    , y(to.y - from.y)
  {
  }
  double squared() const { return x * x + y * y; }
  double size() const { return std::fabs(x) + std::fabs(y); }
  double x, y;
};

/// The sign of `value`, if that is farther from 0 than `bound`; for NaN none.
std::optional<int> certainSign(double value, double bound)
{
  return std::fabs(value) > bound ? std::optional<int>(value > 0.0 ? 1 : -1) : std::nullopt;
}

} // namespace

// With u = b - a and v = c - a, the circumcentre is a + offset / divisor, where divisor = 2 (u x
// v), which is positive, and offset = (|u|^2 v.y - |v|^2 u.y, |v|^2 u.x - |u|^2 v.x). So with d the
// way from `from` to `to`, the side is the sign of (d x (a - from)) divisor + d x offset.

/// Proof. Let e = 2^-53. The coordinates of ways are known to 1 e, their products to 3 e, a cross
/// product and a squared length to 4 e of the sum of the sizes of their products, a product of
/// three coordinates in the offset to 7 e, the offset to 8 e of that sum, the terms of the whole to
/// 10 e, and the whole to 12 e of the sum of their sizes; 16 e pays for terms of second order and
/// for the rounding of the bound. Underflow adds at most 2^-1074 to a product, in the whole times
/// two more coordinates at most: with these below 2^200, less than 2^-660, which is negligible
/// beside e times a bound above 2^-580.
std::optional<int> stages::sideByFilter(const Corners& triangle, const Point& from, const Point& to)
{
  const Way u(triangle.a, triangle.b), v(triangle.a, triangle.c);
  const Way d(from, to), w(from, triangle.a);
  const double uu = u.squared(), vv = v.squared();
  const double divisor = 2.0 * (u.x * v.y - u.y * v.x);
  const double x = uu * v.y - vv * u.y, y = vv * u.x - uu * v.x;
  const double whole = (d.x * w.y - d.y * w.x) * divisor + (d.x * y - d.y * x);
  const double sizeOfDivisor = 2.0 * (std::fabs(u.x * v.y) + std::fabs(u.y * v.x));
  const double sizeOfX = uu * std::fabs(v.y) + vv * std::fabs(u.y);
  const double sizeOfY = vv * std::fabs(u.x) + uu * std::fabs(v.x);
  const double size = (std::fabs(d.x * w.y) + std::fabs(d.y * w.x)) * sizeOfDivisor +
    std::fabs(d.x) * sizeOfY + std::fabs(d.y) * sizeOfX;
  constexpr double kLarge = 0x1p200, kSmall = 0x1p-580;
  const bool isModest = u.size() + v.size() + d.size() + w.size() < kLarge && size > kSmall;
  return isModest ? certainSign(whole, 16 * 0x1p-53 * size) : std::nullopt;
}

int stages::sideUnbounded(const Corners& triangle, const Point& from, const Point& to)
{
  const Unit unit{ &triangle.a, &triangle.b, &triangle.c, &from, &to };
  const WideVector u(unit, triangle.a, triangle.b), v(unit, triangle.a, triangle.c);
  const WideVector d(unit, from, to), w(unit, from, triangle.a);
  const auto uu = dotUnbounded(u, u), vv = dotUnbounded(v, v);
  const auto half = crossUnbounded(u, v);
  const auto x = uu * v.y - vv * u.y, y = vv * u.x - uu * v.x;
  return (crossUnbounded(d, w) * (half + half) + (d.x * y - d.y * x)).sign();
}

int sideOfCircumcentre(const Corners& triangle, const Point& from, const Point& to)
{
  const std::optional<int> sign = stages::sideByFilter(triangle, from, to);
  return sign ? *sign : stages::sideUnbounded(triangle, from, to);
}

/// Proof. The squares are known to 3 e, their sums to 4 e, and the difference to 5 e of the sum of
/// all; 8 e pays for the rest. Underflow adds less than 2^-1072, which is negligible beside e times
/// a sum above 2^-1000. Where something overflows the sum does, and the comparison fails.
std::optional<int> stages::nearerByFilter(const Point& p, const Point& q, const Point& place)
{
  const double ofP = Way(place, p).squared(), ofQ = Way(place, q).squared();
  const double size = ofP + ofQ;
  return size > 0x1p-1000 ? certainSign(ofQ - ofP, 8 * 0x1p-53 * size) : std::nullopt;
}

int stages::nearerUnbounded(const Point& p, const Point& q, const Point& place)
{
  const Unit unit{ &p, &q, &place };
  const WideVector toP(unit, place, p), toQ(unit, place, q);
  return (dotUnbounded(toQ, toQ) - dotUnbounded(toP, toP)).sign();
}

int nearerOf(const Point& p, const Point& q, const Point& place)
{
  const std::optional<int> sign = stages::nearerByFilter(p, q, place);
  return sign ? *sign : stages::nearerUnbounded(p, q, place);
}

/// Proof. The products are known to 3 e, their sum to 4 e of the sum of their sizes; the rest as in
/// nearerByFilter.
std::optional<int> stages::acutenessByFilter(const Point& p, const Point& r, const Point& q)
{
  const Way toP(r, p), toQ(r, q);
  const double first = toP.x * toQ.x, second = toP.y * toQ.y;
  const double size = std::fabs(first) + std::fabs(second);
  return size > 0x1p-1000 ? certainSign(first + second, 8 * 0x1p-53 * size) : std::nullopt;
}

int stages::acutenessUnbounded(const Point& p, const Point& r, const Point& q)
{
  const Unit unit{ &p, &q, &r };
  return dotUnbounded(WideVector(unit, r, p), WideVector(unit, r, q)).sign();
}

int acuteness(const Point& p, const Point& r, const Point& q)
{
  const std::optional<int> sign = stages::acutenessByFilter(p, r, q);
  return sign ? *sign : stages::acutenessUnbounded(p, r, q);
}

} // namespace ahd
