// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentWalk.h"

#include "../Predicates/Predicates.h"

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

/// Turns around `from`, from an edge on one side of the way until an edge lies on it or on the
/// other side: less than half a turn, and never across infinity. Leaves `way` as it is if that
/// takes more steps. Returns false if the caller wants to cancel.
///
///          left
///         /    \          the way leaves by the edge between right and left
///     from --- right
bool SegmentWalk::findWayOut(Index from, Index to, std::size_t mostSteps, WayOut& way)
{
  int side = 0;
  Mesh::Halfedge out = firstToOneSide(from, to, side);
  if (side == 0)
  {
    way.edge = out;
    return true;
  }
  const int begun = side;
  for (std::size_t steps = 0; steps != mostSteps; ++steps)
  {
    const Mesh::Halfedge following = begun < 0 ? mesh_.nextAround(out) : mesh_.previousAround(out);
    side = sideOf(from, to, mesh_.destination(following));
    if (side == 0)
    {
      way.edge = following;
      return true;
    }
    if (side != begun)
    {
      way.crossed = Mesh::next(begun < 0 ? out : following);
      return true;
    }
    out = following;
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

/// The way out of one of the two ends, which becomes start_: of a, unless it has so many neighbours
/// that b is sooner done. Returns false if the caller wants to cancel.
bool SegmentWalk::chooseEnd(Index a, Index b, WayOut& way)
{
  for (std::size_t most = 16; !way.isFound(); most *= 2)
  {
    for (const bool fromA : { true, false })
    {
      start_ = fromA ? a : b;
      if (!findWayOut(start_, fromA ? b : a, most, way))
      {
        return false;
      }
      if (way.isFound())
      {
        break;
      }
    }
  }
  return true;
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
    if (mesh_.isConstrained(h))
    {
      blockedBy_ = h;
      if (!goesOn_)
      {
        return Outcome::Blocked;
      }
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
/// none at all: no place needs to be looked at. kNoIndex else.
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
  if (!chooseEnd(a, b, way))
  {
    return Outcome::Cancelled;
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

/// From vertex to vertex on the segment. `way` leads out of the first.
SegmentWalk::Outcome SegmentWalk::walkFrom(Index from, Index end, WayOut way)
{
  pieces_.clear();
  crossed_.clear();
  for (;;)
  {
    if (way.edge != kNoIndex)
    {
      pieces_.push_back({ from, mesh_.destination(way.edge), way.edge, 0, 0 });
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
    way = WayOut();
    if (!ticker_.step() || !findWayOut(from, end, std::size_t(-1), way))
    {
      return Outcome::Cancelled;
    }
  }
}

} // namespace ahd
