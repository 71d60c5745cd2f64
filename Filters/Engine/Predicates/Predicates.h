// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Predicates_h
#define ahd_Predicates_h

#include "../Points/Points.h"

namespace ahd
{

/// Sign of the area of a, b, c: +1 counterclockwise, -1 clockwise, 0 collinear.
/// Exact for all finite coordinates.
int orient2d(const Point& a, const Point& b, const Point& c);

/// Sign of the in-circle determinant for a, b, c counterclockwise: +1 if d lies strictly inside
/// their circumcircle, -1 strictly outside, 0 on it. Exact for all finite coordinates.
int inCircle(const Point& a, const Point& b, const Point& c, const Point& d);

/// Is d in conflict with the counterclockwise triangle a, b, c? As inCircle > 0, with ties between
/// cocircular points broken by an infinitesimal weight per point, in lexicographic order of (x, y):
/// the answers describe one unique triangulation of the point set.
///
/// @pre four distinct points
bool inConflict(const Point& a, const Point& b, const Point& c, const Point& d);

/// Is the angle at c of the counterclockwise triangle a, b, c so wide that the triangle is flat:
/// above 180 degrees less the arc tangent of 2/5, 158.2? That is, 2 (a - c) . (b - c) < -5 times
/// their cross product. Exact for all finite coordinates.
bool isFlat(const Point& a, const Point& b, const Point& c);

/// The same without the floating-point filter, for callers whose own filter has failed.
int orient2dExact(const Point& a, const Point& b, const Point& c);
int inCircleExact(const Point& a, const Point& b, const Point& c, const Point& d);
bool inConflictExact(const Point& a, const Point& b, const Point& c, const Point& d);

} // namespace ahd

#endif
