// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_EdgeTable_h
#define ahd_EdgeTable_h

#include "../Core/AskedMemory.h"
#include "../Core/Buffer.h"
#include "../Core/Chunks.h"
#include "../Points/Points.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// A number for each of some edges, by its two vertices. A hash table, open addressing. Requests
/// its memory (Progress::take()) unless it is small.
template <typename Value>
class EdgeTable
{
public:
  struct Edge
  {
    std::uint64_t key;
    Value value;
  };

  /// The same for both directions.
  static std::uint64_t keyOf(Index u, Index v)
  {
    return std::uint64_t(std::min(u, v)) << 32 | std::max(u, v);
  }

  explicit EdgeTable(Ticker& ticker)
    : ticker_(ticker)
    , taken_(ticker)
  {
  }

  /// Makes room for so many edges; must be called before add() and find(). Returns false if
  /// cancelled. Throws std::bad_alloc.
  bool begin(std::size_t expected) { return allocate(roomFor(expected)); }

  /// The number of the edge between two vertices; a new edge gets `value`. Null if cancelled: then
  /// the table is unusable. Throws std::bad_alloc.
  Value* add(Index u, Index v, Value value)
  {
    if (2 * (count_ + 1) > edges_.size() && !grow())
    {
      return nullptr;
    }
    Edge& edge = *place(keyOf(u, v));
    if (edge.key == kFree)
    {
      edge = Edge{ keyOf(u, v), value };
      ++count_;
    }
    return &edge.value;
  }

  /// Prefetches for find() or add().
  void prefetch(Index u, Index v) const
  {
    prefetchForRead(edges_.data() + firstPlace(keyOf(u, v)));
  }

  /// Null if there is none.
  const Value* find(Index u, Index v) const
  {
    const Edge* const edge = const_cast<EdgeTable*>(this)->place(keyOf(u, v));
    return edge->key == kFree ? nullptr : &edge->value;
  }

private:
  static constexpr std::uint64_t kFree = ~std::uint64_t(0); // of no edge: u < v

  static std::size_t roomFor(std::size_t edges)
  {
    std::size_t room = 64;
    while (room < 2 * edges + 2)
    {
      room *= 2;
    }
    return room;
  }

  /// `old`: the bytes of the old table, still held.
  bool allocate(std::size_t room, std::size_t old = 0)
  {
    constexpr std::size_t kFew = 1024;
    if (room > kFew)
    {
      taken_.atLeast(room * sizeof(Edge) + old);
    }
    edges_.allocate(room);
    shift_ = 64;
    for (std::size_t size = room; size > 1; size /= 2)
    {
      --shift_;
    }
    return fillAll(edges_, Edge{ kFree, 0 }, ticker_);
  }

  bool grow()
  {
    Buffer<Edge> old;
    std::swap(old, edges_);
    const auto move = [&](std::size_t a, std::size_t b)
    {
      for (const Edge* edge = old.data() + a; edge != old.data() + b; ++edge)
      {
        if (edge->key != kFree)
        {
          *place(edge->key) = *edge;
        }
      }
    };
    const bool all = allocate(2 * old.size(), old.bytes()) &&
      inChunks(0, old.size(), ticker_, move);
    taken_.atMost(edges_.bytes());
    return all;
  }

  std::size_t firstPlace(std::uint64_t key) const
  {
    return static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> shift_);
  }

  Edge* place(std::uint64_t key)
  {
    std::size_t i = firstPlace(key);
    while (edges_[i].key != key && edges_[i].key != kFree)
    {
      i = i + 1 == edges_.size() ? 0 : i + 1;
    }
    return &edges_[i];
  }

  Ticker& ticker_;
  TakenMemory taken_;
  Buffer<Edge> edges_;
  std::size_t count_ = 0;
  unsigned shift_ = 64;
};

} // namespace ahd

#endif
