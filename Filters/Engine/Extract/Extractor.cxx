// SPDX-License-Identifier: BSD-3-Clause
#include "Extractor.h"

#include "../Chunks.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// The corners of a triangle, from its lowest on, counterclockwise.
struct FromLowest
{
  std::uint32_t v0, v1, v2;
};

/// Without branches: which corner is the lowest is as good as random.
FromLowest fromLowest(const std::uint32_t* corners)
{
  const unsigned secondOfTwo = corners[1] < corners[0];
  const unsigned third = corners[2] < corners[secondOfTwo];
  const unsigned lowest = secondOfTwo + third * (2 - secondOfTwo);
  constexpr unsigned kNext[3] = { 1, 2, 0 };
  constexpr unsigned kPrevious[3] = { 2, 0, 1 };
  return { corners[lowest], corners[kNext[lowest]], corners[kPrevious[lowest]] };
}

bool hasCorner(const std::uint32_t* corners, std::uint32_t vertex)
{
  return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
}

/// Calls visit(slot, corners from the lowest on) for every finite triangle.
template <typename Visit>
bool forEachFinite(const Mesh& mesh, Ticker& ticker, Visit visit)
{
  const std::uint32_t* const data = mesh.data();
  const std::uint32_t ghost = mesh.ghost();
  return inChunks(0, mesh.end() / Mesh::kSlotSize, ticker,
    [=](std::size_t a, std::size_t b)
    {
      for (std::size_t slot = a * Mesh::kSlotSize; slot != b * Mesh::kSlotSize;
           slot += Mesh::kSlotSize)
      {
        if (!hasCorner(data + slot, ghost))
        {
          visit(static_cast<Mesh::Slot>(slot), fromLowest(data + slot));
        }
      }
    });
}

/// For each vertex, where the next triangle that has it at a certain corner is to be put.
class Places
{
public:
  Places(std::uint32_t vertices, void* memory)
  {
    next_.view(memory, vertices);
    std::fill(next_.begin(), next_.end(), 0u);
  }
  void count(std::uint32_t vertex) { ++next_[vertex]; }
  std::size_t take(std::uint32_t vertex) { return next_[vertex]++; }

  /// Turns counts into first places.
  bool sumUp(Ticker& ticker)
  {
    std::uint32_t sum = 0;
    return inChunks(0, next_.size(), ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i != b; ++i)
        {
          const std::uint32_t n = next_[i];
          next_[i] = sum;
          sum += n;
        }
      });
  }

private:
  Buffer<std::uint32_t> next_;
};

/// The slots of the finite triangles, sorted by second corner; counts their lowest corners.
bool sortBySecond(
  const Mesh& mesh, Buffer<Mesh::Slot>& sorted, Places& byLowest, Places& bySecond, Ticker& ticker)
{
  const auto count = [&](Mesh::Slot, const FromLowest& t)
  {
    byLowest.count(t.v0);
    bySecond.count(t.v1);
  };
  const auto put = [&](Mesh::Slot slot, const FromLowest& t)
  { sorted[bySecond.take(t.v1)] = slot; };
  return forEachFinite(mesh, ticker, count) && bySecond.sumUp(ticker) &&
    forEachFinite(mesh, ticker, put);
}

} // namespace

std::size_t countHullVertices(const Mesh& mesh, Ticker& ticker)
{
  const std::uint32_t* data = mesh.data();
  Mesh::Halfedge start = 0;
  while (data[start] != mesh.ghost())
  {
    // Corner after corner, over the unused fourth to eighth number of a slot.
    start += (start & 3u) == 2 ? Mesh::kSlotSize - 2 : 1;
    if (!ticker.step())
    {
      return 0;
    }
  }
  std::size_t count = 0;
  Mesh::Halfedge h = start;
  do
  {
    // h's apex is the ghost; turn around it into the next ghost triangle.
    h = Mesh::next(data[Mesh::next(h) + Mesh::kTwin]);
    ++count;
    if (!ticker.step())
    {
      return 0;
    }
  } while (h != start);
  return count;
}

// Two stable counting sorts, by the second corner and then by the lowest; the third follows from
// them. Nothing in it branches on the data, and no fan of triangles is too large.
template <typename Id>
bool writeCanonical(const Mesh& mesh, std::size_t triangleCount, const std::uint32_t* ids,
  Id* triples, Scratch& scratch, Ticker& ticker)
{
  constexpr std::size_t kAhead = 16; // triangles; their slots lie anywhere in the cache's reach
  const std::size_t n = mesh.ghost();
  std::uint32_t* const memory = static_cast<std::uint32_t*>(static_cast<void*>(scratch.data()));
  Places byLowest(mesh.ghost(), memory);
  Places bySecond(mesh.ghost(), memory + n);
  Buffer<Mesh::Slot> sorted;
  sorted.view(memory + 2 * n, triangleCount);
  if (!sortBySecond(mesh, sorted, byLowest, bySecond, ticker) || !byLowest.sumUp(ticker))
  {
    return false;
  }
  const std::uint32_t* const data = mesh.data();
  return inChunks(0, triangleCount, ticker,
    [&, ids, triples, data](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        prefetchForRead(data + sorted[i + kAhead < triangleCount ? i + kAhead : i]);
        const FromLowest t = fromLowest(data + sorted[i]);
        Id* const out = triples + 3 * byLowest.take(t.v0);
        out[0] = Id(ids[t.v0]);
        out[1] = Id(ids[t.v1]);
        out[2] = Id(ids[t.v2]);
      }
      ticker.finished(b - a);
    });
}

template bool writeCanonical(
  const Mesh&, std::size_t, const std::uint32_t*, std::int32_t*, Scratch&, Ticker&);
template bool writeCanonical(
  const Mesh&, std::size_t, const std::uint32_t*, std::int64_t*, Scratch&, Ticker&);

} // namespace ahd
