// SPDX-License-Identifier: BSD-3-Clause
#include "LivingMesh.h"

#include "../Predicates/Predicates.h"

#include <cmath>

namespace ahd
{

/// @pre v lies on the line through both
bool LivingMesh::isAhead(Vertex from, Vertex to, Vertex v) const
{
  const Point &a = places_[from], &b = places_[to], &p = places_[v];
  return a.x != b.x ? (p.x > a.x) == (b.x > a.x) && p.x != a.x
                    : (p.y > a.y) == (b.y > a.y) && p.y != a.y;
}

/// The way from a vertex towards another one: to the first vertex on it, or across an edge, which
/// goes from the right of the segment to its left.
LivingMesh::Way LivingMesh::firstStep(Vertex from, Vertex to, Halfedge& crossed) const
{
  crossed = kNoIndex;
  const Halfedge first = leaving(from);
  Halfedge h = first;
  do
  {
    const Vertex q = target(h), r = apex(h); // the triangle from, q, r
    if (q == to)
    {
      return { from, to, {} };
    }
    const int ofQ = q == kGhost ? 1 : side(from, to, places_[q]);
    if (ofQ == 0 && isAhead(from, to, q))
    {
      return { from, q, {} };
    }
    if (ofQ < 0 && r != kGhost && side(from, to, places_[r]) > 0)
    {
      crossed = Mesh::next(h);
    }
    h = around(h);
  } while (h != first);
  return { from, kNoIndex, {} };
}

/// The pieces of the segment, between the vertices on it. False if it crosses a constraint.
bool LivingMesh::findWay(Vertex from, Vertex to, std::vector<Way>& ways) const
{
  while (from != to)
  {
    Halfedge h = edge(from, to);
    Way way = h != kNoIndex ? Way{ from, to, {} } : firstStep(from, to, h);
    while (way.to == kNoIndex)
    {
      if (isConstraint(h))
      {
        return false;
      }
      way.crossed.push_back({ origin(h), target(h) });
      const Halfedge back = twin(h);
      const Vertex v = apex(back);
      const int sign = v == to ? 0 : side(from, to, places_[v]);
      // back runs from the left to the right; v replaces the one on its own side
      h = sign > 0 ? Mesh::next(back) : Mesh::previous(back);
      way.to = sign == 0 ? v : kNoIndex;
    }
    from = way.to;
    ways.push_back(std::move(way));
  }
  return true;
}

/// Flips the crossed edges until the piece is one, then those that are not Delaunay.
void LivingMesh::makeEdge(const Way& way)
{
  std::vector<Edge> queue = way.crossed, made;
  for (std::size_t k = 0; k < queue.size(); ++k)
  {
    const Edge next = queue[k];
    const Halfedge h = edge(next.first, next.second);
    if (!canFlip(h))
    {
      queue.push_back(next);
      continue;
    }
    const Halfedge flipped = flip(h);
    const Vertex a = origin(flipped), b = target(flipped);
    const bool touches = a == way.from || a == way.to || b == way.from || b == way.to;
    const bool crosses = !touches &&
      side(way.from, way.to, places_[a]) * side(way.from, way.to, places_[b]) < 0;
    (crosses ? queue : made).push_back({ a, b });
  }
  const Halfedge h = edge(way.from, way.to);
  setConstraint(h, true);
  setConstraint(twin(h), true);
  makeDelaunay(made);
}

bool LivingMesh::constrain(Vertex a, Vertex b)
{
  std::vector<Way> ways;
  if (!findWay(a, b, ways))
  {
    return false;
  }
  for (const Way& way : ways)
  {
    makeEdge(way);
  }
  return true;
}

void LivingMesh::findPieces(Vertex a, Vertex b, std::vector<Edge>& pieces) const
{
  pieces.clear();
  std::vector<Way> ways;
  findWay(a, b, ways);
  for (const Way& way : ways)
  {
    pieces.push_back({ way.from, way.to });
  }
}

void LivingMesh::release(Vertex a, Vertex b)
{
  const Halfedge h = edge(a, b);
  setConstraint(h, false);
  setConstraint(twin(h), false);
  std::vector<Edge> suspects = { { a, b } };
  makeDelaunay(suspects);
}

} // namespace ahd
