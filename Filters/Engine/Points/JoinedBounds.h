// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JoinedBounds_h
#define ahd_JoinedBounds_h

#include "Points.h"

#include <algorithm>

namespace ahd
{

/// Also if a bound is NaN.
inline bool isEmpty(const Bounds& bounds)
{
  return !(bounds.xmin <= bounds.xmax);
}

/// The smallest that hold both; either may be empty.
inline Bounds joined(const Bounds& a, const Bounds& b)
{
  return isEmpty(a) ? b
    : isEmpty(b)    ? a
                    : Bounds{ std::min(a.xmin, b.xmin), std::max(a.xmax, b.xmax),
                     std::min(a.ymin, b.ymin), std::max(a.ymax, b.ymax) };
}

/// The smallest that hold these and the point.
inline Bounds joined(const Bounds& bounds, const Point& p)
{
  return joined(bounds, Bounds{ p.x, p.x, p.y, p.y });
}

} // namespace ahd

#endif
