// SPDX-License-Identifier: BSD-3-Clause
#include "Merge.h"

#include "../Core/Border.h"
#include "../Core/SortAsking.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace ahd
{
namespace
{

/// A point with its id, in the order in which the points are looked at.
struct Located
{
  Point at;
  Index id;
};

bool comesBefore(const Located& a, const Located& b)
{
  return a.at == b.at ? a.id < b.id : lexicographicallyLess(a.at, b.at);
}

/// How far is near: the formula of Merge.h.
class Nearness
{
public:
  explicit Nearness(double distance)
    : scale_(std::isfinite(distance) ? std::ldexp(1.0, std::min(-std::ilogb(distance), 1023)) : 1.0)
    , limit_(squared(distance))
  {
  }

  /// Of a difference of coordinates. Not decreasing with its magnitude, so that what is too far in
  /// one coordinate is too far.
  double squared(double difference) const
  {
    const double scaled = difference * scale_;
    return scaled * scaled;
  }
  double squaredDistance(const Point& a, const Point& b) const
  {
    return squared(a.x - b.x) + squared(a.y - b.y);
  }
  bool isNear(double squaredLength) const { return squaredLength <= limit_; }

private:
  double scale_;
  double limit_;
};

/// The kept places that later ones may be merged into. Later ones have no smaller x, so that a kept
/// place that is too far in x is so for all that follow.
class Kept
{
public:
  explicit Kept(const Nearness& nearness)
    : nearness_(nearness)
  {
  }

  void keep(const Located& place)
  {
    byY_.insert(place);
    byX_.push_back(place);
  }

  /// Forgets what is too far for a place of this x and all after it. Returns false if the work is
  /// to be cancelled.
  bool forgetBefore(double x, Ticker& ticker)
  {
    while (first_ != byX_.size() && !nearness_.isNear(nearness_.squared(x - byX_[first_].at.x)))
    {
      byY_.erase(byX_[first_++]);
      if (!ticker.step())
      {
        return false;
      }
    }
    return true;
  }

  /// The id of the nearest one to p that is near; kNoIndex if none is. Few are looked at, as kept
  /// places are not near each other.
  Index nearest(const Point& p) const
  {
    Nearest found;
    const auto from = byY_.lower_bound(Located{ p, 0 });
    for (auto k = from; k != byY_.end() && consider(p, *k, found); ++k)
    {
    }
    for (auto k = from; k != byY_.begin() && consider(p, *std::prev(k), found); --k)
    {
    }
    return found.id;
  }

private:
  struct Nearest
  {
    double squaredDistance = 0.0;
    Point at{ 0.0, 0.0 };
    Index id = kNoIndex;
  };

  struct LowerY
  {
    bool operator()(const Located& a, const Located& b) const
    {
      return a.at.y < b.at.y || (a.at.y == b.at.y && a.at.x < b.at.x);
    }
  };

  /// Returns false if `place`, and all that are farther in y, are too far.
  bool consider(const Point& p, const Located& place, Nearest& found) const
  {
    const double distance = nearness_.squaredDistance(p, place.at);
    const bool wins = found.id == kNoIndex || distance < found.squaredDistance ||
      (distance == found.squaredDistance && lexicographicallyLess(place.at, found.at));
    if (nearness_.isNear(distance) && wins)
    {
      found = { distance, place.at, place.id };
    }
    return nearness_.isNear(nearness_.squared(p.y - place.at.y));
  }

  const Nearness& nearness_;
  std::set<Located, LowerY> byY_;
  std::vector<Located> byX_; ///< as they were kept; those before first_ are no longer in byY_
  std::size_t first_ = 0;
};

/// The finite points that are not left out, place by place, the smallest id of a place first.
/// Returns false if the work is to be cancelled.
bool sortPoints(const PointView& points, std::vector<Located>& sorted, Ticker& ticker)
{
  sorted.reserve(points.count);
  const auto read = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      const Point p = points.skipped(i) ? Point{ 0.0, 0.0 } : points[i];
      if (!points.skipped(i) && isFinite(p))
      {
        sorted.push_back({ p, static_cast<Index>(i) });
      }
    }
  };
  return inChunks(0, points.count, ticker, read) && sortAsking(sorted, ticker, comesBefore);
}

/// Sets keptIds of every point that is merged. Returns false if the work is to be cancelled.
bool mergePlaces(const std::vector<Located>& sorted, const Nearness& nearness,
  std::vector<Index>& keptIds, Ticker& ticker)
{
  Kept kept(nearness);
  for (std::size_t begin = 0, end = 0; begin != sorted.size(); begin = end)
  {
    const Located& place = sorted[begin];
    if (!kept.forgetBefore(place.at.x, ticker))
    {
      return false;
    }
    const Index into = kept.nearest(place.at);
    if (into == kNoIndex)
    {
      kept.keep(place);
    }
    for (end = begin; end != sorted.size() && sorted[end].at == place.at; ++end)
    {
      keptIds[sorted[end].id] = into;
      ticker.finished(1);
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  return true;
}

/// Returns false if the work is to be cancelled.
bool report(
  const PointView& points, const std::vector<Index>& keptIds, MergedPoints& out, Ticker& ticker)
{
  const auto write = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      if (keptIds[i] != kNoIndex)
      {
        out.pairs.push_back({ static_cast<Index>(i), keptIds[i] });
      }
      out.skip[i] = points.skipped(i) || keptIds[i] != kNoIndex;
    }
  };
  return inChunks(0, points.count, ticker, write);
}

} // namespace

Status mergeWithin(const PointView& points, double distance, Progress* progress, MergedPoints& out)
{
  const auto merge = [&]
  {
    if (points.count > kMaximumPoints)
    {
      return Status::TooManyPoints;
    }
    Ticker ticker(progress, Phase::Merge, points.count);
    out.pairs.clear();
    out.skip.assign(points.count, 0);
    std::vector<Index> keptIds(points.count, kNoIndex);
    if (distance > 0.0)
    {
      std::vector<Located> sorted;
      if (!sortPoints(points, sorted, ticker) ||
        !mergePlaces(sorted, Nearness(distance), keptIds, ticker))
      {
        return Status::Cancelled;
      }
    }
    return report(points, keptIds, out, ticker) && ticker.ask() ? Status::Ok : Status::Cancelled;
  };
  return withoutThrowing(merge);
}

} // namespace ahd
