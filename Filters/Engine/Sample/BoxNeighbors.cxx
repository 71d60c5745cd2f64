// SPDX-License-Identifier: BSD-3-Clause
#include "BoxNeighbors.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/Progress.h"
#include "../Order/Quantise.h"
#include "../Order/Rank.h"
#include "../Points/JoinedBounds.h"
#include "../Predicates/Discs.h"
#include "../Predicates/Distances.h"
#include "../Predicates/Predicates.h"
#include "../Triangulation/Locate.h"
#include "../Triangulation/State.h"
#include "NearestSeen.h"

#include <algorithm>
#include <limits>

namespace ahd
{

namespace
{

using State = TriangulationAccess::State;

/// What a test of a disc against boxes counts, beside one for each box.
constexpr std::size_t kStepsOfDisc = 4;

/// Goes from triangle to triangle that meets a box.
///
/// It begins at those that a corner of a box lies in, and next to edges of the hull that a box lies
/// beyond. All others that meet one are reached from there. For let p be a place in a box: what an
/// insertion of p would remove is connected, has p in its closed discs or beyond its edges of the
/// hull, and has what p lies in. On the straight way from the corner of the box to p, which does
/// not leave the box, what contains the place changes to what is next to it, or around a vertex
/// there.
class BoxSearch
{
public:
  /// Throws std::bad_alloc, as all below.
  BoxSearch(const State& part, const std::vector<Bounds>& boxes)
    : tables_(part.tables)
    , places_(part.ranked.xy.data())
    , boxes_(boxes)
    , isFound_(part.ranked.count, 0)
    , isSeen_(part.allTriangles, 0)
  {
  }

  /// Returns false if cancelled.
  bool run(Ticker& ticker) { return beginAtCorners(ticker) && beginAtHull(ticker) && go(ticker); }

  const std::vector<unsigned char>& found() const { return isFound_; }

private:
  bool beginAtCorners(Ticker& ticker)
  {
    const Locator locator(tables_, places_);
    std::size_t hint = 0;
    for (const Bounds& box : boxes_)
    {
      if (isEmpty(box))
      {
        continue;
      }
      const Location at = locator.locate({ box.xmin, box.ymin }, hint, tables_.triangles(), ticker);
      if (at.kind == Location::Nowhere)
      {
        return false;
      }
      hint = at.halfEdge / 3;
      todo_.push_back(hint); // if outside, it may not meet the box, which ends there
    }
    return true;
  }

  bool beginAtHull(Ticker& ticker)
  {
    for (std::size_t h = 0; h != tables_.twins.size(); ++h)
    {
      const bool isHull = tables_.twins[h] == kNoHalfEdge;
      if (isHull && isBeyond(static_cast<HalfEdge>(h)))
      {
        isFound_[tables_.origin(static_cast<HalfEdge>(h))] = 1;
        isFound_[tables_.target(static_cast<HalfEdge>(h))] = 1;
        todo_.push_back(h / 3);
      }
      if (!ticker.step() || (isHull && !stepForBoxes(ticker)))
      {
        return false;
      }
    }
    return true;
  }

  bool go(Ticker& ticker)
  {
    while (!todo_.empty())
    {
      const std::size_t triangle = todo_.back();
      todo_.pop_back();
      if (isSeen_[triangle] == 0)
      {
        isSeen_[triangle] = 1;
        visit(triangle);
        if (!stepForBoxes(ticker))
        {
          return false;
        }
      }
      if (!ticker.step())
      {
        return false;
      }
    }
    return true;
  }

  void visit(std::size_t triangle)
  {
    const Index* const v = tables_.corners.data() + 3 * triangle;
    const Corners corners{ places_[v[0]], places_[v[1]], places_[v[2]] };
    const Circumdisc disc(corners);
    const auto meets = [&disc](const Bounds& box) { return !isEmpty(box) && disc.meets(box); };
    if (std::none_of(boxes_.begin(), boxes_.end(), meets))
    {
      return;
    }
    for (unsigned k = 0; k != 3; ++k)
    {
      isFound_[v[k]] = 1;
      const HalfEdge twin = tables_.twins[3 * triangle + k];
      if (twin != kNoHalfEdge)
      {
        todo_.push_back(twin / 3);
      }
    }
  }

  /// Is a place of a box on the line of an edge of the hull, or beyond it?
  bool isBeyond(HalfEdge h) const
  {
    const Point a = places_[tables_.origin(h)], b = places_[tables_.target(h)];
    const auto isBeyondOf = [&a, &b](const Bounds& box)
    {
      return !isEmpty(box) &&
        (orient2d(a, b, { box.xmin, box.ymin }) <= 0 ||
          orient2d(a, b, { box.xmax, box.ymin }) <= 0 ||
          orient2d(a, b, { box.xmin, box.ymax }) <= 0 ||
          orient2d(a, b, { box.xmax, box.ymax }) <= 0);
    };
    return std::any_of(boxes_.begin(), boxes_.end(), isBeyondOf);
  }

  bool stepForBoxes(Ticker& ticker) const
  {
    constexpr std::size_t kAtOnce = 1024;
    for (std::size_t k = 0; k < boxes_.size(); k += kAtOnce)
    {
      if (!ticker.step(kStepsOfDisc * std::min(kAtOnce, boxes_.size() - k)))
      {
        return false;
      }
    }
    return true;
  }

  const Tables& tables_;
  const Point* places_;
  const std::vector<Bounds>& boxes_;
  std::vector<unsigned char> isFound_; ///< of each vertex
  std::vector<unsigned char> isSeen_;  ///< of each triangle
  std::vector<std::size_t> todo_;
};

/// Ids of the vertices that have a mark, of all if `marks` is null; false if cancelled.
bool listIds(const State& part, const std::vector<unsigned char>* marks, Ticker& ticker,
  std::vector<Index>& ids)
{
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t v = a; v != b; ++v)
    {
      if (!marks || (*marks)[v] != 0)
      {
        ids.push_back(part.ranked.id[v]);
      }
    }
  };
  if (!inChunks(0, part.ranked.count, ticker, list))
  {
    return false;
  }
  std::sort(ids.begin(), ids.end());
  return ticker.ask();
}

/// work(state, ticker) for a part that has points, with its neighbours.
template <typename Work>
Status withNeighbors(Triangulation& part, const Context& context, const Work& work)
{
  const Status status = part.makeNeighbors(context);
  return status != Status::Ok
    ? status
    : unlessCancelled(
        [&]
        {
          const State* state = TriangulationAccess::stateOf(const_cast<const Triangulation&>(part));
          Ticker ticker(context.progress, Phase::Outputs, 0);
          return ticker.ask() && (!state || work(*state, ticker));
        });
}

} // namespace

Status findBoxNeighbors(Triangulation& part, const std::vector<Bounds>& boxes,
  const Context& context, std::vector<Index>& ids)
{
  ids.clear();
  if (std::all_of(boxes.begin(), boxes.end(), isEmpty))
  {
    return Status::Ok;
  }
  return withNeighbors(part, context,
    [&](const State& state, Ticker& ticker)
    {
      if (state.allTriangles == 0)
      {
        return listIds(state, nullptr, ticker, ids);
      }
      BoxSearch search(state, boxes);
      return search.run(ticker) && listIds(state, &search.found(), ticker, ids);
    });
}

namespace
{

/// Marks those of the vertices a, ..., b - 1 that are the first on a side of the bounds.
void markExtremes(const State& part, std::size_t a, std::size_t b, bool (&isMissing)[4],
  std::vector<unsigned char>& marks)
{
  const Bounds& bounds = part.ranked.bounds;
  for (std::size_t v = a; v != b; ++v)
  {
    const Point p = part.ranked.xy[v];
    const bool isAt[4] = { p.x == bounds.xmin, p.x == bounds.xmax, p.y == bounds.ymin,
      p.y == bounds.ymax };
    for (unsigned k = 0; k != 4; ++k)
    {
      marks[v] |= static_cast<unsigned char>(isAt[k] && isMissing[k]);
      isMissing[k] = isMissing[k] && !isAt[k];
    }
  }
}

void markHull(const State& part, std::size_t a, std::size_t b, std::vector<unsigned char>& marks)
{
  const Tables& tables = part.tables;
  for (std::size_t h = a; h != b; ++h)
  {
    if (tables.twins[h] == kNoHalfEdge)
    {
      marks[tables.origin(static_cast<HalfEdge>(h))] = 1;
    }
  }
}

} // namespace

Status findExtremes(
  Triangulation& part, bool allOfHull, const Context& context, std::vector<Index>& ids)
{
  ids.clear();
  return withNeighbors(part, context,
    [&](const State& state, Ticker& ticker)
    {
      if (allOfHull && state.allTriangles == 0)
      {
        return listIds(state, nullptr, ticker, ids);
      }
      std::vector<unsigned char> marks(state.ranked.count, 0);
      bool isMissing[4] = { true, true, true, true };
      const auto lookAtVertices = [&](std::size_t a, std::size_t b)
      { markExtremes(state, a, b, isMissing, marks); };
      const auto lookAtEdges = [&](std::size_t a, std::size_t b) { markHull(state, a, b, marks); };
      return inChunks(0, state.ranked.count, ticker, lookAtVertices) &&
        (!allOfHull || inChunks(0, 3 * state.allTriangles, ticker, lookAtEdges)) &&
        listIds(state, &marks, ticker, ids);
    });
}

Bounds boundsOf(const Triangulation& part)
{
  const State* const state = TriangulationAccess::stateOf(part);
  return state && state->ranked.count != 0 ? state->ranked.bounds : Bounds();
}

std::size_t crowdLimit()
{
  return kTiedByCoordinates;
}

/// Vertices of one column and row follow each other.
Status findCrowd(Triangulation& part, const Context& context, std::size_t& most)
{
  most = 0;
  return withNeighbors(part, context,
    [&](const State& state, Ticker& ticker)
    {
      const Grid grid(state.ranked.bounds);
      std::uint32_t column = 0, row = 0;
      std::size_t count = 0;
      const auto look = [&](std::size_t a, std::size_t b)
      {
        for (std::size_t v = a; v != b; ++v)
        {
          const Point p = state.ranked.xy[v];
          const std::uint32_t c = grid.column(p.x), r = grid.row(p.y);
          count = count != 0 && c == column && r == row ? count + 1 : 1;
          column = c;
          row = r;
          most = std::max(most, count);
        }
      };
      return inChunks(0, state.ranked.count, ticker, look);
    });
}

void growByRounding(const Bounds& all, std::vector<Bounds>& boxes)
{
  for (Bounds& box : boxes)
  {
    if (!isEmpty(box))
    {
      const double by = 2.0 * roundingAt(std::max(isEmpty(all) ? 0.0 : sizeOf(all), sizeOf(box)));
      const auto moved = [](double value, double step)
      {
        constexpr double kMost = std::numeric_limits<double>::max();
        return std::max(-kMost, std::min(value + step, kMost));
      };
      box = { moved(box.xmin, -by), moved(box.xmax, by), moved(box.ymin, -by),
        moved(box.ymax, by) };
    }
  }
}

bool shareBox(const Bounds& all, const Bounds& one, const Bounds& other)
{
  if (isEmpty(all) || isEmpty(one) || isEmpty(other))
  {
    return false;
  }
  const Grid grid(all);
  return grid.column(one.xmin) <= grid.column(other.xmax) &&
    grid.column(other.xmin) <= grid.column(one.xmax) &&
    grid.row(one.ymin) <= grid.row(other.ymax) && grid.row(other.ymin) <= grid.row(one.ymax);
}

} // namespace ahd
