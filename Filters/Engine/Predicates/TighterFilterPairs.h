// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TighterFilterPairs_h
#define ahd_TighterFilterPairs_h

#include "FilterPairs.h"

/// The filter of sharp cross products (TighterFilters.h) for two triangles at once: for slivers
/// that the faster filter of two leaves open.
namespace ahd
{
inline namespace AHD_TARGET
{

/// The edges a-c and c-b of a triangle, and the points beyond them.
struct TwoEdges
{
  const Point &a, &c, &b;
  const Point &beyondFirst, &beyondSecond;
};

/// For each of these edges: conflictInRectangle() of b, a, c.
AHD_ALWAYS_INLINE InCirclePair inRectangles(unsigned open, const Point& p, const TwoEdges& edges)
{
  const int first = (open & 1) != 0 ? conflictInRectangle(edges.c, edges.a, edges.beyondFirst, p)
                                    : 0;
  const int second = (open & 2) != 0 ? conflictInRectangle(edges.b, edges.c, edges.beyondSecond, p)
                                     : 0;
  return { (first > 0 ? 1u : 0u) + (second > 0 ? 2u : 0u),
    (first != 0 ? 1u : 0u) + (second != 0 ? 2u : 0u) };
}

/// A point seen from P, by both coordinates: the vector, rounded, and where it is exact.
struct SeenPoint
{
  Pair vector;
  MaskPair isExact;
};

/// isExactDifference() in TighterFilters.h says why.
AHD_ALWAYS_INLINE SeenPoint seenPoint(Pair p, const Point& a)
{
  const Pair at = coordinates(a);
  const Pair vector = at - p;
  return { vector, areEqual(at - vector, p) & areEqual(p + vector, at) };
}

/// A x B with a relative error of at most 2u (that of single numbers is in TighterFilters.h).
AHD_ALWAYS_INLINE Pair sharpCross(const VectorPair& a, const VectorPair& b)
{
  const Pair right = a.y * b.x;
  const Pair lost = productLess(a.y, b.x, right);
  return productLess(a.x, b.y, right) - lost;
}

/// For both edges: does P lie in the circle of b, a, c (inCircle() in FilterPairs.h), where all
/// coordinates are seen exactly? Nothing is certain without fused multiply-adds.
/// @pre guard >= inCircleGuard(A.z + B.z + C.z) for both.
///
/// Proof: that of inCircleBySharpCrosses() for one triangle, but that any size is allowed, and the
/// guard pays for underflow. A.z may be wrong by 3e more and a cross product by 4e, its three
/// roundings and their errors' rounding; the other factor of their term multiplies that, and each
/// term is wrong by e more. As in inCircleIsCertain() that is less than 12e (la + lb + lc + 1), and
/// the guard is 2^51 as big. Where a term overflows the sum of magnitudes does, or is NaN, and the
/// comparison fails.
AHD_ALWAYS_INLINE InCirclePair inCircleBySharpCrosses(
  const Point& p, const TwoEdges& edges, double guard)
{
  if (!kPairsAreFused)
  {
    return { 0, 0 };
  }
  const Pair at = coordinates(p);
  const SeenPoint a = seenPoint(at, edges.a), b = seenPoint(at, edges.b),
                  c = seenPoint(at, edges.c);
  const SeenPoint f = seenPoint(at, edges.beyondFirst), g = seenPoint(at, edges.beyondSecond);
  const LiftedPair A = lifted(a.vector, c.vector), B = lifted(c.vector, b.vector);
  const LiftedPair C = lifted(f.vector, g.vector);
  const Pair ofA = A.z * sharpCross(C, B), ofB = B.z * sharpCross(A, C),
             ofC = C.z * sharpCross(A, B);
  const Pair det = ofA + ofB - ofC;
  const Pair sum = magnitude(ofA) + magnitude(ofB) + magnitude(ofC);
  const unsigned certain = magnitudeExceeds(det, multiplyAdd(both(0x1p-50), sum, both(guard)));
  const bool first = bits(a.isExact & c.isExact & f.isExact) == 3;
  const bool second = bits(c.isExact & b.isExact & g.isExact) == 3;
  return { signs(det) ^ 3u, certain & ((first ? 1u : 0u) + (second ? 2u : 0u)) };
}

} // namespace AHD_TARGET
} // namespace ahd

#endif
