// SPDX-License-Identifier: BSD-3-Clause
#include "Moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{
namespace fuzz
{
namespace
{

using Points = std::vector<Point>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double special(Dice& dice)
{
  static const double kAll[] = { 0.0, -0.0, 1.0, -1.0, 0.1, 5e-324, -5e-324, 0x1p-1022,
    0x1.fffffffffffffp-1023, 0x1p-1000, 0x1p-537, 0x1p-480, 0x1p500, 0x1p511, 0x1p512, 0x1p1000,
    0x1p1023, 0x1.fffffffffffffp1023, -0x1.fffffffffffffp1023, 1e300, 1e-300, 0x1p53, 0x1p26,
    0x1.0000000000001p0, 411000.3, kInfinity, -kInfinity,
    std::numeric_limits<double>::quiet_NaN() };
  return kAll[dice.below(std::size(kAll))];
}

double someNumber(Dice& dice)
{
  switch (dice.below(8))
  {
    case 0:
      return special(dice);
    case 1: // anything finite
      return std::ldexp(double(dice.bits() >> 11), int(dice.below(2044)) - 1074) *
        (dice.below(2) == 0 ? 1.0 : -1.0);
    case 2:
      return std::ldexp(double(dice.bits() >> 11), -53);
    case 3:
      return 0.1 * double(dice.below(20));
    default:
      return double(dice.below(12)) - 3.0;
  }
}

double stepped(double value, Dice& dice)
{
  const double towards = dice.below(2) == 0 ? kInfinity : -kInfinity;
  for (std::size_t steps = dice.below(4) == 0 ? 1 + dice.below(6) : 1; steps > 0; --steps)
  {
    value = std::nextafter(value, towards);
  }
  return value;
}

const Point& any(const Points& points, Dice& dice)
{
  return points[dice.below(points.size())];
}

/// A place on the line of two points, rounded: between them, beyond, a simple or any fraction.
Point onLine(const Point& a, const Point& b, Dice& dice)
{
  static const double kFractions[] = { 0.5, 2.0, -1.0, 0.25, 1.0 / 3, 3.0, 1e-9, 0x1p-52 };
  const double t = dice.below(3) == 0 ? std::ldexp(double(dice.bits() >> 11), -53)
                                      : kFractions[dice.below(std::size(kFractions))];
  return { a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) };
}

/// A place on the circle through three points, rounded; opposite the third one now and then.
Point onCircle(const Point& a, const Point& b, const Point& c, Dice& dice)
{
  using Long = long double;
  const Long bx = Long(b.x) - a.x, by = Long(b.y) - a.y, cx = Long(c.x) - a.x, cy = Long(c.y) - a.y;
  const Long twice = 2 * (bx * cy - by * cx);
  const Long x = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / twice;
  const Long y = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / twice;
  if (dice.below(3) == 0)
  {
    return { double(a.x + 2 * x), double(a.y + 2 * y) };
  }
  const Long angle = std::ldexp(Long(dice.bits() >> 11), -50);
  const Long radius = std::hypot(x, y);
  return { double(a.x + x + radius * std::cos(angle)), double(a.y + y + radius * std::sin(angle)) };
}

/// A new place near, on or beside others.
Point placeByOthers(const Points& points, Dice& dice)
{
  const Point &a = any(points, dice), &b = any(points, dice), &c = any(points, dice);
  switch (dice.below(9))
  {
    case 0:
      return a;
    case 1:
      return { stepped(a.x, dice), dice.below(2) == 0 ? a.y : stepped(a.y, dice) };
    case 2:
      return { a.x, stepped(a.y, dice) };
    case 3: // exactly on the circle of a, b and the other corner of the box
      return { a.x, b.y };
    case 4:
      return dice.below(2) == 0 ? Point{ a.x, someNumber(dice) } : Point{ someNumber(dice), a.y };
    case 5:
      return { b.x + (c.x - a.x), b.y + (c.y - a.y) };
    case 6: // on the circle of a, b, c, if a and b are level
      return { a.x + (b.x - c.x), c.y };
    case 7:
      return onLine(a, b, dice);
    default:
      return onCircle(a, b, c, dice);
  }
}

Point somePlace(const Points& points, Dice& dice)
{
  return points.empty() || dice.below(4) == 0 ? Point{ someNumber(dice), someNumber(dice) }
                                              : placeByOthers(points, dice);
}

double scaled(double value, int exponent)
{
  return std::ldexp(value, exponent);
}

void shiftExponents(Points& points, Dice& dice)
{
  const int exponents[] = { 1, -1, 53, -53, 500, -500, 1000, -1000, int(dice.below(2100)) - 1050 };
  const int e = exponents[dice.below(std::size(exponents))];
  const std::size_t which = dice.below(4);
  Point& one = points[dice.below(points.size())];
  if (which == 0)
  {
    one.x = scaled(one.x, e);
  }
  else if (which == 1)
  {
    one = { scaled(one.x, e), scaled(one.y, e) };
  }
  else
  {
    for (Point& p : points)
    {
      p = { scaled(p.x, e), which == 2 ? p.y : scaled(p.y, e) };
    }
  }
}

/// Rounds all coordinates to multiples of one number.
void snap(Points& points, Dice& dice)
{
  const double units[] = { 1.0, 0.25, 0.1, 0x1p-40, 0x1p-1074, 1e290, 4.0 };
  const double unit = units[dice.below(std::size(units))];
  for (Point& p : points)
  {
    p = { std::nearbyint(p.x / unit) * unit, std::nearbyint(p.y / unit) * unit };
  }
}

void moveAll(Points& points, Dice& dice)
{
  const std::size_t kind = dice.below(7);
  const Point by = { someNumber(dice), someNumber(dice) };
  if (kind == 0)
  {
    snap(points, dice);
  }
  else if (kind == 1)
  {
    shiftExponents(points, dice);
  }
  for (Point& p : points)
  {
    switch (kind)
    {
      case 2:
        p.x = -p.x;
        break;
      case 3:
        p = { p.y, p.x };
        break;
      case 4:
        p = { -p.y, p.x };
        break;
      case 5:
        p = { p.x + by.x, p.y + by.y };
        break;
      case 6: // nearly on a parabola, or a line
        p.y = by.x * p.x * (dice.below(8) == 0 ? 1.0 : p.x);
        break;
      default:
        break;
    }
  }
}

/// A row, circle, lattice or crowd of new points.
void addMany(Points& points, Dice& dice)
{
  const std::size_t count = 3 + dice.below(dice.below(4) == 0 ? 40 : 9), kind = dice.below(4);
  const Point a = somePlace(points, dice), b = somePlace(points, dice);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double t = double(i) / double(count);
    switch (kind)
    {
      case 0:
        points.push_back({ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) });
        break;
      case 1:
        points.push_back({ a.x + b.x * std::cos(6.28 * t), a.y + b.x * std::sin(6.28 * t) });
        break;
      case 2:
        points.push_back({ a.x + double(i % 4), a.y + double(i / 4) });
        break;
      default:
        points.push_back({ stepped(a.x, dice), stepped(a.y, dice) });
    }
  }
}

void moveOne(Points& points, Dice& dice)
{
  Point& p = points[dice.below(points.size())];
  switch (dice.below(6))
  {
    case 0:
      p.x = stepped(p.x, dice);
      break;
    case 1:
      p.y = stepped(p.y, dice);
      break;
    case 2:
      p = any(points, dice);
      break;
    case 3:
      (dice.below(2) == 0 ? p.x : p.y) = someNumber(dice);
      break;
    default:
      p = somePlace(points, dice);
  }
}

} // namespace

void movePoints(FuzzCase& mutated, Dice& dice)
{
  Points& points = mutated.points;
  const std::size_t kind = points.empty() ? 0 : dice.below(12);
  if (kind <= 3)
  {
    points.push_back(somePlace(points, dice));
  }
  else if (kind <= 7)
  {
    moveOne(points, dice);
  }
  else if (kind == 8)
  {
    addMany(points, dice);
  }
  else if (kind == 9)
  {
    shiftExponents(points, dice);
  }
  else if (kind == 10)
  {
    moveAll(points, dice);
  }
  else
  {
    const std::size_t from = dice.below(points.size());
    const std::size_t most = dice.below(4) == 0 ? points.size() - from : 1;
    points.erase(points.begin() + std::ptrdiff_t(from),
      points.begin() + std::ptrdiff_t(from + 1 + dice.below(most)));
  }
  points.resize(std::min(points.size(), kMostGivenPoints));
}

} // namespace fuzz
} // namespace ahd
