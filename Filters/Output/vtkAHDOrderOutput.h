// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDOrderOutput_h
#define vtkAHDOrderOutput_h

#include "Engine/Triangulate.h"
#include "vtkType.h"

class vtkAHDDuplicates;
class vtkAHDWorkingPoints;
class vtkAHDProgress;
class vtkPolyData;

/**
 * The order of the insertion as a vtkPolyData.
 *
 * Points: those that were inserted, in insertion order, then four corners per box (z: the lowest
 * finite one of the points, 0 if there is none), all in double precision. Cells: first the curve, a
 * polyline through the inserted points, if it is asked for and there are two of them at least; then
 * a counterclockwise quadrangle per box, as the boxes were visited. Cell data: "Level" (-1 for the
 * curve) and "Count". Point data: "InsertionRank" and "OriginalPointIds" (both -1 at corners).
 */
class vtkAHDOrderOutput
{
public:
  /// Borrows all of them. REQUIRES: `input` is open and was triangulated with Options::keepOrder.
  vtkAHDOrderOutput(const ahd::Triangulator& triangulator, const vtkAHDWorkingPoints& input,
    const vtkAHDDuplicates& shown, ahd::Executor& executor, vtkAHDProgress& progress);

  /// Fills `output`; with boxes if the engine kept them. Returns Cancelled if the filter is to
  /// abort, else Ok; unless Ok, `output` is to be emptied. Throws std::bad_alloc if there is no
  /// room.
  ahd::Status Write(bool withCurve, vtkPolyData* output);

  /// Upper estimate of the bytes that Write() allocates for so many inserted points and no boxes.
  static std::size_t EstimateBytes(std::size_t pointCount);

  /// Upper estimate of the bytes that so many boxes take beyond this, the engine's included.
  static std::size_t EstimateBoxBytes(std::size_t boxCount);

private:
  ahd::Status WritePoints(vtkPolyData* output);
  bool WriteInserted(double* xyz, vtkIdType* ranks, vtkIdType* ids, const std::int64_t* order);
  bool WriteCorners(double* xyz, vtkIdType* ranks, vtkIdType* ids);
  bool FindLowestZ(double& lowest);
  template <typename IdArray>
  bool WriteCells(bool withCurve, vtkPolyData* output);
  bool WriteCellData(bool withCurve, vtkPolyData* output);

  const ahd::Triangulator& Triangulator;
  const vtkAHDWorkingPoints& Input;
  const vtkAHDDuplicates& Shown;
  ahd::Executor& Executor;
  vtkAHDProgress& Progress;
  const std::size_t Inserted;
  const std::size_t Boxes;
};

#endif
