// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDVoronoi_h
#define vtkAHDVoronoi_h

#include "Engine/Voronoi/Voronoi.h"

#include <cstddef>

class vtkAHDContext;
class vtkAbstractTransform;
class vtkPolyData;

/**
 * The Voronoi diagram as a vtkPolyData: one polygon per vertex with a cell that is not empty (VTK's
 * filters crash on polygons without corners), in ascending order of the smallest id at its place;
 * cell data are the point data of the vertices and "OriginalPointIds" (vtkIdTypeArray).
 */
namespace vtkAHDVoronoi
{
/// Fills `output`: z is 0. `surface`: has the points that were triangulated and their data, of
/// which arrays with fewer tuples than points are left out. Consumes the cells. Throws vtkAHDStop
/// on an abort, and std::bad_alloc.
void Write(ahd::VoronoiCells&& cells, vtkPolyData* surface, vtkPolyData* output,
  const vtkAHDContext& context);

/// Is this an output of Write()?
bool IsWritten(vtkPolyData* output);

/// Keeps only the cell data that WriteData() needs. @pre IsWritten().
void DropData(vtkPolyData* output);

/// Replaces the cell data of an output of Write() by those of other point data of the same points.
void WriteData(vtkPolyData* surface, vtkPolyData* output);

/// Moves the polygons from the plane z = 0 by the inverse of `toPlane`. Returns false, and
/// moves nothing, if the transform has no inverse.
bool MoveBack(vtkAbstractTransform* toPlane, vtkPolyData* output);
}

#endif
