// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDTransform_h
#define vtkAHDTransform_h

#include "Engine/Core/Executor.h"
#include "Engine/Points/Points.h"

class vtkAbstractTransform;
class vtkAHDPlane;
class vtkAHDProgress;

/// Writes where the points lie from a plane, or where a transform takes them: three numbers each,
/// the third the height. The transform is brought up to date, not changed; a homogeneous one is
/// asked by several threads, any other, which may not stand that, by this one. A point with a
/// coordinate that is not finite gets three that are NaN. Both return false if the filter is to
/// abort and throw std::bad_alloc. REQUIRES: points.stride is 3, the third number of each point is
/// its z.
bool vtkAHDProject(const ahd::PointView& points, const vtkAHDPlane& plane, double* xyz,
  ahd::Executor& executor, vtkAHDProgress& progress);
bool vtkAHDProject(const ahd::PointView& points, vtkAbstractTransform* transform, double* xyz,
  ahd::Executor& executor, vtkAHDProgress& progress);

#endif
