// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDOutput_h
#define vtkAHDOutput_h

#include "Engine/Merge/Merge.h"
#include "Engine/Triangulate.h"
#include "vtkType.h"

#include <vector>

class vtkAHDProgress;
class vtkPolyData;

/**
 * The engine's result as a vtkPolyData: the triangles, which the engine writes straight into the
 * memory of the cell array, and what there is to say of each point.
 *
 * Everything here throws std::bad_alloc if there is no room.
 */
namespace vtkAHDOutput
{
/// Upper estimate of the bytes that the functions below allocate; `idArrays` says how many of the
/// point arrays are asked for.
std::size_t EstimateBytes(std::size_t pointCount, std::size_t idArrays);

/// Gives `output` the triangles, and no other cells. Returns Cancelled if the filter is to abort,
/// else Ok.
ahd::Status WriteTriangles(ahd::Triangulator& triangulator, vtkPolyData* output,
  ahd::Executor& executor, vtkAHDProgress& progress);

/// Adds a count of the run as field data.
void AddCount(vtkPolyData* output, const char* name, vtkIdType count);

/// Adds the point array "Fate", unless cancelled; that of a merged point is that of the one kept.
/// REQUIRES: `output` has the points that were triangulated.
ahd::Status AddFate(const ahd::Triangulator& triangulator,
  const std::vector<ahd::MergedPoint>& merged, vtkPolyData* output, ahd::Executor& executor,
  vtkAHDProgress& progress);

/// Adds the point array "InsertionRank", unless cancelled. REQUIRES: `output` has the points that
/// were triangulated, with Options::keepOrder.
ahd::Status AddInsertionRank(const ahd::Triangulator& triangulator, vtkPolyData* output,
  ahd::Executor& executor, vtkAHDProgress& progress);
}

#endif
