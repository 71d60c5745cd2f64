// SPDX-License-Identifier: BSD-3-Clause
#include "BlockBoxes.h"

#include "../Points/JoinedBounds.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace ahd
{

void BlockBoxes::set(std::vector<Bounds> bounds, double overlap)
{
  overlap_ = overlap;
  levels_.clear();
  levels_.push_back(std::move(bounds));
  while (levels_.back().size() > 1)
  {
    const std::vector<Bounds>& below = levels_.back();
    std::vector<Bounds> rows((below.size() + kInRow - 1) / kInRow);
    for (std::size_t i = 0; i != below.size(); ++i)
    {
      rows[i / kInRow] = joined(rows[i / kInRow], below[i]);
    }
    levels_.push_back(std::move(rows));
  }
}

bool BlockBoxes::isMet(const Circumdisc& disc, const BlockRow& row, std::size_t& steps) const
{
  struct Place
  {
    std::size_t level, number, blocks;
  };
  std::array<Place, kInRow * 22 + 1> open; // 8^22 blocks are more than there can be
  std::size_t count = 0;
  std::size_t blocksOfTop = 1;
  for (std::size_t level = 1; level < levels_.size(); ++level)
  {
    blocksOfTop *= kInRow;
  }
  open[count++] = { levels_.size() - 1, 0, blocksOfTop };
  while (count > 0)
  {
    const Place place = open[--count];
    const Bounds& box = levels_[place.level][place.number];
    const std::size_t first = place.number * place.blocks;
    ++steps;
    if (isEmpty(box) || (row.begin <= first && first + place.blocks <= row.end))
    {
      continue;
    }
    const std::optional<bool> meets = disc.meetsByFilter(box);
    if (meets && !*meets)
    {
      continue;
    }
    if (place.level == 0)
    {
      if (disc.meets(box))
      {
        return true;
      }
      continue;
    }
    const std::size_t end = std::min((place.number + 1) * kInRow, levels_[place.level - 1].size());
    for (std::size_t k = place.number * kInRow; k != end; ++k)
    {
      open[count++] = { place.level - 1, k, place.blocks / kInRow };
    }
  }
  return false;
}

Bounds BlockBoxes::boundsOf(const BlockRow& row) const
{
  Bounds result;
  for (std::size_t i = row.begin; i != row.end; ++i)
  {
    result = joined(result, levels_[0][i]);
  }
  return result;
}

Bounds BlockBoxes::freeBoxOf(const BlockRow& row, const Bounds& own) const
{
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Bounds result{ -kFar, kFar, -kFar, kFar };
  for (std::size_t i = 0; i != blocks(); ++i)
  {
    const Bounds& b = levels_[0][i];
    if (row.has(i) || isEmpty(b) || isEmpty(own))
    {
      continue;
    }
    // Beyond which side does it lie, and how far? Halves, as differences may be too large.
    const double gaps[] = { 0.5 * own.xmin - 0.5 * b.xmax, 0.5 * b.xmin - 0.5 * own.xmax,
      0.5 * own.ymin - 0.5 * b.ymax, 0.5 * b.ymin - 0.5 * own.ymax };
    const std::ptrdiff_t side = std::max_element(gaps, gaps + 4) - gaps;
    if (!(gaps[side] > -overlap_))
    {
      return Bounds();
    }
    switch (side)
    {
      case 0:
        result.xmin = std::max(result.xmin, b.xmax);
        break;
      case 1:
        result.xmax = std::min(result.xmax, b.xmin);
        break;
      case 2:
        result.ymin = std::max(result.ymin, b.ymax);
        break;
      default:
        result.ymax = std::min(result.ymax, b.ymin);
    }
  }
  return result;
}

} // namespace ahd
