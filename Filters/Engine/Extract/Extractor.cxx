// SPDX-License-Identifier: BSD-3-Clause
#include "Extractor.h"

#include "../Core/Loops.h"
#include "KeyChains.h"
#include "SortKeys.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace ahd
{

namespace
{

using Key = TriangleKeys::Key;

/// Writes the triangles of keys as triples, each corner as ids[its vertex].
template <typename Id>
class TripleSink
{
public:
  TripleSink(const TriangleKeys& layout, const std::uint32_t* ids, Id* triples)
    : layout_(layout)
    , ids_(ids)
    , triples_(triples)
  {
  }

  /// `count` keys of one block, the first of them the key of triangle `first`.
  void write(const Key* sorted, std::size_t count, std::size_t block, std::size_t first) const
  {
    Id* const out = triples_ + 3 * first;
    if (const std::uint32_t* const ids = ids_)
    {
      write(sorted, count, block, out, [ids](std::size_t v) { return Id(ids[v]); });
    }
    else
    {
      write(sorted, count, block, out, [](std::size_t v) { return Id(v); });
    }
  }

  /// Where the keys of so many triangles can be sorted: in the room that these will take, at its
  /// end. A triangle has at least half as many bytes more than a key, so none is overwritten before
  /// it has been read.
  Key* room(std::size_t first, std::size_t count)
  {
    static_assert(6 * sizeof(Id) >= 3 * sizeof(Key), "room for the keys");
    const std::uintptr_t end = reinterpret_cast<std::uintptr_t>(triples_ + 3 * (first + count));
    return reinterpret_cast<Key*>(end - end % alignof(Key)) - count;
  }

private:
  static constexpr std::size_t kTriplesAhead = 32;

  /// Writes each corner as nameOf(its vertex).
  template <typename NameOf>
  void write(const Key* sorted, std::size_t count, std::size_t block, Id* out, NameOf nameOf) const
  {
    const TriangleKeys layout = layout_;
    const std::size_t offset = layout.offset();
    const std::size_t first = block * layout.blockSize() - offset; // modulo 2^64
    for (const Key* key = sorted; key != sorted + count; ++key, out += 3)
    {
      prefetchForWrite(out + 3 * kTriplesAhead);
      out[0] = nameOf(first + layout.placeInBlock(*key));
      out[1] = nameOf(layout.second(*key) - offset);
      out[2] = nameOf(layout.third(*key) - offset);
    }
  }

  TriangleKeys layout_;
  const std::uint32_t* ids_;
  Id* triples_;
};

/// Writes the numbers of triangles where their slots say, to the places of their lowest corners.
class NumberSink
{
public:
  NumberSink(const TriangleKeys& layout, std::uint32_t* numbers)
    : layout_(layout)
    , numbers_(numbers)
  {
  }

  /// See TripleSink.
  void write(const Key* sorted, std::size_t count, std::size_t, std::size_t first) const
  {
    const TriangleKeys layout = layout_;
    for (std::size_t i = 0; i < count; ++i)
    {
      numbers_[layout.third(sorted[i])] |= static_cast<std::uint32_t>((first + i) << 2);
    }
  }

  /// Throws std::bad_alloc.
  Key* room(std::size_t, std::size_t count)
  {
    room_.allocate(count);
    return room_.data();
  }

private:
  TriangleKeys layout_;
  std::uint32_t* numbers_;
  Buffer<Key> room_;
};

/// Writes the triangles of one block from its sorted keys.
template <typename Sink>
class BlockWriter
{
public:
  BlockWriter(const TriangleKeys& layout, Sink sink)
    : layout_(layout)
    , sink_(std::move(sink))
  {
  }

  /// Throws std::bad_alloc.
  bool write(const KeyChains& chains, std::size_t block, SmallBlockSorter& sorter, Ticker& ticker)
  {
    const std::size_t count = chains.count(block);
    const std::size_t first = chains.begin(block);
    if (count > SmallBlockSorter::kMostKeys)
    {
      return writeMany(chains, block, ticker);
    }
    if (block != listed_)
    {
      list(chains, block);
    }
    const Key* const sorted = sorter.sorted(pieces_);
    list(chains, block + 1); // read while this block is written
    for (std::size_t i = 0; i < count; i += KeyChains::kKeysPerPiece)
    {
      fetch(i / KeyChains::kKeysPerPiece);
      const std::size_t n = std::min(count - i, KeyChains::kKeysPerPiece);
      sink_.write(sorted + i, n, block, first + i);
    }
    ticker.finished(count);
    return ticker.step(count);
  }

private:
  static constexpr std::size_t kCopied = 256; ///< keys at a time

  /// Lists the pieces of a block if it is sorted in one pass.
  void list(const KeyChains& chains, std::size_t block)
  {
    pieces_.clear();
    listed_ = block;
    if (block < chains.finiteBlocks() && chains.count(block) <= SmallBlockSorter::kMostKeys)
    {
      chains.forEachPiece(block,
        [this](const KeyPiece& piece)
        {
          pieces_.push_back(piece);
          return true;
        });
    }
  }

  /// The k-th piece listed will be read.
  void fetch(std::size_t k) const
  {
    for (std::size_t i = 0; k < pieces_.size() && i < pieces_[k].count; i += kKeysPerLine)
    {
      prefetchForRead(pieces_[k].keys + i);
    }
  }

  bool writeMany(const KeyChains& chains, std::size_t block, Ticker& ticker)
  {
    const std::size_t count = chains.count(block);
    const std::size_t first = chains.begin(block);
    Key* const keys = sink_.room(first, count);
    Key* to = keys;
    const auto copy = [&](const KeyPiece& piece)
    {
      to = std::copy_n(piece.keys, piece.count, to);
      return ticker.step(piece.count);
    };
    if (!chains.forEachPiece(block, copy) || !sortManyKeys(keys, count, layout_.bits(), ticker))
    {
      return false;
    }
    Key some[kCopied];
    for (std::size_t i = 0; i < count; i += kCopied)
    {
      const std::size_t n = std::min(kCopied, count - i);
      std::memcpy(some, static_cast<const void*>(keys + i), n * sizeof(Key));
      sink_.write(some, n, block, first + i);
      ticker.finished(n);
      if (!ticker.step(n))
      {
        return false;
      }
    }
    return true;
  }

  TriangleKeys layout_;
  Sink sink_;
  std::vector<KeyPiece> pieces_;
  std::size_t listed_ = std::size_t(-1); ///< the block that they belong to
};

/// Ghosts have no number: all of them are in the last block.
bool forgetGhosts(const KeyChains& chains, std::uint32_t* numbers, Ticker& ticker)
{
  return chains.forEachPiece(chains.finiteBlocks(),
    [&](const KeyPiece& piece)
    {
      for (std::size_t i = 0; i != piece.count; ++i)
      {
        numbers[chains.layout().third(piece.keys[i])] = kNotExtracted;
      }
      return ticker.step(piece.count);
    });
}

/// Writes the triangles in canonical order into makeSink(layout of the keys), one for each task.
/// `places`: see KeyChains.
template <typename MakeSink>
bool writeInOrder(const ExtractedMesh& from, std::uint32_t* places, Scratch& scratch,
  Ticker& ticker, MakeSink makeSink)
{
  constexpr std::size_t kSharesPerThread = 8; // as blocks take unequal time
  const std::size_t threads = threadsOf(ticker);
  KeyChains chains(from, places, threads, scratch);
  if (!chains.fill(ticker) || !(!places || forgetGhosts(chains, places, ticker)))
  {
    return false;
  }
  const std::size_t shares = threads == 1
    ? 1
    : std::min(kSharesPerThread * threads, chains.finiteBlocks());
  return inParallel(ticker, shares,
    [&](std::size_t task, Ticker& own)
    {
      SmallBlockSorter sorter(chains.layout());
      BlockWriter<decltype(makeSink(chains.layout()))> writer(
        chains.layout(), makeSink(chains.layout()));
      const Share share(chains.finiteBlocks(), task, shares);
      for (std::size_t block = share.begin; block != share.end; ++block)
      {
        if (!writer.write(chains, block, sorter, own))
        {
          return false;
        }
      }
      return true;
    });
}

/// The number of vertices on the hull, by a walk along it with a cache miss at each; gives up above
/// `most`. 0: cancelled.
std::size_t walkAlongHull(const Mesh& mesh, std::size_t most, Ticker& ticker)
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
  } while (h != start && count <= most);
  return count;
}

struct Ghosts
{
  std::size_t count = 0;
  void merge(const Ghosts& other) { count += other.count; }
};

/// The triangles that have the ghost as a corner: each edge of the hull has one. 0: cancelled.
std::size_t countGhosts(const Mesh& mesh, Ticker& ticker)
{
  Ghosts ghosts;
  const std::uint32_t ghost = mesh.ghost();
  const std::uint32_t* const data = mesh.data();
  const bool done = gather(mesh.end() / Mesh::kSlotSize, ticker, ghosts,
    [=](Ghosts& some, std::size_t a, std::size_t b)
    {
      for (const std::uint32_t* t = data + a * Mesh::kSlotSize; t != data + b * Mesh::kSlotSize;
           t += Mesh::kSlotSize)
      {
        some.count += ((t[0] == ghost) | (t[1] == ghost) | (t[2] == ghost)) ? 1u : 0u;
      }
    });
  return done ? ghosts.count : 0;
}

} // namespace

std::size_t countHullVertices(const Mesh& mesh, Ticker& ticker)
{
  // A step along the hull takes as long as passing over 16 triangles: the walk is given up early
  // enough to cost a quarter of that.
  const std::size_t most = mesh.end() / Mesh::kSlotSize / 64;
  const std::size_t count = walkAlongHull(mesh, most, ticker);
  return count <= most ? count : countGhosts(mesh, ticker);
}

template <typename Id>
bool writeCanonical(const ExtractedMesh& from, const std::uint32_t* ids, Id* triples,
  Scratch& scratch, Ticker& ticker)
{
  return writeInOrder(from, nullptr, scratch, ticker,
    [=](const TriangleKeys& layout) { return TripleSink<Id>(layout, ids, triples); });
}

bool numberCanonical(const Mesh& mesh, std::uint32_t* numbers, Scratch& scratch, Ticker& ticker)
{
  return writeInOrder(mesh, numbers, scratch, ticker,
    [=](const TriangleKeys& layout) { return NumberSink(layout, numbers); });
}

template bool writeCanonical(
  const ExtractedMesh&, const std::uint32_t*, std::uint32_t*, Scratch&, Ticker&);
template bool writeCanonical(const ExtractedMesh&, const std::uint32_t*, int*, Scratch&, Ticker&);
template bool writeCanonical(const ExtractedMesh&, const std::uint32_t*, long*, Scratch&, Ticker&);
template bool writeCanonical(
  const ExtractedMesh&, const std::uint32_t*, long long*, Scratch&, Ticker&);

} // namespace ahd
