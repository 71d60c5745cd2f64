// SPDX-License-Identifier: BSD-3-Clause
#include "BoxWalk.h"

#include "../Core/Chunks.h"
#include "HilbertCurve.h"
#include "RadixSort.h"
#include "Sequence.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ahd
{

namespace
{

/// End of the run that starts at `begin` of points whose keys agree above `bits` bits.
/// A bounded number of steps: boxes are mostly small, so the search begins one by one.
std::size_t endOfBox(const std::uint64_t* key, std::size_t begin, std::size_t end, unsigned bits)
{
  const std::uint64_t box = key[begin] >> bits;
  if (key[end - 1] >> bits == box)
  {
    return end;
  }
  const std::size_t near = std::min(end, begin + 64);
  std::size_t i = begin + 1;
  while (i < near && key[i] >> bits == box)
  {
    ++i;
  }
  if (i < near)
  {
    return i;
  }
  return std::size_t(std::upper_bound(key + i, key + end, box,
                       [bits](std::uint64_t b, std::uint64_t k) { return b < k >> bits; }) -
    key);
}

/// The position of a key's box in the order in which the boxes of its division are visited.
std::uint32_t visitOf(std::uint64_t key, unsigned bits, unsigned levels, const Options& options)
{
  const GridPlace finest = placeOfKey(key);
  const unsigned below = bits / 2; // levels of the finest grid inside the box
  const std::uint32_t mask = (1u << levels) - 1;
  const std::uint32_t column = finest.column >> below & mask;
  const std::uint32_t row = finest.row >> below & mask;
  if (options.order == InsertionOrder::AdaptiveHilbert)
  {
    const unsigned rest = 32 - levels;
    return static_cast<std::uint32_t>(hilbertKey(column << rest, row << rest) >> (2 * rest));
  }
  return row << levels | column;
}

bool isAlongKeys(const Options& options)
{
  return options.order == InsertionOrder::AdaptiveHilbert && options.geneRotation;
}

/// Does the curve go on inside undivided boxes?
bool isAlongKeysInside(const Options& options)
{
  return options.order == InsertionOrder::AdaptiveHilbert &&
    options.controlPoints == ControlPoints::EveryLevel;
}

} // namespace

bool Divider::divide(
  const WalkPoints& points, const WalkBox& box, unsigned levels, std::vector<WalkBox>& boxes) const
{
  const unsigned bits = box.bits - 2 * levels;
  boxes.clear();
  for (std::size_t begin = box.begin; begin < box.end;)
  {
    const std::size_t end = endOfBox(points.key, begin, box.end, bits);
    boxes.push_back({ begin, end, bits });
    begin = end;
    if (!ticker_.step())
    {
      return false;
    }
  }
  return isAlongKeys(options_) || reorder(points, levels, boxes);
}

/// From the order of the keys to that of the options.
bool Divider::reorder(const WalkPoints& points, unsigned levels, std::vector<WalkBox>& boxes) const
{
  Buffer<std::uint64_t> visits;
  visits.allocate(boxes.size());
  const bool visited = inChunks(0, boxes.size(), ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        const WalkBox& box = boxes[i];
        const std::uint32_t visit = visitOf(points.key[box.begin], box.bits, levels, options_);
        visits[i] = packed(visit, static_cast<std::uint32_t>(i));
      }
    });
  if (!visited || !sortPacked(visits, boxes.size(), ticker_))
  {
    return false;
  }
  const std::vector<WalkBox> unsorted(boxes);
  return inChunks(0, boxes.size(), ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        boxes[i] = unsorted[visits[i] & 0xFFFFFFFFu];
      }
    });
}

BoxWalk::BoxWalk(const RankedPoints& ranked, const Options& options, Ticker& ticker)
  : ranked_(ranked)
  , options_(options)
  , ticker_(ticker)
{
}

bool BoxWalk::walk(const WalkPoints& points, unsigned levels, Index* to)
{
  points_ = points;
  to_ = to;
  const WalkBox whole{ 0, points.count, 64 };
  if (points.count == 0)
  {
    return true;
  }
  if (levels == 0)
  {
    return leave(whole);
  }
  return isAlongKeys(options_) ? walkAlongKeys(whole, levels) : walkReordered(whole, levels);
}

bool BoxWalk::isDivided(const WalkBox& box) const
{
  return isDividedAgain(box.end - box.begin, options_);
}

/// One division in work per depth, at most one for every two bits of the keys: no box is stored.
bool BoxWalk::walkAlongKeys(const WalkBox& whole, unsigned levels)
{
  std::array<WalkBox, 33> open; // begin: the part that is still to be walked
  std::size_t depth = 0;
  open[depth++] = { whole.begin, whole.end, whole.bits - 2 * levels };
  while (depth > 0)
  {
    WalkBox& rest = open[depth - 1];
    if (rest.begin == rest.end)
    {
      --depth;
      continue;
    }
    const std::size_t end = endOfBox(points_.key, rest.begin, rest.end, rest.bits);
    const WalkBox box{ rest.begin, end, rest.bits };
    rest.begin = end;
    const unsigned r = levelsOfDivision(end - box.begin);
    if (isDivided(box) && 2 * r <= box.bits)
    {
      open[depth++] = { box.begin, box.end, box.bits - 2 * r };
    }
    else if (!(isDivided(box) ? leaveByRank(box) : leave(box)))
    {
      return false;
    }
  }
  return true;
}

bool BoxWalk::walkReordered(const WalkBox& whole, unsigned levels)
{
  std::vector<WalkBox> waiting;
  std::vector<WalkBox> boxes;
  const Divider divider(options_, ticker_);
  if (!divider.divide(points_, whole, levels, boxes))
  {
    return false;
  }
  waiting.assign(boxes.rbegin(), boxes.rend());
  while (!waiting.empty())
  {
    const WalkBox box = waiting.back();
    waiting.pop_back();
    const unsigned r = levelsOfDivision(box.end - box.begin);
    if (isDivided(box) && 2 * r <= box.bits)
    {
      if (!divider.divide(points_, box, r, boxes))
      {
        return false;
      }
      waiting.insert(waiting.end(), boxes.rbegin(), boxes.rend());
    }
    else if (!(isDivided(box) ? leaveByRank(box) : leave(box)))
    {
      return false;
    }
  }
  return true;
}

bool BoxWalk::leaveByRank(const WalkBox& box)
{
  return inChunks(box.begin, box.end, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        *to_++ = rankOf(i);
      }
      ticker_.finished((b - a) / 4);
    });
}

bool BoxWalk::leave(const WalkBox& box)
{
  if (isAlongKeysInside(options_))
  {
    return leaveByRank(box);
  }
  return box.end - box.begin <= kFew ? leaveFewById(box) : leaveManyById(box);
}

/// Each point's place among the few is the number of smaller ids: no branch to guess wrong.
bool BoxWalk::leaveFewById(const WalkBox& box)
{
  const std::size_t n = box.end - box.begin;
  static_assert(kMaximumPoints < std::size_t(std::numeric_limits<std::int32_t>::max()),
    "ids are compared as signed numbers");
  std::array<std::int32_t, kFew> id;
  const std::size_t padded = (n + 3) & ~std::size_t(3); // whole vectors for the compiler
  for (std::size_t i = 0; i < padded; ++i)
  {
    id[i] = i < n ? static_cast<std::int32_t>(ranked_.id[rankOf(box.begin + i)])
                  : std::numeric_limits<std::int32_t>::max();
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    std::int32_t smaller = 0;
    for (std::size_t j = 0; j < padded; ++j)
    {
      smaller += id[j] < id[i] ? 1 : 0;
    }
    to_[smaller] = rankOf(box.begin + i);
  }
  to_ += n;
  ticker_.finished(n / 4);
  return ticker_.step(n);
}

bool BoxWalk::leaveManyById(const WalkBox& box)
{
  const std::size_t n = box.end - box.begin;
  Buffer<std::uint64_t> items;
  items.allocate(n);
  const bool packedAll = inChunks(0, n, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        const Index rank = rankOf(box.begin + i);
        items[i] = packed(ranked_.id[rank], rank);
      }
    });
  return packedAll && sortPacked(items, n, ticker_) &&
    inChunks(0, n, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          *to_++ = static_cast<Index>(items[i] & 0xFFFFFFFFu);
        }
        ticker_.finished((b - a) / 4);
      });
}

} // namespace ahd
