// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Way_h
#define ahd_Way_h

#include "../Points/Points.h"
#include "../Predicates/Segments.h"

namespace ahd
{

/// The ends of a segment, in its direction.
struct Way
{
  Point from;
  Point to;

  Segment leftToRight() const
  {
    return lexicographicallyLess(from, to) ? Segment{ from, to } : Segment{ to, from };
  }

  /// Does it pass a before b? @pre both are points on it, rounded, which is monotone in each
  /// coordinate; so they are in the order of both.
  bool isBefore(const Point& a, const Point& b) const
  {
    return a.x != b.x ? (a.x < b.x) == (from.x < to.x)
                      : a.y != b.y && (a.y < b.y) == (from.y < to.y);
  }
};

} // namespace ahd

#endif
