// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RunMemory_h
#define ahd_RunMemory_h

#include "RunSettings.h"

#include <cstddef>
#include <tuple>

namespace ahd
{

/// The known sizes: points and segments before the work begins; crossings once they are
/// split, boxes once the points are sorted, edges of a surface once its triangles are looked for.
struct RunSizes
{
  std::size_t points = 0; ///< added ones included
  std::size_t segments = 0;
  std::size_t crossings = 0;
  std::size_t addedToLines = 0; ///< points; known when crossings are
  std::size_t boxes = 0;
  std::size_t surfaceEdges = 0; ///< of given triangles, to become constraints
  /// Bytes requested while segments are split, while points are chosen, and while segments are
  /// inserted (Progress::take()).
  std::size_t askedToSplit = 0, askedToSimplify = 0, askedToConstrain = 0;

  auto fields()
  {
    return std::tie(points, segments, crossings, addedToLines, boxes, surfaceEdges, askedToSplit,
      askedToSimplify, askedToConstrain);
  }
};

/// The caller's own memory, for the estimate of a run.
struct CallersMemory
{
  std::size_t bytes = 0;
  std::size_t perAddedPoint = 0; ///< for each point, if points are added, or left out in the end
};

/// Upper estimate of the peak memory in bytes while an input is prepared and triangulated and the
/// requested outputs are written, these included: cells with 32 bits an id, other ids with 64. For
/// the Voronoi diagram both the engine's cells and the written ones. The input is not
/// counted.
///
/// It is that of the largest step, not the sum of all. The table of
/// Testing/Package/Memory/Report.md compares it with actual use.
std::size_t runMemoryEstimate(const InputRequest& request, const RunSettings& settings,
  const RunSizes& sizes, const CallersMemory& callers = {});

/// Upper estimate of the bytes of what is kept of a run to interpolate on it later: the
/// triangulation, all tables, marks and copies of points.
std::size_t keptMemoryEstimate(
  const InputRequest& request, const RunSettings& settings, const RunSizes& sizes);

/// More boxes than memory can be estimated for.
constexpr std::size_t kTooManyBoxes = std::size_t(1) << 40;

/// More bytes than there are.
constexpr std::size_t kTooMuchAsked = std::size_t(1) << 60;

/// The largest number below `tooMany` of which there is memory for so many. @pre fits(0); what
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
