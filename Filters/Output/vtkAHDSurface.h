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
 * straight into the memory of VTK's arrays. All functions throw vtkAHDStop on an abort or
 * if the engine fails, and std::bad_alloc.
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

  /// Points and point data: the input's, or, if points were added, a copy followed by these;
  /// on request, coinciding points at their mean.
  void WritePoints(const vtkAHDInput& input, ahd::RunResult& made) const;

  /// The cells: triangles, and the lines and vertices that replace some under limits of size.
  /// Makes the selection. @pre the points are written.
  void WriteCells(ahd::RunResult& made);

  /// The requested arrays of points and cells. @pre WriteCells().
  void AddArrays(ahd::RunResult& made) const;

  /// The field data array "Crossings", at most a thousand rows; none, and none of the input's, if
  /// nothing crosses.
  void AddCrossings(const ahd::RunResult& made) const;

  /// The same, of these pairs of cells.
  static void WriteCrossings(
    const std::vector<std::array<std::int64_t, 2>>& cells, vtkPolyData* output);

  /// Leaves the points of the cells alone, in their order, with their data, and adds their ids.
  /// Without cells all points stay. @pre all else is written.
  void KeepPointsOfCells() const;

private:
  ahd::Status WriteWithNeighbors(ahd::RunResult& made, std::int32_t* corners);

  const vtkAHDSettings& Settings;
  const vtkAHDContext& Context;
  vtkPolyData* const Output;
  vtkSmartPointer<vtkIdTypeArray> Neighbors; ///< if requested, from WriteCells() on
};

#endif
