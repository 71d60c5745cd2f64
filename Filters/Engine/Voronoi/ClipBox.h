// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ClipBox_h
#define ahd_ClipBox_h

#include "../Points/Points.h"
#include "Circumcentre.h"

#include <algorithm>

namespace ahd
{

/// The place within the bounds that is nearest to p.
inline Point within(const Bounds& bounds, const Point& p)
{
  return { std::min(std::max(p.x, bounds.xmin), bounds.xmax),
    std::min(std::max(p.y, bounds.ymin), bounds.ymax) };
}

/// An axis-parallel box with an area, whose border is followed counterclockwise. Side 0 is below,
/// 1 to the right, 2 above, 3 to the left; corner k is where side k begins.
class ClipBox
{
public:
  explicit ClipBox(const Bounds& bounds)
    : bounds_(bounds)
  {
  }

  const Bounds& bounds() const { return bounds_; }
  bool hasArea() const { return bounds_.xmin < bounds_.xmax && bounds_.ymin < bounds_.ymax; }

  Point corner(unsigned k) const
  {
    return { k == 0 || k == 3 ? bounds_.xmin : bounds_.xmax,
      k == 0 || k == 1 ? bounds_.ymin : bounds_.ymax };
  }
  Line side(unsigned k) const { return { corner(k), corner((k + 1) % 4) }; }

  /// Is it inside, not on the border? Not if it is not finite.
  bool hasInside(const Point& p) const
  {
    return p.x > bounds_.xmin && p.x < bounds_.xmax && p.y > bounds_.ymin && p.y < bounds_.ymax;
  }

  /// Is the circumcentre inside or on the border? Exact. `centre`: the same, rounded once; where
  /// hasInside(centre), it is.
  bool hasCentre(const Corners& triangle, const Point& centre) const;

  /// Where the bisector of p and q, followed counterclockwise around p, leaves the box: 2 k in
  /// corner k, 2 k + 1 on side k between its ends. Exact. @pre p and q are in the box.
  unsigned exitOf(const Point& p, const Point& q) const;

private:
  /// Is it inside or on the border? Not if it is not finite.
  bool contains(const Point& p) const
  {
    return p.x >= bounds_.xmin && p.x <= bounds_.xmax && p.y >= bounds_.ymin && p.y <= bounds_.ymax;
  }
  bool isOnSide(const Point& p, unsigned k) const
  {
    return k == 0 ? p.y == bounds_.ymin
      : k == 1    ? p.x == bounds_.xmax
      : k == 2    ? p.y == bounds_.ymax
                  : p.x == bounds_.xmin;
  }

  Bounds bounds_;
};

} // namespace ahd

#endif
