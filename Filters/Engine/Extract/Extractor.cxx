// SPDX-License-Identifier: BSD-3-Clause
#include "Extractor.h"

#include "../Core/Tasks.h"
#include "SortKeys.h"
#include "TriangleKeys.h"

#include <algorithm>

namespace ahd
{

namespace
{

using Key = TriangleKeys::Key;

/// Calls visit(corners) for every triangle of a share of the slots that is not to be left out,
/// ghosts included.
template <typename Visit>
bool forEachTriangle(const ExtractedMesh& from, const Share& slots, Ticker& ticker, Visit visit)
{
  const std::uint32_t* const data = from.mesh.data();
  return inChunks(slots.begin, slots.end, ticker,
    [=, marks = from.marks, leaveOut = from.leaveOut](std::size_t a, std::size_t b)
    {
      if (!marks)
      {
        for (std::size_t slot = a; slot != b; ++slot)
        {
          visit(data + slot * Mesh::kSlotSize);
        }
        return;
      }
      for (std::size_t slot = a; slot != b; ++slot)
      {
        if ((marks[slot] & leaveOut) == 0)
        {
          visit(data + slot * Mesh::kSlotSize);
        }
      }
    });
}

std::size_t slotsOf(const Mesh& mesh)
{
  return mesh.end() / Mesh::kSlotSize;
}

/// Scatters the keys of all triangles to the blocks of their lowest corners, in shares of the slots
/// that run in parallel; then each block can be sorted by itself, in the cache.
class BlocksOfKeys
{
public:
  /// Throws std::bad_alloc. REQUIRES: room for a key per slot at `memory`.
  BlocksOfKeys(const ExtractedMesh& from, std::size_t tasks, void* memory)
    : from_(from)
    , layout_(from.mesh)
    , tasks_(tasks)
    , keys_(static_cast<Key*>(memory))
  {
    begins_.allocate(layout_.blocks() + 1);
    places_.allocate(tasks * layout_.blocks());
  }

  bool fill(Ticker& ticker) { return count(ticker) && sumUp(ticker) && scatter(ticker); }

  const TriangleKeys& layout() const { return layout_; }
  /// The blocks without that of the ghost: of these no triangle has the ghost as a corner.
  std::size_t finiteBlocks() const { return layout_.blocks() - 1; }
  /// Where the keys of a block begin: so many triangles come before it.
  std::size_t begin(std::size_t block) const { return begins_[block]; }
  Key* keys(std::size_t block) { return keys_ + begins_[block]; }

private:
  bool count(Ticker& ticker)
  {
    return eachShare(ticker,
      [this](const Share& share, std::uint32_t* places, Ticker& own)
      {
        std::fill_n(places, layout_.blocks(), 0u);
        return forEachTriangle(from_, share, own,
          [layout = layout_, places](const std::uint32_t* corners)
          { ++places[layout.blockOf(corners)]; });
      });
  }

  /// Turns the counts into first places, block after block and in each task after task.
  bool sumUp(Ticker& ticker)
  {
    const std::size_t blocks = layout_.blocks();
    std::uint32_t sum = 0;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      begins_[block] = sum;
      for (std::size_t task = 0; task < tasks_; ++task)
      {
        std::uint32_t& place = places_[task * blocks + block];
        const std::uint32_t n = place;
        place = sum;
        sum += n;
      }
      if (!ticker.step(std::min(tasks_, kChunk)))
      {
        return false;
      }
    }
    begins_[blocks] = sum;
    return true;
  }

  bool scatter(Ticker& ticker)
  {
    return eachShare(ticker,
      [this](const Share& share, std::uint32_t* places, Ticker& own)
      {
        return forEachTriangle(from_, share, own,
          [layout = layout_, places, keys = keys_](const std::uint32_t* corners)
          {
            const auto blockAndKey = layout(corners);
            keys[places[blockAndKey.first]++] = blockAndKey.second;
          });
      });
  }

  template <typename Work>
  bool eachShare(Ticker& ticker, Work work)
  {
    return inParallel(ticker, tasks_,
      [&](std::size_t task, Ticker& own)
      {
        return work(
          Share(slotsOf(from_.mesh), task, tasks_), places_.data() + task * layout_.blocks(), own);
      });
  }

  ExtractedMesh from_;
  TriangleKeys layout_;
  std::size_t tasks_;
  Key* keys_;
  Buffer<std::uint32_t> begins_; ///< of each block, and where the last one ends
  Buffer<std::uint32_t> places_; ///< for each task, where its next key of each block is to be put
};

/// Writes the triangles of one block from its sorted keys.
template <typename Id>
class BlockWriter
{
public:
  BlockWriter(const TriangleKeys& layout, const std::uint32_t* ids, Id* triples)
    : layout_(layout)
    , ids_(ids)
    , triples_(triples)
  {
  }

  bool write(BlocksOfKeys& blocks, std::size_t block, SmallBlockSorter& sorter, Ticker& ticker)
  {
    const std::size_t begin = blocks.begin(block);
    const std::size_t count = blocks.begin(block + 1) - begin;
    const Key* sorted = blocks.keys(block);
    if (count <= SmallBlockSorter::kMostKeys)
    {
      sorted = sorter.sorted(sorted, count);
    }
    else if (!sortManyKeys(blocks.keys(block), count, layout_.bits(), ticker))
    {
      return false;
    }
    return inChunks(0, count, ticker,
      [&](std::size_t a, std::size_t b)
      {
        Id* const out = triples_ + 3 * (begin + a);
        if (const std::uint32_t* const ids = ids_)
        {
          writeTriples(sorted + a, b - a, block, out, [ids](std::size_t v) { return Id(ids[v]); });
        }
        else
        {
          writeTriples(sorted + a, b - a, block, out, [](std::size_t v) { return Id(v); });
        }
        ticker.finished(b - a);
      });
  }

private:
  /// Writes each corner as nameOf(its vertex).
  template <typename NameOf>
  void writeTriples(
    const Key* sorted, std::size_t count, std::size_t block, Id* out, NameOf nameOf) const
  {
    const TriangleKeys layout = layout_;
    const std::size_t offset = layout.offset();
    const std::size_t first = block * layout.blockSize() - offset; // modulo 2^64
    for (const Key* key = sorted; key != sorted + count; ++key, out += 3)
    {
      out[0] = nameOf(first + layout.placeInBlock(*key));
      out[1] = nameOf(layout.second(*key) - offset);
      out[2] = nameOf(layout.third(*key) - offset);
    }
  }

  TriangleKeys layout_;
  const std::uint32_t* ids_;
  Id* triples_;
};

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

template <typename Id>
bool writeCanonical(const ExtractedMesh& from, const std::uint32_t* ids, Id* triples,
  Scratch& scratch, Ticker& ticker)
{
  constexpr std::size_t kSharesPerThread = 8; // as blocks take unequal time
  const std::size_t threads = threadsOf(ticker);
  BlocksOfKeys blocks(from, tasksFor(threads, slotsOf(from.mesh), 1, kChunk), scratch.data());
  if (!blocks.fill(ticker))
  {
    return false;
  }
  const std::size_t shares = threads == 1
    ? 1
    : std::min(kSharesPerThread * threads, blocks.finiteBlocks());
  return inParallel(ticker, shares,
    [&](std::size_t task, Ticker& own)
    {
      SmallBlockSorter sorter(blocks.layout());
      BlockWriter<Id> writer(blocks.layout(), ids, triples);
      const Share share(blocks.finiteBlocks(), task, shares);
      for (std::size_t block = share.begin; block != share.end; ++block)
      {
        if (!writer.write(blocks, block, sorter, own))
        {
          return false;
        }
      }
      return true;
    });
}

template bool writeCanonical(
  const ExtractedMesh&, const std::uint32_t*, std::uint32_t*, Scratch&, Ticker&);
template bool writeCanonical(const ExtractedMesh&, const std::uint32_t*, int*, Scratch&, Ticker&);
template bool writeCanonical(const ExtractedMesh&, const std::uint32_t*, long*, Scratch&, Ticker&);
template bool writeCanonical(
  const ExtractedMesh&, const std::uint32_t*, long long*, Scratch&, Ticker&);

} // namespace ahd
