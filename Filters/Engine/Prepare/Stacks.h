// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Stacks_h
#define ahd_Stacks_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"

namespace ahd
{

// For messages on points that x and y hardly distinguish, as in a wall or a volume. Points left out
// or with a coordinate that is not finite do not count.
// The phase is Phase::Extract. Both return Ok, Cancelled or OutOfMemory.

/// Do all points lie on one line in space, give or take a millionth of its length?
Status findIfOnOneLine(const PointView& points, const Context& context, bool& isSo);

/// Do most points share x and y with another one of a different z? Judged by a sample.
Status findIfStacked(const PointView& points, const Context& context, bool& isSo);

} // namespace ahd

#endif
