// SPDX-License-Identifier: BSD-3-Clause
#include "Rank.h"

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "BucketSorter.h"
#include "Scatter.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace ahd
{

namespace
{

constexpr std::size_t kGroupsPerThread = 8;     // crowded buckets take longer than others
constexpr std::size_t kFewToGroup = 4 * kChunk; // no group for less

/// How out.scratch is used. The counters of the scatter lie where the duplicates come later.
struct Layout
{
  explicit Layout(RankedPoints& out, std::size_t n)
    : records(reinterpret_cast<Record*>(out.scratch.data()))
    , keys(reinterpret_cast<std::uint64_t*>(records + n))
    , duplicates(reinterpret_cast<Duplicate*>(keys + n))
    , counters(out.scratch.data() + (n * (sizeof(Record) + sizeof(*keys)) + 63) / 64 * 64)
  {
  }
  Record* records;
  std::uint64_t* keys;
  Duplicate* duplicates; ///< those of a group of buckets begin where its points do
  void* counters;
};

/// Buckets that one task sorts, and the outcome.
struct Group
{
  std::size_t firstBucket, endBucket;
  std::size_t begin;     ///< place of its first record, and of its first rank until closeGaps
  std::size_t count = 0; ///< ranks
  std::size_t duplicates = 0;
  std::size_t to = 0; ///< its first rank
};

std::vector<Group> makeGroups(const Scatter& scatter, std::size_t n, std::size_t threads)
{
  const std::size_t wanted = tasksFor(threads, n, kGroupsPerThread, kFewToGroup);
  std::vector<Group> groups;
  std::size_t first = 0;
  for (std::size_t g = 0; g < wanted; ++g)
  {
    const std::size_t end = g + 1 == wanted ? scatter.buckets()
                                            : scatter.firstFrom(Share(n, g, wanted).end);
    if (first < end)
    {
      groups.push_back({ first, end, scatter.begin(first) });
      first = end;
    }
  }
  return groups;
}

/// The sorter takes 50 KiB: on the heap, as the stack may be small.
bool sortGroup(
  Group& group, const Scatter& scatter, const Layout& layout, RankedPoints& out, Ticker& ticker)
{
  const auto sorter = std::make_unique<BucketSorter>(
    BucketSorter::Place{ layout.records, layout.duplicates + group.begin, group.begin }, out,
    ticker);
  for (std::size_t b = group.firstBucket; b < group.endBucket; ++b)
  {
    const std::size_t begin = scatter.begin(b);
    const std::size_t end = scatter.begin(b + 1);
    if (begin < end && !sorter->take(begin, end, scatter.bitsLeft()))
    {
      return false;
    }
    ticker.finished((end - begin) / 4);
  }
  group.count = sorter->end() - group.begin;
  group.duplicates = sorter->duplicates();
  return true;
}

template <typename T>
bool copyInChunks(const T* from, T* to, std::size_t n, Ticker& ticker)
{
  return inChunks(
    0, n, ticker, [&](std::size_t a, std::size_t b) { std::copy(from + a, from + b, to + a); });
}

/// Closes the gaps between the ranks of all groups. Copies out of the arrays and back, both in
/// parallel: moved in place, each group would have to wait for the one before.
bool closeGaps(const std::vector<Group>& groups, const Layout& layout, std::size_t n,
  RankedPoints& out, Ticker& ticker)
{
  Point* const xy = reinterpret_cast<Point*>(layout.records);
  std::uint64_t* const key = reinterpret_cast<std::uint64_t*>(xy + n);
  Index* const id = reinterpret_cast<Index*>(key + n);
  static_assert(sizeof(Point) + sizeof(std::uint64_t) + sizeof(Index) <= sizeof(Record), "room");
  const auto move = [&](std::size_t g, Ticker& own)
  {
    const Group& group = groups[g];
    return group.begin == group.to ||
      (copyInChunks(&out.xy[group.begin], xy + group.to, group.count, own) &&
        copyInChunks(&out.key[group.begin], key + group.to, group.count, own) &&
        copyInChunks(&out.id[group.begin], id + group.to, group.count, own));
  };
  const auto moveBack = [&](std::size_t g, Ticker& own)
  {
    const Group& group = groups[g];
    return group.begin == group.to ||
      (copyInChunks(xy + group.to, &out.xy[group.to], group.count, own) &&
        copyInChunks(key + group.to, &out.key[group.to], group.count, own) &&
        copyInChunks(id + group.to, &out.id[group.to], group.count, own));
  };
  return inParallel(ticker, groups.size(), move) && inParallel(ticker, groups.size(), moveBack);
}

/// Moves the duplicates of all groups to the end of the scratch, the last group first: none is
/// moved down, so none is overwritten before its turn.
bool gatherDuplicates(
  const std::vector<Group>& groups, const Layout& layout, RankedPoints& out, Ticker& ticker)
{
  Duplicate* const end = reinterpret_cast<Duplicate*>(out.scratch.data() + out.scratch.size());
  Duplicate* to = end;
  for (std::size_t g = groups.size(); g-- > 0;)
  {
    const Duplicate* const from = layout.duplicates + groups[g].begin;
    for (std::size_t left = groups[g].duplicates; left > 0;)
    {
      const std::size_t some = std::min(left, kChunk);
      to = std::copy_backward(from + (left - some), from + left, to);
      left -= some;
      if (!ticker.step(some))
      {
        return false;
      }
    }
  }
  out.duplicates.view(to, static_cast<std::size_t>(end - to));
  return true;
}

} // namespace

Status rankPoints(const PointView& points, Ticker& sorting, RankedPoints& out)
{
  const std::size_t n = out.count;
  const std::size_t threads = threadsOf(sorting);
  out.duplicates.reset();
  out.xy.allocate(n + 1);
  out.id.allocate(n);
  if (out.scratch.size() < rankScratchBytes(n))
  {
    out.scratch.allocate(rankScratchBytes(n));
  }
  const Layout layout(out, n);
  out.key.view(layout.keys, n);
  Scatter scatter(points, out, threads);
  if (!scatter.run(layout.records, layout.keys, layout.counters, sorting))
  {
    return Status::Cancelled;
  }
  std::vector<Group> groups = makeGroups(scatter, n, threads);
  const auto sort = [&](std::size_t g, Ticker& own)
  { return sortGroup(groups[g], scatter, layout, out, own); };
  if (!inParallel(sorting, groups.size(), sort))
  {
    return Status::Cancelled;
  }
  std::size_t count = 0;
  for (Group& group : groups)
  {
    group.to = count;
    count += group.count;
  }
  if ((count < n && !closeGaps(groups, layout, n, out, sorting)) ||
    !gatherDuplicates(groups, layout, out, sorting))
  {
    return Status::Cancelled;
  }
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  out.count = static_cast<Index>(count);
  out.xy[count] = { kNaN, kNaN };
  return Status::Ok;
}

} // namespace ahd
