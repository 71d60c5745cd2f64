// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_GridBoxes_h
#define ahd_GridBoxes_h

#include "../Core/Progress.h"
#include "../Options.h"
#include "../Result.h"
#include "RankedPoints.h"

#include <vector>

namespace ahd
{

/// The undivided boxes of the grid that makeSequence visits (see there), in that order, the empty
/// ones among the boxes of each division included. For drawing; the insertion does not need them.
/// A division of n points makes at most n / 4 boxes, but 4 at least: where nmax is small, points
/// close together may be divided many times, and there may be many more boxes than points.
/// Returns Ok, Cancelled, or TooManyBoxes as soon as there are more than options.mostBoxes.
/// @pre the keys of `points` are still valid. Throws std::bad_alloc.
Status listBoxes(
  const RankedPoints& points, const Options& options, Ticker& ticker, std::vector<GridBox>& boxes);

} // namespace ahd

#endif
