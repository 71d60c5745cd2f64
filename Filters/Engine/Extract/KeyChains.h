// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_KeyChains_h
#define ahd_KeyChains_h

#include "../Core/Buffer.h"
#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "Extractor.h"
#include "SortKeys.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// The place of the lowest corner. Without branches: the outcome is unpredictable.
inline unsigned placeOfLowest(const std::uint32_t* corners)
{
  const unsigned isSecond = corners[1] < corners[0] ? 1u : 0u;
  const unsigned isThird = corners[2] < std::min(corners[0], corners[1]) ? 1u : 0u;
  return (isSecond & (isThird - 1u)) | isThird << 1;
}

/// Distributes the keys of all triangles to the blocks of their lowest corners, in one pass over
/// the mesh; then each block can be sorted by itself, in the cache. How many keys a block gets is
/// not known before, so they wait in chains of pieces: a chain for each block and task, which takes
/// a new piece where its last is full.
///
///     task 0, block 0   [64 keys] <- [64 keys] <- [17 keys]
///     task 0, block 1   [64 keys] <- [3 keys]
class KeyChains
{
public:
  using Key = TriangleKeys::Key;

  static constexpr std::size_t kKeysPerPiece = 64; ///< at most: eight cache lines

  /// With `places` the third number of the keys is the slot, and places[slot] becomes the place of
  /// the lowest corner in each that is not left out. Allocates at most kExtractBytesPerPoint for
  /// each vertex. Throws std::bad_alloc. @pre room for a key per slot in `scratch`.
  KeyChains(const ExtractedMesh& from, std::uint32_t* places, std::size_t threads, Scratch& scratch)
    : from_(from)
    , layout_(from.mesh, places ? TriangleKeys::Third::Slot : TriangleKeys::Third::Corner)
    , places_(places)
    , tasks_(tasksFor(threads, slots(), 1, kChunk))
  {
    // The pieces that a task begins and does not fill take no more than half a key per vertex.
    const std::size_t keysOfTasks = layout_.blockSize() / 2;
    tasks_ = std::min(tasks_, keysOfTasks / kKeysPerLine);
    while (keysPerPiece_ > kKeysPerLine && tasks_ * keysPerPiece_ > keysOfTasks)
    {
      keysPerPiece_ /= 2;
    }
    piecesPerTask_ = (slots() / tasks_ + 1) / keysPerPiece_ + layout_.blocks();
    const std::size_t pieces = tasks_ * piecesPerTask_;
    before_.allocate(pieces);
    chains_.allocate(tasks_ * layout_.blocks());
    begins_.allocate(layout_.blocks() + 1);
    inScratch_ = aligned(scratch.data(), scratch.data() + scratch.size(), keys_);
    const std::size_t more = pieces - std::min(pieces, inScratch_);
    extra_.allocate((more + 1) * bytesPerPiece());
    aligned(extra_.data(), extra_.data() + extra_.size(), extraKeys_);
  }

  /// Returns false if cancelled.
  bool fill(Ticker& ticker)
  {
    std::fill(chains_.begin(), chains_.end(), Chain());
    const auto work = [this](std::size_t task, Ticker& own)
    {
      return layout_.third() == TriangleKeys::Third::Corner
        ? distribute<TriangleKeys::Third::Corner>(task, own)
        : distribute<TriangleKeys::Third::Slot>(task, own);
    };
    return inParallel(ticker, tasks_, work) && sumUp(ticker);
  }

  const TriangleKeys& layout() const { return layout_; }
  /// The number of blocks but the ghost's: their triangles do not have the ghost as a corner.
  std::size_t finiteBlocks() const { return layout_.blocks() - 1; }
  /// How many triangles come before those of a block.
  std::size_t begin(std::size_t block) const { return begins_[block]; }
  std::size_t count(std::size_t block) const { return begins_[block + 1] - begins_[block]; }

  /// Calls visit(piece) for all pieces of a block, in no order, until it returns false. Returns
  /// false then.
  template <typename Visit>
  bool forEachPiece(std::size_t block, Visit visit) const
  {
    for (std::size_t task = 0; task < tasks_; ++task)
    {
      const Chain& chain = chainOf(task, block);
      std::size_t count = lastCount(chain);
      std::uint32_t piece = chain.last;
      for (std::uint32_t k = 0; k < chain.pieces; ++k)
      {
        if (!visit(KeyPiece{ keysOf(piece), count }))
        {
          return false;
        }
        piece = before_[piece];
        count = keysPerPiece_;
      }
    }
    return true;
  }

private:
  struct Chain
  {
    Key* end = nullptr; ///< behind its last key: at the border of a piece, this piece is full
    std::uint32_t last = 0;
    std::uint32_t pieces = 0;
  };

  std::size_t slots() const { return from_.mesh.end() / Mesh::kSlotSize; }
  std::size_t bytesPerPiece() const { return keysPerPiece_ * sizeof(Key); }

  /// The first place for a piece between these addresses; returns for how many there is room.
  std::size_t aligned(unsigned char* begin, unsigned char* end, Key*& first) const
  {
    const std::size_t past = reinterpret_cast<std::uintptr_t>(begin) % bytesPerPiece();
    const std::size_t skipped = past == 0 ? 0 : bytesPerPiece() - past;
    const std::size_t size = static_cast<std::size_t>(end - begin);
    if (size < skipped + bytesPerPiece())
    {
      return 0;
    }
    first = reinterpret_cast<Key*>(begin + skipped);
    return (size - skipped) / bytesPerPiece();
  }

  Key* keysOf(std::size_t piece) const
  {
    return piece < inScratch_ ? keys_ + piece * keysPerPiece_
                              : extraKeys_ + (piece - inScratch_) * keysPerPiece_;
  }
  Chain& chainOf(std::size_t task, std::size_t block)
  {
    return chains_[task * layout_.blocks() + block];
  }
  const Chain& chainOf(std::size_t task, std::size_t block) const
  {
    return chains_[task * layout_.blocks() + block];
  }
  std::size_t lastCount(const Chain& chain) const
  {
    return chain.pieces == 0 ? 0 : static_cast<std::size_t>(chain.end - keysOf(chain.last));
  }

  /// Calls visit(corners, slot) for every triangle of a share of the slots that is not to be left
  /// out, ghosts included.
  template <typename Visit>
  bool forEachTriangle(const Share& share, Ticker& ticker, Visit visit) const
  {
    const std::uint32_t* const data = from_.mesh.data();
    return inChunks(share.begin, share.end, ticker,
      [=, marks = from_.marks, leaveOut = from_.leaveOut](std::size_t a, std::size_t b)
      {
        for (std::size_t slot = a; slot != b; ++slot)
        {
          if (!marks || (marks[slot] & leaveOut) == 0)
          {
            visit(data + slot * Mesh::kSlotSize, slot);
          }
        }
      });
  }

  template <TriangleKeys::Third kThird>
  bool distribute(std::size_t task, Ticker& ticker)
  {
    Chain* const chains = &chainOf(task, 0);
    const std::size_t mask = bytesPerPiece() - 1;
    std::uint32_t fresh = static_cast<std::uint32_t>(task * piecesPerTask_);
    return forEachTriangle(Share(slots(), task, tasks_), ticker,
      [this, layout = layout_, chains, mask, &fresh](const std::uint32_t* corners, std::size_t slot)
      {
        if (kThird == TriangleKeys::Third::Slot)
        {
          places_[slot] = placeOfLowest(corners);
        }
        prefetchForRead(corners + kTrianglesAhead * Mesh::kSlotSize);
        const auto blockAndKey = layout.template blockAndKey<kThird>(corners, slot);
        Chain& chain = chains[blockAndKey.first];
        if ((reinterpret_cast<std::uintptr_t>(chain.end) & mask) == 0)
        {
          takePiece(chain, fresh++);
        }
        *chain.end++ = blockAndKey.second;
      });
  }

  void takePiece(Chain& chain, std::uint32_t piece)
  {
    before_[piece] = chain.last;
    chain.last = piece;
    ++chain.pieces;
    chain.end = keysOf(piece);
    for (std::size_t i = 0; i < keysPerPiece_; i += kKeysPerLine)
    {
      prefetchForWrite(chain.end + i);
    }
  }

  bool sumUp(Ticker& ticker)
  {
    std::uint32_t sum = 0;
    for (std::size_t block = 0; block < layout_.blocks(); ++block)
    {
      begins_[block] = sum;
      for (std::size_t task = 0; task < tasks_; ++task)
      {
        const Chain& chain = chainOf(task, block);
        const std::size_t full = chain.pieces == 0 ? 0 : chain.pieces - 1;
        sum += static_cast<std::uint32_t>(full * keysPerPiece_ + lastCount(chain));
      }
      if (!ticker.step(tasks_))
      {
        return false;
      }
    }
    begins_[layout_.blocks()] = sum;
    return true;
  }

  static constexpr std::size_t kTrianglesAhead = 24;

  ExtractedMesh from_;
  TriangleKeys layout_;
  std::uint32_t* places_;
  std::size_t tasks_;
  std::size_t keysPerPiece_ = kKeysPerPiece; ///< a power of two; fewer where there are many tasks
  /// A task has its pieces side by side: in turns, processors would fetch ahead what others write.
  std::size_t piecesPerTask_ = 0;
  Key* keys_ = nullptr;          ///< the first piece, in the scratch
  std::size_t inScratch_ = 0;    ///< pieces for which there is room there
  Key* extraKeys_ = nullptr;     ///< those for which there is none, in extra_
  Buffer<std::uint32_t> before_; ///< of each piece, the one before it in its chain
  Buffer<Chain> chains_;
  Buffer<unsigned char> extra_;
  Buffer<std::uint32_t> begins_; ///< of each block, and where the last one ends
};

} // namespace ahd

#endif
