// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertAlgorithm.h"

#include "Execution/vtkAHDReport.h"
#include "Pipeline/vtkAHDSettings.h"

vtkAdaptiveHilbertAlgorithm::vtkAdaptiveHilbertAlgorithm() = default;
vtkAdaptiveHilbertAlgorithm::~vtkAdaptiveHilbertAlgorithm() = default;

void vtkAdaptiveHilbertAlgorithm::ReadSettings(vtkAHDSettings& settings) const
{
  ahd::Options& options = settings.Insertion;
  options.order = static_cast<ahd::InsertionOrder>(this->InsertionOrder);
  options.controlPoints = static_cast<ahd::ControlPoints>(this->ControlPoints);
  options.geneRotation = this->GeneRotation;
  options.nmax = this->Nmax;
  options.countWork = this->CountWork;
  options.insertionLimit = static_cast<std::size_t>(this->InsertionLimit);
  options.keepBoxes = this->GenerateBoxes;
  options.keepOrder = this->GenerateInsertionRank || this->GenerateInsertionCurve;
  settings.GeneratePointStatus = this->GeneratePointStatus;
  settings.GenerateInsertionRank = this->GenerateInsertionRank;
  settings.GenerateInsertionCurve = this->GenerateInsertionCurve;
  settings.GenerateConstraintEdges = this->GenerateConstraintEdges;
  settings.GenerateRegionIds = this->GenerateRegionIds;
  settings.GenerateNeighbors = this->GenerateNeighbors;
  settings.MemoryLimit = this->MemoryLimit;
  settings.ReuseLimit = this->ReuseLimit;
}

void vtkAdaptiveHilbertAlgorithm::TakeMeasures(const vtkAHDReport& report)
{
  using Phase = ahd::Phase;
  this->NumberOfPointsInserted = static_cast<vtkIdType>(report.Counts.inserted);
  this->NumberOfDuplicates = static_cast<vtkIdType>(report.Counts.duplicates);
  this->NumberOfRejectedPoints = static_cast<vtkIdType>(report.Counts.notFinite);
  this->NumberOfSkippedPoints = static_cast<vtkIdType>(report.Counts.skipped - report.MergedPoints);
  this->NumberOfPointsBeyondLimit = static_cast<vtkIdType>(report.Counts.beyondLimit);
  this->NumberOfTriangles = static_cast<vtkIdType>(report.Triangles);
  this->NP = this->CountWork ? report.Counts.np() : -1.0;
  this->NR = this->CountWork ? report.Counts.nr() : -1.0;
  this->SortSeconds = report.SecondsOf(Phase::Merge, Phase::Read, Phase::Sort);
  this->InsertSeconds = report.SecondsOf(Phase::Insert);
  this->OutputSeconds = report.SecondsOf(Phase::Extract, Phase::Outputs);
  this->NumberOfThreadsUsed = report.ThreadsUsed;
}

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
