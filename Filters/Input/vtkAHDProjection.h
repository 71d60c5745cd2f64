// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDProjection_h
#define vtkAHDProjection_h

#include "Engine/Prepare/Prepare.h"
#include "vtkAbstractTransform.h"
#include "vtkSmartPointer.h"

class vtkAHDContext;
class vtkTransform;

/**
 * A VTK transform as the engine's Projection. The transform is brought up to date, not changed; a
 * homogeneous one is asked by several threads, any other, which may not stand that, by this one. A
 * point with a coordinate that is not finite gets three that are NaN.
 */
class vtkAHDProjection : public ahd::Projection
{
public:
  explicit vtkAHDProjection(vtkAbstractTransform* transform)
    : Transform(transform)
  {
  }

  /// Who is told of progress, and the threads that work. REQUIRES: it outlives the projection.
  void SetContext(const vtkAHDContext& context) { this->Context = &context; }

  bool project(const ahd::PointView& points, double* to, const ahd::Context&) const override;

private:
  bool ProjectInTurn(const ahd::PointView& points, double* to) const;

  const vtkSmartPointer<vtkAbstractTransform> Transform;
  const vtkAHDContext* Context = nullptr;
};

/// Where points lie from the plane, as a transform. Far from the coordinates' origin it rounds more
/// than Plane::project(), as a matrix cannot subtract before it multiplies.
vtkSmartPointer<vtkTransform> vtkAHDMakeTransform(const ahd::Plane& plane);

#endif
