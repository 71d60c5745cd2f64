// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRings_h
#define vtkAHDRings_h

#include <cstddef>

class vtkPolyData;

namespace ahd
{
struct Outline;
}

/// Writes a closed polyline for each ring, with the cell data "PolygonId" and "IsHole"; and the
/// points that rings pass, in their order in `from`, with their data. Throws std::bad_alloc.
void vtkAHDWriteRings(const ahd::Outline& made, vtkPolyData* from, vtkPolyData* to);

/// The bytes of a point, with its data.
std::size_t vtkAHDRingPointBytes(vtkPolyData* from);

#endif
