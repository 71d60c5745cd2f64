// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Scatter_h
#define ahd_Scatter_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Points/Points.h"
#include "Quantise.h"
#include "RankedPoints.h"
#include "Record.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Distributes the finite points to buckets by the first bits of their keys, in the order of the
/// caller within each bucket, whatever the number of tasks that share the work.
class Scatter
{
public:
  /// Takes the bounds and the number of the finite points from `ranked`.
  Scatter(const PointView& points, const RankedPoints& ranked, std::size_t threads);

  /// Bytes that counters() need at most, for so many finite points.
  static constexpr std::size_t counterBytes(std::size_t n) { return 8 * n + 64; }

  /// Fills `records`, with `keys` (one per finite point) and `counters` as scratch. Moves the
  /// fraction by half a unit per point. Returns false if cancelled.
  /// @pre counterBytes() bytes at `counters`, aligned to 64.
  bool run(Record* records, std::uint64_t* keys, void* counters, Ticker& ticker);

  /// After run(): bucket b is [begin(b), begin(b + 1)), and its keys share all but so many bits.
  std::size_t buckets() const { return std::size_t(1) << bits_; }
  std::size_t begin(std::size_t b) const { return begin_[b]; }
  unsigned bitsLeft() const { return 64 - bits_; }

  /// The first bucket that begins at this place or behind it.
  std::size_t firstFrom(std::size_t place) const;

private:
  template <typename From>
  bool runOn(const From& from, Ticker& ticker);
  template <bool kPlain, typename From>
  bool countFinite(const From& from, Ticker& ticker);
  template <bool kPlain, typename From>
  std::size_t makeKeyBlock(
    const From& from, std::size_t begin, std::size_t end, std::uint64_t* keys) const;
  template <bool kPlain, typename From>
  bool makeKeys(const From& from, Ticker& ticker);
  template <bool kPlain, typename From>
  bool makeRecords(const From& from, Ticker& ticker);
  template <bool kPlain, typename From>
  bool wanted(const From& from, std::size_t i) const;
  bool makePlaces(Ticker& ticker);

  std::size_t bucketOf(std::uint64_t key) const { return key >> 1 >> (63 - bits_); }
  Index* place(std::size_t task) const { return place_ + task * row_; }

  const PointView& points_;
  Grid grid_;
  bool plain_; ///< all points are finite and none is skipped
  unsigned bits_;
  std::size_t tasks_;
  std::size_t row_;                   ///< counters per task, whole cache lines
  std::vector<Index> begin_;          ///< of each bucket
  std::vector<std::size_t> firstKey_; ///< of each task
  Record* records_ = nullptr;
  std::uint64_t* keys_ = nullptr;
  Index* place_ = nullptr; ///< for each task, where its next record of each bucket goes
};

} // namespace ahd

#endif
