// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Segments_h
#define ahd_Segments_h

#include "../Points/Points.h"

namespace ahd
{

/// A segment, from its lexicographically smaller end to the other. @pre they differ.
struct Segment
{
  Point left;
  Point right;
};

/// Order by left ends, then by right ends.
inline bool comesBefore(const Segment& s, const Segment& t)
{
  return s.left == t.left ? lexicographicallyLess(s.right, t.right)
                          : lexicographicallyLess(s.left, t.left);
}

// Segments are compared along a vertical line that is turned counterclockwise by an infinitesimal
// angle. So each point has its own line, the lines come in the lexicographic order of the points,
// and a vertical segment is no exception: its lower end is the left one. All signs are exact.
// "Side" of a point: orient2d(left, right, point), +1 if it lies above the segment (a vertical one:
// to the left of it).

/// +1 if the line of p meets s above t, -1 if below t, 0 if both at p or if they are collinear.
/// `sideOfS`, `sideOfT`: those of p. @pre both reach from p or before to p or beyond.
int orderAt(const Segment& s, int sideOfS, const Segment& t, int sideOfT, const Point& p);

/// The sign of cross((t's right - t's left), (s's right - s's left)): +1 if s is steeper, 0 if they
/// are collinear. `sideOfRight`, `sideOfLeft`: those of the ends of s, seen from t.
/// @pre the lines of the segments have a point in common that lies on both segments.
inline int steepness(int sideOfLeft, int sideOfRight)
{
  return sideOfRight != 0 ? sideOfRight : -sideOfLeft;
}

/// Where the lines of two segments meet, each coordinate rounded to the nearest double, ties to
/// even; never -0.0. @pre the segments cross.
Point crossingOf(const Segment& s, const Segment& t);

/// Is there a point on s that rounds to p, and p no end of s? "Rounds" as crossingOf does; where
/// only a tie between p and another point does, it counts as no.
bool roundsTo(const Segment& s, const Point& p);

/// The fraction of the way from `from` to `to` at p, 0 to 1, measured in the coordinate in which
/// the way is longer. @pre from is not to.
double fractionOfWay(const Point& from, const Point& to, const Point& p);

} // namespace ahd

#endif
