// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertInterpolation2D.h"

#include "Engine/Core/FloatingPoint.h"
#include "Engine/Core/Threads.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Pipeline/vtkAHDThreads.h"
#include "Sampling/vtkAHDSampleBounds.h"
#include "Sampling/vtkAHDSampleExecution.h"
#include "Sampling/vtkAHDSampleSettings.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

vtkStandardNewMacro(vtkAdaptiveHilbertInterpolation2D);
vtkCxxSetObjectMacro(
  vtkAdaptiveHilbertInterpolation2D, Triangulation, vtkAdaptiveHilbertDelaunay2D);

vtkAdaptiveHilbertInterpolation2D::vtkAdaptiveHilbertInterpolation2D()
  : Triangulation(vtkAdaptiveHilbertDelaunay2D::New())
  , NoValue(std::numeric_limits<double>::quiet_NaN())
  , Kept(new vtkAHDSampleMemoryKept)
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

void vtkAdaptiveHilbertInterpolation2D::SetDimensions(int columns, int rows)
{
  const int wished[2] = { std::max(1, columns), std::max(1, rows) };
  if (wished[0] != this->Dimensions[0] || wished[1] != this->Dimensions[1])
  {
    std::copy(wished, wished + 2, this->Dimensions);
    this->Modified();
  }
}

void vtkAdaptiveHilbertInterpolation2D::SetDimensions(const int dimensions[2])
{
  this->SetDimensions(dimensions[0], dimensions[1]);
}

void vtkAdaptiveHilbertInterpolation2D::SetNoValue(double value)
{
  // NaN is not equal to itself, but it is no other setting either.
  if (std::memcmp(&value, &this->NoValue, sizeof value) != 0)
  {
    this->NoValue = value;
    this->Modified();
  }
}

void vtkAdaptiveHilbertInterpolation2D::SetHeightArrayName(const std::string& name)
{
  if (name != this->HeightArrayName)
  {
    this->HeightArrayName = name;
    this->Modified();
  }
}

void vtkAdaptiveHilbertInterpolation2D::SetValidPointMaskArrayName(const std::string& name)
{
  if (name != this->ValidPointMaskArrayName)
  {
    this->ValidPointMaskArrayName = name;
    this->Modified();
  }
}

vtkMTimeType vtkAdaptiveHilbertInterpolation2D::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Triangulation ? std::max(own, this->Triangulation->GetMTime()) : own;
}

int vtkAdaptiveHilbertInterpolation2D::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  // The first type decides: with it the filter is not run for each block.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

/// The output is what the places are, an image or a grid.
int vtkAdaptiveHilbertInterpolation2D::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* const info = outputs->GetInformationObject(0);
  vtkDataObject* const places = vtkDataObject::GetData(inputs[1]);
  vtkDataObject* const now = vtkDataObject::GetData(info);
  vtkSmartPointer<vtkDataObject> wanted;
  if (inputs[1]->GetNumberOfInformationObjects() > 0)
  {
    if (!places)
    {
      return 0;
    }
    wanted.TakeReference(places->NewInstance());
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

void vtkAdaptiveHilbertInterpolation2D::ReadSettings(
  vtkAHDSettings& settings, vtkAHDSampleSettings& wishes) const
{
  this->Triangulation->ReadSettings(settings);
  settings.Samples = true;
  settings.GeneratePointStatus = settings.GenerateInsertionRank = false;
  settings.GenerateInsertionCurve = settings.GenerateConstraintEdges = false;
  settings.GenerateRegionIds = settings.GenerateNeighbors = settings.GenerateVoronoi = false;
  settings.Insertion.keepBoxes = settings.Insertion.keepOrder = false;
  wishes.Method = static_cast<ahd::SampleMethod>(this->Method);
  wishes.Raster.ByCellSize = this->RasterSize == BY_CELL_SIZE;
  wishes.Raster.Dimensions = { { this->Dimensions[0], this->Dimensions[1] } };
  wishes.Raster.CellSize = { { this->CellSize[0], this->CellSize[1] } };
  wishes.Raster.Align = this->AlignToCellSize;
  wishes.UseBounds = this->UseBounds;
  std::copy(this->Bounds, this->Bounds + 4, wishes.Bounds.begin());
  wishes.AsSurface = this->OutputType == SURFACE;
  wishes.NearestOutside = this->Outside == NEAREST_VERTEX;
  wishes.NoValue = this->NoValue;
  wishes.Gradients = this->GenerateGradients;
  wishes.Heights = this->HeightArrayName;
  wishes.Mask = this->ValidPointMaskArrayName;
}

/// The raster as it will be, as far as the input says; it is brought up to date where it does.
/// Filters behind have to know the extent, the origin and the spacing before there are data.
int vtkAdaptiveHilbertInterpolation2D::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = outputs->GetInformationObject(0);
  if (inputs[1]->GetNumberOfInformationObjects() > 0)
  {
    vtkInformation* const places = inputs[1]->GetInformationObject(0);
    info->CopyEntry(places, Pipeline::WHOLE_EXTENT());
    info->CopyEntry(places, vtkDataObject::ORIGIN());
    info->CopyEntry(places, vtkDataObject::SPACING());
    return 1;
  }
  vtkAHDRaster raster;
  if (this->Triangulation)
  {
    const ahd::ScopedFloatingPoint asTheEngine;
    vtkAHDSettings settings;
    vtkAHDSampleSettings wishes;
    this->ReadSettings(settings, wishes);
    raster = wishes.UseBounds ? vtkAHDMakeRasterWithin(wishes.Raster, wishes.Bounds)
                              : this->FindRaster(settings, wishes);
  }
  Announce(raster, info);
  return 1;
}

void vtkAdaptiveHilbertInterpolation2D::Announce(const vtkAHDRaster& raster, vtkInformation* info)
{
  const ahd::SampleRaster& cells = raster.Cells;
  const int extent[6] = { 0, static_cast<int>(cells.columns) - 1, 0,
    static_cast<int>(cells.rows) - 1, 0, raster.Fault == vtkAHDRasterFault::None ? 0 : -1 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), cells.origin.x, cells.origin.y, 0.0);
  info->Set(vtkDataObject::SPACING(), cells.spacing.x, cells.spacing.y, 1.0);
}

/// The raster about the points of the input, which is brought up to date.
vtkAHDRaster vtkAdaptiveHilbertInterpolation2D::FindRaster(
  const vtkAHDSettings& settings, const vtkAHDSampleSettings& wishes)
{
  for (const int port : { 0, 2 })
  {
    if (this->GetNumberOfInputConnections(port) > 0)
    {
      this->GetInputAlgorithm(port, 0)->Update(this->GetInputConnection(port, 0)->GetIndex());
    }
  }
  try
  {
    vtkNew<vtkAlgorithm> nobody; // who could abort, or be told of progress
    vtkAHDProgress progress(nobody);
    ahd::Threads threads(vtkAHDThreadsToUse(this->Triangulation->GetNumberOfThreads()));
    const vtkAHDContext context(progress, threads);
    vtkDataObject* const source = this->GetNumberOfInputConnections(2) > 0
      ? this->GetInputDataObject(2, 0)
      : nullptr;
    const vtkAHDMergedBlocks merged(
      this, settings, this->GetInputDataObject(0, 0), source, context);
    return merged.GetInput()
      ? vtkAHDMakeRaster(
          wishes.Raster, vtkAHDFindBounds(settings, merged.GetInput(), merged.GetSource(), context))
      : vtkAHDRaster();
  }
  catch (const vtkAHDStop&)
  {
  }
  catch (const std::bad_alloc&)
  {
  }
  return vtkAHDRaster();
}

/// All points are needed whatever part of the output is wanted, and all places.
int vtkAdaptiveHilbertInterpolation2D::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* const info = inputs[port]->GetInformationObject(i);
      if (info->Has(Pipeline::WHOLE_EXTENT()))
      {
        info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
      }
    }
  }
  return 1;
}

int vtkAdaptiveHilbertInterpolation2D::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const ahd::ScopedFloatingPoint asTheEngine;
  vtkDataSet* const output = vtkDataSet::GetData(outputs);
  // Errors return 1 as well, as they were told: see vtkAdaptiveHilbertDelaunay2D.
  this->ClearMeasures();
  if (!this->Triangulation)
  {
    vtkErrorMacro("Triangulation is null: nothing says how to triangulate.");
    output->Initialize();
    return 1;
  }
  try
  {
    this->Execute(inputs, output);
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    std::fputs("vtkAdaptiveHilbertInterpolation2D: out of memory, nothing is put out.\n", stderr);
  }
  return 1;
}

void vtkAdaptiveHilbertInterpolation2D::Execute(vtkInformationVector** inputs, vtkDataSet* output)
{
  vtkAHDProgress progress(this);
  ahd::Threads threads(vtkAHDThreadsToUse(this->Triangulation->GetNumberOfThreads()));
  const vtkAHDContext context(progress, threads);
  vtkAHDSettings settings;
  vtkAHDSampleSettings wishes;
  this->ReadSettings(settings, wishes);
  const vtkAHDMergedBlocks merged(
    this, settings, vtkDataObject::GetData(inputs[0]), vtkDataObject::GetData(inputs[2]), context);
  if (!merged.GetInput())
  {
    output->Initialize();
    return;
  }
  merged.Warn();
  vtkAHDSampleInputs data;
  data.Points = merged.GetInput();
  data.Source = merged.GetSource();
  data.Places = vtkDataSet::GetData(inputs[1]);
  data.InputBytes = merged.GetBytes();
  data.SettingsTime = this->Triangulation->GetMTime();
  vtkAHDSampleExecution execution(
    this, settings, wishes, context, this->Triangulation->GetKeepTriangulation());
  const bool isDone = execution.Run(data, *this->Kept, output);
  this->NumberOfTriangulations += execution.HasTriangulated() ? 1 : 0;
  this->MemoryEstimate = execution.GetMemory().Estimate;
  if (isDone)
  {
    this->TakeMeasures(execution.GetResult());
    this->SampleSeconds = execution.GetSeconds();
    this->AddCounts(output);
  }
}

void vtkAdaptiveHilbertInterpolation2D::ClearMeasures()
{
  this->TakeMeasures(vtkAHDSampleResult());
  this->SampleSeconds = 0.0;
  this->MemoryEstimate = 0;
}

void vtkAdaptiveHilbertInterpolation2D::TakeMeasures(const vtkAHDSampleResult& result)
{
  const ahd::SampleReport& counts = result.Counts;
  this->NumberOfPlaces = static_cast<vtkIdType>(result.Places);
  this->NumberOfValidPlaces = static_cast<vtkIdType>(counts.valued);
  this->NumberOfPlacesOutside = static_cast<vtkIdType>(counts.outside);
  this->NumberOfNotFinitePlaces = static_cast<vtkIdType>(counts.notFinite);
  this->NumberOfPlacesWithoutValue = static_cast<vtkIdType>(counts.withoutValue);
  this->NumberOfPlacesWithNeighborsLeftOut = static_cast<vtkIdType>(counts.leftOut);
}

/// Field data, with the names of the Get methods.
void vtkAdaptiveHilbertInterpolation2D::AddCounts(vtkDataSet* output) const
{
  const std::pair<const char*, vtkIdType> counts[] = {
    { "NumberOfPlaces", this->NumberOfPlaces },
    { "NumberOfValidPlaces", this->NumberOfValidPlaces },
    { "NumberOfPlacesOutside", this->NumberOfPlacesOutside },
    { "NumberOfNotFinitePlaces", this->NumberOfNotFinitePlaces },
    { "NumberOfPlacesWithoutValue", this->NumberOfPlacesWithoutValue },
    { "NumberOfPlacesWithNeighborsLeftOut", this->NumberOfPlacesWithNeighborsLeftOut },
  };
  for (const auto& count : counts)
  {
    vtkNew<vtkIdTypeArray> array;
    array->SetName(count.first);
    array->InsertNextValue(count.second);
    output->GetFieldData()->AddArray(array);
  }
}

void vtkAdaptiveHilbertInterpolation2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Triangulation: " << this->Triangulation << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "RasterSize: " << this->RasterSize << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << ", " << this->Dimensions[1] << "\n";
  os << indent << "CellSize: " << this->CellSize[0] << ", " << this->CellSize[1] << "\n";
  os << indent << "AlignToCellSize: " << (this->AlignToCellSize ? "On\n" : "Off\n");
  os << indent << "UseBounds: " << (this->UseBounds ? "On\n" : "Off\n");
  os << indent << "Bounds: " << this->Bounds[0] << ", " << this->Bounds[1] << ", "
     << this->Bounds[2] << ", " << this->Bounds[3] << "\n";
  os << indent << "OutputType: " << this->OutputType << "\n";
  os << indent << "Outside: " << this->Outside << "\n";
  os << indent << "NoValue: " << this->NoValue << "\n";
  os << indent << "GenerateGradients: " << (this->GenerateGradients ? "On\n" : "Off\n");
  os << indent << "HeightArrayName: " << this->HeightArrayName << "\n";
  os << indent << "ValidPointMaskArrayName: " << this->ValidPointMaskArrayName << "\n";
  os << indent << "NumberOfPlaces: " << this->NumberOfPlaces << "\n";
  os << indent << "NumberOfValidPlaces: " << this->NumberOfValidPlaces << "\n";
  os << indent << "NumberOfPlacesOutside: " << this->NumberOfPlacesOutside << "\n";
  os << indent << "NumberOfNotFinitePlaces: " << this->NumberOfNotFinitePlaces << "\n";
  os << indent << "NumberOfPlacesWithoutValue: " << this->NumberOfPlacesWithoutValue << "\n";
  os << indent << "NumberOfPlacesWithNeighborsLeftOut: " << this->NumberOfPlacesWithNeighborsLeftOut
     << "\n";
  os << indent << "SampleSeconds: " << this->SampleSeconds << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << "\n";
  os << indent << "NumberOfTriangulations: " << this->NumberOfTriangulations << "\n";
}
