// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_KernelWalks_h
#define ahd_KernelWalks_h

#include "Kernel.h"

/// The part of the kernel that locates points outside of the hint: hints and walks on the
/// hull, and jumps. For Kernel.cxx.
namespace ahd
{
inline namespace AHD_TARGET
{

/// From a ghost along the hull, as long as p is beyond the edge's end: to a ghost that sees p, or
/// from where that ends through the triangles.
template <bool kCount, Access kAccess, bool kExact>
Mesh::Slot Kernel<kCount, kAccess, kExact>::walkAlongHull(
  Index p, Mesh::Slot ghost, unsigned untilJump)
{
  const Point& at = xy_[p];
  Mesh::Halfedge h = ghost;
  while (data_[h] != ghost_)
  {
    ++h;
  }
  // The ghost's hull edge; the hull lies on its right.
  Corner from = seenFrom(at, xy_, data_[Mesh::next(h)]);
  Corner to = seenFrom(at, xy_, data_[Mesh::previous(h)]);
  const auto isBeyond = [](const Corner& a, const Corner& b) // b, seen from a?
  { return b.x * (a.x - b.x) + b.y * (a.y - b.y) > 0.0; };
  const bool forwards = isBeyond(from, to);
  // It ends at the vertex that is farthest away, but for rounding. Where no jump cuts it short, it
  // is left soon, as inside may be far less to walk.
  Index left = takesNotes_ ? ghost_ : kStepsOnHull;
  for (; left > 0 && (forwards ? isBeyond(from, to) : isBeyond(to, from)); --left)
  {
    if (!spend())
    {
      return kCancelled;
    }
    if (kShared && !territory_.owns(forwards ? to.vertex : from.vertex))
    {
      return kStrayed;
    }
    if (!kShared && --untilJump == 0)
    {
      const Mesh::Slot start = noted(p, std::min(from.z, to.z));
      if (start != kNoIndex)
      {
        return walkFrom(p, start, 0);
      }
    }
    if (kCount)
    {
      ++work_.trianglesWalked;
    }
    // The hull's next vertex stands opposite of the edge that two ghosts share.
    if (forwards)
    {
      h = data_[Mesh::next(h) + Mesh::kTwin];
      from = to;
      to = seenFrom(at, xy_, data_[h]);
      h = Mesh::next(h);
    }
    else
    {
      h = data_[Mesh::previous(h) + Mesh::kTwin];
      to = from;
      from = seenFrom(at, xy_, data_[h]);
      h = Mesh::previous(h);
    }
    if (isRightOf(to, from, p))
    {
      return Mesh::slotOf(h);
    }
  }
  return walk(p, Mesh::slotOf(data_[h + Mesh::kTwin]), untilJump);
}

template <bool kCount, Access kAccess, bool kExact>
bool Kernel<kCount, kAccess, kExact>::beginToNote()
{
  takesNotes_ = true;
  return inChunks(0, ghost_ / kRanksPerNote + kNotesTried + 1, ticker_,
    [this](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        data_[placeOfNote(i)] = kNoIndex;
      }
    });
}

/// Of the triangles noted for the ranks after p one that is less than half as far away as that: all
/// of it or, if it is a ghost, one of its corners. kNoIndex: none.
template <bool kCount, Access kAccess, bool kExact>
Mesh::Slot Kernel<kCount, kAccess, kExact>::noted(Index p, double squaredDistance) const
{
  for (Index k = 1; takesNotes_ && k <= kNotesTried; ++k)
  {
    const Mesh::Slot slot = data_[placeOfNote(p / kRanksPerNote + k)];
    if (slot != kNoIndex && isWithin(squaredDistance / 4, p, slot))
    {
      return slot;
    }
  }
  return kNoIndex;
}

/// Is p nearer than that to all corners of a triangle, or to one of a ghost?
template <bool kCount, Access kAccess, bool kExact>
bool Kernel<kCount, kAccess, kExact>::isWithin(double squaredRadius, Index p, Mesh::Slot slot) const
{
  unsigned near = 0;
  for (Mesh::Slot i = slot; i < slot + 3; ++i)
  {
    near += data_[i] != ghost_ && liftedFrom(xy_[p], xy_[data_[i]]).z < squaredRadius ? 1u : 0u;
  }
  return near == 3 || (near > 0 && isGhost(slot));
}

/// From a ghost of the star of p: the one of its two ghosts on the side of the next point.
template <bool kCount, Access kAccess, bool kExact>
Mesh::Slot Kernel<kCount, kAccess, kExact>::hintOutside(Index next, Mesh::Slot ghost) const
{
  const bool isFirst = data_[ghost + 2] == ghost_;
  const Mesh::Slot before = isFirst ? ghost : Mesh::slotOf(data_[ghost + 2 + Mesh::kTwin]);
  const Mesh::Slot after = isFirst ? Mesh::slotOf(data_[ghost + 1 + Mesh::kTwin]) : ghost;
  const Point& p = xy_[data_[ghost]];
  const Lifted towards = liftedFrom(p, xy_[next]);
  return cross(liftedFrom(p, xy_[data_[after + 2]]), towards) < 0 ? after : before;
}

/// From a finite triangle of the star of p, a vertex of the hull: the ghost beside it that is on
/// the way to the next point, if there is one. Along the hull it is often less far: on points of a
/// curve, triangles inside reach to the other side, where many more may be crossed.
template <bool kCount, Access kAccess, bool kExact>
Mesh::Slot Kernel<kCount, kAccess, kExact>::hintOnHull(Index next, Mesh::Slot hint) const
{
  const Point& p = xy_[data_[hint]];
  const Lifted towards = liftedFrom(p, xy_[next]);
  const auto ahead = [&](Index v)
  {
    const Lifted seen = liftedFrom(p, xy_[v]);
    return seen.x * towards.x + seen.y * towards.y;
  };
  const double first = isHullEdge(hint + 2) ? ahead(data_[hint + 1]) : 0.0;
  const double second = isHullEdge(hint + 1) ? ahead(data_[hint + 2]) : 0.0;
  if (!(first > 0.0 || second > 0.0))
  {
    return hint;
  }
  return Mesh::slotOf(data_[(second > first ? hint + 1 : hint + 2) + Mesh::kTwin]);
}

} // namespace AHD_TARGET
} // namespace ahd

#endif
