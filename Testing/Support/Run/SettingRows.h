// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#ifndef ahd_SettingRows_h
#define ahd_SettingRows_h

#include "vtkAdaptiveHilbertDelaunay2D.h"

#include <limits>

// The settings of vtkAdaptiveHilbertDelaunay2D, for tests of all of them.

namespace ahdtest
{

using Filter = vtkAdaptiveHilbertDelaunay2D;

/// A setting as a number.
struct SettingRow
{
  const char* Name;
  bool IsReal;
  double Default, Least, Most;
  void (*Set)(Filter* filter, double value);
};

constexpr double kNoEnd = std::numeric_limits<double>::max();

const SettingRow kSettingRows[] = {
  { "MergeBlocks", false, 0, 0, 1, [](Filter* f, double v) { f->SetMergeBlocks(v != 0); } },
  { "SourceMode", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetSourceMode(static_cast<int>(v)); } },
  { "SourceHeights", false, 0, 0, 2,
    [](Filter* f, double v) { f->SetSourceHeights(static_cast<int>(v)); } },
  { "ZeroIsMissing", false, 0, 0, 1, [](Filter* f, double v) { f->SetZeroIsMissing(v != 0); } },
  { "SourceLinesOnSurface", false, 1, 0, 1,
    [](Filter* f, double v) { f->SetSourceLinesOnSurface(v != 0); } },
  { "MaximumSegmentLength", true, 0, 0.0, kNoEnd,
    [](Filter* f, double v) { f->SetMaximumSegmentLength(v); } },
  { "ClosedLines", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetClosedLines(static_cast<int>(v)); } },
  { "PointsAsLine", false, 0, 0, 1, [](Filter* f, double v) { f->SetPointsAsLine(v != 0); } },
  { "FillRule", false, 0, 0, 1, [](Filter* f, double v) { f->SetFillRule(static_cast<int>(v)); } },
  { "CrossingMode", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetCrossingMode(static_cast<int>(v)); } },
  { "MaximumEdgeLength", true, 0, 0.0, kNoEnd,
    [](Filter* f, double v) { f->SetMaximumEdgeLength(v); } },
  { "Alpha", true, 0, 0.0, kNoEnd, [](Filter* f, double v) { f->SetAlpha(v); } },
  { "AlphaTris", false, 1, 0, 1,
    [](Filter* f, double v) { f->SetAlphaTris(static_cast<vtkTypeBool>(v)); } },
  { "AlphaLines", false, 1, 0, 1,
    [](Filter* f, double v) { f->SetAlphaLines(static_cast<vtkTypeBool>(v)); } },
  { "AlphaVerts", false, 1, 0, 1,
    [](Filter* f, double v) { f->SetAlphaVerts(static_cast<vtkTypeBool>(v)); } },
  { "MaximumError", true, 0, 0.0, kNoEnd, [](Filter* f, double v) { f->SetMaximumError(v); } },
  { "MaximumNumberOfVertices", false, 0, 0, kNoEnd,
    [](Filter* f, double v) { f->SetMaximumNumberOfVertices(static_cast<vtkIdType>(v)); } },
  { "SecondPass", false, 0, 0, 1, [](Filter* f, double v) { f->SetSecondPass(v != 0); } },
  { "KeptPointsOnly", false, 1, 0, 1, [](Filter* f, double v) { f->SetKeptPointsOnly(v != 0); } },
  { "ProjectionPlaneMode", false, 0, 0, 2,
    [](Filter* f, double v) { f->SetProjectionPlaneMode(static_cast<int>(v)); } },
  { "Rim", false, 0, 0, 2, [](Filter* f, double v) { f->SetRim(static_cast<int>(v)); } },
  { "Tolerance", true, 0, 0.0, 1.0, [](Filter* f, double v) { f->SetTolerance(v); } },
  { "DuplicatePolicy", false, 0, 0, 3,
    [](Filter* f, double v) { f->SetDuplicatePolicy(static_cast<int>(v)); } },
  { "GeneratePointStatus", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetGeneratePointStatus(v != 0); } },
  { "GenerateErrors", false, 0, 0, 1, [](Filter* f, double v) { f->SetGenerateErrors(v != 0); } },
  { "GenerateConstraintEdges", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetGenerateConstraintEdges(v != 0); } },
  { "GenerateRegionIds", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetGenerateRegionIds(v != 0); } },
  { "GenerateNeighbors", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetGenerateNeighbors(v != 0); } },
  { "GenerateVoronoi", false, 0, 0, 1, [](Filter* f, double v) { f->SetGenerateVoronoi(v != 0); } },
  { "VoronoiClip", false, 0, 0, 2,
    [](Filter* f, double v) { f->SetVoronoiClip(static_cast<int>(v)); } },
  { "InsertionOrder", false, 0, 0, 3,
    [](Filter* f, double v) { f->SetInsertionOrder(static_cast<int>(v)); } },
  { "Nmax", false, 50, 1, kNoEnd, [](Filter* f, double v) { f->SetNmax(static_cast<int>(v)); } },
  { "ControlPoints", false, 2, 0, 2,
    [](Filter* f, double v) { f->SetControlPoints(static_cast<int>(v)); } },
  { "GeneRotation", false, 1, 0, 1, [](Filter* f, double v) { f->SetGeneRotation(v != 0); } },
  { "CountWork", false, 0, 0, 1, [](Filter* f, double v) { f->SetCountWork(v != 0); } },
  { "InsertionLimit", false, 0, 0, kNoEnd,
    [](Filter* f, double v) { f->SetInsertionLimit(static_cast<vtkIdType>(v)); } },
  { "GenerateInsertionRank", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetGenerateInsertionRank(v != 0); } },
  { "GenerateInsertionCurve", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetGenerateInsertionCurve(v != 0); } },
  { "GenerateBoxes", false, 0, 0, 1, [](Filter* f, double v) { f->SetGenerateBoxes(v != 0); } },
  { "Offset", true, 1, 0.75, kNoEnd, [](Filter* f, double v) { f->SetOffset(v); } },
  { "BoundingTriangulation", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetBoundingTriangulation(static_cast<vtkTypeBool>(v)); } },
  { "RandomPointInsertion", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetRandomPointInsertion(static_cast<vtkTypeBool>(v)); } },
  { "UseHilbertSorter", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetUseHilbertSorter(static_cast<vtkTypeBool>(v)); } },
  { "NumberOfThreads", false, 0, 0, 1024,
    [](Filter* f, double v) { f->SetNumberOfThreads(static_cast<int>(v)); } },
  { "DistributePoints", false, 0, 0, 1,
    [](Filter* f, double v) { f->SetDistributePoints(v != 0); } },
  { "KeepTriangulation", false, 1, 0, 1,
    [](Filter* f, double v) { f->SetKeepTriangulation(v != 0); } },
  { "MemoryLimit", false, 0, 0, kNoEnd,
    [](Filter* f, double v) { f->SetMemoryLimit(static_cast<vtkTypeInt64>(v)); } },
  { "ReuseLimit", false, 262144, 0, kNoEnd,
    [](Filter* f, double v) { f->SetReuseLimit(static_cast<vtkTypeInt64>(v)); } },
};

} // namespace ahdtest

#endif
