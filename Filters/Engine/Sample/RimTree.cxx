// SPDX-License-Identifier: BSD-3-Clause
#include "RimTree.h"

#include "../Core/Chunks.h"
#include "../Predicates/Predicates.h"
#include "NearestSeen.h"

#include <algorithm>
#include <numeric>

namespace ahd
{

namespace
{

/// What an edge counts: a distance, which may be an exact one.
constexpr std::size_t kStepsOfRimEdge = 8;

} // namespace

Segment RimTree::segmentOf(HalfEdge edge) const
{
  const bool isPiece = surface_.tables->triangles() == 0;
  const Point a = isPiece ? line_->at(line_->beginOf(edge))
                          : surface_.at(surface_.tables->origin(edge));
  const Point b = isPiece ? line_->at(line_->endOf(edge))
                          : surface_.at(surface_.tables->target(edge));
  return lexicographicallyLess(b, a) ? Segment{ b, a } : Segment{ a, b };
}

Box RimTree::boxOf(HalfEdge edge) const
{
  const Segment s = segmentOf(edge);
  return Box::around(s.left, s.right);
}

/// use(h) for the edges of the hull.
template <typename Use>
bool RimTree::forHull(Ticker& ticker, const Use& use) const
{
  const Tables& tables = *surface_.tables;
  HalfEdge first = 0;
  while (tables.twins[first] != kNoHalfEdge) // the curve begins at the hull, or soon comes to it
  {
    ++first;
    if (!ticker.step())
    {
      return false;
    }
  }
  HalfEdge h = first;
  do
  {
    use(h);
    h = tables.starts[tables.target(h)];
    if (!ticker.step())
    {
      return false;
    }
  } while (h != first);
  return true;
}

/// use(edge) for each that is listed: edges of the hull, and others seen from dropped triangles.
template <typename Use>
bool RimTree::forEachEdge(Ticker& ticker, const Use& use) const
{
  const Tables& tables = *surface_.tables;
  const auto useKept = [&](HalfEdge h)
  {
    if (h != kNoHalfEdge && surface_.isKept(h / 3) && (which_ == Rim || tables.isConstrained(h)))
    {
      use(h);
    }
  };
  const auto lookBack = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t t = a; t != b; ++t)
    {
      if (!surface_.isKept(t))
      {
        useKept(tables.twins[3 * t]);
        useKept(tables.twins[3 * t + 1]);
        useKept(tables.twins[3 * t + 2]);
      }
    }
  };
  const bool isWhole = tables.flags.empty() && !surface_.kept;
  return (which_ == Walls || forHull(ticker, useKept)) &&
    (isWhole || inChunks(0, tables.triangles(), ticker, lookBack));
}

bool RimTree::build(
  const SampledSurface& surface, const VertexLine& line, Edges which, Ticker& ticker)
{
  surface_ = surface;
  line_ = &line;
  which_ = which;
  if (surface.tables->triangles() == 0)
  {
    edges_.allocate(which == Rim ? line.pieces() : 0);
    std::iota(edges_.begin(), edges_.end(), HalfEdge(0));
  }
  else
  {
    std::size_t count = 0;
    if (!forEachEdge(ticker, [&count](HalfEdge) { ++count; }))
    {
      return false;
    }
    edges_.allocate(count);
    HalfEdge* to = edges_.data();
    if (!forEachEdge(ticker, [&to](HalfEdge h) { *to++ = h; }))
    {
      return false;
    }
  }
  levels_.allocate(edges_.size());
  if (!levels_.fitItems([this](std::size_t k) { return boxOf(edges_[k]); }, ticker))
  {
    return false;
  }
  if (levels_.levels() != 0)
  {
    const Box& all = levels_.box(levels_.levels() - 1, 0);
    largest_ = sizeOf(Bounds{ all.xmin, all.xmax, all.ymin, all.ymax });
  }
  return true;
}

RimPlace RimTree::placeOn(std::size_t item, const Point& place) const
{
  const Segment s = segmentOf(edges_[item]);
  return { true, edges_[item], s, nearestPartOf(s, place) };
}

bool RimTree::isNearer(const RimPlace& one, const RimPlace& other, const Point& place)
{
  const int nearer = other.is ? nearerOf(one.segment, other.segment, place) : 1;
  return nearer > 0 || (nearer == 0 && comesBefore(one.segment, other.segment));
}

namespace
{

/// Grown to all sides by more than a rounding where no coordinate of it or `other` is larger.
Box grownFor(const Box& other, const Box& b)
{
  const double by = 2.0 * roundingAt(std::max(sizeOf(b), sizeOf(other))); // sums round, too
  Box box;
  box.xmin = b.xmin - by;
  box.xmax = b.xmax + by;
  box.ymin = b.ymin - by;
  box.ymax = b.ymax + by;
  return box;
}

/// Is a box on one side of the line through a and b?
bool isBeside(const Box& box, const Point& a, const Point& b)
{
  const bool rises = (a.x < b.x) == (a.y < b.y); // the corners farthest to either side
  const Point left{ box.xmin, rises ? box.ymax : box.ymin };
  const Point right{ box.xmax, rises ? box.ymin : box.ymax };
  const int side = orient2d(a, b, left);
  return side != 0 && side == orient2d(a, b, right);
}

} // namespace

/// look(item, segment, grown), until it returns false, for edges whose boxes meet this one when it
/// is grown by more than a rounding there: one far point makes it large for its own edges alone.
template <typename Look>
bool RimTree::forNear(const Box& box, Ticker& ticker, const Look& look) const
{
  const auto enter = [&](const Box& b)
  {
    return !ticker.step()         ? Levels::Way::Stop
      : grownFor(b, box).meets(b) ? Levels::Way::In
                                  : Levels::Way::Past;
  };
  return levels_.visit(enter,
    [&](std::size_t leaf)
    {
      for (std::size_t k = levels_.childrenBegin(0, leaf); k != levels_.childrenEnd(0, leaf); ++k)
      {
        const Segment s = segmentOf(edges_[k]);
        const Box ofEdge = Box::around(s.left, s.right), grown = grownFor(ofEdge, box);
        if (grown.meets(ofEdge) && (!ticker.step(kStepsOfRimEdge) || !look(k, s, grown)))
        {
          return false;
        }
      }
      return true;
    });
}

bool RimTree::mayBeNear(const Box& box, Ticker& ticker, bool& isNear) const
{
  isNear = false;
  const auto look = [&isNear](std::size_t, const Segment& s, const Box& grown)
  { return !(isNear = !isBeside(grown, s.left, s.right)); };
  return forNear(box, ticker, look) || isNear;
}

bool RimTree::findWithinRounding(const Point& place, Ticker& ticker, RimPlace& found) const
{
  found = RimPlace();
  bool isWithinAny = false;
  std::size_t hint = 0;
  const auto look = [&](std::size_t item, const Segment& s, const Box&)
  {
    hint = item;
    return !(isWithinAny = isWithin(s, roundingAt(s, place), place));
  };
  return forNear(Box::around(place, place), ticker, look) ||
    (isWithinAny && findNearest(place, hint, ticker, found));
}

/// One call of findNearest().
class RimTree::Search
{
public:
  Search(const RimTree& tree, const Point& place)
    : tree_(tree)
    , place_(place)
    , seen_(place, tree.largest_)
  {
  }

  void look(std::size_t item)
  {
    const RimPlace one = tree_.placeOn(item, place_);
    const Point foot = footOf(one);
    const double size = std::max(sizeOf(one.segment.left), sizeOf(one.segment.right));
    const double rounded = one.part == NearestPart::Inside ? size : 0.0;
    if (!best_.is || (!seen_.isFarther(foot, 0.0, rounded) && isNearer(one, best_, place_)))
    {
      best_ = one;
      item_ = item;
      seen_.take(foot, rounded);
    }
  }

  bool mayHaveNearer(const Box& box) const { return !seen_.isFarther(box); }

  const RimPlace& best() const { return best_; }
  std::size_t item() const { return item_; }

private:
  /// Scaled and rounded. It may be far from the right one on the segment where that is much farther
  /// away than long; but its distance is right.
  Point footOf(const RimPlace& one) const
  {
    const Point a = seen_.scaled(one.segment.left), b = seen_.scaled(one.segment.right);
    if (one.part != NearestPart::Inside)
    {
      return one.part == NearestPart::Left ? a : b;
    }
    const Point p = seen_.scaled(place_), way{ b.x - a.x, b.y - a.y };
    const double part = ((p.x - a.x) * way.x + (p.y - a.y) * way.y) /
      (way.x * way.x + way.y * way.y);
    const double within = part > 0.0 ? std::min(part, 1.0) : 0.0;
    return { a.x + within * way.x, a.y + within * way.y };
  }

  const RimTree& tree_;
  const Point& place_;
  NearestSeen<true> seen_;
  RimPlace best_;
  std::size_t item_ = 0;
};

bool RimTree::findNearest(
  const Point& place, std::size_t& hint, Ticker& ticker, RimPlace& found) const
{
  found = RimPlace();
  if (edges_.empty())
  {
    return ticker.step();
  }
  Search search(*this, place);
  search.look(hint);
  const auto enter = [&](const Box& box)
  {
    return !ticker.step(kStepsOfRimEdge) ? Levels::Way::Stop
      : search.mayHaveNearer(box)        ? Levels::Way::In
                                         : Levels::Way::Past;
  };
  const auto look = [&](std::size_t leaf)
  {
    for (std::size_t k = levels_.childrenBegin(0, leaf); k != levels_.childrenEnd(0, leaf); ++k)
    {
      search.look(k);
    }
    return ticker.step(kStepsOfRimEdge * kStepsOfRimEdge);
  };
  const bool isDone = levels_.visit(enter, look);
  found = search.best();
  hint = search.item();
  return isDone;
}

bool RimTree::isBehind(const Point& from, HalfEdge wall, const Point& to) const
{
  const Point a = surface_.at(surface_.tables->origin(wall));
  const Point b = surface_.at(surface_.tables->target(wall));
  return orient2d(a, b, to) < 0 && orient2d(a, b, from) >= 0 && orient2d(from, a, to) > 0 &&
    orient2d(from, b, to) < 0;
}

bool RimTree::findWall(const Point& from, const Point& to, Ticker& ticker, HalfEdge& wall) const
{
  wall = kNoHalfEdge;
  const Box around = Box::around(from, to);
  const auto enter = [&](const Box& b)
  {
    return !ticker.step()                         ? Levels::Way::Stop
      : around.meets(b) && !isBeside(b, from, to) ? Levels::Way::In
                                                  : Levels::Way::Past;
  };
  const auto look = [&](std::size_t leaf)
  {
    for (std::size_t k = levels_.childrenBegin(0, leaf); k != levels_.childrenEnd(0, leaf); ++k)
    {
      if (around.meets(boxOf(edges_[k])) && isBehind(from, edges_[k], to))
      {
        wall = edges_[k];
        return false;
      }
    }
    return ticker.step(kStepsOfRimEdge);
  };
  return levels_.visit(enter, look) || wall != kNoHalfEdge;
}

} // namespace ahd
