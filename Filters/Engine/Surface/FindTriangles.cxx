// SPDX-License-Identifier: BSD-3-Clause
#include "FindTriangles.h"

#include "../Core/Border.h"
#include "../Core/Progress.h"
#include "../Triangulation/Triangulation.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ahd
{
namespace
{

using Corners = std::array<Index, 3>;

/// A walk around one corner of the triangle to find.
struct Turn
{
  HalfEdge first;
  HalfEdge now;
  Index second; ///< the corner that follows, and the one behind that
  Index third;
};

/// Walks around all corners at the same time, so that the one of least degree ends the search. Sets
/// `at` to the half-edge of the first corner's triangle, kNoHalfEdge if there is none. Returns
/// false if the work is cancelled.
bool find(const Triangulation& triangulation, const Corners& corners, Ticker& ticker, HalfEdge& at)
{
  std::array<Turn, 3> turns;
  at = kNoHalfEdge;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const HalfEdge start = triangulation.start(corners[k]);
    turns[k] = { start, start, corners[(k + 1) % 3], corners[(k + 2) % 3] };
  }
  while (ticker.step())
  {
    for (Turn& turn : turns)
    {
      if (turn.now == kNoHalfEdge)
      {
        return true;
      }
      if (triangulation.target(turn.now) == turn.second &&
        triangulation.origin(previousInTriangle(turn.now)) == turn.third)
      {
        at = turn.now;
        return true;
      }
      turn.now = triangulation.nextAround(turn.now);
      turn.now = turn.now == turn.first ? kNoHalfEdge : turn.now;
    }
  }
  return false;
}

/// The vertices at its corners. Returns false if one is none.
template <typename Id>
bool readCorners(const Triangulation& triangulation, const Id* ids, Corners& corners)
{
  const std::size_t points = triangulation.points().count;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const bool isPoint = ids[k] >= 0 && static_cast<std::uint64_t>(ids[k]) < points;
    corners[k] = isPoint ? triangulation.vertexOf(static_cast<std::size_t>(ids[k])) : kNoIndex;
    if (corners[k] == kNoIndex)
    {
      return false;
    }
  }
  return true;
}

template <typename Id>
bool findAll(const Triangulation& triangulation, const Id* ids, std::size_t count, Ticker& ticker,
  FoundTriangles& found)
{
  found = FoundTriangles();
  found.kept.resize(triangulation.triangleCount());
  for (std::size_t i = 0; i < count; ++i)
  {
    Corners corners = {};
    HalfEdge at = kNoHalfEdge;
    if (readCorners(triangulation, ids + 3 * i, corners) &&
      !find(triangulation, corners, ticker, at))
    {
      return false;
    }
    if (at == kNoHalfEdge)
    {
      found.missing.push_back(i);
    }
    else if (found.kept[at / 3] == 0)
    {
      found.kept[at / 3] = 1;
      ++found.keptCount;
    }
    ticker.finished(1);
    if (!ticker.step())
    {
      return false;
    }
  }
  return ticker.ask();
}

} // namespace

Status markOthers(const GivenTriangles& given, std::size_t points, unsigned char mark,
  unsigned char* marks, const Context& context)
{
  Ticker ticker(context.progress, Phase::Read, given.count, context.executor);
  std::fill_n(marks, points, mark);
  for (std::size_t i = 0; i < given.count; ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t id = given.corner(i, k);
      if (id >= 0 && static_cast<std::uint64_t>(id) < points)
      {
        marks[id] = 0;
      }
    }
    if (!ticker.step())
    {
      return Status::Cancelled;
    }
  }
  return Status::Ok;
}

template <typename Id>
Status findTriangles(Triangulation& triangulation, const Id* ids, std::size_t count,
  const Context& context, FoundTriangles& found)
{
  for (const auto make : { &Triangulation::makeNeighbors, &Triangulation::makePointMap })
  {
    const Status status = (triangulation.*make)(context);
    if (status != Status::Ok)
    {
      return status;
    }
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, count, context.executor);
      return findAll(std::as_const(triangulation), ids, count, ticker, found);
    });
}

template Status findTriangles(
  Triangulation&, const std::int32_t*, std::size_t, const Context&, FoundTriangles&);
template Status findTriangles(
  Triangulation&, const std::int64_t*, std::size_t, const Context&, FoundTriangles&);

} // namespace ahd
