// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Inserter_h
#define ahd_Inserter_h

#include "../Mesh/Mesh.h"
#include "../Order/RankedPoints.h"
#include "../Progress.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// What the insertion did; filled only when counting is asked for.
struct InsertionWork
{
  std::uint64_t trianglesWalked = 0;
  std::uint64_t trianglesRemoved = 0;
  std::uint64_t exactInCircle = 0;
  std::uint64_t exactOrient = 0;
};

/// How an insertion of a sequence ended.
enum class InsertionEnd
{
  Done,
  AllCollinear, ///< no three points of the sequence span a triangle; the mesh is empty
  Cancelled     ///< the mesh is unusable
};

/// Inserts `sequence` (distinct vertices, all of them, each once) into `mesh`, on this thread.
/// REQUIRES: the mesh has room for points.count vertices and is empty.
/// Cost: O(1) expected per point when successive points are close and a sparse subset of the points
/// comes first (see Order); O(n) per point at worst.
/// Allocates nothing. Counts into `work` unless that is null.
InsertionEnd insertSequence(const RankedPoints& points, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork* work);

} // namespace ahd

#endif
