// SPDX-License-Identifier: BSD-3-Clause
#include "../Core/Loops.h"
#include "../Order/HilbertKeys.h"
#include "../Order/Quantise.h"
#include "../Order/RadixSort.h"
#include "Visits.h"

namespace ahd
{

namespace
{

double within(double low, double high, double x)
{
  return x > low ? std::min(x, high) : low; // NaN is low
}

} // namespace

bool CurveOrder::build(
  const PointView& places, std::size_t begin, std::size_t end, const Bounds& bounds, Ticker& ticker)
{
  begin_ = begin;
  items_.allocate(end - begin);
  const bool hasBounds = bounds.xmin <= bounds.xmax;
  const Grid grid(hasBounds ? bounds : Bounds{ 0.0, 0.0, 0.0, 0.0 });
  const auto key = [&](std::size_t a, std::size_t b)
  {
    std::uint32_t columns[kKeyBlock], rows[kKeyBlock];
    for (std::size_t first = a; first < b; first += kKeyBlock)
    {
      const std::size_t count = std::min(kKeyBlock, b - first);
      for (std::size_t k = 0; k != count; ++k)
      {
        const Point p = places[begin + first + k];
        columns[k] = hasBounds ? grid.column(within(bounds.xmin, bounds.xmax, p.x)) : 0;
        rows[k] = hasBounds ? grid.row(within(bounds.ymin, bounds.ymax, p.y)) : 0;
      }
      std::uint64_t* const keys = items_.data() + first;
      hilbertKeys(columns, rows, keys, count);
      for (std::size_t k = 0; k != count; ++k)
      {
        keys[k] = packed(
          static_cast<std::uint32_t>(keys[k] >> 32), static_cast<std::uint32_t>(first + k));
      }
    }
  };
  return inChunksOf(items_.size(), ticker, key) && sortPacked(items_, items_.size(), ticker);
}

} // namespace ahd
