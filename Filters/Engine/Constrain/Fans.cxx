// SPDX-License-Identifier: BSD-3-Clause
#include "Fans.h"

#include "../Predicates/Predicates.h"

#include <iterator>

namespace ahd
{

bool Fans::ComesBefore::operator()(Index u, Index v) const
{
  const Point& middle = mesh->at(hub);
  const bool isLeftU = lexicographicallyLess(mesh->at(u), middle);
  const bool isLeftV = lexicographicallyLess(mesh->at(v), middle);
  return isLeftU != isLeftV ? isLeftV : u != v && orient2d(middle, mesh->at(u), mesh->at(v)) > 0;
}

void Fans::remember(Index hub, Index neighbour)
{
  if (neighbour != mesh_.ghost())
  {
    fans_.try_emplace(hub, ComesBefore{ &mesh_, hub }).first->second.insert(neighbour);
  }
}

/// Found from the neighbour, if that has few edges.
Mesh::Halfedge Fans::edgeTo(Index hub, Index neighbour) const
{
  constexpr int kMost = 32;
  Mesh::Halfedge back = mesh_.outgoing(neighbour);
  for (int steps = 0; steps != kMost; ++steps)
  {
    if (mesh_.destination(back) == hub)
    {
      return mesh_.twin(back);
    }
    back = mesh_.nextAround(back);
  }
  return kNoIndex;
}

std::array<Mesh::Halfedge, 2> Fans::find(Index hub, Index to)
{
  std::array<Mesh::Halfedge, 2> edges = { { kNoIndex, kNoIndex } };
  const auto known = fans_.find(hub);
  if (known == fans_.end())
  {
    return edges;
  }
  Fan& fan = known->second;
  for (Mesh::Halfedge& edge : edges)
  {
    const bool isAfter = &edge == &edges[1];
    while (edge == kNoIndex && !fan.empty())
    {
      const auto after = fan.lower_bound(to);
      const auto next = after == fan.end() ? fan.begin() : after;
      const auto found = isAfter ? next : std::prev(after == fan.begin() ? fan.end() : after);
      edge = edgeTo(hub, *found);
      if (edge == kNoIndex)
      {
        fan.erase(found);
      }
    }
  }
  return edges;
}

} // namespace ahd
