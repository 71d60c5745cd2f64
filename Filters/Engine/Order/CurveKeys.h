// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CurveKeys_h
#define ahd_CurveKeys_h

#include "../Core/Buffer.h"
#include "../Core/Chunks.h"
#include "../Points/BoxLevels.h"
#include "HilbertKeys.h"
#include "Quantise.h"
#include "RadixSort.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Makes keys of places: their positions along a Hilbert curve through some bounds; places outside
/// of these or not finite count as at their border.
class CurveKeys
{
public:
  /// @pre the bounds are not empty.
  explicit CurveKeys(const Bounds& bounds)
    : bounds_(bounds)
    , grid_(bounds)
  {
  }

  /// Writes packed(key, number) for `count` places: numberOf(k) is the k-th, at(number) its place.
  template <typename Number, typename Place>
  void write(const Number& numberOf, const Place& at, std::uint64_t* items, std::size_t count) const
  {
    std::uint32_t columns[kKeyBlock], rows[kKeyBlock], numbers[kKeyBlock];
    for (std::size_t first = 0; first < count; first += kKeyBlock)
    {
      const std::size_t block = std::min(kKeyBlock, count - first);
      for (std::size_t k = 0; k != block; ++k)
      {
        numbers[k] = numberOf(first + k);
        const Point p = at(numbers[k]);
        columns[k] = grid_.column(within(bounds_.xmin, bounds_.xmax, p.x));
        rows[k] = grid_.row(within(bounds_.ymin, bounds_.ymax, p.y));
      }
      hilbertKeys(columns, rows, items + first, block);
      for (std::size_t k = 0; k != block; ++k)
      {
        items[first + k] = packed(static_cast<std::uint32_t>(items[first + k] >> 32), numbers[k]);
      }
    }
  }

private:
  /// NaN is low.
  static double within(double low, double high, double x)
  {
    return x > low ? std::min(x, high) : low;
  }

  const Bounds bounds_;
  const Grid grid_;
};

/// Sorts boxes along a curve through their middles, up to rounding: the low halves of `keys` become
/// their numbers in this order, `all` the box around them. boxOf(number) is a box. Returns false if
/// cancelled; throws std::bad_alloc.
template <typename BoxOf>
bool sortAlongCurve(
  std::size_t count, const BoxOf& boxOf, Buffer<std::uint64_t>& keys, Box& all, Ticker& ticker)
{
  const auto bound = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      all.add(boxOf(k));
    }
  };
  keys.allocate(count);
  if (count == 0 || !inChunks(0, count, ticker, bound))
  {
    return count == 0;
  }
  const CurveKeys curve(Bounds{ all.xmin, all.xmax, all.ymin, all.ymax });
  const auto makeKeys = [&](std::size_t a, std::size_t b)
  {
    curve.write([a](std::size_t k) { return static_cast<std::uint32_t>(a + k); },
      [&](std::size_t number) { return boxOf(number).middle(); }, keys.data() + a, b - a);
  };
  return inChunks(0, count, ticker, makeKeys) && sortPacked(keys, count, ticker);
}

} // namespace ahd

#endif
