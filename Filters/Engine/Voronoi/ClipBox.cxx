// SPDX-License-Identifier: BSD-3-Clause
#include "ClipBox.h"

namespace ahd
{

/// Rounding takes a centre onto a side at most, never across it.
bool ClipBox::hasCentre(const Corners& triangle, const Point& centre) const
{
  if (!contains(centre))
  {
    return false;
  }
  for (unsigned k = 0; k < 4; ++k)
  {
    const Line line = side(k);
    if (isOnSide(centre, k) && sideOfCircumcentre(triangle, line.from, line.to) < 0)
    {
      return false;
    }
  }
  return true;
}

/// The middle of p and q is in the box, and if it lies on a side, so do both: the bisector crosses
/// the inside. So some corners are nearer to p and some to q, and those nearer to p, which lie to
/// its left, come in a row after the place that is looked for.
unsigned ClipBox::exitOf(const Point& p, const Point& q) const
{
  int nearer[4];
  for (unsigned k = 0; k < 4; ++k)
  {
    nearer[k] = nearerOf(p, q, corner(k));
  }
  unsigned k = 0;
  while (k < 3 && !(nearer[k] <= 0 && nearer[k + 1] > 0))
  {
    ++k;
  }
  return nearer[k] == 0 ? 2 * k : 2 * k + 1;
}

} // namespace ahd
