// SPDX-License-Identifier: BSD-3-Clause
//
// The memory that an execution needs.
#include "Execution/vtkAHDExecution.h"

#include "Engine/Core/Memory.h"
#include "Engine/Crossings/Crossings.h"
#include "Output/vtkAHDOrderOutput.h"
#include "Output/vtkAHDPointOutput.h"
#include "Output/vtkAHDSurface.h"
#include "Output/vtkAHDVoronoi.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>

/// Crossings are known once they are split, boxes once the points are sorted.
std::size_t vtkAHDExecution::EstimateBytes() const
{
  const std::size_t count = this->Known.Points;
  std::size_t before = this->BytesBefore + this->Input.EstimateBytes() +
    ahd::preparationMemoryEstimate(this->Input.GetRequest());
  std::size_t bytes = ahd::triangulationMemoryEstimate(count, this->Options);
  std::size_t toSplit = 0; // what is given back before the triangulation
  if (this->Known.Crossings > 0)
  {
    before += count * (3 * sizeof(double) + 1) +
      this->Known.Crossings * sizeof(ahd::CrossingOrigin);
    toSplit = ahd::splitMemoryEstimate(0, this->Known.Crossings);
  }
  if (this->Known.Segments > 0)
  {
    bytes += ahd::constraintMemoryEstimate(count, this->Known.Segments + 2 * this->Known.Crossings);
  }
  if (this->Settings.MayTrimRim())
  {
    bytes += ahd::trimMemoryEstimate(count);
  }
  return before + std::max(toSplit, bytes + this->EstimateTables() + this->EstimateOutputs());
}

/// What is made of a triangulation to be looked up in it.
std::size_t vtkAHDExecution::EstimateTables() const
{
  const vtkAHDSettings& settings = this->Settings;
  const std::size_t count = this->Known.Points;
  const bool looksUp = settings.Samples || settings.LimitsSize() || settings.GenerateNeighbors ||
    settings.GenerateRegionIds || settings.GenerateConstraintEdges || settings.GenerateVoronoi ||
    settings.ShowMeans || settings.HeightsFromSurface || this->Known.Crossings > 0;
  // where one of several points stands for a vertex: the vertex of each point, twice
  const bool chooses = settings.Insertion.representative != ahd::Representative::FirstId;
  return (chooses ? 2 * sizeof(ahd::Index) * count : 0) +
    (looksUp ? ahd::tableMemoryEstimate(count) : 0) +
    (settings.LimitsSize() ? ahd::selectionMemoryEstimate(count) : 0) +
    (settings.GenerateVoronoi ? ahd::voronoiMemoryEstimate(count) : 0);
}

/// What is left behind at most, the tables of an interpolation and the points included.
std::size_t vtkAHDExecution::EstimateLeft() const
{
  const std::size_t count = this->Known.Points;
  return this->EstimateBytes() - this->EstimateOutputs() + ahd::tableMemoryEstimate(count) +
    (3 * sizeof(double) + 1) * count;
}

std::size_t vtkAHDExecution::EstimateOutputs() const
{
  const vtkAHDSettings& settings = this->Settings;
  const std::size_t count = this->Known.Points;
  std::size_t bytes = this->BytesBehind +
    (settings.Samples ? vtkAHDSurface::EstimateMeanBytes(count, settings)
                      : vtkAHDSurface::EstimateBytes(count, settings));
  if (count > this->Input.GetRequest().points.count)
  {
    bytes += vtkAHDPointOutput::EstimateBytes(this->Input.GetInput(), count);
  }
  if (settings.GenerateVoronoi)
  {
    // The polygons have a copy of the point data.
    bytes += vtkAHDVoronoi::EstimateBytes(count) +
      1024 *
        static_cast<std::size_t>(this->Input.GetInput()->GetPointData()->GetActualMemorySize());
  }
  if (settings.WantsOrder())
  {
    const std::size_t limit = this->Options.insertionLimit;
    const std::size_t inserted = limit > 0 ? std::min(limit, count) : count;
    bytes += vtkAHDOrderOutput::EstimateBytes(settings.GenerateInsertionCurve ? inserted : 0) +
      vtkAHDOrderOutput::EstimateBoxBytes(this->Known.Boxes);
  }
  return bytes;
}

void vtkAHDExecution::UpdateEstimate()
{
  this->Report.Estimate = static_cast<vtkTypeInt64>(this->EstimateBytes() / 1024);
}

/// Are there not too many points, and is there memory for it all, as far as that is known before?
bool vtkAHDExecution::FitsInMemory()
{
  if (this->Known.Points > ahd::kMaximumPoints)
  {
    this->Report.Status = ahd::Status::TooManyPoints;
    return false;
  }
  // What was kept for this execution is part of the estimate. With a limit, all of it is given back
  // where it might be too much.
  const std::size_t bytes = this->EstimateBytes();
  const bool isLimited = this->Settings.MemoryLimit > 0;
  this->Report.IsLimited = isLimited;
  vtkAHDOutputMemory& outputs = this->Context.GetOutputMemory();
  if (isLimited && this->Workspace.bytes() / 1024 > bytes / 1024)
  {
    this->Workspace.release();
  }
  if (isLimited &&
    static_cast<vtkTypeInt64>((bytes + outputs.GetBytes()) / 1024) > this->Settings.MemoryLimit)
  {
    outputs.Release(); // arrays may be smaller than the memory that they find
  }
  constexpr vtkTypeInt64 kPlenty = vtkTypeInt64(1) << 50;
  const std::size_t held = this->Workspace.bytes() + outputs.GetBytes() + this->BytesBefore;
  this->Report.Limit = std::min(kPlenty,
    isLimited ? this->Settings.MemoryLimit
              : static_cast<vtkTypeInt64>(ahd::availableMemory() / 1024 + held / 1024));
  this->Report.Estimate = static_cast<vtkTypeInt64>(bytes / 1024);
  this->Report.IsRefused = this->Report.Estimate > this->Report.Limit;
  if (this->Report.IsRefused)
  {
    this->Report.Status = ahd::Status::OutOfMemory;
    return false;
  }
  const std::size_t left = (static_cast<std::size_t>(this->Report.Limit) + 1) * 1024 - 1 - bytes;
  this->Report.MostBoxes = left / vtkAHDOrderOutput::EstimateBoxBytes(1);
  this->Options.mostBoxes = this->Report.MostBoxes;
  this->Report.MostCrossings = this->FindMostCrossings();
  return true;
}

/// How many crossings there is memory for, and for all that comes of them.
std::size_t vtkAHDExecution::FindMostCrossings()
{
  const Sizes known = this->Known;
  std::size_t most = 0, tooMany = ahd::kMaximumPoints + 1;
  while (tooMany - most > 1)
  {
    this->Known.Crossings = most + (tooMany - most) / 2;
    this->Known.Points = known.Points + this->Known.Crossings;
    const bool fits = this->EstimateBytes() / 1024 <= static_cast<std::size_t>(this->Report.Limit);
    (fits ? most : tooMany) = this->Known.Crossings;
  }
  this->Known = known;
  return most;
}
