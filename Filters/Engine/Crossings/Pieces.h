// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Pieces_h
#define ahd_Pieces_h

#include "../Core/AskedMemory.h"
#include "../Points/Points.h"
#include "../Predicates/Segments.h"

#include <vector>

namespace ahd
{

/// A part of a segment of the chains, or all of it.
struct Piece
{
  Segment segment;
  Index leftId, rightId; ///< the points at its ends
  Index position;        ///< of the segment: where its first id stands among those given
  bool isForward;        ///< the segment runs from left to right
  bool isDead;           ///< replaced by pieces of its own
};

using Pieces = std::vector<Piece>;

/// Two pieces that cross, as places in the Pieces.
struct Crossing
{
  Index a;
  Index b;
};

/// Appends to a list. Requests the memory that it grows into, if `taken` is not null. Throws
/// std::bad_alloc.
inline void addCrossing(std::vector<Crossing>& list, const Crossing& crossing, TakenMemory* taken)
{
  if (taken && list.size() == list.capacity())
  {
    taken->atLeast(3 * sizeof(Crossing) * list.size()); // itself, and twice as much
  }
  list.push_back(crossing);
}

/// Do they have one point in common that is an end of neither? Exact.
bool cross(const Segment& s, const Segment& t);

} // namespace ahd

#endif
