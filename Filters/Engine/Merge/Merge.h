// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Merge_h
#define ahd_Merge_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <vector>

namespace ahd
{

/// A point that was merged into another one that is near.
struct MergedPoint
{
  Index id;
  Index keptId; ///< smallest id, of those not left out, at the kept place
};

struct MergedPoints
{
  /// In ascending order of id. Points at a kept place are in no pair: that they coincide is left
  /// to triangulate().
  std::vector<MergedPoint> pairs;
  /// One byte per point, for PointView::skip with skipMask 0xFF: 1 for the points in `pairs` and
  /// for those that the caller had left out, else 0.
  std::vector<unsigned char> skip;

  /// The points without those merged. This object is to outlive the view.
  PointView without(PointView points) const
  {
    points.skip = skip.data();
    points.skipMask = 0xFF;
    return points;
  }
};

/// Merges points that are near each other. The distinct places of the finite points that are not
/// left out are taken in lexicographic order (x, y). A place that has kept ones within `distance`,
/// that distance included, is merged into the nearest of them, the lexicographically smallest of
/// those that are equally near; else it is kept. So a kept place is farther than `distance` from
/// all others kept, and the result is a function of the point set: shuffling the points changes ids
/// only.
///
/// Distances are compared as ((dx s)^2 + (dy s)^2) against (distance s)^2, each operation rounded
/// to nearest double, dx and dy the rounded differences and s the power of two that brings
/// `distance` into [1, 2), but at most 2^1023; for an infinite distance 1. Nothing overflows that
/// is not farther.
///
/// `distance`: 0 to infinity, in the unit of the points. Infinity merges all into the first; 0 (as
/// anything below it, and NaN) merges nothing. The phase is Phase::Merge.
/// Returns Ok, Cancelled, TooManyPoints or OutOfMemory; unless Ok, `out` is not to be used.
/// Cost: n log n steps for any points and any distance, a few per point where hardly any are near
/// each other; all but the last step, which looks at those that may be, on all threads. About 60
/// bytes a point while it works, and 16 for each kept place within `distance` in x.
Status mergeWithin(
  const PointView& points, double distance, const Context& context, MergedPoints& out);

/// The same on this thread. `progress` may be null.
inline Status mergeWithin(
  const PointView& points, double distance, Progress* progress, MergedPoints& out)
{
  return mergeWithin(points, distance, Context{ progress, nullptr }, out);
}

} // namespace ahd

#endif
