// SPDX-License-Identifier: BSD-3-Clause
#include "VertexTree.h"

#include "../Core/Chunks.h"
#include "../Core/Loops.h"
#include "../Predicates/Circles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

double sizeOf(const Point& p)
{
  return std::max(std::fabs(p.x), std::fabs(p.y));
}

void extend(Bounds& bounds, const Bounds& more)
{
  bounds = { std::min(bounds.xmin, more.xmin), std::max(bounds.xmax, more.xmax),
    std::min(bounds.ymin, more.ymin), std::max(bounds.ymax, more.ymax) };
}

/// What two squared distances that are the same may differ by, as a part of either: each has two
/// rounded differences, squares and a sum. An exact comparison is for what differs by less.
constexpr double kSame = 0x1p-48;
/// ... or by less than this: it is far more than squares can lose where they underflow.
constexpr double kGuard = 0x1p-1000;

} // namespace

/// One call of findNearest().
class VertexTree::Search
{
public:
  Search(const VertexTree& tree, const Point& place)
    : tree_(tree)
    , place_(place)
    , scale_(std::max(sizeOf(place), tree.largest_) > 0x1p500 ? 0x1p-600 : 1.0)
  {
  }

  /// Is it nearer than the best so far?
  void look(std::size_t k)
  {
    const Point p = tree_.places_[tree_.vertices_[k]];
    const double d = squared(p.x * scale_ - place_.x * scale_, p.y * scale_ - place_.y * scale_);
    if (best_ == kNone || d + kGuard < distance_ * (1.0 - kSame) ||
      (!(d > distance_ * (1.0 + kSame) + kGuard) && isBefore(p)))
    {
      best_ = k;
      distance_ = d;
    }
  }

  bool mayHaveNearer(const Bounds& b) const
  {
    const double x = std::max(
      b.xmin * scale_ - place_.x * scale_, place_.x * scale_ - b.xmax * scale_);
    const double y = std::max(
      b.ymin * scale_ - place_.y * scale_, place_.y * scale_ - b.ymax * scale_);
    return !(squared(std::max(x, 0.0), std::max(y, 0.0)) > distance_ * (1.0 + kSame) + kGuard);
  }

  std::size_t best() const { return best_; }

private:
  static constexpr std::size_t kNone = std::size_t(-1);

  static double squared(double x, double y) { return x * x + y * y; }

  bool isBefore(const Point& p) const
  {
    const Point q = tree_.places_[tree_.vertices_[best_]];
    const int nearer = nearerOf(p, q, place_);
    return nearer > 0 || (nearer == 0 && lexicographicallyLess(p, q));
  }

  const VertexTree& tree_;
  const Point& place_;
  const double scale_; ///< so that nothing overflows
  std::size_t best_ = kNone;
  double distance_ = std::numeric_limits<double>::infinity();
};

bool VertexTree::build(const TriangulationAccess::State& state, Ticker& ticker)
{
  places_ = state.ranked.xy.data();
  const Bounds& all = state.ranked.bounds;
  largest_ = std::max(sizeOf({ all.xmin, all.ymin }), sizeOf({ all.xmax, all.ymax }));
  if (!listInserted(state, vertices_, ticker))
  {
    return false;
  }
  levels_.assign(1, 0);
  std::size_t nodes = 0;
  for (std::size_t size = vertices_.size(); size > 1;)
  {
    size = (size + kFanout - 1) / kFanout;
    nodes += size;
    levels_.push_back(nodes);
  }
  nodes_.allocate(nodes);
  for (std::size_t level = 0; level + 1 < levels_.size(); ++level)
  {
    const std::size_t below = level == 0 ? 0 : levels_[level - 1];
    const std::size_t items = itemsOn(level);
    const auto bound = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        Bounds bounds{ kFar, -kFar, kFar, -kFar };
        for (std::size_t i = k * kFanout; i != std::min(items, (k + 1) * kFanout); ++i)
        {
          const Point p = level == 0 ? places_[vertices_[i]] : Point();
          extend(bounds, level == 0 ? Bounds{ p.x, p.x, p.y, p.y } : nodes_[below + i]);
        }
        nodes_[levels_[level] + k] = bounds;
      }
    };
    if (!inChunksOf(levels_[level + 1] - levels_[level], ticker, bound))
    {
      return false;
    }
  }
  return true;
}

std::size_t VertexTree::itemsOn(std::size_t level) const
{
  return level == 0 ? vertices_.size() : levels_[level] - levels_[level - 1];
}

bool VertexTree::findNearest(
  const Point& place, std::size_t hint, Ticker& ticker, std::size_t& found) const
{
  if (!ticker.step()) // there may be no nodes
  {
    return false;
  }
  Search search(*this, place);
  search.look(hint);
  // Depth first; on each level on the way down, what comes next and where it ends. The vertices are
  // level 0.
  constexpr std::size_t kLevels = 16; // eight to this power
  std::size_t next[kLevels], end[kLevels];
  const std::size_t top = levels_.size() - 1;
  std::size_t level = top;
  next[level] = 0;
  end[level] = itemsOn(level);
  while (level <= top)
  {
    for (; level == 0 && next[0] != end[0]; ++next[0])
    {
      search.look(next[0]);
    }
    if (next[level] == end[level])
    {
      ++level;
      continue;
    }
    const std::size_t node = next[level]++;
    if (!ticker.step(kFanout))
    {
      return false;
    }
    if (search.mayHaveNearer(nodes_[levels_[level - 1] + node]))
    {
      --level;
      next[level] = node * kFanout;
      end[level] = std::min(itemsOn(level), (node + 1) * kFanout);
    }
  }
  found = search.best();
  return true;
}

} // namespace ahd
