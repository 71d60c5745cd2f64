// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDGivenSurface_h
#define vtkAHDGivenSurface_h

#include "Engine/Surface/Plane.h"
#include "Engine/Triangulation/Triangulation.h"
#include "Execution/vtkAHDReport.h"
#include "Pipeline/vtkAHDCellsView.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkDataObject;
class vtkPolyData;

/// The surface that a data set is, if a vtkAdaptiveHilbertDelaunay2D made it: triangles, as many as
/// its field data say. Else null.
vtkPolyData* vtkAHDFindSurface(vtkDataObject* input);

/// Of the settings of a triangulation leaves those that such a surface has not used up: its plane,
/// memory and how points are inserted.
void vtkAHDLeaveToSurface(vtkAHDSettings& settings);

/// How many of its points, the last ones, were not in the input of the filter that made it.
vtkIdType vtkAHDCountAddedPoints(vtkPolyData* surface);

/// The plane that fits best what the filter that made the surface was given: with points that are
/// no corner, without those that it added. Throws vtkAHDStop and std::bad_alloc.
ahd::Plane vtkAHDFitPlaneOf(
  const vtkAHDSettings& settings, vtkPolyData* surface, const vtkAHDContext& context);

/**
 * The triangles of a surface, to be had in a triangulation of the points that are their corners.
 * Borrows the surface.
 */
class vtkAHDGivenSurface
{
public:
  explicit vtkAHDGivenSurface(vtkPolyData* surface);

  /// A ghost mark for each point that is no corner. Throws vtkAHDStop and std::bad_alloc, as
  /// Find().
  vtkSmartPointer<vtkUnsignedCharArray> MarkOthers(const vtkAHDContext& context);

  /// Makes the triangles of the surface triangles of the triangulation: adds constraints where it
  /// has others, and those that the cell array ConstraintEdges names. Returns how many could not be
  /// had: none, unless the surface folds over itself in the plane. `kept`: as a Selection has it.
  /// Adds what constraints take to the report's estimate, and stops where that is beyond its limit.
  std::size_t Find(ahd::Triangulation& triangulation, std::vector<unsigned char>& kept,
    vtkAHDReport& report, const vtkAHDContext& context);

  /// Upper estimate of the bytes of marks and masks, for so many points; without those of
  /// constraints.
  static std::size_t EstimateBytes(vtkPolyData* surface);

private:
  void Open(const vtkAHDContext& context);
  std::int64_t IdAt(std::size_t k) const;
  std::size_t FindOnce(ahd::Triangulation& triangulation, std::vector<unsigned char>& kept,
    const vtkAHDContext& context);
  void AddEdge(std::size_t triangle, std::size_t edge);
  void ReserveEdges(std::size_t edges, std::size_t points, vtkAHDReport& report);
  template <typename Call>
  void ForMarkedEdges(const vtkAHDContext& context, const Call& call) const;

  vtkPolyData* const Surface;
  vtkAHDCellsView Cells;
  ahd::CellsView Triangles;
  std::vector<std::size_t> Missing;
  std::vector<std::int64_t> Ends;
};

#endif
