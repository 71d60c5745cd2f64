// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Plane_h
#define ahd_Plane_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "Footprint.h"
#include "Vectors.h"

#include <cstddef>

namespace ahd
{

struct PlaneFit;

/// The plane that fits points best, and the places of points in it.
///
/// - Least sum of squared distances from the plane (total least squares): no direction is
///   preferred, and planes may be vertical. Duplicates count as often as they occur.
/// - A function of the points alone: neither their order nor the number of threads changes a bit.
///   (Fits of libraries do not have this property.)
///
/// The normal points to the side where its component of largest magnitude is positive (within a
/// millionth of each other: z before y before x). If that is component k of (x, y, z), the first
/// axis is axis k + 1 (x after z) projected into the plane, the second makes them right handed: for
/// a normal of z, the axes are x and y. Coincident points have a normal of z; points on a line (up
/// to the precision of their numbers) the one closest to z, and y for a line along z.
///
/// The origin is a nearby point from which the distances of all points are exact, with as few
/// digits as possible; it is the coordinates' own origin if that is near, and with
/// isOfCoordinates().
class Plane
{
public:
  /// Fits. Points left out or with a coordinate that is not finite do not count; without others the
  /// plane is z = 0.
  ///
  /// @return Ok, Cancelled or OutOfMemory
  Status fit(const PointView& points, const Context& context);
  /// Takes over a plane fitted in steps.
  void take(const PlaneFit& fit);

  /// Unit vectors at right angles to each other, right handed in this order.
  const Vector3& firstAxis() const { return axes_[0]; }
  const Vector3& secondAxis() const { return axes_[1]; }
  const Vector3& normal() const { return axes_[2]; }

  /// Do all fitted points have one z, or one x or y without being collinear? Then the two other
  /// coordinates are the place of every point in the plane, not rounded: x, y; y, z; or z, x.
  bool isOfCoordinates() const { return isOfCoordinates_; }

  /// How the fitted points lie.
  const Stance& stance() const { return stance_; }

  /// The point's place along the two axes, and its height above the plane. All three are NaN or
  /// infinite if one of its coordinates is.
  Vector3 project(const Vector3& p) const
  {
    const double grow = 1.0 / shrink_;
    Vector3 d;
    for (std::size_t k = 0; k < 3; ++k)
    {
      d[k] = p[k] * shrink_ - origin_[k] * shrink_;
    }
    return { { dot(axes_[0], d) * grow, dot(axes_[1], d) * grow,
      (dot(axes_[2], d) - height_) * grow } };
  }

private:
  void orient(Vector3 normal);

  Matrix3 axes_ = { { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  Vector3 origin_ = { { 0, 0, 0 } };
  double height_ = 0.0; ///< of the plane above the origin, along the normal, shrunk
  bool isOfCoordinates_ = true;
  Stance stance_;
  double shrink_ = 1.0; ///< a power of two that keeps sums of huge coordinates finite
};

} // namespace ahd

#endif
