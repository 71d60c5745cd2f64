// SPDX-License-Identifier: BSD-3-Clause
#include "LivingMesh.h"

namespace ahd
{

/// Links each ghost to the next one along the hull.
void LivingMesh::linkGhosts()
{
  for (Slot s = 0; s < end(); s += Mesh::kSlotSize)
  {
    if (data_[s] == kGhost)
    {
      starAt_[data_[s + 1]] = s;
    }
  }
  for (Slot s = 0; s < end(); s += Mesh::kSlotSize)
  {
    if (data_[s] == kGhost)
    {
      link(s + 1, starAt_[data_[s + 2]] + 2);
    }
  }
}

/// The triangles at v become ghosts: what is opposite to v is the hull.
void LivingMesh::bendHullIn(Vertex v, const Ring& ring)
{
  const std::size_t last = ring.size() - 1;
  freeStar(v, ring);
  Slot previous = kNoIndex;
  for (std::size_t k = 1; k < last; ++k)
  {
    const Slot s = newSlot();
    set(s, kGhost, ring[k], ring[k + 1]);
    join(s, rim_[k].outside, rim_[k].isConstraint);
    link(s + 2, k == 1 ? rim_[0].outside : previous + 1);
    previous = s;
  }
  link(previous + 1, rim_[last].outside);
}

/// v lies on the hull, between two of its three neighbours.
void LivingMesh::joinOnHull(Vertex v, const Ring& ring)
{
  freeStar(v, ring);
  const Slot t = newSlot(), ghost = newSlot();
  set(t, ring[1], ring[2], ring[3]);
  set(ghost, kGhost, ring[1], ring[3]);
  join(t + 2, rim_[1].outside, rim_[1].isConstraint);
  join(t, rim_[2].outside, rim_[2].isConstraint);
  link(t + 1, ghost);
  link(ghost + 2, rim_[0].outside);
  link(ghost + 1, rim_[3].outside);
}

/// The ring begins at the ghost.
bool LivingMesh::removeFromHull(Vertex v, const Ring& ring)
{
  const bool isOnEdge = ring.size() == 4 && side(ring[1], ring[2], places_[ring[3]]) > 0;
  const bool areCollinear = !isOnEdge && isGhost(Mesh::slotOf(twin(Mesh::next(edge(v, ring[1])))));
  if (!areCollinear)
  {
    isOnEdge ? joinOnHull(v, ring) : bendHullIn(v, ring);
  }
  return !areCollinear;
}

} // namespace ahd
