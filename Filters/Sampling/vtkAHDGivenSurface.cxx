// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDGivenSurface.h"

#include "Input/vtkAHDInput.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDOutputArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
// of which each point is in one
constexpr const char* kCountsByStatus[] = { "NumberOfPointsInserted", "NumberOfPointsWithinError",
  "NumberOfPointsBeyondLimit", "NumberOfDuplicates", "NumberOfMergedPoints",
  "NumberOfRejectedPoints", "NumberOfSkippedPoints" };

/// A count that the filter that made the surface has added to it; -1 if there is none.
vtkIdType CountOf(vtkPolyData* surface, const char* name)
{
  auto* count = vtkIdTypeArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray(name));
  return count && count->GetNumberOfValues() == 1 ? count->GetValue(0) : -1;
}
}

vtkPolyData* vtkAHDFindSurface(vtkDataObject* input)
{
  auto* surface = vtkPolyData::SafeDownCast(input);
  if (!surface || surface->GetNumberOfPolys() == 0)
  {
    return nullptr;
  }
  vtkCellArray* const cells = surface->GetPolys();
  const bool isOurs = CountOf(surface, "NumberOfTriangles") == cells->GetNumberOfCells() &&
    surface->GetFieldData()->HasArray("NumberOfPointsInserted") != 0;
  const bool areTriangles = cells->GetNumberOfConnectivityIds() == 3 * cells->GetNumberOfCells() &&
    cells->GetMaxCellSize() == 3;
  return isOurs && areTriangles ? surface : nullptr;
}

vtkIdType vtkAHDCountAddedPoints(vtkPolyData* surface)
{
  const vtkIdType added = CountOf(surface, "NumberOfAddedPoints");
  const vtkIdType count = surface->GetNumberOfPoints();
  vtkIdType all = 0;
  for (const char* const name : kCountsByStatus)
  {
    all += std::max<vtkIdType>(0, CountOf(surface, name));
  }
  auto* const ids = vtkAHDOutputArrays::OriginalPointIds.Find(surface->GetPointData());
  if (all <= count || added <= 0 || !ids || ids->GetNumberOfValues() != count)
  {
    return added > 0 && added < count ? added : 0;
  }
  // a simplified surface has some of them, behind its other points
  const vtkIdType *const begin = ids->GetPointer(0), *const end = begin + count;
  const vtkIdType left = end - std::lower_bound(begin, end, all - added);
  return left < count ? left : 0;
}

ahd::Plane vtkAHDFitPlaneOf(
  const vtkAHDSettings& settings, vtkPolyData* surface, const vtkAHDContext& context)
{
  vtkAHDInput view(settings, surface, nullptr);
  view.Open(context);
  ahd::InputRequest request = view.GetRequest();
  request.unfittedPoints = static_cast<std::size_t>(vtkAHDCountAddedPoints(surface));
  ahd::Plane plane;
  context.Check(ahd::fitPlaneOf(request, context, plane));
  return plane;
}

vtkAHDGivenSurface::vtkAHDGivenSurface(vtkPolyData* surface)
  : Surface(surface)
  , Cells(surface->GetPolys(), "triangles of the surface")
{
}

ahd::GivenTriangles vtkAHDGivenSurface::GetCounts() const
{
  ahd::GivenTriangles counts;
  counts.count = this->Cells.GetCounts().cells;
  return counts;
}

ahd::GivenTriangles vtkAHDGivenSurface::Open(const vtkAHDContext& context)
{
  const ahd::CellsView cells = this->Cells.Open(context);
  auto* edges = vtkAHDOutputArrays::ConstraintEdges.Find(this->Surface->GetCellData());
  const bool fit = edges && edges->GetNumberOfValues() == this->Surface->GetNumberOfCells();
  const vtkIdType first = this->Surface->GetNumberOfVerts() + this->Surface->GetNumberOfLines();
  return { cells.ids32, cells.ids64, cells.cells, fit ? edges->GetPointer(first) : nullptr };
}

vtkSmartPointer<vtkUnsignedCharArray> vtkAHDMarkOthers(
  const ahd::GivenTriangles& triangles, vtkIdType points, const vtkAHDContext& context)
{
  auto marks = vtkAHDNewArray<vtkUnsignedCharArray>(points);
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  context.Check(ahd::markOthers(triangles, static_cast<std::size_t>(points),
    vtkDataSetAttributes::HIDDENPOINT, marks->GetPointer(0), context));
  return marks;
}
