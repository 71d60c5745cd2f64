// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Plane_h
#define ahd_Plane_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "Vectors.h"

#include <cstddef>

namespace ahd
{

struct PlaneFit;

/// The plane that fits points best, and where a point lies in it.
///
/// Best: least sum of squared distances from the plane (total least squares), so that no direction
/// is preferred and planes may be vertical. Duplicates count as often as they are there. A function
/// of the points alone: neither their order nor the number of threads changes a bit; that is why no
/// library's fit is used here.
///
/// The normal points to the side on which its component of largest magnitude is positive (within a
/// millionth of each other: z before y before x). If that is the component k of (x, y, z), the
/// first axis in the plane is the axis k + 1 (x after z) laid into the plane, the second makes them
/// right handed: for a normal of z, the axes are x and y. Coincident points have a normal of z;
/// points on a line (up to the precision of their numbers) the one closest to z, and y for a line
/// along z.
///
/// The plane's origin is a point close by from which the distances of all points are exact, with as
/// few digits as do; it is the coordinates' own origin where that is near, and with
/// isOfCoordinates().
class Plane
{
public:
  /// Fits. Points that are left out or have a coordinate that is not finite do not count; without
  /// any others the plane is z = 0. Returns Ok, Cancelled or OutOfMemory.
  Status fit(const PointView& points, const Context& context);
  /// Becomes one that was fitted in steps.
  void take(const PlaneFit& fit);

  /// Unit vectors at right angles to each other, right handed in this order.
  const Vector3& firstAxis() const { return axes_[0]; }
  const Vector3& secondAxis() const { return axes_[1]; }
  const Vector3& normal() const { return axes_[2]; }

  /// Have all points that it was fitted to one z, or one x or y and are on no line? Then the two
  /// other coordinates are the place of every point in the plane, not rounded: x, y; y, z; or z, x.
  bool isOfCoordinates() const { return isOfCoordinates_; }

  /// Where the point lies along the two axes, and its height above the plane. All three are NaN or
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
      dot(axes_[2], d) * grow - height_ } };
  }

private:
  void orient(Vector3 normal);

  Matrix3 axes_ = { { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  Vector3 origin_ = { { 0, 0, 0 } };
  double height_ = 0.0; ///< of the plane above the origin, along the normal
  bool isOfCoordinates_ = true;
  double shrink_ = 1.0; ///< a power of two that keeps sums of huge coordinates finite
};

} // namespace ahd

#endif
