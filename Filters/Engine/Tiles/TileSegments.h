// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TileSegments_h
#define ahd_TileSegments_h

#include "../Core/Progress.h"
#include "../Distribute/SegmentTree.h"
#include "../Points/BoxLevels.h"
#include "TilePlan.h"

#include <vector>

namespace ahd
{

/// The segments of lines and loops that have a length and finite ends, along a Hilbert curve in
/// boxes of boxes: each part finds those beside it, and does not look at all others. 37 bytes each.
class TileSegments
{
public:
  /// Throws std::bad_alloc.
  explicit TileSegments(const TileLines& lines);

  /// Lists those that have a place in the region, exactly. @pre it is not empty. Returns false if
  /// cancelled; throws std::bad_alloc. Looks at as many boxes and segments as there are levels, and
  /// a few for each segment whose box meets the region.
  bool listIn(const Bounds& region, std::vector<EndPair>& found, Ticker& ticker) const;

private:
  static constexpr std::size_t kChildren = 8; ///< segments or boxes in a box
  using Levels = BoxLevels<kChildren, kChildren>;

  std::vector<EndPair> segments_;
  Levels levels_; ///< of these
};

} // namespace ahd

#endif
