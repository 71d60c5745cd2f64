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

/// ring_ becomes its neighbours, counterclockwise.
void LivingMesh::findRing(Vertex v)
{
  ring_.clear();
  const Halfedge first = leaving(v);
  Halfedge h = first;
  do
  {
    ring_.push_back(target(h));
    h = around(h);
  } while (h != first);
}

std::size_t LivingMesh::degreeOf(Vertex v) const
{
  std::size_t degree = 0;
  const Halfedge first = leaving(v);
  Halfedge h = first;
  do
  {
    ++degree;
    h = around(h);
  } while (h != first);
  return degree;
}

/// May the edge from v be flipped away, so that triangles are left?
bool LivingMesh::canCutOff(Halfedge h) const
{
  const Vertex v = origin(h), left = apex(twin(h)), c = target(h), right = apex(h);
  return left != kGhost && c != kGhost && right != kGhost && side(left, c, places_[right]) > 0 &&
    side(v, left, places_[right]) > 0;
}

/// Leaves v few neighbours: three, or four of which it lies between two; on the hull, those that
/// are on the hull without it. They are in ring_.
void LivingMesh::flipAway(Vertex v, std::vector<Edge>& made)
{
  Halfedge h = leaving(v);
  for (std::size_t size = degreeOf(v), failed = 0; size > 3 && failed < size;)
  {
    if (canCutOff(h))
    {
      const Vertex left = apex(twin(h)), right = apex(h);
      h = around(twin(Mesh::next(flip(h)))); // every second one: else a neighbour gets many edges
      made.push_back({ left, right });
      failed = 0;
      --size;
    }
    else
    {
      ++failed;
      h = around(h);
    }
  }
  findRing(v);
}

/// Frees the triangles around v. Then rim_ is what lay opposite to it, in the order of the ring.
void LivingMesh::freeStar(Vertex v, const Ring& ring)
{
  rim_.clear();
  Halfedge h = edge(v, ring[0]);
  for (std::size_t k = 0; k < ring.size(); ++k, h = around(h))
  {
    const Halfedge opposite = Mesh::next(h);
    rim_.push_back({ origin(opposite), target(opposite), twin(opposite), isConstraint(opposite) });
    free(Mesh::slotOf(opposite));
  }
  slotOfVertex_[v] = kNoIndex;
  freeVertices_.push_back(v);
}

void LivingMesh::joinThree(Vertex v, const Ring& ring)
{
  freeStar(v, ring);
  const Slot s = newSlot();
  set(s, ring[0], ring[1], ring[2]);
  for (std::uint32_t e = 0; e < 3; ++e) // edge e runs from corner e + 1
  {
    const RimEdge& edge = rim_[(e + 1) % 3];
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
      freeStar(v, { a, b, c, d });
      const Slot s = newSlot(), t = newSlot();
      set(s, a, b, c);
      set(t, c, d, a);
      join(s + 2, rim_[0].outside, rim_[0].isConstraint);
      join(s, rim_[1].outside, rim_[1].isConstraint);
      join(t + 2, rim_[2].outside, rim_[2].isConstraint);
      join(t, rim_[3].outside, rim_[3].isConstraint);
      link(s + 1, t + 1);
      made.push_back({ a, c });
      return true;
    }
  }
  return false;
}

bool LivingMesh::remove(Vertex v)
{
  std::vector<Edge>& made = suspects_;
  flipAway(v, made);
  Ring& ring = ring_;
  const auto ghost = std::find(ring.begin(), ring.end(), kGhost);
  bool isGone = true;
  if (ghost != ring.end())
  {
    std::rotate(ring.begin(), ghost, ring.end());
    isGone = removeFromHull(v, ring);
  }
  else if (ring.size() == 3)
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
