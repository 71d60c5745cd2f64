// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAdaptiveHilbertDelaunay2D does where there are several ranks.
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Execution/vtkAHDMessages.h"
#include "Execution/vtkAHDOutputCache.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "Ranks/vtkAHDRankExecution.h"
#include "vtkMultiProcessController.h"
#endif

#include <new>
#include <string>

void vtkAdaptiveHilbertDelaunay2D::SetDistributePoints(bool distribute)
{
  if (this->DistributePoints != distribute)
  {
    this->DistributePoints = distribute;
    this->GetInputPortInformation(0)->Remove(vtkAlgorithm::PORT_REQUIREMENTS_FILLED());
    this->Modified();
  }
}

void vtkAdaptiveHilbertDelaunay2D::SetController(vtkMultiProcessController* controller)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  if (this->Controller != controller)
  {
    vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
    this->GetInputPortInformation(0)->Remove(vtkAlgorithm::PORT_REQUIREMENTS_FILLED());
  }
#else
  static_cast<void>(controller);
#endif
}

vtkMultiProcessController* vtkAdaptiveHilbertDelaunay2D::GetController()
{
  return this->Controller;
}

/// Are there other ranks to triangulate with?
bool vtkAdaptiveHilbertDelaunay2D::IsDistributed() const
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  return this->DistributePoints && this->Controller && this->Controller->GetNumberOfProcesses() > 1;
#else
  return false;
#endif
}

/// Across ranks, points of others would come twice with ghost levels.
int vtkAdaptiveHilbertDelaunay2D::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  for (int port = 0; port < 2 && this->IsDistributed(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      inputs[port]->GetInformationObject(i)->Set(
        vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return result;
}

/// Execute() over ranks. None leaves before all have agreed on it.
void vtkAdaptiveHilbertDelaunay2D::ExecuteOnRanks(
  vtkDataObject* input, vtkDataObject* source, vtkAHDDataSets& data, const vtkAHDContext& context)
{
  vtkAHDSettings settings;
  this->ReadSettings(settings);
  this->Cache->Forget();
  this->ClearMeasures();
  const bool hasBlocks = vtkCompositeDataSet::SafeDownCast(input) != nullptr;
  settings.SeparateBlocks = hasBlocks && !this->MergeBlocks;
  settings.GhostLevels = this->GetOutputInformation(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  const bool hasPoints = hasBlocks || vtkPointSet::SafeDownCast(input);
  if (input && !hasPoints)
  {
    vtkWarningMacro("A " << input->GetClassName()
                         << " has no points of its own: nothing was triangulated for it.");
  }
  vtkNew<vtkPolyData> nothing;
  std::unique_ptr<vtkAHDMergedBlocks> merged;
  try
  {
    merged.reset(
      new vtkAHDMergedBlocks(this, settings, hasPoints ? input : nothing.Get(), source, context));
    data.Input = merged->GetInput();
    data.Source = merged->GetSource();
    data.InputBytes = merged->GetBytes();
    merged->Warn();
  }
  catch (const std::bad_alloc&)
  {
    data.Input = nullptr;
  }
  this->TriangulateOnRanks(data, context, settings, data.Input == nullptr);
}

/// `hasFailed`: this rank has no input, as it could not be merged.
void vtkAdaptiveHilbertDelaunay2D::TriangulateOnRanks(vtkAHDDataSets& data,
  const vtkAHDContext& context, const vtkAHDSettings& settings, bool hasFailed)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  ++this->NumberOfTriangulations;
  vtkAHDRanks ranks(this->Controller);
  vtkAHDRankExecution execution(settings, ranks, context);
  const ahd::Status reason = context.IsAborted() ? ahd::Status::Cancelled
                                                 : ahd::Status::OutOfMemory;
  const vtkAHDReport report = execution.Run(data, hasFailed ? reason : ahd::Status::Ok);
  const vtkAHDRankExecution::Words& words = execution.GetWords();
  this->MemoryEstimate = report.Estimate;
  if (report.Status != ahd::Status::Ok)
  {
    if (!words.Error.empty())
    {
      vtkErrorMacro(<< words.Error);
    }
    else
    {
      vtkAHDSayError(this, settings, report);
    }
    return;
  }
  this->TakeMeasures(report);
  this->AddCounts(data.Outputs[0]);
  if (ranks.GetOwn() == 0)
  {
    vtkAHDSayWarnings(this, settings, report);
    for (const std::string& warning : words.Warnings)
    {
      vtkWarningMacro(<< warning);
    }
  }
#else
  static_cast<void>(data);
  static_cast<void>(context);
  static_cast<void>(settings);
  static_cast<void>(hasFailed);
#endif
}

void vtkAdaptiveHilbertDelaunay2D::WarnAboutRanks()
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  if (!this->WarnedAboutRanks && ranks && ranks->GetNumberOfProcesses() > 1 &&
    ranks->GetLocalProcessId() == 0)
  {
    this->WarnedAboutRanks = true;
    vtkWarningMacro("There are " << ranks->GetNumberOfProcesses()
                                 << " ranks, and each triangulates its own points only: the "
                                    "surfaces of the ranks do not join. DistributePoints "
                                    "triangulates the points of all together.");
  }
#endif
}
