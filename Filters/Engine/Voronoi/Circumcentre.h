// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Circumcentre_h
#define ahd_Circumcentre_h

#include "../Points/Points.h"

namespace ahd
{

/// The three corners of a triangle, counterclockwise.
struct Corners
{
  Point a, b, c;
};

/// The centre of the circle through the corners, rounded once as far as 100 bits go. Not finite if
/// it cannot be told from infinity.
Point circumcentre(const Corners& triangle);

/// The sign of the distance of the circumcentre from the line through `from` and `to`: +1 to the
/// left of it, -1 to the right, 0 on it, as far as 100 bits can tell.
int sideOfCircumcentre(const Corners& triangle, const Point& from, const Point& to);

/// Where the bisector of p and q meets the segment from `from` to `to`; the nearer end of the
/// segment if it does not, or the middle if they are parallel.
Point bisectorOnSegment(const Point& p, const Point& q, const Point& from, const Point& to);

} // namespace ahd

#endif
