// SPDX-License-Identifier: BSD-3-Clause
#include "Extractor.h"

#include "../Core/Tasks.h"
#include "KeyChains.h"
#include "SortKeys.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace ahd
{

namespace
{

using Key = TriangleKeys::Key;

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

  /// Throws std::bad_alloc.
  bool write(const KeyChains& chains, std::size_t block, SmallBlockSorter& sorter, Ticker& ticker)
  {
    const std::size_t count = chains.count(block);
    Id* const out = triples_ + 3 * chains.begin(block);
    if (count > SmallBlockSorter::kMostKeys)
    {
      return writeMany(chains, block, out, ticker);
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
      writeTriples(sorted + i, n, block, out + 3 * i);
    }
    ticker.finished(count);
    return ticker.step(count);
  }

private:
  static constexpr std::size_t kCopied = 256; ///< keys at a time
  static constexpr std::size_t kTriplesAhead = 32;

  /// Lists the pieces of a block if it is to be sorted in one go.
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

  /// The keys are sorted in the room that the triangles will take, at its end: a triangle has at
  /// least half as many bytes more than a key, so none is overwritten before it has been read.
  bool writeMany(const KeyChains& chains, std::size_t block, Id* out, Ticker& ticker)
  {
    static_assert(6 * sizeof(Id) >= 3 * sizeof(Key), "room for the keys");
    const std::size_t count = chains.count(block);
    const std::uintptr_t end = reinterpret_cast<std::uintptr_t>(out + 3 * count);
    Key* const keys = reinterpret_cast<Key*>(end - end % alignof(Key)) - count;
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
      writeTriples(some, n, block, out + 3 * i);
      ticker.finished(n);
      if (!ticker.step(n))
      {
        return false;
      }
    }
    return true;
  }

  void writeTriples(const Key* sorted, std::size_t count, std::size_t block, Id* out) const
  {
    if (const std::uint32_t* const ids = ids_)
    {
      writeTriples(sorted, count, block, out, [ids](std::size_t v) { return Id(ids[v]); });
    }
    else
    {
      writeTriples(sorted, count, block, out, [](std::size_t v) { return Id(v); });
    }
  }

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
      prefetchForWrite(out + 3 * kTriplesAhead);
      out[0] = nameOf(first + layout.placeInBlock(*key));
      out[1] = nameOf(layout.second(*key) - offset);
      out[2] = nameOf(layout.third(*key) - offset);
    }
  }

  TriangleKeys layout_;
  const std::uint32_t* ids_;
  Id* triples_;
  std::vector<KeyPiece> pieces_;
  std::size_t listed_ = std::size_t(-1); ///< the block whose they are
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
  KeyChains chains(from, threads, scratch);
  if (!chains.fill(ticker))
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
      BlockWriter<Id> writer(chains.layout(), ids, triples);
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

template bool writeCanonical(
  const ExtractedMesh&, const std::uint32_t*, std::uint32_t*, Scratch&, Ticker&);
template bool writeCanonical(const ExtractedMesh&, const std::uint32_t*, int*, Scratch&, Ticker&);
template bool writeCanonical(const ExtractedMesh&, const std::uint32_t*, long*, Scratch&, Ticker&);
template bool writeCanonical(
  const ExtractedMesh&, const std::uint32_t*, long long*, Scratch&, Ticker&);

} // namespace ahd
