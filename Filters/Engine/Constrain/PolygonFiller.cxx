// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonFiller.h"

#include "../Core/Chunks.h"
#include "../Predicates/Predicates.h"

#include <utility>

namespace ahd
{

namespace
{
/// With fewer corners than this, cutting ears and flipping is faster.
constexpr std::size_t kManyCorners = 48;
}

int PolygonFiller::orientation(Index a, Index b, Index c) const
{
  return orient2d(xy_[a], xy_[b], xy_[c]);
}

void PolygonFiller::attach(Mesh::Halfedge h, Side side)
{
  data_[h + Mesh::kTwin] = side;
  if (isBorder(side))
  {
    inner_[side / 8] = h;
  }
  else
  {
    data_[side + Mesh::kTwin] = h;
  }
}

/// A triangle in a free slot: its edges 0, 1, 2 run b -> c, c -> a, a -> b.
Mesh::Slot PolygonFiller::place(Index a, Index b, Index c)
{
  const Mesh::Slot slot = free_.back();
  free_.pop_back();
  data_[slot] = a;
  data_[slot + 1] = b;
  data_[slot + 2] = c;
  return slot;
}

bool PolygonFiller::fill(const std::vector<Index>& corners, const Mesh::Slot* slots)
{
  const std::size_t count = corners.size();
  corners_ = &corners;
  cancelled_ = false;
  inner_.assign(count, kNoIndex);
  suspects_.clear();
  for (std::size_t i = 0; i < count - 2; ++i)
  {
    for (unsigned e = 0; e < 3; ++e)
    {
      suspects_.push_back(slots[i] + e);
    }
  }
  free_.assign(slots, slots + (count - 2));
  bool filled = count >= kManyCorners && insertAll();
  if (!filled && !cancelled_)
  {
    free_.assign(slots, slots + (count - 2));
    filled = cutEars();
  }
  return filled && makeDelaunay();
}

/// One corner after the other; as long as the last three turn left, the middle one is an ear. As
/// every corner can be seen from the base, in the order of the corners, none is left in the end
/// (G. T. Toussaint, D. Avis, "On a convex hull algorithm for polygons and its application to
/// triangulation problems", 1982).
bool PolygonFiller::cutEars()
{
  const std::vector<Index>& at = *corners_;
  sides_.resize(at.size());
  stack_.clear();
  for (std::uint32_t r = 0; r < at.size(); ++r)
  {
    sides_[r] = border(r);
    while (stack_.size() >= 2)
    {
      const std::uint32_t q = stack_.back();
      const std::uint32_t p = stack_[stack_.size() - 2];
      if (!ticker_.step())
      {
        cancelled_ = true;
        return false;
      }
      if (orientation(at[p], at[q], at[r]) <= 0)
      {
        break;
      }
      const Mesh::Slot slot = place(at[p], at[q], at[r]);
      attach(slot + 2, sides_[p]);
      attach(slot, sides_[q]);
      sides_[p] = slot + 1;
      stack_.pop_back();
    }
    stack_.push_back(r);
  }
  attach(sides_[0], border(at.size() - 1));
  return true;
}

std::uint32_t PolygonFiller::random(std::uint32_t below)
{
  random_ = random_ * 6364136223846793005u + 1442695040888963407u;
  return static_cast<std::uint32_t>((random_ >> 32) * below >> 32);
}

/// A random order of the corners, from the last to the first, each taken out of the polygon: but
/// never one that is nearer to the base than both its neighbours, as the polygon without it might
/// reach across the base. The distances are rounded; insertAll() detects it where that misleads.
bool PolygonFiller::chooseOrder()
{
  const std::uint32_t last = static_cast<std::uint32_t>(corners_->size() - 1);
  random_ = last;
  for (std::uint32_t i = last - 1; i > 1; --i)
  {
    std::swap(order_[i], order_[1 + random(i)]);
    cancelled_ = cancelled_ || !ticker_.step();
  }
  const auto isNearest = [this](std::uint32_t i)
  { return distance_[i] < distance_[previous_[i]] && distance_[i] < distance_[next_[i]]; };
  for (std::uint32_t i = last - 1; i > 1 && !cancelled_; --i)
  {
    while (isNearest(order_[i]))
    {
      std::swap(order_[i], order_[1 + random(i - 1)]);
    }
    const std::uint32_t taken = order_[i];
    next_[previous_[taken]] = next_[taken];
    previous_[next_[taken]] = previous_[taken];
    cancelled_ = !ticker_.step();
  }
  return !cancelled_;
}

/// The corners in a ring, and how far each is from the base.
bool PolygonFiller::makeRing()
{
  const std::vector<Index>& at = *corners_;
  const std::size_t last = at.size() - 1;
  const Point& from = xy_[at[last]];
  const Point& to = xy_[at[0]];
  next_.resize(at.size());
  previous_.resize(at.size());
  order_.resize(at.size());
  distance_.resize(at.size());
  const auto set = [&](std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i != end; ++i)
    {
      next_[i] = static_cast<std::uint32_t>(i + 1);
      previous_[i] = static_cast<std::uint32_t>(i - 1);
      order_[i] = static_cast<std::uint32_t>(i);
      const Point& p = xy_[at[i]];
      const bool isOnBase = i == 0 || i == last;
      distance_[i] = isOnBase ? 0.0
                              : (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    }
  };
  cancelled_ = !inChunks(0, at.size(), ticker_, set);
  return !cancelled_;
}

/// Returns false if it did not succeed, or was cancelled.
bool PolygonFiller::insertAll()
{
  if (!makeRing() || !chooseOrder())
  {
    return false;
  }
  const std::uint32_t last = static_cast<std::uint32_t>(corners_->size() - 1);
  inner_[0] = border(last); // the triangle across the edge from the first corner to the last
  for (std::uint32_t i = 1; i < last; ++i)
  {
    const std::uint32_t corner = order_[i];
    next_[previous_[corner]] = corner;
    previous_[next_[corner]] = corner;
    if (!insert(corner))
    {
      return false;
    }
  }
  return true;
}

/// Is the triangle from -> vertex -> to invalid or not Delaunay, so that the one behind the edge
/// must be removed?
bool PolygonFiller::belongsToHole(const HoleEdge& edge, Index vertex) const
{
  if (orientation(edge.from, vertex, edge.to) <= 0)
  {
    return true;
  }
  if (isBorder(edge.side))
  {
    return false;
  }
  const Index behind = data_[edge.side];
  return behind != vertex && inConflict(xy_[edge.from], xy_[vertex], xy_[edge.to], xy_[behind]);
}

/// Joins a corner to the vertex that it sees through the edge between its neighbours.
///
///      behind         The edge from -> to has the corner on its right (it may also be the other
///      way /    \         round) and a triangle or the border behind it. Triangle from-corner-to
///      if that
///   from --> to       is Delaunay; else the triangle behind goes, and its other two edges take the
///      \    /         place of this one.
///      corner
bool PolygonFiller::insert(std::uint32_t corner)
{
  const std::vector<Index>& at = *corners_;
  const std::uint32_t w = previous_[corner];
  const Index vertex = at[corner];
  hole_.clear();
  hole_.push_back({ at[w], at[next_[corner]], inner_[w] });
  Side before = border(w);
  while (!hole_.empty())
  {
    const HoleEdge edge = hole_.back();
    hole_.pop_back();
    if (!ticker_.step())
    {
      cancelled_ = true;
      return false;
    }
    if (!belongsToHole(edge, vertex))
    {
      const Mesh::Slot slot = place(edge.from, vertex, edge.to);
      attach(slot + 1, edge.side);
      attach(slot + 2, before);
      before = slot;
      continue;
    }
    if (isBorder(edge.side))
    {
      return false;
    }
    const Mesh::Halfedge h = edge.side;
    const Index behind = data_[h];
    hole_.push_back({ behind, edge.to, data_[Mesh::next(h) + Mesh::kTwin] });
    hole_.push_back({ edge.from, behind, data_[Mesh::previous(h) + Mesh::kTwin] });
    free_.push_back(Mesh::slotOf(h));
  }
  attach(before, border(corner));
  return true;
}

/// Flips edges until each is locally Delaunay.
bool PolygonFiller::makeDelaunay()
{
  while (!suspects_.empty())
  {
    const Mesh::Halfedge h = suspects_.back();
    suspects_.pop_back();
    const Side twin = data_[h + Mesh::kTwin];
    if (!ticker_.step())
    {
      return false;
    }
    if (!isBorder(twin) &&
      inConflict(
        xy_[data_[h]], xy_[data_[Mesh::next(h)]], xy_[data_[Mesh::previous(h)]], xy_[data_[twin]]))
    {
      flip(h);
    }
  }
  return true;
}

///         c                   c            h: b -> c in (a, b, c) and its twin in (d, c, b) become
///       / | \               /   \          (a, b, d) and (d, c, a)
///      a  |  d     to      a --- d
///       \ | /               \   /
///         b                   b
void PolygonFiller::flip(Mesh::Halfedge h)
{
  const Mesh::Halfedge g = data_[h + Mesh::kTwin];
  const Index a = data_[h], b = data_[Mesh::next(h)];
  const Index d = data_[g], c = data_[Mesh::next(g)];
  const Side ab = data_[Mesh::previous(h) + Mesh::kTwin];
  const Side ca = data_[Mesh::next(h) + Mesh::kTwin];
  const Side bd = data_[Mesh::next(g) + Mesh::kTwin];
  const Side dc = data_[Mesh::previous(g) + Mesh::kTwin];
  free_.push_back(Mesh::slotOf(g));
  free_.push_back(Mesh::slotOf(h));
  const Mesh::Slot first = place(a, b, d);
  const Mesh::Slot second = place(d, c, a);
  attach(first, bd);
  attach(first + 2, ab);
  attach(second, ca);
  attach(second + 2, dc);
  attach(first + 1, second + 1);
  for (const Mesh::Halfedge side : { first, first + 2, second, second + 2 })
  {
    suspects_.push_back(side);
  }
}

} // namespace ahd
