// SPDX-License-Identifier: BSD-3-Clause
//
// The steps of an execution that look at finished triangles: alpha, cell arrays, the Voronoi
// diagram.
#include "Execution/vtkAHDRun.h"

#include "Output/vtkAHDAlpha.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkAbstractTransform.h"
#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <memory>

std::size_t vtkAHDRun::EstimateExtraBytes() const
{
  const std::size_t count = static_cast<std::size_t>(this->Points.GetCount());
  const vtkAdaptiveHilbertDelaunay2D* filter = this->Filter;
  std::size_t bytes = 0;
  if (filter->Alpha > 0.0 || filter->MaximumEdgeLength > 0.0)
  {
    bytes += vtkAHDAlpha::EstimateBytes(count) + vtkAHDCellArrays::EstimateBytes(count, 3);
  }
  bytes += filter->GenerateNeighbors ? vtkAHDCellArrays::EstimateBytes(count, 3) : 0;
  bytes += filter->GenerateRegionIds ? vtkAHDCellArrays::EstimateBytes(count, 1) : 0;
  bytes += filter->GenerateConstraintEdges ? vtkAHDCellArrays::EstimateBytes(count, 1) : 0;
  if (filter->GenerateVoronoi)
  {
    // The polygons have a copy of the point data.
    bytes += vtkAHDVoronoi::EstimateBytes(count) +
      1024 * static_cast<std::size_t>(this->Input->GetPointData()->GetActualMemorySize());
  }
  return bytes == 0 ? 0 : bytes + ahd::Triangulator::constraintMemoryEstimate(count, 0);
}

ahd::Status vtkAHDRun::MakeVoronoi()
{
  if (!this->Filter->GenerateVoronoi)
  {
    return ahd::Status::Ok;
  }
  return this->Diagram.Compute(this->Triangulator, this->Points.View(),
    static_cast<ahd::VoronoiClip>(this->Filter->VoronoiClip), this->Progress, this->Executor);
}

ahd::Status vtkAHDRun::WriteVoronoi()
{
  if (this->Filter->GenerateVoronoi)
  {
    this->Diagram.Write(this->Surface, this->Shown, this->Voronoi);
    this->IsDiagramInPlane = this->ToPlane &&
      !vtkAHDVoronoi::MoveBack(this->ToPlane, this->Voronoi);
  }
  return ahd::Status::Ok;
}

ahd::Status vtkAHDRun::DropByLength()
{
  this->Cells = vtkAHDCellArrays(this->Triangulator.report().triangles);
  vtkAHDAlpha::Settings settings;
  settings.Alpha = this->Filter->Alpha;
  settings.MaximumEdgeLength = this->Filter->MaximumEdgeLength;
  settings.Tris = this->Filter->AlphaTris != 0;
  settings.Lines = this->Filter->AlphaLines != 0;
  settings.Verts = this->Filter->AlphaVerts != 0;
  const bool isLimited = settings.Alpha > 0.0 || settings.MaximumEdgeLength > 0.0;
  if (!isLimited || this->Points.View().count == 0)
  {
    return ahd::Status::Ok;
  }
  vtkAHDAlpha::Triangulation mesh;
  mesh.Count = this->Triangulator.report().triangles;
  mesh.AreCollinear = this->DelaunayTriangles == 0;
  std::unique_ptr<std::int64_t[]> neighbors;
  std::unique_ptr<std::int64_t[]> fates;
  if (settings.Alpha > 0.0)
  {
    neighbors.reset(new std::int64_t[3 * mesh.Count]);
    fates.reset(new std::int64_t[this->Points.View().count]);
    ahd::Status status = this->Triangulator.writeNeighbors(neighbors.get(), &this->Progress);
    if (status == ahd::Status::Ok)
    {
      status = this->Triangulator.writeFates(fates.get(), &this->Progress, &this->Executor);
    }
    if (status != ahd::Status::Ok)
    {
      return status;
    }
    for (const ahd::MergedPoint& merged : this->Merged)
    {
      fates[merged.id] = fates[merged.keptId];
    }
    if (!this->Shown.Apply(fates.get(), this->Points.View().count, this->Executor, this->Progress))
    {
      return ahd::Status::Cancelled;
    }
    this->Shown.Swap(fates.get());
  }
  mesh.Corners = this->Surface->GetPolys()->GetConnectivityArray32()->GetPointer(0);
  mesh.Neighbors = neighbors.get();
  mesh.Fates = fates.get();
  vtkAHDAlpha alpha(settings, mesh, this->Surface->GetPoints(), this->Points.View());
  if (!alpha.Select(this->Executor, this->Progress))
  {
    return ahd::Status::Cancelled;
  }
  this->Cells.Replace(alpha, this->Surface);
  return ahd::Status::Ok;
}

void vtkAHDRun::WarnOfDropped()
{
  if (this->IsDiagramInPlane)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "The Voronoi diagram lies in the plane z = 0, as Transform has no inverse to take it back to "
      "the points.");
  }
  if (this->Cells.GetNumberOfDropped() > 0 && this->Surface->GetNumberOfCells() == 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "None of " << this->Report.triangles
                 << " triangles is put out, and nothing else: Alpha, its switches and "
                    "MaximumEdgeLength leave nothing.");
  }
}

ahd::Status vtkAHDRun::AddCellArrays()
{
  ahd::Status status = ahd::Status::Ok;
  if (this->Filter->GenerateConstraintEdges)
  {
    status = this->Cells.AddConstraintEdges(this->Triangulator, this->Surface, this->Progress);
  }
  if (status == ahd::Status::Ok && this->Filter->GenerateRegionIds)
  {
    status = this->Cells.AddRegionIds(this->Triangulator, this->Surface, this->Progress);
  }
  if (status == ahd::Status::Ok && this->Filter->GenerateNeighbors)
  {
    status = this->Cells.AddNeighbors(this->Triangulator, this->Surface, this->Progress);
  }
  return status;
}
