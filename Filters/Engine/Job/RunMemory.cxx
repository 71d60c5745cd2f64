// SPDX-License-Identifier: BSD-3-Clause
#include "RunMemory.h"

#include "../Crossings/Crossings.h"
#include "../Simplify/Simplify.h"
#include "../Surface/Means.h"
#include "../Surface/OrderDrawing.h"
#include "../Triangulate.h"
#include "Errors.h"

#include <algorithm>
#include <iterator>

namespace ahd
{
namespace
{

constexpr std::size_t kId = sizeof(std::int64_t), kPlace = 3 * sizeof(double);

/// The numbers of triangles in their slots, and new memory for their keys where thousands have
/// their lowest corners near to each other, or where they do not overwrite the locations.
constexpr std::size_t kNumbers = 8 + 16;
/// Corners, which need no numbers, and the keys.
constexpr std::size_t kCorners = 24 + 16;
/// All tables, as they are kept: numbers, corners, flags, neighbours, a half-edge of each vertex, a
/// vertex of each point.
constexpr std::size_t kTables = 8 + 24 + 2 + 24 + 4 + 4;
/// Of these, those that constraints leave.
constexpr std::size_t kTablesBehindConstraints = 8 + 2 + 4;

/// Cells of the Voronoi diagram where all points are on the hull, which are the largest: of each
/// point three corners, six numbers of corners, an offset and a site. And what is written of them.
constexpr std::size_t kVoronoiCells = 3 * kPlace + 6 * 4 + 4 + 4;
constexpr std::size_t kVoronoiWritten = 3 * kPlace + 6 * 4 + 4 + kId;

constexpr std::size_t kBoxKept = 2 * sizeof(GridBox); ///< in a list that grows by doubling

/// A pair for each duplicate, and a mean for each place that has some: most where each place has
/// one.
constexpr std::size_t kMeans = (8 + sizeof(Mean)) / 2;

/// Of one run. All are bytes, upper estimates.
class Estimate
{
public:
  Estimate(const InputRequest& request, const RunSettings& settings, const RunSizes& sizes,
    const CallersMemory& callers)
    : request_(request)
    , settings_(settings)
    , sizes_(sizes)
    , callers_(callers)
    , hasMarks_(sizes.segments + sizes.surfaceEdges > 0 || settings.mayTrimRim())
    , adds_(sizes.points > request.points.count)
  {
  }

  std::size_t most() const
  {
    const std::size_t shown = held() + constrained() + inSpace();
    const std::size_t steps[] = { prepared() + simplifying(), prepared() + triangulating(),
      held() + constraining(), shown + selecting(), shown + written() + writing(),
      held() + makingVoronoi() };
    return std::max(preparing(), *std::max_element(std::begin(steps), std::end(steps)));
  }

private:
  std::size_t ofVoronoi(std::size_t perPoint) const
  {
    return settings_.voronoi ? perPoint * (sizes_.points + settings_.voronoiPolygon.size()) : 0;
  }
  std::size_t perPoint(bool is, std::size_t bytes) const { return is ? sizes_.points * bytes : 0; }
  bool selectsByAlpha() const { return settings_.limits.alpha > 0.0; }
  /// By limits in the plane alone?
  bool selectsInPlane() const { return settings_.limitsSize() && !selectsByAlpha(); }
  bool addsToSegments() const { return sizes_.crossings + sizes_.addedToLines > 0; }
  bool hasSurface() const { return request_.surface.count > 0; }
  bool writesCells() const { return !settings_.samples; }
  bool keepsTables() const { return settings_.voronoi && sizes_.segments == 0; }

  std::size_t preparing() const;
  std::size_t prepared() const;
  std::size_t simplifying() const;
  std::size_t triangulating() const;
  std::size_t held() const;
  std::size_t constrained() const;
  std::size_t inSpace() const;
  std::size_t constraining() const;
  std::size_t makingVoronoi() const;
  std::size_t selecting() const;
  std::size_t written() const;
  std::size_t writing() const;
  std::size_t orderDrawn() const;

  const InputRequest& request_;
  const RunSettings& settings_;
  const RunSizes& sizes_;
  const CallersMemory& callers_;
  const bool hasMarks_; // of constraints, or of dropped triangles
  const bool adds_;     // points
};

std::size_t Estimate::preparing() const
{
  const std::size_t known = preparationMemoryEstimate(request_);
  const std::size_t toSplit = sizes_.crossings > 0 ? splitMemoryEstimate(0, sizes_.crossings) : 0;
  std::size_t bytes = known + std::max(toSplit, sizes_.askedToSplit);
  if (addsToSegments())
  {
    bytes = std::max(bytes, prepared() + known); // as they are added
  }
  if (settings_.laysSource() && request_.sourcePoints.count > 0)
  {
    const bool areMixed = request_.heights == SourceHeights::Mixed;
    const std::size_t own = request_.points.count + (areMixed ? request_.sourcePoints.count : 0);
    bytes += triangulationMemoryEstimate(own, settings_.options) + tableMemoryEstimate(own) +
      (settings_.showsMeans ? own * kMeans : 0) +
      (areMixed ? knownConstraintMemory(own, sizes_.segments) : 0);
  }
  return bytes;
}

/// The rest of it.
std::size_t Estimate::prepared() const
{
  std::size_t bytes = preparedMemoryEstimate(request_) + perPoint(hasSurface(), 1) +
    perPoint(settings_.simplifies(), 1) + // marks
    perPoint(adds_ && settings_.hasValues, 8) + perPoint(adds_ && settings_.hasWeights, 8) +
    perPoint(adds_ && settings_.hasMarks, 1);
  if (addsToSegments())
  {
    bytes += sizes_.points * (kPlace + 1) +
      sizes_.crossings * (sizeof(CrossingOrigin) + 2 * kId + 2 * kId) + // cells, ids
      sizes_.addedToLines * (2 * sizeof(SurfacePlace) + 2 * (kId + 1)); // ids, marks
  }
  return bytes;
}

std::size_t Estimate::simplifying() const
{
  SimplifyRequest request;
  request.points.count = sizes_.points;
  request.constraints.chains = sizes_.segments > 0 ? 1 : 0;
  const double weight = 1.0;
  const unsigned char mark = 1;
  request.weights.doubles = settings_.hasWeights ? &weight : nullptr;
  request.mustStay = settings_.hasMarks ? &mark : nullptr;
  return settings_.simplifies() ? simplifyMemoryEstimate(request) + sizes_.askedToSimplify : 0;
}

std::size_t Estimate::triangulating() const
{
  // where one of several points stands for a vertex: the vertex of each point, twice
  const bool chooses = settings_.options.representative != Representative::FirstId;
  return triangulationMemoryEstimate(sizes_.points, settings_.options) +
    perPoint(chooses, 2 * sizeof(Index)) + sizes_.boxes * kBoxKept;
}

/// From when there are triangles until the end.
std::size_t Estimate::held() const
{
  return prepared() + triangulatedMemoryEstimate(sizes_.points, settings_.options) +
    sizes_.boxes * kBoxKept + perPoint(keepsTables(), kTables) + ofVoronoi(kVoronoiCells);
}

/// From when there are constraints: tables that stay, marks, a slot of each vertex. Or a vertex of
/// each point, for means.
std::size_t Estimate::constrained() const
{
  return perPoint(hasMarks_, 4 + 2) +
    perPoint(!keepsTables() && (settings_.voronoi || hasMarks_), kTablesBehindConstraints) +
    perPoint(!keepsTables() && settings_.showsMeans, 4);
}

/// Where points lie that are not the input's own.
std::size_t Estimate::inSpace() const
{
  return perPoint(
    adds_ || (settings_.showsMeans && (writesCells() || settings_.limitsSize())), kPlace);
}

/// Trimming, and averaging, take less than what is held when cells are written.
std::size_t Estimate::constraining() const
{
  const std::size_t edges = sizes_.surfaceEdges;
  const std::size_t segments = sizes_.segments + 2 * sizes_.crossings + edges;
  return segments == 0 ? 0
                       : knownConstraintMemory(sizes_.points, segments) + sizes_.askedToConstrain +
      edges * 3 * kId; // their ends, and where they begin
}

/// The cells and the tables are in held().
std::size_t Estimate::makingVoronoi() const
{
  const std::size_t points = sizes_.points + settings_.voronoiPolygon.size();
  return settings_.voronoi ? voronoiMemoryEstimate(points) - ofVoronoi(kVoronoiCells) +
      perPoint(sizes_.segments > 0, kTables - kTablesBehindConstraints)
                           : 0;
}

std::size_t Estimate::selecting() const
{
  if (!selectsByAlpha())
  {
    return perPoint(selectsInPlane(), 2 + kCorners + (hasMarks_ ? kNumbers : 0));
  }
  // Where the plane is x, y, of the places in space z alone is read.
  const bool isUpright = !request_.fitPlane && !request_.projection;
  return selectionMemoryEstimate(sizes_.points) - perPoint(isUpright, 2 * sizeof(double)) +
    sizes_.points * kNumbers;
}

/// The outputs. Memory of arrays is rounded up by a sixteenth at most
/// (vtkAHDOutputMemory::GetCapacity).
std::size_t Estimate::written() const
{
  std::size_t bytes = sizes_.points * settings_.bytesOfArrays(false) + ofVoronoi(kVoronoiWritten) +
    orderDrawn();
  if (writesCells())
  {
    // Corners and offsets of two triangles a point; of lines in place of all of them there are
    // three.
    const std::size_t rows = selectsByAlpha() ? 3 : 2;
    bytes += sizes_.points *
      ((selectsByAlpha() ? 3 * (2 + 1) : 2 * (3 + 1)) * sizeof(std::int32_t) +
        rows * settings_.bytesOfArrays(true));
  }
  return bytes + bytes / 16 + 4096 +
    perPoint(adds_ || settings_.simplifies(), callers_.perAddedPoint);
}

/// The selection, and memory to write arrays.
std::size_t Estimate::writing() const
{
  // By corners alone, where these are there and numbers are not; else with a place among those
  // that are left. A byte for each triangle, the ends of lines.
  const bool byCorners = selectsInPlane();
  const std::size_t ends = selectsByAlpha() ? 24 : 0, places = byCorners && !hasMarks_ ? 0 : 8;
  // a set of each slot, and three numbers for each set
  constexpr std::size_t kRegions = 8 + 2 * 12;
  const bool looksUp = settings_.wants(WantedArray::Neighbors) ||
    (hasMarks_ &&
      (settings_.wants(WantedArray::Regions) || settings_.wants(WantedArray::ConstraintEdges) ||
        byCorners));
  const std::size_t selected = perPoint(settings_.limitsSize() || hasSurface(), 2);
  if (settings_.samples) // all tables are made, except existing ones
  {
    return selected + perPoint(true, kTables);
  }
  // A surface has all of them, too, to find its triangles.
  const bool findsErrors = settings_.wants(WantedArray::Errors);
  const bool needsAll = hasSurface() || findsErrors;
  const std::size_t tables = needsAll ? kTables - (hasMarks_ ? kTablesBehindConstraints : 0)
    : selectsByAlpha()                ? 8
    : looksUp                         ? kNumbers
                                      : 0;
  return selected + perPoint(settings_.limitsSize() || hasSurface(), ends + places) +
    perPoint(byCorners, 24) + perPoint(true, tables) +
    (findsErrors ? errorMemoryEstimate(sizes_.points) : 0) +
    perPoint(hasMarks_ && settings_.wants(WantedArray::Regions), kRegions);
}

std::size_t Estimate::orderDrawn() const
{
  if (!settings_.curve && !settings_.options.keepBoxes)
  {
    return 0;
  }
  const std::size_t limit = settings_.options.insertionLimit;
  const std::size_t inserted = limit > 0 ? std::min(limit, sizes_.points) : sizes_.points;
  constexpr std::size_t kPerCorner = kPlace + 3 * kId, kPerCell = 2 * kId + sizeof(int);
  return (settings_.curve ? inserted * (kPlace + 3 * kId) : 0) + 1024 +
    sizes_.boxes * (kBoxCorners * kPerCorner + kPerCell);
}

} // namespace

std::size_t keptMemoryEstimate(
  const InputRequest& request, const RunSettings& settings, const RunSizes& sizes)
{
  const std::size_t count = sizes.points;
  const bool isConstrained = sizes.segments > 0 || settings.mayTrimRim();
  return preparedMemoryEstimate(request) + triangulatedMemoryEstimate(count, settings.options) +
    tableMemoryEstimate(count) + (isConstrained ? constraintMemoryEstimate(count, 0) : 0) +
    (settings.limitsSize() ? 2 * count : 0) + (kPlace + 1) * count;
}

std::size_t runMemoryEstimate(const InputRequest& request, const RunSettings& settings,
  const RunSizes& sizes, const CallersMemory& callers)
{
  return sizes.points > kMaximumPoints
    ? std::size_t(-1) / 2
    : callers.bytes + Estimate(request, settings, sizes, callers).most();
}

} // namespace ahd
