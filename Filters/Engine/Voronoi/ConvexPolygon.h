// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConvexPolygon_h
#define ahd_ConvexPolygon_h

#include "../Points/Points.h"
#include "Circumcentre.h"
#include "Voronoi.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// The place within the bounds that is nearest to p.
inline Point within(const Bounds& bounds, const Point& p)
{
  return { std::min(std::max(p.x, bounds.xmin), bounds.xmax),
    std::min(std::max(p.y, bounds.ymin), bounds.ymax) };
}

/// A convex polygon, whose border is followed counterclockwise from the corner with the smallest
/// (x, y). Corner k is where side k begins. Corners on straight sides are left out.
///
/// A stretch of the border is corner k, number 2 k, or what lies between the ends of side k,
/// 2 k + 1.
class ConvexPolygon
{
public:
  /// @param corners two opposite corners of a box with sides along the axes; or those of the
  /// polygon, in either direction, the first one perhaps again in the end
  explicit ConvexPolygon(std::vector<Point> corners);

  /// All below require that there is none.
  PolygonFault fault() const { return fault_; }

  const Bounds& bounds() const { return bounds_; }
  std::size_t size() const { return corners_.size(); }
  const Point& corner(std::size_t k) const { return corners_[k == size() ? 0 : k]; }
  Line side(std::size_t k) const { return { corner(k), corner(k + 1) }; }

  /// Is it a box and has the point inside? Then an exact place that was rounded to it is inside,
  /// too.
  bool isBoxAround(const Point& p) const
  {
    return isBox_ && p.x > bounds_.xmin && p.x < bounds_.xmax && p.y > bounds_.ymin &&
      p.y < bounds_.ymax;
  }

  static constexpr std::size_t kNoSide = std::size_t(-1);

  /// A side that the circumcentre lies beyond or on; kNoSide if it is inside. Exact. `centre`: the
  /// same, rounded once, which takes it onto a double at most, never across. Takes the logarithm of
  /// the number of sides.
  std::size_t sideBeyond(const Corners& triangle, const Point& centre) const;

  /// The sign of the distance of the circumcentre from the line through side k: +1 on the side of
  /// the polygon, 0 on the line. Exact.
  int sideOf(std::size_t k, const Corners& triangle, const Point& centre) const;

  struct Crossing
  {
    std::uint32_t entry, exit;
  };
  /// The stretches where the bisector of p and q, followed counterclockwise around p, enters the
  /// inside and leaves it. Returns false if it does not cross the inside. Exact; linear.
  bool isCrossed(const Point& p, const Point& q, Crossing& crossing) const;

  /// Is it inside or on the border? Exact.
  bool contains(const Point& p) const;

private:
  PolygonFault arrange();
  PolygonFault takeStrict();

  std::vector<Point> corners_;
  Bounds bounds_;
  std::size_t last_ = 0; ///< the corner with the largest (x, y): x rises up to it, then falls
  bool isBox_ = false;
  PolygonFault fault_; ///< the last member: arrange() sets the others
};

} // namespace ahd

#endif
