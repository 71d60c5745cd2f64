// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CurveOrder_h
#define ahd_CurveOrder_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Points/Points.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Places in an order in which neighbours follow each other, for searches that each start at the
/// previous result.
class CurveOrder
{
public:
  /// Callers with many places order this many at once, to save memory.
  static constexpr std::size_t kBlock = std::size_t(1) << 22;

  /// Upper estimate of the bytes taken where so many places are ordered, block by block.
  static constexpr std::size_t mostBytes(std::size_t count)
  {
    return 2 * sizeof(std::uint64_t) * (count < kBlock ? count : kBlock);
  }

  /// Orders places[begin, end) along a Hilbert curve through the bounds; places outside of them or
  /// not finite count as at their border. Many places in one box of the curve's grid, as when a few
  /// others lie far away, are ordered along a curve of their own. Returns false if cancelled;
  /// throws std::bad_alloc. @pre fewer than 2^32.
  bool build(const PointView& places, std::size_t begin, std::size_t end, const Bounds& bounds,
    Ticker& ticker);

  /// The same through the bounds of the places that are finite.
  bool build(const PointView& places, std::size_t begin, std::size_t end, Ticker& ticker);

  /// The number of the k-th place.
  std::size_t operator[](std::size_t k) const
  {
    return begin_ + static_cast<std::uint32_t>(items_[k]);
  }

private:
  class Crowds;

  std::size_t begin_ = 0;
  Buffer<std::uint64_t> items_;
};

} // namespace ahd

#endif
