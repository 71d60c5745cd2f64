// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Constraints_h
#define ahd_Constraints_h

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace ahd
{

/// Which regions between loops are kept. Only edges of loops bound a region; without a loop
/// everything is kept.
enum class FillRule
{
  /// Inside is on the left. A region is kept if it lies on the left of every loop edge that bounds
  /// it, or if none does. Each loop that passes along an edge counts; an edge that loops pass as
  /// often one way as the other bounds nothing.
  Orientation = 0,
  /// A region is kept if a way from the outside to it crosses loops an odd number of times. Loops
  /// along the same edges count as one.
  EvenOdd = 1
};

/// Chains of points, borrowed from the caller. Each pair of successive points is a segment that
/// becomes an edge of the triangulation, or a row of edges if vertices lie on it. Any ids are
/// legal, repeated ones included.
struct ConstraintView
{
  const std::int64_t* ids = nullptr; ///< the caller's ids of points, chain after chain
  /// Chain k is ids[offsets[k]] to ids[offsets[k + 1] - 1]: chains + 1 numbers, ascending.
  const std::int64_t* offsets = nullptr;
  std::size_t chains = 0;
  /// The first `lines` chains are open. The others are loops: their last point is joined to their
  /// first.
  std::size_t lines = 0;
};

/// The number of segments of a chain: one less than ids; as many in a loop, unless its last id is
/// its first.
inline std::size_t segmentsOf(const ConstraintView& constraints, std::size_t chain)
{
  const std::int64_t begin = constraints.offsets[chain], end = constraints.offsets[chain + 1];
  if (end - begin < 2)
  {
    return 0;
  }
  const bool isClosed = chain >= constraints.lines &&
    constraints.ids[begin] != constraints.ids[end - 1];
  return static_cast<std::size_t>(end - begin) - (isClosed ? 0 : 1);
}

/// A segment that was left out because it crosses an earlier one.
struct LeftOut
{
  std::size_t chain, segment;           ///< the segment, from 0 within its chain
  std::size_t otherChain, otherSegment; ///< the one it crosses first on its way
};

/// The outcome of the constraints. segments = points + withoutVertex + crossing + those that became
/// edges.
struct ConstraintReport
{
  std::size_t segments = 0;      ///< given
  std::size_t points = 0;        ///< of no length: both ends are one vertex
  std::size_t withoutVertex = 0; ///< with an end that is no vertex, or no point at all
  std::size_t crossing = 0;      ///< left out: see leftOut
  std::size_t unfilledLoops = 0; ///< loops that bound no region, as a segment of theirs is missing
  std::size_t edges = 0;         ///< distinct edges of the triangulation that are constraints
  std::vector<LeftOut> leftOut;  ///< in the order of the chains

  auto fields()
  {
    return std::tie(segments, points, withoutVertex, crossing, unfilledLoops, edges, leftOut);
  }
};

} // namespace ahd

#endif
