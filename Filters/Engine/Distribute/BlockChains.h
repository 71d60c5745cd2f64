// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockChains_h
#define ahd_BlockChains_h

#include "../Prepare/Prepare.h"
#include "BlockTransport.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

class Ticker;

/// The global ids of the points of one block: those of its input and, after all blocks' inputs,
/// those that its source adds.
struct BlockIds
{
  std::size_t given = 0; ///< points of the input
  std::int64_t first = 0, firstAdded = 0;

  /// The global id of a point by its number; -1 for none.
  std::int64_t of(std::int64_t number) const
  {
    const auto own = static_cast<std::int64_t>(given);
    return number < 0 ? -1 : number < own ? first + number : firstAdded + (number - own);
  }
};

/// The constraints of all blocks, as if their sources were appended: open lines, closed lines that
/// are loops, alone or joined across blocks, polygons; of each kind those of block 0 first.
class BlockChains
{
public:
  /// Joins them, in global ids. `prepared`: the result of prepare() for a block's `request`, but
  /// for closedLinesAreLoops, which is for all blocks together. `vertices`: cells of the appended
  /// source before its lines. Collective; returns Ok, Cancelled or OutOfMemory, the same on all
  /// blocks.
  Status join(const InputRequest& request, const PreparedInput& prepared, const BlockIds& ids,
    std::int64_t vertices, BlockTransport& transport, const Context& context);

  ConstraintView view() const;
  /// How many ids they have.
  std::size_t idCount() const { return chains_.ids.size(); }
  bool haveLoops() const { return chains_.cells.size() > chains_.lines; }
  /// The cell of the appended source that a chain is made of.
  std::int64_t cellOf(std::size_t chain) const { return chains_.cells[chain]; }
  /// Counts over all sources.
  const UnfitIds& unfitIds() const { return unfit_; }
  /// Are there lines, and none is closed, though closed ones would be loops?
  bool areLinesUnclosed() const { return areLinesUnclosed_; }

private:
  struct Own;
  bool append(const std::vector<Own>& all, std::int64_t vertices, Ticker& ticker);
  bool close(const std::vector<Own>& all, Ticker& ticker);
  void addUnfit(const Own& own, std::int64_t firstLine, std::int64_t firstPolygon);

  Chains chains_;
  UnfitIds unfit_;
  bool areLinesUnclosed_ = false;
};

} // namespace ahd

#endif
