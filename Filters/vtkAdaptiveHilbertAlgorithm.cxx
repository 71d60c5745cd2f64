// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertAlgorithm.h"

#include "Engine/Triangulate.h"

vtkAdaptiveHilbertAlgorithm::vtkAdaptiveHilbertAlgorithm()
  : Triangulator(new ahd::Triangulator)
{
}
vtkAdaptiveHilbertAlgorithm::~vtkAdaptiveHilbertAlgorithm() = default;

void vtkAdaptiveHilbertAlgorithm::ClearMeasures()
{
  this->NumberOfPointsInserted = 0;
  this->NumberOfDuplicates = 0;
  this->NumberOfRejectedPoints = 0;
  this->NumberOfSkippedPoints = 0;
  this->NumberOfPointsBeyondLimit = 0;
  this->NumberOfTriangles = 0;
  this->NP = -1.0;
  this->NR = -1.0;
  this->SortSeconds = 0.0;
  this->InsertSeconds = 0.0;
  this->OutputSeconds = 0.0;
  this->NumberOfThreadsUsed = 0;
  this->MemoryEstimate = 0;
}

void vtkAdaptiveHilbertAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InsertionOrder: " << this->InsertionOrder << "\n";
  os << indent << "Nmax: " << this->Nmax << "\n";
  os << indent << "ControlPoints: " << this->ControlPoints << "\n";
  os << indent << "GeneRotation: " << (this->GeneRotation ? "On\n" : "Off\n");
  os << indent << "RandomPointInsertion: " << (this->RandomPointInsertion ? "On\n" : "Off\n");
  os << indent << "UseHilbertSorter: " << (this->UseHilbertSorter ? "On\n" : "Off\n");
  os << indent << "CountWork: " << (this->CountWork ? "On\n" : "Off\n");
  os << indent << "InsertionLimit: " << this->InsertionLimit << "\n";
  os << indent << "GeneratePointStatus: " << (this->GeneratePointStatus ? "On\n" : "Off\n");
  os << indent << "GenerateConstraintEdges: " << (this->GenerateConstraintEdges ? "On\n" : "Off\n");
  os << indent << "GenerateRegionIds: " << (this->GenerateRegionIds ? "On\n" : "Off\n");
  os << indent << "GenerateNeighbors: " << (this->GenerateNeighbors ? "On\n" : "Off\n");
  os << indent << "GenerateInsertionRank: " << (this->GenerateInsertionRank ? "On\n" : "Off\n");
  os << indent << "GenerateInsertionCurve: " << (this->GenerateInsertionCurve ? "On\n" : "Off\n");
  os << indent << "GenerateBoxes: " << (this->GenerateBoxes ? "On\n" : "Off\n");
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "ReuseLimit: " << this->ReuseLimit << "\n";
  os << indent << "KeepTriangulation: " << (this->KeepTriangulation ? "On\n" : "Off\n");
  os << indent << "NumberOfPointsInserted: " << this->NumberOfPointsInserted << "\n";
  os << indent << "NumberOfDuplicates: " << this->NumberOfDuplicates << "\n";
  os << indent << "NumberOfRejectedPoints: " << this->NumberOfRejectedPoints << "\n";
  os << indent << "NumberOfSkippedPoints: " << this->NumberOfSkippedPoints << "\n";
  os << indent << "NumberOfPointsBeyondLimit: " << this->NumberOfPointsBeyondLimit << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "NP: " << this->NP << "\n";
  os << indent << "NR: " << this->NR << "\n";
  os << indent << "SortSeconds: " << this->SortSeconds << "\n";
  os << indent << "InsertSeconds: " << this->InsertSeconds << "\n";
  os << indent << "OutputSeconds: " << this->OutputSeconds << "\n";
  os << indent << "NumberOfThreadsUsed: " << this->NumberOfThreadsUsed << "\n";
  os << indent << "NumberOfTriangulations: " << this->NumberOfTriangulations << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << "\n";
}
