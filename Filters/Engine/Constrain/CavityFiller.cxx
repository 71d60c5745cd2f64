// SPDX-License-Identifier: BSD-3-Clause
#include "CavityFiller.h"

#include "../Core/Chunks.h"

#include <algorithm>

namespace ahd
{

template <typename Visit>
bool CavityFiller::eachEdge(const Side& side, Visit visit)
{
  return inChunks(0, side.old.size(), ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t p = a; p != b; ++p)
      {
        visit(p);
      }
    });
}

template <typename Visit>
bool CavityFiller::eachSlot(Visit visit)
{
  return inChunks(0, slots_.size(), ticker_,
    [&](std::size_t a, std::size_t b)
    { std::for_each(slots_.data() + a, slots_.data() + b, visit); });
}

void CavityFiller::Side::clear()
{
  corners.clear();
  old.clear();
}

void CavityFiller::Side::add(Index corner, Mesh::Halfedge edge)
{
  corners.push_back(corner);
  old.push_back(edge);
}

/// The triangles to go, and the two polygons.
///
///       left            first triangle: from, right, left; the edge crossed runs right -> left
///      /    \           in it. Each one after it has one corner more, on one of the sides.
///   from      apex
///      \    /
///       right
bool CavityFiller::collect(Index from, Index to, const Mesh::Halfedge* crossed, std::size_t count)
{
  right_.clear();
  left_.clear();
  slots_.assign(1, Mesh::slotOf(crossed[0]));
  right_.add(from, Mesh::previous(crossed[0]));
  left_.add(mesh_.destination(crossed[0]), Mesh::next(crossed[0]));
  for (std::size_t i = 0; i < count; ++i)
  {
    const Mesh::Halfedge ahead = mesh_.twin(crossed[i]); // left -> right
    slots_.push_back(Mesh::slotOf(ahead));
    const bool toRight = i + 1 < count && crossed[i + 1] == Mesh::previous(ahead);
    const bool toLeft = i + 1 < count && !toRight;
    if (!toLeft) // the edge right -> apex is on the border
    {
      right_.add(mesh_.destination(ahead), Mesh::next(ahead));
    }
    if (!toRight) // and apex -> left
    {
      left_.add(mesh_.apex(ahead), Mesh::previous(ahead));
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  right_.corners.push_back(to);
  // From `to` back to `from`: corner p is where edge p begins.
  std::reverse(left_.corners.begin(), left_.corners.end());
  std::reverse(left_.old.begin(), left_.old.end());
  left_.corners.push_back(from);
  return true;
}

bool CavityFiller::lookBeyond(Side& side)
{
  side.beyond.resize(side.old.size());
  side.flags.resize(side.old.size());
  bool anyHanging = false;
  const auto look = [&](std::size_t p)
  {
    const Mesh::Halfedge h = side.old[p];
    side.beyond[p] = mesh_.twin(h);
    const bool hangs = (mesh_.marks(side.beyond[p]) & kInCavity) != 0;
    side.flags[p] = static_cast<std::uint8_t>(
      (mesh_.isConstrained(h) ? kConstrained : 0) | (hangs ? kHanging : 0));
    anyHanging = anyHanging || hangs;
  };
  if (!eachEdge(side, look) || !anyHanging)
  {
    return !ticker_.cancelled();
  }
  // Places instead of twins: removed triangles need no links.
  const auto writePlace = [&](std::size_t p)
  {
    if ((side.flags[p] & kHanging) != 0)
    {
      mesh_.data()[side.old[p] + Mesh::kTwin] = static_cast<std::uint32_t>(p);
    }
  };
  const auto readPlace = [&](std::size_t p)
  {
    if ((side.flags[p] & kHanging) != 0)
    {
      side.beyond[p] = mesh_.data()[side.beyond[p] + Mesh::kTwin];
    }
  };
  return eachEdge(side, writePlace) && eachEdge(side, readPlace);
}

bool CavityFiller::fillSide(Side& side, const Mesh::Slot* slots)
{
  return filler_.fill(side.corners, slots) &&
    eachEdge(side, [&](std::size_t p) { side.old[p] = filler_.inner(p); });
}

bool CavityFiller::join(Side& side)
{
  return eachEdge(side,
    [&](std::size_t p)
    {
      const bool hangs = (side.flags[p] & kHanging) != 0;
      mesh_.link(side.old[p], hangs ? side.old[side.beyond[p]] : side.beyond[p]);
      if ((side.flags[p] & kConstrained) != 0)
      {
        mesh_.constrain(side.old[p]);
      }
    });
}

/// The same as fill() for a segment that crosses one edge, as most short ones do.
///
///       left                    left
///      /  |  \                 /     \        h: right -> left in (from, right, left) and its twin
///      in
///   from  |  to       to    from --- to       (to, left, right) become (from, right, to) and
///      \  |  /                 \     /        (to, left, from)
///       right                   right
void CavityFiller::flip(Mesh::Halfedge h)
{
  const Mesh::Halfedge g = mesh_.twin(h);
  const Mesh::Halfedge old[4] = { Mesh::next(g), Mesh::previous(h), Mesh::next(h),
    Mesh::previous(g) }; // right -> to, from -> right, left -> from, to -> left
  Mesh::Halfedge beyond[4];
  bool isConstrained[4];
  for (int i = 0; i < 4; ++i)
  {
    beyond[i] = mesh_.twin(old[i]);
    isConstrained[i] = mesh_.isConstrained(old[i]);
  }
  const Mesh::Slot first = Mesh::slotOf(h), second = Mesh::slotOf(g);
  const Index from = mesh_.apex(h), right = mesh_.origin(h);
  const Index to = mesh_.apex(g), left = mesh_.origin(g);
  const Index corners[2][3] = { { from, right, to }, { to, left, from } };
  std::copy(corners[0], corners[0] + 3, mesh_.data() + first);
  std::copy(corners[1], corners[1] + 3, mesh_.data() + second);
  mesh_.marks(first) = mesh_.marks(second) = 0;
  mesh_.setCorners(first);
  mesh_.setCorners(second);
  const Mesh::Halfedge placed[4] = { first, first + 2, second, second + 2 };
  for (int i = 0; i < 4; ++i)
  {
    mesh_.link(placed[i], beyond[i]);
    if (isConstrained[i])
    {
      mesh_.constrain(placed[i]);
    }
  }
  made_ = second + 1;
  mesh_.link(made_, first + 1);
}

bool CavityFiller::fill(Index from, Index to, const Mesh::Halfedge* crossed, std::size_t count)
{
  if (count == 1)
  {
    flip(crossed[0]);
    return true;
  }
  const auto mark = [this](Mesh::Slot slot) { mesh_.marks(slot) |= kInCavity; };
  if (!collect(from, to, crossed, count) || !eachSlot(mark) || !lookBeyond(right_) ||
    !lookBeyond(left_) || !fillSide(right_, slots_.data()))
  {
    return false;
  }
  const Mesh::Halfedge back = filler_.inner(right_.corners.size() - 1);
  if (!fillSide(left_, slots_.data() + right_.corners.size() - 2))
  {
    return false;
  }
  made_ = filler_.inner(left_.corners.size() - 1);
  const auto renew = [this](Mesh::Slot slot)
  {
    mesh_.marks(slot) = 0;
    mesh_.setCorners(slot);
  };
  if (!eachSlot(renew) || !join(right_) || !join(left_))
  {
    return false;
  }
  mesh_.link(made_, back);
  return true;
}

} // namespace ahd
