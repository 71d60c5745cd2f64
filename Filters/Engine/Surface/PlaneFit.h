// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlaneFit_h
#define ahd_PlaneFit_h

#include "../Core/Progress.h"
#include "../Points/Points.h"
#include "Footprint.h"
#include "Vectors.h"

#include <memory>
#include <vector>

namespace ahd
{

/// The plane with the least sum of squared distances from points, not yet turned to a side (see
/// Plane.h).
struct PlaneFit
{
  /// Of length about 1; z if all points coincide or there are none. For points on a line (up to the
  /// precision of their numbers) the one closest to z, or to y where the line's largest component
  /// is z.
  Vector3 normal = { { 0, 0, 1 } };

  /// A nearby point from which the distance of every point is exact, along each coordinate.
  Vector3 origin = { { 0, 0, 0 } };

  /// Of the plane above the origin, along the normal, times `shrink`.
  double height = 0.0;

  /// A power of two; coordinates multiplied by it can be added up.
  double shrink = 1.0;

  /// Is the plane that of a coordinate common to all points? Then the normal is its axis and the
  /// origin 0.
  bool isOfCoordinates = true;

  /// Is it a plane for these points, rather than that of x, y?
  Stance stance;
};

/// Returns false if cancelled; throws std::bad_alloc.
/// @pre `fit` is new
bool fitPlane(const PointView& points, Ticker& ticker, PlaneFit& fit);

/// The bytes that fitPlane() takes at most, of so many points.
std::size_t planeFitMemoryEstimate(std::size_t points);

/// fitPlane() in steps, for points in several parts: the plane of all, bit for bit as if one had
/// them. All holders of parts proceed alike:
///
///     while not isDone(): look(), tell() each other, hear() what all have told
class PlaneFitting
{
public:
  /// Of the own part, which it borrows, and may be empty. `areDoubles`: do the coordinates of all
  /// parts count as doubles? Else all are floats.
  PlaneFitting(const PointView& points, bool areDoubles);
  ~PlaneFitting();

  bool isDone() const;
  /// Reads the own part. Returns false if cancelled; throws std::bad_alloc.
  bool look(Ticker& ticker);
  /// A few hundred bytes, and once 24 KB if the plane is steep. Throws std::bad_alloc.
  void tell(std::vector<unsigned char>& bytes) const;
  /// The messages of all parts, one's own included, in the same order for all.
  void hear(const std::vector<std::vector<unsigned char>>& all);
  /// The same where there are no others.
  void goOn();
  /// @pre isDone().
  const PlaneFit& fit() const;

private:
  class Work;
  std::unique_ptr<Work> work_;
};

} // namespace ahd

#endif
