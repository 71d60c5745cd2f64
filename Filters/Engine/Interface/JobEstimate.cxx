// SPDX-License-Identifier: BSD-3-Clause
//
// The memory that a job needs.
#include "Job.h"

#include "../Crossings/Crossings.h"
#include "../Surface/Means.h"
#include "../Surface/OrderDrawing.h"

#include <algorithm>

namespace ahd
{
namespace
{

constexpr std::size_t kId = sizeof(std::int64_t);

} // namespace

std::size_t boxBytes(std::size_t boxes)
{
  const std::size_t perCorner = 3 * sizeof(double) + 3 * kId;
  const std::size_t perCell = 2 * kId + sizeof(int);
  return boxes * (2 * sizeof(GridBox) + kBoxCorners * perCorner + perCell);
}

std::size_t Job::estimate() const
{
  return expected(request()).estimate;
}

/// Upper estimate of all that is allocated, for what is known of sizes: points and segments before
/// the work begins; crossings once they are split, boxes once the points are sorted.
std::size_t Job::estimate(const JobSizes& sizes) const
{
  InputRequest asked = request();
  asked.fitPlane = settings.isProjected(); // or what takes the same
  const std::size_t count = sizes.points;
  std::size_t before = static_cast<std::size_t>(settings[IntSetting::OtherMemory]) +
    arrays.copiedBytes() + preparationMemoryEstimate(asked);
  std::size_t bytes = triangulationMemoryEstimate(count, settings.options());
  std::size_t toSplit = 0; // what is given back before the triangulation
  if (sizes.crossings > 0)
  {
    before += count * (3 * sizeof(double) + 1) + sizes.crossings * sizeof(CrossingOrigin);
    toSplit = splitMemoryEstimate(0, sizes.crossings);
  }
  if (sizes.segments > 0)
  {
    bytes += constraintMemoryEstimate(count, sizes.segments + 2 * sizes.crossings);
  }
  bytes += settings.mayTrimRim() ? trimMemoryEstimate(count) : 0;
  bytes += count > asked.points.count ? 3 * sizeof(double) * count : 0; // where they are in space
  return before + std::max(toSplit, bytes + estimateTables(sizes) + estimateArrays(sizes));
}

/// What is made of a triangulation to be looked up in it.
std::size_t Job::estimateTables(const JobSizes& sizes) const
{
  const bool wantsVoronoi = settings.is(IntSetting::WantVoronoi);
  const bool looksUp = settings.limitsSize() || settings.is(IntSetting::WantNeighbors) ||
    settings.is(IntSetting::WantRegions) || settings.is(IntSetting::WantConstraintEdges) ||
    wantsVoronoi || settings.showsMeans() || settings.is(IntSetting::SourceHeights) ||
    sizes.crossings > 0;
  // where one of several points stands for a vertex: the vertex of each point, twice
  const bool chooses = settings.options().representative != Representative::FirstId;
  return (chooses ? 2 * sizeof(Index) * sizes.points : 0) +
    (looksUp ? tableMemoryEstimate(sizes.points) : 0) +
    (settings.limitsSize() ? selectionMemoryEstimate(sizes.points) : 0) +
    (wantsVoronoi ? voronoiMemoryEstimate(sizes.points) : 0);
}

/// The arrays that are announced, written: triangles and their offsets with 32 bits, other ids with
/// 64.
std::size_t Job::estimateArrays(const JobSizes& sizes) const
{
  const auto bytes = [this](IntSetting wanted, std::size_t size)
  { return settings.is(wanted) ? size : 0; };
  const std::size_t perTriangle = (3 + 1) * sizeof(std::int32_t) +
    bytes(IntSetting::WantNeighbors, 3 * kId) + bytes(IntSetting::WantRegions, kId) +
    bytes(IntSetting::WantConstraintEdges, 1);
  // a pair of numbers for each duplicate, as a vector grows, a mean, and the copy of the points
  constexpr std::size_t kPerMean = 4 * sizeof(std::size_t) + 2 * sizeof(Mean) + 3 * sizeof(double);
  // two corners a vertex, six numbers of corners, an offset and an id
  constexpr std::size_t kPerVoronoiCell = 2 * 3 * sizeof(double) + 8 * kId;
  const std::size_t perPoint = bytes(IntSetting::WantPointStatus, kId) +
    bytes(IntSetting::WantInsertionRanks, kId) + (settings.showsMeans() ? kPerMean : 0) +
    bytes(IntSetting::WantVoronoi, kPerVoronoiCell);
  std::size_t sum = sizes.points * (2 * perTriangle + perPoint);
  if (settings.drawsOrder())
  {
    const std::size_t limit = settings.options().insertionLimit;
    const std::size_t inserted = limit > 0 ? std::min(limit, sizes.points) : sizes.points;
    sum += bytes(IntSetting::WantCurve, inserted * (3 * sizeof(double) + 3 * kId)) + 1024 +
      boxBytes(sizes.boxes);
  }
  return sum;
}

} // namespace ahd
