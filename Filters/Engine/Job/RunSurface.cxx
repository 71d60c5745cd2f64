// SPDX-License-Identifier: BSD-3-Clause
//
// A surface given by its triangles; the implementation of Run::findSurface.
#include "../Core/Border.h"
#include "Run.h"

#include <utility>

namespace ahd
{
namespace
{

/// Calls with each edge that must become a constraint: all of missing triangles, and those that the
/// caller names. Returns false if cancelled.
template <typename Call>
bool forEdges(const GivenTriangles& given, const std::vector<std::size_t>& missing,
  const Context& context, const Call& call)
{
  Ticker ticker(context.progress, Phase::Constrain, 0);
  for (const std::size_t triangle : missing)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      call(triangle, k);
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  for (std::size_t triangle = 0; given.edges && triangle < given.count; ++triangle)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if ((given.edges[triangle] >> k & 1u) != 0)
      {
        call(triangle, k);
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return ticker.ask();
}

Status find(
  const GivenTriangles& given, const Context& context, RunResult& made, FoundTriangles& found)
{
  return given.ids32 ? findTriangles(made.triangulation, given.ids32, given.count, context, found)
                     : findTriangles(made.triangulation, given.ids64, given.count, context, found);
}

} // namespace

/// Their number, and their memory, is known only here.
Status Run::constrainEdges(const std::vector<std::size_t>& missing, RunResult& made)
{
  std::size_t count = 0;
  std::vector<std::int64_t> ends, offsets;
  const auto fill = [&]
  {
    ends.reserve(2 * count);
    offsets.assign(1, 0);
    offsets.reserve(count + 1);
    return forEdges(surface_, missing, context_,
      [&](std::size_t triangle, std::size_t k)
      {
        ends.push_back(surface_.corner(triangle, k));
        ends.push_back(surface_.corner(triangle, (k + 1) % 3));
        offsets.push_back(static_cast<std::int64_t>(ends.size()));
      });
  };
  if (!forEdges(surface_, missing, context_, [&count](std::size_t, std::size_t) { ++count; }))
  {
    return Status::Cancelled;
  }
  report_.surfaceEdges = count;
  report_.estimate = estimate();
  report_.isRefused = count > 0 && !fits();
  if (count == 0 || report_.isRefused)
  {
    return count == 0 ? Status::Ok : Status::OutOfMemory;
  }
  const Status status = unlessCancelled(fill);
  return status != Status::Ok
    ? status
    : withAsking(report_.askedToConstrain,
        [&]
        {
          const ConstraintView edges{ ends.data(), offsets.data(), count, count };
          return ahd::constrain(std::move(made.triangulation), edges, FillRule::Orientation,
            context_, made.triangulation);
        });
}

/// The constraints that the caller names have all triangles mostly. They do not where edges that
/// are no constraints bound what was left of a surface, and beyond them there were constraints.
Status Run::findSurface(RunResult& made)
{
  if (surface_.count == 0)
  {
    return Status::Ok;
  }
  FoundTriangles found;
  Status status = constrainEdges({}, made);
  status = status != Status::Ok ? status : find(surface_, context_, made, found);
  if (status == Status::Ok && !found.missing.empty())
  {
    if (report_.surfaceEdges > 0) // constrain() takes a triangulation without constraints
    {
      status = ahd::triangulate(
        made.points.points(), settings_.options, workspace_, context_, made.triangulation);
      status = status != Status::Ok ? status : find(surface_, context_, made, found);
    }
    const std::vector<std::size_t> missing = std::move(found.missing);
    status = status != Status::Ok ? status : constrainEdges(missing, made);
    status = status != Status::Ok ? status : find(surface_, context_, made, found);
  }
  if (status == Status::Ok)
  {
    report_.foldedTriangles = found.missing.size();
    made.selection.kept = std::move(found.kept);
    made.selection.keptCount = found.keptCount;
  }
  return end(status);
}

} // namespace ahd
