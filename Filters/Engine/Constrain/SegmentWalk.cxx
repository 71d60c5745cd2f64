// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentWalk.h"

#include "../Predicates/Predicates.h"

#include <algorithm>
#include <array>

namespace ahd
{

/// Does v, which lies on the line from -> to, lie on the same side of `from` as `to`?
bool SegmentWalk::isAhead(Index from, Index to, Index v) const
{
  return lexicographicallyLess(mesh_.at(from), mesh_.at(to)) ==
    lexicographicallyLess(mesh_.at(from), mesh_.at(v));
}

/// +1 if v is on the left of the way, -1 on the right, 0 on its line.
int SegmentWalk::sideOf(Index from, Index to, Index v) const
{
  return v == to ? 0 : orient2d(mesh_.at(from), mesh_.at(to), mesh_.at(v));
}

/// An edge from `from` that lies along the way (side 0) or truly on one side of it: neither to
/// infinity nor in the opposite direction. Two neighbouring edges are never both of these, and
/// three never all.
Mesh::Halfedge SegmentWalk::firstToOneSide(Index from, Index to, int& side) const
{
  Mesh::Halfedge out = mesh_.outgoing(from);
  for (;; out = mesh_.nextAround(out))
  {
    const Index v = mesh_.destination(out);
    if (v != mesh_.ghost())
    {
      side = sideOf(from, to, v);
      if (side != 0 || isAhead(from, to, v))
      {
        return out;
      }
    }
  }
}

/// Takes one step around `from`, towards the way: less than half a turn, and never across infinity.
///
///          left
///         /    \          the way leaves by the edge between right and left
///     from --- right
bool SegmentWalk::isFoundNext(Turn& turn, Index from, Index to, WayOut& way) const
{
  const bool isRight = turn.side < 0;
  const Mesh::Halfedge following = isRight ? mesh_.nextAround(turn.out)
                                           : mesh_.previousAround(turn.out);
  const int side = sideOf(from, to, mesh_.destination(following));
  if (side == 0)
  {
    way.edge = following;
  }
  else if (side != turn.side)
  {
    way.crossed = Mesh::next(isRight ? turn.out : following);
  }
  turn.out = following;
  return way.isFound();
}

/// Turns around `from`, from an edge on one side of the way until an edge lies on it or on the
/// other side. Leaves `way` as it is if that takes more steps, and if these are few. Returns Free,
/// Beyond or Cancelled.
SegmentWalk::Outcome SegmentWalk::findWayOut(
  Index from, Index to, std::size_t mostSteps, WayOut& way)
{
  constexpr std::size_t kMany = 64;
  Turn turn{ kNoIndex, 0 };
  turn.out = firstToOneSide(from, to, turn.side);
  if (turn.side == 0)
  {
    way.edge = turn.out;
    return Outcome::Free;
  }
  for (std::size_t steps = 0; steps != std::min(mostSteps, kMany); ++steps)
  {
    if (isFoundNext(turn, from, to, way))
    {
      return Outcome::Free;
    }
    if (!ticker_.step())
    {
      return Outcome::Cancelled;
    }
  }
  if (mostSteps <= kMany)
  {
    return Outcome::Free;
  }
  if (isLimited()) // fans are looked for from the neighbours
  {
    return Outcome::Beyond;
  }
  return turnFromFans(from, to, way) ? Outcome::Free : Outcome::Cancelled;
}

/// The same where it takes many steps, from the nearest edges that are remembered on both sides at
/// a time: so the cost is that to the nearer one. The result is remembered.
bool SegmentWalk::turnFromFans(Index from, Index to, WayOut& way)
{
  std::array<Turn, 3> turns{};
  std::size_t count = 1;
  turns[0].out = firstToOneSide(from, to, turns[0].side);
  for (const Mesh::Halfedge edge : fans_.find(from, to))
  {
    if (edge == kNoIndex)
    {
      continue;
    }
    const Index v = mesh_.destination(edge);
    const int side = sideOf(from, to, v);
    if (side != 0)
    {
      turns[count++] = { edge, side };
    }
    else if (v == to || isAhead(from, to, v))
    {
      way.edge = edge;
      return true;
    }
  }
  for (std::size_t k = 0; !isFoundNext(turns[k], from, to, way); k = k + 1 == count ? 0 : k + 1)
  {
    if (!ticker_.step())
    {
      return false;
    }
  }
  fans_.remember(
    from, way.edge != kNoIndex ? mesh_.destination(way.edge) : mesh_.origin(way.crossed));
  return true;
}

/// The way out of one of the two ends, which becomes start_: of a, unless it has so many neighbours
/// that b is faster. Returns Free, Beyond or Cancelled.
SegmentWalk::Outcome SegmentWalk::chooseEnd(Index a, Index b, WayOut& way)
{
  for (std::size_t most = 16; !way.isFound(); most *= 2)
  {
    for (const bool fromA : { true, false })
    {
      start_ = fromA ? a : b;
      const Outcome outcome = findWayOut(start_, fromA ? b : a, most, way);
      if (outcome != Outcome::Free || way.isFound())
      {
        return outcome;
      }
    }
  }
  return Outcome::Free;
}

/// From triangle to triangle, from the edge `first` opposite to `from` to a vertex on the segment.
SegmentWalk::Outcome SegmentWalk::cross(Index from, Index to, Mesh::Halfedge first)
{
  const Point& p = mesh_.at(from);
  const Point& q = mesh_.at(to);
  const std::size_t begin = crossed_.size();
  Mesh::Halfedge h = first;
  for (;;)
  {
    if (!ticker_.step())
    {
      return Outcome::Cancelled;
    }
    if (!isOwn(mesh_.origin(h)) || !isOwn(mesh_.destination(h)))
    {
      return Outcome::Beyond;
    }
    if (mesh_.isConstrained(h))
    {
      blockedBy_ = h;
      if (!goesOn_)
      {
        return Outcome::Blocked;
      }
    }
    if (crossed_.size() == mostCrossed_)
    {
      return Outcome::Long;
    }
    crossed_.push_back(h);
    //       left             the twin runs from left to right; ahead of it is the apex
    //      / ^   \           .
    //  -----h|----apex
    //      \ |   /
    //       right
    const Mesh::Halfedge ahead = mesh_.twin(h);
    const Index apex = mesh_.apex(ahead);
    const int side = apex == to ? 0 : orient2d(p, q, mesh_.at(apex));
    if (side == 0)
    {
      pieces_.push_back({ from, apex, kNoIndex, begin, crossed_.size() });
      return Outcome::Free;
    }
    h = side > 0 ? Mesh::next(ahead) : Mesh::previous(ahead);
  }
}

/// The edge from one vertex to another, if it is one of the first few around the vertex or there is
/// none at all: needs no coordinates. kNoIndex else.
Mesh::Halfedge SegmentWalk::edgeNearby(Index from, Index to) const
{
  constexpr int kMost = 8;
  const Mesh::Halfedge first = mesh_.outgoing(from);
  Mesh::Halfedge out = first;
  for (int steps = 0; steps != kMost; ++steps)
  {
    if (mesh_.destination(out) == to)
    {
      return out;
    }
    out = mesh_.nextAround(out);
    if (out == first)
    {
      break;
    }
  }
  return kNoIndex;
}

SegmentWalk::Outcome SegmentWalk::walk(Index a, Index b)
{
  if (const Mesh::Halfedge edge = edgeNearby(a, b); edge != kNoIndex)
  {
    start_ = a;
    crossed_.clear();
    pieces_.assign(1, { a, b, edge, 0, 0 });
    return Outcome::Free;
  }
  WayOut way;
  if (const Outcome outcome = chooseEnd(a, b, way); outcome != Outcome::Free)
  {
    return outcome;
  }
  const Index end = start_ == a ? b : a;
  goesOn_ = false;
  Outcome outcome = walkFrom(start_, end, way);
  if (outcome == Outcome::Blocked && start_ == b)
  {
    // What blocks it last on the way from b is the first from a.
    goesOn_ = true;
    outcome = walkFrom(b, a, way);
    return outcome == Outcome::Free ? Outcome::Blocked : outcome;
  }
  return outcome;
}

SegmentWalk::Outcome SegmentWalk::walkAcross(Index a, Index b)
{
  WayOut way;
  if (const Outcome outcome = chooseEnd(a, b, way); outcome != Outcome::Free)
  {
    return outcome;
  }
  goesOn_ = true;
  return walkFrom(start_, start_ == a ? b : a, way);
}

/// From vertex to vertex on the segment. `way` leads out of the first.
SegmentWalk::Outcome SegmentWalk::walkFrom(Index from, Index end, WayOut way)
{
  pieces_.clear();
  crossed_.clear();
  for (;;)
  {
    if (way.edge != kNoIndex)
    {
      const Index next = rows_ == nullptr ? mesh_.destination(way.edge)
                                          : rows_->ahead(from, way.edge, end);
      pieces_.push_back({ from, next, way.edge, 0, 0 });
    }
    else if (const Outcome outcome = cross(from, end, way.crossed); outcome != Outcome::Free)
    {
      return outcome;
    }
    from = pieces_.back().to;
    if (from == end)
    {
      return Outcome::Free;
    }
    if (!isOwn(from))
    {
      return Outcome::Beyond;
    }
    way = WayOut();
    if (!ticker_.step())
    {
      return Outcome::Cancelled;
    }
    const Outcome outcome = findWayOut(from, end, std::size_t(-1), way);
    if (outcome != Outcome::Free)
    {
      return outcome;
    }
  }
}

} // namespace ahd
