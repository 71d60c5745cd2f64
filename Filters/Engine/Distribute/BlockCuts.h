// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockCuts_h
#define ahd_BlockCuts_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Where a row of blocks is cut in two: everything in a tree of blocks is cut there.
inline std::size_t middleBlock(std::size_t begin, std::size_t end)
{
  return begin + (end - begin) / 2;
}

/// The plane, cut into half-open boxes, one for each block: a kd-tree. Which block owns a point is
/// a function of its x and y, the same wherever the cuts are the same; so coincident points meet on
/// one block.
class BlockCuts
{
public:
  /// How many blocks; 1 without cuts.
  std::size_t blocks() const { return cuts_.empty() ? 1 : cuts_.size(); }

  /// The block that owns the point. A coordinate that is NaN counts as a large one.
  std::size_t ownerOf(const Point& p) const
  {
    std::size_t begin = 0, end = blocks();
    while (end - begin > 1)
    {
      const std::size_t middle = middleBlock(begin, end);
      const Cut& cut = cuts_[middle];
      ((cut.isAcrossX ? p.x : p.y) < cut.at ? end : begin) = middle;
    }
    return begin;
  }

private:
  friend class BlockCutter;
  struct Cut
  {
    double at; ///< smaller coordinates belong to the blocks below
    bool isAcrossX;
  };
  std::vector<Cut> cuts_; ///< at the middle of each row of blocks that is cut; the first is unused
};

/// Cuts the plane so that about as many of the samples lie in each block, always across the longer
/// side. The samples of all blocks, in the same order everywhere, give the same cuts everywhere.
/// Cost: n log n + n log(blocks). Returns Ok, Cancelled or OutOfMemory. @pre finite samples,
/// blocks > 0.
Status cutIntoBlocks(
  const std::vector<Point>& samples, std::size_t blocks, const Context& context, BlockCuts& out);

/// `most` finite points, or fewer, evenly by number. Blocks with more points should give more
/// samples, in proportion; some 512 times as many as there are blocks in all are enough. Returns Ok
/// or OutOfMemory.
Status samplePoints(const PointView& points, std::size_t most, std::vector<Point>& out);

} // namespace ahd

#endif
