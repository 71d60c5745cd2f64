// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDCellArrays_h
#define vtkAHDCellArrays_h

#include "Engine/Triangulate.h"
#include "Output/vtkAHDAlpha.h"

#include <cstddef>
#include <vector>

class vtkAHDProgress;
class vtkPolyData;

/**
 * Which cells the surface has: verts, then lines, then those of the triangles that were kept. What
 * the engine knows of each triangle becomes cell data, one row per cell.
 *
 * Everything here throws std::bad_alloc if there is no room.
 */
class vtkAHDCellArrays
{
public:
  /// As many triangles, all kept, and nothing else.
  explicit vtkAHDCellArrays(std::size_t triangles = 0)
    : Triangles(triangles)
    , KeptCount(triangles)
  {
  }

  /// Puts what `alpha` selected into the surface in place of its triangles.
  void Replace(const vtkAHDAlpha& alpha, vtkPolyData* surface);

  std::size_t GetNumberOfDropped() const { return this->Triangles - this->KeptCount; }

  /// Adds the cell array "Neighbors": for each triangle the cells on the other side of its edges
  /// (first to second corner, second to third, third to first), -1 where there is none; -1 for
  /// verts and lines. Cells are numbered as VTK numbers them: verts, lines, triangles.
  ahd::Status AddNeighbors(
    ahd::Triangulator& triangulator, vtkPolyData* surface, vtkAHDProgress& progress) const;

  /// Adds the cell array "ConstraintEdges": bits 1, 2, 4 for the three edges in this order; 0 for
  /// verts and lines.
  ahd::Status AddConstraintEdges(
    ahd::Triangulator& triangulator, vtkPolyData* surface, vtkAHDProgress& progress) const;

  /// Adds the cell array "RegionId": -1 for verts and lines.
  ahd::Status AddRegionIds(
    ahd::Triangulator& triangulator, vtkPolyData* surface, vtkAHDProgress& progress) const;

  /// Upper estimate of the bytes that they allocate for so many points, per array: one with
  /// `width` numbers a triangle.
  static std::size_t EstimateBytes(std::size_t pointCount, std::size_t width)
  {
    return pointCount * 2 * (2 * width + 1) * sizeof(std::int64_t);
  }

private:
  bool IsKept(std::size_t triangle) const { return this->Kept.empty() || this->Kept[triangle]; }
  template <int width, typename Array, typename Value>
  void Add(
    const char* name, const std::vector<Value>& rows, Value without, vtkPolyData* surface) const;

  std::size_t Triangles;
  std::size_t KeptCount;
  std::size_t Before = 0;          // verts and lines
  std::vector<unsigned char> Kept; // one byte per triangle; empty: all are
};

#endif
