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
/// are loops, polygons; of each kind those of block 0 first.
class BlockChains
{
public:
  /// Joins them, in global ids. `prepared`: the result of prepare() for a block's `request`.
  /// `vertices`: cells of the appended source before its lines. Collective; returns Ok, Cancelled
  /// or OutOfMemory, the same on all blocks.
  Status join(const InputRequest& request, const PreparedInput& prepared, const BlockIds& ids,
    std::int64_t vertices, BlockTransport& transport, const Context& context);

  ConstraintView view() const;
  /// How many ids they have.
  std::size_t idCount() const { return ids_.size(); }
  bool haveLoops() const { return cells_.size() > lines_; }
  /// The cell of the appended source that a chain is made of.
  std::int64_t cellOf(std::size_t chain) const { return cells_[chain]; }
  /// Counts over all sources.
  const UnfitIds& unfitIds() const { return unfit_; }

private:
  struct Own;
  bool append(const std::vector<Own>& all, std::int64_t vertices, Ticker& ticker);
  void addUnfit(const Own& own, std::int64_t firstLine, std::int64_t firstPolygon);

  std::vector<std::int64_t> ids_, offsets_, cells_;
  std::size_t lines_ = 0;
  UnfitIds unfit_;
};

} // namespace ahd

#endif
