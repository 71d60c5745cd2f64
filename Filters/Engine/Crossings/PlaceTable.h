// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlaceTable_h
#define ahd_PlaceTable_h

#include "../Core/Buffer.h"
#include "../Core/Chunks.h"
#include "../Points/Points.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace ahd
{

/// Places that pieces are led through, each once, in the order in which they came. A hash table,
/// open addressing.
class PlaceTable
{
public:
  struct Place
  {
    Point at;
    Index id; ///< of the point there; kNoIndex as long as it is not known
    Index endId,
      pointId;           ///< smallest ids there, of ends of segments and of all points; or kNoIndex
    Index first, second; ///< positions of the first two segments that cross there; or kNoIndex
    Index lower, upper;  ///< and of the first two by their places; or kNoIndex
  };

  explicit PlaceTable(Ticker& ticker)
    : ticker_(ticker)
  {
  }

  Place& operator[](Index k) { return places_[k]; }
  const Place& operator[](Index k) const { return places_[k]; }
  std::size_t size() const { return places_.size(); }

  /// kNoIndex if it is not there.
  Index find(const Point& p) const { return slots_.empty() ? kNoIndex : slots_[slotOf(p)]; }

  /// Prefetches for find() and add().
  void prefetch(const Point& p) const { prefetchForWrite(&slots_[firstSlotOf(p)]); }

  /// Adds the place unless it is there, and sets its number. Returns false if cancelled. Throws
  /// std::bad_alloc.
  bool add(const Point& p, Index& number)
  {
    if (slots_.size() < 2 * (places_.size() + 1) && !reserve(2 * places_.size() + 32))
    {
      return false;
    }
    Index& slot = slots_[slotOf(p)];
    if (slot == kNoIndex)
    {
      places_.push_back(
        { p, kNoIndex, kNoIndex, kNoIndex, kNoIndex, kNoIndex, kNoIndex, kNoIndex });
      slot = static_cast<Index>(places_.size() - 1);
    }
    number = slot;
    return true;
  }

  /// Makes room for so many places, mostly. Returns false if cancelled. Throws
  /// std::bad_alloc.
  bool reserve(std::size_t count)
  {
    if (slots_.size() >= 2 * count && !slots_.empty())
    {
      return true;
    }
    const unsigned bits = bitLength(2 * count | 63);
    shift_ = 64 - bits;
    slots_.allocate(std::size_t(1) << bits);
    const auto put = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        slots_[slotOf(places_[k].at)] = static_cast<Index>(k);
      }
    };
    return fillAll(slots_, kNoIndex, ticker_) && inChunks(0, places_.size(), ticker_, put);
  }

private:
  static std::uint64_t bitsOf(double value)
  {
    const double withoutSign = value + 0.0; // -0.0 is 0.0
    std::uint64_t bits;
    std::memcpy(&bits, &withoutSign, sizeof bits);
    return bits;
  }

  std::size_t firstSlotOf(const Point& p) const
  {
    const std::uint64_t x = bitsOf(p.x) * 0x9E3779B97F4A7C15u;
    const std::uint64_t mixed = ((x ^ x >> 32) + bitsOf(p.y)) * 0xC2B2AE3D27D4EB4Fu;
    const std::uint64_t key = (mixed ^ mixed >> 29) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(key >> shift_);
  }

  std::size_t slotOf(const Point& p) const
  {
    std::size_t slot = firstSlotOf(p);
    while (slots_[slot] != kNoIndex && !(places_[slots_[slot]].at == p))
    {
      slot = slot + 1 == slots_.size() ? 0 : slot + 1;
    }
    return slot;
  }

  Ticker& ticker_;
  std::vector<Place> places_;
  Buffer<Index> slots_;
  unsigned shift_ = 64;
};

} // namespace ahd

#endif
