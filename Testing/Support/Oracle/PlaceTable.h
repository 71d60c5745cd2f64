// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlaceTable_h
#define ahd_PlaceTable_h

#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace ahd
{
namespace test
{

/// Finds the first point at the same place. -0.0 and +0.0 are the same coordinate.
class PlaceTable
{
public:
  explicit PlaceTable(const PointView& points)
    : points_(points)
  {
    std::size_t capacity = 16;
    while (capacity < 2 * points.count)
    {
      capacity *= 2;
    }
    slots_.assign(capacity, kEmpty);
  }

  /// The id of the first point given at the place of point i: i itself if it is the first.
  std::int32_t firstAt(std::size_t i)
  {
    const Point p = points_[i];
    std::size_t slot = hash(p);
    for (;; ++slot)
    {
      std::int32_t& found = slots_[slot & (slots_.size() - 1)];
      if (found == kEmpty)
      {
        found = std::int32_t(i);
      }
      if (points_[std::size_t(found)] == p)
      {
        return found;
      }
    }
  }

private:
  static constexpr std::int32_t kEmpty = -1;

  static std::size_t hash(const Point& p)
  {
    const double normal[2] = { p.x + 0.0, p.y + 0.0 };
    std::uint64_t bits[2];
    std::memcpy(bits, normal, sizeof bits);
    std::uint64_t h = bits[0] * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29) ^ bits[1]) * 0xBF58476D1CE4E5B9u;
    return std::size_t(h ^ (h >> 32));
  }

  const PointView& points_;
  std::vector<std::int32_t> slots_;
};

} // namespace test
} // namespace ahd

#endif
