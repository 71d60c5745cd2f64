// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Sequence_h
#define ahd_Sequence_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Options.h"
#include "../Result.h"
#include "RankedPoints.h"

namespace ahd
{

/// Do these settings make the sequence that of the ranks 0 .. count - 1 by Rounds? The default
/// does.
inline bool isRankByRounds(const Options& options)
{
  return options.order == InsertionOrder::AdaptiveHilbert && options.geneRotation &&
    options.controlPoints == ControlPoints::EveryLevel;
}

/// Levels of division for a box of so many points: the smallest r >= 1 for which the 4^r boxes hold
/// 16 points or fewer on average (the paper's formulas 1 to 5).
constexpr unsigned levelsOfDivision(std::size_t points)
{
  unsigned r = 1;
  while (points > (std::size_t(16) << (2 * r)))
  {
    ++r;
  }
  return r;
}

/// Is a box of a division with so many points divided again?
inline bool isDividedAgain(std::size_t points, const Options& options)
{
  return options.order != InsertionOrder::RegularGrid && points > std::size_t(options.nmax);
}

/// Levels of the first division of so many points; 0 if they are not divided.
unsigned levelsOfFirstDivision(std::size_t points, const Options& options);

/// Bytes per point, at most, that makeSequence takes beside the sequence. A division has at most a
/// quarter as many boxes that are not empty as it has points; lists of them (24 bytes a box) grow
/// by doubling, and are sorted with 16 bytes a box.
constexpr std::size_t kSequenceScratchPerPoint = 56;

/// The order in which the points are inserted: a permutation of the ranks 0 .. count - 1.
///
/// Boxes: the box of all points is divided into 2^r x 2^r boxes if it holds more than nmax points,
/// each of those again if it does, and so on; r by levelsOfDivision. Boxes of one division are
/// visited along the Hilbert curve (AdaptiveHilbert; turned by the gene of the divided box if
/// options.geneRotation) or row by row, left to right (MultiGrid). Points of an undivided box come
/// in ascending order of the caller's id. RegularGrid divides once, whatever nmax, and never again.
/// A departure from the paper, measured (../Algorithm.md): with AdaptiveHilbert and EveryLevel the
/// curve goes on inside undivided boxes, down to the single point; with geneRotation the order of
/// the boxes and their points then is the order of rank, whatever nmax. Another: where a crowded
/// box is too small to be divided on the finest grid (2^32 x 2^32), its points come in order of
/// rank, which goes on inside such boxes.
///
/// Control points (AdaptiveHilbert, MultiGrid). SingleLevel: if all points are divided at all, the
/// point of smallest id of every non-empty box of the first division, in the reverse order of the
/// boxes, before all others; a control point no longer counts in its box. EveryLevel: the positions
/// by Rounds.
///
/// @pre options.nmax >= 1. Moves the fraction by a quarter of a unit per point.
/// Throws std::bad_alloc.
Status makeSequence(
  const RankedPoints& points, const Options& options, Ticker& sorting, Buffer<Index>& sequence);

} // namespace ahd

#endif
