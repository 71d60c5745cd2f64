// SPDX-License-Identifier: BSD-3-Clause
//
// The settings of a case.
#include "FilterCase.h"

#include "SettingRows.h"

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkAdaptiveHilbertQualityMesh2D.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace ahd
{
namespace fuzz
{
namespace
{

using Filter = vtkAdaptiveHilbertDelaunay2D;

/// Two that inputs may have, and one that most have not.
const char* const kArrayNames[] = { "", "a", "b", "Fate" };

/// NaN is refused: the value before stays, which must be a new filter's.
void set(const ahdtest::SettingRow& row, double value, vtkAdaptiveHilbertDelaunay2D* filter)
{
  if (std::isnan(value))
  {
    row.Set(filter, row.Default);
  }
  row.Set(filter, value);
}

/// Of a setting without a byte: the default, where the byte is 0.
double anyValue(const ahdtest::SettingRow& row, std::uint8_t byte)
{
  if (byte == 0 || row.IsReal)
  {
    return byte == 0 ? row.Default : number(byte);
  }
  const double least = std::max(row.Least, -128.0);
  return least + byte % (static_cast<int>(std::min(row.Most - least, 255.0)) + 1);
}
} // namespace

double number(std::uint8_t byte)
{
  const double odd[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -1.0, DBL_MAX, DBL_MIN, 1e-300, 1e300, 1.0 };
  return byte == 0 ? 0.0 : byte >= 248 ? odd[byte - 248] : std::ldexp(1.0, (int(byte) - 160) / 8);
}

void FilterCase::configure(vtkAdaptiveHilbertDelaunay2D* filter, unsigned run) const
{
  filter->SetVoronoiPolygon("-1 -2, 90 3, 40 200");
  filter->SetTransform(transform_); // the same object unless it changes, or nothing is kept
  filter->SetValueArrayName(kArrayNames[head_[kNumbers] & 3]);
  filter->SetWeightArrayName(kArrayNames[head_[kNumbers] >> 2 & 3]);
  filter->SetKeepArrayName(kArrayNames[head_[kNumbers] >> 4 & 3]);
  std::map<std::string, double> values = this->ofSurface();
  values.merge(this->ofNumbers());
  values.merge(this->ofWork(run));
  std::size_t other = 0;
  for (const ahdtest::SettingRow& row : ahdtest::kSettingRows)
  {
    const auto own = values.extract(row.Name);
    set(row, own ? own.mapped() : anyValue(row, head_[other++ % head_.size()]), filter);
  }
  if (!values.empty())
  {
    std::cerr << values.begin()->first << " is no setting.\n";
    std::abort();
  }
}

void FilterCase::configure(vtkAdaptiveHilbertQualityMesh2D* mesh, unsigned run) const
{
  this->configure(mesh->GetTriangulation(), run);
  const double largest = this->largest();
  // half of it, a quarter ...; the last are any number
  const auto part = [&](unsigned bits, FilterByte byte)
  {
    return bits == 0 ? 0.0
      : bits == 7    ? number(head_[byte])
                     : std::ldexp(largest, -static_cast<int>(bits));
  };
  const double length = part(head_[kMeshSizes] >> 2 & 7u, kEdge);
  const double side = part(head_[kMeshSizes] >> 5, kAlpha);
  mesh->SetMinimumAngle(head_[kMesh] % 35);
  mesh->SetMaximumLength(std::isnan(length) ? 0.0 : length);
  mesh->SetMaximumArea(std::isnan(side) ? 0.0 : side * side);
  mesh->SetSizeArrayName(kArrayNames[head_[kMeshSizes] & 3]);
  mesh->SetMaximumNumberOfAddedPoints(head_[kLimit]);
}

/// Of a coordinate of the points, in the plane.
double FilterCase::largest() const
{
  double largest = 0.0;
  auto sets = leavesOf(input_);
  sets.push_back(source_);
  for (vtkDataObject* data : sets)
  {
    auto* const set = vtkPointSet::SafeDownCast(data);
    const vtkIdType count = set && set->GetPoints() ? set->GetNumberOfPoints() : 0;
    for (vtkIdType id = 0; id < count; ++id)
    {
      double point[3];
      set->GetPoint(id, point);
      if (transform_)
      {
        transform_->TransformPoint(point, point);
      }
      for (const double number : point)
      {
        largest = std::isfinite(number) ? std::max(largest, std::abs(number)) : largest;
      }
    }
  }
  return largest;
}

std::map<std::string, double> FilterCase::ofSurface() const
{
  // segments are divided into some 30 parts at most
  const double longest = head_[kEdge] % 4 == 3 ? this->largest() / 8.0 : 0.0;
  return {
    { "MaximumSegmentLength", longest },
    { "SourceMode", bit(kModes, 0) },
    { "CrossingMode", bit(kModes, 1) },
    { "FillRule", bit(kModes, 2) },
    { "ProjectionPlaneMode", head_[kModes] >> 5 & 3 },
    { "MergeBlocks", bit(kModes, 7) },
    { "Rim", head_[kOffset] % 3 },
    { "ClosedLines", bit(kThreadCount, 2) },
    { "PointsAsLine", bit(kThreadCount, 4) },
    { "SourceHeights", bit(kThreadCount, 3) * (1 + bit(kThreadCount, 7)) },
    { "ZeroIsMissing", bit(kThreadCount, 5) },
    { "SourceLinesOnSurface", 1 - bit(kThreadCount, 6) },
    { "GeneratePointStatus", bit(kExtras, 0) },
    { "GenerateConstraintEdges", bit(kExtras, 1) },
    { "GenerateRegionIds", bit(kExtras, 2) },
    { "GenerateNeighbors", bit(kExtras, 3) },
    { "GenerateInsertionRank", bit(kExtras, 4) },
    { "GenerateInsertionCurve", bit(kExtras, 5) },
    { "GenerateBoxes", bit(kExtras, 6) },
    { "GenerateVoronoi", bit(kExtras, 7) },
    { "VoronoiClip", bit(kMoreExtras, 0) * (1 + bit(kMoreExtras, 2)) },
    { "BoundingTriangulation", bit(kMoreExtras, 1) },
    { "AlphaTris", !bit(kMoreExtras, 3) },
    { "AlphaLines", !bit(kMoreExtras, 4) },
    { "AlphaVerts", !bit(kMoreExtras, 5) },
    { "Tolerance", number(head_[kTolerance]) / 64 },
    { "Offset", number(head_[kOffset]) },
  };
}

std::map<std::string, double> FilterCase::ofNumbers() const
{
  const bool simplifies = head_[kMaximumError] != 0 || head_[kMostVertices] != 0;
  const bool isMesh = head_[kMesh] != 0;
  const bool mayLimit = bit(kNumbers, 7) || !(simplifies || isMesh);
  const int duplicates = head_[kModes] >> 3 & 3;
  const bool excludes = simplifies && !bit(kNumbers, 7) && duplicates == Filter::MEAN_Z;
  return {
    { "MaximumError", number(head_[kMaximumError]) },
    { "MaximumNumberOfVertices", head_[kMostVertices] },
    { "SecondPass", bit(kNumbers, 6) },
    { "DuplicatePolicy", excludes ? 0 : duplicates },
    { "Alpha", mayLimit ? number(head_[kAlpha]) : 0.0 },
    { "MaximumEdgeLength", bit(kNumbers, 7) || !isMesh ? number(head_[kEdge]) : 0.0 },
    { "InsertionLimit", mayLimit ? head_[kLimit] : 0 },
  };
}

std::map<std::string, double> FilterCase::ofWork(unsigned run) const
{
  const double limit = head_[kMemory] == 0 ? 0.0 : number(head_[kMemory] % 248u) * 1024 + 1;
  return {
    { "MemoryLimit", limit },
    { "InsertionOrder", head_[kOrder] & 3 },
    { "ControlPoints", (head_[kOrder] >> 2 & 3) == 0 ? 2 : (head_[kOrder] >> 2 & 3) - 1 },
    { "Nmax", head_[kOrder] >> 4 == 0 ? 50 : head_[kOrder] >> 4 },
    { "GeneRotation", !bit(kMoreExtras, 7) },
    { "CountWork", run == 0 && bit(kMoreExtras, 6) },
    { "KeepTriangulation", run == 0 && !bit(kMoreExtras, 2) },
    { "NumberOfThreads", run == 0 ? head_[kThreadCount] % 4 : 3 },
    { "ReuseLimit", run == 0 ? 262144 : 0 },
  };
}

} // namespace fuzz
} // namespace ahd
