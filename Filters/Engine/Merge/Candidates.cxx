// SPDX-License-Identifier: BSD-3-Clause
#include "Candidates.h"

#include "../Core/Buffer.h"
#include "../Core/Loops.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ahd
{
namespace
{

constexpr std::size_t kBlock = 256; ///< points at a time, in the first-level cache

/// Some of the points: their positions and numbers.
struct Block
{
  double x[kBlock];
  double y[kBlock];
  std::uint32_t number[kBlock];
  std::size_t count = 0;

  void add(const Point& p, std::size_t i, bool counts)
  {
    x[count] = p.x;
    y[count] = p.y;
    number[count] = static_cast<std::uint32_t>(i);
    count += counts;
  }
};

/// The square lattice of cells over the plane, and the cells touched by the square around a point
/// with sides a little longer than the distance. The squares of two points overlap if these are
/// within the distance along both axes: then they touch a cell in common. This needs no exactness,
/// as all operations are monotone: rounded sums, rounded products, truncation. With a <= b <= a +
/// 1.125 distance, b - r is not above a + r, rounded or not, so the number of the cell of b - r is
/// one of those from the cell of a - r to that of a + r.
class Cells
{
public:
  /// Cells are so many distances wide, or more, so that there are no more than 2^31 in a row.
  /// @pre distance and the largest magnitude of a coordinate are below 2^1000.
  Cells(double distance, double width, double magnitude)
    : reach_(0.5625 * distance) // rounded among subnormal numbers, still half the distance
    , scale_(1.0 / std::max({ width * distance, magnitude * 0x1p-30, 0x1p-1000 }))
  {
  }

  /// Calls prefetch(hash) and later visit(k, hash) for each cell that the square of the block's
  /// k-th point touches: mostly one, nine at most.
  template <typename Prefetch, typename Visit>
  void visitAll(const Block& block, const Prefetch& prefetch, const Visit& visit) const
  {
    std::int32_t left[kBlock], right[kBlock], low[kBlock], high[kBlock];
    number(block.x, -reach_, left, block.count);
    number(block.x, reach_, right, block.count);
    number(block.y, -reach_, low, block.count);
    number(block.y, reach_, high, block.count);
    std::uint32_t hashes[kBlock];
    std::uint32_t across[kBlock]; // those that touch several
    std::size_t acrossCount = 0;
    for (std::size_t k = 0; k < block.count; ++k)
    {
      hashes[k] = hash(left[k], low[k]);
      prefetch(hashes[k]);
      across[acrossCount] = static_cast<std::uint32_t>(k);
      acrossCount += left[k] != right[k] || low[k] != high[k];
    }
    for (std::size_t k = 0; k < block.count; ++k)
    {
      visit(k, hashes[k]);
    }
    for (std::size_t i = 0; i < acrossCount; ++i)
    {
      const std::size_t k = across[i];
      for (std::int32_t row = low[k]; row <= high[k]; ++row)
      {
        for (std::int32_t column = left[k] + (row == low[k]); column <= right[k]; ++column)
        {
          visit(k, hash(column, row));
        }
      }
    }
  }

private:
  /// The numbers of the cells along an axis, at the coordinates plus `beside`.
  void number(
    const double* coordinates, double beside, std::int32_t* cells, std::size_t count) const
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      cells[k] = static_cast<std::int32_t>((coordinates[k] + beside) * scale_);
    }
  }

  static std::uint32_t hash(std::int32_t column, std::int32_t row)
  {
    const std::uint64_t both = std::uint64_t(std::uint32_t(column)) << 32 | std::uint32_t(row);
    const std::uint64_t h = both * 0x9E3779B97F4A7C15u;
    return static_cast<std::uint32_t>((h ^ h >> 32) * 0xD6E8FEB86659FD93u >> 32);
  }

  double reach_;
  double scale_;
};

/// The cells that are touched once, and those touched more often: a bit per hash value of cells, so
/// cells with one hash count as the same.
class Touched
{
public:
  /// For so many points, with 8 cells for each.
  bool clear(std::size_t points, Ticker& ticker)
  {
    once_.allocate(points / 4 + 1);
    again_.allocate(points / 4 + 1);
    return fillAll(once_, 0u, ticker) && fillAll(again_, 0u, ticker);
  }

  void prefetchToTouch(std::uint32_t hash) const { prefetchForWrite(&once_[wordOf(hash)]); }
  void touch(std::uint32_t hash)
  {
    std::uint32_t& word = once_[wordOf(hash)];
    const std::uint32_t bit = bitOf(hash);
    if ((word & bit) != 0)
    {
      again_[wordOf(hash)] |= bit;
    }
    word |= bit;
  }

  void prefetchToAsk(std::uint32_t hash) const { prefetchForRead(&again_[wordOf(hash)]); }
  bool isTouchedAgain(std::uint32_t hash) const
  {
    return (again_[wordOf(hash)] & bitOf(hash)) != 0;
  }

  std::size_t words() const { return once_.size(); }

  /// Adds the words [begin, end) of `other`.
  void merge(const Touched& other, std::size_t begin, std::size_t end)
  {
    for (std::size_t k = begin; k < end; ++k)
    {
      again_[k] |= other.again_[k] | (once_[k] & other.once_[k]);
      once_[k] |= other.once_[k];
    }
  }

private:
  std::size_t wordOf(std::uint32_t hash) const { return std::uint64_t(hash) * once_.size() >> 32; }
  static std::uint32_t bitOf(std::uint32_t hash) { return 1u << (hash & 31); }

  Buffer<std::uint32_t> once_; ///< a bit per cell
  Buffer<std::uint32_t> again_;
};

/// Sets flags[i] to 1 if item i touches a cell that another one touches, else to 0.
/// `add(i, block)` adds the place of item i, if it counts.
template <typename Add>
class Round
{
public:
  Round(std::size_t count, const Cells& cells, const Add& add, Ticker& ticker)
    : count_(count)
    , cells_(cells)
    , add_(add)
    , ticker_(ticker)
  {
  }

  /// `flagged` becomes how many flags are set.
  bool run(unsigned char* flags, std::size_t& flagged)
  {
    return touchAll() && flagAll(flags, flagged);
  }

private:
  struct Count
  {
    std::size_t of = 0;
    void merge(const Count& other) { of += other.of; }
  };

  /// Calls work(block) for the items [begin, end).
  template <typename Work>
  void inBlocks(std::size_t begin, std::size_t end, const Work& work) const
  {
    for (std::size_t a = begin; a < end; a += kBlock)
    {
      Block block;
      for (std::size_t i = a; i != std::min(end, a + kBlock); ++i)
      {
        add_(i, block);
      }
      work(block);
    }
  }

  /// A table for each task, then all into the first.
  bool touchAll()
  {
    constexpr std::size_t kMostTables = 4;
    const std::size_t tasks = std::min(kMostTables, tasksForLoop(ticker_, count_));
    tables_ = std::vector<Touched>(std::min(tasks, threadsOf(ticker_)));
    const auto touch = [&](std::size_t task, Ticker& own)
    {
      Touched& table = tables_[task];
      const Share share(count_, task, tables_.size());
      return table.clear(count_, own) &&
        inChunks(share.begin, share.end, own,
          [&](std::size_t a, std::size_t b)
          {
            inBlocks(a, b,
              [&](const Block& block)
              {
                cells_.visitAll(
                  block, [&table](std::uint32_t hash) { table.prefetchToTouch(hash); },
                  [&table](std::size_t, std::uint32_t hash) { table.touch(hash); });
              });
            own.finished(b - a);
          });
    };
    const auto merge = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = 1; k < tables_.size(); ++k)
      {
        tables_[0].merge(tables_[k], a, b);
      }
    };
    return inParallel(ticker_, tables_.size(), touch) &&
      (tables_.size() == 1 || inChunksOf(tables_[0].words(), ticker_, merge));
  }

  bool flagAll(unsigned char* flags, std::size_t& flagged)
  {
    const Touched& table = tables_[0];
    Count count;
    const bool all = gather(count_, ticker_, count,
      [&](Count& part, std::size_t a, std::size_t b)
      {
        std::fill(flags + a, flags + b, static_cast<unsigned char>(0));
        inBlocks(a, b,
          [&](const Block& block)
          {
            cells_.visitAll(
              block, [&table](std::uint32_t hash) { table.prefetchToAsk(hash); },
              [&](std::size_t k, std::uint32_t hash)
              { flags[block.number[k]] |= table.isTouchedAgain(hash); });
          });
        part.of += static_cast<std::size_t>(std::count(flags + a, flags + b, 1));
      });
    flagged = count.of;
    return all;
  }

  const std::size_t count_;
  const Cells& cells_;
  const Add& add_;
  Ticker& ticker_;
  std::vector<Touched> tables_;
};

template <typename Add>
bool flagCandidates(std::size_t count, const Cells& cells, const Add& add, unsigned char* flags,
  std::size_t& flagged, Ticker& ticker)
{
  return Round<Add>(count, cells, add, ticker).run(flags, flagged);
}

bool counts(const PointView& points, std::size_t i, const Point& p)
{
  return isFinite(p) && !points.skipped(i);
}

/// The largest magnitude of coordinates.
struct Magnitude
{
  double most = 0.0;

  void merge(const Magnitude& other) { most = std::max(most, other.most); }
};

bool findMagnitude(const PointView& points, Ticker& ticker, Magnitude& magnitude)
{
  return gather(points.count, ticker, magnitude,
    [&points](Magnitude& part, std::size_t a, std::size_t b)
    {
      double most = part.most;
      for (std::size_t i = a; i != b; ++i)
      {
        const Point p = points[i];
        const double both = std::max(std::fabs(p.x), std::fabs(p.y));
        most = counts(points, i, p) ? std::max(most, both) : most;
      }
      part.most = most;
    });
}

/// Appends the points for which wants(i) is true and that count.
template <typename Wants>
bool collect(
  const PointView& points, const Wants& wants, std::vector<Located>& found, Ticker& ticker)
{
  return inChunks(0, points.count, ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        if (wants(i) && counts(points, i, points[i]))
        {
          found.push_back({ points[i], static_cast<Index>(i) });
        }
      }
    });
}

/// Keeps the items whose flag is set.
bool keepFlagged(std::vector<Located>& items, const unsigned char* flags, Ticker& ticker)
{
  std::size_t size = 0;
  const bool all = inChunks(0, items.size(), ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        items[size] = items[i];
        size += flags[i];
      }
    });
  items.resize(size);
  return all;
}

/// Sets the flags of the points that may be near others, if these are no more than half; else sets
/// `flagged` to more than that.
bool flagPoints(const PointView& points, double distance, double magnitude, unsigned char* flags,
  std::size_t& flagged, Ticker& ticker)
{
  flagged = points.count;
  return !(distance < 0x1p1000 && magnitude < 0x1p1000) ||
    flagCandidates(
      points.count, Cells(distance, 16.0, magnitude),
      [&points](std::size_t i, Block& block)
      { block.add(points[i], i, counts(points, i, points[i])); },
      flags, flagged, ticker);
}

} // namespace

bool findCandidates(const PointView& points, double distance, unsigned char* flags, Ticker& ticker,
  std::vector<Located>& found)
{
  std::size_t flagged = 0;
  Magnitude magnitude;
  if (!findMagnitude(points, ticker, magnitude) ||
    !flagPoints(points, distance, magnitude.most, flags, flagged, ticker))
  {
    return false;
  }
  if (flagged > points.count / 2)
  {
    found.reserve(points.count);
    return collect(
      points, [](std::size_t) { return true; }, found, ticker);
  }
  found.reserve(flagged);
  return collect(
           points, [flags](std::size_t i) { return flags[i] != 0; }, found, ticker) &&
    flagCandidates(
      flagged, Cells(distance, 4.0, magnitude.most),
      [&found](std::size_t i, Block& block) { block.add(found[i].at, i, true); }, flags, flagged,
      ticker) &&
    keepFlagged(found, flags, ticker);
}

} // namespace ahd
