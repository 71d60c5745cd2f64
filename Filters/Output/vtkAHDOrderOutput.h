// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDOrderOutput_h
#define vtkAHDOrderOutput_h

#include "Engine/Prepare/Prepare.h"
#include "Engine/Triangulation/Triangulation.h"
#include "vtkType.h"

class vtkAHDContext;
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
  /// Borrows all of them. REQUIRES: the points were triangulated with Options::keepOrder.
  vtkAHDOrderOutput(const ahd::PreparedInput& points, ahd::Triangulation& triangulation,
    const vtkAHDContext& context);

  /// Fills `output`; with boxes if the engine kept them. Throws vtkAHDStop if the filter is to
  /// abort, and std::bad_alloc if there is no room; then `output` is to be emptied.
  void Write(bool withCurve, vtkPolyData* output);

  /// Upper estimate of the bytes that Write() allocates for so many inserted points and no boxes.
  static std::size_t EstimateBytes(std::size_t pointCount);

  /// Upper estimate of the bytes that so many boxes take beyond this, the engine's included.
  static std::size_t EstimateBoxBytes(std::size_t boxCount);

private:
  void WritePoints(vtkPolyData* output);
  void WriteInserted(double* xyz, vtkIdType* ranks, const vtkIdType* ids);
  void WriteCorners(double* xyz, vtkIdType* ranks, vtkIdType* ids);
  double FindLowestZ() const;
  template <typename IdArray>
  void WriteCells(bool withCurve, vtkPolyData* output);
  void WriteCellData(bool withCurve, vtkPolyData* output);

  const ahd::PreparedInput& Points;
  ahd::Triangulation& Triangulation;
  const vtkAHDContext& Context;
  const std::size_t Inserted;
  const std::size_t Boxes;
};

#endif
