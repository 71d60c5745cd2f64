// SPDX-License-Identifier: BSD-3-Clause
#include "VertexTree.h"

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

  bool mayHaveNearer(const Box& b) const
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
  levels_.allocate(vertices_.size());
  const auto boxOf = [&](std::size_t k)
  {
    const Point& p = places_[vertices_[k]];
    return Box::around(p, p);
  };
  return levels_.fitItems(boxOf, ticker);
}

bool VertexTree::findNearest(
  const Point& place, std::size_t hint, Ticker& ticker, std::size_t& found) const
{
  Search search(*this, place);
  search.look(hint);
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
      search.look(k);
    }
    return true;
  };
  const bool isDone = levels_.visit(enter, look);
  found = search.best();
  return isDone;
}

} // namespace ahd
