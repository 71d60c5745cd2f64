// SPDX-License-Identifier: BSD-3-Clause
//
// Lines and loops: their corners in leaves, the segments beside a part, constraints at the root.
#include "../Core/Border.h"
#include "../Core/SortAsking.h"
#include "../Triangulation/State.h"
#include "TileVisits.h"

#include <algorithm>

namespace ahd
{

void TileVisits::dealCorners()
{
  corners_.resize(plan_.hasLines() ? plan_.leaves() : 0);
  for (const Point& corner : plan_.facts().lines.corners)
  {
    const std::int64_t leaf = plan_.leafOf(corner);
    if (leaf >= 0 && plan_.hasLines())
    {
      corners_[static_cast<std::size_t>(leaf)].push_back(corner);
    }
  }
  for (std::vector<Point>& corners : corners_)
  {
    std::sort(corners.begin(), corners.end(), lexicographicallyLess);
  }
}

/// The vertices of the leaf where segments end.
bool TileVisits::findEnds(std::size_t leaf, Part& part, Ticker& ticker) const
{
  if (corners_.empty() || corners_[leaf].empty())
  {
    return true;
  }
  const std::vector<Point>& corners = corners_[leaf];
  const RankedPoints& ranked = TriangulationAccess::stateOf(part.triangulation())->ranked;
  std::vector<Index> ends;
  const auto look = [&](std::size_t v)
  {
    if (std::binary_search(corners.begin(), corners.end(), ranked.xy[v], lexicographicallyLess))
    {
      ends.push_back(static_cast<Index>(v));
    }
  };
  if (!inSteps(0, ranked.count, ticker, look))
  {
    return false;
  }
  part.setEnds(std::move(ends));
  return true;
}

/// Those that may touch triangles of a part of so many points.
bool TileVisits::joinSegments(
  std::size_t part, std::size_t points, Surroundings& around, Ticker& ticker) const
{
  const Bounds& region = plan_.reach(part);
  std::vector<EndPair> found;
  return (isEmpty(region) || segments_.listIn(region, found, ticker)) &&
    around.segments.build(std::move(found), region, points / 4, ticker);
}

namespace
{

/// Constraints of the points of a part.
struct PlacedLines
{
  std::vector<std::int64_t> ids; ///< numbers of the points, -1 where there is none
  std::vector<std::int64_t> offsets{ 0 };
};

/// The corners of lines are the points at their places. Loops are closed by a corner more: places
/// that are no point's are equal, and would close others. Returns false if cancelled.
bool placeCorners(const TileLines& lines, const std::vector<BorderPoint>& points, Ticker& ticker,
  PlacedLines& placed)
{
  using Place = std::pair<Point, Index>;
  const auto isBefore = [](const Place& a, const Place& b)
  { return lexicographicallyLess(a.first, b.first); };
  std::vector<Place> places;
  const auto add = [&](std::size_t i)
  {
    if ((points[i].marks & BorderPoint::kEndOfSegment) != 0)
    {
      places.emplace_back(points[i].at, static_cast<Index>(i));
    }
  };
  if (!inSteps(0, points.size(), ticker, add) || !sortAsking(places, ticker, isBefore))
  {
    return false;
  }
  const auto put = [&](std::size_t k)
  {
    const auto at = std::lower_bound(
      places.begin(), places.end(), Place{ lines.corners[k], 0 }, isBefore);
    const bool isThere = at != places.end() && at->first == lines.corners[k];
    placed.ids.push_back(isThere ? std::int64_t(at->second) : -1);
  };
  for (std::size_t chain = 0; chain != lines.chains(); ++chain)
  {
    const auto begin = static_cast<std::size_t>(lines.offsets[chain]);
    const auto end = static_cast<std::size_t>(lines.offsets[chain + 1]);
    const bool isOpen = end > begin + 1 && !(lines.corners[begin] == lines.corners[end - 1]);
    if (!inSteps(begin, end, ticker, put))
    {
      return false;
    }
    if (chain >= lines.lines && isOpen)
    {
      put(begin);
    }
    placed.offsets.push_back(static_cast<std::int64_t>(placed.ids.size()));
  }
  return true;
}

} // namespace

Status TileVisits::constrain(Part& part, const Context& context) const
{
  const TileLines& lines = plan_.facts().lines;
  PlacedLines placed;
  const Status found = unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      return !plan_.hasLines() || placeCorners(lines, part.given(), ticker, placed);
    });
  const ConstraintView view{ placed.ids.data(), placed.offsets.data(), lines.chains(),
    static_cast<std::size_t>(lines.lines) };
  return found != Status::Ok || !plan_.hasLines()
    ? found
    : part.constrain(view, FillRule(lines.rule), context);
}

} // namespace ahd
