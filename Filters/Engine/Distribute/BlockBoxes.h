// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockBoxes_h
#define ahd_BlockBoxes_h

#include "../Core/Progress.h"
#include "../Points/Points.h"
#include "../Predicates/Discs.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// A row of successive blocks.
struct BlockRow
{
  std::size_t begin = 0, end = 0;

  bool has(std::size_t block) const { return begin <= block && block < end; }
};

/// The tight bounds of all blocks' points, and of rows of eight, of 64, ... blocks. Empty bounds
/// where there is no point.
class BlockBoxes
{
public:
  /// `overlap`: by how much, at most, bounds may lie within others that they are apart from but for
  /// that. Throws std::bad_alloc.
  void set(std::vector<Bounds> bounds, double overlap = 0.0);

  std::size_t blocks() const { return levels_.empty() ? 0 : levels_[0].size(); }

  /// Around the points of a row.
  Bounds boundsOf(const BlockRow& row) const;

  /// Does the disc meet the bounds of a block that is not in the row? Exact. `steps` grows by what
  /// it took: about log(blocks).
  bool isMet(const Circumdisc& disc, const BlockRow& row, std::size_t& steps) const;

  /// A box with no point of other blocks' bounds inside; sides with none beyond lie at infinity.
  /// Large, but not the largest. Where `own`, the bounds of the row's points, and those of others
  /// overlap by more than they may it is empty: xmin > xmax.
  Bounds freeBoxOf(const BlockRow& row, const Bounds& own) const;

private:
  static constexpr std::size_t kInRow = 8;
  std::vector<std::vector<Bounds>> levels_; ///< from the blocks' own to one around all
  double overlap_ = 0.0;
};

} // namespace ahd

#endif
