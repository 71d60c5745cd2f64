// SPDX-License-Identifier: BSD-3-Clause
//
// The steps of an execution that deal with constraints, and with points near each other.
#include "Execution/vtkAHDRun.h"

#include "Engine/Crossings/Crossings.h"
#include "Engine/Merge/Merge.h"
#include "Output/vtkAHDPointOutput.h"
#include "Pipeline/vtkAHDLoop.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

namespace
{
/// Of the field data array "Crossings".
constexpr std::size_t kMostCrossingRows = 1000;

/// The length of the box's diagonal; the largest double if it is longer.
double Diagonal(const ahd::Bounds& box)
{
  const double length = std::hypot(box.xmax - box.xmin, box.ymax - box.ymin);
  return std::min(length, std::numeric_limits<double>::max());
}
}

/// The source whose own points are triangulated; null if there is none.
vtkPolyData* vtkAHDRun::GetSourceOfPoints() const
{
  const bool wanted = this->Source && this->Source->GetPoints() &&
    this->Source->GetNumberOfPoints() > 0 &&
    this->Filter->SourceMode == vtkAdaptiveHilbertDelaunay2D::SOURCE_COORDINATES;
  return wanted ? this->Source : nullptr;
}

bool vtkAHDRun::HasConstraints() const
{
  return vtkAHDConstraints::CountSegments(this->Source) > 0;
}

/// Points known before the work begins.
std::size_t vtkAHDRun::CountExpectedPoints() const
{
  const vtkPolyData* source = this->GetSourceOfPoints();
  const vtkIdType added = (source ? this->Source->GetNumberOfPoints() : 0) +
    (this->Filter->BoundingTriangulation && !this->IsProjected() ? 8 : 0);
  return static_cast<std::size_t>(
    std::max(this->Points.GetCount(), this->Points.GetInputCount() + added));
}

ahd::Status vtkAHDRun::OpenPoints()
{
  bool all = this->Points.Open(this->Executor, this->Progress);
  vtkPolyData* source = this->GetSourceOfPoints();
  if (all && source)
  {
    all = this->Points.Copy(this->Executor, this->Progress);
    const std::size_t count = static_cast<std::size_t>(source->GetNumberOfPoints());
    double* xyz = this->Points.Add(count);
    vtkPoints* points = source->GetPoints();
    all = all &&
      vtkAHDLoop(count, this->Executor, this->Progress,
        [points, xyz](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            points->GetPoint(static_cast<vtkIdType>(i), xyz + 3 * i);
          }
        });
  }
  return all ? ahd::Status::Ok : ahd::Status::Cancelled;
}

ahd::Status vtkAHDRun::Merge()
{
  const double tolerance = this->Filter->Tolerance;
  if (tolerance == 0.0)
  {
    return ahd::Status::Ok;
  }
  ahd::Bounds box;
  if (!this->Points.FindBounds(this->Executor, this->Progress, box))
  {
    return ahd::Status::Cancelled;
  }
  ahd::MergedPoints merged;
  const ahd::Status status = ahd::mergeWithin(
    this->Points.View(), tolerance * Diagonal(box), &this->Progress, merged);
  this->Progress.Finish();
  if (status == ahd::Status::Ok && !merged.pairs.empty())
  {
    this->Points.SetSkipped(std::move(merged.skip));
    this->Merged = std::move(merged.pairs);
  }
  return status;
}

ahd::Status vtkAHDRun::ReadConstraints()
{
  if (!this->HasConstraints())
  {
    return ahd::Status::Ok;
  }
  this->Progress.beginPhase(ahd::Phase::Split); // for the time it takes
  const bool added = this->GetSourceOfPoints() != nullptr;
  const bool own = this->Filter->SourceMode == vtkAdaptiveHilbertDelaunay2D::SOURCE_IDS;
  const vtkIdType firstId = own ? 0 : this->Points.GetInputCount();
  const vtkIdType idCount = own ? this->Points.GetInputCount()
    : added                     ? this->Source->GetNumberOfPoints()
                                : 0;
  const bool all = this->Constraints.Read(this->Source, firstId, idCount, this->Progress) &&
    this->Constraints.Follow(this->Merged, this->Progress);
  this->Progress.Finish();
  return all ? ahd::Status::Ok : ahd::Status::Cancelled;
}

ahd::Status vtkAHDRun::Split()
{
  if (this->Constraints.IsEmpty() ||
    this->Filter->CrossingMode != vtkAdaptiveHilbertDelaunay2D::SPLIT)
  {
    return ahd::Status::Ok;
  }
  ahd::SplitConstraints split;
  const ahd::Status status = ahd::splitAtCrossings(
    this->Points.View(), this->Constraints.View(), &this->Progress, split);
  this->Progress.Finish();
  if (status != ahd::Status::Ok || split.rounds == 0)
  {
    return status;
  }
  if (!split.points.empty())
  {
    if (!this->Points.Copy(this->Executor, this->Progress))
    {
      return ahd::Status::Cancelled;
    }
    this->AddSplitPoints(split.points);
  }
  this->Constraints.Replace(std::move(split.ids), std::move(split.offsets));
  const std::size_t bytes = this->EstimateBytes();
  this->Filter->MemoryEstimate = static_cast<vtkTypeInt64>(bytes / 1024);
  return this->Filter->MemoryEstimate > this->Limit ? ahd::Status::OutOfMemory : status;
}

/// Adds the points, and keeps between which others they lie. REQUIRES: Constraints are those that
/// were split.
void vtkAHDRun::AddSplitPoints(const std::vector<ahd::CrossingPoint>& points)
{
  double* place = this->Points.Add(points.size());
  this->Crossings.reserve(points.size());
  for (const ahd::CrossingPoint& p : points)
  {
    const auto a = this->Constraints.GetEnds(p.chainA, p.segmentA);
    const auto b = this->Constraints.GetEnds(p.chainB, p.segmentB);
    this->Crossings.push_back({ { { a[0], a[1], b[0], b[1] } }, { { p.alongA, p.alongB } } });
    if (this->CrossingCells.size() < kMostCrossingRows)
    {
      this->CrossingCells.push_back(
        { { this->Constraints.GetCell(p.chainB), this->Constraints.GetCell(p.chainA) } });
    }
    *place++ = p.at.x;
    *place++ = p.at.y;
    *place++ = 0.0;
  }
  this->FindCrossingHeights();
}

vtkIdType vtkAHDRun::GetFirstCrossing() const
{
  return this->Points.GetCount() - static_cast<vtkIdType>(this->Crossings.size());
}

void vtkAHDRun::FindCrossingHeights()
{
  double* places = this->Points.GetPlaces() + 3 * this->GetFirstCrossing();
  for (std::size_t k = 0; k < this->Crossings.size(); ++k)
  {
    places[3 * k + 2] = vtkAHDInterpolate(this->Crossings[k],
      [this](vtkIdType id) { return this->Points.GetPoint(static_cast<std::size_t>(id))[2]; });
  }
}

ahd::Status vtkAHDRun::Constrain()
{
  if (this->Constraints.IsEmpty())
  {
    return ahd::Status::Ok;
  }
  const ahd::Status status = this->Triangulator.constrain(
    this->Constraints.View(), static_cast<ahd::FillRule>(this->Filter->FillRule), &this->Progress);
  this->Progress.Finish();
  return status;
}

ahd::Status vtkAHDRun::WritePoints()
{
  if (this->Points.GetAddedCount() > 0)
  {
    const vtkAHDPointOutput points(
      this->Input, this->GetSourceOfPoints(), this->Points, this->IsProjected(), this->Crossings);
    return points.Write(this->Surface, this->Executor, this->Progress);
  }
  this->Surface->SetPoints(this->Input->GetPoints());
  this->Surface->GetPointData()->PassData(this->Input->GetPointData());
  return ahd::Status::Ok;
}

/// Adds the field data array "Crossings" if there are any; else there is none.
void vtkAHDRun::AddCrossings()
{
  for (const ahd::LeftOut& out : this->Triangulator.constraints().leftOut)
  {
    if (this->CrossingCells.size() == kMostCrossingRows)
    {
      break;
    }
    this->CrossingCells.push_back(
      { { this->Constraints.GetCell(out.chain), this->Constraints.GetCell(out.otherChain) } });
  }
  if (this->CrossingCells.empty())
  {
    this->Surface->GetFieldData()->RemoveArray("Crossings"); // the input's
    return;
  }
  vtkNew<vtkIdTypeArray> rows;
  rows->SetName("Crossings");
  rows->SetNumberOfComponents(2);
  for (const auto& cells : this->CrossingCells)
  {
    rows->InsertNextValue(cells[0]);
    rows->InsertNextValue(cells[1]);
  }
  this->Surface->GetFieldData()->AddArray(rows);
}

void vtkAHDRun::WarnOfConstraints()
{
  const ahd::ConstraintReport& report = this->Triangulator.constraints();
  const vtkAHDConstraints::UnfitIds& unfit = this->Constraints.GetUnfitIds();
  // The engine counts pieces where segments were split.
  const std::string ofAll = this->Filter->CrossingMode == vtkAdaptiveHilbertDelaunay2D::SPLIT
    ? " segments or pieces of segments"
    : " of " + std::to_string(report.segments) + " segments";
  std::ostringstream loops;
  if (report.unfilledLoops > 0)
  {
    loops << " " << report.unfilledLoops
          << (report.unfilledLoops == 1 ? " polygon bounds" : " polygons bound")
          << " nothing, since a segment is missing.";
  }
  if (report.crossing > 0)
  {
    const ahd::LeftOut& first = report.leftOut[0];
    vtkWarningWithObjectMacro(this->Filter,
      "" << report.crossing << ofAll
         << " of the source were left out, since they cross others that come before "
            "them; the first is in cell "
         << this->Constraints.GetCell(first.chain) << " and crosses cell "
         << this->Constraints.GetCell(first.otherChain) << "." << loops.str());
    loops.str("");
  }
  if (unfit.Count > 0)
  {
    const bool own = this->Filter->SourceMode == vtkAdaptiveHilbertDelaunay2D::SOURCE_IDS;
    vtkWarningWithObjectMacro(this->Filter,
      "" << report.withoutVertex << ofAll << " of the source are no constraints: " << unfit.Count
         << " of the ids in its cells are not those of points, the first is " << unfit.FirstId
         << " in cell " << unfit.FirstCell << ". They refer to the points of "
         << (own ? "the input (see SourceMode)." : "the source.") << loops.str());
  }
  else if (report.withoutVertex > 0 && this->DelaunayTriangles > 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "" << report.withoutVertex << ofAll
         << " of the source are no constraints, since an end of theirs is a point that "
            "was rejected, is skipped or lies beyond InsertionLimit."
         << loops.str());
  }
}
