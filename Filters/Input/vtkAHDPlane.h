// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDPlane_h
#define vtkAHDPlane_h

#include "Engine/Core/Executor.h"
#include "Engine/Points/Points.h"
#include "Input/vtkAHDVectors.h"
#include "vtkSmartPointer.h"

class vtkAHDProgress;
class vtkTransform;

/**
 * The plane that fits points best, and where a point lies in it.
 *
 * Best: least sum of squared distances from the plane (total least squares), so that no direction
 * is preferred and planes may be vertical. Duplicates count as often as they are there. The result
 * is a function of the points alone: neither their order nor the number of threads changes a bit.
 *
 * The normal points to the side on which its component of largest magnitude is positive (within a
 * millionth of each other: z before y before x). If that is the component k of (x, y, z), the first
 * axis in the plane is the axis k + 1 (x after z) laid into the plane, the second makes them right
 * handed: for a normal of z, the axes are x and y. Where one plane is as good as another, this is
 * decided: coincident points have a normal of z; points on a line (up to the precision of their
 * numbers) have the one closest to z, and y for a line along z.
 *
 * The plane's origin is a point close by from which the distances of all points are exact, with as
 * few digits as do; it is the coordinates' own origin where that is near. So points in a plane
 * along two axes keep their distances to the last bit.
 */
class vtkAHDPlane
{
public:
  /// Fits. Points that are skipped or have a coordinate that is not finite do not count; without
  /// any others the plane is z = 0. Returns false if the filter is to abort. REQUIRES:
  /// points.stride is 3, the third number of each point is its z.
  bool Fit(const ahd::PointView& points, ahd::Executor& executor, vtkAHDProgress& progress);

  /// Unit vectors at right angles to each other, right handed in this order.
  const vtkAHDVector& GetFirstAxis() const { return this->Axes[0]; }
  const vtkAHDVector& GetSecondAxis() const { return this->Axes[1]; }
  const vtkAHDVector& GetNormal() const { return this->Axes[2]; }

  /// Where the point lies along the two axes, and its height above the plane. All three are NaN or
  /// infinite if one of its coordinates is.
  vtkAHDVector Project(const vtkAHDVector& p) const;

  /// The same as a transform. Far from the coordinates' origin it rounds more than Project(), as a
  /// matrix cannot subtract before it multiplies.
  vtkSmartPointer<vtkTransform> MakeTransform() const;

private:
  void Orient(vtkAHDVector normal);

  vtkAHDMatrix Axes = { { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  vtkAHDVector Origin = { { 0, 0, 0 } };
  double Height = 0.0; // of the plane above Origin, along the normal
  double Shrink = 1.0; // a power of two that keeps sums of huge coordinates finite
};

#endif
