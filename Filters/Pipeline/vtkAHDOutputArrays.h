// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#ifndef vtkAHDOutputArrays_h
#define vtkAHDOutputArrays_h

#include "Pipeline/vtkAHDContext.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>

/// An array that is put out: its name, its type, and how many numbers each tuple has.
template <typename Array>
struct vtkAHDOutputArray
{
  const char* Name;
  int Components;

  /// Such an array, not initialised. Throws std::bad_alloc.
  vtkSmartPointer<Array> Make(std::size_t tuples, const vtkAHDContext& context) const
  {
    auto array = context.NewArray<Array>(static_cast<vtkIdType>(tuples) * this->Components);
    array->SetNumberOfComponents(this->Components);
    array->SetName(this->Name);
    return array;
  }

  /// The one of this name and type, or null.
  Array* Find(vtkFieldData* data) const
  {
    return Array::SafeDownCast(data->GetAbstractArray(this->Name));
  }
};

namespace vtkAHDOutputArrays
{
/// The status of each point: its own id if it is a vertex of the surface, that of the vertex that
/// stands for it, -1 (not finite) or -2 (not inserted).
constexpr vtkAHDOutputArray<vtkIdTypeArray> Fate = { "Fate", 1 };
/// The place of each point in the order of insertion; -1: none. Also of the points of the output
/// Insertion order.
constexpr vtkAHDOutputArray<vtkIdTypeArray> InsertionRank = { "InsertionRank", 1 };
/// Which edges of a triangle are edges of the source: the sum of 1, 2 and 4.
constexpr vtkAHDOutputArray<vtkUnsignedCharArray> ConstraintEdges = { "ConstraintEdges", 1 };
/// The number of the region between constraints; -1 for lines and vertices.
constexpr vtkAHDOutputArray<vtkIdTypeArray> RegionId = { "RegionId", 1 };
/// The triangles behind the edges from the first corner, the second, the third; -1: none.
constexpr vtkAHDOutputArray<vtkIdTypeArray> Neighbors = { "Neighbors", 3 };
/// The cells of the source that cross each other, at most a thousand pairs; no array if there is
/// none.
constexpr vtkAHDOutputArray<vtkIdTypeArray> Crossings = { "Crossings", 2 };
/// The ids in the input: of the points of the output Insertion order, of the vertices that the
/// cells of Voronoi belong to.
constexpr vtkAHDOutputArray<vtkIdTypeArray> OriginalPointIds = { "OriginalPointIds", 1 };
/// Of the cells of the output Insertion order: how many divisions made the box.
constexpr vtkAHDOutputArray<vtkIntArray> Level = { "Level", 1 };
/// Of the same cells: the points in the box.
constexpr vtkAHDOutputArray<vtkIdTypeArray> Count = { "Count", 1 };
/// The numbers of the points of all ranks, by the name that VTK's own generator of global ids uses.
constexpr vtkAHDOutputArray<vtkIdTypeArray> GlobalPointIds = { "GlobalPointIds", 1 };
/// The same of the triangles.
constexpr vtkAHDOutputArray<vtkIdTypeArray> GlobalCellIds = { "GlobalCellIds", 1 };
}

#endif
