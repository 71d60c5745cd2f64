// SPDX-License-Identifier: BSD-3-Clause
#include "CurveOrder.h"

#include "../Core/Loops.h"
#include "../Core/SortAsking.h"
#include "../Points/JoinedBounds.h"
#include "CurveKeys.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace ahd
{

namespace
{

/// The bounds of the finite points.
struct FoundBounds
{
  Bounds bounds;

  void add(const Point& p)
  {
    if (isFinite(p))
    {
      bounds = joined(bounds, p);
    }
  }
  void merge(const FoundBounds& other) { bounds = joined(bounds, other.bounds); }
};

} // namespace

/// Orders places of equal key by new keys within their own bounds, repeatedly. Each time their
/// bounds are a 2^15-th of what they were, or less, on their longer side: doubles leave room for
/// some 140 times.
class CurveOrder::Crowds
{
public:
  Crowds(const PointView& places, CurveOrder& order, Ticker& ticker)
    : places_(places)
    , begin_(order.begin_)
    , items_(order.items_)
    , ticker_(ticker)
  {
  }

  bool order()
  {
    bool goesOn = list(0, items_.size());
    while (goesOn && !crowds_.empty())
    {
      const Crowd crowd = crowds_.back();
      crowds_.pop_back();
      goesOn = order(crowd);
    }
    return goesOn;
  }

private:
  struct Crowd
  {
    std::size_t first, last;
  };

  /// Fewer are found quickly in any order.
  static constexpr std::size_t kLeast = 64;

  /// Lists those of items [first, last), which are sorted.
  bool list(std::size_t first, std::size_t last)
  {
    std::size_t begin = first;
    return inChunks(first, last, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t k = a; k != b; ++k)
        {
          const bool ends = k + 1 == last || items_[k + 1] >> 32 != items_[k] >> 32;
          if (ends && k + 1 - begin >= kLeast)
          {
            crowds_.push_back({ begin, k + 1 });
          }
          begin = ends ? k + 1 : begin;
        }
      });
  }

  bool order(const Crowd& crowd)
  {
    const auto at = [&](std::size_t number) { return places_[begin_ + number]; };
    FoundBounds found;
    const auto look = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        found.add(at(static_cast<std::uint32_t>(items_[k])));
      }
    };
    if (!inChunks(crowd.first, crowd.last, ticker_, look))
    {
      return false;
    }
    const Bounds& bounds = found.bounds;
    if (isEmpty(bounds) || (bounds.xmin == bounds.xmax && bounds.ymin == bounds.ymax))
    {
      return true; // in one place, or nowhere
    }
    const CurveKeys keys(bounds);
    const auto write = [&](std::size_t a, std::size_t b)
    {
      std::uint64_t* const items = &items_[a];
      keys.write(
        [items](std::size_t k) { return static_cast<std::uint32_t>(items[k]); }, at, items, b - a);
    };
    const std::size_t count = crowd.last - crowd.first;
    scratch_.resize(count > kChunk ? count : 0);
    return inChunks(crowd.first, crowd.last, ticker_, write) &&
      sortAsking(&items_[crowd.first], count, scratch_.data(), ticker_, std::less<>()) &&
      list(crowd.first, crowd.last);
  }

  const PointView& places_;
  std::size_t begin_;
  Buffer<std::uint64_t>& items_;
  Ticker& ticker_;
  std::vector<Crowd> crowds_;
  std::vector<std::uint64_t> scratch_;
};

bool CurveOrder::build(
  const PointView& places, std::size_t begin, std::size_t end, const Bounds& bounds, Ticker& ticker)
{
  begin_ = begin;
  items_.allocate(end - begin);
  const Bounds none{ 0.0, 0.0, 0.0, 0.0 };
  const CurveKeys keys(isEmpty(bounds) ? none : bounds);
  const auto write = [&](std::size_t a, std::size_t b)
  {
    keys.write([a](std::size_t k) { return static_cast<std::uint32_t>(a + k); },
      [&](std::size_t number) { return places[begin + number]; }, items_.data() + a, b - a);
  };
  return inChunksOf(items_.size(), ticker, write) && sortPacked(items_, items_.size(), ticker) &&
    Crowds(places, *this, ticker).order();
}

bool CurveOrder::build(const PointView& places, std::size_t begin, std::size_t end, Ticker& ticker)
{
  FoundBounds found;
  const auto look = [&](FoundBounds& part, std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      part.add(places[begin + k]);
    }
  };
  return gather(end - begin, ticker, found, look) &&
    build(places, begin, end, found.bounds, ticker);
}

} // namespace ahd
