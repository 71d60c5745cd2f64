// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAdaptiveHilbertInterpolation2D does where there are several ranks.
#include "vtkAdaptiveHilbertInterpolation2D.h"

#include "Engine/Core/FloatingPoint.h"
#include "Engine/Core/Threads.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Pipeline/vtkAHDThreads.h"
#include "Sampling/vtkAHDSampleColumns.h"
#include "Sampling/vtkAHDSampleInformation.h"
#include "Sampling/vtkAHDSampleMessages.h"
#include "Sampling/vtkAHDSampleOutput.h"
#include "Sampling/vtkAHDSampleSettings.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "Ranks/vtkAHDRankSampling.h"
#include "vtkMultiProcessController.h"
#endif

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Are there other ranks to interpolate with? As Triangulation says.
bool vtkAdaptiveHilbertInterpolation2D::IsDistributed() const
{
  return this->Triangulation && this->Triangulation->IsDistributed();
}

/// What downstream may ask for; pieces of an extent where there is one.
void vtkAdaptiveHilbertInterpolation2D::AnnouncePieces(vtkInformation* info) const
{
  const bool isDistributed = this->IsDistributed();
  const std::pair<vtkInformationIntegerKey*, bool> keys[] = {
    { vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), isDistributed },
    { vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(),
      isDistributed && info->Has(Pipeline::WHOLE_EXTENT()) },
  };
  for (const auto& key : keys)
  {
    key.second ? info->Set(key.first, 1) : info->Remove(key.first);
  }
}

#if VTK_MODULE_ENABLE_VTK_ParallelCore

namespace
{
/// Points and constraints of one rank, each as one data set.
struct RankInput
{
  /// Throws nothing.
  RankInput(vtkAlgorithm* filter, const vtkAHDSettings& settings, vtkDataObject* points,
    vtkDataObject* source, const vtkAHDContext& context, vtkAHDRankSampling::Inputs& inputs)
  {
    try
    {
      const bool hasPoints = vtkPointSet::SafeDownCast(points) ||
        vtkCompositeDataSet::SafeDownCast(points);
      this->Merged.reset(new vtkAHDMergedBlocks(
        filter, settings, hasPoints ? points : this->Nothing.Get(), source, context));
      inputs.Data.Input = this->Merged->GetInput();
      inputs.Data.Source = this->Merged->GetSource();
      inputs.Data.InputBytes = this->Merged->GetBytes();
    }
    catch (const std::bad_alloc&)
    {
    }
    if (!inputs.Data.Input)
    {
      const bool areBad = this->Merged && this->Merged->AreCellsBad();
      inputs.Before = context.IsAborted() ? ahd::Status::Cancelled
        : areBad                          ? ahd::Status::BadCells
                                          : ahd::Status::OutOfMemory;
    }
  }

  void Warn(vtkObject* filter, vtkDataObject* points) const
  {
    this->Merged->Warn();
    if (points && !vtkPointSet::SafeDownCast(points) && !vtkCompositeDataSet::SafeDownCast(points))
    {
      vtkWarningWithObjectMacro(filter,
        "A " << points->GetClassName()
             << " has no points of its own: nothing was triangulated for it.");
    }
  }

  vtkNew<vtkPolyData> Nothing;
  std::unique_ptr<vtkAHDMergedBlocks> Merged;
};
}

/// Ranks ask each other, with their pieces of the inputs brought up to date: all ranks alike. Those
/// that know the raster already take part in RequestData().
vtkAHDRaster vtkAdaptiveHilbertInterpolation2D::FindRasterOnRanks(
  const vtkAHDSettings& settings, const vtkAHDSampleSettings& wishes, vtkInformation* info)
{
  vtkMultiProcessController* const controller = this->Triangulation->GetController();
  for (const int port : { 0, 2 })
  {
    if (this->GetNumberOfInputConnections(port) > 0)
    {
      vtkAlgorithmOutput* const from = this->GetInputConnection(port, 0);
      vtkNew<vtkInformation> request;
      request->Set(Pipeline::UPDATE_PIECE_NUMBER(), controller->GetLocalProcessId());
      request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), controller->GetNumberOfProcesses());
      request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      vtkInformation* const told = this->GetExecutive()->GetOutputInformation(0);
      if (told->Has(Pipeline::UPDATE_TIME_STEP()))
      {
        request->Set(Pipeline::UPDATE_TIME_STEP(), told->Get(Pipeline::UPDATE_TIME_STEP()));
      }
      vtkNew<vtkInformationVector> requests;
      requests->SetInformationObject(from->GetIndex(), request);
      from->GetProducer()->Update(from->GetIndex(), requests);
    }
  }
  vtkNew<vtkAlgorithm> nobody; // who could abort, or be told of progress or errors
  vtkAHDProgress progress(nobody);
  ahd::Threads threads(vtkAHDThreadsToUse(this->Triangulation->GetNumberOfThreads()));
  vtkAHDOutputMemory notKept;
  const vtkAHDContext context(progress, threads, notKept);
  vtkAHDRanks ranks(controller);
  vtkAHDRankSampling::Inputs inputs;
  const auto dataOf = [&](int port)
  {
    return this->GetNumberOfInputConnections(port) > 0 ? this->GetInputDataObject(port, 0)
                                                       : nullptr;
  };
  const RankInput input(nullptr, settings, dataOf(0), dataOf(2), context, inputs);
  try
  {
    vtkAHDRankSampling asking(nobody, settings, wishes, ranks, context);
    const vtkAHDRaster raster = asking.FindRaster(inputs);
    const vtkAHDSampleColumns::Kind scalars = asking.GetKindOfScalars();
    vtkDataObject::SetPointDataActiveScalarInfo(info, scalars.Type, scalars.Components);
    return raster;
  }
  catch (const vtkAHDStop&)
  {
  }
  catch (const std::bad_alloc&)
  {
  }
  return vtkAHDRaster();
}

/// What is known before there are data.
void vtkAdaptiveHilbertInterpolation2D::DescribeOnRanks(vtkInformation* info, bool isRaster)
{
  if (!isRaster)
  {
    return;
  }
  const ahd::ScopedFloatingPoint asTheEngine;
  vtkAHDSettings settings;
  vtkAHDSampleSettings wishes;
  this->ReadSettings(settings, wishes);
  vtkAHDAnnounceRaster(this->FindRasterOnRanks(settings, wishes, info), info);
}

/// Each rank takes its piece, whatever is asked of it: points of others would come twice. Where
/// there is an extent, the piece is one of that which is asked for.
void vtkAdaptiveHilbertInterpolation2D::AskForPieces(vtkInformationVector** inputs)
{
  for (int port = 0; port < this->GetNumberOfInputPorts() && this->IsDistributed(); ++port)
  {
    vtkMultiProcessController* const controller = this->Triangulation->GetController();
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* const info = inputs[port]->GetInformationObject(i);
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), controller->GetLocalProcessId());
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), controller->GetNumberOfProcesses());
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
}

/// Returns what RequestData() is to return: the same on all ranks.
int vtkAdaptiveHilbertInterpolation2D::ExecuteOnRanks(
  vtkInformationVector** inputs, vtkInformation* info, vtkDataObject* output)
{
  vtkAHDProgress progress(this);
  ahd::Threads threads(vtkAHDThreadsToUse(this->Triangulation->GetNumberOfThreads()));
  vtkAHDOutputMemory notKept;
  const vtkAHDContext context(progress, threads, notKept);
  vtkAHDSettings settings;
  vtkAHDSampleSettings wishes;
  this->ReadSettings(settings, wishes);
  vtkAHDRanks ranks(this->Triangulation->GetController());
  vtkAHDRankSampling::Inputs given;
  const RankInput input(this, settings, vtkDataObject::GetData(inputs[0]),
    vtkDataObject::GetData(inputs[2]), context, given);
  if (given.Data.Input)
  {
    input.Warn(this, vtkDataObject::GetData(inputs[0]));
  }
  given.Places = vtkDataObject::GetData(inputs[1]);
  if (info->Has(Pipeline::UPDATE_EXTENT()))
  {
    info->Get(Pipeline::UPDATE_EXTENT(), given.Extent.data());
  }
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    info->Get(Pipeline::WHOLE_EXTENT(), given.Whole.data());
  }
  if (info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    given.Piece = { { info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
      info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()),
      info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) } };
  }
  vtkAHDRankSampling execution(this, settings, wishes, ranks, context);
  ++this->NumberOfTriangulations;
  const bool isDone = execution.Run(given, output);
  this->MemoryEstimate = execution.GetEstimate();
  if (isDone)
  {
    this->AddMeasures(execution.GetResult());
    this->SampleSeconds = execution.GetSeconds();
    AddCounts(execution.GetResult(), vtkDataSet::SafeDownCast(output));
  }
#if AHD_VTK_HAS_CHECK_ABORT
  else if (execution.IsAborted())
  {
    this->SetAbortOutput(true); // so that all execute anew, as the one that was told to abort does
  }
#endif
  this->MustDescribeAnew = execution.IsOtherRaster();
  const bool isRaster = inputs[1]->GetNumberOfInformationObjects() == 0;
  const bool fits = !isRaster || !vtkAHDHasFiltersBehind(info) ||
    vtkAHDHasAllThatIsWanted(output, info);
  const bool fitAll = ranks.agree(fits ? ahd::Status::Ok : ahd::Status::Cancelled) ==
    ahd::Status::Ok;
  return fitAll ? 1 : this->EndWithOtherRaster(isDone, output);
}

void vtkAdaptiveHilbertInterpolation2D::WarnAboutRanks()
{
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  if (!this->WarnedAboutRanks && ranks && ranks->GetNumberOfProcesses() > 1 &&
    ranks->GetLocalProcessId() == 0)
  {
    this->WarnedAboutRanks = true;
    vtkWarningMacro("There are "
      << ranks->GetNumberOfProcesses()
      << " ranks, and each interpolates between its own points only: values of different ranks do "
         "not fit together. "
      << (this->Triangulation->GetDistributePoints()
             ? "DistributePoints of Triangulation has no effect without a Controller."
             : "DistributePoints of Triangulation interpolates between the points of all."));
  }
}

#else

vtkAHDRaster vtkAdaptiveHilbertInterpolation2D::FindRasterOnRanks(
  const vtkAHDSettings&, const vtkAHDSampleSettings&, vtkInformation*)
{
  return vtkAHDRaster();
}
void vtkAdaptiveHilbertInterpolation2D::DescribeOnRanks(vtkInformation*, bool) {}
void vtkAdaptiveHilbertInterpolation2D::AskForPieces(vtkInformationVector**) {}
int vtkAdaptiveHilbertInterpolation2D::ExecuteOnRanks(
  vtkInformationVector**, vtkInformation*, vtkDataObject*)
{
  return 1;
}
void vtkAdaptiveHilbertInterpolation2D::WarnAboutRanks() {}

#endif
