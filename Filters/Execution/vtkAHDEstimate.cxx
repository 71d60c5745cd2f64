// SPDX-License-Identifier: BSD-3-Clause
//
// The memory that an execution needs.
#include "Execution/vtkAHDExecution.h"

#include "Engine/Core/Memory.h"
#include "Output/vtkAHDPointOutput.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>

namespace
{
/// What is wished for, in the engine's words.
ahd::RunWishes WishesOf(const vtkAHDSettings& settings, const ahd::Options& options)
{
  ahd::RunWishes wishes;
  wishes.options = options;
  wishes.alpha = settings.Limits.alpha > 0.0;
  wishes.maximumEdgeLength = settings.Limits.maximumEdgeLength > 0.0;
  wishes.trimsRim = settings.MayTrimRim();
  wishes.showsMeans = settings.ShowMeans;
  wishes.samples = settings.Samples;
  wishes.pointStatus = settings.GeneratePointStatus;
  wishes.insertionRanks = settings.GenerateInsertionRank;
  wishes.neighbors = settings.GenerateNeighbors;
  wishes.regions = settings.GenerateRegionIds;
  wishes.constraintEdges = settings.GenerateConstraintEdges;
  wishes.voronoi = settings.GenerateVoronoi;
  wishes.curve = settings.GenerateInsertionCurve;
  return wishes;
}
}

std::size_t vtkAHDExecution::EstimateBytes() const
{
  ahd::RunWishes wishes = WishesOf(this->Settings, this->Options);
  wishes.perAddedPoint = vtkAHDPointOutput::EstimateBytesPerPoint(this->Input.GetInput());
  // The polygons of the Voronoi diagram have a copy of the point data.
  vtkPointData* const data = this->Input.GetInput()->GetPointData();
  const std::size_t copied = this->Settings.GenerateVoronoi ? data->GetActualMemorySize() : 0;
  return this->BytesBefore + this->BytesBehind + this->Input.EstimateBytes() + 1024 * copied +
    ahd::runMemoryEstimate(this->Input.GetRequest(), wishes, this->Known);
}

/// What is left behind at most: the triangulation, the tables of an interpolation, and copies of
/// points.
std::size_t vtkAHDExecution::EstimateLeft() const
{
  const std::size_t count = this->Known.points;
  const bool isConstrained = this->Known.segments > 0 || this->Settings.MayTrimRim();
  return this->BytesBefore + this->Input.EstimateBytes() +
    ahd::preparedMemoryEstimate(this->Input.GetRequest()) +
    ahd::triangulatedMemoryEstimate(count, this->Options) + ahd::tableMemoryEstimate(count) +
    (isConstrained ? ahd::constraintMemoryEstimate(count, 0) : 0) +
    (this->Settings.LimitsSize() ? 2 * count : 0) + (3 * sizeof(double) + 1) * count;
}

/// Limits what is asked for to what there is memory for. `asked`: of Known.
void vtkAHDExecution::LimitAsked(std::size_t& asked)
{
  const std::size_t most = ahd::mostThatFit(ahd::kTooMuchAsked,
    [&](std::size_t bytes)
    {
      asked = bytes;
      return this->EstimateBytes() / 1024 <= static_cast<std::size_t>(this->Report.Limit);
    });
  asked = 0;
  this->Context.GetAsked().limitTo(most);
}

/// Ends the execution unless the status is Ok: as refused, if what was asked for was.
void vtkAHDExecution::CheckAsked(ahd::Status status)
{
  this->UpdateEstimate();
  this->Report.IsRefused = status == ahd::Status::OutOfMemory &&
    this->Context.GetAsked().wasRefused();
  this->Context.Check(status);
}

void vtkAHDExecution::UpdateEstimate()
{
  this->Report.Estimate = static_cast<vtkTypeInt64>(this->EstimateBytes() / 1024);
}

/// Are there not too many points, and is there memory for it all, as far as that is known before?
bool vtkAHDExecution::FitsInMemory()
{
  if (this->Known.points > ahd::kMaximumPoints)
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
  this->Report.MostBoxes = ahd::mostThatFit(
    ahd::kTooManyBoxes, [this](std::size_t count) { return this->Fits(0, count); });
  this->Options.mostBoxes = this->Report.MostBoxes;
  // How many there is memory for, and for all that comes of them.
  this->Report.MostCrossings = ahd::mostThatFit(
    ahd::kMaximumPoints + 1, [this](std::size_t count) { return this->Fits(count, 0); });
  return true;
}

/// Would there be memory with so many crossings and boxes?
bool vtkAHDExecution::Fits(std::size_t crossings, std::size_t boxes)
{
  const ahd::RunSizes known = this->Known;
  this->Known.crossings = crossings;
  this->Known.points += crossings;
  this->Known.boxes = boxes;
  const std::size_t bytes = this->EstimateBytes();
  this->Known = known;
  return bytes / 1024 <= static_cast<std::size_t>(this->Report.Limit);
}
