// SPDX-License-Identifier: BSD-3-Clause
//
// Segments that cross others are taken out of the mesh again.
#include "InCurveOrder.h"

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "../Predicates/Predicates.h"

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
        if (edges.add(mesh_.origin(h), mesh_.destination(h), 0) == nullptr)
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
    for (const SegmentWalk::Piece& piece : walk.pieces())
    {
      visit(piece.from, piece.to);
    }
  }
  return true;
}

/// The segments that became any of these edges.
bool InCurveOrder::findUsers(const Edges& edges, std::vector<Segment>& users)
{
  constexpr std::size_t kLeastTask = std::size_t(1) << 12;
  const std::size_t most = mostCrossed();
  const std::size_t tasks = tasksFor(threadsOf(ticker_), segments_.size(), 1, kLeastTask);
  std::vector<std::vector<Segment>> found(tasks);
  const auto look = [&](std::size_t task, Ticker& own)
  {
    SegmentWalk walk(mesh_, own);
    const Share share(segments_.size(), task, tasks);
    std::vector<Segment> mine;
    for (std::size_t i = share.begin; i != share.end && mine.size() <= most; ++i)
    {
      bool isUser = false;
      const auto see = [&](Index u, Index v) { isUser |= edges.find(u, v) != nullptr; };
      if (!eachEdge(segments_[i], walk, see) || !own.step())
      {
        return false;
      }
      if (isUser)
      {
        mine.push_back(segments_[i]);
      }
    }
    found[task] = std::move(mine);
    return true;
  };
  if (!inParallel(ticker_, tasks, look))
  {
    return false;
  }
  for (const std::vector<Segment>& some : found)
  {
    users.insert(users.end(), some.begin(), some.end());
    if (!ticker_.step(some.size()))
    {
      return false;
    }
  }
  gaveUp_ = gaveUp_ || users.size() > most;
  return true;
}

/// Takes the constraint off the edge between two vertices, or puts it on. `suspects`: gets edges
/// that need not be locally Delaunay then.
bool InCurveOrder::setConstraint(
  Index u, Index v, bool isOn, SegmentWalk& walk, std::vector<Mesh::Halfedge>& suspects)
{
  if (walk.walk(u, v) != SegmentWalk::Outcome::Free || !ticker_.step())
  {
    return false;
  }
  const Mesh::Halfedge edge = walk.pieces().front().edge;
  if (mesh_.isConstrained(edge) == isOn)
  {
    return true;
  }
  if (isOn)
  {
    mesh_.constrain(edge);
    mesh_.constrain(mesh_.twin(edge));
    ++edges_;
    return true;
  }
  mesh_.release(edge);
  mesh_.release(mesh_.twin(edge));
  --edges_;
  suspects.push_back(edge);
  return true;
}

/// Flips edges until all are locally Delaunay, if these are the only ones that need not be. What is
/// flipped needs not be remembered: nothing is in conflict with a triangle that was there before
/// all segments, so both were made by a segment, in slots that are remembered since.
bool InCurveOrder::makeDelaunay(std::vector<Mesh::Halfedge>& suspects)
{
  CavityFiller cavity(mesh_, ticker_);
  std::size_t most = kReplacedAtLeast + segments_.size() * kMostReplaced;
  while (!suspects.empty())
  {
    const Mesh::Halfedge h = suspects.back(), g = mesh_.twin(h);
    suspects.pop_back();
    const Mesh::Slot first = Mesh::slotOf(h), second = Mesh::slotOf(g);
    if (!mesh_.isConstrained(h) && !mesh_.isGhost(first) && !mesh_.isGhost(second) &&
      inConflict(mesh_.at(mesh_.apex(h)), mesh_.at(mesh_.origin(h)), mesh_.at(mesh_.destination(h)),
        mesh_.at(mesh_.apex(g))))
    {
      if (most-- == 0)
      {
        gaveUp_ = true;
        return true;
      }
      cavity.flip(h);
      suspects.insert(suspects.end(), { first, first + 2, second, second + 2 });
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

/// These segments become nothing, and the mesh is as if they had never come.
bool InCurveOrder::takeOut(const std::vector<Segment>& crossed)
{
  SegmentWalk along(mesh_, ticker_), walk(mesh_, ticker_);
  std::vector<Mesh::Halfedge> suspects;
  Edges taken(ticker_);
  std::size_t count = 0;
  if (!taken.begin(crossed.size()))
  {
    return false;
  }
  bool done = true;
  const auto takeOff = [&](Index u, Index v)
  {
    ++count;
    done = done && taken.add(u, v, 0) != nullptr && setConstraint(u, v, false, walk, suspects);
  };
  for (const Segment& segment : crossed)
  {
    if (!eachEdge(segment, along, takeOff) || !done)
    {
      return false;
    }
    became_[segment.place] = kNothing;
    if (count > mostCrossed())
    {
      gaveUp_ = true;
      return true;
    }
  }
  // Others may be the same edges.
  std::vector<Segment> others;
  if (!findUsers(taken, others))
  {
    return false;
  }
  const auto putBack = [&](Index u, Index v)
  { done = done && setConstraint(u, v, true, walk, suspects); };
  for (const Segment& segment : others)
  {
    if (!eachEdge(segment, along, putBack) || !done)
    {
      return false;
    }
  }
  return gaveUp_ || makeDelaunay(suspects);
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
