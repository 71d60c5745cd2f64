// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDExecution.h"

#include "Engine/Prepare/Stacks.h"
#include "Execution/vtkAHDKeptTriangulation.h"
#include "Output/vtkAHDOrderOutput.h"
#include "Output/vtkAHDSurface.h"
#include "Output/vtkAHDVoronoi.h"

#include "vtkAbstractTransform.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

vtkAHDExecution::vtkAHDExecution(const vtkAHDSettings& settings, vtkAHDInput& input,
  ahd::Workspace& workspace, const vtkAHDContext& context, std::size_t bytesBefore)
  : Settings(settings)
  , Input(input)
  , Workspace(workspace)
  , Context(context)
  , BytesBefore(bytesBefore)
  , Options(settings.Insertion)
{
  this->Known.points = ahd::expectedPoints(input.GetRequest());
  this->Known.segments = ahd::segmentsOf(input.GetRequest());
}

vtkAHDReport vtkAHDExecution::Run(const vtkAHDOutputs& outputs, vtkAHDLeftBehind* left)
{
  this->Report.Points = this->Known.points;
  if (!this->FitsInMemory())
  {
    return this->Report;
  }
  Results results;
  bool isLeft = false;
  this->Try(
    [&]
    {
      this->SetStages();
      this->MakeSurface(results);
      this->Write(results, outputs);
      this->FindStacks(results);
      this->ReportOn(results);
      isLeft = left && this->Leave(results, outputs[0], *left);
    });
  for (std::size_t k = 0; k < outputs.size() && this->Report.Status != ahd::Status::Ok; ++k)
  {
    outputs[k]->Initialize();
  }
  if (!isLeft)
  {
    this->GiveBack(results);
  }
  this->KeepOutputMemory(isLeft ? this->EstimateLeft() : this->Workspace.bytes());
  return this->Report;
}

vtkAHDReport vtkAHDExecution::Triangulate(
  vtkAHDTriangulated& made, std::size_t bytesBehind, const std::vector<double>& stagesBehind)
{
  this->BytesBehind = bytesBehind;
  this->Report.Points = this->Known.points;
  if (!this->FitsInMemory())
  {
    return this->Report;
  }
  Results results;
  this->Try(
    [&]
    {
      std::vector<double> stages = this->FirstStages();
      stages.insert(stages.end(), stagesBehind.begin(), stagesBehind.end());
      this->Context.SetStages(stages);
      this->MakeSurface(results);
      this->FindStacks(results);
      this->ReportOn(results);
    });
  if (this->Report.Status == ahd::Status::Ok)
  {
    made = std::move(results);
    return this->Report;
  }
  this->GiveBack(results);
  return this->Report;
}

/// Takes these steps; the report says how they ended.
template <typename Steps>
void vtkAHDExecution::Try(const Steps& steps)
{
  try
  {
    this->Report.Status = ahd::Status::Ok;
    steps();
  }
  catch (const vtkAHDStop& stop)
  {
    this->Report.Status = stop.Reason;
    this->Report.BadCell = stop.Cell;
    this->Report.BadCellsOf = stop.CellsOf;
  }
  catch (const std::bad_alloc&)
  {
    this->Report.Status = ahd::Status::OutOfMemory;
  }
}

void vtkAHDExecution::MakeSurface(Results& results)
{
  this->Prepare(results.Points);
  this->MakeTriangles(results);
  this->Constrain(results);
}

/// Those until the triangles are there. Weights are about times, measured with 10^6 points: that of
/// a plain triangulation is 1. In the order in which they are begun below.
std::vector<double> vtkAHDExecution::FirstStages() const
{
  const vtkAHDSettings& settings = this->Settings;
  const auto weight = [](bool wanted, double value) { return wanted ? value : 0.0; };
  return {
    0.02 + weight(settings.IsProjected(), 0.5) + weight(settings.Tolerance > 0.0, 1.5) +
      weight(settings.HeightsFromSurface, 1.5) +
      weight(settings.Split && this->Known.segments > 0, 2.0),                   // Prepare
    1.0,                                                                         // MakeTriangles
    weight(settings.GenerateVoronoi, 3.0),                                       // Voronoi cells
    weight(this->Known.segments > 0, 0.6) + weight(settings.MayTrimRim(), 0.05), // Constrain
  };
}

/// All of Run(), weighed as they are there.
void vtkAHDExecution::SetStages() const
{
  const vtkAHDSettings& settings = this->Settings;
  const auto weight = [](bool wanted, double value) { return wanted ? value : 0.0; };
  const double arrays = weight(settings.GeneratePointStatus, 0.1) +
    weight(settings.GenerateInsertionRank, 0.1) + weight(settings.GenerateConstraintEdges, 0.5) +
    weight(settings.GenerateRegionIds, 1.0) + weight(settings.GenerateNeighbors, 0.9);
  std::vector<double> stages = this->FirstStages();
  stages.insert(stages.end(),
    {
      0.15 + weight(settings.LimitsSize(), 1.5) + weight(settings.ShowMeans, 0.2), // points, cells
      arrays,                                                                      // arrays
      weight(settings.GenerateVoronoi, 0.5),                                       // diagram
      weight(settings.WantsOrder(), 0.4)                                           // order
    });
  this->Context.SetStages(stages);
}

void vtkAHDExecution::Prepare(ahd::PreparedInput& points)
{
  this->Context.NextStage();
  this->Input.Open(this->Context);
  ahd::InputRequest request = this->Input.GetRequest();
  request.mostCrossings = this->Report.MostCrossings;
  this->LimitAsked(this->Known.askedToSplit);
  const ahd::Status status = ahd::prepare(request, this->Context, points);
  this->Known.askedToSplit = this->Context.GetAsked().most();
  if (status == ahd::Status::TooManyCrossings)
  {
    this->Known.crossings = this->Report.MostCrossings + 1;
    this->Known.points += this->Known.crossings;
    this->UpdateEstimate();
  }
  this->CheckAsked(status);
  this->Known.points = this->Report.Points = points.points().count;
  this->Known.crossings = points.crossings().size();
  this->UpdateEstimate();
}

void vtkAHDExecution::MakeTriangles(Results& results)
{
  this->Context.NextStage();
  ahd::Triangulation& triangulation = results.Triangulation;
  const ahd::Status status = ahd::triangulate(
    results.Points.points(), this->Options, this->Workspace, this->Context, triangulation);
  this->Known.boxes = status == ahd::Status::TooManyBoxes ? this->Report.MostBoxes + 1
                                                          : triangulation.boxes().size();
  this->UpdateEstimate();
  this->Context.Check(status);
  this->Context.Check(
    ahd::findOddPoints(results.Points.points(), this->Context, this->Report.OddPoints));
  if (!results.Points.crossings().empty() && triangulation.report().duplicates > 0)
  {
    this->Context.Check(results.Points.endCrossingsAtVertices(triangulation, this->Context));
  }
  this->Report.DelaunayTriangles = triangulation.report().triangles;
  this->Context.NextStage();
  if (this->Settings.GenerateVoronoi)
  {
    this->TakeVoronoiMemory(triangulation.report(), results.Voronoi);
    this->Context.Check(
      ahd::voronoiCells(triangulation, this->Settings.VoronoiClip, results.Voronoi, this->Context));
  }
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

void vtkAHDExecution::Constrain(Results& results)
{
  this->Context.NextStage();
  if (results.Points.hasConstraints())
  {
    this->LimitAsked(this->Known.askedToConstrain);
    const ahd::Status status = ahd::constrain(std::move(results.Triangulation),
      results.Points.constraints(), this->Settings.FillRule, this->Context, results.Triangulation);
    this->Known.askedToConstrain = this->Context.GetAsked().most();
    this->CheckAsked(status);
  }
  if (this->Settings.TrimsRim(results.Points.plane()))
  {
    this->Context.Check(
      ahd::trim(std::move(results.Triangulation), this->Context, results.Triangulation));
  }
}

void vtkAHDExecution::Write(Results& results, const vtkAHDOutputs& outputs)
{
  ahd::Triangulation& triangulation = results.Triangulation;
  this->Context.NextStage();
  vtkAHDSurface surface(this->Settings, this->Context, outputs[0]);
  surface.WritePoints(this->Input, results.Points);
  surface.ShowMeans(results.Points, triangulation);
  results.Selection = surface.WriteCells(results.Points, triangulation);
  this->Context.NextStage();
  surface.AddCrossings(results.Points, triangulation);
  surface.AddPointArrays(results.Points, triangulation);
  surface.AddCellArrays(triangulation, results.Selection);
  this->Context.NextStage();
  this->WriteVoronoi(results, outputs);
  this->Context.NextStage();
  if (this->Settings.WantsOrder())
  {
    vtkAHDOrderOutput::Write(
      triangulation, this->Settings.GenerateInsertionCurve, outputs[1], this->Context);
  }
  this->Context.NextStage();
  this->Context.StopIfAborted();
  this->Report.Triangles = static_cast<std::size_t>(outputs[0]->GetNumberOfPolys());
  this->Report.Cells = static_cast<std::size_t>(outputs[0]->GetNumberOfCells());
}

void vtkAHDExecution::WriteVoronoi(Results& results, const vtkAHDOutputs& outputs)
{
  if (!this->Settings.GenerateVoronoi)
  {
    return;
  }
  vtkAHDVoronoi::Write(std::move(results.Voronoi), outputs[0], outputs[2], this->Context);
  if (this->Settings.IsProjected())
  {
    vtkSmartPointer<vtkAbstractTransform> toPlane = this->Settings.Transform;
    if (this->Settings.FitPlane)
    {
      toPlane = vtkAHDMakeTransform(results.Points.plane());
    }
    this->Report.IsDiagramInPlane = !vtkAHDVoronoi::MoveBack(toPlane, outputs[2]);
  }
}

/// Looks whether x and y tell the points apart, where the triangles give cause for it.
void vtkAHDExecution::FindStacks(const Results& results)
{
  const ahd::PointView& points = results.Points.points();
  const ahd::Report& counts = results.Triangulation.report();
  if (this->Settings.IsProjected() || counts.beyondLimit > 0)
  {
    return;
  }
  if (this->Report.DelaunayTriangles == 0)
  {
    this->Context.Check(ahd::findIfOnOneLine(points, this->Context, this->Report.AreOnOneLine));
  }
  else if (counts.duplicates > counts.inserted / 2 && !this->Settings.ShowMeans &&
    this->Options.representative == ahd::Representative::FirstId) // else they were thought of
  {
    this->Context.Check(ahd::findIfStacked(points, this->Context, this->Report.AreStacked));
  }
}

void vtkAHDExecution::ReportOn(const Results& results)
{
  vtkAHDReport& report = this->Report;
  const ahd::PreparedInput& points = results.Points;
  report.Counts = results.Triangulation.report();
  report.Constraints = results.Triangulation.constraints();
  report.InputPoints = points.inputCount();
  report.MergedPoints = points.merged().size();
  report.AddedPoints = points.addedCount();
  report.Crossings = points.crossings().size();
  report.BentConstraints = points.bentCount();
  report.FirstBentCell = points.firstBentCell();
  report.UnfitIds = points.unfitIds();
  report.Source = this->Input.GetSourceContent();
  report.PointsOffSurface = points.outsideCount();
  report.MarksAreUnfit = this->Input.GetMarksAreUnfit();
  for (std::size_t phase = 0; phase < ahd::kPhases; ++phase)
  {
    report.Seconds[phase] = this->Context.GetSeconds(ahd::Phase(phase));
  }
  report.ThreadsUsed = static_cast<int>(this->Context.GetThreadsUsed());
  if (!report.Constraints.leftOut.empty())
  {
    const ahd::LeftOut& first = report.Constraints.leftOut[0];
    report.FirstCrossing = { { points.cellOf(first.chain), points.cellOf(first.otherChain) } };
  }
}

/// Leaves the triangulation behind, if it is to be had again and not too much. Returns false if
/// not: then nothing has changed. Throws vtkAHDStop if the filter is to abort.
bool vtkAHDExecution::Leave(Results& results, vtkPolyData* surface, vtkAHDLeftBehind& left) const
{
  // Places that were converted go with the input.
  const bool isFit = this->Report.Triangles > 0 && !results.Points.isProjected() &&
    !this->Input.MustConvertPoints();
  if (!isFit || static_cast<vtkTypeInt64>(this->EstimateLeft() / 1024) >= this->Settings.ReuseLimit)
  {
    return false;
  }
  try
  {
    auto content = std::make_unique<vtkAHDLeftTriangulation>();
    const ahd::PointView& points = results.Points.points();
    const auto borrowed = this->Input.FindBorrowed(points);
    std::copy(borrowed.begin(), borrowed.end(), content->Borrowed.begin());
    const void* const floats = points.floats;
    content->At = { { points.doubles ? points.doubles : floats, points.skip } };
    content->ShowMeans = this->Settings.ShowMeans;
    const auto kept = vtkSmartPointer<vtkAHDKeptTriangulation>::New();
    vtkAHDLeftTriangulation& to = *content;
    if (!kept->Keep(content, surface, this->Context))
    {
      this->Context.StopIfAborted();
      return false;
    }
    to.Made = std::move(results); // nobody else knows the surface yet
    to.Kept = std::move(results.Selection.kept);
    left.Let(kept);
    return true;
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
}

/// The working memory, for the next execution or to the system.
void vtkAHDExecution::GiveBack(Results& results)
{
  if (this->Report.Status == ahd::Status::Ok)
  {
    this->Workspace.reclaim(std::move(results.Triangulation));
  }
  const std::size_t held = (this->Workspace.bytes() + 1023) / 1024;
  if (this->Report.Status != ahd::Status::Ok ||
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
  const bool isOk = this->Report.Status == ahd::Status::Ok;
  this->Context.GetOutputMemory().KeepAtMost(
    isOk ? static_cast<std::size_t>(std::clamp(left, 0.0, 0x1p60)) : 0);
}
