// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertQualityMesh2D.h"

#include "Engine/Core/FloatingPoint.h"
#include "Engine/Core/Threads.h"
#include "Execution/vtkAHDMergedBlocks.h"
#include "Execution/vtkAHDRefineExecution.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDPieces.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSay.h"
#include "Pipeline/vtkAHDThreads.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "vtkMultiProcessController.h"
#endif

#include <algorithm>
#include <array>
#include <new>

vtkStandardNewMacro(vtkAdaptiveHilbertQualityMesh2D);
vtkCxxSetObjectMacro(vtkAdaptiveHilbertQualityMesh2D, Triangulation, vtkAdaptiveHilbertDelaunay2D);

vtkAdaptiveHilbertQualityMesh2D::vtkAdaptiveHilbertQualityMesh2D()
  : Triangulation(vtkAdaptiveHilbertDelaunay2D::New())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkAdaptiveHilbertQualityMesh2D::~vtkAdaptiveHilbertQualityMesh2D()
{
  this->SetTriangulation(nullptr);
}

void vtkAdaptiveHilbertQualityMesh2D::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(1, source);
}

void vtkAdaptiveHilbertQualityMesh2D::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

vtkPolyData* vtkAdaptiveHilbertQualityMesh2D::GetSource()
{
  return this->GetNumberOfInputConnections(1) > 0
    ? vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0))
    : nullptr;
}

vtkMTimeType vtkAdaptiveHilbertQualityMesh2D::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Triangulation ? std::max(own, this->Triangulation->GetMTime()) : own;
}

/// The first type decides: with it the filter is not run for each block.
int vtkAdaptiveHilbertQualityMesh2D::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable"); // to say what to do with it
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

/// In one process all is needed whatever piece of the output is wanted.
int vtkAdaptiveHilbertQualityMesh2D::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  if (vtkAHDIsOnlyProcess(this->Triangulation ? this->Triangulation->GetController() : nullptr))
  {
    vtkAHDAskForAll(inputs[0]);
    vtkAHDAskForAll(inputs[1]);
  }
  return result;
}

int vtkAdaptiveHilbertQualityMesh2D::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const ahd::ScopedFloatingPoint asTheEngine;
  const bool isAlone = vtkAHDIsOnlyProcess(
    this->Triangulation ? this->Triangulation->GetController() : nullptr);
  std::array<vtkSmartPointer<vtkPolyData>, 2> outputs; // observers may replace them
  std::array<bool, 2> isWanted;                        // the first piece has all
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    vtkInformation* const info = outputVector->GetInformationObject(static_cast<int>(k));
    outputs[k] = vtkPolyData::GetData(info);
    isWanted[k] = !isAlone || !vtkAHDIsLaterPiece(info);
  }
  // Errors return 1 as well, as they were told: see vtkAdaptiveHilbertDelaunay2D.
  this->ClearMeasures();
  bool isDone = false;
  try
  {
    isDone = (isWanted[0] || isWanted[1]) && this->Execute(inputVector, outputs);
  }
  catch (const std::bad_alloc&)
  {
    this->ClearMeasures();
    vtkAHDSayOutOfMemory("vtkAdaptiveHilbertQualityMesh2D",
      [this] { vtkErrorMacro("Out of memory. The output is empty."); });
  }
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    if (!isDone || !isWanted[k])
    {
      outputs[k]->Initialize();
    }
  }
  return 1;
}

/// Observers have the outputs, too: all is made in others, and handed on in the end.
bool vtkAdaptiveHilbertQualityMesh2D::Execute(vtkInformationVector** inputs, const Outputs& outputs)
{
  const vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> triangulation = this->Triangulation;
  if (!triangulation)
  {
    vtkAHDSay(this, ahd::Topic::Refusal, { { "triangulation_is_null", true } });
    return false;
  }
  if (!this->MayRefine(triangulation))
  {
    return false;
  }
  vtkAHDProgress progress(this);
  ahd::Threads threads(vtkAHDThreadsToUse(triangulation->GetNumberOfThreads()));
  vtkAHDOutputMemory notKept;
  const vtkAHDContext context(progress, threads, notKept);
  vtkAHDSettings settings;
  triangulation->ReadSettings(settings, true);
  vtkAHDRefineWishes wishes;
  wishes.SizeArrayName = this->SizeArrayName;
  wishes.Request.minimumAngle = this->MinimumAngle;
  wishes.Request.maximumArea = this->MaximumArea;
  wishes.Request.maximumLength = this->MaximumLength;
  if (this->MaximumNumberOfAddedPoints >= 0)
  {
    wishes.Request.mostSteinerPoints = static_cast<std::size_t>(this->MaximumNumberOfAddedPoints);
  }
  const vtkAHDMergedBlocks merged(
    this, settings, vtkDataObject::GetData(inputs[0]), vtkDataObject::GetData(inputs[1]), context);
  merged.Warn();
  std::array<vtkNew<vtkPolyData>, 2> made;
  for (std::size_t k = 0; k < made.size(); ++k)
  {
    made[k]->GetFieldData()->ShallowCopy(outputs[k]->GetFieldData());
  }
  vtkAHDRefineExecution execution(this, settings, wishes, context);
  const bool isDone = merged.GetInput() && execution.Run(merged, made[0], made[1]);
  this->MemoryEstimate = execution.GetMemoryEstimate();
  if (isDone)
  {
    const ahd::Refinement& found = execution.GetFound().found;
    this->NumberOfTriangles = made[0]->GetNumberOfPolys();
    this->NumberOfAddedPoints = static_cast<vtkIdType>(found.points.size());
    this->NumberOfPointsAddedToSegments = static_cast<vtkIdType>(found.onSegments);
    this->NumberOfBadTriangles = static_cast<vtkIdType>(found.bad.size());
    this->NumberOfEncroachedPieces = static_cast<vtkIdType>(found.encroachedPieces);
    this->LeastAngle = execution.GetLeastAngle();
    this->AddCounts(made[0]->GetFieldData());
    outputs[0]->ShallowCopy(made[0]);
    outputs[1]->ShallowCopy(made[1]);
  }
  return isDone;
}

/// Says what is to say of several ranks. False: their points would have to be one mesh.
bool vtkAdaptiveHilbertQualityMesh2D::MayRefine(vtkAdaptiveHilbertDelaunay2D* triangulation)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  const auto countOf = [](vtkMultiProcessController* ranks)
  { return ranks ? ranks->GetNumberOfProcesses() : 1; };
  vtkMultiProcessController* const all = vtkMultiProcessController::GetGlobalController();
  const int together = countOf(triangulation->GetController());
  if (triangulation->GetDistributePoints() && together > 1)
  {
    vtkAHDSay(this, ahd::Topic::Refusal, { { "mesh_ranks", together } });
    return false;
  }
  if (countOf(all) > 1 && !this->WarnedAboutRanks && all->GetLocalProcessId() == 0)
  {
    this->WarnedAboutRanks = true;
    vtkAHDSay(this, ahd::Topic::Blocks, { { "mesh_ranks", countOf(all) } });
  }
#else
  static_cast<void>(triangulation);
#endif
  return true;
}

void vtkAdaptiveHilbertQualityMesh2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Triangulation: " << this->Triangulation << "\n";
}
