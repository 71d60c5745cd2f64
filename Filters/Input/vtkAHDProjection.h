// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDProjection_h
#define vtkAHDProjection_h

#include "Engine/Prepare/Prepare.h"
#include "vtkAbstractTransform.h"
#include "vtkSmartPointer.h"

class vtkAHDContext;
class vtkTransform;

/**
 * A VTK transform as the engine's Projection. The transform is updated, not changed; a
 * homogeneous one is used by several threads, others, which may not be thread-safe, by this one. A
 * point with a coordinate that is not finite becomes NaN in all three.
 */
class vtkAHDProjection : public ahd::Projection
{
public:
  explicit vtkAHDProjection(vtkAbstractTransform* transform)
    : Transform(transform)
  {
  }

  /// The progress and threads to use. @pre it outlives the projection.
  void SetContext(const vtkAHDContext& context) { this->Context = &context; }

  bool project(const ahd::PointView& points, double* to, const ahd::Context&) const override;

private:
  bool ProjectInTurn(const ahd::PointView& points, double* to) const;

  const vtkSmartPointer<vtkAbstractTransform> Transform;
  const vtkAHDContext* Context = nullptr;
};

/// The plane as a transform: positions in it, and heights above it. Far from the coordinates'
/// origin it rounds more than Plane::project(), as a matrix cannot subtract before it multiplies.
vtkSmartPointer<vtkTransform> vtkAHDMakeTransform(const ahd::Plane& plane);

#endif
