// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Circumcentre_h
#define ahd_Circumcentre_h

#include "../Points/Points.h"
#include "../Predicates/Circles.h"

namespace ahd
{

// Where corners of cells lie. "Rounded once": each coordinate is the exact one, rounded to nearest
// from at least 11 bits more than a double has: so no more than 0.501 units in the last place away,
// and on no other side of a double. Infinite beyond the largest double.

/// The centre of the circle through the corners, rounded once. REQUIRES: they are not collinear.
Point circumcentre(const Corners& triangle);

/// A segment that a bisector meets.
struct Line
{
  Point from, to;
};

/// Where the bisector of p and q meets the line, rounded once. REQUIRES: they are not parallel.
Point bisectorOnLine(const Point& p, const Point& q, const Line& line);

/// For Circumcentre.cxx and its tests only: the same, always by integers as long as need be.
namespace stages
{
Point circumcentreUnbounded(const Corners& triangle);
Point bisectorUnbounded(const Point& p, const Point& q, const Line& line);
}

} // namespace ahd

#endif
