// SPDX-License-Identifier: BSD-3-Clause
#include "Kernel.h"

namespace ahd
{
inline namespace AHD_TARGET
{

/// Depth first through the triangles in conflict with p, counterclockwise, so that the edges of the
/// cavity's border are met in the order in which they stand around p, and the star's triangles can
/// be written and linked at once.
///
///             c                 Edge a-b of the cavity, with p on its left; the triangle on its
///           /   \               outer side has corners c, b, a. If that is in conflict with p, the
///          /     \              edge is replaced by a-c and c-b, and its slot is free; else a-b is
///         b <---- a             a border edge, and the star gets the triangle p, a, b.
///          \     /
///             p
///
/// No triangle is marked: the cavity has no vertex inside, so its dual graph is a tree and no
/// triangle is met twice. The number of free slots always equals the number of open edges (root: 1
/// freed and 2 fresh for 3 edges; each conflict: 1 slot, 1 edge more; each border edge takes one),
/// so each open edge carries a slot; where there are very many, they wait in these slots.
///
/// While the star is written, the triangle whose wedge at p holds the next point becomes the hint.
/// That choice is made in floating point, and without a branch, as it would be mispredicted; a
/// wrong hint (rounding, or the ghost's NaN) costs steps, never the result.
template <bool kCount, Access kAccess, bool kExact>
Insertion Kernel<kCount, kAccess, kExact>::carve(const Cavity& cavity, Mesh::Slot& hint)
{
  std::uint32_t* const data = data_;
  const Point* const xy = xy_;
  const Index p = cavity.p;
  const Point at = xy[p];
  const double towardsX = xy[cavity.next].x - at.x;
  const double towardsY = xy[cavity.next].y - at.y;
  Mesh::Slot slot = hint;
  Root root = rootAt(at, slot);
  if (kCount)
  {
    ++work_.trianglesWalked;
  }
  if (!isInConflict(root, p))
  {
    slot = walkFrom(p, slot);
    if (slot == kCancelled || slot == kStrayed)
    {
      return slot == kCancelled ? Insertion::Cancelled : Insertion::Strayed;
    }
    root = rootAt(at, slot);
  }
  if (kShared && !(owns(root.a.vertex) && owns(root.b.vertex) && owns(root.c.vertex)))
  {
    return Insertion::Deferred;
  }

  Corner a = root.a;
  Corner b = root.b;
  double crossed = root.ab;
  Mesh::Halfedge twin = data[slot + Mesh::kTwin];
  const Mesh::Slot fresh = cavity.fresh;
  PendingEdge* top = pending_.data();
  *top++ = pendingTo(a, root.ca, data[slot + 2 + Mesh::kTwin], Mesh::Slot(fresh + Mesh::kSlotSize));
  *top++ = pendingTo(root.c, root.bc, data[slot + 1 + Mesh::kTwin], fresh);
  countRemoved();

  std::size_t stars = 0;
  Mesh::Slot firstStar = kNoIndex;
  Mesh::Slot previousStar = fresh +
    Mesh::kSlotSize; // not written yet: takes the first link in vain
  Mesh::Slot hintForNext = kNoIndex;
  unsigned startIsRight = a.x * towardsY - a.y * towardsX < 0;
  for (;;)
  {
    const Corner apex = seenFrom(at, xy, data[twin]);
    const double crossedIn = cross(a, apex);
    const double crossedOut = cross(apex, b);
    const double det = multiplyAdd(
      a.z, crossedOut, multiplyAdd(b.z, crossedIn, -(apex.z * crossed)));
    const double bound = inCircleErrorBound(a.z, b.z, apex.z, guard_);
    if (kExact && bound < exactBelow_
        ? perturbedDeterminant(det, b, a, apex, -crossed, crossedIn, crossedOut, perturbation_) > 0
        : std::fabs(det) > bound ? det > 0
                                 : conflicts(b.vertex, a.vertex, apex.vertex, p))
    {
      countRemoved();
      if (kShared && !owns(apex.vertex))
      {
        return Insertion::Deferred;
      }
      if (!spend())
      {
        return Insertion::Cancelled;
      }
      *top++ = pendingTo(
        b, crossedOut, data[Mesh::previous(twin) + Mesh::kTwin], Mesh::slotOf(twin));
      if (top == pendingEnd())
      {
        if (kShared)
        {
          return Insertion::Deferred;
        }
        top = spillPending();
      }
      twin = data[Mesh::next(twin) + Mesh::kTwin];
      b = apex;
      crossed = crossedIn;
      continue;
    }

    // A border edge: write the star's triangle p, a, b and link it.
    if (kShared)
    {
      if (stars == kMostDeferredWrites)
      {
        return Insertion::Deferred;
      }
      star_[stars++] = { slot, a.vertex, b.vertex, twin };
    }
    else
    {
      data[slot] = p;
      data[slot + 1] = a.vertex;
      data[slot + 2] = b.vertex;
      data[slot + Mesh::kTwin] = twin;
      data[twin + Mesh::kTwin] = slot;
      data[slot + 2 + Mesh::kTwin] = previousStar + 1;
      data[previousStar + 1 + Mesh::kTwin] = slot + 2;
      firstStar = firstStar == kNoIndex ? slot : firstStar;
      previousStar = slot;
    }

    const unsigned endIsRight = b.x * towardsY - b.y * towardsX < 0;
    hintForNext = endIsRight > startIsRight ? slot : hintForNext;
    startIsRight = endIsRight;
    a = b;
    if (top != pending_.data())
    {
      --top;
      b = Corner{ { top->x, top->y, top->z }, top->end };
      crossed = top->crossed;
      twin = top->twin;
      slot = top->slot;
    }
    else if (spilled_ != kNoIndex)
    {
      slot = spilled_;
      b = seenFrom(at, xy, data[slot]);
      crossed = cross(a, b);
      twin = data[slot + 1];
      spilled_ = data[slot + 2];
    }
    else
    {
      break;
    }
  }
  if (kShared)
  {
    writeStar(p, stars);
  }
  else
  {
    data[previousStar + 1 + Mesh::kTwin] = firstStar + 2;
    data[firstStar + 2 + Mesh::kTwin] = previousStar + 1;
  }
  hint = hintForNext;
  return Insertion::Done;
}

/// From any triangle of the star of p, in none of whose wedges the next point was found: that lies
/// outside of the hull, mostly. Returns the ghost of the star on its side, if there is one.
template <bool kCount, Access kAccess, bool kExact>
Mesh::Slot Kernel<kCount, kAccess, kExact>::hintOutside(Index next, Mesh::Slot star)
{
  Mesh::Slot slot = star;
  do
  {
    const Mesh::Slot after = Mesh::slotOf(data_[slot + 1 + Mesh::kTwin]);
    if (data_[slot + 2] == ghost_)
    {
      const Point& p = xy_[data_[slot]];
      const Lifted towards = liftedFrom(p, xy_[next]);
      return cross(liftedFrom(p, xy_[data_[after + 2]]), towards) < 0 ? after : slot;
    }
    slot = after;
  } while (slot != star && spend());
  return star;
}

/// Writes the triangles p, a, b that carve() has put aside, and links each to the next.
template <bool kCount, Access kAccess, bool kExact>
void Kernel<kCount, kAccess, kExact>::writeStar(Index p, std::size_t triangles)
{
  Mesh::Slot previous = star_[triangles - 1].slot;
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const StarTriangle t = star_[i];
    data_[t.slot] = p;
    data_[t.slot + 1] = t.a;
    data_[t.slot + 2] = t.b;
    data_[t.slot + Mesh::kTwin] = t.twin;
    data_[t.twin + Mesh::kTwin] = t.slot;
    data_[t.slot + 2 + Mesh::kTwin] = previous + 1;
    data_[previous + 1 + Mesh::kTwin] = t.slot + 2;
    previous = t.slot;
  }
}

/// Moves the open edges, which fill their room, to the slots they carry: end, twin, and the slot of
/// the one below. So a cavity of any size needs no more memory. Returns where the next edge goes.
template <bool kCount, Access kAccess, bool kExact>
typename Kernel<kCount, kAccess, kExact>::PendingEdge*
Kernel<kCount, kAccess, kExact>::spillPending()
{
  for (const PendingEdge& edge : pending_)
  {
    data_[edge.slot] = edge.end;
    data_[edge.slot + 1] = edge.twin;
    data_[edge.slot + 2] = spilled_;
    spilled_ = edge.slot;
  }
  return pending_.data();
}

template <bool kCount, Access kAccess, bool kExact>
bool Kernel<kCount, kAccess, kExact>::conflicts(Index a, Index b, Index c, Index p)
{
  if (c == ghost_)
  {
    return conflictsWithGhost(a, b, p);
  }
  if (b == ghost_)
  {
    return conflictsWithGhost(c, a, p);
  }
  if (a == ghost_)
  {
    return conflictsWithGhost(b, c, p);
  }
  spendOnExact();
  if (kCount)
  {
    ++work_.exactInCircle;
  }
  const int inRectangle = conflictInRectangle(xy_[a], xy_[b], xy_[c], xy_[p]);
  return inRectangle != 0 ? inRectangle > 0 : inConflictExact(xy_[a], xy_[b], xy_[c], xy_[p]);
}

/// The hull lies on the right of the edge `from` - `to` or is that edge: p is in conflict if it
/// sees the edge from outside, or lies between its ends (then it also is in conflict with the
/// finite triangle behind the edge).
template <bool kCount, Access kAccess, bool kExact>
bool Kernel<kCount, kAccess, kExact>::conflictsWithGhost(Index from, Index to, Index p)
{
  const Point& a = xy_[from];
  const Point& b = xy_[to];
  const Point& q = xy_[p];
  spendOnExact();
  const int side = orient2d(a, b, q);
  if (side != 0)
  {
    return side > 0;
  }
  return lexicographicallyLess(a, q) == lexicographicallyLess(q, b);
}

template <bool kCount, Access kAccess, bool kExact>
int Kernel<kCount, kAccess, kExact>::orientation(Index a, Index b, Index p)
{
  spendOnExact();
  if (kCount)
  {
    ++work_.exactOrient;
  }
  return orient2dExact(xy_[a], xy_[b], xy_[p]);
}

template <bool kCount, Access kAccess, bool kExact>
bool Kernel<kCount, kAccess, kExact>::refill()
{
  budget_ = kStepsPerRefill;
  ticker_.finished(insertedSinceAsking_);
  insertedSinceAsking_ = 0;
  return ticker_.ask();
}

template class Kernel<false, Access::Alone, false>;
template class Kernel<true, Access::Alone, false>;
template class Kernel<false, Access::Shared, false>;
template class Kernel<false, Access::Alone, true>;
template class Kernel<true, Access::Alone, true>;
template class Kernel<false, Access::Shared, true>;

} // namespace AHD_TARGET
} // namespace ahd
