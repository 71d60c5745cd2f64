// SPDX-License-Identifier: BSD-3-Clause
#include "Rank.h"

#include "../Chunks.h"
#include "BucketSorter.h"
#include "HilbertCurve.h"
#include "Quantise.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace ahd
{

namespace
{

constexpr std::size_t kBucket = 256;      // points per bucket aimed at
constexpr unsigned kMostBucketBits = 15;  // more buckets than this cost more than they save
constexpr std::size_t kPrefetchAhead = 2; // records: the next cache line

/// The caller's numbers, widened.
template <typename Number>
struct Source
{
  const Number* numbers;
  std::size_t stride;

  Point operator[](std::size_t i) const { return { numbers[i * stride], numbers[i * stride + 1] }; }
};

/// Keys of all finite points in the caller's order, and how many fall into each bucket; then the
/// records, bucket by bucket.
class Scatter
{
public:
  Scatter(const PointView& points, RankedPoints& out, Ticker& ticker)
    : points_(points)
    , out_(out)
    , ticker_(ticker)
    , grid_(out.bounds)
    , plain_(out.count == points.count)
    , bits_(out.count <= kBucket ? 0 : std::min(kMostBucketBits, bitLength(out.count / kBucket)))
    , place_((std::size_t(1) << bits_) + 1, 0u)
  {
  }

  bool run(Buffer<Record>& records)
  {
    return points_.doubles ? runOn(Source<double>{ points_.doubles, points_.stride }, records)
                           : runOn(Source<float>{ points_.floats, points_.stride }, records);
  }

  /// After run(): bucket b is [begin(b), begin(b + 1)) and shares all but so many bits.
  std::size_t buckets() const { return std::size_t(1) << bits_; }
  std::size_t begin(std::size_t b) const { return b == 0 ? 0 : place_[b - 1]; }
  unsigned bitsLeft() const { return 64 - bits_; }

private:
  template <typename From>
  bool runOn(const From& from, Buffer<Record>& records)
  {
    return plain_ ? makeKeys<true>(from) && makeRecords<true>(from, records)
                  : makeKeys<false>(from) && makeRecords<false>(from, records);
  }

  std::size_t bucketOf(std::uint64_t key) const { return key >> 1 >> (63 - bits_); }

  template <bool kPlain, typename From>
  bool wanted(const From& from, std::size_t i) const
  {
    return kPlain || (!points_.skipped(i) && isFinite(from[i]));
  }

  template <bool kPlain, typename From>
  bool makeKeys(const From& from)
  {
    std::uint64_t* next = out_.key.data();
    return inChunks(0, points_.count, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          if (wanted<kPlain>(from, i))
          {
            const Point p = from[i];
            const std::uint64_t key = hilbertKey(grid_.column(p.x), grid_.row(p.y));
            *next++ = key;
            ++place_[bucketOf(key)];
          }
        }
        ticker_.finished((b - a) / 4);
      });
  }

  template <bool kPlain, typename From>
  bool makeRecords(const From& from, Buffer<Record>& records)
  {
    Index sum = 0;
    for (Index& place : place_)
    {
      const Index count = place;
      place = sum;
      sum += count;
    }
    const std::uint64_t* next = out_.key.data();
    Record* const to = records.data();
    return inChunks(0, points_.count, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          if (wanted<kPlain>(from, i))
          {
            const Point p = from[i];
            const std::uint64_t key = *next++;
            Record* const r = to + place_[bucketOf(key)]++;
            *r = { p.x, p.y, key, static_cast<Index>(i) };
            prefetchForWrite(r + kPrefetchAhead);
          }
        }
        ticker_.finished((b - a) / 4);
      });
  }

  const PointView& points_;
  RankedPoints& out_;
  Ticker& ticker_;
  Grid grid_;
  bool plain_;
  unsigned bits_;
  std::vector<Index> place_; ///< where the next record of each bucket goes
};

} // namespace

Status rankPoints(const PointView& points, Ticker& sorting, RankedPoints& out)
{
  const std::size_t n = out.count;
  out.duplicates.clear();
  out.xy.allocate(n + 1);
  out.id.allocate(n);
  Buffer<Record> records;
  if (out.scratch.size() < n * kRankScratchPerPoint)
  {
    out.scratch.allocate(n * kRankScratchPerPoint);
  }
  records.view(out.scratch.data(), n);
  out.key.view(out.scratch.data() + n * sizeof(Record), n);

  Scatter scatter(points, out, sorting);
  if (!scatter.run(records))
  {
    return Status::Cancelled;
  }
  BucketSorter sorter(records, out, sorting);
  for (std::size_t b = 0; b < scatter.buckets(); ++b)
  {
    const std::size_t begin = scatter.begin(b);
    const std::size_t end = scatter.begin(b + 1);
    if (begin < end && !sorter.take(begin, end, scatter.bitsLeft()))
    {
      return Status::Cancelled;
    }
    sorting.finished((end - begin) / 4);
  }
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  out.count = static_cast<Index>(sorter.end());
  out.xy[sorter.end()] = { kNaN, kNaN };
  return Status::Ok;
}

} // namespace ahd
