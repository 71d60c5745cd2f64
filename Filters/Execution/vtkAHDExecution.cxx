// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDExecution.h"

#include "Execution/vtkAHDFingerprint.h"
#include "Execution/vtkAHDLentTriangulation.h"
#include "Output/vtkAHDOrderOutput.h"
#include "Output/vtkAHDPointOutput.h"
#include "Output/vtkAHDSurface.h"
#include "Output/vtkAHDVoronoi.h"
#include "Pipeline/vtkAHDMemoryLimit.h"

#include "vtkAbstractTransform.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <algorithm>
#include <memory>
#include <new>
#include <optional>
#include <utility>

vtkAHDExecution::vtkAHDExecution(const vtkAHDSettings& settings, vtkAHDInput& input,
  ahd::Workspace& workspace, const vtkAHDContext& context, std::size_t bytesBefore)
  : Settings(settings)
  , Input(input)
  , Workspace(workspace)
  , Context(context)
  , BytesBefore(bytesBefore)
{
}

// ----------------------------------------------------------------------------------------- memory

/// Memory besides that of the engine's estimate.
ahd::CallersMemory vtkAHDExecution::OwnMemory(std::size_t bytesBehind) const
{
  // The polygons of the Voronoi diagram have a copy of the point data.
  vtkPointData* const data = this->Input.GetInput()->GetPointData();
  const std::size_t copied = this->Settings.voronoi ? data->GetActualMemorySize() : 0;
  const std::size_t perPoint = vtkAHDPointOutput::EstimateBytesPerPoint(this->Input.GetInput());
  constexpr std::size_t kPerKept = 3 * sizeof(double) + 4 + 2 * sizeof(vtkIdType); // numbers, ids
  return { this->BytesBefore + bytesBehind + this->Input.EstimateBytes() + 1024 * copied,
    this->Settings.CopiesKept ? 2 * perPoint + kPerKept : perPoint };
}

std::size_t vtkAHDExecution::EstimateBytes() const
{
  ahd::RunReport report;
  const ahd::Run run(
    this->Settings, this->Input.GetRequest(), this->OwnMemory(0), this->Workspace, report);
  return run.estimate();
}

/// The most that is lent.
std::size_t vtkAHDExecution::EstimateLent() const
{
  return this->BytesBefore + this->Input.EstimateBytes() + this->Report.keptEstimate;
}

/// Are there not too many points, and is there memory for it all, as far as that is known before?
bool vtkAHDExecution::FitsInMemory(ahd::Run& run)
{
  const std::size_t limit = vtkAHDBytesOfLimit(this->Settings.MemoryLimit);
  vtkAHDOutputMemory& outputs = this->Context.GetOutputMemory();
  if (limit > 0 && run.estimate() + outputs.GetBytes() > limit)
  {
    outputs.Release(); // arrays may be smaller than the memory that they find
  }
  return run.check(limit, outputs.GetBytes() + this->BytesBefore) == ahd::Status::Ok;
}

/// Memory for as many corners as there are without a border, and a few more. Where that is not
/// enough, voronoiCells() takes its own.
void vtkAHDExecution::TakeVoronoiMemory(const ahd::Report& counts, ahd::VoronoiCells& cells) const
{
  vtkAHDOutputMemory& memory = this->Context.GetOutputMemory();
  const std::size_t corners = counts.triangles + counts.triangles / 64;
  cells.points = memory.Take<ahd::VoronoiCorner>(corners);
  cells.offsets = memory.Take<std::int32_t>(counts.inserted + 1);
  cells.corners = memory.Take<std::int32_t>(3 * corners);
}

// ------------------------------------------------------------------------------------------ steps

vtkAHDReport vtkAHDExecution::Run(const vtkAHDOutputs& outputs, LentPointer* lent)
{
  ahd::RunResult made;
  bool isLent = false;
  if (lent && this->Context.GetProgress().IsObserved())
  {
    this->TakePrints();
  }
  const bool isTried = this->Try(0,
    [&](ahd::Run& run)
    {
      this->Context.SetStages(run.stages());
      this->Make(run, made);
      this->Write(made, outputs);
      this->Finish(run, made);
      isLent = lent && this->Lend(made, outputs[0], *lent);
    });
  if (!isTried)
  {
    return this->Report;
  }
  for (std::size_t k = 0; k < outputs.size() && this->Report.status != ahd::Status::Ok; ++k)
  {
    outputs[k]->Initialize();
  }
  if (!isLent)
  {
    this->GiveBack(made);
  }
  this->KeepOutputMemory(isLent ? this->EstimateLent() : this->Workspace.bytes());
  return this->Report;
}

vtkAHDReport vtkAHDExecution::Triangulate(
  ahd::RunResult& made, std::size_t bytesBehind, const std::vector<double>& stagesBehind)
{
  const bool isTried = this->Try(bytesBehind,
    [&](ahd::Run& run)
    {
      std::vector<double> stages = run.firstStages();
      stages.insert(stages.end(), stagesBehind.begin(), stagesBehind.end());
      this->Context.SetStages(stages);
      this->Make(run, made);
      this->Finish(run, made);
    });
  if (isTried && this->Report.status != ahd::Status::Ok)
  {
    made = ahd::RunResult();
    this->Workspace.release();
  }
  return this->Report;
}

/// Takes these steps; the report says how they ended. Returns false if there is no memory for them.
template <typename Steps>
bool vtkAHDExecution::Try(std::size_t bytesBehind, const Steps& steps)
{
  ahd::Run run(this->Settings, this->Input.GetRequest(), this->OwnMemory(bytesBehind),
    this->Workspace, this->Report);
  if (!this->FitsInMemory(run))
  {
    return false;
  }
  try
  {
    this->Report.status = ahd::Status::Ok;
    steps(run);
  }
  catch (const vtkAHDStop& stop)
  {
    this->Report.status = stop.Reason;
    this->Report.BadCell = stop.Cell;
    this->Report.BadCellsOf = stop.CellsOf;
  }
  catch (const std::bad_alloc&)
  {
    this->Report.status = ahd::Status::OutOfMemory;
  }
  return true;
}

void vtkAHDExecution::Make(ahd::Run& run, ahd::RunResult& made)
{
  const auto open = [this, &made]
  {
    this->Input.Open(this->Context);
    made.numbers = this->Input.GetNumbers();
    return this->Input.GetRequest();
  };
  const auto lend = [this](const ahd::Report& counts, ahd::VoronoiCells& cells)
  { this->TakeVoronoiMemory(counts, cells); };
  const ahd::Context threads = this->Context;
  this->Context.Check(run.make(open, lend, this->Context.GetProgress(), threads.executor, made));
}

void vtkAHDExecution::Write(ahd::RunResult& made, const vtkAHDOutputs& outputs)
{
  this->Context.NextStage();
  vtkAHDSurface surface(this->Settings, this->Context, outputs[0]);
  surface.WritePoints(this->Input, made);
  surface.WriteCells(made);
  this->Context.NextStage();
  surface.AddCrossings(made);
  surface.AddArrays(made);
  this->Context.NextStage();
  this->WriteVoronoi(made, outputs);
  this->Context.NextStage();
  if (this->Settings.drawsOrder())
  {
    vtkAHDOrderOutput::Write(made.triangulation, this->Settings.curve, outputs[1], this->Context);
  }
  if (this->Settings.CopiesKept)
  {
    surface.KeepPointsOfCells();
  }
  this->Context.NextStage();
  this->Context.StopIfAborted();
}

void vtkAHDExecution::WriteVoronoi(ahd::RunResult& made, const vtkAHDOutputs& outputs)
{
  if (!this->Settings.voronoi)
  {
    return;
  }
  vtkAHDVoronoi::Write(std::move(made.voronoi), outputs[0], outputs[2], this->Context);
  if (this->Settings.isProjected())
  {
    vtkSmartPointer<vtkAbstractTransform> toPlane = this->Settings.Transform;
    if (this->Settings.fitsPlane())
    {
      toPlane = vtkAHDMakeTransform(made.points.plane());
    }
    this->Report.IsDiagramInPlane = !vtkAHDVoronoi::MoveBack(toPlane, outputs[2]);
  }
}

void vtkAHDExecution::Finish(ahd::Run& run, const ahd::RunResult& made)
{
  this->Context.Check(run.finish(made, this->Context));
  this->Report.Source = this->Input.GetSourceContent();
  this->Report.MarksAreUnfit = this->Input.GetMarksAreUnfit();
  this->Report.UnfitNumbers = this->Input.GetUnfitNumbers();
  this->Report.seconds = this->Context.GetProgress().seconds();
  this->Report.threadsUsed = this->Context.GetThreadsUsed();
}

/// Of places and marks, to which observers may write.
void vtkAHDExecution::TakePrints()
{
  const auto arrays = this->Input.FindBorrowed(this->Input.GetRequest().points);
  for (std::size_t k = 0; k < arrays.size(); ++k)
  {
    ahd::Fingerprint print;
    if (vtkAHDTakeFingerprint(arrays[k], this->Context, print))
    {
      this->Prints[k] = print;
    }
  }
}

/// Lends the triangulation, if requested and not too large. Returns false if
/// not: then nothing has changed. Throws vtkAHDStop if the filter is to abort.
bool vtkAHDExecution::Lend(ahd::RunResult& made, vtkPolyData* surface, LentPointer& lent) const
{
  // Places that were converted go with the input.
  const bool isFit = this->Report.triangles > 0 && !made.points.isProjected() &&
    !this->Input.MustConvertPoints() && !this->Settings.CopiesKept;
  if (!isFit || static_cast<vtkTypeInt64>(this->EstimateLent() / 1024) >= this->Settings.ReuseLimit)
  {
    return false;
  }
  try
  {
    auto content = std::make_unique<vtkAHDLentTriangulation::Content>();
    const ahd::PointView& points = made.points.points();
    const auto borrowed = this->Input.FindBorrowed(points);
    std::copy(borrowed.begin(), borrowed.end(), content->Borrowed.begin());
    const void* const floats = points.floats;
    content->At = { { points.doubles ? points.doubles : floats, points.skip } };
    for (std::size_t k = 0; k < borrowed.size(); ++k)
    {
      content->Before[k] = borrowed[k] ? this->Prints[k] : std::nullopt;
    }
    content->ShowMeans = this->Settings.showsMeans;
    const auto object = LentPointer::New();
    vtkAHDLentTriangulation::Content& to = *content;
    if (!object->Keep(content, surface, this->Context))
    {
      this->Context.StopIfAborted();
      return false;
    }
    made.selection = ahd::Selection{ std::move(made.selection.kept), made.selection.keptCount };
    made.numbers = ahd::PointNumbers(); // of the input that is read now
    to.Made = std::move(made);          // the surface is not shared yet
    lent = object;
    return true;
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
}

/// The working memory, for the next execution or to the system.
void vtkAHDExecution::GiveBack(ahd::RunResult& made)
{
  if (this->Report.status == ahd::Status::Ok)
  {
    this->Workspace.reclaim(std::move(made.triangulation));
  }
  const std::size_t held = (this->Workspace.bytes() + 1023) / 1024;
  if (this->Report.status != ahd::Status::Ok ||
    static_cast<vtkTypeInt64>(held) > this->Settings.ReuseLimit)
  {
    this->Workspace.release();
  }
}

/// That of the outputs when they are gone, for the next execution. `held`: the bytes of ReuseLimit
/// that other memory has.
void vtkAHDExecution::KeepOutputMemory(std::size_t held) const
{
  const double left = double(this->Settings.ReuseLimit) * 1024 - double(held);
  const bool isOk = this->Report.status == ahd::Status::Ok;
  this->Context.GetOutputMemory().KeepAtMost(
    isOk ? static_cast<std::size_t>(std::clamp(left, 0.0, 0x1p60)) : 0);
}
