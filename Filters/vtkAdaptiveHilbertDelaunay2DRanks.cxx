// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAdaptiveHilbertDelaunay2D does where there are several ranks.
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDLentTriangulation.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Execution/vtkAHDMessages.h"
#include "Execution/vtkAHDOutputCache.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSay.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Pipeline/vtkAHDThreads.h"
#include "Ranks/vtkAHDRankUpdates.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "Ranks/vtkAHDRankBlocks.h"
#include "Ranks/vtkAHDRankExecution.h"
#include "vtkMultiProcessController.h"
#endif

#include <array>
#include <memory>
#include <string>
#include <vector>

#if VTK_MODULE_ENABLE_VTK_ParallelCore
namespace
{
/// The output surfaces if there are no blocks, though there may have been some before.
void MakeSurfaces(
  vtkInformationVector* outputs, std::array<vtkSmartPointer<vtkPolyData>, 3>& surfaces)
{
  for (std::size_t port = 0; port < surfaces.size(); ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(static_cast<int>(port));
    if (!vtkPolyData::GetData(info))
    {
      info->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
    }
    surfaces[port] = vtkPolyData::GetData(info);
  }
}

/// Blocks, one data object for each port.
void PutOut(const std::vector<vtkSmartPointer<vtkDataObject>>& made, vtkInformationVector* outputs)
{
  for (std::size_t port = 0; port < made.size(); ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(static_cast<int>(port));
    vtkDataObject* now = vtkDataObject::GetData(info);
    if (now && std::string(now->GetClassName()) == made[port]->GetClassName())
    {
      now->ShallowCopy(made[port]);
    }
    else
    {
      info->Set(vtkDataObject::DATA_OBJECT(), made[port]);
    }
  }
}

/// That there are so many on each rank, whatever was asked of it: so ranks that are asked for the
/// same next have to execute, or have not, alike.
void SetGhostLevels(vtkInformationVector* outputs, int levels)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* data = vtkDataObject::GetData(outputs, port))
    {
      data->GetInformation()->Set(vtkDataObject::DATA_NUMBER_OF_GHOST_LEVELS(), levels);
    }
  }
}
}
#endif

void vtkAdaptiveHilbertDelaunay2D::SetDistributePoints(bool distribute)
{
  if (this->DistributePoints != distribute)
  {
    this->DistributePoints = distribute;
    this->DescribePortsAnew();
    this->Modified();
  }
}

void vtkAdaptiveHilbertDelaunay2D::SetController(vtkMultiProcessController* controller)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  if (this->Controller != controller)
  {
    vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
    this->DescribePortsAnew();
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

/// Outputs of the type of the input, if that has blocks to be triangulated each by itself. Where
/// there is no input, others may have blocks: outputs stay unchanged.
void vtkAdaptiveHilbertDelaunay2D::MakeOutputs(
  vtkDataObject* input, vtkInformationVector* outputs) const
{
  auto* blocks = this->MergeBlocks ? nullptr : vtkDataObjectTree::SafeDownCast(input);
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* now = vtkDataObject::GetData(outputs, port);
    const char* const name = blocks ? blocks->GetClassName() : "vtkPolyData";
    const bool fits = now && (!input || std::string(now->GetClassName()) == name);
    vtkSmartPointer<vtkDataObject> made = now;
    if (!fits)
    {
      made = vtkSmartPointer<vtkDataObject>::Take(
        blocks ? blocks->NewInstance() : static_cast<vtkDataObject*>(vtkPolyData::New()));
      outputs->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), made);
    }
  }
}

/// Execute() over ranks. None leaves before all have agreed on it.
void vtkAdaptiveHilbertDelaunay2D::ExecuteOnRanks(
  vtkDataObject* input, vtkDataObject* source, vtkInformationVector* outputs)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  this->Cache->Forget();
  this->ClearMeasures();
  vtkAHDRanks ranks(this->Controller);
  std::unique_ptr<vtkAHDRankBlocks> blocks;
  vtkAHDRankResult result;
  RankSurfaces surfaces;
  const vtkSmartPointer<vtkDataObject> held[] = { input, source }; // observers may let go of them
  int levels = this->GetOutputInformation(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  const ahd::Status status = ranks.Execute(
    [&]
    {
      vtkAHDProgress progress(this);
      ahd::Threads threads(1);
      const vtkAHDContext context(progress, threads, *this->OutputMemory);
      levels = ranks.FindMost(levels);
      blocks = std::make_unique<vtkAHDRankBlocks>(ranks, context, input, this->MergeBlocks);
      if (!blocks->HaveBlocks())
      {
        MakeSurfaces(outputs, surfaces);
      }
    });
  if (status != ahd::Status::Ok)
  {
    this->EndOnRanks(status, result, surfaces);
  }
  else if (!blocks->GetDifference().empty())
  {
    vtkErrorMacro(
      << blocks->GetDifference()
      << ". With MergeBlocks off, each block is triangulated over all ranks by itself, so "
         "all ranks must have the same blocks, except missing ones. Nothing was "
         "computed. Switch MergeBlocks on for one surface of all blocks, or "
         "DistributePoints off: each rank then triangulates its own.");
  }
  else if (blocks->HaveBlocks())
  {
    this->ExecuteBlocksOnRanks(ranks, *blocks, source, levels, outputs);
  }
  else
  {
    this->ExecuteOneOnRanks(ranks, input, source, levels, surfaces);
  }
  SetGhostLevels(outputs, levels);
  this->Updates->Settle();
#else
  static_cast<void>(input);
  static_cast<void>(source);
  static_cast<void>(outputs);
#endif
}

/// Each block of all ranks by itself, in their order. The measures are those of the last.
void vtkAdaptiveHilbertDelaunay2D::ExecuteBlocksOnRanks(vtkAHDRanks& ranks,
  const vtkAHDRankBlocks& blocks, vtkDataObject* source, int levels, vtkInformationVector* outputs)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  std::vector<vtkSmartPointer<vtkDataObject>> made;
  std::vector<RankSurfaces> parts;
  vtkAHDRankResult result;
  ahd::Status status = ranks.Execute(
    [&]
    {
      this->WarnOfInput(blocks.GetInput());
      parts.resize(blocks.GetCount());
      for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
      {
        made.push_back(blocks.MakeOutput());
        for (std::size_t k = 0; k < parts.size(); ++k)
        {
          const auto part = vtkSmartPointer<vtkPolyData>::New();
          if (vtkDataObject* block = blocks.GetBlock(k))
          {
            part->GetFieldData()->PassData(block->GetFieldData()); // as the pipeline does
          }
          blocks.SetBlock(k, made.back(), part);
          parts[k][static_cast<std::size_t>(port)] = part;
        }
      }
    });
  for (std::size_t k = 0; k < parts.size() && status == ahd::Status::Ok; ++k)
  {
    this->ClearMeasures();
    this->ExecuteOneOnRanks(ranks, blocks.GetBlock(k), source, levels, parts[k]);
  }
  if (status == ahd::Status::Ok)
  {
    status = ranks.Execute([&] { PutOut(made, outputs); });
  }
  if (status != ahd::Status::Ok)
  {
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    {
      vtkDataObject::GetData(outputs, port)->Initialize(); // on some ranks all may be there
    }
    this->EndOnRanks(status, result, RankSurfaces());
  }
#else
  static_cast<void>(ranks);
  static_cast<void>(blocks);
  static_cast<void>(source);
  static_cast<void>(levels);
  static_cast<void>(outputs);
#endif
}

/// Returns whether it has points or blocks, and warns if it is something that has none.
bool vtkAdaptiveHilbertDelaunay2D::WarnOfInput(vtkDataObject* input)
{
  const bool hasPoints = vtkCompositeDataSet::SafeDownCast(input) ||
    vtkPointSet::SafeDownCast(input);
  if (input && !hasPoints)
  {
    vtkAHDSay(this, ahd::Topic::Blocks, { { "without_points", input->GetClassName() } });
  }
  return hasPoints;
}

/// `input` may be null, or nothing that has points. `levels`: of ghost cells, of all ranks.
void vtkAdaptiveHilbertDelaunay2D::ExecuteOneOnRanks(vtkAHDRanks& ranks, vtkDataObject* input,
  vtkDataObject* source, int levels, const RankSurfaces& surfaces)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  ++this->NumberOfTriangulations;
  vtkAHDRankResult result;
  const ahd::Status status = ranks.Execute(
    [&]
    {
      vtkAHDSettings settings;
      this->ReadSettings(settings);
      this->GetSettingsOfRanks(settings.OfRanks);
      settings.GhostLevels = levels;
      vtkAHDProgress progress(this);
      ahd::Threads threads(vtkAHDThreadsToUse(this->NumberOfThreads));
      const vtkAHDContext context(progress, threads, *this->OutputMemory);
      const bool hasPoints = this->WarnOfInput(input);
      vtkNew<vtkPolyData> nothing;
      const vtkAHDMergedBlocks merged(
        this, settings, hasPoints ? input : nothing.Get(), source, context);
      std::array<vtkNew<vtkPolyData>, 3> outputs; // handed on in the end, as observers have theirs
      vtkAHDDataSets own;
      own.Input = merged.GetInput();
      own.Source = merged.GetSource();
      own.InputBytes = merged.GetBytes();
      for (std::size_t k = 0; k < outputs.size(); ++k)
      {
        outputs[k]->GetFieldData()->ShallowCopy(surfaces[k]->GetFieldData());
        own.Outputs[k] = outputs[k];
      }
      merged.Warn();
      this->TakeBackLent();
      vtkAHDRankExecution(settings, ranks, context, result)
        .Run(own, merged.GetStatus(context), *this->Workspace);
      this->MemoryEstimate = result.Report.GetEstimate();
      this->TakeMeasures(result.Report);
      this->AddCounts(own.Outputs[0]->GetFieldData());
      for (std::size_t k = 0; k < outputs.size(); ++k)
      {
        surfaces[k]->ShallowCopy(outputs[k]);
      }
      if (ranks.GetOwn() == 0)
      {
        this->WarnOnRanks(settings, result);
      }
    });
  if (status != ahd::Status::Ok)
  {
    this->EndOnRanks(status, result, surfaces);
  }
#else
  static_cast<void>(ranks);
  static_cast<void>(input);
  static_cast<void>(source);
  static_cast<void>(levels);
  static_cast<void>(surfaces);
#endif
}

void vtkAdaptiveHilbertDelaunay2D::WarnOnRanks(
  const vtkAHDSettings& settings, const vtkAHDRankResult& result)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  this->Warn(settings, result.Report);
  for (const std::string& warning : result.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!result.OneRank.empty() && !this->WarnedAboutOneRank)
  {
    this->WarnedAboutOneRank = true; // once, as some move such a setting step by step
    vtkWarningMacro(<< result.OneRank);
  }
#else
  static_cast<void>(settings);
  static_cast<void>(result);
#endif
}

/// After a failure that all ranks know of: each reports it, with empty outputs.
void vtkAdaptiveHilbertDelaunay2D::EndOnRanks(
  ahd::Status status, vtkAHDRankResult& result, const RankSurfaces& surfaces)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  for (const auto& output : surfaces)
  {
    if (output)
    {
      output->Initialize();
    }
  }
  this->ClearMeasures();
  this->MemoryEstimate = result.Report.GetEstimate();
  result.Report.status = status;
  this->SayAbort(status);
  vtkAHDSayOutOfMemory("vtkAdaptiveHilbertDelaunay2D",
    [&]
    {
      if (result.Error.empty())
      {
        vtkAHDSayError(this, result.Report);
      }
      else
      {
        vtkErrorMacro(<< result.Error);
      }
    });
#else
  static_cast<void>(status);
  static_cast<void>(result);
  static_cast<void>(surfaces);
#endif
}

/// VTK executes a filter that was aborted anew, even if nothing has changed: so it has to know of
/// it on all ranks, as the one that was told to abort would wait for the others.
void vtkAdaptiveHilbertDelaunay2D::SayAbort(ahd::Status status)
{
#if AHD_VTK_HAS_CHECK_ABORT
  if (status == ahd::Status::Cancelled)
  {
    this->SetAbortOutput(true);
  }
#else
  static_cast<void>(status);
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
                                    "surfaces of the ranks do not join. "
                                 << (this->DistributePoints
                                        ? "DistributePoints has no effect without a Controller."
                                        : "DistributePoints triangulates the points of all "
                                          "together."));
  }
#endif
}
