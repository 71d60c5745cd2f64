// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDRefineExecution.h"

#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Execution/vtkAHDMessages.h"
#include "Input/vtkAHDInput.h"
#include "Output/vtkAHDPointOutput.h"
#include "Output/vtkAHDSurface.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDMemoryLimit.h"
#include "Pipeline/vtkAHDOutputArrays.h"
#include "Pipeline/vtkAHDSay.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>

namespace
{
constexpr double kTimeToRefine = 10.0, kTimeToTriangulate = 2.0; // a plain triangulation takes 1

/// Cells of these ids; the first offset may be any.
vtkSmartPointer<vtkCellArray> MakeCells(
  const std::int64_t* offsets, std::size_t cells, const std::vector<std::int64_t>& ids)
{
  auto starts = vtkAHDNewArray<vtkTypeInt64Array>(static_cast<vtkIdType>(cells + 1));
  std::transform(offsets, offsets + cells + 1, starts->GetPointer(0),
    [offsets](std::int64_t offset) { return offset - offsets[0]; });
  auto corners = vtkAHDNewArray<vtkTypeInt64Array>(offsets[cells] - offsets[0]);
  std::copy(ids.data() + offsets[0], ids.data() + offsets[cells], corners->GetPointer(0));
  auto made = vtkSmartPointer<vtkCellArray>::New();
  made->SetData(starts, corners);
  return made;
}

/// Points at these places, of which those that are no vertex are hidden; all where loops leave
/// nothing, as there are no pieces then that would leave it out.
vtkSmartPointer<vtkPolyData> MakePoints(
  ahd::RunResult& made, const ahd::Refinement& found, const vtkAHDContext& context)
{
  const std::vector<ahd::SteinerPoint>& added = found.points;
  const ahd::PointView& given = made.points.points();
  const std::size_t count = given.count + added.size();
  auto places = vtkAHDNewArray<vtkDoubleArray>(3 * static_cast<vtkIdType>(count));
  places->SetNumberOfComponents(3);
  auto marks = vtkAHDNewArray<vtkUnsignedCharArray>(static_cast<vtkIdType>(count));
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  std::vector<std::int64_t> status(given.count);
  context.Check(made.writeStatus(status.data(), context));
  double* to = places->GetPointer(0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isGiven = i < given.count;
    const ahd::Point place = isGiven
      ? given[i]
      : ahd::Point{ added[i - given.count].x, added[i - given.count].y };
    to[3 * i] = place.x;
    to[3 * i + 1] = place.y;
    to[3 * i + 2] = 0.0;
    const bool isVertex = found.triangles > 0 &&
      (!isGiven || status[i] == static_cast<std::int64_t>(i));
    marks->SetValue(static_cast<vtkIdType>(i), isVertex ? 0 : vtkDataSetAttributes::HIDDENPOINT);
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  auto all = vtkSmartPointer<vtkPolyData>::New();
  all->SetPoints(points);
  all->GetPointData()->AddArray(marks);
  return all;
}
}

bool vtkAHDRefineExecution::Refuse(const ahd::Facts& facts) const
{
  vtkAHDSay(this->Filter, ahd::Topic::Refusal, facts);
  return false;
}

bool vtkAHDRefineExecution::Run(
  const vtkAHDMergedBlocks& merged, vtkPolyData* mesh, vtkPolyData* segments)
{
  const ahd::SizeLimits& limits = this->Settings.limits;
  const char* const refused = this->Settings.options.insertionLimit > 0 ? "InsertionLimit"
    : limits.alpha > 0.0                                                ? "Alpha"
    : this->Settings.limitsSize()                                       ? "MaximumEdgeLength"
                                                                        : nullptr;
  if (refused)
  {
    return this->Refuse({ { "not_to_refine", refused } });
  }
  try
  {
    return this->Try(merged, mesh, segments);
  }
  catch (const vtkAHDStop& stop)
  {
    if (stop.Reason == ahd::Status::OutOfMemory)
    {
      throw std::bad_alloc();
    }
    return false;
  }
}

bool vtkAHDRefineExecution::Try(
  const vtkAHDMergedBlocks& merged, vtkPolyData* mesh, vtkPolyData* segments)
{
  vtkAHDInput input(this->Settings, merged.GetInput(), merged.GetSource());
  ahd::Workspace workspace;
  vtkAHDExecution first(this->Settings, input, workspace, this->Context, merged.GetBytes());
  ahd::RunResult made;
  const vtkAHDReport report = first.Triangulate(made, 0, { kTimeToRefine, kTimeToTriangulate });
  this->Estimate = report.GetEstimate();
  if (report.status != ahd::Status::Ok)
  {
    vtkAHDSayError(this->Filter, report);
    return false;
  }
  vtkAHDSayWarnings(this->Filter, this->Settings, report);
  this->Context.NextStage();
  vtkNew<vtkPolyData> given, surface;
  vtkAHDSurface(this->Settings, this->Context, given).WritePoints(input, made);
  const std::size_t other = merged.GetBytes() + input.EstimateBytes();
  if (!this->Refine(made, given, other))
  {
    return false;
  }
  this->Context.NextStage();
  if (!this->TriangulateAgain(made, report.estimate, surface))
  {
    return false;
  }
  this->WritePoints(made, given, mesh);
  this->WriteTriangles(made, surface, mesh);
  this->WriteSegments(mesh, segments);
  this->Context.StopIfAborted();
  return true;
}

/// The number of each point, if there is such an array.
bool vtkAHDRefineExecution::ReadSizes(vtkPolyData* given, std::vector<double>& sizes)
{
  const std::string& name = this->Wishes.SizeArrayName;
  if (name.empty() || name == "None")
  {
    return true;
  }
  vtkDataArray* const array = given->GetPointData()->GetArray(name.c_str());
  const vtkIdType count = given->GetNumberOfPoints();
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() < count)
  {
    return this->Refuse({ { "unfit_sizes", name } });
  }
  sizes.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    sizes[static_cast<std::size_t>(i)] = array->GetComponent(i, 0);
  }
  return true;
}

bool vtkAHDRefineExecution::Refine(ahd::RunResult& made, vtkPolyData* given, std::size_t other)
{
  std::vector<double> sizes;
  if (!this->ReadSizes(given, sizes))
  {
    return false;
  }
  ahd::RefineRequest request = this->Wishes.Request;
  request.sizes = sizes.empty() ? nullptr : sizes.data();
  std::size_t at = 0;
  const ahd::RefineFault fault = ahd::findRefineFault(made.triangulation, request, at);
  if (fault != ahd::RefineFault::None)
  {
    vtkErrorWithObjectMacro(
      this->Filter, "" << ahd::refineFaultText(request, fault, at) << " Nothing was computed.");
    return false;
  }
  const std::size_t limit = vtkAHDBytesOfLimit(this->Settings.MemoryLimit);
  const ahd::RefineInput input = this->ToRefine(made);
  ahd::CheckedMemory checked;
  const ahd::Status status = ahd::refineWithin(
    checked, { limit, other + sizeof(double) * sizes.size() }, input, request, this->Found);
  this->Estimate = std::max(this->Estimate, static_cast<vtkTypeInt64>(checked.needed / 1024));
  if (status == ahd::Status::OutOfMemory)
  {
    return this->Refuse(ahd::factsOf(checked, status, input));
  }
  this->Context.Check(status);
  return true;
}

/// `held`: bytes that are there already.
bool vtkAHDRefineExecution::TriangulateAgain(
  ahd::RunResult& made, std::size_t held, vtkPolyData* surface)
{
  const ahd::Refinement& found = this->Found.found;
  vtkAHDSettings settings;
  settings.fillRule = ahd::FillRule::EvenOdd;
  settings.wanted[std::size_t(ahd::WantedArray::Regions)] = true;
  settings.MemoryLimit = this->Settings.MemoryLimit;
  const auto points = MakePoints(made, found, this->Context);
  vtkNew<vtkPolyData> pieces, none, noneElse;
  if (!found.offsets.empty())
  {
    const std::int64_t* const offsets = found.offsets.data();
    pieces->SetLines(MakeCells(offsets, found.lines, found.ids));
    pieces->SetPolys(
      MakeCells(offsets + found.lines, found.offsets.size() - 1 - found.lines, found.ids));
  }
  vtkAHDInput input(settings, points, pieces);
  ahd::Workspace workspace;
  vtkAHDExecution execution(settings, input, workspace, this->Context, held);
  const vtkAHDReport report = execution.Run({ { surface, none, noneElse } });
  this->Estimate = std::max(this->Estimate, report.GetEstimate());
  if (report.status != ahd::Status::Ok)
  {
    vtkAHDSayError(this->Filter, report);
  }
  return report.status == ahd::Status::Ok;
}

/// In x, y the places are those that were found; in another plane they are between the corners.
void vtkAHDRefineExecution::WritePoints(
  const ahd::RunResult& made, vtkPolyData* given, vtkPolyData* mesh) const
{
  const std::vector<ahd::SteinerPoint>& added = this->Found.found.points;
  const vtkIdType before = given->GetNumberOfPoints();
  const vtkIdType count = before + static_cast<vtkIdType>(added.size());
  auto places = vtkAHDNewArray<vtkDoubleArray>(3 * count);
  places->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < before; ++i)
  {
    given->GetPoint(i, places->GetPointer(3 * i));
  }
  for (std::size_t k = 0; k < added.size(); ++k)
  {
    double* const to = places->GetPointer(3 * (before + static_cast<vtkIdType>(k)));
    for (vtkIdType c = 0; c < 3; ++c)
    {
      to[c] = ahd::interpolate(
        added[k], [&](ahd::Index id) { return places->GetValue(3 * vtkIdType(id) + c); });
    }
    if (!this->Settings.isProjected())
    {
      to[0] = added[k].x;
      to[1] = added[k].y;
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  mesh->SetPoints(points);
  vtkPointData* const data = mesh->GetPointData();
  vtkAHDPointOutput::AddRefined(given->GetPointData(), before, added, data, this->Context);
  auto ids = vtkAHDOutputArrays::OriginalPointIds.Make(
    static_cast<std::size_t>(count), this->Context);
  const auto own = static_cast<vtkIdType>(made.points.inputCount());
  for (vtkIdType i = 0; i < count; ++i)
  {
    ids->SetValue(i, i < own ? i : -1);
  }
  vtkAHDReplaceArray(data, ids);
}

void vtkAHDRefineExecution::WriteTriangles(
  ahd::RunResult& made, vtkPolyData* surface, vtkPolyData* mesh)
{
  vtkIdTypeArray* const named = vtkAHDOutputArrays::RegionId.Find(surface->GetCellData());
  auto* const corners = vtkTypeInt32Array::SafeDownCast(
    surface->GetPolys()->GetConnectivityArray());
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPolys());
  std::vector<std::int64_t> regions(named->GetPointer(0), named->GetPointer(0) + count);
  std::vector<std::int64_t> bad(this->Found.found.bad.size());
  ahd::MeshTriangles triangles;
  triangles.corners = count > 0 ? corners->GetPointer(0) : nullptr;
  triangles.count = count;
  triangles.regions = regions.data();
  triangles.bad = bad.data();
  this->Context.Check(ahd::describeRefined(this->ToRefine(made), this->Found, triangles));
  this->LeastAngle = triangles.leastAngle;
  mesh->SetPolys(surface->GetPolys());
  std::copy(regions.begin(), regions.end(), named->GetPointer(0));
  auto reasons = vtkAHDOutputArrays::BadReason.Make(count, this->Context);
  std::fill_n(reasons->GetPointer(0), count, -1);
  for (std::size_t k = 0; k < bad.size(); ++k)
  {
    if (bad[k] >= 0)
    {
      reasons->SetValue(
        static_cast<vtkIdType>(bad[k]), static_cast<int>(this->Found.found.bad[k].reason));
    }
  }
  mesh->GetCellData()->AddArray(named);
  mesh->GetCellData()->AddArray(reasons);
}

void vtkAHDRefineExecution::WriteSegments(vtkPolyData* mesh, vtkPolyData* segments) const
{
  const std::vector<ahd::MeshPiece>& pieces = this->Found.pieces;
  std::vector<std::int64_t> ids(2 * pieces.size()), offsets(pieces.size() + 1, 0);
  auto cells = vtkAHDOutputArrays::SourceCell.Make(pieces.size(), this->Context);
  auto bounds = vtkAHDOutputArrays::IsBoundary.Make(pieces.size(), this->Context);
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    ids[2 * k] = pieces[k].ids[0];
    ids[2 * k + 1] = pieces[k].ids[1];
    offsets[k + 1] = static_cast<std::int64_t>(2 * k + 2);
    cells->SetValue(static_cast<vtkIdType>(k), pieces[k].cell);
    bounds->SetValue(static_cast<vtkIdType>(k), k < this->Found.innerPieces ? 0 : 1);
  }
  segments->SetPoints(mesh->GetPoints());
  segments->GetPointData()->ShallowCopy(mesh->GetPointData());
  segments->SetLines(MakeCells(offsets.data(), pieces.size(), ids));
  segments->GetCellData()->AddArray(cells);
  segments->GetCellData()->AddArray(bounds);
}
