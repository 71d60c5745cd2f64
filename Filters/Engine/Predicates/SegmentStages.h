// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SegmentStages_h
#define ahd_SegmentStages_h

#include "Segments.h"

#include <optional>

/// The stages of orderAt, crossingOf and roundsTo (Segments.h). Those by filter, in double
/// arithmetic, answer only where they are certain; the others always, and exactly. For Segments.cxx
/// and its tests only.
namespace ahd::stages
{

/// The sign of the height of s above t where the vertical through p meets their lines.
/// @pre neither is vertical.
std::optional<int> heightsByFilter(const Segment& s, const Segment& t, const Point& p);
int heightsUnbounded(const Segment& s, const Segment& t, const Point& p);

/// Where they cross, each coordinate rounded. @pre they cross.
std::optional<Point> crossingByFilter(const Segment& s, const Segment& t);
Point crossingUnbounded(const Segment& s, const Segment& t);

/// Does s certainly miss all points that round to p?
bool passesByFilter(const Segment& s, const Point& p);

/// Does the line of s meet the interior of the set of points that round to p?
bool meetsUnbounded(const Segment& s, const Point& p);

} // namespace ahd::stages

#endif
