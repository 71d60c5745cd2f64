// SPDX-License-Identifier: BSD-3-Clause
//
// What an execution says of itself: the memory it needs, measures, warnings and errors.
#include "Execution/vtkAHDRun.h"

#include "Output/vtkAHDOrderOutput.h"
#include "Output/vtkAHDOutput.h"
#include "Pipeline/vtkAHDMemory.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

namespace
{
/// mergeWithin's, for each point: its own, those near it, the marks and pairs that are kept.
constexpr std::size_t kBytesToMerge = 140;
/// splitAtCrossings's, for each segment.
constexpr std::size_t kBytesToSplit = 400;
}

/// How many boxes there are shows only when the points are sorted, how many crossings when they are
/// looked for; the rest is known before.
std::size_t vtkAHDRun::EstimateBytes() const
{
  const std::size_t count = this->CountExpectedPoints();
  const std::size_t limit = static_cast<std::size_t>(this->Filter->InsertionLimit);
  const std::size_t idArrays = static_cast<std::size_t>(this->Filter->GeneratePointStatus) +
    static_cast<std::size_t>(this->Filter->GenerateInsertionRank);
  std::size_t bytes = ahd::Triangulator::memoryEstimate(count, this->GetOptions()) +
    vtkAHDOutput::EstimateBytes(count, idArrays) + this->EstimateSourceBytes(count) +
    this->EstimateDuplicateBytes(count) + this->Filter->BytesOfBlocks;
  if (this->IsOrderWanted())
  {
    bytes += vtkAHDOrderOutput::EstimateBytes(limit > 0 ? std::min(limit, count) : count);
  }
  return bytes + this->EstimateExtraBytes();
}

/// Of what constraints, tolerance and added points take.
std::size_t vtkAHDRun::EstimateSourceBytes(std::size_t count) const
{
  const bool adds = count > static_cast<std::size_t>(this->Points.GetInputCount());
  std::size_t bytes = 0;
  if (adds || this->IsProjected() || this->Points.MustBeConverted())
  {
    bytes += vtkAHDWorkingPoints::EstimateBytes(count);
  }
  if (adds)
  {
    bytes += vtkAHDPointOutput::EstimateBytes(this->Input, count);
  }
  if (this->HasConstraints())
  {
    const std::size_t segments = std::max(
      this->Constraints.GetSegmentCount(), vtkAHDConstraints::CountSegments(this->Source));
    const bool splits = this->Filter->CrossingMode == vtkAdaptiveHilbertDelaunay2D::SPLIT;
    bytes += vtkAHDConstraints::EstimateBytes(this->Source) +
      this->Crossings.size() * sizeof(vtkAHDCrossing) + (splits ? segments * kBytesToSplit : 0) +
      ahd::Triangulator::constraintMemoryEstimate(count, segments);
  }
  if (this->Filter->Tolerance > 0.0)
  {
    bytes += count * kBytesToMerge;
  }
  return bytes;
}

bool vtkAHDRun::FitsInMemory()
{
  if (this->CountExpectedPoints() > ahd::kMaximumPoints)
  {
    this->Fail(ahd::Status::TooManyPoints);
    return false;
  }
  // What was kept for this execution is part of the estimate. With a limit, all of it is given back
  // where it might be too much.
  const std::size_t bytes = this->EstimateBytes();
  const bool isLimited = this->Filter->MemoryLimit > 0;
  if (isLimited && this->Triangulator.memoryHeld() / 1024 > bytes / 1024)
  {
    this->Triangulator.release();
  }
  constexpr vtkTypeInt64 kPlenty = vtkTypeInt64(1) << 50;
  const vtkTypeInt64 needed = static_cast<vtkTypeInt64>(bytes / 1024);
  const vtkTypeInt64 held = static_cast<vtkTypeInt64>(
    (this->Triangulator.memoryHeld() + this->Filter->BytesOfBlocks) / 1024);
  this->Limit = std::min(
    kPlenty, isLimited ? this->Filter->MemoryLimit : vtkAHDAvailableMemory() + held);
  this->Filter->MemoryEstimate = needed;
  if (needed > this->Limit)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "Triangulating "
        << this->CountExpectedPoints() << " points may take " << needed << " KiB of memory, but "
        << (isLimited ? "MemoryLimit allows " : "there are ") << this->Limit
        << " KiB. Nothing was computed. Take fewer points, or set MemoryLimit (in KiB) to allow "
           "more.");
    return false;
  }
  const std::size_t left = (static_cast<std::size_t>(this->Limit) + 1) * 1024 - 1 - bytes;
  this->MostBoxes = left / vtkAHDOrderOutput::EstimateBoxBytes(1);
  return true;
}

void vtkAHDRun::AddBoxesToEstimate(std::size_t boxes)
{
  const std::size_t bytes = this->EstimateBytes() + vtkAHDOrderOutput::EstimateBoxBytes(boxes);
  this->Filter->MemoryEstimate = static_cast<vtkTypeInt64>(bytes / 1024);
}

void vtkAHDRun::Fail(ahd::Status status)
{
  this->Surface->Initialize();
  this->Order->Initialize();
  this->Voronoi->Initialize();
  this->Triangulator.release();
  if (status == ahd::Status::TooManyPoints)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "" << this->CountExpectedPoints() << " points are too many: at most " << ahd::kMaximumPoints
         << " can be triangulated.");
  }
  else if (status == ahd::Status::TooManyBoxes)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "The grid of "
        << this->Points.GetCount() << " points has more than " << this->MostBoxes
        << " boxes, and putting out more may take more memory than "
        << (this->Filter->MemoryLimit > 0 ? "MemoryLimit allows, " : "there is, ") << this->Limit
        << " KiB. Nothing was computed. Switch GenerateBoxes off, take fewer points or "
           "a larger Nmax, or set MemoryLimit (in KiB) to allow more.");
  }
  else if (status == ahd::Status::OutOfMemory)
  {
    const bool isLimited = this->Filter->MemoryLimit > 0 &&
      this->Filter->MemoryEstimate > this->Limit;
    vtkErrorWithObjectMacro(this->Filter,
      "Out of memory while triangulating "
        << this->Points.GetCount() << " points; about " << this->Filter->MemoryEstimate
        << " KiB are needed"
        << (isLimited ? ", and MemoryLimit allows " + std::to_string(this->Limit) : std::string())
        << ".");
  }
}

void vtkAHDRun::KeepMeasures()
{
  vtkAdaptiveHilbertDelaunay2D* filter = this->Filter;
  const ahd::ConstraintReport& constraints = this->Triangulator.constraints();
  filter->NumberOfPointsInserted = static_cast<vtkIdType>(this->Report.inserted);
  filter->NumberOfDuplicates = static_cast<vtkIdType>(this->Report.duplicates);
  filter->NumberOfRejectedPoints = static_cast<vtkIdType>(this->Report.notFinite);
  filter->NumberOfSkippedPoints = static_cast<vtkIdType>(
    this->Report.skipped - this->Merged.size());
  filter->NumberOfPointsBeyondLimit = static_cast<vtkIdType>(this->Report.beyondLimit);
  filter->NumberOfTriangles = this->Surface->GetNumberOfPolys();
  filter->NumberOfMergedPoints = static_cast<vtkIdType>(this->Merged.size());
  filter->NumberOfAddedPoints = this->Points.GetAddedCount();
  filter->NumberOfConstraintEdges = static_cast<vtkIdType>(constraints.edges);
  filter->NumberOfCrossings = static_cast<vtkIdType>(
    filter->CrossingMode == vtkAdaptiveHilbertDelaunay2D::SPLIT ? this->Crossings.size()
                                                                : constraints.crossing);
  filter->NumberOfConstraintsLeftOut = static_cast<vtkIdType>(
    constraints.withoutVertex + constraints.crossing);
  filter->NumberOfUnfilledLoops = static_cast<vtkIdType>(constraints.unfilledLoops);
  if (filter->CountWork)
  {
    filter->NP = this->Report.np();
    filter->NR = this->Report.nr();
  }
  this->KeepTimes();
  this->AddCounts();
}

void vtkAHDRun::KeepTimes()
{
  const auto seconds = [this](std::initializer_list<ahd::Phase> phases)
  {
    double sum = 0.0;
    for (const ahd::Phase phase : phases)
    {
      sum += this->Progress.GetSeconds(phase);
    }
    return sum;
  };
  using Phase = ahd::Phase;
  this->Filter->SortSeconds = seconds({ Phase::Merge, Phase::Read, Phase::Sort });
  this->Filter->InsertSeconds = seconds({ Phase::Insert });
  this->Filter->ConstrainSeconds = seconds({ Phase::Split, Phase::Constrain });
  this->Filter->OutputSeconds = seconds({ Phase::Extract, Phase::Fates });
  this->Filter->NumberOfThreadsUsed = static_cast<int>(this->Executor.GetThreadsUsed());
}

/// Field data, with the names of the Get methods.
void vtkAHDRun::AddCounts()
{
  const vtkAdaptiveHilbertDelaunay2D* f = this->Filter;
  const std::pair<const char*, vtkIdType> counts[] = {
    { "NumberOfPointsInserted", f->NumberOfPointsInserted },
    { "NumberOfDuplicates", f->NumberOfDuplicates },
    { "NumberOfRejectedPoints", f->NumberOfRejectedPoints },
    { "NumberOfSkippedPoints", f->NumberOfSkippedPoints },
    { "NumberOfPointsBeyondLimit", f->NumberOfPointsBeyondLimit },
    { "NumberOfTriangles", f->NumberOfTriangles },
    { "NumberOfMergedPoints", f->NumberOfMergedPoints },
    { "NumberOfAddedPoints", f->NumberOfAddedPoints },
    { "NumberOfConstraintEdges", f->NumberOfConstraintEdges },
    { "NumberOfCrossings", f->NumberOfCrossings },
    { "NumberOfConstraintsLeftOut", f->NumberOfConstraintsLeftOut },
    { "NumberOfUnfilledLoops", f->NumberOfUnfilledLoops },
  };
  for (const auto& count : counts)
  {
    vtkAHDOutput::AddCount(this->Surface, count.first, count.second);
  }
}

void vtkAHDRun::Warn()
{
  this->WarnOfPlane();
  if (this->Points.GetMarksAreUnfit())
  {
    vtkWarningWithObjectMacro(this->Filter,
      "The point data array " << vtkDataSetAttributes::GhostArrayName()
                              << " does not have one value for each of the "
                              << this->Points.GetInputCount()
                              << " points, or not of type unsigned char, so no point was skipped.");
  }
  if (this->Report.notFinite > 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "" << this->Report.notFinite << " of " << this->Points.GetCount()
         << " points were left out, since "
         << (this->IsProjected() ? "they have no finite place in the plane of the triangulation"
                                 : "their x or y is NaN or infinite")
         << "; the first is point " << this->Odd.FirstRejected << ".");
  }
  if (this->Odd.OddZ > 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "" << this->Odd.OddZ << " of " << this->Points.GetCount()
         << " points have a z that is NaN or infinite. They are part of the triangulation, which "
            "is computed in x and y, but cannot be drawn.");
  }
  this->WarnOfDropped();
  if (this->DelaunayTriangles == 0 && this->Report.inserted + this->Report.notFinite > 0)
  {
    this->WarnOfNoTriangle();
  }
  if (this->DelaunayTriangles > 0 && this->Report.triangles == 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "There is no triangle, because the polygons of the source keep none of the "
        << this->DelaunayTriangles << " triangles (see FillRule).");
  }
  this->WarnOfConstraints();
}

void vtkAHDRun::WarnOfNoTriangle()
{
  const bool areFew = this->Report.inserted < 3;
  if (this->Report.beyondLimit > 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "There is no triangle yet, because InsertionLimit has only the first "
        << this->Report.inserted << " of " << this->Report.inserted + this->Report.beyondLimit
        << " distinct points inserted, "
        << (areFew ? "fewer than three." : "and these are collinear."));
    return;
  }
  const std::string merged = this->Merged.empty()
    ? std::string()
    : ", of which Tolerance merged " + std::to_string(this->Merged.size()) + " into others";
  vtkWarningWithObjectMacro(this->Filter,
    "There is no triangle, because " << (areFew ? "there are fewer than three distinct points: "
                                                : "all distinct points are collinear: ")
                                     << this->Report.inserted << " distinct points among "
                                     << this->Points.GetCount() << merged << ".");
}
