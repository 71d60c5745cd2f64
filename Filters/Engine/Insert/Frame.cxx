// SPDX-License-Identifier: BSD-3-Clause
#include "Frame.h"

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "../Predicates/Filters.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace ahd
{

namespace
{

constexpr std::size_t kTasksPerThread = 4;
constexpr std::size_t kFewPoints = 4 * kChunk; // no task for less

/// 2^e is more than every coordinate, and not more than twice the largest one.
int exponentAbove(const Bounds& bounds)
{
  int exponent;
  std::frexp(std::max(std::max(std::fabs(bounds.xmin), std::fabs(bounds.xmax)),
               std::max(std::fabs(bounds.ymin), std::fabs(bounds.ymax))),
    &exponent);
  return exponent;
}

/// Calls work(a, b) for chunks [a, b) of [0, count), on all threads.
template <typename Work>
bool inShares(std::size_t count, Ticker& ticker, Work work)
{
  const std::size_t tasks = tasksFor(threadsOf(ticker), count, kTasksPerThread, kFewPoints);
  return inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(count, task, tasks);
      return inChunks(share.begin, share.end, own, work);
    });
}

/// Has one of these coordinates bits that a multiple of 1 / up has not? Else adds the bits of the
/// multiples to `bits`. @pre their magnitudes times `up` are less than 2^51.
bool addBits(const double* begin, const double* end, double up, std::uint64_t& bits)
{
  constexpr double kInteger = 0x1.8p52; // a sum with this is rounded to an integer
  bool hasMore = false;
  for (const double* c = begin; c != end; ++c)
  {
    const double multiple = *c * up;
    const double sum = multiple + kInteger;
    hasMore |= sum - kInteger != multiple;
    std::uint64_t word;
    std::memcpy(&word, &sum, sizeof word);
    bits |= word;
  }
  return hasMore;
}

} // namespace

bool Framing::begin(Ticker& ticker)
{
  exponent_ = exponentAbove(points_.bounds);
  if (std::abs(exponent_) > kFrameExponent)
  {
    // Neither the scale nor its reciprocal is subnormal.
    const int shift = std::max(-1000, std::min(1000, -exponent_));
    const double scale = std::ldexp(1.0, shift);
    bool isExact = false;
    if (!scalesExactly(scale, ticker, isExact))
    {
      return false;
    }
    if (!isExact)
    {
      const Bounds& b = points_.bounds;
      guard_ = inCircleGuard(4 * squaredLength(b.xmax - b.xmin, b.ymax - b.ymin));
      squaredGuard_ = std::numeric_limits<double>::infinity();
      return true;
    }
    exponent_ += shift;
    scale_ = scale;
    if (!multiplyBy(scale_, ticker))
    {
      return false;
    }
  }
  const double ghost = std::ldexp(kGhostDistance, exponent_);
  guard_ = inCircleGuard(2 * ghost * ghost);
  squaredGuard_ = inCircleSquaredGuard(2 * ghost * ghost);
  points_.xy[points_.count] = { 0.0, ghost };
  return findUnit(ticker);
}

bool Framing::end(Ticker& ticker)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  points_.xy[points_.count] = { kNaN, kNaN };
  return scale_ == 1.0 || multiplyBy(1.0 / scale_, ticker);
}

bool Framing::multiplyBy(double factor, Ticker& ticker)
{
  Point* const xy = points_.xy.data();
  return inShares(points_.count, ticker,
    [=](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        xy[i] = { xy[i].x * factor, xy[i].y * factor };
      }
    });
}

bool Framing::scalesExactly(double factor, Ticker& ticker, bool& isExact) const
{
  if (factor > 1.0)
  {
    isExact = true; // nothing overflows, and more bits are there than before
    return true;
  }
  const double back = 1.0 / factor;
  std::atomic<bool> loses{ false };
  const Point* const xy = points_.xy.data();
  const bool done = inShares(points_.count, ticker,
    [&, xy](std::size_t a, std::size_t b)
    {
      bool differ = loses.load(std::memory_order_relaxed);
      for (std::size_t i = a; i < b && !differ; ++i)
      {
        differ = xy[i].x * factor * back != xy[i].x || xy[i].y * factor * back != xy[i].y;
      }
      if (differ)
      {
        loses.store(true, std::memory_order_relaxed);
      }
    });
  isExact = !loses;
  return done;
}

/// The coarsest power of two of which all coordinates are multiples, as long as it may be of use:
/// coordinates of many bits are not looked at for long.
bool Framing::findUnit(Ticker& ticker)
{
  constexpr int kBits = 51;
  constexpr std::size_t kSome = 256; // points
  const double up = std::ldexp(1.0, kBits - exponent_);
  const Bounds& b = points_.bounds;
  const double span = std::max(
    scale_ * b.xmax - scale_ * b.xmin, scale_ * b.ymax - scale_ * b.ymin);
  const auto unitOf = [=](std::uint64_t bits)
  {
    int zeros = 0;
    while (zeros < kBits && (bits >> zeros & 1) == 0)
    {
      ++zeros;
    }
    return std::ldexp(1.0, zeros - kBits + exponent_);
  };
  std::atomic<std::uint64_t> bits{ 0 };
  std::atomic<bool> isOfNoUse{ false };
  const double* const xy = &points_.xy.data()->x;
  const bool done = inShares(points_.count, ticker,
    [&, xy](std::size_t begin, std::size_t end)
    {
      std::uint64_t own = 0;
      for (std::size_t i = begin; i < end && !isOfNoUse.load(std::memory_order_relaxed); i += kSome)
      {
        if (addBits(xy + 2 * i, xy + 2 * std::min(end, i + kSome), up, own) ||
          span > kExactSpan * unitOf(own))
        {
          isOfNoUse.store(true, std::memory_order_relaxed);
        }
      }
      bits.fetch_or(own, std::memory_order_relaxed);
    });
  if (!isOfNoUse)
  {
    const double unit = unitOf(bits);
    exactBelow_ = exactErrorBound(unit);
    perturbation_ = perturbationFor(unit);
  }
  return done;
}

} // namespace ahd
