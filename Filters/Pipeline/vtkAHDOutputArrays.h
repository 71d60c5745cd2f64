// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#ifndef vtkAHDOutputArrays_h
#define vtkAHDOutputArrays_h

#include "Engine/Job/ArrayRows.h"
#include "Pipeline/vtkAHDContext.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>

/// An output array: its name, its type, and the number of components.
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

  /// The array of this name and type, or null.
  Array* Find(vtkFieldData* data) const
  {
    return Array::SafeDownCast(data->GetAbstractArray(this->Name));
  }
};

namespace vtkAHDOutputArrays
{
/// The status of each point: its own id if it is a vertex of the surface, the id of the vertex that
/// stands for it, -1 (rejected), -2 (not inserted) or -3 (left out within the error).
constexpr vtkAHDOutputArray<vtkIdTypeArray> Fate = { "Fate", 1 };
/// How far the surface is from each point; NaN where there is none.
constexpr vtkAHDOutputArray<vtkDoubleArray> Error = { "Error", 1 };
/// The position of each point in the order of insertion; -1: none. Also for the points of the
/// output Insertion order.
constexpr vtkAHDOutputArray<vtkIdTypeArray> InsertionRank = { "InsertionRank", 1 };
/// Which edges of a triangle are edges of the source: the sum of 1, 2 and 4.
constexpr vtkAHDOutputArray<vtkUnsignedCharArray> ConstraintEdges = { "ConstraintEdges", 1 };
/// The number of the region between constraints; -1 for lines and vertices.
constexpr vtkAHDOutputArray<vtkIdTypeArray> RegionId = { "RegionId", 1 };
/// The triangles across the edges that begin at the first corner, the second, the third; -1: none.
constexpr vtkAHDOutputArray<vtkIdTypeArray> Neighbors = { "Neighbors", 3 };
/// The cells of the source that cross each other, at most a thousand pairs; no array if there are
/// none.
constexpr vtkAHDOutputArray<vtkIdTypeArray> Crossings = { "Crossings", 2 };
/// The ids in the input of the points of a simplified surface and of the output Insertion order, of
/// the vertices of the cells of Voronoi, and of the points of a quality mesh; -1 for those that
/// were added.
constexpr vtkAHDOutputArray<vtkIdTypeArray> OriginalPointIds = { "OriginalPointIds", 1 };
/// The number of divisions that made the box, for the cells of the output Insertion order.
constexpr vtkAHDOutputArray<vtkIntArray> Level = { "Level", 1 };
/// The number of points in the box, for the same cells.
constexpr vtkAHDOutputArray<vtkIdTypeArray> Count = { "Count", 1 };
/// Why a triangle of a quality mesh is not as wished: 0, an angle below 60 degrees between
/// segments; 1, there are as many added points as were allowed; 2, an edge is as short as
/// coordinates can tell. -1: it is as wished.
constexpr vtkAHDOutputArray<vtkIntArray> BadReason = { "BadReason", 1 };
/// The cell of the source along which a piece of a segment of a quality mesh lies, the first if
/// there are more; -1: none.
constexpr vtkAHDOutputArray<vtkIdTypeArray> SourceCell = { "SourceCell", 1 };
/// 1: a piece of a segment bounds a quality mesh; 0: it has triangles on both sides.
constexpr vtkAHDOutputArray<vtkUnsignedCharArray> IsBoundary = { "IsBoundary", 1 };
/// The numbers of the points of all ranks, under the name that VTK's own generator of global ids
/// uses.
constexpr vtkAHDOutputArray<vtkIdTypeArray> GlobalPointIds = { "GlobalPointIds", 1 };
/// The same for the triangles.
constexpr vtkAHDOutputArray<vtkIdTypeArray> GlobalCellIds = { "GlobalCellIds", 1 };

/// Calls visit(array, ahd::WantedArray) for each that a setting adds.
template <typename Visit>
void VisitWanted(const Visit& visit)
{
  visit(Fate, ahd::WantedArray::PointStatus);
  visit(Error, ahd::WantedArray::Errors);
  visit(InsertionRank, ahd::WantedArray::InsertionRanks);
  visit(ConstraintEdges, ahd::WantedArray::ConstraintEdges);
  visit(RegionId, ahd::WantedArray::Regions);
  visit(Neighbors, ahd::WantedArray::Neighbors);
}
}

#endif
