// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockRoute_h
#define ahd_BlockRoute_h

#include "../Core/Chunks.h"
#include "BlockCuts.h"
#include "BlockStars.h"
#include "Steps.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

namespace ahd
{

/// A transport by which two blocks can swap bytes, too.
class PairTransport : public BlockTransport
{
public:
  /// Called by both blocks, with the same sizes; 0: nothing is sent.
  /// @pre the partner is another block.
  virtual void swap(
    std::size_t partner, const void* out, std::size_t outBytes, void* in, std::size_t inBytes) = 0;
};

/// The partner of a block in a round: partners are mutual, and in as many rounds as there are
/// blocks each meets each, itself included.
inline std::size_t partnerOf(std::size_t block, std::size_t blocks, std::size_t round)
{
  return (round + blocks - block) % blocks;
}

/// The routes of tuples: the block that each one goes to, and the places of those that arrive. Any
/// number of arrays can be moved along it. Collective functions return Ok, Cancelled or
/// OutOfMemory, the same on all blocks.
class BlockRoute
{
public:
  /// Borrows the transport.
  BlockRoute(
    std::size_t block, std::size_t blocks, PairTransport& transport, const Context& context)
    : block_(block)
    , blocks_(blocks)
    , transport_(transport)
    , context_(context)
  {
  }

  /// Points go to their owners; arrivals are put block after block. Collective.
  Status toOwners(const PointView& points, const BlockCuts& cuts);
  /// The same with all tuples, to one block.
  Status toOne(std::size_t count, std::size_t block);
  /// Requests tuples: that of point wanted[k] comes to place k. `names`: the ids of this block's
  /// tuples, ascending. Collective. @pre all are there.
  Status ask(const std::vector<BlockPoint>& wanted, const std::vector<std::int64_t>& names);

  /// The number of arrivals.
  std::size_t count() const { return arrivals_; }
  /// Arrival k, in the order of the blocks, is put at places[k]: a permutation.
  void setPlaces(std::vector<Index>&& places) { places_ = std::move(places); }

  /// Moves tuples of `width` bytes each; that of place 0 goes to `to`. Both may be null where there
  /// are none. Collective, as all below.
  Status move(const void* from, std::size_t width, void* to);

  /// Puts valueOf(i) of each tuple i where it goes; throws nothing.
  template <typename Value, typename ValueOf>
  Status moveValues(const ValueOf& valueOf, Value* to)
  {
    static_assert(IsSolid<Value>::value, "moved as it lies in memory");
    return carry(sizeof(Value), to,
      [&valueOf](const Index* tuples, std::size_t some, unsigned char* bytes)
      {
        for (std::size_t k = 0; k != some; ++k)
        {
          const Value value = valueOf(tuples[k]);
          std::memcpy(bytes + k * sizeof(Value), &value, sizeof(Value));
        }
      });
  }

  /// Moves items of variable size: read(i) returns that of tuple i; put(place, item) stores it.
  /// Both may throw std::bad_alloc. Takes as much memory as is sent and received.
  template <typename Item, typename Read, typename Put>
  Status moveItems(const Read& read, const Put& put)
  {
    std::vector<BlockMessage> out, in;
    Steps steps(transport_, context_);
    steps.each(
      [&](Ticker& ticker)
      {
        return eachBlock(
          [&](std::size_t block)
          {
            const Tuples& tuples = out_[block];
            out.push_back({ block, {} });
            BytesWriter writer(out.back().bytes);
            return inSteps(
              0, tuples.size(), ticker, [&](std::size_t k) { writer(read(tuples[k])); });
          });
      });
    steps.exchange(out, in);
    steps.each(
      [&](Ticker& ticker)
      {
        return std::all_of(in.begin(), in.end(),
          [&](const BlockMessage& message)
          {
            BytesReader reader(message.bytes);
            const std::size_t first = firstOf_[message.block];
            return inSteps(0, countFrom(message.block), ticker,
              [&](std::size_t k)
              {
                Item item;
                reader(item);
                put(placeOf(first + k), item);
              });
          });
      });
    return steps.status();
  }

  /// Upper estimate of the bytes for the routes of so many tuples, and for moving them, except by
  /// moveItems().
  static std::size_t memoryEstimate(std::size_t count)
  {
    return 2 * kPiece + (sizeof(Index) + sizeof(std::uint32_t)) * count;
  }

private:
  using Tuples = std::vector<Index>;
  /// Writes the tuples of these numbers, one after the other.
  using Pack = std::function<void(const Index*, std::size_t, unsigned char*)>;
  /// Tuples move in pieces of so many bytes: they stay in the cache between packing and sending,
  /// and a block holds two of them.
  static constexpr std::size_t kPiece = std::size_t(1) << 21;

  /// Calls work(block) for all of them, until it returns false: then this does.
  template <typename Work>
  bool eachBlock(const Work& work) const
  {
    std::size_t block = 0;
    while (block != blocks_ && work(block))
    {
      ++block;
    }
    return block == blocks_;
  }
  template <typename Owner>
  Status toOwnersOf(std::size_t count, const Owner& owner);
  Status tellCounts();
  std::size_t countFrom(std::size_t block) const;
  std::size_t placeOf(std::size_t arrival) const
  {
    return places_.empty() ? arrival : std::size_t(places_[arrival]);
  }
  Status carry(std::size_t width, void* to, const Pack& pack);

  const std::size_t block_, blocks_;
  PairTransport& transport_;
  const Context context_;
  std::vector<Tuples> out_;          ///< of each block, ascending
  std::vector<std::size_t> firstOf_; ///< of each block, the first of its arrivals
  std::vector<Index> places_;        ///< of arrivals; empty: k is put at k
  std::size_t arrivals_ = 0;
};

} // namespace ahd

#endif
