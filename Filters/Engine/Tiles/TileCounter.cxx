// SPDX-License-Identifier: BSD-3-Clause
#include "TileCounter.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Order/Rank.h"

#include <algorithm>
#include <numeric>

namespace ahd
{

namespace
{

constexpr std::size_t kMostCounts = std::size_t(1) << 20;
constexpr unsigned kMostSteps = 10;

/// The boxes that all steps lead to, of one.
std::size_t partsAfter(unsigned steps)
{
  return std::size_t(1) << (2 * steps);
}

bool areSame(const Bounds& a, const Bounds& b)
{
  return a.xmin == b.xmin && a.xmax == b.xmax && a.ymin == b.ymin && a.ymax == b.ymax;
}

} // namespace

TileCounter::TileCounter(const Bounds& guess)
  : grid_(guess)
  , isRight_(!isEmpty(guess))
{
  if (isRight_)
  {
    boxes_ = { { {}, 0, true } };
    openBoxes();
  }
}

Status TileCounter::count(const PointView& points, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      RankedPoints found; // no point is ranked
      {
        Ticker reading(context.progress, Phase::Read, points.count, context.executor);
        if (readPoints(points, reading, found) != Status::Ok)
        {
          return false;
        }
      }
      points_ += found.count;
      notFinite_ += found.notFinite;
      bounds_ = joined(bounds_, found.bounds);
      isRight_ = isRight_ && areSame(joined(grid_, bounds_), grid_);
      Ticker sorting(context.progress, Phase::Sort, points.count);
      return !isRight_ ||
        inChunks(0, points.count, sorting,
          [&](std::size_t begin, std::size_t end) { countKeys(points, begin, end); });
    });
}

void TileCounter::countKeys(const PointView& points, std::size_t begin, std::size_t end)
{
  const TileGrid grid(grid_);
  std::uint64_t keys[kKeyBlock];
  for (std::size_t first = begin; first < end; first += kKeyBlock)
  {
    const std::size_t count = std::min(end - first, kKeyBlock);
    grid.keysOf(points, first, count, keys);
    for (std::size_t k = 0; k != count; ++k)
    {
      if (isFinite(points[first + k]))
      {
        countKey(keys[k]);
      }
    }
  }
}

void TileCounter::countKey(std::uint64_t key)
{
  const auto after = std::upper_bound(opened_.begin(), opened_.end(), key);
  if (after == opened_.begin())
  {
    return;
  }
  const std::size_t k = static_cast<std::size_t>(after - opened_.begin()) - 1;
  const TileBox box = { opened_[k], levels_[k] };
  if (box.has(key))
  {
    const unsigned shift = 64 - 2 * (box.level + steps_);
    ++counts_[k * partsAfter(steps_) + static_cast<std::size_t>((key - box.key) >> shift)];
  }
}

/// Lists the leaves in a box, and those of its parts that are to be divided further. `counts`: of
/// the parts after as many steps as are left.
void TileCounter::divide(const Division& now, const std::uint64_t* counts, std::vector<Box>& out)
{
  const std::size_t parts = partsAfter(now.steps);
  const std::uint64_t sum = std::accumulate(counts, counts + parts, std::uint64_t(0));
  if (sum <= now.most || now.box.level == TileBox::kLevels || now.steps == 0)
  {
    out.push_back({ now.box, sum, sum > now.most && now.box.level != TileBox::kLevels });
    return;
  }
  for (unsigned q = 0; q != 4; ++q)
  {
    divide({ now.box.quarter(q), now.steps - 1, now.most }, counts + q * (parts / 4), out);
  }
}

/// Makes room for the counts of open boxes' parts.
void TileCounter::openBoxes()
{
  opened_.clear();
  levels_.clear();
  std::uint32_t deepest = 0;
  for (const Box& box : boxes_)
  {
    if (box.isOpen)
    {
      opened_.push_back(box.box.key);
      levels_.push_back(box.box.level);
      deepest = std::max(deepest, box.box.level);
    }
  }
  steps_ = std::min(kMostSteps, TileBox::kLevels - deepest);
  while (steps_ > 1 && opened_.size() * partsAfter(steps_) > kMostCounts)
  {
    --steps_;
  }
  counts_.assign(opened_.size() * partsAfter(steps_), 0);
}

/// Divides open boxes as far as they were counted.
void TileCounter::divideOpen(std::uint64_t most)
{
  std::vector<Box> divided;
  const std::uint64_t* counts = counts_.data();
  for (const Box& box : boxes_)
  {
    if (box.isOpen)
    {
      divide({ box.box, steps_, most }, counts, divided);
      counts += partsAfter(steps_);
    }
    else
    {
      divided.push_back(box);
    }
  }
  boxes_ = std::move(divided);
}

TileCounter::Next TileCounter::endPass(std::uint64_t most, TileFacts& facts)
{
  const bool isFirst = pointsBefore_ == 0 && notFiniteBefore_ == 0;
  const bool isCounted = isRight_ && !boxes_.empty() && areSame(grid_, bounds_);
  const bool isSame = points_ == pointsBefore_ && notFinite_ == notFiniteBefore_ &&
    (isCounted || points_ == 0);
  if (!isFirst && !isSame)
  {
    return Next::Different;
  }
  facts = TileFacts();
  facts.bounds = isCounted || points_ != 0 ? bounds_ : Bounds();
  facts.points = points_;
  facts.notFinite = notFinite_;
  if (isCounted)
  {
    divideOpen(most);
  }
  else
  {
    grid_ = bounds_;
    isRight_ = true;
    boxes_ = { { {}, 0, points_ != 0 } };
  }
  openBoxes();
  pointsBefore_ = points_;
  notFiniteBefore_ = notFinite_;
  bounds_ = Bounds();
  points_ = notFinite_ = 0;
  return opened_.empty() ? listLeaves(facts) : Next::Again;
}

/// Leaves out boxes of the grid that have no place within the bounds.
TileCounter::Next TileCounter::listLeaves(TileFacts& facts) const
{
  std::uint64_t counted = 0;
  for (const Box& box : boxes_)
  {
    counted += box.count;
    if (box.count != 0 || boxes_.size() == 1 || !isEmpty(TileGrid(facts.bounds).placesOf(box.box)))
    {
      facts.leaves.push_back({ box.box.key, box.box.level, box.count });
    }
  }
  return counted == facts.points ? Next::Done : Next::Different;
}

} // namespace ahd
