// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlanarSurfaceOutline.h"

#include "Engine/Core/FloatingPoint.h"
#include "Engine/Core/Threads.h"
#include "Engine/Job/OutlineRun.h"
#include "Execution/vtkAHDMessages.h"
#include "Input/vtkAHDAppendedPolygons.h"
#include "Input/vtkAHDHeldCopy.h"
#include "Output/vtkAHDRings.h"
#include "Pipeline/vtkAHDCellsView.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDMemoryLimit.h"
#include "Pipeline/vtkAHDPieces.h"
#include "Pipeline/vtkAHDPointsView.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSay.h"
#include "Ranks/vtkAHDRankUpdates.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "Ranks/vtkAHDRanks.h"
#include "vtkMultiProcessController.h"
#endif

#include <algorithm>
#include <limits>
#include <new>
#include <vector>

vtkStandardNewMacro(vtkPlanarSurfaceOutline);

namespace
{
constexpr char kPolygons[] = "polygons"; // in messages
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}

namespace
{
/// Does work(context) for a filter, and says why it failed.
template <typename Work>
ahd::Status Attempt(vtkAlgorithm* filter, const Work& work)
{
  vtkAHDProgress progress(filter);
  ahd::Threads threads(1);
  vtkAHDOutputMemory notKept;
  try
  {
    work(vtkAHDContext(progress, threads, notKept));
    return ahd::Status::Ok;
  }
  catch (const vtkAHDStop& stop)
  {
    if (stop.Reason == ahd::Status::BadCells)
    {
      vtkAHDSayBadCells(filter, stop.CellsOf, stop.Cell);
    }
    return stop.Reason;
  }
  catch (const std::bad_alloc&)
  {
    vtkAHDSayOutOfMemory("vtkPlanarSurfaceOutline",
      [filter] { vtkErrorWithObjectMacro(filter, "Out of memory. The output is empty."); });
    return ahd::Status::OutOfMemory;
  }
}
}

/// What is outlined.
struct vtkPlanarSurfaceOutline::Surface
{
  vtkSmartPointer<vtkPolyData> Data; // points, polygons, and the data of its points
  bool WritesGroups = false;
  vtkSmartPointer<vtkDataArray> Groups; // of the cells, from FirstCell on; null: all are alike
  vtkSmartPointer<vtkUnsignedCharArray> Ghosts; // of these; null: none
  vtkIdType FirstCell = 0;
  std::size_t Bytes = 0; // of what was joined

  ahd::Status Status = ahd::Status::Ok; // what came of taking it

  bool HasNumbers() const { return this->Groups || this->Ghosts; }
  vtkSmartPointer<vtkPolyData> GetPart(const vtkAHDContext& context) const;
  /// The number of a polygon; NaN: it is left out.
  double GetNumber(vtkIdType polygon) const
  {
    const vtkIdType cell = this->FirstCell + polygon;
    const bool isLeftOut = this->Ghosts &&
      (this->Ghosts->GetValue(cell) &
        (vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL)) != 0;
    return isLeftOut ? kNan : this->Groups ? this->Groups->GetComponent(cell, 0) : 0.0;
  }
};

namespace
{
constexpr char kGroups[] = "Groups", kGhosts[] = "Ghosts"; // names of the numbers of a part
}

/// The points, polygons and their numbers alone. Throws vtkAHDStop if the polygons are damaged.
vtkSmartPointer<vtkPolyData> vtkPlanarSurfaceOutline::Surface::GetPart(
  const vtkAHDContext& context) const
{
  context.GetProgress().Watch(this->Data);
  vtkAHDCellsView(this->Data->GetPolys(), kPolygons).Open(context);
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(this->Data->GetPoints());
  part->SetPolys(this->Data->GetPolys());
  if (this->HasNumbers())
  {
    vtkNew<vtkDoubleArray> numbers;
    numbers->SetName(this->WritesGroups ? kGroups : kGhosts);
    numbers->SetNumberOfValues(part->GetNumberOfPolys());
    for (vtkIdType k = 0; k < part->GetNumberOfPolys(); ++k)
    {
      numbers->SetValue(k, this->GetNumber(k));
    }
    part->GetCellData()->AddArray(numbers);
  }
  return part;
}

/// One surface of several parts.
vtkPlanarSurfaceOutline::Surface vtkPlanarSurfaceOutline::Join(
  const std::vector<vtkSmartPointer<vtkDataObject>>& parts)
{
  Surface surface;
  surface.Data = vtkAHDAppendPolygons(parts);
  surface.Groups = surface.Data->GetCellData()->GetArray(0);
  surface.WritesGroups = std::any_of(parts.begin(), parts.end(),
    [](vtkDataObject* part)
    { return vtkPolyData::SafeDownCast(part)->GetCellData()->HasArray(kGroups) != 0; });
  surface.Bytes = 1024 * surface.Data->GetActualMemorySize();
  return surface;
}

// --------------------------------------------------------------------------------- several ranks

#if VTK_MODULE_ENABLE_VTK_ParallelCore
/// Brings the polygons of all ranks to the first. Returns whether this is the rank that outlines.
/// Collective with several ranks.
bool vtkPlanarSurfaceOutline::Gather(Surface& surface)
{
  if (!this->IsDistributed())
  {
    return surface.Status == ahd::Status::Ok;
  }
  vtkSmartPointer<vtkPolyData> part;
  if (surface.Status == ahd::Status::Ok)
  {
    surface.Status = Attempt(
      this, [&](const vtkAHDContext& context) { part = surface.GetPart(context); });
  }
  // Nobody waits for a rank that failed; it has said why.
  if (vtkAHDRanks(this->Controller).agree(surface.Status) != ahd::Status::Ok)
  {
    return false;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> all;
  this->Controller->Gather(part, all, 0);
  const bool isFirst = this->Controller->GetLocalProcessId() == 0;
  return isFirst &&
    Attempt(this, [&](const vtkAHDContext&) { surface = Join(all); }) == ahd::Status::Ok;
}

bool vtkPlanarSurfaceOutline::IsDistributed() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

void vtkPlanarSurfaceOutline::SetController(vtkMultiProcessController* controller)
{
  vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
}

#else

bool vtkPlanarSurfaceOutline::Gather(Surface& surface)
{
  return surface.Status == ahd::Status::Ok;
}
bool vtkPlanarSurfaceOutline::IsDistributed() const
{
  return false;
}
void vtkPlanarSurfaceOutline::SetController(vtkMultiProcessController*) {}

#endif

int vtkPlanarSurfaceOutline::ComputePipelineMTime(vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs, int requestFromOutputPort,
  vtkMTimeType* mtime)
{
  const int result = this->Superclass::ComputePipelineMTime(
    request, inputs, outputs, requestFromOutputPort, mtime);
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  if (this->IsDistributed())
  {
    *mtime = this->Updates->FindMTime(this->Controller, this, *mtime, inputs, outputs);
  }
#endif
  return result;
}

int vtkPlanarSurfaceOutline::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestInformation(request, inputs, outputs);
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  if (this->IsDistributed())
  {
    vtkAHDRankUpdates::ShareTimes(this->Controller, this, outputs);
  }
#endif
  return result;
}

// ------------------------------------------------------------------------------------ one process

/// Of all blocks.
struct vtkPlanarSurfaceOutline::Lacks
{
  bool Groups = false;
  vtkIdType Blocks = 0; // that are no polygonal data
  vtkIdType Strips = 0, Polygons = 0, Points = 0;
};

vtkPlanarSurfaceOutline::vtkPlanarSurfaceOutline()
  : Updates(new vtkAHDRankUpdates)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  this->SetController(vtkMultiProcessController::GetGlobalController());
#endif
}

vtkPlanarSurfaceOutline::~vtkPlanarSurfaceOutline()
{
  this->SetController(nullptr);
}

void vtkPlanarSurfaceOutline::SetGroupArrayName(const std::string& name)
{
  if (this->GroupArrayName != name)
  {
    this->GroupArrayName = name;
    this->Modified();
  }
}

/// The first type decides: with it the filter is not run for each block.
int vtkPlanarSurfaceOutline::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

/// In one process all is needed whatever piece of the output is wanted; across ranks, cells of
/// others would come twice with ghost levels.
int vtkPlanarSurfaceOutline::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  if (vtkAHDIsOnlyProcess(this->Controller))
  {
    vtkAHDAskForAll(inputs[0]);
  }
  else if (vtkInformation* const info = inputs[0]->GetInformationObject(0))
  {
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return result;
}

int vtkPlanarSurfaceOutline::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const ahd::ScopedFloatingPoint asTheEngine;
  vtkInformation* const info = outputs->GetInformationObject(0);
  vtkPolyData* const output = vtkPolyData::GetData(info);
  if (vtkAHDIsOnlyProcess(this->Controller) && vtkAHDIsLaterPiece(info))
  {
    return 1; // the first piece has all
  }
  // Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more.
  Surface surface;
  const ahd::Status status = Attempt(this,
    [&](const vtkAHDContext& context)
    { surface = this->Take(vtkDataObject::GetData(inputs[0]), context); });
  surface.Status = status;
  if (this->Gather(surface) &&
    Attempt(
      this, [&](const vtkAHDContext& context) { this->MakeOutline(surface, output, context); }) !=
      ahd::Status::Ok)
  {
    output->Initialize();
  }
  this->Updates->Settle();
  return 1;
}

/// Holds the arrays of a polygonal data set, and collects what it lacks.
vtkPlanarSurfaceOutline::Surface vtkPlanarSurfaceOutline::Hold(vtkPolyData* input, Lacks& lacks)
{
  Surface surface;
  surface.Data = vtkAHDHeldCopy(input);
  surface.FirstCell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType cells = surface.FirstCell + input->GetNumberOfPolys() +
    input->GetNumberOfStrips();
  const auto fits = [cells](vtkDataArray* array)
  { return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == cells; };
  if (!this->GroupArrayName.empty() && this->GroupArrayName != "None")
  {
    vtkDataArray* const groups = input->GetCellData()->GetArray(this->GroupArrayName.c_str());
    surface.WritesGroups = fits(groups);
    surface.Groups = fits(groups) ? groups : nullptr;
    lacks.Groups = lacks.Groups || (!fits(groups) && cells > 0);
  }
  vtkDataArray* const ghosts = input->GetCellData()->GetArray(
    vtkDataSetAttributes::GhostArrayName());
  surface.Ghosts = fits(ghosts) ? vtkUnsignedCharArray::SafeDownCast(ghosts) : nullptr;
  lacks.Strips += input->GetNumberOfStrips();
  lacks.Polygons += input->GetNumberOfPolys();
  lacks.Points += input->GetNumberOfPoints();
  return surface;
}

/// The input as one surface, with all blocks. Says what it lacks.
vtkPlanarSurfaceOutline::Surface vtkPlanarSurfaceOutline::Take(
  vtkDataObject* input, const vtkAHDContext& context)
{
  Lacks lacks;
  Surface surface;
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(input))
  {
    std::vector<vtkSmartPointer<vtkDataObject>> parts;
    const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      auto* const block = vtkPolyData::SafeDownCast(each->GetCurrentDataObject());
      lacks.Blocks += block ? 0 : 1;
      if (block)
      {
        parts.emplace_back(this->Hold(block, lacks).GetPart(context));
      }
    }
    surface = Join(parts);
  }
  else
  {
    vtkNew<vtkPolyData> nothing;
    auto* const data = vtkPolyData::SafeDownCast(input);
    surface = this->Hold(data ? data : nothing.Get(), lacks);
  }
  vtkAHDSay(this, ahd::Topic::Outline,
    { { "unfit_group", lacks.Groups ? this->GroupArrayName : std::string() },
      { "polygon_strips", lacks.Strips }, { "outlined_blocks", lacks.Blocks },
      { "has_no_polygon",
        !this->IsDistributed() && lacks.Polygons + lacks.Strips == 0 && lacks.Points > 0 } });
  return surface;
}

namespace
{
/// The numbers of all polygons; none if they are alike.
template <typename GetNumber>
const double* ReadNumbers(
  std::vector<double>& to, const vtkAHDContext& context, const GetNumber& number)
{
  context.ForRange(to.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        to[k] = number(static_cast<vtkIdType>(k));
      }
    });
  return to.empty() ? nullptr : to.data();
}
}

void vtkPlanarSurfaceOutline::MakeOutline(
  const Surface& surface, vtkPolyData* output, const vtkAHDContext& context)
{
  context.GetProgress().Watch(surface.Data);
  vtkAHDPointsView points(surface.Data->GetPoints());
  vtkAHDCellsView cells(surface.Data->GetPolys(), kPolygons);
  std::vector<double> numbers;
  ahd::OutlineRequest request;
  request.points.count = points.GetCount();
  request.cells = cells.GetCounts();
  const std::size_t counted = surface.HasNumbers() ? request.cells.cells : 0;
  const ahd::OutlineMemory memory = { vtkAHDBytesOfLimit(this->MemoryLimit),
    surface.Bytes + points.EstimateBytes() + cells.EstimateBytes() + sizeof(double) * counted,
    vtkAHDRingPointBytes(surface.Data) };
  ahd::CheckedMemory checked;
  const auto open = [&]
  {
    request.points = points.Open(context);
    request.cells = cells.Open(context);
    numbers.resize(counted);
    request.groups = ReadNumbers(
      numbers, context, [&surface](vtkIdType k) { return surface.GetNumber(k); });
    return request;
  };
  ahd::Outline made;
  const ahd::Status status = ahd::outlineWithin(
    checked, memory, request, open, context.GetProgress(), made);
  if (status == ahd::Status::OutOfMemory || status == ahd::Status::TooManyPoints)
  {
    vtkAHDSay(this, ahd::Topic::Refusal, ahd::factsOf(checked, status, request));
  }
  if (status == ahd::Status::Ok)
  {
    this->Write(surface, made, output);
    vtkAHDSay(this, ahd::Topic::Outline, ahd::factsOf(made));
  }
}

void vtkPlanarSurfaceOutline::Write(
  const Surface& surface, const ahd::Outline& made, vtkPolyData* output)
{
  vtkAHDWriteRings(made, surface.Data, output);
  if (!surface.WritesGroups)
  {
    return;
  }
  const auto groups = vtkSmartPointer<vtkDataArray>::Take(surface.Groups->NewInstance());
  groups->SetNumberOfTuples(output->GetNumberOfLines());
  groups->SetName(this->GroupArrayName.c_str());
  for (std::size_t k = 0; k + 1 < made.polygons.size(); ++k)
  {
    for (vtkIdType r = made.polygons[k]; r < vtkIdType(made.polygons[k + 1]); ++r)
    {
      groups->SetTuple(r, surface.FirstCell + made.cells[k], surface.Groups);
    }
  }
  output->GetCellData()->AddArray(groups);
}

void vtkPlanarSurfaceOutline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GroupArrayName: " << this->GroupArrayName << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
