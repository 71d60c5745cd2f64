// SPDX-License-Identifier: BSD-3-Clause
#include "Path.h"

#include "../Core/Progress.h"
#include "../Predicates/Predicates.h"

#include <algorithm>
#include <array>

namespace ahd
{

/// +1 if the vertex lies to the left of the way, -1 to the right, 0 on its line.
int SegmentPath::side(Index vertex) const
{
  return orient2d(from_, to_, surface_.at(vertex));
}

/// Does the place lie to the right of the half-edge, outside of its triangle?
bool SegmentPath::isBeyond(HalfEdge h, const Point& place) const
{
  return orient2d(surface_.at(surface_.origin(h)), surface_.at(surface_.target(h)), place) < 0;
}

/// Does a vertex on the line of the way lie after its begin?
bool SegmentPath::isAhead(Index vertex) const
{
  const Point at = surface_.at(vertex);
  return !(at == from_) && lexicographicallyLess(from_, to_) == lexicographicallyLess(from_, at);
}

bool SegmentPath::find(const Point& from, const Point& to, std::size_t hint)
{
  met_.clear();
  from_ = from;
  to_ = to;
  entered_ = around_ = kNoHalfEdge;
  begin(surface_.locate(from, hint, ticker_));
  while (entered_ != kNoHalfEdge || around_ != kNoHalfEdge)
  {
    if (entered_ != kNoHalfEdge)
    {
      hint_ = entered_ / 3;
      pass(entered_);
    }
    else
    {
      passVertex(around_);
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return !ticker_.cancelled();
}

void SegmentPath::begin(const Location& at)
{
  hint_ = at.halfEdge == kNoHalfEdge ? hint_ : at.halfEdge / 3;
  switch (at.kind)
  {
    case Location::OnVertex:
      around_ = at.halfEdge;
      return;
    case Location::OnEdge:
      return fromEdge(at.halfEdge);
    case Location::InTriangle:
      return fromTriangle(at.halfEdge);
    case Location::Outside:
      return enter(at.halfEdge);
    default:
      return;
  }
}

/// From outside: along the hull edges that face the begin, from one of them on to the one that the
/// way crosses. Those on the left of the way lead on counterclockwise, those on the right
/// clockwise.
void SegmentPath::enter(HalfEdge hull)
{
  HalfEdge h = hull;
  while (isBeyond(h, from_) && ticker_.step())
  {
    const Index left = surface_.origin(h), right = surface_.target(h);
    const int sideOfLeft = side(left), sideOfRight = side(right);
    for (const Index end : { left, right })
    {
      if ((end == left ? sideOfLeft : sideOfRight) == 0)
      {
        return isAhead(end) ? reach(end) : void();
      }
    }
    if (sideOfLeft != sideOfRight)
    {
      const bool faces = sideOfLeft > 0;
      const bool ends = isBeyond(h, to_) ||
        orient2d(surface_.at(left), surface_.at(right), to_) == 0;
      if (faces && !ends)
      {
        met_.push_back({ h, false });
        entered_ = h;
      }
      return;
    }
    h = sideOfLeft > 0 ? surface_.start(right) : previousOnHull(h);
  }
}

/// The hull edge that ends where this one begins.
HalfEdge SegmentPath::previousOnHull(HalfEdge h) const
{
  HalfEdge last = h;
  for (HalfEdge next = h; next != kNoHalfEdge; next = surface_.nextAround(next))
  {
    last = next;
  }
  return previousInTriangle(last);
}

/// From within an edge.
void SegmentPath::fromEdge(HalfEdge h)
{
  const Index origin = surface_.origin(h), target = surface_.target(h);
  const int sideOfTo = orient2d(surface_.at(origin), surface_.at(target), to_);
  if (sideOfTo == 0)
  {
    return reach(isAhead(origin) ? origin : target);
  }
  entered_ = sideOfTo > 0 ? h : surface_.twin(h);
}

/// From within a triangle, whose first half-edge is given.
void SegmentPath::fromTriangle(HalfEdge first)
{
  for (HalfEdge h = first; h != first + 3; ++h)
  {
    const int sideOfOrigin = side(surface_.origin(h));
    if (sideOfOrigin == 0 && isAhead(surface_.origin(h)))
    {
      return reach(surface_.origin(h));
    }
    if (sideOfOrigin < 0 && side(surface_.target(h)) > 0)
    {
      return leave(h);
    }
  }
}

/// On through the triangle to the left of a half-edge that was crossed: its origin lies to the left
/// of the way, its target to the right.
void SegmentPath::pass(HalfEdge entered)
{
  entered_ = kNoHalfEdge;
  const HalfEdge right = nextInTriangle(entered), left = previousInTriangle(entered);
  const Index apex = surface_.origin(left);
  const int sideOfApex = side(apex);
  sideOfApex == 0 ? reach(apex) : leave(sideOfApex > 0 ? right : left);
}

/// From the vertex at which `first` is start(): into a triangle or along an edge, or outwards,
/// where the way ends.
void SegmentPath::passVertex(HalfEdge first)
{
  constexpr std::size_t kMany = 32;
  HalfEdge out = first;
  for (std::size_t k = 0; k < kMany && out != kNoHalfEdge; ++k)
  {
    if (turn(out))
    {
      return;
    }
    out = surface_.nextAround(out);
    out = out == first || !ticker_.step() ? kNoHalfEdge : out;
  }
  if (out == kNoHalfEdge || !turn(findAround(first)))
  {
    around_ = kNoHalfEdge;
  }
}

/// The last half-edge around a vertex, counterclockwise from `first`, that does not come after the
/// way.
HalfEdge SegmentPath::findAround(HalfEdge first)
{
  const Index vertex = surface_.origin(first);
  std::vector<HalfEdge>& fan = fans_[vertex];
  if (fan.empty())
  {
    HalfEdge out = first;
    do
    {
      taken_.atLeast(3 * sizeof(HalfEdge) * ++inFans_);
      fan.push_back(out);
      out = surface_.nextAround(out);
    } while (out != kNoHalfEdge && out != first && ticker_.step());
  }
  const Point centre = surface_.at(vertex), start = surface_.at(surface_.target(first));
  // Is the direction more than half a turn after that of the first?
  const auto isFar = [&](const Point& p)
  {
    const int side = orient2d(centre, start, p);
    return side < 0 ||
      (side == 0 && lexicographicallyLess(centre, p) != lexicographicallyLess(centre, start));
  };
  const bool isWayFar = isFar(to_);
  const auto comesAfter = [&](bool, HalfEdge out)
  {
    const Point p = surface_.at(surface_.target(out));
    const bool isOutFar = isFar(p);
    return isOutFar != isWayFar ? isOutFar : orient2d(centre, p, to_) < 0;
  };
  return std::upper_bound(fan.begin() + 1, fan.end(), true, comesAfter)[-1];
}

/// From the vertex where the half-edge begins, if the way leads along the triangle to its left, or
/// through it. Returns false if not.
bool SegmentPath::turn(HalfEdge out)
{
  const HalfEdge opposite = nextInTriangle(out);
  const std::array<Index, 2> ends = { { surface_.target(out), surface_.target(opposite) } };
  const std::array<int, 2> sides = { { side(ends[0]), side(ends[1]) } };
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Point vertex = surface_.at(surface_.origin(out)), end = surface_.at(ends[k]);
    if (sides[k] == 0 && lexicographicallyLess(vertex, end) == lexicographicallyLess(from_, to_))
    {
      around_ = kNoHalfEdge;
      reach(ends[k]);
      return true;
    }
  }
  if (sides[0] < 0 && sides[1] > 0)
  {
    around_ = kNoHalfEdge;
    leave(opposite);
    return true;
  }
  return false;
}

/// Out of a triangle across one of its half-edges, unless the way ends before.
void SegmentPath::leave(HalfEdge h)
{
  if (isBeyond(h, to_))
  {
    met_.push_back({ h, false });
    entered_ = surface_.twin(h);
  }
}

/// To a vertex on the line of the way, ahead, unless the way ends before.
void SegmentPath::reach(Index vertex)
{
  const Point at = surface_.at(vertex);
  if (!(at == to_) && lexicographicallyLess(at, to_) == lexicographicallyLess(from_, to_))
  {
    around_ = surface_.start(vertex);
    met_.push_back({ around_, true });
  }
}

} // namespace ahd
