// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#include "vtkAdaptiveHilbertAlgorithm.h"

#include "Engine/Job/ReportRows.h"
#include "Engine/Job/Settings.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDMeasuresText.h"
#include "Pipeline/vtkAHDSetters.h"
#include "Pipeline/vtkAHDSettingsOfRanks.h"

#include <algorithm>
#include <array>
#include <utility>

vtkAdaptiveHilbertAlgorithm::vtkAdaptiveHilbertAlgorithm() = default;
vtkAdaptiveHilbertAlgorithm::~vtkAdaptiveHilbertAlgorithm() = default;

void vtkAdaptiveHilbertAlgorithm::SetMaximumSegmentLength(double value)
{
  vtkAHDSetClamped(this, this->MaximumSegmentLength, value, 0.0, VTK_DOUBLE_MAX);
}

void vtkAdaptiveHilbertAlgorithm::SetMaximumEdgeLength(double value)
{
  vtkAHDSetClamped(this, this->MaximumEdgeLength, value, 0.0, VTK_DOUBLE_MAX);
}

void vtkAdaptiveHilbertAlgorithm::SetAlpha(double value)
{
  vtkAHDSetClamped(this, this->Alpha, value, 0.0, VTK_DOUBLE_MAX);
}

void vtkAdaptiveHilbertAlgorithm::SetMaximumError(double value)
{
  vtkAHDSetClamped(this, this->MaximumError, value, 0.0, VTK_DOUBLE_MAX);
}

void vtkAdaptiveHilbertAlgorithm::SetValueArrayName(const std::string& name)
{
  vtkAHDSetAny(this, this->ValueArrayName, name);
}

void vtkAdaptiveHilbertAlgorithm::SetWeightArrayName(const std::string& name)
{
  vtkAHDSetAny(this, this->WeightArrayName, name);
}

void vtkAdaptiveHilbertAlgorithm::SetKeepArrayName(const std::string& name)
{
  vtkAHDSetAny(this, this->KeepArrayName, name);
}

void vtkAdaptiveHilbertAlgorithm::SetTolerance(double value)
{
  vtkAHDSetClamped(this, this->Tolerance, value, 0.0, 1.0);
}

void vtkAdaptiveHilbertAlgorithm::SetVoronoiPolygon(const std::string& name)
{
  vtkAHDSetAny(this, this->VoronoiPolygon, name);
}

void vtkAdaptiveHilbertAlgorithm::SetOffset(double value)
{
  vtkAHDSetClamped(this, this->Offset, value, 0.75, VTK_DOUBLE_MAX);
}

void vtkAdaptiveHilbertAlgorithm::ClearMeasures()
{
  this->NumberOfTriangles = 0;
  this->NumberOfPointsInserted = 0;
  this->NumberOfDuplicates = 0;
  this->NumberOfMergedPoints = 0;
  this->NumberOfAddedPoints = 0;
  this->NumberOfRejectedPoints = 0;
  this->NumberOfSkippedPoints = 0;
  this->NumberOfPointsBeyondLimit = 0;
  this->NumberOfPointsWithinError = 0;
  this->NumberOfConstraintEdges = 0;
  this->NumberOfCrossings = 0;
  this->NumberOfAddedLinePoints = 0;
  this->NumberOfBentConstraints = 0;
  this->NumberOfConstraintsLeftOut = 0;
  this->NumberOfUnfilledLoops = 0;
  this->NumberOfTrimmedTriangles = 0;
  this->LargestError = 0.0;
  this->NP = -1.0;
  this->NR = -1.0;
  this->SortSeconds = 0.0;
  this->InsertSeconds = 0.0;
  this->ConstrainSeconds = 0.0;
  this->OutputSeconds = 0.0;
  this->NumberOfThreadsUsed = 0;
  this->MemoryEstimate = 0;
}

void vtkAdaptiveHilbertAlgorithm::ClearSeconds()
{
  this->SortSeconds = 0.0;
  this->InsertSeconds = 0.0;
  this->ConstrainSeconds = 0.0;
  this->OutputSeconds = 0.0;
}

void vtkAdaptiveHilbertAlgorithm::TakeMeasures(const ahd::RunReport& report)
{
  const auto count = [&report](const char* name)
  { return ahd::findRow(ahd::kCountRows, name)->get(report); };
  const auto measure = [&report](const char* name)
  { return ahd::findRow(ahd::kMeasureRows, name)->get(report); };
  this->NumberOfTriangles = static_cast<vtkIdType>(count("triangles"));
  this->NumberOfPointsInserted = static_cast<vtkIdType>(count("inserted"));
  this->NumberOfDuplicates = static_cast<vtkIdType>(count("duplicates"));
  this->NumberOfMergedPoints = static_cast<vtkIdType>(count("merged_points"));
  this->NumberOfAddedPoints = static_cast<vtkIdType>(count("added_points"));
  this->NumberOfRejectedPoints = static_cast<vtkIdType>(count("not_finite"));
  this->NumberOfSkippedPoints = static_cast<vtkIdType>(count("skipped"));
  this->NumberOfPointsBeyondLimit = static_cast<vtkIdType>(count("beyond_limit"));
  this->NumberOfPointsWithinError = static_cast<vtkIdType>(count("within_error"));
  this->NumberOfConstraintEdges = static_cast<vtkIdType>(count("constraint_edges"));
  this->NumberOfCrossings = static_cast<vtkIdType>(count("crossings"));
  this->NumberOfAddedLinePoints = static_cast<vtkIdType>(count("points_added_to_lines"));
  this->NumberOfBentConstraints = static_cast<vtkIdType>(count("bent_segments"));
  this->NumberOfConstraintsLeftOut = static_cast<vtkIdType>(
    count("segments_without_vertex") + count("segments_crossing"));
  this->NumberOfUnfilledLoops = static_cast<vtkIdType>(count("unfilled_loops"));
  this->NumberOfTrimmedTriangles = static_cast<vtkIdType>(count("trimmed_triangles"));
  this->LargestError = measure("largest_error");
  this->NP = measure("np");
  this->NR = measure("nr");
  this->SortSeconds = measure("seconds_merge") + measure("seconds_read") + measure("seconds_sort");
  this->InsertSeconds = measure("seconds_insert");
  this->ConstrainSeconds = measure("seconds_split") + measure("seconds_constrain");
  this->OutputSeconds = measure("seconds_extract") + measure("seconds_outputs");
  this->NumberOfThreadsUsed = static_cast<int>(count("threads_used"));
}

void vtkAdaptiveHilbertAlgorithm::AddCounts(vtkFieldData* data) const
{
  const std::pair<const char*, vtkIdType> counts[] = {
    { "NumberOfTriangles", this->NumberOfTriangles },
    { "NumberOfPointsInserted", this->NumberOfPointsInserted },
    { "NumberOfDuplicates", this->NumberOfDuplicates },
    { "NumberOfMergedPoints", this->NumberOfMergedPoints },
    { "NumberOfAddedPoints", this->NumberOfAddedPoints },
    { "NumberOfRejectedPoints", this->NumberOfRejectedPoints },
    { "NumberOfSkippedPoints", this->NumberOfSkippedPoints },
    { "NumberOfPointsBeyondLimit", this->NumberOfPointsBeyondLimit },
    { "NumberOfPointsWithinError", this->NumberOfPointsWithinError },
    { "NumberOfConstraintEdges", this->NumberOfConstraintEdges },
    { "NumberOfCrossings", this->NumberOfCrossings },
    { "NumberOfAddedLinePoints", this->NumberOfAddedLinePoints },
    { "NumberOfBentConstraints", this->NumberOfBentConstraints },
    { "NumberOfConstraintsLeftOut", this->NumberOfConstraintsLeftOut },
    { "NumberOfUnfilledLoops", this->NumberOfUnfilledLoops },
    { "NumberOfTrimmedTriangles", this->NumberOfTrimmedTriangles },
  };
  for (const auto& count : counts)
  {
    vtkAHDAddCount(count.first, count.second, data);
  }
}

void vtkAdaptiveHilbertAlgorithm::GetJobSettings(ahd::JobSettings& settings) const
{
  settings.set(ahd::IntSetting::CellIds, this->SourceMode);
  settings.set(ahd::IntSetting::ZeroIsMissing, this->ZeroIsMissing);
  settings.set(ahd::IntSetting::LinesOnSurface, this->SourceLinesOnSurface);
  settings.set(ahd::DoubleSetting::MaximumSegmentLength, this->MaximumSegmentLength);
  settings.set(ahd::IntSetting::ClosedLines, this->ClosedLines);
  settings.set(ahd::IntSetting::PointsAsLine, this->PointsAsLine);
  settings.set(ahd::IntSetting::FillRule, this->FillRule);
  settings.set(ahd::IntSetting::SplitCrossings, this->CrossingMode);
  settings.set(ahd::DoubleSetting::MaximumEdgeLength, this->MaximumEdgeLength);
  settings.set(ahd::DoubleSetting::Alpha, this->Alpha);
  settings.set(ahd::IntSetting::AlphaTriangles, this->AlphaTris != 0);
  settings.set(ahd::IntSetting::AlphaLines, this->AlphaLines != 0);
  settings.set(ahd::IntSetting::AlphaVertices, this->AlphaVerts != 0);
  settings.set(ahd::DoubleSetting::MaximumError, this->MaximumError);
  settings.set(ahd::IntSetting::MaximumVertices, this->MaximumNumberOfVertices);
  settings.set(ahd::IntSetting::SecondPass, this->SecondPass);
  settings.set(ahd::IntSetting::Rim, this->Rim);
  settings.set(ahd::DoubleSetting::Tolerance, this->Tolerance);
  settings.set(ahd::IntSetting::Duplicates, this->DuplicatePolicy);
  settings.set(ahd::IntSetting::WantPointStatus, this->GeneratePointStatus);
  settings.set(ahd::IntSetting::WantErrors, this->GenerateErrors);
  settings.set(ahd::IntSetting::WantConstraintEdges, this->GenerateConstraintEdges);
  settings.set(ahd::IntSetting::WantRegions, this->GenerateRegionIds);
  settings.set(ahd::IntSetting::WantNeighbors, this->GenerateNeighbors);
  settings.set(ahd::IntSetting::WantVoronoi, this->GenerateVoronoi);
  settings.set(ahd::IntSetting::VoronoiClip, this->VoronoiClip);
  settings.set(ahd::IntSetting::InsertionOrder, this->InsertionOrder);
  settings.set(ahd::IntSetting::Nmax, this->Nmax);
  settings.set(ahd::IntSetting::ControlPoints, this->ControlPoints);
  settings.set(ahd::IntSetting::GeneRotation, this->GeneRotation);
  settings.set(ahd::IntSetting::CountWork, this->CountWork);
  settings.set(ahd::IntSetting::InsertionLimit, this->InsertionLimit);
  settings.set(ahd::IntSetting::WantInsertionRanks, this->GenerateInsertionRank);
  settings.set(ahd::IntSetting::WantCurve, this->GenerateInsertionCurve);
  settings.set(ahd::IntSetting::WantBoxes, this->GenerateBoxes);
  settings.set(ahd::DoubleSetting::Offset, this->Offset);
  settings.set(ahd::IntSetting::Bounding, this->BoundingTriangulation != 0);
}

void vtkAdaptiveHilbertAlgorithm::GetSettingsOfRanks(vtkAHDSettingsOfRanks& settings) const
{
  settings.Numbers = {
    { "SourceMode", double(this->SourceMode) },
    { "ZeroIsMissing", double(this->ZeroIsMissing) },
    { "SourceLinesOnSurface", double(this->SourceLinesOnSurface) },
    { "MaximumSegmentLength", double(this->MaximumSegmentLength) },
    { "ClosedLines", double(this->ClosedLines) },
    { "PointsAsLine", double(this->PointsAsLine) },
    { "FillRule", double(this->FillRule) },
    { "CrossingMode", double(this->CrossingMode) },
    { "MaximumEdgeLength", double(this->MaximumEdgeLength) },
    { "Alpha", double(this->Alpha) },
    { "AlphaTris", double(this->AlphaTris != 0) },
    { "AlphaLines", double(this->AlphaLines != 0) },
    { "AlphaVerts", double(this->AlphaVerts != 0) },
    { "MaximumError", double(this->MaximumError) },
    { "MaximumNumberOfVertices", double(this->MaximumNumberOfVertices) },
    { "SecondPass", double(this->SecondPass) },
    { "KeptPointsOnly", double(this->KeptPointsOnly) },
    { "Tolerance", double(this->Tolerance) },
    { "DuplicatePolicy", double(this->DuplicatePolicy) },
    { "GeneratePointStatus", double(this->GeneratePointStatus) },
    { "GenerateErrors", double(this->GenerateErrors) },
    { "GenerateConstraintEdges", double(this->GenerateConstraintEdges) },
    { "GenerateRegionIds", double(this->GenerateRegionIds) },
    { "GenerateNeighbors", double(this->GenerateNeighbors) },
    { "GenerateVoronoi", double(this->GenerateVoronoi) },
    { "VoronoiClip", double(this->VoronoiClip) },
    { "InsertionOrder", double(this->InsertionOrder) },
    { "Nmax", double(this->Nmax) },
    { "ControlPoints", double(this->ControlPoints) },
    { "GeneRotation", double(this->GeneRotation) },
    { "CountWork", double(this->CountWork) },
    { "InsertionLimit", double(this->InsertionLimit) },
    { "GenerateInsertionRank", double(this->GenerateInsertionRank) },
    { "GenerateInsertionCurve", double(this->GenerateInsertionCurve) },
    { "GenerateBoxes", double(this->GenerateBoxes) },
    { "Offset", double(this->Offset) },
    { "BoundingTriangulation", double(this->BoundingTriangulation != 0) },
  };
  const std::pair<bool, const char*> onOneRank[] = {
    { this->MaximumSegmentLength > 0, "MaximumSegmentLength" },
    { this->PointsAsLine, "PointsAsLine" },
    { this->Alpha > 0, "Alpha" },
    { this->MaximumError > 0, "MaximumError" },
    { this->MaximumNumberOfVertices > 0, "MaximumNumberOfVertices" },
    { this->Tolerance > 0, "Tolerance" },
    { this->GenerateErrors, "GenerateErrors" },
    { this->GenerateRegionIds, "GenerateRegionIds" },
    { this->GenerateNeighbors, "GenerateNeighbors" },
    { this->GenerateVoronoi, "GenerateVoronoi" },
    { this->CountWork, "CountWork" },
    { this->InsertionLimit > 0, "InsertionLimit" },
    { this->GenerateInsertionRank, "GenerateInsertionRank" },
    { this->GenerateInsertionCurve, "GenerateInsertionCurve" },
    { this->GenerateBoxes, "GenerateBoxes" },
  };
  for (const auto& setting : onOneRank)
  {
    if (setting.first)
    {
      settings.OnOneRank.push_back(setting.second);
    }
  }
}

std::string vtkAdaptiveHilbertAlgorithm::GetMeasures()
{
  return vtkAHDMeasuresText({
    { "triangles", double(this->NumberOfTriangles), 0, false },
    { "points in the surface", double(this->NumberOfPointsInserted), 0, false },
    { "duplicates left out", double(this->NumberOfDuplicates), 0, false },
    { "points merged", double(this->NumberOfMergedPoints), 0, false },
    { "points added", double(this->NumberOfAddedPoints), 0, false },
    { "points rejected (NaN or infinite)", double(this->NumberOfRejectedPoints), 0, false },
    { "points skipped (ghost or hidden)", double(this->NumberOfSkippedPoints), 0, false },
    { "points beyond the limit", double(this->NumberOfPointsBeyondLimit), 0, false },
    { "points left out within the error", double(this->NumberOfPointsWithinError), 0, false },
    { "edges of the source", double(this->NumberOfConstraintEdges), 0, false },
    { "crossings in the source", double(this->NumberOfCrossings), 0, false },
    { "points added to lines", double(this->NumberOfAddedLinePoints), 0, false },
    { "bent segments", double(this->NumberOfBentConstraints), 0, false },
    { "segments left out", double(this->NumberOfConstraintsLeftOut), 0, false },
    { "outlines that bound nothing", double(this->NumberOfUnfilledLoops), 0, false },
    { "flat triangles trimmed", double(this->NumberOfTrimmedTriangles), 0, false },
    { "largest error of the points left out", double(this->LargestError), 0, true },
    { "triangles tested a point (NP)", double(this->NP), -1, true },
    { "removed a point (NR)", double(this->NR), -1, true },
  });
}

std::string vtkAdaptiveHilbertAlgorithm::GetResources()
{
  return vtkAHDMeasuresText({
    { "s to sort", double(this->SortSeconds), 0, true },
    { "s to insert", double(this->InsertSeconds), 0, true },
    { "s to constrain", double(this->ConstrainSeconds), 0, true },
    { "s to write", double(this->OutputSeconds), 0, true },
    { "threads", double(this->NumberOfThreadsUsed), 0, false },
    { "triangulations so far", double(this->NumberOfTriangulations), 0, false },
    { "KiB of memory at most", double(this->MemoryEstimate), 0, false },
  });
}

void vtkAdaptiveHilbertAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeBlocks: " << (this->MergeBlocks ? "On\n" : "Off\n");
  os << indent << "SourceMode: " << this->SourceMode << "\n";
  os << indent << "SourceHeights: " << this->SourceHeights << "\n";
  os << indent << "ZeroIsMissing: " << (this->ZeroIsMissing ? "On\n" : "Off\n");
  os << indent << "SourceLinesOnSurface: " << (this->SourceLinesOnSurface ? "On\n" : "Off\n");
  os << indent << "MaximumSegmentLength: " << this->MaximumSegmentLength << "\n";
  os << indent << "ClosedLines: " << this->ClosedLines << "\n";
  os << indent << "PointsAsLine: " << (this->PointsAsLine ? "On\n" : "Off\n");
  os << indent << "FillRule: " << this->FillRule << "\n";
  os << indent << "CrossingMode: " << this->CrossingMode << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "AlphaTris: " << (this->AlphaTris ? "On\n" : "Off\n");
  os << indent << "AlphaLines: " << (this->AlphaLines ? "On\n" : "Off\n");
  os << indent << "AlphaVerts: " << (this->AlphaVerts ? "On\n" : "Off\n");
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "MaximumNumberOfVertices: " << this->MaximumNumberOfVertices << "\n";
  os << indent << "SecondPass: " << (this->SecondPass ? "On\n" : "Off\n");
  os << indent << "KeptPointsOnly: " << (this->KeptPointsOnly ? "On\n" : "Off\n");
  os << indent << "ValueArrayName: " << this->ValueArrayName << "\n";
  os << indent << "WeightArrayName: " << this->WeightArrayName << "\n";
  os << indent << "KeepArrayName: " << this->KeepArrayName << "\n";
  os << indent << "ProjectionPlaneMode: " << this->ProjectionPlaneMode << "\n";
  os << indent << "Rim: " << this->Rim << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "DuplicatePolicy: " << this->DuplicatePolicy << "\n";
  os << indent << "GeneratePointStatus: " << (this->GeneratePointStatus ? "On\n" : "Off\n");
  os << indent << "GenerateErrors: " << (this->GenerateErrors ? "On\n" : "Off\n");
  os << indent << "GenerateConstraintEdges: " << (this->GenerateConstraintEdges ? "On\n" : "Off\n");
  os << indent << "GenerateRegionIds: " << (this->GenerateRegionIds ? "On\n" : "Off\n");
  os << indent << "GenerateNeighbors: " << (this->GenerateNeighbors ? "On\n" : "Off\n");
  os << indent << "GenerateVoronoi: " << (this->GenerateVoronoi ? "On\n" : "Off\n");
  os << indent << "VoronoiClip: " << this->VoronoiClip << "\n";
  os << indent << "VoronoiPolygon: " << this->VoronoiPolygon << "\n";
  os << indent << "InsertionOrder: " << this->InsertionOrder << "\n";
  os << indent << "Nmax: " << this->Nmax << "\n";
  os << indent << "ControlPoints: " << this->ControlPoints << "\n";
  os << indent << "GeneRotation: " << (this->GeneRotation ? "On\n" : "Off\n");
  os << indent << "CountWork: " << (this->CountWork ? "On\n" : "Off\n");
  os << indent << "InsertionLimit: " << this->InsertionLimit << "\n";
  os << indent << "GenerateInsertionRank: " << (this->GenerateInsertionRank ? "On\n" : "Off\n");
  os << indent << "GenerateInsertionCurve: " << (this->GenerateInsertionCurve ? "On\n" : "Off\n");
  os << indent << "GenerateBoxes: " << (this->GenerateBoxes ? "On\n" : "Off\n");
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "BoundingTriangulation: " << (this->BoundingTriangulation ? "On\n" : "Off\n");
  os << indent << "RandomPointInsertion: " << (this->RandomPointInsertion ? "On\n" : "Off\n");
  os << indent << "UseHilbertSorter: " << (this->UseHilbertSorter ? "On\n" : "Off\n");
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "DistributePoints: " << (this->DistributePoints ? "On\n" : "Off\n");
  os << indent << "KeepTriangulation: " << (this->KeepTriangulation ? "On\n" : "Off\n");
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "ReuseLimit: " << this->ReuseLimit << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "NumberOfPointsInserted: " << this->NumberOfPointsInserted << "\n";
  os << indent << "NumberOfDuplicates: " << this->NumberOfDuplicates << "\n";
  os << indent << "NumberOfMergedPoints: " << this->NumberOfMergedPoints << "\n";
  os << indent << "NumberOfAddedPoints: " << this->NumberOfAddedPoints << "\n";
  os << indent << "NumberOfRejectedPoints: " << this->NumberOfRejectedPoints << "\n";
  os << indent << "NumberOfSkippedPoints: " << this->NumberOfSkippedPoints << "\n";
  os << indent << "NumberOfPointsBeyondLimit: " << this->NumberOfPointsBeyondLimit << "\n";
  os << indent << "NumberOfPointsWithinError: " << this->NumberOfPointsWithinError << "\n";
  os << indent << "NumberOfConstraintEdges: " << this->NumberOfConstraintEdges << "\n";
  os << indent << "NumberOfCrossings: " << this->NumberOfCrossings << "\n";
  os << indent << "NumberOfAddedLinePoints: " << this->NumberOfAddedLinePoints << "\n";
  os << indent << "NumberOfBentConstraints: " << this->NumberOfBentConstraints << "\n";
  os << indent << "NumberOfConstraintsLeftOut: " << this->NumberOfConstraintsLeftOut << "\n";
  os << indent << "NumberOfUnfilledLoops: " << this->NumberOfUnfilledLoops << "\n";
  os << indent << "NumberOfTrimmedTriangles: " << this->NumberOfTrimmedTriangles << "\n";
  os << indent << "LargestError: " << this->LargestError << "\n";
  os << indent << "NP: " << this->NP << "\n";
  os << indent << "NR: " << this->NR << "\n";
  os << indent << "SortSeconds: " << this->SortSeconds << "\n";
  os << indent << "InsertSeconds: " << this->InsertSeconds << "\n";
  os << indent << "ConstrainSeconds: " << this->ConstrainSeconds << "\n";
  os << indent << "OutputSeconds: " << this->OutputSeconds << "\n";
  os << indent << "NumberOfThreadsUsed: " << this->NumberOfThreadsUsed << "\n";
  os << indent << "NumberOfTriangulations: " << this->NumberOfTriangulations << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << "\n";
}
