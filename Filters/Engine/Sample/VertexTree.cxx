// SPDX-License-Identifier: BSD-3-Clause
#include "VertexTree.h"

#include "../Core/Loops.h"
#include "../Predicates/Circles.h"
#include "NearestSeen.h"

#include <algorithm>
#include <utility>

namespace ahd
{

/// One call of findNearest(). With walls no vertex counts that is behind one.
template <bool hasWalls>
class VertexTree::Search
{
public:
  Search(const VertexTree& tree, const Point& place, const RimTree* walls)
    : tree_(tree)
    , place_(place)
    , walls_(walls)
    , seen_(place, tree.largest_)
  {
  }

  /// Is it nearer than the best so far? Returns false if cancelled.
  bool look(std::size_t k, Ticker& ticker)
  {
    const Point p = tree_.at(k);
    const Point c = seen_.scaled(p);
    const double d = seen_.squaredDistance(c);
    if (seen_.isCertainlyNearer(d) || (!seen_.isFarther(c, d) && isBefore(p)))
    {
      bool counts = true;
      if (hasWalls && !isInFront(p, ticker, counts))
      {
        return false;
      }
      if (counts)
      {
        best_ = k;
        seen_.take(c);
      }
    }
    return true;
  }

  /// Until one is found, only those are looked at that are not farther than this, scaled. @pre none
  void limit(double distance) { seen_.take(seen_.beside(distance)); }

  double distance() const { return seen_.distance(); }
  bool hasFound() const { return best_ != kNone; }

  bool mayHaveNearer(const Box& b) const
  {
    return !seen_.isFarther(b) && !(hasWalls && isBehind(b));
  }

  std::size_t best() const { return best_; }

private:
  static constexpr std::size_t kNone = std::size_t(-1);

  bool isBefore(const Point& p) const
  {
    if (!hasFound())
    {
      return true;
    }
    const Point q = tree_.at(best_);
    const int nearer = nearerOf(p, q, place_);
    return nearer > 0 || (nearer == 0 && lexicographicallyLess(p, q));
  }

  /// What is behind one wall mostly is with its neighbours. Returns false if cancelled.
  bool isInFront(const Point& p, Ticker& ticker, bool& is)
  {
    is = false;
    if (wall_ != kNoHalfEdge && walls_->isBehind(place_, wall_, p))
    {
      return ticker.step();
    }
    HalfEdge wall = kNoHalfEdge;
    const bool isDone = walls_->findWall(place_, p, ticker, wall);
    is = wall == kNoHalfEdge;
    wall_ = is ? wall_ : wall;
    return isDone;
  }

  /// All of a box: what is behind a wall is convex.
  bool isBehind(const Box& b) const
  {
    return wall_ != kNoHalfEdge && walls_->isBehind(place_, wall_, { b.xmin, b.ymin }) &&
      walls_->isBehind(place_, wall_, { b.xmax, b.ymin }) &&
      walls_->isBehind(place_, wall_, { b.xmin, b.ymax }) &&
      walls_->isBehind(place_, wall_, { b.xmax, b.ymax });
  }

  const VertexTree& tree_;
  const Point& place_;
  const RimTree* walls_;
  HalfEdge wall_ = kNoHalfEdge; ///< the last one that a vertex was behind
  std::size_t best_ = kNone;
  NearestSeen<false> seen_; ///< infinitely far at first
};

/// Takes out those that are in triangles, all of which loops or trim() dropped.
bool VertexTree::leaveOutDropped(const TriangulationAccess::State& state, Ticker& ticker)
{
  const Tables& tables = state.tables;
  Buffer<unsigned char> isKept;
  isKept.allocate(state.ranked.count);
  const auto mark = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t h = 3 * a; h != 3 * b; ++h)
    {
      isKept[tables.corners[h]] |= static_cast<unsigned char>(tables.isKept(h / 3));
    }
  };
  Buffer<Index> all(std::move(vertices_));
  vertices_ = Buffer<Index>();
  std::size_t count = 0;
  const auto counts = [&](Index v) { return isKept[v] != 0 || tables.starts[v] == kNoHalfEdge; };
  const auto countThem = [&](std::size_t a, std::size_t b)
  { count += std::size_t(std::count_if(all.data() + a, all.data() + b, counts)); };
  if (!fillAll(isKept, 0, ticker) || !inChunks(0, tables.triangles(), ticker, mark) ||
    !inChunks(0, all.size(), ticker, countThem))
  {
    return false;
  }
  vertices_.allocate(count);
  Index* to = vertices_.data();
  return inChunks(0, all.size(), ticker,
    [&](std::size_t a, std::size_t b)
    { to = std::copy_if(all.data() + a, all.data() + b, to, counts); });
}

bool VertexTree::build(const TriangulationAccess::State& state, Ticker& ticker)
{
  places_ = state.ranked.xy.data();
  largest_ = sizeOf(state.ranked.bounds);
  if (!listInserted(state, vertices_, ticker) ||
    (!state.tables.flags.empty() && !leaveOutDropped(state, ticker)))
  {
    return false;
  }
  levels_.allocate(vertices_.size());
  const auto boxOf = [&](std::size_t k)
  {
    const Point p = at(k);
    return Box::around(p, p);
  };
  return levels_.fitItems(boxOf, ticker);
}

/// Returns false if cancelled.
template <bool hasWalls>
bool VertexTree::run(Search<hasWalls>& search, Ticker& ticker) const
{
  const auto enter = [&](const Box& box)
  {
    return !ticker.step(8)        ? Levels::Way::Stop
      : search.mayHaveNearer(box) ? Levels::Way::In
                                  : Levels::Way::Past;
  };
  const auto look = [&](std::size_t leaf)
  {
    for (std::size_t k = levels_.childrenBegin(0, leaf); k != levels_.childrenEnd(0, leaf); ++k)
    {
      if (!search.look(k, ticker))
      {
        return false;
      }
    }
    return true;
  };
  return levels_.visit(enter, look);
}

bool VertexTree::findNearest(const Point& place, const RimTree& walls, std::size_t hint,
  Ticker& ticker, std::size_t& found) const
{
  Search<false> all(*this, place, nullptr);
  HalfEdge wall = kNoHalfEdge;
  if (!all.look(hint, ticker) || !run(all, ticker) ||
    (!walls.empty() && !walls.findWall(place, at(all.best()), ticker, wall)))
  {
    return false;
  }
  found = all.best();
  if (wall == kNoHalfEdge)
  {
    return true;
  }
  // Hidden ones do not end the search: each must be asked about, so the nearer ones come first.
  Search<true> inFront(*this, place, &walls);
  constexpr double kLeast = 0x1p-280; // squares of less are the same
  for (double reach = std::max(kLeast, 2.0 * all.distance()); !inFront.hasFound(); reach *= 2.0)
  {
    inFront.limit(reach);
    if (!inFront.look(hint, ticker) || !run(inFront, ticker))
    {
      return false;
    }
  }
  found = inFront.best();
  return true;
}

} // namespace ahd
