// SPDX-License-Identifier: BSD-3-Clause
#include "Merge.h"

#include "../Core/Border.h"
#include "../Core/Buffer.h"
#include "../Core/Loops.h"
#include "Candidates.h"
#include "SortByPlace.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace ahd
{
namespace
{

/// The test for near points, by the formula of Merge.h.
class Nearness
{
public:
  explicit Nearness(double distance)
    : scale_(std::isfinite(distance) ? std::ldexp(1.0, std::min(-std::ilogb(distance), 1023)) : 1.0)
    , limit_(squared(distance))
  {
  }

  /// Of a difference of coordinates. Not decreasing with its magnitude, so that points too far
  /// apart in one coordinate are too far apart.
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

/// Rows two distances high. Places near in y are in one of the rows from below(y) to above(y), two
/// or three: sums and products are rounded and truncated, all of which is monotone. For any finite
/// y and any distance: where a double's last digit is worth many rows, only numbers equal to y are
/// near it, and y itself gives their row.
class Rows
{
public:
  explicit Rows(double distance)
  {
    if (std::isfinite(distance)) // else all places are in one row
    {
      unit_ = distance < 0x1p-900 ? 0x1p200 : distance < 0x1p900 ? 1.0 : 0.25;
      reach_ = 1.125 * (unit_ * distance);
      scale_ = 1.0 / (2.0 * (unit_ * distance));
    }
  }

  std::int64_t of(double y) const { return row(y, 0.0); }
  std::int64_t below(double y) const { return row(y, -reach_); }
  std::int64_t above(double y) const { return row(y, reach_); }

private:
  std::int64_t row(double y, double beside) const
  {
    const double scaled = (y * unit_ + beside) * scale_;
    if (std::fabs(scaled) < 0x1p62)
    {
      return static_cast<std::int64_t>(scaled);
    }
    std::int64_t bits;
    std::memcpy(&bits, &y, sizeof bits);
    return bits;
  }

  double unit_ = 0.0; ///< a power of two: sums stay finite, a row's height normal
  double reach_ = 0.0;
  double scale_ = 0.0;
};

/// The kept places that later ones may be merged into. Later ones have no smaller x, so that a kept
/// place that is too far in x is so for all that follow. The others lie in rows two distances high,
/// with few in each, as they are not near each other. A chain has those of the rows with one hash,
/// the latest first.
class Kept
{
public:
  /// @pre no more than `most` are kept. Throws std::bad_alloc.
  Kept(const Nearness& nearness, double distance, std::size_t most, Ticker& ticker)
    : nearness_(nearness)
    , rows_(distance)
    , ticker_(ticker)
  {
    places_.allocate(most);
  }

  /// Returns false if the work is cancelled.
  bool keep(const Located& place)
  {
    places_[end_] = { place.at, place.id, kNoIndex };
    const bool all = end_ - begin_ < chains_.size() || makeChains();
    link(end_++);
    return all;
  }

  /// Drops kept places too far for a place of this x and all after it. Returns false if cancelled.
  bool forgetBefore(double x)
  {
    while (begin_ != end_ && !nearness_.isNear(nearness_.squared(x - places_[begin_].at.x)))
    {
      ++begin_;
      if (!ticker_.step())
      {
        return false;
      }
    }
    return true;
  }

  /// The id of the nearest kept place that p is near to; kNoIndex if there is none.
  Index nearest(const Point& p) const
  {
    Nearest found;
    const std::int64_t last = rows_.above(p.y);
    for (std::int64_t row = rows_.below(p.y); row <= last && begin_ != end_; ++row)
    {
      for (Index k = chains_[chainOf(row)]; k != kNoIndex && k >= begin_; k = places_[k].earlier)
      {
        consider(p, places_[k], found);
      }
    }
    return found.id;
  }

private:
  struct Place
  {
    Point at;
    Index id;
    Index earlier; ///< in its chain; those before begin_ are dropped
  };

  struct Nearest
  {
    double squaredDistance = 0.0;
    Point at{ 0.0, 0.0 };
    Index id = kNoIndex;
  };

  void consider(const Point& p, const Place& place, Nearest& found) const
  {
    const double distance = nearness_.squaredDistance(p, place.at);
    const bool wins = found.id == kNoIndex || distance < found.squaredDistance ||
      (distance == found.squaredDistance && lexicographicallyLess(place.at, found.at));
    if (nearness_.isNear(distance) && wins)
    {
      found = { distance, place.at, place.id };
    }
  }

  std::size_t chainOf(std::int64_t row) const
  {
    const std::uint64_t h = std::uint64_t(row) * 0x9E3779B97F4A7C15u;
    return ((h ^ h >> 32) * 0xD6E8FEB86659FD93u >> 32) & (chains_.size() - 1);
  }

  void link(std::size_t k)
  {
    Index& chain = chains_[chainOf(rows_.of(places_[k].at.y))];
    places_[k].earlier = std::exchange(chain, static_cast<Index>(k));
  }

  /// Four times as many chains as kept places not dropped. Returns false if cancelled.
  bool makeChains()
  {
    constexpr std::size_t kLeast = 64;
    chains_.allocate(std::max(kLeast, std::size_t(1) << bitLength(2 * (end_ - begin_))));
    return fillAll(chains_, kNoIndex, ticker_) &&
      inChunks(begin_, end_, ticker_,
        [this](std::size_t a, std::size_t b)
        {
          for (std::size_t k = a; k != b; ++k)
          {
            link(k);
          }
        });
  }

  const Nearness& nearness_;
  const Rows rows_;
  Ticker& ticker_;
  Buffer<Place> places_; ///< as they were kept
  std::size_t begin_ = 0, end_ = 0;
  Buffer<Index> chains_; ///< a power of two of them; the latest place of each
};

/// Sets keptIds of every point that is merged, and `count` to how many are. `sorted`: place by
/// place, the smallest id of a place first. Returns false if the work is cancelled.
bool mergePlaces(const Buffer<Located>& sorted, double distance, Buffer<Index>& keptIds,
  std::size_t& count, Ticker& ticker)
{
  const Nearness nearness(distance);
  Kept kept(nearness, distance, sorted.size(), ticker);
  for (std::size_t begin = 0, end = 0; begin != sorted.size(); begin = end)
  {
    const Located& place = sorted[begin];
    if (!kept.forgetBefore(place.at.x))
    {
      return false;
    }
    const Index into = kept.nearest(place.at);
    if (into == kNoIndex && !kept.keep(place))
    {
      return false;
    }
    for (end = begin; end != sorted.size() && sorted[end].at == place.at; ++end)
    {
      keptIds[sorted[end].id] = into;
      count += into != kNoIndex;
      ticker.finished(1);
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  return true;
}

/// Lists them by id. Returns false if the work is cancelled.
bool report(
  const Buffer<Index>& keptIds, std::size_t count, std::vector<MergedPoint>& pairs, Ticker& ticker)
{
  pairs.reserve(count);
  return inChunks(0, keptIds.size(), ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        if (keptIds[i] != kNoIndex)
        {
          pairs.push_back({ static_cast<Index>(i), keptIds[i] });
        }
      }
    });
}

/// Finds out.pairs. `flags` is scratch, a byte per point. Returns false if cancelled.
bool findPairs(const PointView& points, double distance, unsigned char* flags, Ticker& ticker,
  std::vector<MergedPoint>& pairs)
{
  Buffer<Located> sorted;
  {
    std::vector<Located> candidates;
    if (!findCandidates(points, distance, flags, ticker, candidates) ||
      !sortByPlace(candidates, sorted, ticker))
    {
      return false;
    }
  }
  ticker.finished(points.count - sorted.size());
  if (sorted.empty())
  {
    return true;
  }
  std::size_t count = 0;
  Buffer<Index> keptIds;
  keptIds.allocate(points.count);
  return fillAll(keptIds, kNoIndex, ticker) &&
    mergePlaces(sorted, distance, keptIds, count, ticker) &&
    (count == 0 || report(keptIds, count, pairs, ticker));
}

/// Marks the points of pairs and those that the caller had left out. Returns false if cancelled.
bool markSkipped(const PointView& points, MergedPoints& out, Ticker& ticker)
{
  unsigned char* const skip = out.skip.data();
  return inChunksOf(points.count, ticker,
           [&](std::size_t a, std::size_t b)
           {
             for (std::size_t i = a; i != b; ++i)
             {
               skip[i] = points.skipped(i);
             }
           }) &&
    inChunksOf(out.pairs.size(), ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i != b; ++i)
        {
          skip[out.pairs[i].id] = 1;
        }
      });
}

} // namespace

Status mergeWithin(
  const PointView& points, double distance, const Context& context, MergedPoints& out)
{
  const auto merge = [&]
  {
    if (points.count > kMaximumPoints)
    {
      return Status::TooManyPoints;
    }
    Ticker ticker(context.progress, Phase::Merge, 2 * points.count, context.executor);
    out.pairs.clear();
    out.skip.assign(points.count, 0);
    const bool all = (!(distance > 0.0) ||
                       findPairs(points, distance, out.skip.data(), ticker, out.pairs)) &&
      markSkipped(points, out, ticker);
    return all && ticker.ask() ? Status::Ok : Status::Cancelled;
  };
  return withoutThrowing(merge);
}

} // namespace ahd
