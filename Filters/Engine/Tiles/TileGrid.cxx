// SPDX-License-Identifier: BSD-3-Clause
#include "TileGrid.h"

#include <cstring>

namespace ahd
{

namespace
{

/// Doubles in their order as integers, and back; both zeros are 0.
std::int64_t numberOf(double value)
{
  std::int64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits < 0 ? INT64_MIN - bits : bits;
}

double valueOf(std::int64_t number)
{
  const std::int64_t bits = number < 0 ? INT64_MIN - number : number;
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// The first double from `low` to `high` that is in this column or a later one; one past `high`
/// where none is, as a number.
std::int64_t firstFrom(const Quantiser& quantiser, double low, double high, std::uint64_t column)
{
  std::int64_t begin = numberOf(low), end = numberOf(high) + 1;
  while (begin < end)
  {
    // the mean, without overflow
    const std::int64_t middle = (begin & end) + ((begin ^ end) >> 1);
    if (quantiser(valueOf(middle)) < column)
    {
      begin = middle + 1;
    }
    else
    {
      end = middle;
    }
  }
  return begin;
}

} // namespace

void TileGrid::keysOf(
  const PointView& points, std::size_t first, std::size_t count, std::uint64_t* keys) const
{
  std::uint32_t columns[kKeyBlock], rows[kKeyBlock];
  for (std::size_t k = 0; k != count; ++k)
  {
    const Point p = points[first + k];
    const Point at = isFinite(p) ? p : Point{ bounds_.xmin, bounds_.ymin };
    columns[k] = columnOf(at);
    rows[k] = rowOf(at);
  }
  hilbertKeys(columns, rows, keys, count);
}

Bounds TileGrid::placesOf(const TileBox& box) const
{
  const std::uint64_t side = std::uint64_t(1) << (TileBox::kLevels - box.level);
  const GridPlace some = placeOfKey(box.key);
  const std::uint64_t column = some.column & ~(side - 1), row = some.row & ~(side - 1);
  const Bounds& b = bounds_;
  const std::int64_t left = firstFrom(grid_.column, b.xmin, b.xmax, column);
  const std::int64_t right = firstFrom(grid_.column, b.xmin, b.xmax, column + side);
  const std::int64_t bottom = firstFrom(grid_.row, b.ymin, b.ymax, row);
  const std::int64_t top = firstFrom(grid_.row, b.ymin, b.ymax, row + side);
  return left < right && bottom < top
    ? Bounds{ valueOf(left), valueOf(right - 1), valueOf(bottom), valueOf(top - 1) }
    : Bounds();
}

} // namespace ahd
