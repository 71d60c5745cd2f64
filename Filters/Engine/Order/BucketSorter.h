// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BucketSorter_h
#define ahd_BucketSorter_h

#include "../Core/Chunks.h"
#include "../Core/Progress.h"
#include "../Points/Points.h"
#include "RankedPoints.h"
#include "Record.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Sorts buckets of records by (key, x, y) into the arrays of a RankedPoints, one bucket after the
/// other, drops duplicates, and ranks crowds of one key again in bounds of their own.
///
/// Two places hold points: `records`, and the arrays of `out`, whose part from `end()` on is free
/// scratch for the current bucket. Pending ranges lie on a stack, so nothing recurses. Several
/// sorters may work on the same arrays: each touches only the places of the records it takes.
class BucketSorter
{
public:
  struct Place
  {
    Record* records;       ///< of all buckets; as many as the arrays of `out` have room for
    Duplicate* duplicates; ///< where those found here go; never more than records taken
    std::size_t begin;     ///< of the first bucket
  };
  BucketSorter(const Place& place, RankedPoints& out, Ticker& ticker);

  /// Takes the records [begin, end), whose keys differ at most in their low `bits` bits. Buckets
  /// come in ascending order of key and, without gaps, of place: begin is the end of the bucket
  /// before. Returns false if cancelled.
  bool take(std::size_t begin, std::size_t end, unsigned bits);

  /// Behind the last rank given.
  std::size_t end() const { return end_; }
  /// Duplicates found so far.
  std::size_t duplicates() const { return duplicates_; }

private:
  /// Points that are still to be ranked.
  struct Range
  {
    std::size_t begin, end;
    unsigned bits; ///< the keys may differ in so many low bits
    bool sorted;   ///< in the arrays of `out` and sorted by key; else in `records`
    bool crowd;    ///< the points share `key`; the keys of the records are places within the crowd
    std::uint64_t key;
  };

  struct KeyAndPlace
  {
    std::uint64_t key;
    Index place;
  };

  static constexpr std::size_t kSmall = 1024; ///< ranges up to this size are sorted in one go
  static constexpr std::size_t kCrowdedBin =
    24; ///< most points that insertion sort may see at once

  bool sortSmall(const Range& range);
  void sortCrowdedBins(std::size_t bins);
  void sortBin(std::size_t begin, std::size_t end);
  bool insertionSort(std::size_t begin, std::size_t end);

  bool split(const Range& range);
  bool scatter(const Range& range, unsigned shift, std::size_t bins);
  bool copyToRecords(std::size_t begin, std::size_t end);
  bool copyToArrays(std::size_t begin, std::size_t end, std::size_t to);

  bool emit(const Range& range);
  bool emitEqual(std::size_t begin, std::size_t end, std::uint64_t key, bool& crowd);
  bool pushCrowd(std::size_t begin, std::size_t end, std::uint64_t key);

  void put(const Record& r, std::size_t to)
  {
    out_.xy[to] = { r.x, r.y };
    out_.key[to] = r.key;
    out_.id[to] = r.id;
  }
  /// Prefetches a record to be read and its destination; both may lie past the end.
  void fetch(const Record* r, std::size_t to)
  {
    prefetchForRead(r);
    if (to % 4 == 0) // four points lie in a cache line
    {
      prefetchForWrite(out_.xy.data() + to);
      prefetchForWrite(out_.key.data() + to);
      prefetchForWrite(out_.id.data() + to);
    }
  }
  void rank(const Point& p, Index id, std::uint64_t key)
  {
    out_.xy[end_] = p;
    out_.id[end_] = id;
    out_.key[end_] = key;
    ++end_;
  }

  Record* records_;
  Duplicate* duplicate_;
  std::size_t duplicates_ = 0;
  RankedPoints& out_;
  Ticker& ticker_;
  std::size_t end_;
  std::vector<Range> waiting_;

  // Scratch of the current ranges.
  std::array<Index, 2 * kSmall> place_;
  std::array<Index, 2 * kSmall> inBin_;
  std::array<KeyAndPlace, kSmall> sorting_;
  std::array<Point, kSmall> points_;
  std::array<Index, kSmall> ids_;
};

} // namespace ahd

#endif
