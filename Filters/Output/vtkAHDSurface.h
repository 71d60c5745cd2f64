// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSurface_h
#define vtkAHDSurface_h

#include "Engine/Job/Run.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkAHDInput;
class vtkIdTypeArray;
class vtkPolyData;

/**
 * The first output: a triangulation as a vtkPolyData. The engine writes triangles and arrays
 * straight into the memory of VTK's arrays. Everything here throws vtkAHDStop if the filter is to
 * abort or the engine could not go on, and std::bad_alloc if there is no room.
 */
class vtkAHDSurface
{
public:
  /// Borrows all of them.
  vtkAHDSurface(const vtkAHDSettings& settings, const vtkAHDContext& context, vtkPolyData* output)
    : Settings(settings)
    , Context(context)
    , Output(output)
  {
  }

  /// Points and point data: the input's, or, where points were added, a copy with these behind;
  /// where that is asked for, each place of several points at their mean.
  void WritePoints(const vtkAHDInput& input, ahd::RunResult& made) const;

  /// The cells: triangles, and what the limits on their size leave instead of some. REQUIRES: the
  /// points are there. Makes the selection.
  void WriteCells(ahd::RunResult& made);

  /// The point arrays that are asked for.
  void AddPointArrays(ahd::RunResult& made) const;

  /// The cell arrays that are asked for. REQUIRES: WriteCells().
  void AddCellArrays(ahd::RunResult& made) const;

  /// The field data array "Crossings", at most a thousand rows; none, and none of the input's, if
  /// nothing crosses.
  void AddCrossings(const ahd::RunResult& made) const;

  /// The same, of these pairs of cells.
  static void WriteCrossings(
    const std::vector<std::array<std::int64_t, 2>>& cells, vtkPolyData* output);

private:
  ahd::Status WriteWithNeighbors(ahd::RunResult& made, std::int32_t* corners);

  const vtkAHDSettings& Settings;
  const vtkAHDContext& Context;
  vtkPolyData* const Output;
  vtkSmartPointer<vtkIdTypeArray> Neighbors; ///< if they are asked for, from WriteCells() on
};

#endif
