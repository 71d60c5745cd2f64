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

/// The power of two that makes this about 2^500, so that squares do not overflow, and what is far
/// smaller does not underflow in them.
double scaleOf(double largest)
{
  constexpr double kScaled = 0x1p499;
  constexpr int kLeast = -500;
  return std::ldexp(kScaled, -std::max(std::ilogb(largest), kLeast));
}

/// What two squared distances that are the same may differ by, as a part of either: each has two
/// rounded differences, squares and a sum. Differences of distances tell more about what differs by
/// less.
constexpr double kSame = 0x1p-48;
/// ... or by less than this: it is far more than coordinates up to 2^500 that lose 2^-1074 make of
/// it.
constexpr double kGuard = 0x1p-560;

} // namespace

/// One call of findNearest().
class VertexTree::Search
{
public:
  Search(const VertexTree& tree, const Point& place)
    : tree_(tree)
    , place_(place)
    , scale_(scaleOf(std::max(sizeOf(place), tree.largest_)))
    , scaled_{ place.x * scale_, place.y * scale_ }
  {
  }

  /// Is it nearer than the best so far?
  void look(std::size_t k)
  {
    const Point p = tree_.places_[tree_.vertices_[k]];
    const Point c{ p.x * scale_, p.y * scale_ };
    const double d = squared(c.x - scaled_.x, c.y - scaled_.y);
    if (best_ == kNone || d + kGuard < distance_ * (1.0 - kSame) ||
      (!(d > distance_ * (1.0 + kSame) + kGuard) && !isFarther(c) && isBefore(p)))
    {
      best_ = k;
      nearest_ = c;
      distance_ = d;
    }
  }

  bool mayHaveNearer(const Bounds& b) const
  {
    const Point c{ std::max(b.xmin * scale_, std::min(scaled_.x, b.xmax * scale_)),
      std::max(b.ymin * scale_, std::min(scaled_.y, b.ymax * scale_)) };
    return !(squared(c.x - scaled_.x, c.y - scaled_.y) > distance_ * (1.0 + kSame) + kGuard) &&
      !isFarther(c);
  }

  std::size_t best() const { return best_; }

private:
  static constexpr std::size_t kNone = std::size_t(-1);

  static double squared(double x, double y) { return x * x + y * y; }

  /// Is a scaled place certainly farther than the best so far? Seen from afar, squared distances
  /// are all the same up to rounding; what they differ by is not.
  ///
  /// With p the place, q the best and c the other, |c - p|^2 - |q - p|^2 is the sum, over x and y,
  /// of (c - q) ((c - p) + (q - p)). That has six roundings at most, each of no more than u of the
  /// sum of |c - q| (|c - p| + |q - p|).
  bool isFarther(const Point& c) const
  {
    constexpr double kRounding = 0x1p-49;
    const Point &p = scaled_, &q = nearest_;
    const double more = (c.x - q.x) * ((c.x - p.x) + (q.x - p.x)) +
      (c.y - q.y) * ((c.y - p.y) + (q.y - p.y));
    const double size = std::fabs(c.x - q.x) * (std::fabs(c.x - p.x) + std::fabs(q.x - p.x)) +
      std::fabs(c.y - q.y) * (std::fabs(c.y - p.y) + std::fabs(q.y - p.y));
    return more > kRounding * size + kGuard;
  }

  bool isBefore(const Point& p) const
  {
    const Point q = tree_.places_[tree_.vertices_[best_]];
    const int nearer = nearerOf(p, q, place_);
    return nearer > 0 || (nearer == 0 && lexicographicallyLess(p, q));
  }

  const VertexTree& tree_;
  const Point& place_;
  const double scale_;
  const Point scaled_; ///< the place
  std::size_t best_ = kNone;
  Point nearest_{ 0.0, 0.0 }; ///< the best one, scaled
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
