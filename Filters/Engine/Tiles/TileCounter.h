// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TileCounter_h
#define ahd_TileCounter_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "TilePlan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Counts points in boxes of the grid of ranks, in passes over all points, until none with more
/// than a leaf may have can be divided. The outcome is a function of the points alone.
class TileCounter
{
public:
  /// `guess`: of the points' bounds; empty: none. Right, it saves a pass.
  explicit TileCounter(const Bounds& guess);

  /// Returns Ok, Cancelled or OutOfMemory. Cancelled or failed, it may have counted some: begin
  /// anew. Takes 8 MB in all, and 24 bytes for each leaf.
  Status count(const PointView& points, const Context& context);

  enum class Next
  {
    Again,    ///< another pass
    Done,     ///< facts are complete but for extent and lines
    Different ///< this pass had other points than the one before
  };
  /// Ends a pass. `most`: points of a leaf; 1 at least.
  Next endPass(std::uint64_t most, TileFacts& facts);

private:
  /// In the order of the curve.
  struct Box
  {
    TileBox box;
    std::uint64_t count;
    bool isOpen; ///< it will be divided
  };

  /// A box, the levels to what was counted of it, and the points that a leaf may have.
  struct Division
  {
    TileBox box;
    unsigned steps;
    std::uint64_t most;
  };

  void countKeys(const PointView& points, std::size_t begin, std::size_t end);
  void countKey(std::uint64_t key);
  static void divide(const Division& now, const std::uint64_t* counts, std::vector<Box>& out);
  void openBoxes();
  void divideOpen(std::uint64_t most);
  Next listLeaves(TileFacts& facts) const;

  Bounds grid_;                       ///< that keys refer to
  bool isRight_ = true;               ///< as far as is known, these are the points' bounds
  std::vector<Box> boxes_;            ///< empty before the bounds are known
  std::vector<std::uint64_t> opened_; ///< the keys of open boxes
  std::vector<std::uint32_t> levels_; ///< and their levels
  unsigned steps_ = 0;                ///< levels between open boxes and what is counted
  std::vector<std::uint64_t> counts_; ///< of parts of open boxes

  Bounds bounds_; ///< of this pass, as all below
  std::uint64_t points_ = 0, notFinite_ = 0;
  std::uint64_t pointsBefore_ = 0, notFiniteBefore_ = 0;
};

} // namespace ahd

#endif
