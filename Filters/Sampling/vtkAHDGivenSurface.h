// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDGivenSurface_h
#define vtkAHDGivenSurface_h

#include "Engine/Surface/FindTriangles.h"
#include "Engine/Surface/Plane.h"
#include "Pipeline/vtkAHDCellsView.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>

class vtkDataObject;
class vtkPolyData;

/// The surface that a data set is, if a vtkAdaptiveHilbertDelaunay2D made it: triangles, as many as
/// its field data say. Else null.
vtkPolyData* vtkAHDFindSurface(vtkDataObject* input);

/// How many of its points, the last ones, were not in the input of the filter that made it.
vtkIdType vtkAHDCountAddedPoints(vtkPolyData* surface);

/// The plane that fits best what the filter that made the surface was given: with points that are
/// no corner, without those that it added. Throws vtkAHDStop and std::bad_alloc.
ahd::Plane vtkAHDFitPlaneOf(
  const vtkAHDSettings& settings, vtkPolyData* surface, const vtkAHDContext& context);

/**
 * The triangles of a surface, as the engine looks at them. Borrows the surface.
 */
class vtkAHDGivenSurface
{
public:
  explicit vtkAHDGivenSurface(vtkPolyData* surface);

  /// How many triangles; Open() tells where they are.
  ahd::GivenTriangles GetCounts() const;

  /// With the constraints that the cell array ConstraintEdges names. Good as long as this. To be
  /// called once. Throws vtkAHDStop and std::bad_alloc.
  ahd::GivenTriangles Open(const vtkAHDContext& context);

  /// Bytes that Open() takes.
  std::size_t EstimateBytes() const { return this->Cells.EstimateBytes(); }

private:
  vtkPolyData* const Surface;
  vtkAHDCellsView Cells;
};

/// A ghost mark for each point that is no corner of these. Throws vtkAHDStop and std::bad_alloc.
vtkSmartPointer<vtkUnsignedCharArray> vtkAHDMarkOthers(
  const ahd::GivenTriangles& triangles, vtkIdType points, const vtkAHDContext& context);

#endif
