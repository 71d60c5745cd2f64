// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleExecution.h"

#include "Engine/Core/Memory.h"
#include "Engine/Triangulate.h"
#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDMessages.h"
#include "Sampling/vtkAHDCommonPlaces.h"
#include "Sampling/vtkAHDGivenSurface.h"
#include "Sampling/vtkAHDSampleBounds.h"
#include "Sampling/vtkAHDSampleInformation.h"
#include "Sampling/vtkAHDSampleOutput.h"
#include "Sampling/vtkAHDSamplePieces.h"
#include "Sampling/vtkAHDSampling.h"

#include "vtkCharArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <new>
#include <utility>

namespace
{
/// As whole KiB, and never beyond what can be counted.
vtkTypeInt64 InKiB(double bytes)
{
  constexpr double kMost = 0x1p60;
  return static_cast<vtkTypeInt64>(std::min(bytes / 1024.0, kMost));
}

/// The most memory of a kept triangulation.
double BytesKept(std::size_t points, const vtkAHDSettings& settings)
{
  return double(ahd::triangulationMemoryEstimate(points, settings.options)) +
    double(ahd::tableMemoryEstimate(points));
}

ahd::GivenTriangles CountsOf(const vtkAHDSampleInputs& inputs)
{
  return inputs.Surface ? vtkAHDGivenSurface(inputs.Surface).GetCounts() : ahd::GivenTriangles();
}

/// Of the input, before it is triangulated.
std::size_t BytesOf(const vtkAHDSampleInputs& inputs)
{
  return inputs.InputBytes +
    (inputs.Surface ? vtkAHDGivenSurface(inputs.Surface).EstimateBytes() : 0);
}
}

vtkAHDSampleExecution::vtkAHDSampleExecution(vtkAlgorithm* filter, const vtkAHDSettings& settings,
  const vtkAHDSampleSettings& wishes, const vtkAHDContext& context, bool keep)
  : Filter(filter)
  , Settings(settings)
  , Wishes(wishes)
  , Context(context)
  , MayKeep(keep)
{
}

vtkAHDSampleExecution::~vtkAHDSampleExecution() = default;

bool vtkAHDSampleExecution::Run(
  const vtkAHDSampleInputs& inputs, vtkAHDSampleMemoryKept& kept, vtkDataSet* output)
{
  ahd::Status status = ahd::Status::Ok;
  try
  {
    this->Context.StopIfAborted();
    this->Silence.emplace(this->Context.GetProgress());
    if (kept.Surface)
    {
      // One that is lent is there between the pieces of an execution alone.
      const bool isLent = kept.Surface->IsLent();
      this->IsKept = isLent ? inputs.Piece > 0
                            : (this->MayKeep || inputs.Piece > 0) &&
          kept.Surface->IsOf(
            inputs.SettingsTimes, inputs.Points, inputs.Source, inputs.Surface, this->Context);
      if (!this->IsKept)
      {
        kept.Surface->GiveBack(kept.Workspace); // its memory is for the new one
        kept.Surface.reset();
      }
    }
    if (inputs.Surface && !this->IsKept)
    {
      this->BorrowSurface(inputs, kept);
    }
    if (this->FindPlaces(inputs) && this->FitsInMemory(inputs, kept))
    {
      this->TakeSurface(inputs, kept);
      if (this->Report.status == ahd::Status::Ok)
      {
        this->Interpolate(inputs, *kept.Surface, output);
        this->Keep(inputs, kept);
        return true;
      }
      vtkAHDSayError(this->Filter, this->Report);
    }
  }
  catch (const vtkAHDStop& stop)
  {
    status = stop.Reason;
    if (status == ahd::Status::BadCells)
    {
      vtkAHDSayBadCells(this->Filter, stop.CellsOf, stop.Cell);
    }
  }
  catch (const std::bad_alloc&)
  {
    status = ahd::Status::OutOfMemory;
  }
  output->Initialize();
  kept.Surface.reset();
  kept.Workspace.release();
  if (status == ahd::Status::OutOfMemory)
  {
    this->Memory.Estimate = std::max(this->Memory.Estimate, this->Report.GetEstimate());
    vtkAHDSayMemory(this->Filter, this->Memory, false);
  }
  return false;
}

/// From the filter that made it, in place of the surface that was kept, if it can be had. In other
/// planes places and raster would go by these settings, and the triangles by those of the other.
void vtkAHDSampleExecution::BorrowSurface(
  const vtkAHDSampleInputs& inputs, vtkAHDSampleMemoryKept& kept)
{
  if (this->Settings.isProjected())
  {
    return;
  }
  vtkSmartPointer<vtkAHDLentTriangulation> lender;
  vtkAHDLentTriangulation::ContentPointer lent = vtkAHDLentTriangulation::Borrow(
    inputs.Surface, this->Context, lender);
  if (lent)
  {
    kept.Surface = std::make_unique<vtkAHDSampledSurface>(
      this->Settings, inputs.Surface, std::move(lent), lender);
    kept.Workspace.release();
    this->IsKept = true;
  }
}

/// Where values are wanted. Returns false if there is no raster, or no memory to find it, which it
/// says.
bool vtkAHDSampleExecution::FindPlaces(const vtkAHDSampleInputs& inputs)
{
  if (!this->FitsToFindPlaces(inputs))
  {
    return false;
  }
  if (inputs.Surface && this->Settings.fitsPlane())
  {
    this->Plane = vtkAHDFitPlaneOf(this->Settings, inputs.Surface, this->Context);
    this->Settings.Plane = &this->Plane;
  }
  if (inputs.Places)
  {
    this->Places = std::make_unique<vtkAHDPlaces>(inputs.Places);
    this->NumberOfPlaces = this->Places->GetCount();
    return true;
  }
  this->Raster = inputs.Raster
    ? *inputs.Raster
    : vtkAHDFindRaster(this->Settings, this->Wishes, inputs.Points, inputs.Source, this->Context);
  this->Covers = vtkAHDCover(inputs.Told, this->Raster);
  vtkAHDSayNoRaster(this->Filter, this->Wishes, this->Raster);
  this->NumberOfPlaces = this->Raster.Cells.columns * this->Raster.Cells.rows;
  return this->Raster.Fault == vtkAHDRasterFault::None ||
    this->Raster.Fault == vtkAHDRasterFault::NoArea;
}

/// What a raster has beside columns and mask: hidden points, and x, y and z of a surface.
double vtkAHDSampleExecution::EstimateRaster() const
{
  return (this->Wishes.AsSurface ? 25.0 : 1.0) * double(this->NumberOfPlaces);
}

/// Interpolating. The first of several pieces answers for all: their outputs stay, and one of them
/// takes more than that at a time.
void vtkAHDSampleExecution::EstimateSampling(const vtkAHDSampleInputs& inputs, std::size_t points)
{
  vtkPointData* const data = inputs.Points->GetPointData();
  const vtkAHDSampleColumns columns(
    this->Wishes, data, data, static_cast<std::size_t>(inputs.Points->GetNumberOfPoints()));
  const auto estimate = [&](const vtkAHDPlaces& places)
  {
    const ahd::PointView view(static_cast<const double*>(nullptr), places.GetCount(), 3);
    return double(places.EstimateBytes(this->Settings.isProjected())) +
      vtkAHDSampling::EstimateBytes(this->Wishes, columns, points, ahd::SamplePlaces(view));
  };
  if (!this->Places)
  {
    const ahd::SampleRaster& cells = this->Raster.Cells;
    this->Memory.Places = double(cells.columns) * double(cells.rows);
    this->BytesOfSampling = this->EstimateRaster() +
      vtkAHDSampling::EstimateBytes(this->Wishes, columns, points, ahd::SamplePlaces(cells));
    if (inputs.PiecesBefore)
    {
      this->CommonPlaces = vtkAHDFindCommonPlaces(
        cells, *inputs.PiecesBefore, this->Context, nullptr);
      const auto again = [&](std::size_t count)
      {
        const ahd::PointView view(static_cast<const double*>(nullptr), count, 2);
        return double(count) * double(sizeof(ahd::Point)) +
          vtkAHDSampling::EstimateBytes(this->Wishes, columns, points, ahd::SamplePlaces(view));
      };
      this->BytesOfSampling += again(this->CommonPlaces) - again(0); // tables are there once
    }
    return;
  }
  if (!inputs.Pieces || inputs.Piece > 0)
  {
    this->Memory.Places = double(this->Places->GetCount());
    this->BytesOfSampling = estimate(*this->Places);
    return;
  }
  double outputs = 0.0, most = 0.0;
  for (std::size_t k = 0; k < inputs.Pieces->GetCount(); ++k)
  {
    const vtkAHDPlaces places(inputs.Pieces->GetPlaces(k));
    const double putOut = columns.EstimateOutputBytes(double(places.GetCount()));
    this->Memory.Places += double(places.GetCount());
    outputs += putOut;
    most = std::max(most, estimate(places) - putOut);
  }
  this->BytesOfSampling = outputs + most;
}

/// `held`: bytes that are part of estimates, not of free memory.
void vtkAHDSampleExecution::FindLimit(double held)
{
  this->Memory.IsLimited = this->Settings.MemoryLimit > 0;
  this->Memory.Limit = this->Memory.IsLimited ? this->Settings.MemoryLimit
                                              : InKiB(double(ahd::availableMemory()) + held);
}

/// Is there memory to find out where the raster lies? That may take a copy of the points. Says if
/// not.
bool vtkAHDSampleExecution::FitsToFindPlaces(const vtkAHDSampleInputs& inputs)
{
  if (inputs.Places || inputs.Raster)
  {
    return true;
  }
  const std::size_t bytes = vtkAHDEstimateBounds(
    this->Settings, this->Wishes, inputs.Points, inputs.Source);
  vtkAHDSampleMemory& memory = this->Memory;
  this->FindLimit(double(inputs.InputBytes));
  if (InKiB(double(bytes) + double(inputs.InputBytes)) <= memory.Limit)
  {
    return true;
  }
  vtkAHDInput view(this->Settings, inputs.Points, inputs.Source);
  ahd::Workspace none;
  view.GiveTriangles(CountsOf(inputs));
  memory.Estimate = InKiB(double(
    vtkAHDExecution(this->Settings, view, none, this->Context, BytesOf(inputs)).EstimateBytes()));
  memory.Points = ahd::expectedPoints(view.GetRequest());
  const auto& dimensions = this->Wishes.Raster.Dimensions;
  const bool isUnknown = this->Wishes.Raster.ByCellSize || this->Wishes.Raster.IsChosen();
  memory.Places = isUnknown ? -1.0 : double(dimensions[0]) * double(dimensions[1]);
  vtkAHDSayMemory(this->Filter, memory, true);
  return false;
}

/// Is there memory for it all? Says if not.
bool vtkAHDSampleExecution::FitsInMemory(
  const vtkAHDSampleInputs& inputs, const vtkAHDSampleMemoryKept& kept)
{
  vtkAHDInput view(this->Settings, inputs.Points, inputs.Source);
  ahd::Workspace none;
  view.GiveTriangles(CountsOf(inputs));
  const vtkAHDExecution execution(this->Settings, view, none, this->Context, BytesOf(inputs));
  const std::size_t points = ahd::expectedPoints(view.GetRequest());
  this->EstimateSampling(inputs, points);
  const double toMake = double(execution.EstimateBytes());
  vtkAHDSampleMemory& memory = this->Memory;
  memory.Points = points;
  memory.Estimate = InKiB(toMake + this->BytesOfSampling);
  this->FindLimit(double(kept.Workspace.bytes()) + double(inputs.InputBytes));
  const double tables = this->IsKept && kept.Surface->IsLent()
    ? double(ahd::tableMemoryEstimate(points))
    : 0.0;
  const double needed = this->BytesOfSampling + (this->IsKept ? tables : toMake);
  const bool isRefused = (memory.IsLimited ? memory.Estimate : InKiB(needed)) > memory.Limit;
  if (isRefused && points <= ahd::kMaximumPoints)
  {
    vtkAHDSayMemory(this->Filter, memory, true);
    return false;
  }
  return true;
}

/// Their weight is about their time, beside that of a plain triangulation, which is 1.
std::vector<double> vtkAHDSampleExecution::StagesBehind(std::size_t points) const
{
  const bool isScan = !this->Places && this->Wishes.Method == ahd::SampleMethod::Linear;
  const double perPlace = isScan                       ? 0.05
    : this->Wishes.Method == ahd::SampleMethod::Linear ? 0.6
                                                       : 2.0;
  const double sampling = 0.1 + perPlace * double(this->NumberOfPlaces) / double(points + 1);
  return { this->Settings.limitsSize() ? 1.5 : 0.0, sampling };
}

/// The surface that was kept, or a new one in its place.
void vtkAHDSampleExecution::TakeSurface(
  const vtkAHDSampleInputs& inputs, vtkAHDSampleMemoryKept& kept)
{
  const std::size_t points = static_cast<std::size_t>(inputs.Points->GetNumberOfPoints());
  if (this->IsKept)
  {
    this->Report.status = ahd::Status::Ok;
    kept.Surface->TakeData(inputs.Points, inputs.Source);
    this->Context.SetStages({ 0.0, this->StagesBehind(points).back() });
    this->Context.NextStage();
    this->Context.NextStage();
    return;
  }
  this->Silence.reset();
  kept.Surface = std::make_unique<vtkAHDSampledSurface>(
    this->Settings, inputs.Points, inputs.Source, inputs.Surface, this->Context);
  vtkAHDExecution execution(
    this->Settings, kept.Surface->GetInput(), kept.Workspace, this->Context, BytesOf(inputs));
  this->Report = kept.Surface->Make(execution,
    static_cast<std::size_t>(std::min(this->BytesOfSampling, 0x1p60)), this->StagesBehind(points));
  this->Triangulated = this->Report.status != ahd::Status::BadCells && !this->Report.isRefused;
  if (this->Report.status != ahd::Status::Ok)
  {
    return;
  }
  this->Memory.Estimate = this->Report.GetEstimate();
  this->Context.NextStage();
  kept.Surface->Select(this->Settings, this->Context, this->Report);
  if (this->Report.foldedTriangles > 0)
  {
    vtkAHDSayFolded(this->Filter, this->Report.triangles, this->Report.foldedTriangles);
    throw vtkAHDStop{ ahd::Status::Cancelled };
  }
  this->Context.NextStage();
  if (!inputs.PiecesBefore)
  {
    vtkAHDSayWarnings(this->Filter, this->Settings, this->Report);
  }
}

void vtkAHDSampleExecution::Interpolate(
  const vtkAHDSampleInputs& inputs, vtkAHDSampledSurface& surface, vtkDataSet* output)
{
  const double begun = this->Context.GetProgress().now();
  const ahd::SamplePlaces places = this->Places
    ? ahd::SamplePlaces(this->Places->Open(this->Settings, surface.GetPoints(), this->Context))
    : ahd::SamplePlaces(this->Raster.Cells);
  const auto heights = surface.MakeHeights(this->Settings, this->Context);
  this->Silence.reset();
  const vtkSmartPointer<vtkPointData> data = surface.MakePointData(this->Context);
  vtkAHDSampleColumns columns(
    this->Wishes, inputs.Points->GetPointData(), data, surface.GetPoints().points().count);
  vtkAHDSampling sampling(
    this->Wishes, surface.GetTriangulation(), surface.GetKept(), this->Context);
  sampling.Run(places, heights.data(), columns);
  if (inputs.Places)
  {
    output->ShallowCopy(inputs.Places);
  }
  else if (auto* grid = vtkStructuredGrid::SafeDownCast(output))
  {
    vtkAHDMakeSurface(places.raster(), columns.GetHeights(), sampling.GetMask()->GetPointer(0),
      this->Context, grid);
  }
  else if (places.count() > 0)
  {
    vtkAHDMakeImage(places.raster(), vtkImageData::SafeDownCast(output));
    if (sampling.GetReport().outside + sampling.GetReport().withoutValue > 0)
    {
      const auto marks = columns.MarkWithoutValue(sampling.GetMask()->GetPointer(0), this->Context);
      marks ? output->GetPointData()->AddArray(marks) : 0;
    }
  }
  this->Context.NextStage();
  this->Context.StopIfAborted();
  columns.AddTo(output->GetPointData());
  if (!this->Wishes.Mask.empty())
  {
    sampling.GetMask()->SetName(this->Wishes.Mask.c_str());
    output->GetPointData()->RemoveArray(this->Wishes.Mask.c_str());
    output->GetPointData()->AddArray(sampling.GetMask());
  }
  this->CountPlaces(places, sampling.GetReport(), surface);
  this->FindMissing(columns, inputs, surface, heights.data());
  if (this->CommonPlaces > 0)
  {
    this->TakeFromCounts(inputs, surface, heights.data(), data);
  }
  this->Seconds = this->Context.GetProgress().now() - begun;
  if (inputs.SaysArrays)
  {
    vtkAHDSayArrayWarnings(this->Filter, this->Wishes, columns);
  }
}

/// The missing values of arrays that have some.
void vtkAHDSampleExecution::FindMissing(const vtkAHDSampleColumns& columns,
  const vtkAHDSampleInputs& inputs, vtkAHDSampledSurface& surface, const double* heights)
{
  const ahd::SampleReport& counts = this->Result.Counts;
  if (counts.withoutValue + counts.leftOut > 0)
  {
    const ahd::PreparedInput& points = surface.GetPoints();
    const std::size_t added = inputs.Surface
      ? static_cast<std::size_t>(vtkAHDCountAddedPoints(inputs.Surface))
      : points.addedCount() + inputs.AddedPoints;
    this->Result.Missing = columns.FindMissing(heights, surface.GetTriangulation(),
      { points.points().count - added, points.firstCrossing() }, this->Context);
  }
}

/// What became of places that ranks before have is not to count.
void vtkAHDSampleExecution::TakeFromCounts(const vtkAHDSampleInputs& inputs,
  vtkAHDSampledSurface& surface, const double* heights, vtkPointData* data)
{
  std::vector<ahd::Point> places;
  places.reserve(this->CommonPlaces);
  vtkAHDFindCommonPlaces(this->Raster.Cells, *inputs.PiecesBefore, this->Context, &places);
  vtkAHDSampleColumns columns(
    this->Wishes, inputs.Points->GetPointData(), data, surface.GetPoints().points().count);
  vtkAHDSampling sampling(
    this->Wishes, surface.GetTriangulation(), surface.GetKept(), this->Context);
  sampling.Run(ahd::SamplePlaces(ahd::PointView(&places[0].x, places.size(), 2)), heights, columns);
  const ahd::SampleReport& others = sampling.GetReport();
  ahd::takeCounts(others, this->Result.Counts);
  for (vtkAHDMissingValues& missing : this->Result.Missing)
  {
    missing.Places -= columns.CountMissingOf(missing.Name);
  }
}

void vtkAHDSampleExecution::CountPlaces(
  const ahd::SamplePlaces& places, const ahd::SampleReport& counts, vtkAHDSampledSurface& surface)
{
  this->Result.Counts = counts;
  this->Result.Triangles = surface.GetTriangleCount();
  if (counts.outside == 0 || counts.valued > 0)
  {
    return;
  }
  this->Result.Surface = vtkAHDBoundsOf(surface.GetPoints().points(), this->Context);
  if (!places.isRaster())
  {
    this->Result.Wanted = vtkAHDBoundsOf(places.points(), this->Context);
    return;
  }
  const ahd::SampleRaster& raster = places.raster();
  const ahd::Point last = raster.at(raster.columns - 1, raster.rows - 1);
  this->Result.Wanted.xmin = raster.origin.x;
  this->Result.Wanted.xmax = last.x;
  this->Result.Wanted.ymin = raster.origin.y;
  this->Result.Wanted.ymax = last.y;
}

/// Leaves the surface to the next execution, or its memory.
void vtkAHDSampleExecution::Keep(const vtkAHDSampleInputs& inputs, vtkAHDSampleMemoryKept& kept)
{
  if (kept.Surface->IsLent())
  {
    if (!inputs.Pieces || inputs.Piece + 1 == inputs.Pieces->GetCount())
    {
      kept.Surface.reset(); // all pieces are interpolated on the same one
    }
    return;
  }
  kept.Surface->DropData();
  const std::size_t points = kept.Surface->GetPoints().points().count;
  const double bytes = BytesKept(points, this->Settings) +
    (inputs.InputBytes > 0 ? double(kept.Surface->CountInputBytes()) : 0.0);
  if (this->MayKeep && InKiB(bytes) <= this->Settings.ReuseLimit)
  {
    if (!this->IsKept)
    {
      kept.Surface->Remember(inputs.SettingsTimes, this->Context);
    }
    kept.Workspace.release(); // the surface has the memory to reuse
    return;
  }
  kept.Surface->GiveBack(kept.Workspace);
  kept.Surface.reset();
  if (InKiB(double(kept.Workspace.bytes())) > this->Settings.ReuseLimit)
  {
    kept.Workspace.release();
  }
}
