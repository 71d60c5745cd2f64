// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDVoronoi_h
#define vtkAHDVoronoi_h

#include "Engine/Voronoi/Voronoi.h"

#include <cstddef>

class vtkAHDContext;
class vtkAbstractTransform;
class vtkPolyData;

/**
 * The Voronoi diagram as a vtkPolyData: one polygon per vertex, in ascending order of the smallest
 * id at its place; cell data are the point data of the vertices and "OriginalPointIds"
 * (vtkIdTypeArray).
 */
namespace vtkAHDVoronoi
{
/// Fills `output`: z is 0. `surface`: has the points that were triangulated and their data, of
/// which arrays with fewer tuples than points are left out. Uses up the cells. Throws vtkAHDStop if
/// the filter is to abort, and std::bad_alloc if there is no room.
void Write(ahd::VoronoiCells&& cells, vtkPolyData* surface, vtkPolyData* output,
  const vtkAHDContext& context);

/// Is this what Write() wrote?
bool IsWritten(vtkPolyData* output);

/// Leaves of its cell data what WriteData() needs. REQUIRES: IsWritten().
void DropData(vtkPolyData* output);

/// Replaces the cell data of what Write() wrote by those of other point data of the same points.
void WriteData(vtkPolyData* surface, vtkPolyData* output);

/// Moves the polygons from the plane z = 0 to where `toPlane` takes points from. Returns false, and
/// moves nothing, if the transform has no inverse.
bool MoveBack(vtkAbstractTransform* toPlane, vtkPolyData* output);
}

#endif
