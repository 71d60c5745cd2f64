// SPDX-License-Identifier: BSD-3-Clause
#include "BlockState.h"

#include "../Core/Border.h"
#include "../Core/SortAsking.h"

#include <algorithm>
#include <utility>

namespace ahd
{

/// The vertices of this block where segments end, and their data for all blocks.
bool BlockTriangulation::State::findOwnEnds(
  std::vector<Index>& vertices, std::vector<ChainEnd>& found, Ticker& ticker)
{
  const ConstraintView& given = input.constraints;
  const std::size_t places = constraintIds(given);
  const std::int64_t* const ids = places == 0 ? nullptr : given.ids + given.offsets[0];
  const std::int64_t* const begin = input.ids;
  const std::int64_t* const end = begin + input.points.count;
  TriangulationAccess::State& made = *TriangulationAccess::stateOf(own().triangulation());
  for (std::size_t i = 0; i != places && begin != end; ++i)
  {
    const std::int64_t* const at = std::lower_bound(begin, end, ids[i]);
    if (at != end && *at == ids[i])
    {
      if (!made.hasPointMap && !made.makePointMap(ticker))
      {
        return false;
      }
      const Index vertex = made.tables.vertexOf[static_cast<std::size_t>(at - begin)];
      if (vertex != kNoIndex)
      {
        vertices.push_back(vertex);
        found.push_back({ i, made.ranked.xy[vertex], begin[made.ranked.id[vertex]] });
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// The segments that may touch triangles of a row, of which so many points are triangulated;
/// segments without a length cut nothing.
bool BlockTriangulation::State::joinSegments(
  const BlockRow& row, std::size_t points, Ticker& ticker)
{
  const Bounds region = around.boxes.boundsOf(row);
  const ConstraintView& given = input.constraints;
  std::vector<EndPair> pairs;
  for (std::size_t chain = 0; chain != given.chains; ++chain)
  {
    const auto first = static_cast<std::size_t>(given.offsets[chain] - given.offsets[0]);
    const auto count = static_cast<std::size_t>(given.offsets[chain + 1] - given.offsets[chain]);
    const std::size_t segments = segmentsOf(given, chain);
    for (std::size_t i = 0; i != segments; ++i)
    {
      const ChainEnd& from = ends[first + i];
      const ChainEnd& to = ends[first + (i + 1 == count ? 0 : i + 1)];
      const EndPair pair{ from.at, to.at };
      if (from.vertex >= 0 && to.vertex >= 0 && from.vertex != to.vertex &&
        SegmentTree::reaches(pair, region))
      {
        pairs.push_back(pair);
      }
      if (!ticker.step())
      {
        return false;
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return around.segments.build(std::move(pairs), region, points / 4, ticker);
}

/// Of each id of the constraints its place among the points of all blocks' part, -1 if it has none.
bool BlockTriangulation::State::placeEnds(std::vector<std::int64_t>& placeOf, Ticker& ticker)
{
  using Place = std::pair<std::int64_t, Index>;
  const std::vector<BorderPoint>& given = parts[level].given();
  std::vector<Place> places;
  const auto add = [&](std::size_t i)
  {
    if ((given[i].marks & BorderPoint::kEndOfSegment) != 0)
    {
      places.emplace_back(given[i].id, static_cast<Index>(i));
    }
  };
  if (!inSteps(0, given.size(), ticker, add) ||
    !sortAsking(places, ticker, [](const Place& a, const Place& b) { return a.first < b.first; }))
  {
    return false;
  }
  placeOf.reserve(ends.size());
  const auto find = [&](std::size_t i)
  {
    const ChainEnd& end = ends[i];
    const auto found = std::lower_bound(places.begin(), places.end(), end.vertex,
      [](const Place& place, std::int64_t id) { return place.first < id; });
    const bool isThere = end.vertex >= 0 && found != places.end() && found->first == end.vertex;
    placeOf.push_back(isThere ? std::int64_t(found->second) : -1);
  };
  return inSteps(0, ends.size(), ticker, find);
}

/// The constraints, their ids as places among the points. Loops that are closed by a segment more
/// are closed by an id more: other ids than before may be equal now.
bool BlockTriangulation::State::placeConstraints(
  std::vector<std::int64_t>& ids, std::vector<std::int64_t>& offsets, Ticker& ticker)
{
  const ConstraintView& given = input.constraints;
  std::vector<std::int64_t> placeOf;
  if (!placeEnds(placeOf, ticker))
  {
    return false;
  }
  ids.reserve(placeOf.size() + given.chains);
  offsets.reserve(given.chains + 1);
  offsets.push_back(0);
  for (std::size_t chain = 0; chain != given.chains; ++chain)
  {
    const auto first = static_cast<std::size_t>(given.offsets[chain] - given.offsets[0]);
    const auto end = static_cast<std::size_t>(given.offsets[chain + 1] - given.offsets[0]);
    const auto copy = [&](std::size_t from, std::size_t to)
    { ids.insert(ids.end(), placeOf.data() + from, placeOf.data() + to); };
    if (!inChunks(first, end, ticker, copy) || !ticker.step())
    {
      return false;
    }
    if (end != first && segmentsOf(given, chain) == end - first)
    {
      ids.push_back(placeOf[first]);
    }
    offsets.push_back(static_cast<std::int64_t>(ids.size()));
  }
  return true;
}

Status BlockTriangulation::State::constrainAll(const Context& context)
{
  isHostOfAll = true;
  if (input.constraints.chains == 0)
  {
    return Status::Ok;
  }
  std::vector<std::int64_t> ids, offsets;
  Status status = unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      return placeConstraints(ids, offsets, ticker);
    });
  if (status == Status::Ok)
  {
    ConstraintView placed = input.constraints;
    placed.ids = ids.data();
    placed.offsets = offsets.data();
    status = parts[level].constrain(placed, input.rule, context);
  }
  if (status == Status::Ok)
  {
    report.constraints = parts[level].triangulation().constraints();
  }
  return status;
}

} // namespace ahd
