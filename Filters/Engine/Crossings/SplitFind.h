// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SplitFind_h
#define ahd_SplitFind_h

#include "../Core/Progress.h"
#include "Pieces.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Segments whose ends are named by their rank among all ends in lexicographic order.
struct RankedSegments
{
  struct Ends
  {
    Index left;
    Index right;
  };

  std::vector<Point> places; ///< distinct, ascending
  std::vector<Ends> ends;    ///< of each segment: left < right
  std::size_t firstNew = 0;  ///< segments before this one are known not to cross each other

  Segment operator[](Index s) const { return { places[ends[s].left], places[ends[s].right] }; }
};

/// Finds all pairs of segments that have one point in common which is an end of neither, each pair
/// once, in no particular order: a < b, and b is new. Stops once it has found more than `most`.
/// Returns false if cancelled. Throws std::bad_alloc.
///
/// After Balaban, "An optimal algorithm for finding segments intersections" (SCG 1995), his
/// "intermediate" algorithm: strips between two ends are halved again and again. Of the segments
/// that span a strip, a ladder is taken: as many as follow without crossing one another. All others
/// find the rungs they cross by going up and down from where they enter, and go on into the two
/// halves of the strip, as far as they reach into them.
/// Cost: n log^2 n + k log n steps for any n segments with k crossings.
bool findCrossings(const RankedSegments& segments, Ticker& ticker, std::vector<Crossing>& crossings,
  std::size_t most = std::size_t(-1), TakenMemory* taken = nullptr);

} // namespace ahd

#endif
