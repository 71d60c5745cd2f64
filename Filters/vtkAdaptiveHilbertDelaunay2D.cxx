// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "Engine/Core/FloatingPoint.h"
#include "Engine/Core/Memory.h"
#include "Engine/Core/Threads.h"
#include "Engine/Job/Settings.h"
#include "Engine/Triangulate.h"
#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDLentTriangulation.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Execution/vtkAHDMessages.h"
#include "Execution/vtkAHDOutputCache.h"
#include "Input/vtkAHDInput.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSay.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Pipeline/vtkAHDThreads.h"
#include "Ranks/vtkAHDRankUpdates.h"

#include "vtkAbstractTransform.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "vtkMultiProcessController.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
/// NaN if it is none.
double ReadNumber(const std::string& word)
{
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  const bool isRead = stream >> number && stream.eof();
  return isRead ? number : std::numeric_limits<double>::quiet_NaN();
}

/// The pairs of numbers in VoronoiPolygon; NaN for what is none.
std::vector<ahd::Point> ReadCorners(std::string text)
{
  const auto isMark = [](char c) { return c == ',' || c == ';'; };
  std::replace_if(text.begin(), text.end(), isMark, ' ');
  std::istringstream words(text);
  std::vector<ahd::Point> corners;
  for (std::string x, y; words >> x; y.clear())
  {
    words >> y;
    corners.push_back({ ReadNumber(x), ReadNumber(y) });
  }
  return corners;
}
}

vtkStandardNewMacro(vtkAdaptiveHilbertDelaunay2D);
vtkCxxSetObjectMacro(vtkAdaptiveHilbertDelaunay2D, Transform, vtkAbstractTransform);

vtkAdaptiveHilbertDelaunay2D::vtkAdaptiveHilbertDelaunay2D()
  : Workspace(new ahd::Workspace)
  , Cache(new vtkAHDOutputCache)
  , OutputMemory(new vtkAHDOutputMemory)
  , Updates(new vtkAHDRankUpdates)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  this->SetController(vtkMultiProcessController::GetGlobalController());
#endif
}

vtkAdaptiveHilbertDelaunay2D::~vtkAdaptiveHilbertDelaunay2D()
{
  this->TakeBackLent();
  this->SetTransform(nullptr);
  this->SetController(nullptr);
}

void vtkAdaptiveHilbertDelaunay2D::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(1, source);
}

void vtkAdaptiveHilbertDelaunay2D::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

vtkPolyData* vtkAdaptiveHilbertDelaunay2D::GetSource()
{
  return this->GetNumberOfInputConnections(1) > 0
    ? vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0))
    : nullptr;
}

vtkAbstractTransform* vtkAdaptiveHilbertDelaunay2D::ComputeBestFittingPlane(vtkPointSet* input)
{
  if (!input)
  {
    return nullptr;
  }
  const ahd::ScopedFloatingPoint asTheEngine;
  try
  {
    vtkNew<vtkAlgorithm> nobody; // without an abort
    vtkAHDProgress progress(nobody);
    ahd::Threads threads(vtkAHDThreadsToUse(0));
    vtkAHDOutputMemory none;
    const vtkAHDContext context(progress, threads, none);
    vtkAHDInput points(vtkAHDSettings(), input, nullptr);
    points.Open(context);
    ahd::Plane plane;
    context.Check(plane.fit(points.GetRequest().points, context));
    const vtkSmartPointer<vtkTransform> transform = vtkAHDMakeTransform(plane);
    transform->Register(nullptr);
    return transform;
  }
  catch (const vtkAHDStop&)
  {
    return nullptr;
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

vtkMTimeType vtkAdaptiveHilbertDelaunay2D::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Transform ? std::max(own, this->Transform->GetMTime()) : own;
}

void vtkAdaptiveHilbertDelaunay2D::SetMergeBlocks(bool merge)
{
  if (this->MergeBlocks != merge)
  {
    this->MergeBlocks = merge;
    this->DescribePortsAnew();
    this->Modified();
  }
}

int vtkAdaptiveHilbertDelaunay2D::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const ahd::ScopedFloatingPoint asTheEngine;
  vtkAHDDataSets data;
  std::array<vtkSmartPointer<vtkPolyData>, 3> held; // observers may replace outputs
  for (std::size_t port = 0; port < held.size(); ++port)
  {
    // null where it has blocks
    held[port] = vtkPolyData::GetData(outputVector, static_cast<int>(port));
    data.Outputs[port] = held[port];
  }
  // Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more, run
  // this filter again with every Update(), and keep the filters behind it at their last output.
  try
  {
    vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
    vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
    if (this->IsDistributed())
    {
      this->ExecuteOnRanks(input, source, outputVector);
      return 1;
    }
    const vtkMTimeType settings = this->GetMTime();
    if (!this->IsEmptyPiece(outputVector) || !this->Cache->KnowsEmpty(settings))
    {
      vtkAHDProgress progress(this);
      ahd::Threads threads(vtkAHDThreadsToUse(this->NumberOfThreads));
      const vtkAHDContext context(progress, threads, *this->OutputMemory);
      this->Execute(input, source, data, context);
      this->Cache->KeepEmpty(data, settings);
    }
    this->KeepFirstPieces(outputVector);
  }
  catch (const std::bad_alloc&)
  {
    this->EndWithoutMemory(data);
  }
  return 1;
}

/// Observers have the outputs, too: all is made in data sets of its own, and handed on in the end.
void vtkAdaptiveHilbertDelaunay2D::Execute(
  vtkDataObject* input, vtkDataObject* source, vtkAHDDataSets& data, const vtkAHDContext& context)
{
  vtkAHDSettings settings;
  this->ReadSettings(settings);
  const vtkAHDMergedBlocks merged(this, settings, input, source, context);
  std::array<vtkNew<vtkPolyData>, 3> outputs;
  vtkAHDDataSets own;
  own.Input = merged.GetInput();
  own.Source = merged.GetSource();
  own.InputBytes = merged.GetBytes();
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    outputs[k]->GetFieldData()->ShallowCopy(data.Outputs[k]->GetFieldData());
    own.Outputs[k] = outputs[k];
  }
  if (!own.Input || !this->PassOnCached(own, context))
  {
    this->ClearMeasures();
    this->WarnAboutRanks();
    merged.Warn();
    own.Input ? this->Triangulate(own, context) : this->Cache->Forget();
  }
  if (own.Input)
  {
    merged.HandOnPoints(outputs[0]);
  }
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    data.Outputs[k]->ShallowCopy(outputs[k]);
  }
}

/// Where memory ran out elsewhere than in an execution's steps, which say more of it.
void vtkAdaptiveHilbertDelaunay2D::EndWithoutMemory(const vtkAHDDataSets& data)
{
  for (vtkPolyData* output : data.Outputs)
  {
    if (output)
    {
      output->Initialize();
    }
  }
  this->Cache->Forget();
  this->ClearMeasures();
  vtkAHDSayOutOfMemory("vtkAdaptiveHilbertDelaunay2D",
    [this] { vtkErrorMacro("Out of memory. The output is empty."); });
}

/// Ends lending the triangulation of the last execution.
void vtkAdaptiveHilbertDelaunay2D::TakeBackLent()
{
  if (this->Lent)
  {
    this->Lent->TakeBack(*this->Workspace);
    this->Lent = nullptr;
  }
}

/// Passes on the outputs of the last execution if its input was the same. Else returns false.
bool vtkAdaptiveHilbertDelaunay2D::PassOnCached(
  const vtkAHDDataSets& data, const vtkAHDContext& context)
{
  if (!this->KeepTriangulation || context.IsAborted())
  {
    this->Cache->Forget();
    return false;
  }
  if (!this->Cache->Fits(data, this->GetMTime(), context))
  {
    return false;
  }
  this->Cache->PassOn(data);
  if (this->Lent && !this->Lent->BorrowsFrom(data.Input)) // no other input is to be held
  {
    this->TakeBackLent();
  }
  this->ClearSeconds();
  return true;
}

void vtkAdaptiveHilbertDelaunay2D::Triangulate(
  const vtkAHDDataSets& data, const vtkAHDContext& context)
{
  ++this->NumberOfTriangulations;
  vtkAHDSettings settings;
  this->ReadSettings(settings);
  vtkAHDInput input(settings, data.Input, data.Source);
  this->TakeBackLent();
  vtkAHDExecution execution(settings, input, *this->Workspace, context, data.InputBytes);
  const vtkAHDReport report = execution.Run(data.Outputs, &this->Lent);
  this->MemoryEstimate = report.GetEstimate();
  if (report.status != ahd::Status::Ok)
  {
    vtkAHDSayError(this, report);
    this->Cache->Forget();
    return;
  }
  this->TakeMeasures(report);
  this->AddCounts(data.Outputs[0]->GetFieldData());
  this->Warn(settings, report);
  if (this->KeepTriangulation && !settings.simplifies() && !settings.hasValues)
  {
    this->Cache->Keep(data, context); // it knows points, none of their data
  }
}

/// Of segments that InsertionLimit leaves out, once, as some move it step by step.
void vtkAdaptiveHilbertDelaunay2D::Warn(const vtkAHDSettings& settings, const vtkAHDReport& report)
{
  vtkAHDSayWarnings(this, settings, report, this->WarnedAboutLimit);
  const bool isTold = report.constraints.withoutVertex > 0 && report.delaunayTriangles > 0;
  this->WarnedAboutLimit = report.counts.beyondLimit > 0 && (this->WarnedAboutLimit || isTold);
}

/// `forSamples`: to interpolate on the triangulation, without its outputs. `onSurface`: on that of
/// a surface that was made before.
void vtkAdaptiveHilbertDelaunay2D::ReadSettings(
  vtkAHDSettings& settings, bool forSamples, bool onSurface) const
{
  ahd::JobSettings job;
  this->GetJobSettings(job);
  if (forSamples)
  {
    job.wantSamplesOnly();
  }
  if (onSurface)
  {
    job.leaveToSurface();
  }
  static_cast<ahd::RunSettings&>(settings) = job.run();
  if (settings.clipsAtPolygon())
  {
    settings.voronoiPolygon = ReadCorners(this->VoronoiPolygon);
  }
  this->ReadNumbers(settings);
  settings.AddSourcePoints = !settings.idsAreOfInput;
  settings.sourceHeights = settings.AddSourcePoints ? ahd::SourceHeights(this->SourceHeights)
                                                    : ahd::SourceHeights::Own;
  const bool fits = this->ProjectionPlaneMode == VTK_BEST_FITTING_PLANE;
  settings.Transform = fits ? nullptr : this->Transform;
  settings.plane = fits  ? ahd::PlaneKind::BestFit
    : settings.Transform ? ahd::PlaneKind::Callback
                         : ahd::PlaneKind::Xy;
  settings.TransformIsMissing = this->ProjectionPlaneMode == VTK_SET_TRANSFORM_PLANE &&
    !this->Transform;
  settings.MemoryLimit = this->MemoryLimit;
  settings.ReuseLimit = this->ReuseLimit;
}

/// Which arrays of the input are read, and whether the output has only points that are kept.
void vtkAdaptiveHilbertDelaunay2D::ReadNumbers(vtkAHDSettings& settings) const
{
  settings.ValueArrayName = this->ValueArrayName;
  settings.WeightArrayName = this->WeightArrayName;
  settings.KeepArrayName = this->KeepArrayName;
  const auto isNamed = [](const std::string& name) { return !name.empty() && name != "None"; };
  const bool simplifies = settings.simplifies();
  const bool areAllShown = settings.samples || settings.wants(ahd::WantedArray::PointStatus) ||
    settings.wants(ahd::WantedArray::Errors);
  settings.hasValues = isNamed(this->ValueArrayName) &&
    (simplifies || settings.wants(ahd::WantedArray::Errors));
  settings.hasWeights = isNamed(this->WeightArrayName) && simplifies;
  settings.hasMarks = isNamed(this->KeepArrayName) && simplifies;
  settings.CopiesKept = this->KeptPointsOnly && simplifies && !areAllShown;
}

int vtkAdaptiveHilbertDelaunay2D::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE()); // all types, as Set() is for the first
  if (port == 1)
  {
    // With both, the filter is not run for each block of a source.
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    if (this->IsDistributed())
    {
      info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // all hear of it
    }
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  if (this->IsDistributed())
  {
    // Whatever a rank has, it has to join the others.
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Remove(vtkAlgorithm::INPUT_IS_OPTIONAL());
  // The first type decides: a filter that takes composite data sets is not run for each block.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    this->MergeBlocks ? "vtkCompositeDataSet" : "vtkPointSet");
  if (this->MergeBlocks)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable"); // to say what to do with it
  return 1;
}

void vtkAdaptiveHilbertDelaunay2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Transform: " << this->Transform << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
