// SPDX-License-Identifier: BSD-3-Clause
#include "LivingMesh.h"

#include "../Predicates/Predicates.h"

#include <algorithm>

namespace ahd
{

bool LivingMesh::isRemovable(Vertex v) const
{
  const Halfedge first = leaving(v);
  Halfedge h = first;
  bool is = true;
  do
  {
    is = is && !isConstraint(h) && target(h) != kGhost;
    h = around(h);
  } while (h != first);
  return is;
}

/// Its neighbours, counterclockwise.
LivingMesh::Ring LivingMesh::ringOf(Vertex v) const
{
  Ring ring;
  const Halfedge first = leaving(v);
  Halfedge h = first;
  do
  {
    ring.push_back(target(h));
    h = around(h);
  } while (h != first);
  return ring;
}

/// Flips the edge from v to the k-th neighbour away, if that leaves triangles.
bool LivingMesh::cutOff(Vertex v, Ring& ring, std::size_t k)
{
  const std::size_t n = ring.size();
  const Vertex left = ring[(k + n - 1) % n], c = ring[k], right = ring[(k + 1) % n];
  const bool is = side(left, c, places_[right]) > 0 && side(v, left, places_[right]) > 0;
  if (is)
  {
    flip(edge(v, c));
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return is;
}

/// Leaves v few neighbours: three, or four of which it lies between two.
void LivingMesh::flipAway(Vertex v, Ring& ring, std::vector<Edge>& made)
{
  std::size_t failed = 0;
  for (std::size_t k = 0; ring.size() > 3 && failed < ring.size();)
  {
    k %= ring.size();
    const std::size_t n = ring.size();
    const Edge cut = { ring[(k + n - 1) % n], ring[(k + 1) % n] };
    if (cutOff(v, ring, k))
    {
      made.push_back(cut);
      failed = 0;
    }
    else
    {
      ++failed;
      ++k;
    }
  }
}

/// Frees the triangles around v. `rim`: what lay opposite to it, in the order of the ring.
void LivingMesh::freeStar(Vertex v, const Ring& ring, std::vector<RimEdge>& rim)
{
  std::vector<Slot> slots;
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    const Halfedge opposite = Mesh::next(edge(v, ring[k]));
    rim.push_back({ origin(opposite), target(opposite), twin(opposite), isConstraint(opposite) });
    slots.push_back(Mesh::slotOf(opposite));
  }
  for (const Slot s : slots)
  {
    free(s);
  }
  slotOfVertex_[v] = kNoIndex;
  freeVertices_.push_back(v);
}

void LivingMesh::joinThree(Vertex v, const Ring& ring)
{
  std::vector<RimEdge> rim;
  freeStar(v, ring, rim);
  const Slot s = newSlot();
  set(s, ring[0], ring[1], ring[2]);
  for (std::uint32_t e = 0; e < 3; ++e) // edge e runs from corner e + 1
  {
    const RimEdge& edge = rim[(e + 1) % 3];
    join(s + e, edge.outside, edge.isConstraint);
  }
}

/// Where v lies on a diagonal of its four neighbours, which becomes an edge.
bool LivingMesh::joinFour(Vertex v, const Ring& ring, std::vector<Edge>& made)
{
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Vertex a = ring[k], b = ring[k + 1], c = ring[k + 2], d = ring[(k + 3) % 4];
    if (side(a, c, places_[v]) == 0 && side(a, b, places_[c]) > 0 && side(c, d, places_[a]) > 0)
    {
      std::vector<RimEdge> rim;
      freeStar(v, { a, b, c, d }, rim);
      const Slot s = newSlot(), t = newSlot();
      set(s, a, b, c);
      set(t, c, d, a);
      join(s + 2, rim[0].outside, rim[0].isConstraint);
      join(s, rim[1].outside, rim[1].isConstraint);
      join(t + 2, rim[2].outside, rim[2].isConstraint);
      join(t, rim[3].outside, rim[3].isConstraint);
      link(s + 1, t + 1);
      made.push_back({ a, c });
      return true;
    }
  }
  return false;
}

bool LivingMesh::remove(Vertex v)
{
  Ring ring = ringOf(v);
  std::vector<Edge> made;
  flipAway(v, ring, made);
  bool isGone = ring.size() == 3;
  if (isGone)
  {
    joinThree(v, ring);
  }
  else
  {
    isGone = ring.size() == 4 && joinFour(v, ring, made);
  }
  makeDelaunay(made); // if it is not gone, as it was before
  return isGone;
}

} // namespace ahd
