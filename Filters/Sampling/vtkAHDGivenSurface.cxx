// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDGivenSurface.h"

#include "Engine/Surface/FindTriangles.h"
#include "Engine/Triangulate.h"
#include "Input/vtkAHDInput.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDOutputArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace
{
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

void vtkAHDLeaveToSurface(vtkAHDSettings& settings)
{
  settings.options.representative = ahd::Representative::FirstId;
  settings.options.insertionLimit = 0;
  settings.limits = ahd::SizeLimits();
  settings.idsAreOfInput = true;
  settings.AddSourcePoints = false;
  settings.heightsFromSurface = false;
  settings.split = false;
  settings.tolerance = 0.0;
  settings.showsMeans = false;
  settings.bounding = false;
  settings.rim = ahd::RimKind::ConvexHull;
}

vtkIdType vtkAHDCountAddedPoints(vtkPolyData* surface)
{
  const vtkIdType added = CountOf(surface, "NumberOfAddedPoints");
  return added > 0 && added < surface->GetNumberOfPoints() ? added : 0;
}

ahd::Plane vtkAHDFitPlaneOf(
  const vtkAHDSettings& settings, vtkPolyData* surface, const vtkAHDContext& context)
{
  vtkAHDInput view(settings, surface, nullptr);
  view.Open(context);
  ahd::PointView given = view.GetRequest().points;
  given.count -= static_cast<std::size_t>(vtkAHDCountAddedPoints(surface));
  ahd::Plane plane;
  context.Check(plane.fit(given, context));
  return plane;
}

vtkAHDGivenSurface::vtkAHDGivenSurface(vtkPolyData* surface)
  : Surface(surface)
  , Cells(surface->GetPolys(), "triangles of the surface")
{
}

void vtkAHDGivenSurface::Open(const vtkAHDContext& context)
{
  if (this->Triangles.cells == 0)
  {
    this->Triangles = this->Cells.Open(context);
  }
}

std::int64_t vtkAHDGivenSurface::IdAt(std::size_t k) const
{
  return this->Triangles.ids32 ? this->Triangles.ids32[k] : this->Triangles.ids64[k];
}

vtkSmartPointer<vtkUnsignedCharArray> vtkAHDGivenSurface::MarkOthers(const vtkAHDContext& context)
{
  this->Open(context);
  const vtkIdType points = this->Surface->GetNumberOfPoints();
  auto marks = vtkAHDNewArray<vtkUnsignedCharArray>(points);
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  unsigned char* const mark = marks->GetPointer(0);
  std::fill_n(mark, static_cast<std::size_t>(points), vtkDataSetAttributes::HIDDENPOINT);
  for (std::size_t k = 0; k < this->Triangles.ids; ++k)
  {
    if (k % (std::size_t(1) << 14) == 0)
    {
      context.StopIfAborted();
    }
    const std::int64_t id = this->IdAt(k);
    if (id >= 0 && id < points)
    {
      mark[id] = 0;
    }
  }
  return marks;
}

std::size_t vtkAHDGivenSurface::FindOnce(
  ahd::Triangulation& triangulation, std::vector<unsigned char>& kept, const vtkAHDContext& context)
{
  ahd::FoundTriangles found;
  const std::size_t count = this->Triangles.cells;
  context.Check(this->Triangles.ids32
      ? ahd::findTriangles(triangulation, this->Triangles.ids32, count, context, found)
      : ahd::findTriangles(triangulation, this->Triangles.ids64, count, context, found));
  kept = std::move(found.kept);
  this->Missing = std::move(found.missing);
  return this->Missing.size();
}

void vtkAHDGivenSurface::AddEdge(std::size_t triangle, std::size_t edge)
{
  this->Ends.push_back(this->IdAt(3 * triangle + edge));
  this->Ends.push_back(this->IdAt(3 * triangle + (edge + 1) % 3));
}

/// Makes room for so many. The memory that they and what constrains by them take is known only
/// here: the report is told, and where there is none, that is the end.
void vtkAHDGivenSurface::ReserveEdges(std::size_t edges, std::size_t points, vtkAHDReport& report)
{
  const std::size_t bytes = this->Missing.capacity() * sizeof(std::size_t) +
    edges * 3 * sizeof(std::int64_t) + ahd::constraintMemoryEstimate(points, edges);
  report.estimate += bytes / 1024 * 1024;
  if (report.GetEstimate() > report.GetLimit())
  {
    throw vtkAHDStop{ ahd::Status::OutOfMemory };
  }
  this->Ends.reserve(2 * edges);
}

/// Calls with each edge that the array ConstraintEdges names, if it is there.
template <typename Call>
void vtkAHDGivenSurface::ForMarkedEdges(const vtkAHDContext& context, const Call& call) const
{
  auto* edges = vtkAHDOutputArrays::ConstraintEdges.Find(this->Surface->GetCellData());
  if (!edges || edges->GetNumberOfValues() != this->Surface->GetNumberOfCells())
  {
    return;
  }
  const vtkIdType first = this->Surface->GetNumberOfVerts() + this->Surface->GetNumberOfLines();
  for (std::size_t t = 0; t < this->Triangles.cells; ++t)
  {
    if (t % (std::size_t(1) << 14) == 0)
    {
      context.StopIfAborted();
    }
    const unsigned bits = edges->GetValue(first + static_cast<vtkIdType>(t));
    for (std::size_t k = 0; k < 3; ++k)
    {
      if ((bits >> k & 1u) != 0)
      {
        call(t, k);
      }
    }
  }
}

std::size_t vtkAHDGivenSurface::Find(ahd::Triangulation& triangulation,
  std::vector<unsigned char>& kept, vtkAHDReport& report, const vtkAHDContext& context)
{
  this->Open(context);
  this->Ends.clear();
  std::size_t count = 3 * this->FindOnce(triangulation, kept, context);
  this->ForMarkedEdges(context, [&count](std::size_t, std::size_t) { ++count; });
  if (count == 0)
  {
    return 0;
  }
  this->ReserveEdges(count, triangulation.points().count, report);
  for (const std::size_t t : this->Missing)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->AddEdge(t, k);
    }
  }
  this->ForMarkedEdges(context,
    [this](std::size_t t, std::size_t k) { this->AddEdge(t, k); }); // natural neighbours end there
  const std::size_t segments = this->Ends.size() / 2;
  std::vector<std::int64_t> offsets(segments + 1);
  for (std::size_t k = 0; k <= segments; ++k)
  {
    offsets[k] = static_cast<std::int64_t>(2 * k);
  }
  const ahd::ConstraintView edges{ this->Ends.data(), offsets.data(), segments, segments };
  context.Check(ahd::constrain(
    std::move(triangulation), edges, ahd::FillRule::Orientation, context, triangulation));
  return this->FindOnce(triangulation, kept, context);
}

std::size_t vtkAHDGivenSurface::EstimateBytes(vtkPolyData* surface)
{
  const vtkAHDCellsView cells(surface->GetPolys(), nullptr);
  const std::size_t points = static_cast<std::size_t>(surface->GetNumberOfPoints());
  return cells.EstimateBytes() + 3 * points; // a mark, and a byte for each of two triangles
}
