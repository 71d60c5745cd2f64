// SPDX-License-Identifier: BSD-3-Clause
#include "ClipBox.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

/// Half of how far it is from p to the side that is ahead, in units of the direction's length;
/// infinite where that overflows.
double distanceAhead(double p, double direction, double low, double high)
{
  if (direction == 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  // Halves, since the box may be wider than the largest double.
  const double far = direction > 0.0 ? 0.5 * high - 0.5 * p : 0.5 * low - 0.5 * p;
  return far / direction;
}

/// p and twice `half`, where the way may be longer than the largest double.
double moved(double p, double half)
{
  const double result = p + 2.0 * half;
  return std::isfinite(result) ? result : (p + half) + half;
}

} // namespace

Point directionOf(const Point& from, const Point& to)
{
  Point result{ to.x - from.x, to.y - from.y };
  if (!isFinite(result))
  {
    result = { 0.5 * to.x - 0.5 * from.x, 0.5 * to.y - 0.5 * from.y };
  }
  const double larger = std::max(std::fabs(result.x), std::fabs(result.y));
  if (!(larger > 0.0)) // NaN has no exponent either
  {
    return result;
  }
  const int exponent = std::ilogb(larger);
  return { std::ldexp(result.x, -exponent), std::ldexp(result.y, -exponent) };
}

Point ClipBox::leave(const Point& p, const Point& a, const Point& b) const
{
  const Point along = directionOf(a, b);
  const Point direction{ -along.y, along.x };
  const double inX = distanceAhead(p.x, direction.x, bounds_.xmin, bounds_.xmax);
  const double inY = distanceAhead(p.y, direction.y, bounds_.ymin, bounds_.ymax);
  Point result;
  if (inX <= inY)
  {
    result.x = direction.x > 0.0 ? bounds_.xmax : bounds_.xmin;
    result.y = moved(p.y, inX * direction.y);
  }
  else
  {
    result.x = moved(p.x, inY * direction.x);
    result.y = direction.y > 0.0 ? bounds_.ymax : bounds_.ymin;
  }
  return within(bounds_, result);
}

unsigned ClipBox::sideOf(const Point& p) const
{
  for (unsigned side = 0; side < 3; ++side)
  {
    if (isOnSide(p, side) && !isOnSide(p, (side + 1) % 4))
    {
      return side;
    }
  }
  return 3;
}

std::vector<unsigned> ClipBox::between(const Point& p, const Point& q) const
{
  std::vector<unsigned> result;
  const unsigned first = sideOf(p);
  const unsigned last = sideOf(q);
  const double ahead[4] = { q.x - p.x, q.y - p.y, p.x - q.x, p.y - q.y };
  // On one side and ahead, no corner is passed; behind, all four are.
  const unsigned steps = first == last ? (ahead[first] >= 0.0 ? 0 : 4) : (last + 4 - first) % 4;
  for (unsigned step = 1; step <= steps; ++step)
  {
    const unsigned k = (first + step) % 4;
    if (!(corner(k) == q))
    {
      result.push_back(k);
    }
  }
  return result;
}

} // namespace ahd
