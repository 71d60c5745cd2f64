// SPDX-License-Identifier: BSD-3-Clause
#include "BucketSorter.h"

#include "../Core/Chunks.h"
#include "HilbertCurve.h"
#include "Quantise.h"
#include "Rank.h"

#include <algorithm>

namespace ahd
{

namespace
{

constexpr unsigned kMostSplitBits = 11;

/// About one bin per key, by the highest of the bits in which the keys may differ.
struct Bins
{
  Bins(unsigned bits, std::size_t keys)
    : shift(bits - std::min(bits, bitLength(keys)))
    , count(std::size_t(1) << (bits - shift))
  {
  }
  std::size_t of(std::uint64_t key) const { return key >> shift & (count - 1); }

  unsigned shift;
  std::size_t count;
};

std::uint64_t keyOf(const Record& record)
{
  return record.key;
}
std::uint64_t keyOf(std::uint64_t key)
{
  return key;
}

/// The bits in which one of the keys differs from `key`.
template <typename Item>
std::uint64_t differing(const Item* items, std::size_t n, std::uint64_t key)
{
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    bits |= keyOf(items[i]) ^ key;
  }
  return bits;
}

/// Turns the numbers of keys in the bins into places: where the first key of each bin goes, if that
/// of the first bin goes to `next`. Returns the largest of the numbers.
template <typename Places>
Index toPlaces(Places& places, std::size_t bins, Index next)
{
  Index most = 0;
  for (std::size_t b = 0; b < bins; ++b)
  {
    const Index count = places[b];
    most = std::max(most, count);
    places[b] = next;
    next += count;
  }
  return most;
}

/// The same from the keys themselves.
template <typename Item, typename Places>
Index findPlaces(const Item* items, std::size_t n, const Bins& bins, Index next, Places& places)
{
  std::fill_n(places.begin(), bins.count, 0u);
  for (std::size_t i = 0; i < n; ++i)
  {
    ++places[bins.of(keyOf(items[i]))];
  }
  return toPlaces(places, bins.count, next);
}

/// Up to kTiedByCoordinates distinct points, each with the smallest id seen at its place.
struct DistinctPoints
{
  struct Entry
  {
    Point p;
    Index id;
  };
  Entry entry[kTiedByCoordinates];
  std::size_t count = 0;

  Entry* find(const Point& p)
  {
    std::size_t i = 0;
    while (i < count && !(entry[i].p == p))
    {
      ++i;
    }
    return i < count ? entry + i : nullptr;
  }

  /// Returns false if there is no room for one more place.
  bool add(const Point& p, Index id)
  {
    if (Entry* known = find(p))
    {
      if (id < known->id)
      {
        *known = { p, id };
      }
      return true;
    }
    if (count == kTiedByCoordinates)
    {
      return false;
    }
    entry[count++] = { p, id };
    return true;
  }

  void sort()
  {
    std::sort(entry, entry + count,
      [](const Entry& a, const Entry& b) { return lexicographicallyLess(a.p, b.p); });
  }
};

} // namespace

BucketSorter::BucketSorter(const Place& place, RankedPoints& out, Ticker& ticker)
  : records_(place.records)
  , duplicate_(place.duplicates)
  , out_(out)
  , ticker_(ticker)
  , end_(place.begin)
{
}

bool BucketSorter::take(std::size_t begin, std::size_t end, unsigned bits)
{
  waiting_.push_back({ begin, end, bits, false, false, 0 });
  while (!waiting_.empty())
  {
    const Range range = waiting_.back();
    waiting_.pop_back();
    const bool goOn = range.sorted        ? emit(range)
      : range.end - range.begin <= kSmall ? sortSmall(range)
                                          : split(range);
    if (!goOn)
    {
      return false;
    }
  }
  return true;
}

/// Counting sort on the next bits, about one bin per point, straight into the final place; then an
/// insertion sort, which finds nearly nothing to do. Crowded bins are sorted first.
bool BucketSorter::sortSmall(const Range& range)
{
  const std::size_t n = range.end - range.begin;
  const Record* const from = records_ + range.begin;
  Bins bins(range.bits, n);
  const Index first = static_cast<Index>(end_);
  Index most = findPlaces(from, n, bins, first, place_);
  if (most > kCrowdedBin)
  {
    // The keys may begin alike: then further bits tell more.
    bins = Bins(bitLength(differing(from, n, from->key)), n);
    most = findPlaces(from, n, bins, first, place_);
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    fetch(from + n + i, end_ + n + i); // of the range that comes next, mostly
    put(from[i], place_[bins.of(from[i].key)]++);
  }
  if (most > kCrowdedBin)
  {
    sortCrowdedBins(bins.count);
  }
  const bool distinct = insertionSort(end_, end_ + n);
  const Range sorted{ end_, end_ + n, range.bits, true, range.crowd, range.key };
  if (!distinct || range.crowd)
  {
    return ticker_.step(n) && emit(sorted);
  }
  end_ += n;
  return ticker_.step(n);
}

/// After the counting sort place_[b] is the end of bin b.
void BucketSorter::sortCrowdedBins(std::size_t bins)
{
  std::size_t begin = end_;
  for (std::size_t b = 0; b < bins; ++b)
  {
    const std::size_t end = place_[b];
    if (end - begin > kCrowdedBin)
    {
      sortBin(begin, end);
    }
    begin = end;
  }
}

/// Sorts a crowded bin by the bits in which its keys differ, as sortSmall does the range.
void BucketSorter::sortBin(std::size_t begin, std::size_t end)
{
  const std::size_t n = end - begin;
  const std::uint64_t* const keys = out_.key.data() + begin;
  const Bins bins(bitLength(differing(keys, n, keys[0])), n);
  findPlaces(keys, n, bins, 0, inBin_);
  for (std::size_t i = 0; i < n; ++i)
  {
    sorting_[inBin_[bins.of(keys[i])]++] = { keys[i], static_cast<Index>(i) };
    points_[i] = out_.xy[begin + i];
    ids_[i] = out_.id[begin + i];
  }
  for (std::size_t b = 0, from = 0; b < bins.count; from = inBin_[b++])
  {
    if (inBin_[b] - from > kCrowdedBin)
    {
      std::sort(sorting_.begin() + from, sorting_.begin() + inBin_[b],
        [](const KeyAndPlace& x, const KeyAndPlace& y) { return x.key < y.key; });
    }
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    out_.key[begin + i] = sorting_[i].key;
    out_.xy[begin + i] = points_[sorting_[i].place];
    out_.id[begin + i] = ids_[sorting_[i].place];
  }
}

/// Returns whether the keys are all different.
bool BucketSorter::insertionSort(std::size_t begin, std::size_t end)
{
  std::uint64_t* const key = out_.key.data();
  bool distinct = true;
  for (std::size_t i = begin + 1; i < end; ++i)
  {
    if (key[i] > key[i - 1])
    {
      continue;
    }
    const std::uint64_t k = key[i];
    const Point p = out_.xy[i];
    const Index id = out_.id[i];
    std::size_t j = i;
    for (; j > begin && key[j - 1] > k; --j)
    {
      key[j] = key[j - 1];
      out_.xy[j] = out_.xy[j - 1];
      out_.id[j] = out_.id[j - 1];
    }
    distinct = distinct && (j == begin || key[j - 1] != k);
    key[j] = k;
    out_.xy[j] = p;
    out_.id[j] = id;
  }
  return distinct;
}

/// Scatters a large range by the first bits in which its keys differ.
bool BucketSorter::split(const Range& range)
{
  const std::uint64_t first = records_[range.begin].key;
  std::uint64_t unlike = 0;
  const bool looked = inChunks(range.begin, range.end, ticker_,
    [&](std::size_t a, std::size_t b) { unlike |= differing(records_ + a, b - a, first); });
  if (!looked)
  {
    return false;
  }
  if (unlike == 0)
  {
    const std::size_t to = end_;
    return copyToArrays(range.begin, range.end, to) &&
      emit({ to, to + (range.end - range.begin), 0, true, range.crowd, range.key });
  }
  const unsigned bits = bitLength(unlike);
  const std::size_t wanted = (range.end - range.begin) / kSmall + 1;
  const unsigned binBits = std::min({ bits, kMostSplitBits, bitLength(wanted) + 1 });
  return scatter(range, bits - binBits, std::size_t(1) << binBits);
}

/// To the arrays, sorted by the bits at `shift`, and back: then each bin is a range of records.
bool BucketSorter::scatter(const Range& range, unsigned shift, std::size_t bins)
{
  const Record* const records = records_;
  const std::uint64_t mask = bins - 1;
  std::fill(place_.begin(), place_.begin() + bins, 0u);
  const bool counted = inChunks(range.begin, range.end, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        ++place_[records[i].key >> shift & mask];
      }
    });
  toPlaces(place_, bins, static_cast<Index>(range.begin));
  const bool scattered = counted &&
    inChunks(range.begin, range.end, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          put(records[i], place_[records[i].key >> shift & mask]++);
        }
      });
  if (!scattered || !copyToRecords(range.begin, range.end))
  {
    return false;
  }
  for (std::size_t b = bins; b-- > 0;)
  {
    const std::size_t begin = b == 0 ? range.begin : place_[b - 1];
    if (begin < place_[b])
    {
      waiting_.push_back({ begin, place_[b], shift, false, range.crowd, range.key });
    }
  }
  return true;
}

bool BucketSorter::copyToRecords(std::size_t begin, std::size_t end)
{
  return inChunks(begin, end, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        records_[i] = { out_.xy[i].x, out_.xy[i].y, out_.key[i], out_.id[i] };
      }
    });
}

bool BucketSorter::copyToArrays(std::size_t begin, std::size_t end, std::size_t to)
{
  return inChunks(begin, end, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        put(records_[i], to + (i - begin));
      }
    });
}

/// Gives the points of a sorted range their ranks, run of equal keys by run, until it meets a
/// crowd.
bool BucketSorter::emit(const Range& range)
{
  for (std::size_t begin = range.begin; begin < range.end;)
  {
    std::size_t end = begin + 1;
    while (end < range.end && out_.key[end] == out_.key[begin])
    {
      if (++end % kChunk == 0 && !ticker_.step(kChunk))
      {
        return false;
      }
    }
    const std::uint64_t key = range.crowd ? range.key : out_.key[begin];
    if (end - begin == 1)
    {
      rank(out_.xy[begin], out_.id[begin], key);
    }
    else
    {
      bool crowd = false;
      if (!emitEqual(begin, end, key, crowd))
      {
        return false;
      }
      if (crowd)
      {
        waiting_.push_back({ end, range.end, range.bits, true, range.crowd, range.key });
        return pushCrowd(begin, end, key);
      }
    }
    begin = end;
  }
  return true;
}

/// Ranks points of one key, unless there are too many distinct ones: then sets `crowd`.
bool BucketSorter::emitEqual(std::size_t begin, std::size_t end, std::uint64_t key, bool& crowd)
{
  DistinctPoints distinct;
  const bool looked = inChunks(begin, end, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b && !crowd; ++i)
      {
        crowd = !distinct.add(out_.xy[i], out_.id[i]);
      }
    });
  if (!looked || crowd)
  {
    return looked;
  }
  const bool listed = end - begin == distinct.count ||
    inChunks(begin, end, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          const Index kept = distinct.find(out_.xy[i])->id;
          if (kept != out_.id[i])
          {
            duplicate_[duplicates_++] = { out_.id[i], kept };
          }
        }
      });
  distinct.sort();
  for (std::size_t i = 0; i < distinct.count; ++i)
  {
    rank(distinct.entry[i].p, distinct.entry[i].id, key);
  }
  return listed;
}

/// Queues a crowd as records whose keys are places in the bounds of the crowd.
bool BucketSorter::pushCrowd(std::size_t begin, std::size_t end, std::uint64_t key)
{
  Bounds bounds{ out_.xy[begin].x, out_.xy[begin].x, out_.xy[begin].y, out_.xy[begin].y };
  const bool looked = inChunks(begin, end, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        const Point& p = out_.xy[i];
        bounds = { std::min(bounds.xmin, p.x), std::max(bounds.xmax, p.x),
          std::min(bounds.ymin, p.y), std::max(bounds.ymax, p.y) };
      }
    });
  const Grid grid(bounds);
  waiting_.push_back({ begin, end, 64, false, true, key });
  return looked &&
    inChunks(begin, end, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          const Point& p = out_.xy[i];
          records_[i] = { p.x, p.y, hilbertKey(grid.column(p.x), grid.row(p.y)), out_.id[i] };
        }
      });
}

} // namespace ahd
