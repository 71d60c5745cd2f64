// SPDX-License-Identifier: BSD-3-Clause
#include "Sequence.h"

#include "../Core/Chunks.h"
#include "../Core/Loops.h"
#include "BoxWalk.h"
#include "Rounds.h"

#include <algorithm>
#include <vector>

namespace ahd
{

namespace
{

bool hasControlPoints(const Options& options, ControlPoints kind)
{
  return options.controlPoints == kind &&
    (options.order == InsertionOrder::AdaptiveHilbert ||
      options.order == InsertionOrder::MultiGrid);
}

/// The control points of ControlPoints::SingleLevel, and the other points.
class SingleLevel
{
public:
  SingleLevel(const RankedPoints& points, const Options& options, Ticker& ticker)
    : points_(points)
    , options_(options)
    , ticker_(ticker)
  {
  }

  /// Writes the control points to `to`. Returns false if the work is cancelled.
  bool choose(unsigned levels, Index* to)
  {
    const std::size_t n = points_.count;
    std::vector<WalkBox> boxes;
    isControl_.assign(n, 0);
    const WalkPoints all{ points_.key.data(), nullptr, n };
    if (!Divider(options_, ticker_).divide(all, WalkBox{ 0, n, 64 }, levels, boxes))
    {
      return false;
    }
    for (std::size_t b = boxes.size(); b-- > 0;)
    {
      std::size_t first = boxes[b].begin;
      if (!firstOf(boxes[b], first))
      {
        return false;
      }
      isControl_[first] = 1;
      to[controls_++] = static_cast<Index>(first);
    }
    return keepOthers();
  }

  std::size_t controls() const { return controls_; }
  WalkPoints others() const { return { key_.data(), rank_.data(), points_.count - controls_ }; }

private:
  bool firstOf(const WalkBox& box, std::size_t& first)
  {
    return inChunks(box.begin, box.end, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          first = points_.id[i] < points_.id[first] ? i : first;
        }
      });
  }

  bool keepOthers()
  {
    key_.allocate(points_.count - controls_);
    rank_.allocate(points_.count - controls_);
    std::size_t kept = 0;
    return inChunks(0, points_.count, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          if (!isControl_[i])
          {
            key_[kept] = points_.key[i];
            rank_[kept++] = static_cast<Index>(i);
          }
        }
      });
  }

  const RankedPoints& points_;
  const Options& options_;
  Ticker& ticker_;
  std::size_t controls_ = 0;
  std::vector<unsigned char> isControl_;
  Buffer<std::uint64_t> key_;
  Buffer<Index> rank_;
};

/// Writes the points of an order to `to`, control points of every level first. `at(i)` is the i-th
/// of the n points.
template <typename At>
bool everyLevelFirst(std::size_t n, At at, Index* to, Ticker& ticker)
{
  const Rounds rounds(n);
  for (std::size_t stride = rounds.firstStride(); stride > 0; stride /= kControlStride)
  {
    const bool isLast = stride == 1 && rounds.firstStride() > 1;
    const bool copied = inChunksOf(rounds.size(stride), ticker,
      [&, to](std::size_t a, std::size_t b)
      {
        if (isLast)
        {
          rounds.lastPlaces(a, b - a, to + a);
        }
        for (std::size_t k = a; k < b; ++k)
        {
          to[k] = at(isLast ? to[k] : rounds.place(stride, k));
        }
      });
    if (!copied)
    {
      return false;
    }
    to += rounds.size(stride);
  }
  return true;
}

/// ControlPoints::EveryLevel.
bool makeEveryLevel(const RankedPoints& points, const Options& options, unsigned levels,
  Ticker& ticker, Index* sequence)
{
  const std::size_t n = points.count;
  if (isRankByRounds(options))
  {
    // The curve through all boxes and on inside them is the order of rank itself.
    ticker.finished(n / 4);
    return everyLevelFirst(
      n, [](std::size_t i) { return Index(i); }, sequence, ticker);
  }
  Buffer<Index> order;
  order.allocate(n);
  BoxWalk boxes(points, options, ticker);
  return boxes.walk(WalkPoints{ points.key.data(), nullptr, n }, levels, order.data()) &&
    everyLevelFirst(
      n, [&order](std::size_t i) { return order[i]; }, sequence, ticker);
}

} // namespace

unsigned levelsOfFirstDivision(std::size_t points, const Options& options)
{
  switch (options.order)
  {
    case InsertionOrder::AsGiven:
      return 0;
    case InsertionOrder::RegularGrid:
      return levelsOfDivision(points);
    default:
      return points > std::size_t(options.nmax) ? levelsOfDivision(points) : 0;
  }
}

Status makeSequence(
  const RankedPoints& points, const Options& options, Ticker& sorting, Buffer<Index>& sequence)
{
  const unsigned levels = levelsOfFirstDivision(points.count, options);
  BoxWalk boxes(points, options, sorting);
  sequence.allocate(points.count);
  bool done = true;
  if (levels > 0 && hasControlPoints(options, ControlPoints::SingleLevel))
  {
    SingleLevel single(points, options, sorting);
    done = single.choose(levels, sequence.data()) &&
      boxes.walk(single.others(), levels, sequence.data() + single.controls());
  }
  else if (points.count > 0 && hasControlPoints(options, ControlPoints::EveryLevel))
  {
    done = makeEveryLevel(points, options, levels, sorting, sequence.data());
  }
  else
  {
    const WalkPoints all{ points.key.data(), nullptr, points.count };
    done = boxes.walk(all, levels, sequence.data());
  }
  return done ? Status::Ok : Status::Cancelled;
}

} // namespace ahd
