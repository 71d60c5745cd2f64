// SPDX-License-Identifier: BSD-3-Clause
#include "Scatter.h"

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "HilbertKeys.h"

#include <algorithm>

namespace ahd
{

namespace
{

constexpr std::size_t kBucket = 256;       // points per bucket aimed at
constexpr std::size_t kPointsAhead = 64;   // fetched, and their keys
constexpr unsigned kMostBucketBits = 15;   // more buckets than this cost more than they save
constexpr std::size_t kPrefetchAhead = 2;  // records: the next cache line
constexpr unsigned kMostCachedBits = 12;   // of so many buckets the next lines stay in the cache
constexpr std::ptrdiff_t kKeysAhead = 24;  // of more buckets: the key whose place is fetched
constexpr std::size_t kTasksPerThread = 4; // so that a late thread delays the others less
constexpr std::size_t kMostTasks = 128;    // their counters fit into counterBytes()
constexpr std::size_t kFewPoints = kChunk; // no task for less
constexpr std::size_t kLine = 64 / sizeof(Index); // counters per cache line

/// The caller's numbers, widened.
template <typename Number>
struct Source
{
  const Number* numbers;
  std::size_t stride;

  Point operator[](std::size_t i) const { return { numbers[i * stride], numbers[i * stride + 1] }; }
  void prefetch(std::size_t i) const { prefetchForRead(numbers + i * stride); }
};

unsigned bucketBits(std::size_t n)
{
  return n <= kBucket ? 0 : std::min(kMostBucketBits, bitLength(n / kBucket));
}

} // namespace

Scatter::Scatter(const PointView& points, const RankedPoints& ranked, std::size_t threads)
  : points_(points)
  , grid_(ranked.whole)
  , plain_(ranked.count == points.count)
  , bits_(bucketBits(ranked.count))
  , tasks_(std::min(kMostTasks, tasksFor(threads, ranked.count, kTasksPerThread, kFewPoints)))
  , row_((buckets() + kLine - 1) / kLine * kLine)
  , begin_(buckets() + 1)
  , firstKey_(tasks_ + 1)
{
  // row_ <= 2 n / kBucket, or one line: there is room for the counters of all tasks.
  constexpr std::size_t kPerPoint = counterBytes(2) - counterBytes(1);
  static_assert(2 * kMostTasks * sizeof(Index) <= kBucket * kPerPoint, "counterBytes() is too low");
  static_assert(kLine * sizeof(Index) <= kFewPoints * kPerPoint, "counterBytes() is too low");
}

std::size_t Scatter::firstFrom(std::size_t place) const
{
  const auto found = std::lower_bound(begin_.begin(), begin_.end() - 1, place);
  return static_cast<std::size_t>(found - begin_.begin());
}

bool Scatter::run(Record* records, std::uint64_t* keys, void* counters, Ticker& ticker)
{
  records_ = records;
  keys_ = keys;
  place_ = static_cast<Index*>(counters);
  return points_.doubles ? runOn(Source<double>{ points_.doubles, points_.stride }, ticker)
                         : runOn(Source<float>{ points_.floats, points_.stride }, ticker);
}

template <typename From>
bool Scatter::runOn(const From& from, Ticker& ticker)
{
  return plain_ ? countFinite<true>(from, ticker) && makeKeys<true>(from, ticker) &&
      makePlaces(ticker) && makeRecords<true>(from, ticker)
                : countFinite<false>(from, ticker) && makeKeys<false>(from, ticker) &&
      makePlaces(ticker) && makeRecords<false>(from, ticker);
}

template <bool kPlain, typename From>
bool Scatter::wanted(const From& from, std::size_t i) const
{
  return kPlain || (!points_.skipped(i) && isFinite(from[i]));
}

/// Finds the first key of each task.
template <bool kPlain, typename From>
bool Scatter::countFinite(const From& from, Ticker& ticker)
{
  const bool counted = kPlain || tasks_ == 1 ||
    inParallel(ticker, tasks_,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(points_.count, task, tasks_);
        std::size_t count = 0;
        const bool done = inChunks(share.begin, share.end, own,
          [&](std::size_t a, std::size_t b)
          {
            for (std::size_t i = a; i < b; ++i)
            {
              count += wanted<kPlain>(from, i) ? 1u : 0u;
            }
          });
        firstKey_[task + 1] = count;
        return done;
      });
  for (std::size_t task = 0; task < tasks_; ++task)
  {
    firstKey_[task + 1] = kPlain ? Share(points_.count, task, tasks_).end
                                 : firstKey_[task] + firstKey_[task + 1];
  }
  return counted;
}

/// Keys of the finite points among [begin, end), at most kKeyBlock points; returns how many.
template <bool kPlain, typename From>
std::size_t Scatter::makeKeyBlock(
  const From& from, std::size_t begin, std::size_t end, std::uint64_t* keys) const
{
  std::uint32_t columns[kKeyBlock];
  std::uint32_t rows[kKeyBlock];
  std::size_t count = 0;
  const Grid grid = grid_;
  for (std::size_t i = begin; i < end; ++i)
  {
    from.prefetch(i + kPointsAhead);
    if (wanted<kPlain>(from, i))
    {
      const Point p = from[i];
      columns[count] = grid.column(p.x);
      rows[count++] = grid.row(p.y);
    }
  }
  hilbertKeys(columns, rows, keys, count);
  return count;
}

/// Keys of all finite points in the caller's order, and how many of each task fall into each
/// bucket.
template <bool kPlain, typename From>
bool Scatter::makeKeys(const From& from, Ticker& ticker)
{
  return inParallel(ticker, tasks_,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(points_.count, task, tasks_);
      Index* const count = place(task);
      std::fill(count, count + buckets(), 0u);
      std::uint64_t* next = keys_ + firstKey_[task];
      return inChunks(share.begin, share.end, own,
        [&](std::size_t a, std::size_t b)
        {
          for (std::size_t i = a; i < b; i += kKeyBlock)
          {
            const std::size_t made = makeKeyBlock<kPlain>(
              from, i, std::min(b, i + kKeyBlock), next);
            std::for_each(next, next + made, [&](std::uint64_t key) { ++count[bucketOf(key)]; });
            next += made;
          }
          own.finished((b - a) / 4);
        });
    });
}

/// Turns the counters into places: bucket by bucket, and in each task by task.
bool Scatter::makePlaces(Ticker& ticker)
{
  const std::size_t lines = row_ / kLine;
  const std::size_t parts = std::min(tasks_, lines);
  const auto forLines = [&](const auto& work)
  {
    return inParallel(ticker, parts,
      [&](std::size_t part, Ticker& own)
      {
        const Share share(lines, part, parts);
        for (std::size_t line = share.begin; line < share.end; ++line)
        {
          work(line * kLine, std::min(buckets(), (line + 1) * kLine));
          if (!own.step(tasks_ * kLine))
          {
            return false;
          }
        }
        return true;
      });
  };
  const bool counted = forLines(
    [&](std::size_t first, std::size_t end)
    {
      std::fill(begin_.data() + first + 1, begin_.data() + end + 1, 0u);
      for (std::size_t task = 0; task < tasks_; ++task)
      {
        for (std::size_t b = first; b < end; ++b)
        {
          begin_[b + 1] += place(task)[b];
        }
      }
    });
  for (std::size_t b = 0; counted && b < buckets(); ++b)
  {
    begin_[b + 1] += begin_[b];
  }
  return counted &&
    forLines(
      [&](std::size_t first, std::size_t end)
      {
        Index next[kLine];
        std::copy(begin_.data() + first, begin_.data() + end, next);
        for (std::size_t task = 0; task < tasks_; ++task)
        {
          for (std::size_t b = first; b < end; ++b)
          {
            const Index count = place(task)[b];
            place(task)[b] = next[b - first];
            next[b - first] += count;
          }
        }
      });
}

template <bool kPlain, typename From>
bool Scatter::makeRecords(const From& from, Ticker& ticker)
{
  return inParallel(ticker, tasks_,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(points_.count, task, tasks_);
      Index* const places = place(task);
      const std::uint64_t* next = keys_ + firstKey_[task];
      const std::uint64_t* const end = keys_ + firstKey_[task + 1];
      const bool isCached = bits_ <= kMostCachedBits;
      return inChunks(share.begin, share.end, own,
        [&](std::size_t a, std::size_t b)
        {
          for (std::size_t i = a; i < b; ++i)
          {
            if (wanted<kPlain>(from, i))
            {
              const Point p = from[i];
              from.prefetch(i + kPointsAhead);
              prefetchForRead(next + kPointsAhead);
              const std::uint64_t key = *next++;
              Record* const r = records_ + places[bucketOf(key)]++;
              *r = { p.x, p.y, key, static_cast<Index>(i) };
              const std::uint64_t* const later = next + std::min(kKeysAhead, end - next - 1);
              prefetchForWrite(isCached ? r + kPrefetchAhead : records_ + places[bucketOf(*later)]);
            }
          }
          own.finished((b - a) / 4);
        });
    });
}

} // namespace ahd
