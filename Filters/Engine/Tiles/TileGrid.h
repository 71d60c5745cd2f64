// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TileGrid_h
#define ahd_TileGrid_h

#include "../Order/HilbertCurve.h"
#include "../Order/HilbertKeys.h"
#include "../Order/Quantise.h"
#include "../Points/JoinedBounds.h"

#include <algorithm>
#include <cstdint>

namespace ahd
{

/// A box of the grid of ranks: all cells whose keys begin with the first 2 * level bits of `key`,
/// the smallest of them.
struct TileBox
{
  static constexpr unsigned kLevels = 32;

  std::uint64_t key = 0;
  std::uint32_t level = 0; ///< 0: the whole grid; kLevels: one cell

  /// The key of the last cell.
  std::uint64_t last() const
  {
    return level == 0 ? ~std::uint64_t(0) : key + ((std::uint64_t(1) << (64 - 2 * level)) - 1);
  }
  bool has(std::uint64_t other) const { return key <= other && other <= last(); }
  /// Quarter q along the curve. @pre level < kLevels
  TileBox quarter(unsigned q) const
  {
    return { key + (std::uint64_t(q) << (62 - 2 * level)), level + 1 };
  }
};

/// The grid that ranks points within bounds (Rank.h), which are not empty.
class TileGrid
{
public:
  explicit TileGrid(const Bounds& bounds)
    : bounds_(bounds)
    , grid_(bounds)
  {
  }

  /// The key of a finite place; beyond the bounds, that of the nearest place of them.
  std::uint64_t keyOf(const Point& p) const { return hilbertKey(columnOf(p), rowOf(p)); }

  /// The same of `count` <= kKeyBlock points from `first` on, many at a time; keys of points that
  /// are not finite mean nothing.
  void keysOf(
    const PointView& points, std::size_t first, std::size_t count, std::uint64_t* keys) const;

  /// The places within the bounds whose keys are in the box: exactly those in the rectangle that is
  /// returned, whose sides are included; empty if there is none. Quantisers are monotone, so these
  /// are intervals of doubles.
  Bounds placesOf(const TileBox& box) const;

private:
  std::uint32_t columnOf(const Point& p) const
  {
    return grid_.column(std::min(std::max(p.x, bounds_.xmin), bounds_.xmax));
  }
  std::uint32_t rowOf(const Point& p) const
  {
    return grid_.row(std::min(std::max(p.y, bounds_.ymin), bounds_.ymax));
  }

  Bounds bounds_;
  Grid grid_;
};

} // namespace ahd

#endif
