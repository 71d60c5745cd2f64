// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAdaptiveHilbertDelaunay2D does where there are several ranks.
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDKeptTriangulation.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Execution/vtkAHDMessages.h"
#include "Execution/vtkAHDOutputCache.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDPieces.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Pipeline/vtkAHDThreads.h"

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

#include <new>
#include <string>
#include <vector>

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

/// Across ranks, points of others would come twice with ghost levels. In one process all is needed
/// whatever piece of the output is wanted: surfaces of pieces do not join.
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
  for (int port = 0; port < 2 && vtkAHDIsOnlyProcess(this->Controller); ++port)
  {
    vtkAHDAskForAll(inputs[port]);
  }
  return result;
}

/// In one process the first piece of an output has all of it, and the others nothing. Is there
/// nothing to be made, as others than the first are wanted?
bool vtkAdaptiveHilbertDelaunay2D::IsEmptyPiece(vtkInformationVector* outputs) const
{
  const bool isMade[] = { true, this->GenerateInsertionCurve || this->GenerateBoxes,
    this->GenerateVoronoi };
  bool isEmpty = vtkAHDIsOnlyProcess(this->Controller);
  for (int port = 0; port < 3; ++port)
  {
    isEmpty = isEmpty && (!isMade[port] || vtkAHDIsLaterPiece(outputs->GetInformationObject(port)));
  }
  return isEmpty;
}

/// Empties those outputs of which another piece than the first is wanted.
void vtkAdaptiveHilbertDelaunay2D::KeepFirstPieces(vtkInformationVector* outputs) const
{
  for (int port = 0; port < 3 && vtkAHDIsOnlyProcess(this->Controller); ++port)
  {
    vtkInformation* const info = outputs->GetInformationObject(port);
    if (vtkAHDIsLaterPiece(info))
    {
      vtkDataObject::GetData(info)->Initialize();
    }
  }
}

/// What ports take and give is asked for anew when it is needed next.
void vtkAdaptiveHilbertDelaunay2D::DescribePortsAnew()
{
  this->GetInputPortInformation(0)->Remove(vtkAlgorithm::PORT_REQUIREMENTS_FILLED());
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    this->GetOutputPortInformation(port)->Remove(vtkAlgorithm::PORT_REQUIREMENTS_FILLED());
  }
}

int vtkAdaptiveHilbertDelaunay2D::FillOutputPortInformation(int port, vtkInformation* info)
{
  const int result = this->Superclass::FillOutputPortInformation(port, info);
  if (this->IsDistributed() && !this->MergeBlocks)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // as MakeOutputs() makes them
  }
  return result;
}

vtkTypeBool vtkAdaptiveHilbertDelaunay2D::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->IsDistributed() && request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    this->MakeOutputs(vtkDataObject::GetData(inputs[0]), outputs);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

/// Outputs of the type of the input, if that has blocks to be triangulated each by itself. Where
/// there is no input, others may have blocks: outputs stay what they were.
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
void vtkAdaptiveHilbertDelaunay2D::ExecuteOnRanks(vtkDataObject* input, vtkDataObject* source,
  vtkInformationVector* outputs, const vtkAHDContext& context)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  this->Cache->Forget();
  this->ClearMeasures();
  vtkAHDRanks ranks(this->Controller);
  std::unique_ptr<vtkAHDRankBlocks> blocks;
  try
  {
    blocks.reset(new vtkAHDRankBlocks(ranks, context, input, this->MergeBlocks));
  }
  catch (const vtkAHDStop& stop)
  {
    vtkAHDReport report;
    report.Status = stop.Reason;
    this->SayAbort(stop.Reason);
    vtkAHDSayError(this, report);
    return;
  }
  if (!blocks->GetDifference().empty())
  {
    vtkErrorMacro(<< blocks->GetDifference()
                  << ". Where MergeBlocks is off, block by block is triangulated over all ranks, "
                     "and each has to have the same ones, but for those that it lacks. Nothing was "
                     "computed. Switch MergeBlocks on for one surface of all, or DistributePoints "
                     "off: each rank then triangulates its own.");
    return;
  }
  if (blocks->HaveBlocks())
  {
    this->WarnOfInput(input);
    this->ExecuteBlocksOnRanks(*blocks, source, outputs);
    return;
  }
  vtkAHDDataSets data;
  for (std::size_t port = 0; port < data.Outputs.size(); ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(static_cast<int>(port));
    if (!vtkPolyData::GetData(info)) // it had blocks before
    {
      info->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
    }
    data.Outputs[port] = vtkPolyData::GetData(info);
  }
  this->ExecuteOneOnRanks(input, source, data);
#else
  static_cast<void>(input);
  static_cast<void>(source);
  static_cast<void>(outputs);
  static_cast<void>(context);
#endif
}

/// Each block of all ranks by itself, in their order. The measures are those of the last.
void vtkAdaptiveHilbertDelaunay2D::ExecuteBlocksOnRanks(
  const vtkAHDRankBlocks& blocks, vtkDataObject* source, vtkInformationVector* outputs)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  std::vector<vtkSmartPointer<vtkDataObject>> made;
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    made.push_back(blocks.MakeOutput());
  }
  for (std::size_t k = 0; k < blocks.GetCount(); ++k)
  {
    vtkDataObject* block = blocks.GetBlock(k);
    vtkAHDDataSets data;
    std::vector<vtkSmartPointer<vtkPolyData>> parts;
    for (std::size_t port = 0; port < made.size(); ++port)
    {
      parts.push_back(vtkSmartPointer<vtkPolyData>::New());
      data.Outputs[port] = parts[port];
      if (block)
      {
        parts[port]->GetFieldData()->PassData(block->GetFieldData()); // as the pipeline does
      }
    }
    this->ClearMeasures();
    this->ExecuteOneOnRanks(block, source, data);
    for (std::size_t port = 0; port < made.size(); ++port)
    {
      blocks.SetBlock(k, made[port], parts[port]);
    }
  }
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
#else
  static_cast<void>(blocks);
  static_cast<void>(source);
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
    vtkWarningMacro("A " << input->GetClassName()
                         << " has no points of its own: nothing was triangulated for it.");
  }
  return hasPoints;
}

/// `input` may be null, or nothing that has points.
void vtkAdaptiveHilbertDelaunay2D::ExecuteOneOnRanks(
  vtkDataObject* input, vtkDataObject* source, vtkAHDDataSets& data)
{
  vtkAHDSettings settings;
  this->ReadSettings(settings);
  settings.GhostLevels = this->GetOutputInformation(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  vtkAHDProgress progress(this);
  ahd::Threads threads(vtkAHDThreadsToUse(this->NumberOfThreads));
  const vtkAHDContext context(progress, threads, *this->OutputMemory);
  const bool hasPoints = this->WarnOfInput(input);
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
  ahd::Status before = ahd::Status::Ok;
  if (!data.Input)
  {
    before = context.IsAborted()        ? ahd::Status::Cancelled
      : merged && merged->AreCellsBad() ? ahd::Status::BadCells
                                        : ahd::Status::OutOfMemory;
  }
  this->TriangulateOnRanks(data, context, settings, before);
}

/// `before`: why this rank has no input; Ok if it has.
void vtkAdaptiveHilbertDelaunay2D::TriangulateOnRanks(vtkAHDDataSets& data,
  const vtkAHDContext& context, const vtkAHDSettings& settings, ahd::Status before)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  ++this->NumberOfTriangulations;
  this->Left->TakeBack(*this->Workspace);
  vtkAHDRanks ranks(this->Controller);
  vtkAHDRankExecution execution(settings, ranks, context);
  const vtkAHDReport report = execution.Run(data, before, *this->Workspace);
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
      this->SayAbort(report.Status);
      vtkAHDSayError(this, report);
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
    if (!words.OneRank.empty() && !this->WarnedAboutOneRank)
    {
      this->WarnedAboutOneRank = true; // once, as some move such a setting step by step
      vtkWarningMacro(<< words.OneRank);
    }
  }
#else
  static_cast<void>(data);
  static_cast<void>(context);
  static_cast<void>(settings);
  static_cast<void>(before);
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
