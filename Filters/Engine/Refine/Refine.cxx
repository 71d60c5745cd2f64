// SPDX-License-Identifier: BSD-3-Clause
#include "Refine.h"

#include "../Core/Border.h"
#include "Domain.h"
#include "Refiner.h"
#include "Writing.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace
{

constexpr double kMostCoordinate = 0x1p900; ///< so that nothing overflows

bool isLimit(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

bool isInRange(const Point& p)
{
  return std::max(std::fabs(p.x), std::fabs(p.y)) < kMostCoordinate;
}

/// Of the request alone.
RefineFault faultOf(const RefineRequest& request)
{
  const bool isAngle = isLimit(request.minimumAngle) &&
    request.minimumAngle <= RefineRequest::kLargestAngle;
  return !isAngle                     ? RefineFault::Angle
    : !isLimit(request.maximumArea)   ? RefineFault::Area
    : !isLimit(request.maximumLength) ? RefineFault::Length
                                      : RefineFault::None;
}

/// The numbers of vertices that there may be: in a mesh with its frame, and in one made of the
/// points.
std::size_t mostFor(const Triangulation& made, const RefineRequest& request)
{
  const std::size_t there = std::max(made.points().count, made.vertexCount()) + Domain::kFirst +
    Domain::kFrame;
  const std::size_t room = there < kMaximumPoints ? kMaximumPoints - there : 0;
  return std::min(request.mostSteinerPoints, room);
}

} // namespace

RefineFault findRefineFault(
  const Triangulation& made, const RefineRequest& request, std::size_t& at)
{
  at = 0;
  const RefineFault fault = faultOf(request);
  const PointView& points = made.points();
  for (; fault == RefineFault::None && at < points.count; ++at)
  {
    if (!isFinite(points[at]) || points.skipped(at))
    {
      continue;
    }
    if (!isInRange(points[at]))
    {
      return RefineFault::Range;
    }
    if (request.sizes && !(isLimit(request.sizes[at]) && request.sizes[at] > 0.0))
    {
      return RefineFault::Size;
    }
  }
  at = 0;
  return fault;
}

Status refine(
  Triangulation& made, const RefineRequest& request, const Context& context, Refinement& out)
{
  out = Refinement();
  std::size_t at = 0;
  const RefineFault fault = findRefineFault(made, request, at);
  if (fault != RefineFault::None)
  {
    out.fault = fault;
    out.faultAt = at;
    return Status::Ok;
  }
  const Status status = made.makeNeighbors(context);
  if (status != Status::Ok || made.triangleCount() == 0)
  {
    return status;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      Domain domain(made, request.sizes, ticker);
      if (!ticker.ask() || !domain.load())
      {
        return false;
      }
      Refiner refiner(domain, request, mostFor(made, request), ticker);
      Refinement result;
      const bool isDone = refiner.run() && writeRefinement(domain, refiner, ticker, result);
      if (isDone)
      {
        out = std::move(result);
      }
      return isDone;
    });
}

} // namespace ahd
