// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Hull_h
#define ahd_Hull_h

#include "../Core/Progress.h"
#include "../Points/Points.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// The corners of the convex hull, counterclockwise from the lexicographically smallest; points on
/// its edges are none. Two if all points are on one line. Takes at most 40 bytes a point. Returns
/// false if cancelled; throws std::bad_alloc. @pre finite, distinct points
bool findHullCorners(
  const Point* points, std::size_t count, Ticker& ticker, std::vector<Index>& corners);

} // namespace ahd

#endif
