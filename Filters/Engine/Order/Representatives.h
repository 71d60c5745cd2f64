// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Representatives_h
#define ahd_Representatives_h

#include "../Core/Progress.h"
#include "../Options.h"
#include "RankedPoints.h"

namespace ahd
{

/// Chooses which of the points at one place stands for the vertex there, in place of the one of
/// smallest id: changes `ranked`.id, .xy (in the sign of zeros) and .duplicates. @pre no
/// order is made by id afterwards; a stride of 3. Takes 4 bytes a point while it works, if there
/// are duplicates. Returns false if cancelled; throws std::bad_alloc.
bool chooseRepresentatives(
  const PointView& points, Representative wanted, RankedPoints& ranked, Ticker& ticker);

} // namespace ahd

#endif
