// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Distances_h
#define ahd_Distances_h

#include "Segments.h"

#include <optional>

namespace ahd
{

// Distances of places from segments, whose ends may coincide. Exact for all finite coordinates.

/// What of a segment is nearest to a place.
enum class NearestPart
{
  Left,   ///< its left end
  Inside, ///< a place between its ends
  Right
};

NearestPart nearestPartOf(const Segment& s, const Point& place);

/// Which of s and t is nearer to `place`: +1 if s is, -1 if t is, 0 if neither.
int nearerOf(const Segment& s, const Segment& t, const Point& place);

/// How far rounding may have moved a place that was computed to lie on s: 16 units in the last
/// place of the largest coordinate of s and `place`.
double roundingAt(const Segment& s, const Point& place);
/// The same, where no coordinate is larger than this.
double roundingAt(double largest);

/// Is `place` at most this far from s?
bool isWithin(const Segment& s, double distance, const Point& place);

/// For Distances.cxx and its tests only: in double arithmetic where that is certain, and always.
namespace stages
{

std::optional<int> nearerByFilter(const Segment& s, const Segment& t, const Point& place);
int nearerUnbounded(const Segment& s, const Segment& t, const Point& place);
std::optional<bool> withinByFilter(const Segment& s, double distance, const Point& place);
bool withinUnbounded(const Segment& s, double distance, const Point& place);

} // namespace stages
} // namespace ahd

#endif
