// SPDX-License-Identifier: BSD-3-Clause
#include "Prepare.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Order/CurveOrder.h"
#include "../Surface/PlaneFit.h"
#include "../Triangulation/Triangulation.h"
#include "Preparation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ahd
{
namespace
{

/// Bytes of mergeWithin for each point: the point while sorted and while kept, with its chains, the
/// point it is merged into, and the marks and pairs that remain.
constexpr std::size_t kBytesToMerge = 80;
/// Of these the marks and pairs.
constexpr std::size_t kBytesMerged = sizeof(MergedPoint) + 1;

bool isProjected(const InputRequest& request)
{
  return request.fitPlane || request.projection;
}

/// Points, to the chains?
bool mayAddToLines(const InputRequest& request)
{
  return segmentsOf(request) > 0 &&
    (request.maximumSegmentLength > 0.0 ||
      (request.linesOnSurface && request.heights != SourceHeights::Own));
}

/// Lines of no id not counted.
std::size_t segmentsToSplit(const InputRequest& request)
{
  const CellsView& lines = request.lines;
  return segmentsOf(request) - std::min(lines.ids, lines.cells);
}

std::size_t chainsOf(const InputRequest& request)
{
  return request.lines.cells + request.polygons.cells + (arePointsLine(request) ? 1 : 0);
}

/// The results of the tasks of a loop.
struct Found
{
  std::size_t firstNotFinite = std::numeric_limits<std::size_t>::max();
  std::size_t oddZ = 0;

  void merge(const Found& other)
  {
    firstNotFinite = std::min(firstNotFinite, other.firstNotFinite);
    oddZ += other.oddZ;
  }
};

/// Sums that become NaN with the first number that is not finite: no branch, since there hardly
/// ever is one.
template <typename Number>
bool areAllFinite(const Number* begin, const Number* end)
{
  Number x = 0, y = 0, z = 0;
  for (const Number* p = begin; p != end; p += 3)
  {
    x += p[0] * 0;
    y += p[1] * 0;
    z += p[2] * 0;
  }
  return x + y + z == 0;
}

/// The same for points that are not three contiguous numbers.
bool areAllFinite(const PointView& points, std::size_t begin, std::size_t end)
{
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::array<double, 3> p = points.place(i);
    sum += p[0] * 0 + p[1] * 0 + p[2] * 0;
  }
  return sum == 0;
}

/// Looks at the points [begin, end).
void findOdd(const PointView& points, std::size_t begin, std::size_t end, Found& found)
{
  const bool areRows = points.stride == 3 && !points.isFlat;
  if (!areRows         ? areAllFinite(points, begin, end)
      : points.doubles ? areAllFinite(points.doubles + 3 * begin, points.doubles + 3 * end)
                       : areAllFinite(points.floats + 3 * begin, points.floats + 3 * end))
  {
    return;
  }
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::array<double, 3> p = points.place(i);
    if (points.skipped(i))
    {
      continue;
    }
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
    {
      found.firstNotFinite = std::min(found.firstNotFinite, i);
    }
    else if (!std::isfinite(p[2]))
    {
      ++found.oddZ;
    }
  }
}

/// The first bad cell.
struct Misplaced
{
  std::size_t cell = std::size_t(-1);

  void merge(const Misplaced& other) { cell = std::min(cell, other.cell); }
};

template <typename Number>
Status findBadCellBy(
  const Number* offsets, const CellsView& cells, const Context& context, BadCell& bad)
{
  Ticker ticker(context.progress, Phase::Merge, 0, context.executor);
  Misplaced found;
  const bool all = gather(cells.cells, ticker, found,
    [&](Misplaced& part, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end && part.cell > i; ++i)
      {
        const bool isFit = offsets[i] >= 0 && offsets[i] <= offsets[i + 1] &&
          static_cast<std::uint64_t>(offsets[i + 1]) <= cells.ids;
        part.cell = isFit ? part.cell : i;
      }
    });
  if (!all)
  {
    return Status::Cancelled;
  }
  if (found.cell >= cells.cells)
  {
    return Status::Ok;
  }
  bad = { found.cell, offsets[found.cell], offsets[found.cell + 1], cells.ids };
  return Status::BadCells;
}

} // namespace

std::array<double, 3> PreparedInput::place(std::size_t id) const
{
  return points_.place(id);
}

ConstraintView PreparedInput::constraints() const
{
  ConstraintView view;
  view.ids = ids_.data();
  view.offsets = offsets_.data();
  view.chains = offsets_.empty() ? 0 : offsets_.size() - 1;
  view.lines = lines_;
  return view;
}

std::int64_t PreparedInput::cellOf(std::size_t chain) const
{
  return firstCell_ + (cells_.empty() ? static_cast<std::int64_t>(chain) : cells_[chain]);
}

Status PreparedInput::endCrossingsAtVertices(Triangulation& triangulation, const Context& context)
{
  if (crossings_.size() + addedToLines_ == 0 || triangulation.report().duplicates == 0)
  {
    return Status::Ok; // each point stands for itself
  }
  const Status status = triangulation.makePointMap(context);
  if (status != Status::Ok)
  {
    return status;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      const auto firstAdded = static_cast<Index>(inputCount_ + sourceCount_);
      const auto refer = [&](auto& points, Index limit)
      {
        for (Index& point : points)
        {
          const Index vertex = triangulation.vertexOf(point);
          const Index other = vertex == kNoIndex ? point : triangulation.pointOf(vertex);
          point = other < limit ? other : point;
        }
      };
      const bool all = ticker.ask() &&
        inChunks(0, crossings_.size(), ticker,
          [&](std::size_t begin, std::size_t end)
          {
            for (std::size_t k = begin; k < end; ++k)
            {
              refer(crossings_[k].ends, kNoIndex);
            }
          }) &&
        inChunks(surfacePlaces_.size() - addedToLines_, surfacePlaces_.size(), ticker,
          [&](std::size_t begin, std::size_t end)
          {
            for (std::size_t k = begin; k < end; ++k)
            {
              refer(surfacePlaces_[k].corners, firstAdded); // interpolated in order
            }
          });
      if (all)
      {
        findAddedHeights();
      }
      return all;
    });
}

/// Of points added to lines, then of crossings.
void PreparedInput::findAddedHeights()
{
  std::size_t id = inputCount_ + sourceCount_;
  for (std::size_t k = sourceCount_; k < surfacePlaces_.size(); ++k)
  {
    places_[3 * id++ + 2] = interpolate(
      surfacePlaces_[k], [this](Index origin) { return places_[3 * std::size_t(origin) + 2]; });
  }
  findCrossingHeights();
}

void PreparedInput::findCrossingHeights()
{
  double* places = places_.data() + 3 * firstCrossing();
  for (std::size_t k = 0; k < crossings_.size(); ++k)
  {
    places[3 * k + 2] = interpolate(
      crossings_[k], [this](Index id) { return places_[3 * std::size_t(id) + 2]; });
  }
}

Status prepare(const InputRequest& request, const Context& context, PreparedInput& out)
{
  return withoutThrowing([&] { return Preparation(request, context, out).run(); });
}

Status fitPlaneOf(const InputRequest& request, const Context& context, Plane& plane)
{
  PointView fitted = request.points;
  fitted.count -= std::min(fitted.count, request.unfittedPoints);
  return plane.fit(fitted, context);
}

std::size_t expectedPoints(const InputRequest& request)
{
  const bool isBounded = request.bounding && !isProjected(request);
  return request.points.count + request.sourcePoints.count + (isBounded ? 8 : 0);
}

bool arePointsLine(const InputRequest& request)
{
  return request.pointsAreLine && !request.idsAreOfInput && request.sourcePoints.count > 1 &&
    request.lines.cells + request.polygons.cells == 0;
}

std::size_t segmentsOf(const InputRequest& request)
{
  // a loop has as many as points, a line one less
  return arePointsLine(request) ? request.sourcePoints.count
                                : request.lines.ids + request.polygons.ids;
}

std::size_t preparationMemoryEstimate(const InputRequest& request)
{
  const std::size_t segments = segmentsOf(request), chains = chainsOf(request);
  const bool closes = request.closedLinesAreLoops && segments > 0;
  const std::size_t toClose = (segments + 3 * chains) * sizeof(std::int64_t) +
    closingMemoryEstimate(request.lines.cells);
  return preparedMemoryEstimate(request) + (closes ? toClose : 0) +
    (request.split && segments > 0 ? splitMemoryEstimate(segmentsToSplit(request), 0) : 0) +
    (request.heights != SourceHeights::Own ? CurveOrder::mostBytes(request.sourcePoints.count) +
          request.sourcePoints.count * sizeof(Index)
                                           : 0) +
    (request.heights == SourceHeights::Mixed
        ? (segments + chains) * sizeof(std::int64_t) + expectedPoints(request)
        : 0) +
    (mayAddToLines(request) ? (segments + chains) * (sizeof(std::int64_t) + 1) : 0) +
    (request.fitPlane && !request.plane ? planeFitMemoryEstimate(expectedPoints(request)) : 0) +
    (request.tolerance > 0.0 ? expectedPoints(request) * (kBytesToMerge - kBytesMerged) : 0);
}

std::size_t preparedMemoryEstimate(const InputRequest& request)
{
  const std::size_t count = expectedPoints(request);
  const std::size_t segments = segmentsOf(request);
  const std::size_t chains = chainsOf(request);
  const bool areCopied = count > request.points.count || isProjected(request);
  return (areCopied ? count * (3 * sizeof(double) + 1) : 0) +
    (segments > 0 ? (segments + chains) * sizeof(std::int64_t) : 0) +
    (request.heights != SourceHeights::Own || mayAddToLines(request)
        ? request.sourcePoints.count * sizeof(SurfacePlace)
        : 0) +
    (request.tolerance > 0.0 ? count * kBytesMerged : 0);
}

Status findBadCell(const CellsView& cells, const Context& context, BadCell& bad)
{
  return withoutThrowing(
    [&]
    {
      return cells.offsets64 ? findBadCellBy(cells.offsets64, cells, context, bad)
                             : findBadCellBy(cells.offsets32, cells, context, bad);
    });
}

Status findOddPoints(const PointView& points, const Context& context, OddPoints& odd)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Extract, 0, context.executor);
      Found found;
      const bool all = gather(points.count, ticker, found,
        [&points](Found& part, std::size_t begin, std::size_t end)
        { findOdd(points, begin, end, part); });
      const bool isNone = found.firstNotFinite == Found().firstNotFinite;
      odd.firstNotFinite = isNone ? 0 : found.firstNotFinite;
      odd.oddZ = found.oddZ;
      return all;
    });
}

} // namespace ahd
