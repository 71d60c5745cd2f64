// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Rank_h
#define ahd_Rank_h

#include "../Core/Progress.h"
#include "../Options.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "RankedPoints.h"

#include <cstddef>

namespace ahd
{

// The canonical rank of a point, a function of the point set alone:
// 1. x and y are quantised to 32 bits each over the bounding box, or a larger one (Quantise.h);
// 2. points are sorted by their place on the Hilbert curve of 32 levels (HilbertCurve.h);
// 3. up to kTiedByCoordinates distinct points of one place are sorted by (x, y); more than that are
//    ranked again by these rules in their own bounding box.
// Coincident points are one point: the one of smallest id stays.

constexpr std::size_t kTiedByCoordinates = 16;

/// Bytes per point that rankPoints needs beside locations and ids: a record, a key and a duplicate.
constexpr std::size_t kRankScratchPerPoint = 32 + 8 + 8;

/// Bytes of scratch that rankPoints needs for so many finite points.
constexpr std::size_t rankScratchBytes(std::size_t n)
{
  return n * kRankScratchPerPoint + 128;
}

// Both functions use all threads that are lent to the phase; the result, the order of duplicates
// included, does not depend on their number.

/// Reads each point once (phase Read): sets out.bounds, out.whole, out.notFinite and out.skipped;
/// skipped points are not read. out.count becomes the number of finite points. `least`: what
/// out.whole holds besides out.bounds.
Status readPoints(
  const PointView& points, Ticker& reading, RankedPoints& out, const RankBounds& least = {});

/// Sorts the points by rank and drops duplicates; sets the rest of `out`. out.scratch is made
/// larger if it has not rankScratchBytes(out.count) bytes.
/// @pre readPoints returned Ok for the same points and `out`; at most kMaximumPoints points.
/// Moves the fraction by three quarters of a unit per point. Throws std::bad_alloc.
/// Cost: two passes over the points to scatter them to buckets by the first bits of their keys, one
/// to sort each bucket; crowded buckets are scattered again by further bits. With several threads
/// and duplicates, two more to close the gaps that these leave. A bucket is sorted by one thread.
Status rankPoints(const PointView& points, Ticker& sorting, RankedPoints& out);

} // namespace ahd

#endif
