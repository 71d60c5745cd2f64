// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAdaptiveHilbertInterpolation2D does where there are several ranks.
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
/// What one rank works with in one execution.
struct RankWork
{
  RankWork(vtkAlgorithm* filter, int threads)
    : Progress(filter)
    , Threads(vtkAHDThreadsToUse(threads))
    , Context(this->Progress, this->Threads, this->NotKept)
  {
  }

  /// Points and constraints, each as one data set. @pre Settings.
  void Take(vtkAlgorithm* filter, vtkDataObject* points, vtkDataObject* source)
  {
    const bool hasPoints = vtkPointSet::SafeDownCast(points) ||
      vtkCompositeDataSet::SafeDownCast(points);
    this->Merged.reset(new vtkAHDMergedBlocks(
      filter, this->Settings, hasPoints ? points : this->Nothing.Get(), source, this->Context));
    this->Given.Data.Input = this->Merged->GetInput();
    this->Given.Data.Source = this->Merged->GetSource();
    this->Given.Data.InputBytes = this->Merged->GetBytes();
    this->Given.Before = this->Merged->GetStatus(this->Context);
    if (filter && this->Given.Data.Input)
    {
      this->Merged->Warn();
      if (points && !hasPoints)
      {
        vtkAHDSay(filter, ahd::Topic::Blocks, { { "without_points", points->GetClassName() } });
      }
    }
  }

  /// Held, because observers may change the pipeline's data. May be null.
  void TakePlaces(vtkDataObject* places)
  {
    if (places)
    {
      this->Progress.Watch(places);
      this->Places.TakeReference(places->NewInstance());
      this->Places->ShallowCopy(places);
      this->Given.Places = this->Places;
    }
  }

  /// The piece of the output that is wanted.
  void ReadRequest(vtkInformation* info)
  {
    if (info->Has(Pipeline::UPDATE_EXTENT()))
    {
      info->Get(Pipeline::UPDATE_EXTENT(), this->Given.Extent.data());
    }
    if (info->Has(Pipeline::WHOLE_EXTENT()))
    {
      info->Get(Pipeline::WHOLE_EXTENT(), this->Given.Whole.data());
    }
    if (info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
    {
      this->Given.Piece = { { info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
        info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()),
        info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) } };
    }
  }

  vtkAHDProgress Progress;
  ahd::Threads Threads;
  vtkAHDOutputMemory NotKept;
  const vtkAHDContext Context;
  vtkAHDSettings Settings;
  vtkAHDSampleSettings Wishes;
  vtkNew<vtkPolyData> Nothing;
  vtkSmartPointer<vtkDataObject> Places;
  std::unique_ptr<vtkAHDMergedBlocks> Merged;
  vtkAHDRankSampling::Inputs Given;
};
}

/// Brings this rank's pieces of the inputs up to date.
void vtkAdaptiveHilbertInterpolation2D::UpdatePieces()
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
}

/// Ranks ask each other, with their pieces of the inputs: all ranks alike. Throws as
/// vtkAHDRankSampling::FindRaster().
vtkAHDRaster vtkAdaptiveHilbertInterpolation2D::FindRasterOnRanks(
  vtkAHDRanks& ranks, vtkInformation* info)
{
  vtkNew<vtkAlgorithm> nobody; // without abort, progress and errors
  RankWork work(nobody, this->Triangulation->GetNumberOfThreads());
  this->ReadSettings(work.Settings, work.Wishes);
  this->Triangulation->GetSettingsOfRanks(work.Settings.OfRanks);
  this->GetSettingsOfRanks(work.Wishes.OfRanks);
  const auto dataOf = [&](int port)
  {
    return this->GetNumberOfInputConnections(port) > 0 ? this->GetInputDataObject(port, 0)
                                                       : nullptr;
  };
  work.Take(nullptr, dataOf(0), dataOf(2));
  work.Given.Places = dataOf(1);
  vtkAHDRankSampling asking(nobody, work.Settings, work.Wishes, ranks, work.Context);
  const vtkAHDRaster raster = asking.FindRaster(work.Given);
  const vtkAHDSampleColumns::Kind scalars = asking.GetKindOfScalars();
  vtkDataObject::SetPointDataActiveScalarInfo(info, scalars.Type, scalars.Components);
  return raster;
}

/// What is known before there are data. Where one rank has a raster, all take part: those that have
/// places hear there, as the others do, that this is not the same.
void vtkAdaptiveHilbertInterpolation2D::DescribeOnRanks(vtkInformation* info, bool isRaster)
{
  const ahd::ScopedFloatingPoint asTheEngine;
  vtkAHDRaster raster; // none, where ranks cannot go on
  vtkAHDRanks ranks(this->Triangulation->GetController());
  bool isAny = false;
  ranks.Execute([&] { isAny = ranks.IsAny(isRaster); });
  if (!isAny)
  {
    return;
  }
  this->UpdatePieces();
  if (ranks.Execute([&] { raster = this->FindRasterOnRanks(ranks, info); }) != ahd::Status::Ok)
  {
    raster = vtkAHDRaster();
  }
  if (isRaster)
  {
    vtkAHDAnnounceRaster(raster, info);
  }
}

int vtkAdaptiveHilbertInterpolation2D::ComputePipelineMTime(vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs, int requestFromOutputPort,
  vtkMTimeType* mtime)
{
  const int result = this->Superclass::ComputePipelineMTime(
    request, inputs, outputs, requestFromOutputPort, mtime);
  if (this->IsDistributed())
  {
    *mtime = this->Updates->FindMTime(
      this->Triangulation->GetController(), this, *mtime, inputs, outputs);
  }
  return result;
}

/// Has ranks execute for the same times.
void vtkAdaptiveHilbertInterpolation2D::ShareTimes(vtkInformationVector* outputs)
{
  vtkAHDRankUpdates::ShareTimes(this->Triangulation->GetController(), this, outputs);
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
  vtkAHDRanks ranks(this->Triangulation->GetController());
  std::unique_ptr<RankWork> work;
  ++this->NumberOfTriangulations;
  ahd::Status status = ranks.Execute(
    [&]
    {
      work = std::make_unique<RankWork>(this, this->Triangulation->GetNumberOfThreads());
      this->ReadSettings(work->Settings, work->Wishes);
      this->Triangulation->GetSettingsOfRanks(work->Settings.OfRanks);
      this->GetSettingsOfRanks(work->Wishes.OfRanks);
      work->Take(this, vtkDataObject::GetData(inputs[0]), vtkDataObject::GetData(inputs[2]));
      work->TakePlaces(vtkDataObject::GetData(inputs[1]));
      work->ReadRequest(info);
    });
  if (status != ahd::Status::Ok)
  {
    return this->EndOnRanks(output);
  }
  vtkAHDRankSampling execution(this, work->Settings, work->Wishes, ranks, work->Context);
  const bool isDone = execution.Run(work->Given, output);
  this->MemoryEstimate = execution.GetEstimate();
  this->MustDescribeAnew = execution.IsOtherRaster();
#if AHD_VTK_HAS_CHECK_ABORT
  if (execution.IsAborted())
  {
    this->SetAbortOutput(true); // so that all execute anew, as the one that was told to abort does
  }
#endif
  bool fitAll = true;
  status = ranks.Execute(
    [&]
    {
      if (isDone)
      {
        this->AddMeasures(execution.GetResult().Counts);
        this->SampleSeconds = execution.GetSeconds();
        AddCounts(execution.GetResult().Counts, vtkDataSet::SafeDownCast(output)->GetFieldData());
      }
      const bool isRaster = inputs[1]->GetNumberOfInformationObjects() == 0;
      fitAll = !ranks.IsAny(
        isRaster && vtkAHDHasFiltersBehind(info) && !vtkAHDHasAllThatIsWanted(output, info));
    });
  if (status != ahd::Status::Ok)
  {
    return this->EndOnRanks(output);
  }
  return fitAll ? 1 : this->EndWithOtherRaster(isDone, output);
}

/// Where memory ran out on a rank elsewhere than in steps that say more of it: the same on all.
int vtkAdaptiveHilbertInterpolation2D::EndOnRanks(vtkDataObject* output)
{
  output->Initialize();
  this->ClearCounts();
  this->SayOutOfMemory();
  return 1;
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

void vtkAdaptiveHilbertInterpolation2D::UpdatePieces() {}
vtkAHDRaster vtkAdaptiveHilbertInterpolation2D::FindRasterOnRanks(vtkAHDRanks&, vtkInformation*)
{
  return vtkAHDRaster();
}
int vtkAdaptiveHilbertInterpolation2D::ComputePipelineMTime(vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs, int requestFromOutputPort,
  vtkMTimeType* mtime)
{
  return this->Superclass::ComputePipelineMTime(
    request, inputs, outputs, requestFromOutputPort, mtime);
}
void vtkAdaptiveHilbertInterpolation2D::ShareTimes(vtkInformationVector*) {}
void vtkAdaptiveHilbertInterpolation2D::DescribeOnRanks(vtkInformation*, bool) {}
void vtkAdaptiveHilbertInterpolation2D::AskForPieces(vtkInformationVector**) {}
int vtkAdaptiveHilbertInterpolation2D::ExecuteOnRanks(
  vtkInformationVector**, vtkInformation*, vtkDataObject*)
{
  return 1;
}
int vtkAdaptiveHilbertInterpolation2D::EndOnRanks(vtkDataObject*)
{
  return 1;
}
void vtkAdaptiveHilbertInterpolation2D::WarnAboutRanks() {}

#endif
