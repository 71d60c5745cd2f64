// SPDX-License-Identifier: BSD-3-Clause
#include "Spots.h"

#include "../Predicates/Predicates.h"

#include <algorithm>

namespace ahd
{

Spot SpotOwner::ofEdge(HalfEdge h) const
{
  const HalfEdge twin = surface_.tables->twins[h];
  const HalfEdge first = std::min(h, twin), second = std::max(h, twin); // a twin may be none
  if (surface_.isKept(first / 3))
  {
    return { Spot::OnEdge, first };
  }
  if (second != kNoHalfEdge && surface_.isKept(second / 3))
  {
    return { Spot::OnEdge, second };
  }
  return {};
}

bool SpotOwner::ofVertex(Index vertex, Ticker& ticker, Spot& spot) const
{
  spot = Spot();
  const HalfEdge start = surface_.tables->starts[vertex];
  HalfEdge h = start;
  do
  {
    if (h == kNoHalfEdge)
    {
      return true;
    }
    if (surface_.isKept(h / 3))
    {
      spot = { Spot::OnVertex, h };
      return true;
    }
    if (!ticker.step())
    {
      return false;
    }
    h = surface_.tables->twins[previousInTriangle(h)];
  } while (h != start);
  return true;
}

bool SpotFinder::find(const Point& place, Ticker& ticker, Spot& spot)
{
  if (!ticker.step()) // a walk may end where it begins
  {
    return false;
  }
  const Tables& tables = *surface_.tables;
  const Locator locator(tables, surface_.places);
  const Location found = locator.locate(place, hint_, tables.triangles(), ticker);
  if (found.kind == Location::Nowhere)
  {
    return false;
  }
  hint_ = found.halfEdge / 3;
  spot = Spot();
  switch (found.kind)
  {
    case Location::InTriangle:
      spot = surface_.isKept(hint_) ? Spot{ Spot::InTriangle, found.halfEdge } : Spot();
      return true;
    case Location::OnEdge:
      spot = SpotOwner(surface_).ofEdge(found.halfEdge);
      return true;
    case Location::OnVertex:
      return SpotOwner(surface_).ofVertex(tables.origin(found.halfEdge), ticker, spot);
    default:
      return true;
  }
}

} // namespace ahd
