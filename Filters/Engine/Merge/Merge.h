// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Merge_h
#define ahd_Merge_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <vector>

namespace ahd
{

/// A point that was merged into a near one.
struct MergedPoint
{
  Index id;
  Index keptId; ///< smallest id, of those not left out, at the kept place
};

struct MergedPoints
{
  /// In ascending order of id. Points at a kept place are in no pair: triangulate() handles
  /// coincident points.
  std::vector<MergedPoint> pairs;
  /// One byte per point, for PointView::skip with skipMask 0xFF: 1 for points in `pairs` and points
  /// left out by the caller, else 0.
  std::vector<unsigned char> skip;

  /// The points without the merged ones. The view borrows this object.
  PointView without(PointView points) const
  {
    points.skip = skip.data();
    points.skipMask = 0xFF;
    return points;
  }
};

/// Merges points that are near each other.
///
/// The distinct places of the finite points that are not left out are taken in lexicographic order
/// (x, y). A place with kept ones within `distance`, inclusive, is merged into the nearest of them,
/// of equally near ones the lexicographically smallest; otherwise it is kept. So kept places are
/// farther than `distance` from each other, and the result is a function of the point set:
/// shuffling the points changes ids only.
///
/// Distances are compared as ((dx s)^2 + (dy s)^2) against (distance s)^2, each operation rounded
/// to nearest double, dx and dy the rounded differences and s the power of two that brings
/// `distance` into [1, 2), but at most 2^1023; for an infinite distance 1. Only farther distances
/// overflow.
///
/// Cost: n log n steps for any points and distance, a few per point if hardly any are near each
/// other; on all threads except for the last step, which compares the candidates. About 60 bytes a
/// point, and 16 for each kept place within `distance` in x. The phase is Phase::Merge.
///
/// @param points borrowed
/// @param distance 0 to infinity, in the unit of the points. Infinity merges all into the first; 0,
///   negative numbers and NaN merge nothing.
/// @param context threads and progress; may be empty
/// @param out undefined unless the result is Ok
/// @return Ok, Cancelled, TooManyPoints or OutOfMemory
Status mergeWithin(
  const PointView& points, double distance, const Context& context, MergedPoints& out);

/// The same on the calling thread. `progress` may be null.
inline Status mergeWithin(
  const PointView& points, double distance, Progress* progress, MergedPoints& out)
{
  return mergeWithin(points, distance, Context{ progress, nullptr }, out);
}

} // namespace ahd

#endif
