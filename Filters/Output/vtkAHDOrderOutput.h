// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDOrderOutput_h
#define vtkAHDOrderOutput_h

#include "Engine/Triangulation/Triangulation.h"

#include <cstddef>

class vtkAHDContext;
class vtkPolyData;

/**
 * The order of the insertion as a vtkPolyData: the engine's drawing
 * (Engine/Surface/OrderDrawing.h).
 *
 * Cells: first the curve, a polyline through the inserted points, if requested and if there are
 * at least two; then a quadrangle per box. Cell data: "Level" and "Count". Point data:
 * "InsertionRank" and "OriginalPointIds".
 */
namespace vtkAHDOrderOutput
{
/// Fills `output`; with boxes if the engine kept them. Throws vtkAHDStop on an abort,
/// and std::bad_alloc; then `output` must be emptied. @pre with a
/// curve, the points were triangulated with Options::keepOrder.
void Write(ahd::Triangulation& triangulation, bool withCurve, vtkPolyData* output,
  const vtkAHDContext& context);
}

#endif
