// SPDX-License-Identifier: BSD-3-Clause
#include "TilePlan.h"

#include "../Predicates/Distances.h"
#include "../Sample/BoxNeighbors.h"
#include "../Sample/NearestSeen.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ahd
{

namespace
{

constexpr std::uint64_t kKindOfPlan = 0x414844506C616E31; // "AHDPlan1"

constexpr unsigned kIndexedBits = 16; // of keys: a table that fits the second-level cache

/// The first number from 0 to `end` for which `is` holds, which then holds for all that follow.
template <typename Is>
std::size_t firstOf(std::size_t end, Is is)
{
  std::size_t begin = 0;
  while (begin < end)
  {
    const std::size_t middle = begin + (end - begin) / 2;
    if (is(middle))
    {
      end = middle;
    }
    else
    {
      begin = middle + 1;
    }
  }
  return begin;
}

struct Range
{
  std::size_t begin, end;
};

/// Of `count` numbers, ascending or descending, those from low to high.
template <typename At>
Range rangeWithin(std::size_t count, double low, double high, At at)
{
  const bool ascends = count < 2 || at(0) <= at(count - 1);
  const std::size_t begin = firstOf(
    count, [&](std::size_t k) { return ascends ? at(k) >= low : at(k) <= high; });
  const std::size_t end = firstOf(
    count, [&](std::size_t k) { return ascends ? at(k) > high : at(k) < low; });
  return { begin, std::max(begin, end) };
}

} // namespace

Fingerprint fingerprintOf(const TileView& bytes, std::uint64_t kind)
{
  FingerprintSum sum;
  const std::size_t words = bytes.size / FingerprintSum::kWord;
  sum.add(bytes.data, 0, words, words);
  return sum.finish(bytes.data, bytes.size, kind);
}

TilePlan::TilePlan(TileFacts facts)
  : facts_(std::move(facts))
  , grid_(isEmpty(facts_.bounds) ? Bounds{ 0.0, 0.0, 0.0, 0.0 } : facts_.bounds)
{
  indexKeys();
  measure();
  arrange();
  BlockBytes bytes;
  BytesWriter{ bytes }(facts_);
  fingerprint_ = fingerprintOf({ bytes.data(), bytes.size() }, kKindOfPlan);
}

/// Places of leaves. Those beyond the bounds are as their nearest places within these.
void TilePlan::measure()
{
  const Bounds& inner = facts_.bounds;
  const Bounds& outer = facts_.extent;
  std::uint64_t points = 0;
  for (const TileLeaf& leaf : facts_.leaves)
  {
    Bounds box = isEmpty(inner) ? outer : grid_.placesOf(leaf.box());
    if (!isEmpty(box) && !isEmpty(inner))
    {
      box = { box.xmin == inner.xmin ? outer.xmin : box.xmin,
        box.xmax == inner.xmax ? outer.xmax : box.xmax,
        box.ymin == inner.ymin ? outer.ymin : box.ymin,
        box.ymax == inner.ymax ? outer.ymax : box.ymax };
    }
    boxes_.push_back(box);
    reaches_.push_back(leaf.count != 0 || facts_.hasPlaces != 0 ? box : Bounds());
    firstPoints_.push_back(points);
    points += leaf.count;
  }
  growByRounding(outer, reaches_);
  overlap_ = isEmpty(outer) ? 0.0 : 8.0 * roundingAt(sizeOf(outer));
}

void TilePlan::arrange()
{
  for (std::size_t k = 0; k != leaves(); ++k)
  {
    rows_.push_back({ k, k + 1 });
    parents_.push_back(0);
  }
  std::size_t leaf = 0;
  const std::size_t top = joinParts({}, leaf);
  if (top < leaves()) // the only leaf
  {
    parents_[top] = parents_.size();
    rows_.push_back(rows_[top]);
    reaches_.push_back(reaches_[top]);
    parents_.push_back(0);
  }
  parents_.back() = parents_.size();
  joined_.resize(parents_.size());
  for (std::size_t part = 0; part != root(); ++part)
  {
    joined_[parents_[part]].push_back(part);
  }
}

/// The part of all leaves in the box, which has some, from `leaf` on; moves it behind these.
std::size_t TilePlan::joinParts(const TileBox& box, std::size_t& leaf)
{
  if (facts_.leaves[leaf].level == box.level)
  {
    return leaf++;
  }
  const std::size_t first = leaf;
  std::vector<std::size_t> joined;
  Bounds reach;
  for (unsigned q = 0; q != 4; ++q)
  {
    const TileBox quarter = box.quarter(q);
    if (leaf != leaves() && quarter.has(facts_.leaves[leaf].key))
    {
      joined.push_back(joinParts(quarter, leaf));
      reach = ahd::joined(reach, reaches_[joined.back()]);
    }
  }
  if (joined.size() == 1)
  {
    return joined[0];
  }
  const std::size_t node = parents_.size();
  for (const std::size_t part : joined)
  {
    parents_[part] = node;
  }
  parents_.push_back(0);
  rows_.push_back({ first, leaf });
  reaches_.push_back(reach);
  return node;
}

void TilePlan::indexKeys()
{
  before_.reserve((std::size_t(1) << kIndexedBits) + 1);
  std::uint32_t leaf = 0;
  for (std::uint64_t k = 0; k != std::uint64_t(1) << kIndexedBits; ++k)
  {
    while (leaf != leaves() && facts_.leaves[leaf].key < k << (64 - kIndexedBits))
    {
      ++leaf;
    }
    before_.push_back(leaf);
  }
  before_.push_back(static_cast<std::uint32_t>(leaves()));
}

/// The last leaf whose key is not larger; the first one if there is none.
std::int32_t TilePlan::leafOf(std::uint64_t key) const
{
  const std::uint32_t* const before =
    &before_[static_cast<std::size_t>(key >> (64 - kIndexedBits))];
  const auto after = std::upper_bound(facts_.leaves.begin() + before[0],
    facts_.leaves.begin() + before[1], key,
    [](std::uint64_t k, const TileLeaf& leaf) { return k < leaf.key; });
  return std::max(0, static_cast<std::int32_t>(after - facts_.leaves.begin()) - 1);
}

std::int32_t TilePlan::leafOf(const Point& p) const
{
  return isFinite(p) ? leafOf(grid_.keyOf(p)) : -1;
}

void TilePlan::findLeaves(
  const PointView& points, std::size_t begin, std::size_t end, std::int32_t* leaves) const
{
  std::uint64_t keys[kKeyBlock];
  for (std::size_t first = begin; first < end; first += kKeyBlock)
  {
    const std::size_t count = std::min(end - first, kKeyBlock);
    grid_.keysOf(points, first, count, keys);
    for (std::size_t k = 0; k != count; ++k)
    {
      *leaves++ = isFinite(points[first + k]) ? leafOf(keys[k]) : -1;
    }
  }
}

SampleRaster TilePlan::pieceOf(const SampleRaster& whole, std::size_t k) const
{
  const Bounds& b = boxes_[k];
  const Range columns = rangeWithin(
    whole.columns, b.xmin, b.xmax, [&](std::size_t c) { return whole.at(c, 0).x; });
  const Range rows = rangeWithin(
    whole.rows, b.ymin, b.ymax, [&](std::size_t r) { return whole.at(0, r).y; });
  SampleRaster piece = whole;
  piece.firstColumn += columns.begin;
  piece.firstRow += rows.begin;
  piece.columns = columns.end - columns.begin;
  piece.rows = rows.end - rows.begin;
  if (isEmpty(b) || piece.columns == 0 || piece.rows == 0)
  {
    piece.firstColumn = piece.firstRow = piece.columns = piece.rows = 0;
  }
  return piece;
}

bool TilePlan::holds(const SampleRaster& raster) const
{
  if (raster.columns == 0 || raster.rows == 0)
  {
    return true;
  }
  const Bounds& b = facts_.extent;
  const auto has = [&b](const Point& p)
  { return b.xmin <= p.x && p.x <= b.xmax && b.ymin <= p.y && p.y <= b.ymax; };
  return has(raster.at(0, 0)) && has(raster.at(raster.columns - 1, raster.rows - 1));
}

BlockBytes TilePlan::write() const
{
  BlockBytes bytes;
  BytesWriter writer{ bytes };
  writer(facts_);
  writer(fingerprint_);
  return bytes;
}

bool TilePlan::read(const unsigned char* bytes, std::size_t size, TileFacts& facts)
{
  constexpr std::size_t kEnd = sizeof(Fingerprint);
  if (size < kEnd)
  {
    return false;
  }
  Fingerprint said;
  std::memcpy(&said, bytes + size - kEnd, kEnd);
  if (said != fingerprintOf({ bytes, size - kEnd }, kKindOfPlan))
  {
    return false;
  }
  facts = TileFacts();
  BytesReader{ bytes, size - kEnd }(facts);
  return !facts.leaves.empty();
}

} // namespace ahd
