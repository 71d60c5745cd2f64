// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkAHDExecutor.h"
#include "vtkAHDPlane.h"
#include "vtkAHDProgress.h"
#include "vtkAHDRun.h"
#include "vtkAHDWorkingPoints.h"

#include "vtkAbstractTransform.h"
#include "vtkDataObject.h"
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
#include <new>

vtkStandardNewMacro(vtkAdaptiveHilbertDelaunay2D);
vtkCxxSetObjectMacro(vtkAdaptiveHilbertDelaunay2D, Transform, vtkAbstractTransform);

vtkAdaptiveHilbertDelaunay2D::vtkAdaptiveHilbertDelaunay2D()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkAdaptiveHilbertDelaunay2D::~vtkAdaptiveHilbertDelaunay2D()
{
  this->SetTransform(nullptr);
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
  vtkNew<vtkAlgorithm> nobody; // who could abort
  vtkAHDProgress progress(nobody);
  vtkAHDExecutor executor(vtkAHDThreadsToUse(0));
  vtkAHDWorkingPoints points(input);
  vtkAHDPlane plane;
  try
  {
    points.Open(executor, progress);
    plane.Fit(points.View(), executor, progress);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkTransform> transform = plane.MakeTransform();
  transform->Register(nullptr);
  return transform;
}

vtkMTimeType vtkAdaptiveHilbertDelaunay2D::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Transform ? std::max(own, this->Transform->GetMTime()) : own;
}

int vtkAdaptiveHilbertDelaunay2D::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ClearMeasures();
  this->WarnAboutRanks();

  vtkDataObject* data = vtkDataObject::GetData(inputVector[0]);
  vtkPointSet* input = vtkPointSet::SafeDownCast(data);
  if (!input)
  {
    // A block of a composite data set: their types are not looked at by the pipeline.
    vtkWarningMacro("A " << (data ? data->GetClassName() : "missing block")
                         << " has no points of its own: nothing was triangulated for it.");
    return 1;
  }
  // Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more, run
  // this filter again with every Update(), and keep the filters behind it at their last output.
  vtkAHDRun run(this, input, vtkPolyData::GetData(inputVector[1]), outputVector);
  if (!run.FitsInMemory())
  {
    return 1;
  }
  const ahd::Status status = run.Triangulate();
  if (status != ahd::Status::Ok)
  {
    run.Fail(status);
    return 1;
  }
  run.KeepMeasures();
  run.Warn();
  return 1;
}

int vtkAdaptiveHilbertDelaunay2D::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkAdaptiveHilbertDelaunay2D::ClearMeasures()
{
  this->Superclass::ClearMeasures();
  this->NumberOfMergedPoints = 0;
  this->NumberOfAddedPoints = 0;
  this->NumberOfConstraintEdges = 0;
  this->NumberOfCrossings = 0;
  this->NumberOfConstraintsLeftOut = 0;
  this->NumberOfUnfilledLoops = 0;
  this->ConstrainSeconds = 0.0;
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
                                    "surfaces of the ranks do not join.");
  }
#endif
}

void vtkAdaptiveHilbertDelaunay2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceMode: " << this->SourceMode << "\n";
  os << indent << "CrossingMode: " << this->CrossingMode << "\n";
  os << indent << "FillRule: " << this->FillRule << "\n";
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "AlphaTris: " << (this->AlphaTris ? "On\n" : "Off\n");
  os << indent << "AlphaLines: " << (this->AlphaLines ? "On\n" : "Off\n");
  os << indent << "AlphaVerts: " << (this->AlphaVerts ? "On\n" : "Off\n");
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "ProjectionPlaneMode: " << this->ProjectionPlaneMode << "\n";
  os << indent << "Transform: " << this->Transform << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "DuplicatePolicy: " << this->DuplicatePolicy << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "BoundingTriangulation: " << (this->BoundingTriangulation ? "On\n" : "Off\n");
  os << indent << "GenerateFate: " << (this->GenerateFate ? "On\n" : "Off\n");
  os << indent << "GenerateConstraintEdges: " << (this->GenerateConstraintEdges ? "On\n" : "Off\n");
  os << indent << "GenerateRegionIds: " << (this->GenerateRegionIds ? "On\n" : "Off\n");
  os << indent << "GenerateNeighbors: " << (this->GenerateNeighbors ? "On\n" : "Off\n");
  os << indent << "GenerateVoronoi: " << (this->GenerateVoronoi ? "On\n" : "Off\n");
  os << indent << "VoronoiClip: " << this->VoronoiClip << "\n";
  os << indent << "NumberOfMergedPoints: " << this->NumberOfMergedPoints << "\n";
  os << indent << "NumberOfAddedPoints: " << this->NumberOfAddedPoints << "\n";
  os << indent << "NumberOfConstraintEdges: " << this->NumberOfConstraintEdges << "\n";
  os << indent << "NumberOfCrossings: " << this->NumberOfCrossings << "\n";
  os << indent << "NumberOfConstraintsLeftOut: " << this->NumberOfConstraintsLeftOut << "\n";
  os << indent << "NumberOfUnfilledLoops: " << this->NumberOfUnfilledLoops << "\n";
  os << indent << "ConstrainSeconds: " << this->ConstrainSeconds << "\n";
}
