// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentWalk.h"

#include "../Predicates/Predicates.h"

namespace ahd
{

/// Looks for the edge a-b around both ends in turn, so that a vertex of very many edges costs no
/// more than the other end has. Leaves edge_ as the half-edge from a to b or kNoIndex, and start_
/// as the end around which the search ended. Returns false if the caller wants to cancel.
bool SegmentWalk::findEdge(Index a, Index b)
{
  const Mesh::Halfedge firstA = mesh_.outgoing(a);
  const Mesh::Halfedge firstB = mesh_.outgoing(b);
  Mesh::Halfedge fromA = firstA, fromB = firstB;
  edge_ = kNoIndex;
  do
  {
    if (mesh_.destination(fromA) == b)
    {
      start_ = a;
      edge_ = fromA;
      return true;
    }
    if (mesh_.destination(fromB) == a)
    {
      start_ = a;
      edge_ = mesh_.twin(fromB);
      return true;
    }
    fromA = mesh_.nextAround(fromA);
    fromB = mesh_.nextAround(fromB);
    if (!ticker_.step())
    {
      return false;
    }
  } while (fromA != firstA && fromB != firstB);
  start_ = fromA == firstA ? a : b;
  return true;
}

/// Does v, which lies on the line from -> to, lie on the same side of `from` as `to`?
bool SegmentWalk::isAhead(Index from, Index to, Index v) const
{
  return lexicographicallyLess(mesh_.at(from), mesh_.at(to)) ==
    lexicographicallyLess(mesh_.at(from), mesh_.at(v));
}

/// The triangle around `from` through which the way to `to` leaves, or the edge along which it
/// does. Leaves edge_ or wayOut_ (the edge opposite to `from` that is crossed). Returns false if
/// the caller wants to cancel. REQUIRES: neither is outside the hull.
bool SegmentWalk::findWayOut(Index from, Index to)
{
  const Point& p = mesh_.at(from);
  const Point& q = mesh_.at(to);
  const auto side = [&](Index v) {
    return v == mesh_.ghost() ? -2 : v == to ? 0 : orient2d(p, q, mesh_.at(v));
  };
  edge_ = kNoIndex;
  wayOut_ = kNoIndex;
  //        left              `out` runs from `from` to `right`; the way lies between right and
  //       /    \             left where right is on its right and left on its left
  //    from --- right
  Mesh::Halfedge out = mesh_.outgoing(from);
  int right = side(mesh_.destination(out));
  for (;;)
  {
    if (right == 0 && isAhead(from, to, mesh_.destination(out)))
    {
      edge_ = out;
      return true;
    }
    const Mesh::Halfedge following = mesh_.nextAround(out);
    const int left = side(mesh_.destination(following));
    if (right == -1 && left == 1)
    {
      wayOut_ = Mesh::next(out);
      return true;
    }
    out = following;
    right = left;
    if (!ticker_.step())
    {
      return false;
    }
  }
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
      return Outcome::Blocked;
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

SegmentWalk::Outcome SegmentWalk::walk(Index a, Index b)
{
  pieces_.clear();
  crossed_.clear();
  if (!findEdge(a, b))
  {
    return Outcome::Cancelled;
  }
  if (edge_ != kNoIndex)
  {
    pieces_.push_back({ a, b, edge_, 0, 0 });
    return Outcome::Free;
  }
  const Index end = start_ == a ? b : a;
  for (Index from = start_; from != end; from = pieces_.back().to)
  {
    if (!findWayOut(from, end))
    {
      return Outcome::Cancelled;
    }
    if (edge_ != kNoIndex)
    {
      pieces_.push_back({ from, mesh_.destination(edge_), edge_, 0, 0 });
      continue;
    }
    if (const Outcome outcome = cross(from, end, wayOut_); outcome != Outcome::Free)
    {
      return outcome;
    }
  }
  return Outcome::Free;
}

} // namespace ahd
