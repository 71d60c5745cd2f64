// SPDX-License-Identifier: BSD-3-Clause
//
// Segments that cross others are taken out of the mesh again.
#include "InCurveOrder.h"

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "../Predicates/Predicates.h"

#include <numeric>
#include <utility>

namespace ahd
{

/// The constraint edges that these segments cross.
bool InCurveOrder::findCrossedEdges(const std::vector<Segment>& crossing, Edges& edges)
{
  SegmentWalk walk(mesh_, ticker_);
  std::size_t most = mostCrossed();
  for (const Segment& segment : crossing)
  {
    if (walk.walkAcross(segment.from, segment.to) != SegmentWalk::Outcome::Free)
    {
      return false;
    }
    for (const Mesh::Halfedge h : walk.crossed())
    {
      if (mesh_.isConstrained(h))
      {
        if (most-- == 0)
        {
          gaveUp_ = true;
          return true;
        }
        if (edges.add(mesh_.origin(h), mesh_.destination(h), kFound) == nullptr)
        {
          return false;
        }
      }
      if (!ticker_.step())
      {
        return false;
      }
    }
  }
  return true;
}

/// Calls visit(u, v) for each edge that a segment became.
template <typename Visit>
bool InCurveOrder::eachEdge(const Segment& segment, SegmentWalk& walk, Visit visit) const
{
  if (became_[segment.place] == kEdge)
  {
    visit(segment.from, segment.to);
  }
  else if (became_[segment.place] == kRow)
  {
    if (walk.walk(segment.from, segment.to) != SegmentWalk::Outcome::Free)
    {
      return false;
    }
    for (const WalkPiece& piece : walk.pieces())
    {
      visit(piece.from, piece.to);
    }
  }
  return true;
}

/// Calls visit(u, v) for those of the edges that the segment became and no other is known to use.
template <typename Visit>
bool InCurveOrder::eachOf(const Edges& edges, const Segment& segment, Uses& uses, Visit visit) const
{
  const auto isOne = [&](Index u, Index v)
  {
    const std::uint8_t* const use = edges.find(u, v);
    return use != nullptr && *use != kShared;
  };
  if (became_[segment.place] != kRow)
  {
    if (became_[segment.place] == kEdge && isOne(segment.from, segment.to))
    {
      visit(segment.from, segment.to);
    }
    return true;
  }
  if (uses.walk.walk(segment.from, segment.to) != SegmentWalk::Outcome::Free)
  {
    return false;
  }
  const std::vector<WalkPiece>& pieces = uses.walk.pieces();
  const WalkPiece* without = pieces.data();
  for (const WalkPiece& piece : pieces)
  {
    if (!uses.without.isRow(piece) && isOne(piece.from, piece.to))
    {
      visit(piece.from, piece.to);
      if (!uses.without.remember(without, &piece))
      {
        return false;
      }
      without = &piece + 1;
    }
  }
  return uses.without.remember(without, pieces.data() + pieces.size());
}

/// The segments that became any of these edges.
bool InCurveOrder::findUsers(const Edges& edges, std::vector<Segment>& users)
{
  constexpr std::size_t kLeastTask = std::size_t(1) << 12;
  const std::size_t most = mostCrossed();
  const std::size_t tasks = tasksFor(threadsOf(ticker_), segments_.size(), 1, kLeastTask);
  std::vector<std::vector<Segment>> found(tasks);
  std::vector<std::size_t> uses(tasks);
  const auto look = [&](std::size_t task, Ticker& own)
  {
    Uses known(mesh_, own);
    const Share share(segments_.size(), task, tasks);
    std::vector<Segment> mine;
    std::size_t count = 0;
    for (std::size_t i = share.begin; i != share.end && count <= most; ++i)
    {
      const std::size_t before = count;
      const auto see = [&](Index, Index) { ++count; };
      if (!eachOf(edges, segments_[i], known, see) || !own.step())
      {
        return false;
      }
      if (count != before)
      {
        grown_.add(mine, segments_[i]);
      }
    }
    found[task] = std::move(mine);
    uses[task] = count;
    return true;
  };
  if (!inParallel(ticker_, tasks, look))
  {
    return false;
  }
  std::size_t count = 0;
  for (const std::vector<Segment>& some : found)
  {
    count += some.size();
  }
  grown_.take(sizeof(Segment) * count);
  users.reserve(count);
  for (const std::vector<Segment>& some : found)
  {
    users.insert(users.end(), some.begin(), some.end());
    if (!ticker_.step(some.size()))
    {
      return false;
    }
  }
  gaveUp_ = gaveUp_ || std::accumulate(uses.begin(), uses.end(), std::size_t(0)) > most;
  return true;
}

/// The edges of these segments, whose outcome becomes kNothing: each once, in their order.
bool InCurveOrder::findEdges(
  const std::vector<Segment>& segments, Edges& edges, std::vector<Made>& list)
{
  SegmentWalk walk(mesh_, ticker_);
  bool done = true;
  std::size_t most = mostCrossed();
  const auto add = [&](Index u, Index v)
  {
    std::uint8_t* const use = done ? edges.add(u, v, kFound) : nullptr;
    done = use != nullptr;
    if (done && *use == kFound)
    {
      *use = kListed;
      grown_.add(list, Made{ u, v });
    }
  };
  for (const Segment& segment : segments)
  {
    if (!eachEdge(segment, walk, add) || !done || !ticker_.step())
    {
      return false;
    }
    const std::size_t count = became_[segment.place] == kRow ? walk.pieces().size() : 1;
    became_[segment.place] = kNothing;
    gaveUp_ = gaveUp_ || count > most;
    if (gaveUp_)
    {
      return true;
    }
    most -= count;
  }
  return true;
}

/// Finds out which of the edges other segments use.
bool InCurveOrder::findShared(Edges& edges)
{
  std::vector<Segment> others;
  if (!findUsers(edges, others) || gaveUp_)
  {
    return gaveUp_;
  }
  Uses uses(mesh_, ticker_);
  bool done = true;
  const auto share = [&](Index u, Index v)
  {
    std::uint8_t* const use = done ? edges.add(u, v, kFound) : nullptr;
    done = use != nullptr;
    if (done)
    {
      *use = kShared;
    }
  };
  for (const Segment& other : others)
  {
    if (!eachOf(edges, other, uses, share) || !done || !ticker_.step())
    {
      return false;
    }
  }
  return true;
}

/// Flips edges until all are locally Delaunay, if the suspects are the only ones that need not be.
bool InCurveOrder::makeDelaunay(CavityFiller& cavity)
{
  while (!suspects_.empty())
  {
    const Mesh::Halfedge h = suspects_.back(), g = mesh_.twin(h);
    suspects_.pop_back();
    const Mesh::Slot first = Mesh::slotOf(h), second = Mesh::slotOf(g);
    if (!mesh_.isConstrained(h) && !mesh_.isGhost(first) && !mesh_.isGhost(second) &&
      inConflict(mesh_.at(mesh_.apex(h)), mesh_.at(mesh_.origin(h)), mesh_.at(mesh_.destination(h)),
        mesh_.at(mesh_.apex(g))))
    {
      cavity.flip(h);
      suspects_.insert(suspects_.end(), { first, first + 2, second, second + 2 });
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

/// The edge is no constraint any more, and need not be locally Delaunay.
void InCurveOrder::takeMark(Mesh::Halfedge edge)
{
  mesh_.release(edge);
  mesh_.release(mesh_.twin(edge));
  --edges_;
  suspects_.push_back(edge);
}

/// These edges are no constraints any more, and the mesh is as if they had never been inserted: the
/// last one first, so that each flips as few edges as it crossed when it came. `edges`: but for
/// those that others share.
bool InCurveOrder::release(const std::vector<Made>& list, const Edges* edges)
{
  SegmentWalk walk(mesh_, ticker_);
  CavityFiller cavity(mesh_, ticker_);
  for (auto made = list.rbegin(); made != list.rend(); ++made)
  {
    if (edges != nullptr && *edges->find(made->from, made->to) == kShared)
    {
      continue;
    }
    if (walk.walk(made->from, made->to) != SegmentWalk::Outcome::Free || !ticker_.step())
    {
      return false;
    }
    for (const WalkPiece& piece : walk.pieces())
    {
      takeMark(piece.edge);
    }
    if (!makeDelaunay(cavity))
    {
      return false;
    }
  }
  return true;
}

/// No edge is a constraint any more. Flips may move one to triangles already visited: so the search
/// repeats while there are any.
bool InCurveOrder::releaseRest()
{
  CavityFiller cavity(mesh_, ticker_);
  for (std::size_t k = 0; edges_ != 0; k = k + 1 == mesh_.triangles() ? 0 : k + 1)
  {
    const Mesh::Halfedge first = Mesh::slotOfTriangle(k);
    for (Mesh::Halfedge h = first; h != first + 3 && mesh_.marks(first) != 0; ++h)
    {
      if (mesh_.isConstrained(h))
      {
        takeMark(h);
      }
    }
    if (!makeDelaunay(cavity) || !ticker_.step())
    {
      return false;
    }
  }
  return true;
}

/// Takes these segments out.
bool InCurveOrder::takeOut(std::vector<Segment>& crossed)
{
  Edges edges(ticker_);
  std::vector<Made> list;
  return edges.begin(crossed.size()) && inRounds(crossed) && findEdges(crossed, edges, list) &&
    (gaveUp_ || findShared(edges)) && (gaveUp_ || release(list, &edges));
}

/// Takes all segments out.
bool InCurveOrder::undo()
{
  for (auto territory = territories_.rbegin(); territory != territories_.rend(); ++territory)
  {
    if (!release(territory->made, nullptr))
    {
      return false;
    }
    territory->made = std::vector<Made>();
  }
  return releaseRest();
}

bool InCurveOrder::takeOutCrossed()
{
  std::vector<Segment> crossing, crossed;
  Edges edges(ticker_);
  if (!gather(&Territory::crossing, crossing))
  {
    return false;
  }
  if (crossing.empty())
  {
    return true;
  }
  return edges.begin(crossing.size()) && findCrossedEdges(crossing, edges) &&
    (gaveUp_ || findUsers(edges, crossed)) && (gaveUp_ || takeOut(crossed));
}

} // namespace ahd
