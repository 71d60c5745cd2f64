// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Discs_h
#define ahd_Discs_h

#include "../Points/Points.h"
#include "Circles.h"
#include "Segments.h"

#include <optional>

namespace ahd
{

// Decides which triangles of a block are final, whatever points other blocks have. Exact for
// all finite coordinates; discs, boxes, triangles and segments are closed.

/// The circumdisc of a triangle, for tests against several boxes. Borrows the triangle.
class Circumdisc
{
public:
  /// @pre counterclockwise, not collinear.
  explicit Circumdisc(const Corners& triangle);

  /// Has it a point in common with the box? @pre the box is not empty; it may be a point.
  bool meets(const Bounds& box) const;

  /// The same in double arithmetic, where that is certain.
  std::optional<bool> meetsByFilter(const Bounds& box) const;

  /// Does it certainly lie between the lines x = xmin, x = xmax, y = ymin and y = ymax, and touch
  /// none? Lines may lie at infinity. False may mean that the filter cannot tell.
  bool isCertainlyWithin(const Bounds& box) const;

private:
  const Corners& triangle_;
  // All lengths times scale_, a power of two: then the triangle is about 1 wide. The centre is a +
  // (x_, y_) / divisor_, the radius radius_ / divisor_.
  double scale_, x_, y_, divisor_, radius_;
  double sizeOfDivisor_, sizeOfOffset_; ///< of their summands
};

/// Have the counterclockwise triangle and the segment from p to q a point in common? p may be q.
bool touches(const Corners& triangle, const Point& p, const Point& q);

/// For Discs.cxx and its tests only.
namespace stages
{

bool discMeetsUnbounded(const Corners& triangle, const Bounds& box);

} // namespace stages
} // namespace ahd

#endif
