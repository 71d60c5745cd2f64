// SPDX-License-Identifier: BSD-3-Clause
//
// What the interpolation tells filters behind it before there are data, and asks of those before
// it.
#include "vtkAdaptiveHilbertInterpolation2D.h"

#include "Engine/Core/FloatingPoint.h"
#include "Engine/Core/Memory.h"
#include "Engine/Core/Threads.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDPieces.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Pipeline/vtkAHDThreads.h"
#include "Ranks/vtkAHDRankUpdates.h"
#include "Sampling/vtkAHDGivenSurface.h"
#include "Sampling/vtkAHDSampleBounds.h"
#include "Sampling/vtkAHDSampleColumns.h"
#include "Sampling/vtkAHDSampleInformation.h"
#include "Sampling/vtkAHDSampleSettings.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <new>

/// Filters behind have to know extent, origin, spacing and the type of the scalars before there are
/// data. The points say them, so these are brought up to date here.
int vtkAdaptiveHilbertInterpolation2D::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* const info = outputs->GetInformationObject(0);
  const bool isRaster = inputs[1]->GetNumberOfInformationObjects() == 0;
  if (isRaster)
  {
    vtkAHDAnnounceRaster(vtkAHDRaster(), info); // until it is known
  }
  else
  {
    vtkInformation* const places = inputs[1]->GetInformationObject(0);
    info->CopyEntry(places, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    info->CopyEntry(places, vtkDataObject::ORIGIN());
    info->CopyEntry(places, vtkDataObject::SPACING());
  }
  if (this->IsDistributed())
  {
    this->ShareTimes(outputs);
    this->DescribeOnRanks(info, isRaster);
    this->Updates->Settle();
  }
  else if (this->Triangulation)
  {
    const ahd::ScopedFloatingPoint asTheEngine;
    try
    {
      this->UpdateInputs();
      this->Describe(info, isRaster);
    }
    catch (const vtkAHDStop&)
    {
    }
    catch (const std::bad_alloc&)
    {
    }
  }
  this->AnnouncePieces(info);
  return 1;
}

/// Others may have requested a piece of the same inputs, which then lack points.
void vtkAdaptiveHilbertInterpolation2D::UpdateInputs()
{
  const bool isAlone = vtkAHDIsOnlyProcess(this->Triangulation->GetController());
  for (const int port : { 0, 2 })
  {
    if (this->GetNumberOfInputConnections(port) > 0)
    {
      vtkAlgorithmOutput* const from = this->GetInputConnection(port, 0);
      vtkNew<vtkInformationVector> requests;
      requests->SetInformationObject(from->GetIndex(), vtkNew<vtkInformation>());
      vtkInformation* const request = requests->GetInformationObject(from->GetIndex());
      request->CopyEntry(from->GetProducer()->GetOutputInformation(from->GetIndex()),
        vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
      if (isAlone)
      {
        vtkAHDAskForAll(requests);
      }
      from->GetProducer()->Update(from->GetIndex(), requests);
    }
  }
}

/// Says what the output will be like. What is wrong with the input or settings is said when they
/// are used.
void vtkAdaptiveHilbertInterpolation2D::Describe(vtkInformation* info, bool isRaster)
{
  vtkAHDSettings settings;
  vtkAHDSampleSettings wishes;
  this->ReadSettings(settings, wishes);
  vtkNew<vtkAlgorithm> nobody; // without abort and progress
  vtkAHDProgress progress(nobody);
  ahd::Threads threads(vtkAHDThreadsToUse(this->Triangulation->GetNumberOfThreads()));
  vtkAHDOutputMemory notKept;
  const vtkAHDContext context(progress, threads, notKept);
  vtkDataObject* const source = this->GetNumberOfInputConnections(2) > 0
    ? this->GetInputDataObject(2, 0)
    : nullptr;
  const vtkAHDMergedBlocks merged(
    nullptr, settings, this->GetInputDataObject(0, 0), source, context);
  if (!merged.GetInput())
  {
    return;
  }
  vtkPolyData* const surface = merged.GetSource() ? nullptr : vtkAHDFindSurface(merged.GetInput());
  if (surface)
  {
    this->Triangulation->ReadSettings(settings, true, true);
  }
  vtkPointData* const data = merged.GetInput()->GetPointData();
  const vtkAHDSampleColumns::Kind scalars = vtkAHDSampleColumns(
    wishes, data, data, static_cast<std::size_t>(merged.GetInput()->GetNumberOfPoints()))
                                              .GetKindOfScalars();
  vtkDataObject::SetPointDataActiveScalarInfo(info, scalars.Type, scalars.Components);
  if (isRaster)
  {
    // Too little memory is reported when the raster is filled.
    const double bytes = double(merged.GetBytes()) +
      double(vtkAHDEstimateBounds(settings, wishes, merged.GetInput(), merged.GetSource()));
    const double most = settings.MemoryLimit > 0
      ? 1024.0 * (double(settings.MemoryLimit) + 1.0)
      : double(ahd::availableMemory()) + double(merged.GetBytes());
    if (bytes >= most)
    {
      return;
    }
    ahd::Plane plane;
    if (surface && settings.fitsPlane() && !wishes.UseBounds)
    {
      plane = vtkAHDFitPlaneOf(settings, surface, context);
      settings.Plane = &plane;
    }
    const vtkAHDRaster raster = vtkAHDFindRaster(
      settings, wishes, merged.GetInput(), merged.GetSource(), context);
    // Filters for images behind may make room for one as large before the data are there.
    const bool isTooLarge = vtkAHDIsLarger(raster.Cells, settings.MemoryLimit);
    vtkAHDAnnounceRaster(isTooLarge ? vtkAHDRaster() : raster, info);
  }
}

/// All points are needed whatever part of the output is wanted; on ranks the piece of each. Of
/// places as many as are wanted of the output, and all where these have an extent.
int vtkAdaptiveHilbertInterpolation2D::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->AskForPieces(inputs);
  const bool isAlone = this->Triangulation &&
    vtkAHDIsOnlyProcess(this->Triangulation->GetController());
  for (const int port : { 0, 2 })
  {
    if (isAlone)
    {
      vtkAHDAskForAll(inputs[port]);
    }
  }
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
