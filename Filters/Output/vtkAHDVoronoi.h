// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDVoronoi_h
#define vtkAHDVoronoi_h

#include "Engine/Triangulate.h"
#include "Engine/Voronoi/Voronoi.h"

#include <cstddef>

class vtkAHDDuplicates;
class vtkAbstractTransform;
class vtkAHDProgress;
class vtkPolyData;

/**
 * The Voronoi diagram as a vtkPolyData: one polygon per vertex, in ascending order of the smallest
 * id at its place;
 * cell data are the point data of the vertices and "OriginalPointIds" (vtkIdTypeArray).
 *
 * Everything here throws std::bad_alloc if there is no room.
 */
class vtkAHDVoronoi
{
public:
  /// Computes the cells. Returns Ok, Cancelled or OutOfMemory. REQUIRES: `points` were triangulated
  /// and there are no constraints yet, or Options::keepLocations was set for them.
  ahd::Status Compute(ahd::Triangulator& triangulator, const ahd::PointView& points,
    ahd::VoronoiClip clip, vtkAHDProgress& progress, ahd::Executor& executor);

  /// Fills `output`: z is 0. `surface`: has the points that were triangulated and their data, of
  /// which arrays with fewer tuples than points are left out. `shown`: which of several points at
  /// one place the vertex is. Gives up the cells.
  void Write(vtkPolyData* surface, const vtkAHDDuplicates& shown, vtkPolyData* output);

  /// Is this what Write() wrote?
  static bool IsWritten(vtkPolyData* output);

  /// Replaces the cell data of what Write() wrote by those of other point data of the same points.
  static void WriteData(vtkPolyData* surface, vtkPolyData* output);

  /// Moves the polygons from the plane z = 0 to where `toPlane` takes points from. Returns false,
  /// and moves nothing, if the transform has no inverse.
  static bool MoveBack(vtkAbstractTransform* toPlane, vtkPolyData* output);

  /// Upper estimate of the bytes that all this allocates for so many points, their data not
  /// counted.
  static std::size_t EstimateBytes(std::size_t pointCount);

private:
  void WriteCells(vtkPolyData* output);

  ahd::VoronoiCells Cells;
};

#endif
