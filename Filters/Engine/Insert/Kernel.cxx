// SPDX-License-Identifier: BSD-3-Clause
#include "KernelWalks.h"

namespace ahd
{
inline namespace AHD_TARGET
{

/// The star is there from the beginning, as a ring of triangles around p that are linked to each
/// other and to what lies beyond them, and it grows: where the triangle beyond one of its edges is
/// in conflict with p, the star's triangle on that edge is split in two.
///
///             c                 Triangle p, a, b of the star; the triangle beyond a-b has corners
///           /   \               c, b, a and is in conflict with p. Then p, a, c stays in the place
///          /     \              of p, a, b, and p, c, b takes the slot of the triangle that goes.
///         b <---- a             Beyond a-c and c-b are two more triangles, which are tested next.
///          \     /
///             p
///
/// Both are tested at once: half of all that is known of an edge is the same, and what costs time
/// is not so much to find an answer as to find, after one that was guessed wrong, the next. So what
/// can be chosen without a branch is, and the answers come in pairs, early (FilterPairs.h), and
/// what lies behind both triangles is read before it is known whether it will be needed. One of
/// them, if in conflict, is next; the other one waits in a list through the unused numbers of the
/// star's triangles, so that no cavity is too large: it is written there in any case, and listed by
/// a mask.
///
/// No triangle is marked: the cavity has no vertex inside, so its dual graph is a tree and no
/// triangle is met twice.
///
/// The star's triangle whose wedge at p holds the next point becomes the hint. That choice is made
/// in floating point, and without a branch, as it would be mispredicted; a wrong hint (rounding, or
/// the ghost's NaN) costs steps, never the result.
///
/// kInside: while it has met no ghost; where it does, it begins once more. Only ghosts have edges
/// that belong to others whole beside those that a part owns (beyond()).
template <bool kCount, Access kAccess, bool kExact>
template <bool kInside>
Insertion Kernel<kCount, kAccess, kExact>::carve(const Cavity& cavity, Mesh::Slot& hint)
{
  const Point* const xy = xy_;
  const Index p = cavity.p;
  const Pair at = coordinates(xy[p]);
  Mesh::Slot slot = hint;
  Root root = rootAt(at, slot);
  if (kCount)
  {
    ++work_.trianglesWalked;
  }
  if (!isInConflict(root, p))
  {
    slot = walkFrom(p, slot, kStepsToJump);
    if (slot == kCancelled || slot == kStrayed)
    {
      return slot == kCancelled ? Insertion::Cancelled : Insertion::Strayed;
    }
    isOutside_ = isGhost(slot);
    root = rootAt(at, slot);
  }
  if (kShared &&
    !(mayRemove<kInside>(root.a) && mayRemove<kInside>(root.b) && mayRemove<kInside>(root.c)))
  {
    hint = slot;
    return kInside && isGhost(slot) ? carve<false>(cavity, hint) : Insertion::Deferred;
  }

  const VectorPair origin{ lows(at, at), highs(at, at) };
  const Pair way = coordinates(xy[cavity.next]) - at;
  const VectorPair towards{ lows(way, way), highs(way, way) };

  // The root is looked at like a triangle beyond an edge a-c of a star of two.
  const std::uint32_t* const twins = data_ + slot + Mesh::kTwin;
  const Mesh::Halfedge closing = twins[2];
  const Beyond beyondRoot{ twins[0], twins[1], data_[twins[0]], data_[twins[1]] };
  const unsigned rightOfBC = signs(cross(root.edges.b, towards));
  openStar(cavity, root, closing);
  Removed t{ cavity.fresh, slot + 2, root.b, (rightOfBC & 1) != 0, root.edges, beyondRoot };
  const Mesh::Slot closingPlace = t.place + Mesh::kSlotSize;
  Mesh::Slot hintPlace = firstHint({ t.place, slot, closingPlace }, signs(root.edges.crossed),
    signs(cross(root.edges.a, towards)), rightOfBC);
  // Written in any case, and chosen by a mask: a branch would be taken at random.
  (data_ + closingPlace)[3] = kNoIndex;
  const Mesh::Slot isWaiting = 0u - (closingInConflict(root, closing, origin, p) ? 1u : 0u);
  Mesh::Slot waiting = (closingPlace & isWaiting) | ~isWaiting;
  std::size_t splits = 0; // counted if Shared
  for (;;)
  {
    countRemoved();
    if (kShared)
    {
      if (splits == kMostSplits || !mayRemove<kInside>(t.apex))
      {
        takeBack(splits);
        hint = slot;
        if (!spend(splits))
        {
          return Insertion::Cancelled;
        }
        return kInside && t.apex == ghost_ ? carve<false>(cavity, hint) : Insertion::Deferred;
      }
      splits_[splits++] = t.entry;
    }
    else if (!spend())
    {
      return Insertion::Cancelled;
    }
    const Beyond first = beyond<kInside>(t.beyond.first);
    const Beyond second = beyond<kInside>(t.beyond.second);
    const LiftedPair apices = liftedFrom(origin, xy[t.beyond.firstApex], xy[t.beyond.secondApex]);
    const InCirclePair seen = test(t.edges, apices);
    const unsigned right = signs(cross(apices, towards));
    const unsigned inside = seen.certain == 3 ? seen.inside
                                              : decide(seen, t.place, t.apex, t.beyond);
    const Mesh::Slot added = split(t, p);
    const Mesh::Slot refined = t.apexIsRight ? t.place : added;
    hintPlace = hintPlace == t.place ? refined : hintPlace;
    if ((inside & 1) != 0)
    {
      // The other one waits, if it is in conflict, too: again by a mask.
      (data_ + added)[3] = waiting;
      waiting ^= (waiting ^ added) & (0u - (inside >> 1));
      t = { t.place, t.beyond.first, t.beyond.firstApex, (right & 1) != 0,
        lowEdges(t.edges, apices), first };
    }
    else if ((inside & 2) != 0)
    {
      t = { added, t.beyond.second, t.beyond.secondApex, (right & 2) != 0,
        highEdges(t.edges, apices), second };
    }
    else if (waiting != kNoIndex)
    {
      t = waitingAt<kInside>(waiting, at, towards);
      waiting = (data_ + waiting)[3];
    }
    else
    {
      break;
    }
  }
  if (kShared && !spend(splits))
  {
    return Insertion::Cancelled;
  }
  hint = hintPlace;
  if ((data_ + hint)[1] == ghost_ || (data_ + hint)[2] == ghost_)
  {
    hint = hintOutside(cavity.next, hint);
    isOutside_ = true;
  }
  else if (isOutside_)
  {
    hint = hintOnHull(cavity.next, hint);
    isOutside_ = isGhost(hint);
  }
  return Insertion::Done;
}

/// Which of the star's triangles on a root's edges a-b, b-c and c-a is the hint: the one with the
/// next point in its wedge, that is on the right of the ray through its end and not of that through
/// its start. If there is none, p is outside the root, and the next point behind the same edge.
/// `behind` tells of a-b and b-c whether p is behind them, `ofAB` and `ofBC` of which of their ends
/// the next point is on the right.
template <bool kCount, Access kAccess, bool kExact>
AHD_ALWAYS_INLINE Mesh::Slot Kernel<kCount, kAccess, kExact>::firstHint(
  const RootPlaces& places, unsigned behind, unsigned ofAB, unsigned ofBC)
{
  // By masks, as compilers make branches of some choices here, which would be taken at random.
  const auto choose = [](unsigned yes, Mesh::Slot a, Mesh::Slot b)
  { return b ^ ((a ^ b) & (0u - (yes & 1u))); };
  Mesh::Slot hint = choose(behind >> 1, places.bc, places.ca);
  hint = choose(behind, places.ab, hint);
  hint = choose(ofAB & ~(ofBC >> 1), places.ca, hint);
  hint = choose(ofBC >> 1 & ~ofBC, places.bc, hint);
  hint = choose(ofAB >> 1 & ~ofAB, places.ab, hint);
  return hint;
}

/// The star of two triangles, p, a, c and p, c, a, in the two fresh slots.
template <bool kCount, Access kAccess, bool kExact>
AHD_ALWAYS_INLINE void Kernel<kCount, kAccess, kExact>::openStar(
  const Cavity& cavity, const Root& root, Mesh::Halfedge closingTwin)
{
  const Mesh::Slot place = cavity.fresh;
  const Mesh::Slot closing = place + Mesh::kSlotSize;
  std::uint32_t* const t = data_ + place;
  t[0] = cavity.p;
  t[1] = root.a;
  t[2] = root.c;
  t[5] = closing + 2;
  t[6] = closing + 1;
  t[8] = cavity.p;
  t[9] = root.c;
  t[10] = root.a;
  t[12] = closingTwin;
  t[13] = place + 2;
  t[14] = place + 1;
  (data_ + closingTwin)[Mesh::kTwin] = closing;
}

/// Splits the star's triangle on the edge across which a triangle was removed. Returns where the
/// second half stands: in the slot of that triangle.
template <bool kCount, Access kAccess, bool kExact>
AHD_ALWAYS_INLINE Mesh::Slot Kernel<kCount, kAccess, kExact>::split(const Removed& removed, Index p)
{
  const Mesh::Slot added = Mesh::slotOf(removed.entry);
  std::uint32_t* const u = data_ + removed.place;
  std::uint32_t* const v = data_ + added;
  const Index b = u[2];
  const Mesh::Halfedge after = u[5];
  u[2] = removed.apex;
  u[4] = removed.beyond.first;
  u[5] = added + 2;
  v[0] = p;
  v[1] = removed.apex;
  v[2] = b;
  v[4] = removed.beyond.second;
  v[5] = after;
  v[6] = removed.place + 1;
  (data_ + removed.beyond.first)[Mesh::kTwin] = removed.place;
  (data_ + removed.beyond.second)[Mesh::kTwin] = added;
  (data_ + after)[Mesh::kTwin] = added + 1;
  return added;
}

/// Takes back the splits of the star in work, the last one first, and the star of two: the mesh is
/// as it was, down to the places of corners and edges. @pre there is a split.
template <bool kCount, Access kAccess, bool kExact>
void Kernel<kCount, kAccess, kExact>::takeBack(std::size_t splits)
{
  Mesh::Slot place = 0;
  while (splits > 0)
  {
    const Mesh::Halfedge entry = splits_[--splits];
    const std::uint32_t* const v = data_ + Mesh::slotOf(entry);
    place = Mesh::slotOf(v[6]); // the other half is the one after it in the star
    const std::uint32_t* const u = data_ + place;
    const Index a = u[1], b = v[2], apex = u[2];
    const Mesh::Halfedge first = u[4], second = v[4], after = v[5];
    const Mesh::Halfedge next = Mesh::next(entry);
    const Mesh::Halfedge previous = Mesh::previous(entry);
    data_[place + 2] = b;
    link(place + 1, after);
    data_[entry] = apex;
    data_[next] = b;
    data_[previous] = a;
    link(place, entry);
    link(next, first);
    link(previous, second);
  }
  // The first split was that of the star's first triangle.
  link(splits_[0], (data_ + place + Mesh::kSlotSize)[Mesh::kTwin]);
}

/// Is the triangle beyond the root's edge c-a in conflict with p?
template <bool kCount, Access kAccess, bool kExact>
AHD_ALWAYS_INLINE bool Kernel<kCount, kAccess, kExact>::closingInConflict(
  const Root& root, Mesh::Halfedge twin, const VectorPair& origin, Index p)
{
  const Index apex = data_[twin];
  const LiftedPair beyond = liftedFrom(origin, xy_[apex], xy_[apex]);
  const InCirclePair seen = test(root.closing, beyond);
  return (seen.certain & 1) != 0 ? (seen.inside & 1) != 0 : conflicts(root.a, root.c, apex, p);
}

/// The triangle beyond the star's triangle at `place`, which is in conflict with p.
template <bool kCount, Access kAccess, bool kExact>
template <bool kInside>
AHD_ALWAYS_INLINE typename Kernel<kCount, kAccess, kExact>::Removed
Kernel<kCount, kAccess, kExact>::waitingAt(
  Mesh::Slot place, Pair at, const VectorPair& towards) const
{
  const std::uint32_t* const t = data_ + place;
  const Mesh::Halfedge twin = t[Mesh::kTwin];
  const Index apex = data_[twin];
  const Pair a = coordinates(xy_[t[1]]) - at;
  const Pair b = coordinates(xy_[t[2]]) - at;
  const Pair c = coordinates(xy_[apex]) - at;
  const LiftedPair ac = lifted(a, c), cb = lifted(c, b);
  const bool isRight = (signs(cross(cb, towards)) & 1) != 0;
  return { place, twin, apex, isRight, { ac, cb, cross(ac, cb) }, beyond<kInside>(twin) };
}

/// Which of the two triangles beyond a removed one are in conflict with p, by tighter filters and
/// the exact predicate where the filter is not certain.
/// @pre the star has not been split there yet.
template <bool kCount, Access kAccess, bool kExact>
unsigned Kernel<kCount, kAccess, kExact>::decide(
  InCirclePair seen, Mesh::Slot place, Index apex, Beyond beyond)
{
  const Index p = data_[place], a = data_[place + 1], b = data_[place + 2];
  const Index ofFirst = beyond.firstApex, ofSecond = beyond.secondApex;
  const TwoEdges edges{ xy_[a], xy_[apex], xy_[b], xy_[ofFirst], xy_[ofSecond] };
  seen = orElse(seen, inRectangles(3 & ~seen.certain, xy_[p], edges));
  if (seen.certain != 3)
  {
    InCirclePair sharp = inCircleBySharpCrosses(xy_[p], edges, guard_);
    // The ghost's place is not for filters that are as close as this one.
    sharp.certain &= apex == ghost_ ? 0u : 3u;
    sharp.certain &= a == ghost_ || ofFirst == ghost_ ? 2u : 3u;
    sharp.certain &= b == ghost_ || ofSecond == ghost_ ? 1u : 3u;
    seen = orElse(seen, sharp);
  }
  // In a frame the tighter filters for one triangle know nothing more.
  const bool isInFrame = !std::isinf(squaredGuard_);
  const auto conflict = [=](Index u, Index v, Index w)
  { return kPairsAreFused && isInFrame ? conflictsExactly(u, v, w, p) : conflicts(u, v, w, p); };
  const bool first = (seen.certain & 1) != 0 ? (seen.inside & 1) != 0 : conflict(apex, a, ofFirst);
  const bool second = (seen.certain & 2) != 0 ? (seen.inside & 2) != 0
                                              : conflict(b, apex, ofSecond);
  return (first ? 1u : 0u) + (second ? 2u : 0u);
}

template <bool kCount, Access kAccess, bool kExact>
bool Kernel<kCount, kAccess, kExact>::conflicts(Index a, Index b, Index c, Index p)
{
  if (a != ghost_ && b != ghost_ && c != ghost_)
  {
    const Point &A = xy_[a], &B = xy_[b], &C = xy_[c], &P = xy_[p];
    const int inRectangle = conflictInRectangle(A, B, C, P);
    if (inRectangle != 0)
    {
      return inRectangle > 0;
    }
    std::optional<int> sign = inCircleByLengths(A, B, C, P);
    sign = sign ? sign : inCircleBySharpCrosses(A, B, C, P);
    if (sign)
    {
      return *sign > 0;
    }
  }
  return conflictsExactly(a, b, c, p);
}

template <bool kCount, Access kAccess, bool kExact>
bool Kernel<kCount, kAccess, kExact>::conflictsExactly(Index a, Index b, Index c, Index p)
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
  return inConflictExact(xy_[a], xy_[b], xy_[c], xy_[p]);
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
  const std::optional<int> sharp = orient2dBySharpCross(a, b, q);
  const int side = sharp ? *sharp : orient2d(a, b, q);
  if (side != 0)
  {
    return side > 0;
  }
  return lexicographicallyLess(a, q) == lexicographicallyLess(q, b);
}

template <bool kCount, Access kAccess, bool kExact>
int Kernel<kCount, kAccess, kExact>::orientation(Index a, Index b, Index p)
{
  if (const std::optional<int> sharp = orient2dBySharpCross(xy_[a], xy_[b], xy_[p]))
  {
    return *sharp;
  }
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
  ++refills_;
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
