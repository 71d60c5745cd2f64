// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertInterpolation2D.h"

#include "Engine/Core/FloatingPoint.h"
#include "Engine/Core/Threads.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSay.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Pipeline/vtkAHDThreads.h"
#include "Ranks/vtkAHDRankUpdates.h"
#include "Sampling/vtkAHDGivenSurface.h"
#include "Sampling/vtkAHDSampleExecution.h"
#include "Sampling/vtkAHDSampleInformation.h"
#include "Sampling/vtkAHDSampleMessages.h"
#include "Sampling/vtkAHDSamplePieces.h"
#include "Sampling/vtkAHDSampleSettings.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkAbstractTransform.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <new>
#include <utility>

vtkStandardNewMacro(vtkAdaptiveHilbertInterpolation2D);
vtkCxxSetObjectMacro(
  vtkAdaptiveHilbertInterpolation2D, Triangulation, vtkAdaptiveHilbertDelaunay2D);

vtkAdaptiveHilbertInterpolation2D::vtkAdaptiveHilbertInterpolation2D()
  : Triangulation(vtkAdaptiveHilbertDelaunay2D::New())
  , Kept(new vtkAHDSampleMemoryKept)
  , Updates(new vtkAHDRankUpdates)
{
  this->SetNumberOfInputPorts(3);
}

vtkAdaptiveHilbertInterpolation2D::~vtkAdaptiveHilbertInterpolation2D()
{
  this->SetTriangulation(nullptr);
}

void vtkAdaptiveHilbertInterpolation2D::SetPlacesData(vtkDataSet* places)
{
  this->SetInputData(1, places);
}

void vtkAdaptiveHilbertInterpolation2D::SetPlacesConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

vtkDataSet* vtkAdaptiveHilbertInterpolation2D::GetPlaces()
{
  return this->GetNumberOfInputConnections(1) > 0
    ? vtkDataSet::SafeDownCast(this->GetInputDataObject(1, 0))
    : nullptr;
}

void vtkAdaptiveHilbertInterpolation2D::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(2, source);
}

void vtkAdaptiveHilbertInterpolation2D::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

vtkPolyData* vtkAdaptiveHilbertInterpolation2D::GetSource()
{
  return this->GetNumberOfInputConnections(2) > 0
    ? vtkPolyData::SafeDownCast(this->GetInputDataObject(2, 0))
    : nullptr;
}

/// In RequestData() it would be too early to be modified: the pipeline then takes all for up to
/// date.
vtkMTimeType vtkAdaptiveHilbertInterpolation2D::GetMTime()
{
  if (this->MustDescribeAnew)
  {
    this->MustDescribeAnew = false;
    this->Modified(); // so that the next Update() begins with RequestInformation()
  }
  if (this->IsDistributed() != this->HasPortsOfRanks)
  {
    this->HasPortsOfRanks = !this->HasPortsOfRanks;
    // FillInputPortInformation() says something else now
    for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
    {
      this->GetInputPortInformation(port)->Remove(vtkAlgorithm::PORT_REQUIREMENTS_FILLED());
    }
  }
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Triangulation ? std::max(own, this->Triangulation->GetMTime()) : own;
}

int vtkAdaptiveHilbertInterpolation2D::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Remove(vtkAlgorithm::INPUT_IS_OPTIONAL());
  if (port != 1 && this->IsDistributed())
  {
    // Whatever a rank has, it has to join the others.
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    if (this->IsDistributed())
    {
      info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // all hear of it
    }
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  // The first type decides: with it the filter is not run for each block.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable"); // to say what to do with it
  }
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkAdaptiveHilbertInterpolation2D::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // the places may have blocks
  return 1;
}

/// The output has the type of the places, or is an image or a grid.
int vtkAdaptiveHilbertInterpolation2D::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* const info = outputs->GetInformationObject(0);
  vtkDataObject* const places = vtkDataObject::GetData(inputs[1]);
  vtkDataObject* const now = vtkDataObject::GetData(info);
  vtkSmartPointer<vtkDataObject> wanted;
  if (inputs[1]->GetNumberOfInformationObjects() > 0)
  {
    if (places)
    {
      wanted.TakeReference(places->NewInstance());
    }
    else if (this->IsDistributed())
    {
      wanted = vtkSmartPointer<vtkPolyData>::New(); // others wait to hear of it
    }
    else
    {
      return 0;
    }
  }
  else if (this->OutputType == SURFACE)
  {
    wanted = vtkSmartPointer<vtkStructuredGrid>::New();
  }
  else
  {
    wanted = vtkSmartPointer<vtkImageData>::New();
  }
  if (!now || std::strcmp(now->GetClassName(), wanted->GetClassName()) != 0)
  {
    info->Set(vtkDataObject::DATA_OBJECT(), wanted);
    this->GetOutputPortInformation(0)->Set(
      vtkDataObject::DATA_EXTENT_TYPE(), wanted->GetExtentType());
  }
  return 1;
}

/// What VTK keeps of a request takes memory, too.
vtkTypeBool vtkAdaptiveHilbertInterpolation2D::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  try
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  catch (const std::bad_alloc&)
  {
    vtkAHDSayOutOfMemory("vtkAdaptiveHilbertInterpolation2D",
      [&]
      {
        this->ClearCounts();
        this->Modified(); // or VTK takes the output for that of the last execution
        if (vtkDataObject* const output = vtkDataObject::GetData(outputs))
        {
          output->Initialize();
        }
        this->SayOutOfMemory();
      });
    return 0;
  }
}

void vtkAdaptiveHilbertInterpolation2D::ReadSettings(
  vtkAHDSettings& settings, vtkAHDSampleSettings& wishes) const
{
  this->Triangulation->ReadSettings(settings, true);
  wishes.Method = static_cast<ahd::SampleMethod>(this->Method);
  wishes.Raster.ByCellSize = this->RasterSize == BY_CELL_SIZE;
  wishes.Raster.Dimensions = { { this->Dimensions[0], this->Dimensions[1] } };
  wishes.Raster.CellSize = { { this->CellSize[0], this->CellSize[1] } };
  wishes.Raster.Align = this->AlignToCellSize;
  wishes.UseBounds = this->UseBounds;
  std::copy(this->Bounds, this->Bounds + 4, wishes.Bounds.begin());
  wishes.AsSurface = this->OutputType == SURFACE;
  wishes.Outside = static_cast<ahd::OutsideValues>(this->Outside);
  wishes.NoValue = this->NoValue;
  wishes.Gradients = this->GenerateGradients;
  wishes.Heights = this->HeightArrayName;
  wishes.Mask = this->ValidPointMaskArrayName;
}

int vtkAdaptiveHilbertInterpolation2D::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const ahd::ScopedFloatingPoint asTheEngine;
  vtkInformation* const info = outputs->GetInformationObject(0);
  const vtkSmartPointer<vtkDataObject> output = vtkDataObject::GetData(info);
  if (vtkFieldData* const data = output->GetAttributesAsFieldData(vtkDataObject::POINT))
  {
    data->Initialize(); // VTK leaves an image the scalars of the last execution
  }
  // Errors return 1 as well, as they were told: see vtkAdaptiveHilbertDelaunay2D.
  this->ClearMeasures();
  if (this->IsDistributed())
  {
    const int result = this->ExecuteOnRanks(inputs, info, output);
    this->Updates->Settle();
    return result;
  }
  this->MustDescribeAnew = false;
  const bool isRaster = inputs[1]->GetNumberOfInformationObjects() == 0;
  const bool isBehind = isRaster && vtkAHDHasFiltersBehind(info);
  bool isDone = false;
  try
  {
    // Observers have the output, too: all is made in one of its own, and handed on in the end.
    const auto made = vtkSmartPointer<vtkDataObject>::Take(output->NewInstance());
    made->ShallowCopy(output);
    isDone = this->Execute(inputs, info, made);
    output->ShallowCopy(made);
    if (isDone && isBehind && this->MustDescribeAnew)
    {
      this->WarnOfOtherRaster();
    }
  }
  catch (const std::bad_alloc&)
  {
    isDone = false;
    this->SayOutOfMemory();
  }
  if (!isDone)
  {
    output->Initialize();
    this->ClearCounts();
  }
  return !isBehind || vtkAHDHasAllThatIsWanted(output, info)
    ? 1
    : this->EndWithOtherRaster(isDone, output);
}

/// Where memory ran out elsewhere than in an execution's steps, which say more of it.
void vtkAdaptiveHilbertInterpolation2D::SayOutOfMemory()
{
  vtkAHDSayOutOfMemory("vtkAdaptiveHilbertInterpolation2D",
    [this] { vtkErrorMacro("Out of memory. The output is empty."); });
}

/// Once for each filter.
void vtkAdaptiveHilbertInterpolation2D::WarnOfOtherRaster()
{
  if (!this->WarnedOfOtherRaster)
  {
    this->WarnedOfOtherRaster = true;
    vtkWarningMacro(
      "The points have other bounds at this time, so the raster differs from the "
      "one announced to downstream filters. Until the next update image filters place "
      "it where it was before, or use a part of it. Set UseBounds to have one raster "
      "at all times. This warning appears once.");
  }
}

/// Filters for images behind would read pixels that are not there, so those behind are not run.
/// Returns what RequestData() is to return.
int vtkAdaptiveHilbertInterpolation2D::EndWithOtherRaster(bool isDone, vtkDataObject* output)
{
  this->MustDescribeAnew = true; // VTK takes the output for that of the last time that did not fail
  if (isDone)
  {
    vtkAHDSayOutOfMemory("vtkAdaptiveHilbertInterpolation2D",
      [this]
      {
        vtkErrorMacro("The points have other bounds at this time, so the raster differs from the "
                      "one announced to downstream filters, and lacks cells that they request. "
                      "Update again, or set UseBounds to have one raster at all times.");
      });
    output->Initialize();
    this->ClearCounts();
  }
  return 0;
}

bool vtkAdaptiveHilbertInterpolation2D::Execute(
  vtkInformationVector** inputs, vtkInformation* info, vtkDataObject* output)
{
  vtkAHDProgress progress(this);
  const vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> triangulation = this->Triangulation;
  if (!triangulation)
  {
    vtkAHDSay(this, ahd::Topic::Refusal, { { "triangulation_is_null", true } });
    return false;
  }
  this->WarnAboutRanks();
  ahd::Threads threads(vtkAHDThreadsToUse(triangulation->GetNumberOfThreads()));
  vtkAHDOutputMemory notKept;
  const vtkAHDContext context(progress, threads, notKept);
  vtkAHDSettings settings, onSurface;
  vtkAHDSampleSettings wishes;
  this->ReadSettings(settings, wishes);
  triangulation->ReadSettings(onSurface, true, true);
  if (!vtkAHDAreNamesFit(this, wishes))
  {
    return false;
  }
  const vtkAHDMergedBlocks merged(
    this, settings, vtkDataObject::GetData(inputs[0]), vtkDataObject::GetData(inputs[2]), context);
  merged.Warn();
  if (!merged.GetInput())
  {
    return false;
  }
  vtkAHDSampleInputs data;
  data.Points = merged.GetInput();
  data.Source = merged.GetSource();
  data.Surface = data.Source ? nullptr : vtkAHDFindSurface(data.Points);
  if (data.Surface)
  {
    settings = onSurface;
  }
  data.InputBytes = merged.GetBytes();
  vtkAbstractTransform* const transform = triangulation->GetTransform();
  data.SettingsTimes = { { triangulation->vtkObject::GetMTime(),
    transform ? transform->GetMTime() : 0 } };
  const bool isRaster = inputs[1]->GetNumberOfInformationObjects() == 0;
  data.Told = isRaster && vtkAHDHasFiltersBehind(info) ? vtkAHDToldRaster(info)
                                                       : ahd::SampleRaster();
  progress.Watch(vtkDataObject::GetData(inputs[1]));
  const vtkAHDSamplePieces pieces(vtkDataObject::GetData(inputs[1]), output);
  vtkAHDSettings between = settings; // the triangulation is kept until the last piece is done
  between.ReuseLimit = VTK_TYPE_INT64_MAX;
  vtkAHDSampleResult all;
  for (std::size_t k = 0; k < pieces.GetCount(); ++k)
  {
    const bool isLast = k + 1 == pieces.GetCount();
    data.Places = pieces.GetPlaces(k);
    data.Pieces = pieces.GetCount() > 1 ? &pieces : nullptr;
    data.Piece = k;
    data.SaysArrays = k == 0;
    vtkAHDSampleExecution execution(this, isLast ? settings : between, wishes, context,
      !isLast || triangulation->GetKeepTriangulation());
    const bool isDone = execution.Run(data, *this->Kept, pieces.GetOutput(k));
    this->NumberOfTriangulations += execution.HasTriangulated() ? 1 : 0;
    this->MemoryEstimate = std::max(this->MemoryEstimate, execution.GetMemory().Estimate);
    if (!isDone)
    {
      return false;
    }
    this->MustDescribeAnew = isRaster &&
      (execution.CoversTold() || vtkAHDIsNotAnnounced(output, info));
    all.Add(execution.GetResult());
    this->SampleSeconds += execution.GetSeconds();
    AddCounts(execution.GetResult().Counts, pieces.GetOutput(k)->GetFieldData());
  }
  this->AddMeasures(all.Counts);
  vtkAHDSayPlaceWarnings(this, all);
  return true;
}

/// All but the estimate.
void vtkAdaptiveHilbertInterpolation2D::ClearCounts()
{
  const vtkTypeInt64 estimate = this->MemoryEstimate;
  this->ClearMeasures();
  this->MemoryEstimate = estimate;
}

void vtkAdaptiveHilbertInterpolation2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Triangulation: " << this->Triangulation << "\n";
}
