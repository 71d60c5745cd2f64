// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Circles_h
#define ahd_Circles_h

#include "../Points/Points.h"

#include <optional>

namespace ahd
{

/// The three corners of a triangle, counterclockwise.
struct Corners
{
  Point a, b, c;
};

// The decisions that clip cells of the Voronoi diagram. Exact for all finite coordinates.

/// The sign of the distance of the circumcentre from the line through `from` and `to`: +1 to the
/// left of it, -1 to the right, 0 on it.
int sideOfCircumcentre(const Corners& triangle, const Point& from, const Point& to);

/// Which of p and q is nearer to `place`: +1 if p is, -1 if q is, 0 if neither.
int nearerOf(const Point& p, const Point& q, const Point& place);

/// The sign of (p - r) . (q - r): +1 if the angle at r is acute, -1 if it is obtuse, 0 if it is a
/// right one.
int acuteness(const Point& p, const Point& r, const Point& q);

/// For Circles.cxx and its tests only: in double arithmetic where that is certain, and always.
namespace stages
{

std::optional<int> sideByFilter(const Corners& triangle, const Point& from, const Point& to);
int sideUnbounded(const Corners& triangle, const Point& from, const Point& to);
std::optional<int> nearerByFilter(const Point& p, const Point& q, const Point& place);
int nearerUnbounded(const Point& p, const Point& q, const Point& place);
std::optional<int> acutenessByFilter(const Point& p, const Point& r, const Point& q);
int acutenessUnbounded(const Point& p, const Point& r, const Point& q);

} // namespace stages
} // namespace ahd

#endif
