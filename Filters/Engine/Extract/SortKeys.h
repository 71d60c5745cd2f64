// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SortKeys_h
#define ahd_SortKeys_h

#include "../Core/Buffer.h"
#include "../Core/Chunks.h"
#include "TriangleKeys.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace ahd
{

constexpr std::size_t kKeysPerLine = 64 / sizeof(TriangleKeys::Key); ///< in a cache line

/// Keys that lie next to each other.
struct KeyPiece
{
  const TriangleKeys::Key* keys;
  std::size_t count;
};

/// Sorts the keys of blocks that fit into a cache.
class SmallBlockSorter
{
public:
  using Key = TriangleKeys::Key;

  static constexpr std::size_t kMostKeys = 4096; ///< a block of 1024 vertices has 2048 on average

  /// Throws std::bad_alloc.
  explicit SmallBlockSorter(const TriangleKeys& keys)
    : keys_(keys)
  {
    ends_.allocate(keys.blockSize());
    placed_.allocate(kMostKeys + kWindow);
    sorted_.allocate(kMostKeys + kWindow);
  }

  /// The keys of one block in ascending order, until the next call. @pre at most kMostKeys.
  const Key* sorted(const std::vector<KeyPiece>& pieces)
  {
    if (pieces.size() == 1 && pieces[0].count <= kFewKeys)
    {
      Key* const end = std::copy_n(pieces[0].keys, pieces[0].count, sorted_.data());
      std::sort(sorted_.data(), end);
      return sorted_.data();
    }
    place(pieces);
    std::size_t begin = 0;
    for (const std::size_t end : ends_)
    {
      sortFour(placed_.data() + begin, sorted_.data() + begin);
      if (end - begin > 4)
      {
        sortMore(begin, end);
      }
      begin = end;
    }
    return sorted_.data();
  }

private:
  static constexpr std::size_t kFewKeys = 64; ///< sorted before all ends have been looked at
  static constexpr std::size_t kWindow =
    8; ///< keys looked at beyond the first of a vertex, at most

  /// By lowest corner: ends_ tells where the keys of each end.
  void place(const std::vector<KeyPiece>& pieces)
  {
    const TriangleKeys layout = keys_;
    std::uint32_t* const ends = ends_.data();
    Key* const placed = placed_.data();
    std::fill(ends_.begin(), ends_.end(), 0u);
    forEachKey(pieces, [=](Key key) { ++ends[layout.placeInBlock(key)]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& end : ends_)
    {
      sum += std::exchange(end, sum);
    }
    forEachKey(pieces, [=](Key key) { placed[ends[layout.placeInBlock(key)]++] = key; });
    std::fill_n(placed + sum, kWindow, ~Key(0));
  }

  template <typename Visit>
  static void forEachKey(const std::vector<KeyPiece>& pieces, Visit visit)
  {
    for (const KeyPiece& piece : pieces)
    {
      std::for_each(piece.keys, piece.keys + piece.count, visit);
    }
  }

  /// Sorts four keys, however many of them belong to this vertex: most vertices are the lowest
  /// corner of four triangles or fewer, and their number is unpredictable. Those of later vertices
  /// are larger, and are written again when their own turn comes.
  static void sortFour(const Key* in, Key* out)
  {
    Key a = in[0], b = in[1], c = in[2], d = in[3];
    order(a, b);
    order(c, d);
    order(a, c);
    order(b, d);
    order(b, c);
    out[0] = a;
    out[1] = b;
    out[2] = c;
    out[3] = d;
  }

  void sortMore(std::size_t begin, std::size_t end)
  {
    Key* const out = sorted_.data() + begin;
    if (end - begin > kWindow)
    {
      std::copy(placed_.data() + begin, placed_.data() + end, out);
      std::sort(out, out + (end - begin));
      return;
    }
    // Eight keys by the same trick: two sorted fours, merged (Batcher's odd-even merge).
    sortFour(placed_.data() + begin, out);
    sortFour(placed_.data() + begin + 4, out + 4);
    for (const auto& pair : { std::pair{ 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 }, { 2, 4 }, { 3, 5 },
           { 1, 2 }, { 3, 4 }, { 5, 6 } })
    {
      order(out[pair.first], out[pair.second]);
    }
  }
  static void order(Key& a, Key& b)
  {
    const Key low = a < b ? a : b;
    b = a < b ? b : a;
    a = low;
  }

  TriangleKeys keys_;
  Buffer<std::uint32_t> ends_;
  Buffer<Key> placed_;
  Buffer<Key> sorted_;
};

/// Sorts distinct keys that differ in their `bits` lowest bits only, in place, in time linear in
/// their number: by eight bits at a time, the highest first, each key swapped to where it belongs.
/// Returns false if cancelled.
inline bool sortManyKeys(TriangleKeys::Key* keys, std::size_t count, unsigned bits, Ticker& ticker)
{
  if (count <= SmallBlockSorter::kMostKeys)
  {
    std::sort(keys, keys + count);
    return ticker.step(count);
  }
  constexpr std::size_t kDigits = 256;
  const unsigned shift = bits > 8 ? bits - 8 : 0;
  const auto digit = [=](TriangleKeys::Key key) { return std::size_t(key >> shift) % kDigits; };
  std::size_t ends[kDigits] = {};
  const auto countDigits = [&](std::size_t a, std::size_t b)
  { std::for_each(keys + a, keys + b, [&](TriangleKeys::Key key) { ++ends[digit(key)]; }); };
  if (!inChunks(0, count, ticker, countDigits))
  {
    return false;
  }
  std::size_t next[kDigits];
  std::size_t sum = 0;
  for (std::size_t d = 0; d < kDigits; ++d)
  {
    next[d] = sum;
    sum += ends[d];
    ends[d] = sum;
  }
  for (std::size_t d = 0; d < kDigits; ++d)
  {
    while (next[d] != ends[d])
    {
      TriangleKeys::Key& key = keys[next[d]];
      std::swap(key, keys[next[digit(key)]++]);
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  for (std::size_t d = 0, begin = 0; d < kDigits; begin = ends[d++])
  {
    if (ends[d] != begin && !sortManyKeys(keys + begin, ends[d] - begin, shift, ticker))
    {
      return false;
    }
  }
  return true;
}

} // namespace ahd

#endif
