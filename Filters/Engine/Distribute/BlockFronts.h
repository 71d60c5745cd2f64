// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockFronts_h
#define ahd_BlockFronts_h

#include "BlockBoxes.h"
#include "BlockCuts.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ahd
{

/// A level of the tree: all blocks as successive rows, each worked at by one block, its host. Level
/// 0 are the blocks themselves, the last level is one row. A row of the level above consists of
/// whole rows of this one.
class BlockFront
{
public:
  /// Each block for itself. Throws std::bad_alloc, as all below.
  static BlockFront ofBlocks(std::size_t blocks)
  {
    std::size_t halvings = 0;
    while ((std::size_t(1) << halvings) < blocks)
    {
      ++halvings;
    }
    return BlockFront(blocks, halvings);
  }

  /// Rows of up to 2^halvings of these, as the cuts have it: boxes of the kd-tree. @pre there
  /// is more than one row.
  BlockFront above(std::size_t halvings) const
  {
    return BlockFront(blocks(), halvings_ - std::min(halvings, halvings_));
  }

  /// All blocks as one row, worked at by this one.
  BlockFront gatheredTo(std::size_t host) const
  {
    BlockFront result(blocks(), 0);
    result.host_ = host;
    return result;
  }

  std::size_t blocks() const { return begins_.back(); }
  std::size_t rows() const { return begins_.size() - 1; }
  BlockRow row(std::size_t k) const { return { begins_[k], begins_[k + 1] }; }
  /// The row of a block.
  std::size_t rowOf(std::size_t block) const
  {
    return static_cast<std::size_t>(
      std::upper_bound(begins_.begin(), begins_.end(), block) - begins_.begin() - 1);
  }
  std::size_t hostOf(std::size_t k) const { return rows() == 1 ? host_ : begins_[k]; }
  /// The row that this block works at; rows() if it works at none.
  std::size_t rowHostedBy(std::size_t block) const
  {
    const std::size_t k = rows() == 1 ? 0 : rowOf(block);
    return hostOf(k) == block ? k : rows();
  }

private:
  BlockFront(std::size_t blocks, std::size_t halvings)
    : begins_{ 0, blocks }
    , halvings_(halvings)
  {
    for (std::size_t k = 0; k != halvings; ++k)
    {
      std::vector<std::size_t> halved;
      for (std::size_t i = 0; i + 1 != begins_.size(); ++i)
      {
        const std::size_t middle = middleBlock(begins_[i], begins_[i + 1]);
        halved.push_back(begins_[i]);
        if (middle != begins_[i])
        {
          halved.push_back(middle);
        }
      }
      halved.push_back(blocks);
      begins_.swap(halved);
    }
  }

  std::vector<std::size_t> begins_; ///< of each row, and where the last one ends
  std::size_t halvings_;
  std::size_t host_ = 0;
};

} // namespace ahd

#endif
