// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDOutput_h
#define vtkAHDOutput_h

#include "Engine/Triangulate.h"
#include "vtkType.h"

class vtkAHDProgress;
class vtkPointSet;
class vtkPolyData;

/**
 * The engine's result as a vtkPolyData: the input's points and point data, and the triangles, which
 * the engine writes straight into the memory of the cell array.
 *
 * Everything here throws std::bad_alloc if there is no room.
 */
namespace vtkAHDOutput
{
/// Upper estimate of the bytes that the functions below allocate; `idArrays` says how many of the
/// point arrays are asked for.
std::size_t EstimateBytes(std::size_t pointCount, std::size_t idArrays);

/// Gives `output` the points and point data of `input` (shared, not copied), the triangles, and the
/// counts of the run as field data. Returns Cancelled if the filter is to abort, else Ok.
ahd::Status Write(ahd::Triangulator& triangulator, vtkPointSet* input, vtkPolyData* output,
  ahd::Executor& executor, vtkAHDProgress& progress);

/// Adds the point array "Fate", unless cancelled. REQUIRES: `output` has the points that were
/// triangulated.
ahd::Status AddFate(const ahd::Triangulator& triangulator, vtkPolyData* output,
  ahd::Executor& executor, vtkAHDProgress& progress);

/// Adds the point array "InsertionRank", unless cancelled. REQUIRES: `output` has the points that
/// were triangulated, with Options::keepOrder.
ahd::Status AddInsertionRank(const ahd::Triangulator& triangulator, vtkPolyData* output,
  ahd::Executor& executor, vtkAHDProgress& progress);
}

#endif
