// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Insert_h
#define ahd_Insert_h

#include "../Core/Progress.h"
#include "../Mesh/Mesh.h"
#include "../Order/RankedPoints.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Counts of the insertion; filled only on request.
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

/// Inserts `sequence` (distinct vertices, all of them, each once) into `mesh`, on this thread. The
/// locations are changed while it works (Frame.h), and as they were afterwards unless cancelled.
/// @pre the mesh has room for points.count vertices and is empty.
/// Cost: O(1) expected per point when successive points are close and a sparse subset of the points
/// comes first (see Order); O(n) per point at worst.
/// Allocates nothing. Counts into `work` unless that is null.
InsertionEnd insertSequence(RankedPoints& points, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork* work);

/// How an insertion was shared (see Report).
struct SharedWork
{
  std::uint64_t attempts = 0;
  std::uint64_t deferred = 0;
  std::uint64_t criticalPath = 0;
};

/// Fewest points for which threads are worth their while: with fewer, one thread does it all.
constexpr std::size_t kLeastShared = 30000;

/// Inserts all vertices in order of rank by Rounds into `mesh`, on the threads lent to the phase.
/// The locations are changed while it works, as above.
/// With counting (`work` not null) or without threads: on this one.
/// @pre the mesh has room for points.count vertices and is empty.
/// Allocates 4 bytes per point if there are threads. Throws std::bad_alloc.
///
/// Where the rounds are large enough they are inserted in parts. Why that is safe:
/// - A part owns the vertices of a range of ranks, a territory, and inserts its points. It removes
///   a triangle only if it owns all its finite vertices. Two such triangles of different parts have
///   no finite vertex in common, so no edge (each has a finite vertex): neither part removes what
///   the other removes, nor its neighbours.
/// - A triangle with a vertex of a part's own is removed by that part or by none, and the link
///   across an edge with an end of its own is changed by that part or by none. The part reads
///   nothing else: a walk that would cross an edge without an end of its own stops. So no number is
///   written by one thread while another one reads it, and there is nothing to lock or to mark.
/// - Every insertion has two slots for the two triangles it adds, known from the point's place in
///   the order. It fills these and those of the triangles it removes, no others.
/// - Where a cavity turns out to have a triangle that must stay, its changes are undone, in the
///   same slots and links.
/// Points that a part cannot insert wait for the next pass, in which four parts are one. The last
/// pass has one part, which owns all. Curve and territories are such that few points wait: those
/// whose cavities reach across the border of the part's region, about a constant times the root of
/// the number of its points.
InsertionEnd insertByRounds(
  RankedPoints& points, Mesh& mesh, Ticker& ticker, InsertionWork* work, SharedWork& shared);

} // namespace ahd

#endif
