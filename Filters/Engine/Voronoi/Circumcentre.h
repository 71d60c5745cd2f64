// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Circumcentre_h
#define ahd_Circumcentre_h

#include "../Points/Points.h"
#include "../Predicates/Circles.h"

#include <cmath>

namespace ahd
{

// Coordinates of corners of cells. "Rounded once": each coordinate is the exact one, rounded to
// nearest from at least 11 bits more than a double has: so no more than 0.501 units in the last
// place away, and on no other side of a double. Infinite beyond the largest double.

/// The centre of the circle through the corners, rounded once. @pre they are not collinear.
Point circumcentre(const Corners& triangle);

/// Is each coordinate zero, or so far from the ends of the range that neither products of three
/// differences of such numbers nor the rounding errors of these overflow or underflow?
inline bool isModest(const Point& p)
{
  const double x = std::fabs(p.x), y = std::fabs(p.y);
  return ((x >= 0x1p-60 && x <= 0x1p60) || x == 0.0) && ((y >= 0x1p-60 && y <= 0x1p60) || y == 0.0);
}

/// A segment that a bisector meets.
struct Line
{
  Point from, to;
};

/// Where the bisector of p and q meets the line, rounded once. @pre they are not parallel.
Point bisectorOnLine(const Point& p, const Point& q, const Line& line);

/// For Circumcentre.cxx and its tests only: the same, always by integers of the length needed.
namespace stages
{
Point circumcentreUnbounded(const Corners& triangle);
Point bisectorUnbounded(const Point& p, const Point& q, const Line& line);
}

} // namespace ahd

#endif
