// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RunMemory_h
#define ahd_RunMemory_h

#include "RunSettings.h"

#include <cstddef>

namespace ahd
{

/// What is known of sizes: points and segments before the work begins; crossings once they are
/// split, boxes once the points are sorted, edges of a surface once its triangles are looked for.
struct RunSizes
{
  std::size_t points = 0; ///< added ones included
  std::size_t segments = 0;
  std::size_t crossings = 0;
  std::size_t boxes = 0;
  std::size_t surfaceEdges = 0; ///< of given triangles, to become constraints
  /// Bytes that show while segments are split, and while they are inserted (Progress::take()).
  std::size_t askedToSplit = 0, askedToConstrain = 0;
};

/// What the caller of a run takes besides, for its estimate.
struct CallersMemory
{
  std::size_t bytes = 0;
  std::size_t perAddedPoint = 0; ///< for each point, if points are added
};

/// Upper estimate of all bytes that are held at a time while an input is prepared and triangulated
/// and what is asked for is written, that included: cells with 32 bits an id, other ids with 64.
/// Of the Voronoi diagram both the engine's cells and what is written of them. The input not
/// counted.
///
/// The step that takes most counts, not their sum. The table of Testing/Package/Memory/Report.md
/// has it beside what is taken.
std::size_t runMemoryEstimate(const InputRequest& request, const RunSettings& settings,
  const RunSizes& sizes, const CallersMemory& callers = {});

/// More boxes than memory can be estimated for.
constexpr std::size_t kTooManyBoxes = std::size_t(1) << 40;

/// More bytes than there are.
constexpr std::size_t kTooMuchAsked = std::size_t(1) << 60;

/// The largest number below `tooMany` of which there is memory for so many. REQUIRES: fits(0); what
/// fits is no less than a larger number that does.
template <typename Fits>
std::size_t mostThatFit(std::size_t tooMany, const Fits& fits)
{
  std::size_t most = 0;
  while (tooMany - most > 1)
  {
    const std::size_t middle = most + (tooMany - most) / 2;
    (fits(middle) ? most : tooMany) = middle;
  }
  return most;
}

} // namespace ahd

#endif
