// SPDX-License-Identifier: BSD-3-Clause
#include "Box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

/// How far it is from p to the side that is ahead, in units of the direction's length.
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

} // namespace

Point Box::leave(const Point& p, const Point& a, const Point& b) const
{
  const Point direction{ 0.5 * a.y - 0.5 * b.y, 0.5 * b.x - 0.5 * a.x };
  const double inX = distanceAhead(p.x, direction.x, bounds_.xmin, bounds_.xmax);
  const double inY = distanceAhead(p.y, direction.y, bounds_.ymin, bounds_.ymax);
  Point result;
  if (inX <= inY)
  {
    result.x = direction.x > 0.0 ? bounds_.xmax : bounds_.xmin;
    result.y = p.y + inX * direction.y * 2.0;
  }
  else
  {
    result.x = p.x + inY * direction.x * 2.0;
    result.y = direction.y > 0.0 ? bounds_.ymax : bounds_.ymin;
  }
  result.x = std::min(std::max(result.x, bounds_.xmin), bounds_.xmax);
  result.y = std::min(std::max(result.y, bounds_.ymin), bounds_.ymax);
  return result;
}

unsigned Box::sideOf(const Point& p) const
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

std::vector<unsigned> Box::between(const Point& p, const Point& q) const
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
