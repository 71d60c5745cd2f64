// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ClipBox_h
#define ahd_ClipBox_h

#include "../Points/Points.h"

#include <algorithm>
#include <vector>

namespace ahd
{

/// The place within the bounds that is nearest to p.
inline Point within(const Bounds& bounds, const Point& p)
{
  return { std::min(std::max(p.x, bounds.xmin), bounds.xmax),
    std::min(std::max(p.y, bounds.ymin), bounds.ymax) };
}

/// The direction from one point to another: their difference times a power of two, so that its
/// larger coordinate is between 1 and 2 and no product of such directions overflows, or underflows
/// and matters. Zero if they are one place, not finite if one of them is not.
Point directionOf(const Point& from, const Point& to);

/// An axis-parallel box with an area, whose border is followed counterclockwise. Side 0 is below,
/// 1 to the right, 2 above, 3 to the left; corner k is where side k begins.
class ClipBox
{
public:
  explicit ClipBox(const Bounds& bounds)
    : bounds_(bounds)
  {
  }

  bool hasArea() const { return bounds_.xmin < bounds_.xmax && bounds_.ymin < bounds_.ymax; }

  /// Is it inside or on the border? Not if it is not finite.
  bool contains(const Point& p) const
  {
    return p.x >= bounds_.xmin && p.x <= bounds_.xmax && p.y >= bounds_.ymin && p.y <= bounds_.ymax;
  }

  Point corner(unsigned k) const
  {
    return { k == 0 || k == 3 ? bounds_.xmin : bounds_.xmax,
      k == 0 || k == 1 ? bounds_.ymin : bounds_.ymax };
  }

  bool isOnSide(const Point& p, unsigned side) const
  {
    return side == 0 ? p.y == bounds_.ymin
      : side == 1    ? p.x == bounds_.xmax
      : side == 2    ? p.y == bounds_.ymax
                     : p.x == bounds_.xmin;
  }

  /// Where one leaves the box who goes from p, inside, at right angles to the left of the direction
  /// from a to b. On the border, exactly.
  Point leave(const Point& p, const Point& a, const Point& b) const;

  /// The corners that are passed counterclockwise from p to q, both on the border: numbers of
  /// corners. p and q themselves are not among them.
  std::vector<unsigned> between(const Point& p, const Point& q) const;

private:
  /// The side a point of the border is on; at a corner, the one that begins there.
  unsigned sideOf(const Point& p) const;

  Bounds bounds_;
};

} // namespace ahd

#endif
