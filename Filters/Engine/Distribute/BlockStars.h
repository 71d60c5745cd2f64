// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockStars_h
#define ahd_BlockStars_h

#include "BlockTriangulation.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Triangles, where the caller has them.
struct BlockTriangles
{
  std::int32_t* corners = nullptr; ///< three of each, the lowest first, by number
  std::uint8_t* edges = nullptr;   ///< of each, those that are constraints; null: not asked for
  std::size_t count = 0;
  std::size_t inside = 0; ///< so many, the first ones, have no corner of other blocks

  /// Keeps those whose byte is not 0, in order.
  void keep(const std::uint8_t* kept)
  {
    std::size_t next = 0, insideKept = 0;
    for (std::size_t t = 0; t != count; ++t)
    {
      if (kept[t] != 0)
      {
        std::copy_n(corners + 3 * t, 3, corners + 3 * next);
        insideKept += t < inside ? 1 : 0;
        if (edges)
        {
          edges[next] = edges[t];
        }
        ++next;
      }
    }
    count = next;
    inside = insideKept;
  }
};

/// A point, by its global id.
struct BlockPoint
{
  std::int64_t id;
  std::uint64_t block; ///< that owns it

  bool operator<(const BlockPoint& other) const { return id < other.id; }
  bool operator==(const BlockPoint& other) const { return id == other.id; }
};

/// A block's triangles and those around its points, as BlockTriangulation writes them, with the
/// same ones left out on all blocks: with them each of its points has all triangles around it.
struct BlockStars
{
  std::size_t block = 0, blocks = 1;
  const std::int64_t* ids = nullptr; ///< of own points, ascending
  std::size_t points = 0;            ///< own ones: numbers from here on are foreign points'
  const std::vector<ForeignPoint>* foreign = nullptr;
  BlockTriangles own, around;

  /// Own triangles, and behind them those around.
  std::size_t count() const { return own.count + around.count; }
  const std::int32_t* corners(std::size_t triangle) const
  {
    return triangle < own.count ? own.corners + 3 * triangle
                                : around.corners + 3 * (triangle - own.count);
  }
  std::uint8_t edges(std::size_t triangle) const
  {
    const BlockTriangles& of = triangle < own.count ? own : around;
    return of.edges ? of.edges[triangle < own.count ? triangle : triangle - own.count]
                    : std::uint8_t(0);
  }
  bool isOwn(std::int32_t number) const { return static_cast<std::size_t>(number) < points; }
  BlockPoint point(std::int32_t number) const
  {
    const auto place = static_cast<std::size_t>(number);
    if (place < points)
    {
      return { ids[place], block };
    }
    const ForeignPoint& other = (*foreign)[place - points];
    return { other.id, other.block };
  }
};

} // namespace ahd

#endif
