// SPDX-License-Identifier: BSD-3-Clause
#include "SortByPlace.h"

#include "../Core/Loops.h"
#include "../Core/SortAsking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ahd
{
namespace
{

bool comesBefore(const Located& a, const Located& b)
{
  return a.at == b.at ? a.id < b.id : lexicographicallyLess(a.at, b.at);
}

/// Of half the x: their difference is finite.
struct Extent
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void merge(const Extent& other)
  {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// One call of sortByPlace(). What returns a bool returns false if the work is cancelled.
class Strips
{
public:
  Strips(std::vector<Located>& items, Buffer<Located>& sorted, Ticker& ticker)
    : items_(items)
    , sorted_(sorted)
    , ticker_(ticker)
    , count_(items.size() / kPerStrip + 1)
    , tasks_(std::min({ kMostTasks, threadsOf(ticker), tasksForLoop(ticker, items.size()) }))
  {
    places_.allocate(count_ * tasks_);
    sorted_.allocate(items.size());
  }

  bool run() { return measure() && count() && scatter() && sort(); }

private:
  static constexpr std::size_t kPerStrip = 32;
  static constexpr std::size_t kMostTasks = 8; ///< each has a table: 1 byte per point at most

  bool measure()
  {
    Extent extent;
    const bool all = gather(items_.size(), ticker_, extent,
      [this](Extent& part, std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i != b; ++i)
        {
          const double half = 0.5 * items_[i].at.x;
          part.merge({ half, half });
        }
      });
    low_ = extent.low;
    const double perUnit = double(count_) / (extent.high - extent.low);
    scale_ = std::isfinite(perUnit) ? perUnit : 0.0; // all in one
    return all;
  }

  /// Not decreasing with x.
  std::size_t stripOf(const Located& item) const
  {
    const double strip = (0.5 * item.at.x - low_) * scale_;
    return std::min(static_cast<std::size_t>(strip), count_ - 1);
  }

  /// Calls work(item, table of the task) for all items.
  template <typename Work>
  bool forAll(const Work& work)
  {
    return inParallel(ticker_, tasks_,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(items_.size(), task, tasks_);
        Index* const places = places_.data() + task * count_;
        return inChunks(share.begin, share.end, own,
          [&](std::size_t a, std::size_t b)
          {
            for (std::size_t i = a; i != b; ++i)
            {
              work(items_[i], places);
            }
          });
      });
  }

  /// Finds where each task's items of a strip go.
  bool count()
  {
    if (!fillAll(places_, Index(0), ticker_) ||
      !forAll([this](const Located& item, Index* places) { ++places[stripOf(item)]; }))
    {
      return false;
    }
    Index sum = 0;
    return inChunks(0, count_, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t strip = a; strip != b; ++strip)
        {
          for (std::size_t task = 0; task < tasks_; ++task)
          {
            sum += std::exchange(places_[task * count_ + strip], sum);
          }
        }
      });
  }

  bool scatter()
  {
    return forAll(
      [this](const Located& item, Index* places) { sorted_[places[stripOf(item)]++] = item; });
  }

  /// Where a strip ends: behind the last task's items.
  std::size_t endOf(std::size_t strip) const { return places_[(tasks_ - 1) * count_ + strip]; }

  bool sort()
  {
    const std::size_t tasks = tasks_ == 1 ? 1 : tasksForLoop(ticker_, items_.size());
    return inParallel(ticker_, tasks,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(count_, task, tasks);
        for (std::size_t strip = share.begin; strip != share.end; ++strip)
        {
          const std::size_t begin = strip == 0 ? 0 : endOf(strip - 1);
          if (!sortAsking(sorted_.data() + begin, endOf(strip) - begin, items_.data() + begin, own,
                comesBefore) ||
            !own.step())
          {
            return false;
          }
        }
        return true;
      });
  }

  std::vector<Located>& items_;
  Buffer<Located>& sorted_;
  Ticker& ticker_;
  const std::size_t count_;
  const std::size_t tasks_;
  Buffer<Index> places_; ///< for each task and strip: where its next item goes
  double low_ = 0.0;
  double scale_ = 0.0;
};

} // namespace

bool sortByPlace(std::vector<Located>& items, Buffer<Located>& sorted, Ticker& ticker)
{
  return Strips(items, sorted, ticker).run();
}

} // namespace ahd
