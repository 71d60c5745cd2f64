// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FilterPairs_h
#define ahd_FilterPairs_h

#include "Filters.h"

#if AHD_HAS_X86_PAIRS
#include <immintrin.h>
#endif

/// The in-circle filter of Filters.h for two triangles at once, which takes no longer than one, and
/// in another order, in which the answer comes soon after the last point is known: all else is
/// computed before. The kernel speculates on answers, and waits for this one only where it was
/// wrong.
namespace ahd
{
inline namespace AHD_TARGET
{

#if AHD_HAS_X86_PAIRS
/// Two numbers, on which each operation works at once.
struct Pair
{
  __m128d v;
};

AHD_ALWAYS_INLINE Pair both(double a)
{
  return { _mm_set1_pd(a) };
}
AHD_ALWAYS_INLINE Pair coordinates(const Point& p)
{
  return { _mm_loadu_pd(&p.x) };
}
/// The low (high) numbers of two pairs.
AHD_ALWAYS_INLINE Pair lows(Pair a, Pair b)
{
  return { _mm_unpacklo_pd(a.v, b.v) };
}
AHD_ALWAYS_INLINE Pair highs(Pair a, Pair b)
{
  return { _mm_unpackhi_pd(a.v, b.v) };
}
AHD_ALWAYS_INLINE double low(Pair a)
{
  return _mm_cvtsd_f64(a.v);
}
AHD_ALWAYS_INLINE double high(Pair a)
{
  return low(highs(a, a));
}

AHD_ALWAYS_INLINE Pair operator+(Pair a, Pair b)
{
  return { _mm_add_pd(a.v, b.v) };
}
AHD_ALWAYS_INLINE Pair operator-(Pair a, Pair b)
{
  return { _mm_sub_pd(a.v, b.v) };
}
AHD_ALWAYS_INLINE Pair operator*(Pair a, Pair b)
{
  return { _mm_mul_pd(a.v, b.v) };
}
#if defined(__FMA__) || defined(AHD_FUSED_MULTIPLY_ADD)
constexpr bool kPairsAreFused = true; ///< Do the next three functions round once?
AHD_ALWAYS_INLINE Pair multiplyAdd(Pair a, Pair b, Pair c)
{
  return { _mm_fmadd_pd(a.v, b.v, c.v) };
}
AHD_ALWAYS_INLINE Pair lessProduct(Pair c, Pair a, Pair b)
{
  return { _mm_fnmadd_pd(a.v, b.v, c.v) };
}
AHD_ALWAYS_INLINE Pair productLess(Pair a, Pair b, Pair c)
{
  return { _mm_fmsub_pd(a.v, b.v, c.v) };
}
#else
constexpr bool kPairsAreFused = false;
AHD_ALWAYS_INLINE Pair multiplyAdd(Pair a, Pair b, Pair c)
{
  return a * b + c;
}
AHD_ALWAYS_INLINE Pair lessProduct(Pair c, Pair a, Pair b)
{
  return c - a * b;
}
AHD_ALWAYS_INLINE Pair productLess(Pair a, Pair b, Pair c)
{
  return a * b - c;
}
#endif

/// Bit 0 for the low number, bit 1 for the high one: is its sign bit set? Is its magnitude larger
/// than that of the other pair?
AHD_ALWAYS_INLINE unsigned signs(Pair a)
{
  return static_cast<unsigned>(_mm_movemask_pd(a.v));
}
AHD_ALWAYS_INLINE Pair magnitude(Pair a)
{
  return { _mm_andnot_pd(_mm_set1_pd(-0.0), a.v) };
}
AHD_ALWAYS_INLINE unsigned magnitudeExceeds(Pair a, Pair b)
{
  return static_cast<unsigned>(_mm_movemask_pd(_mm_cmpgt_pd(magnitude(a).v, b.v)));
}

/// For each of two numbers: an answer, for choices without a branch.
struct MaskPair
{
  __m128d v;
};

AHD_ALWAYS_INLINE MaskPair exceeds(Pair a, Pair b)
{
  return { _mm_cmpgt_pd(a.v, b.v) };
}
AHD_ALWAYS_INLINE MaskPair areEqual(Pair a, Pair b)
{
  return { _mm_cmpeq_pd(a.v, b.v) };
}
AHD_ALWAYS_INLINE MaskPair operator&(MaskPair a, MaskPair b)
{
  return { _mm_and_pd(a.v, b.v) };
}
AHD_ALWAYS_INLINE unsigned bits(MaskPair m)
{
  return static_cast<unsigned>(_mm_movemask_pd(m.v));
}
AHD_ALWAYS_INLINE Pair choose(MaskPair m, Pair a, Pair b)
{
  return { _mm_or_pd(_mm_and_pd(m.v, a.v), _mm_andnot_pd(m.v, b.v)) };
}
AHD_ALWAYS_INLINE Pair orZero(MaskPair m, Pair a)
{
  return { _mm_and_pd(m.v, a.v) };
}
AHD_ALWAYS_INLINE Pair larger(Pair a, Pair b)
{
  return { _mm_max_pd(a.v, b.v) };
}
AHD_ALWAYS_INLINE Pair smaller(Pair a, Pair b)
{
  return { _mm_min_pd(a.v, b.v) };
}
#else
struct Pair
{
  double l, h;
};

AHD_ALWAYS_INLINE Pair both(double a)
{
  return { a, a };
}
AHD_ALWAYS_INLINE Pair coordinates(const Point& p)
{
  return { p.x, p.y };
}
AHD_ALWAYS_INLINE Pair lows(Pair a, Pair b)
{
  return { a.l, b.l };
}
AHD_ALWAYS_INLINE Pair highs(Pair a, Pair b)
{
  return { a.h, b.h };
}
AHD_ALWAYS_INLINE double low(Pair a)
{
  return a.l;
}
AHD_ALWAYS_INLINE double high(Pair a)
{
  return a.h;
}

AHD_ALWAYS_INLINE Pair operator+(Pair a, Pair b)
{
  return { a.l + b.l, a.h + b.h };
}
AHD_ALWAYS_INLINE Pair operator-(Pair a, Pair b)
{
  return { a.l - b.l, a.h - b.h };
}
AHD_ALWAYS_INLINE Pair operator*(Pair a, Pair b)
{
  return { a.l * b.l, a.h * b.h };
}
constexpr bool kPairsAreFused = kMultiplyAddIsFused;
AHD_ALWAYS_INLINE Pair multiplyAdd(Pair a, Pair b, Pair c)
{
  return { multiplyAdd(a.l, b.l, c.l), multiplyAdd(a.h, b.h, c.h) };
}
AHD_ALWAYS_INLINE Pair lessProduct(Pair c, Pair a, Pair b)
{
  return { multiplyAdd(-a.l, b.l, c.l), multiplyAdd(-a.h, b.h, c.h) };
}
AHD_ALWAYS_INLINE Pair productLess(Pair a, Pair b, Pair c)
{
  return { multiplyAdd(a.l, b.l, -c.l), multiplyAdd(a.h, b.h, -c.h) };
}

AHD_ALWAYS_INLINE unsigned signs(Pair a)
{
  return (std::signbit(a.l) ? 1u : 0u) + (std::signbit(a.h) ? 2u : 0u);
}
AHD_ALWAYS_INLINE Pair magnitude(Pair a)
{
  return { std::fabs(a.l), std::fabs(a.h) };
}
AHD_ALWAYS_INLINE unsigned magnitudeExceeds(Pair a, Pair b)
{
  return (std::fabs(a.l) > b.l ? 1u : 0u) + (std::fabs(a.h) > b.h ? 2u : 0u);
}

struct MaskPair
{
  bool l, h;
};

AHD_ALWAYS_INLINE MaskPair exceeds(Pair a, Pair b)
{
  return { a.l > b.l, a.h > b.h };
}
AHD_ALWAYS_INLINE MaskPair areEqual(Pair a, Pair b)
{
  return { a.l == b.l, a.h == b.h };
}
AHD_ALWAYS_INLINE MaskPair operator&(MaskPair a, MaskPair b)
{
  return { a.l && b.l, a.h && b.h };
}
AHD_ALWAYS_INLINE unsigned bits(MaskPair m)
{
  return (m.l ? 1u : 0u) + (m.h ? 2u : 0u);
}
AHD_ALWAYS_INLINE Pair choose(MaskPair m, Pair a, Pair b)
{
  return { m.l ? a.l : b.l, m.h ? a.h : b.h };
}
AHD_ALWAYS_INLINE Pair orZero(MaskPair m, Pair a)
{
  return choose(m, a, both(0.0));
}
AHD_ALWAYS_INLINE Pair larger(Pair a, Pair b)
{
  return choose(exceeds(a, b), a, b);
}
AHD_ALWAYS_INLINE Pair smaller(Pair a, Pair b)
{
  return choose(exceeds(b, a), a, b);
}
#endif

/// Two vectors.
struct VectorPair
{
  Pair x, y;
};

AHD_ALWAYS_INLINE Pair cross(const VectorPair& a, const VectorPair& b)
{
  return productLess(a.x, b.y, a.y * b.x);
}

/// Two points seen from P (Lifted).
struct LiftedPair : VectorPair
{
  Pair z;
};

AHD_ALWAYS_INLINE LiftedPair lifted(const VectorPair& v)
{
  return { v, multiplyAdd(v.x, v.x, v.y * v.y) };
}

/// A and B, each as a pair of its coordinates.
AHD_ALWAYS_INLINE LiftedPair lifted(Pair a, Pair b)
{
  return lifted(VectorPair{ lows(a, b), highs(a, b) });
}

/// `origin` is P twice.
AHD_ALWAYS_INLINE LiftedPair liftedFrom(const VectorPair& origin, const Point& a, const Point& b)
{
  const Pair first = coordinates(a), second = coordinates(b);
  return lifted(VectorPair{ lows(first, second) - origin.x, highs(first, second) - origin.y });
}

AHD_ALWAYS_INLINE LiftedPair lows(const LiftedPair& a, const LiftedPair& b)
{
  return { { lows(a.x, b.x), lows(a.y, b.y) }, lows(a.z, b.z) };
}
AHD_ALWAYS_INLINE LiftedPair highs(const LiftedPair& a, const LiftedPair& b)
{
  return { { highs(a.x, b.x), highs(a.y, b.y) }, highs(a.z, b.z) };
}

AHD_ALWAYS_INLINE Lifted lowOf(const LiftedPair& a)
{
  return { low(a.x), low(a.y), low(a.z) };
}
AHD_ALWAYS_INLINE Lifted highOf(const LiftedPair& a)
{
  return { high(a.x), high(a.y), high(a.z) };
}

/// Two edges, from A to B; `crossed` is cross(A, B).
struct EdgePair
{
  LiftedPair a, b;
  Pair crossed;
};

/// The edges A-C and C-B of the low (high) one of two edges and points.
AHD_ALWAYS_INLINE EdgePair lowEdges(const EdgePair& e, const LiftedPair& c)
{
  return { lows(e.a, c), lows(c, e.b), lows(cross(e.a, c), cross(c, e.b)) };
}
AHD_ALWAYS_INLINE EdgePair highEdges(const EdgePair& e, const LiftedPair& c)
{
  return { highs(e.a, c), highs(c, e.b), highs(cross(e.a, c), cross(c, e.b)) };
}

/// Which of two triangles has P in its circle. Bit 0 for the first, bit 1 for the second.
struct InCirclePair
{
  unsigned inside;  ///< where it is certain
  unsigned certain; ///< the others are for an exact predicate to decide
};

/// Of each triangle the first answer that is certain.
AHD_ALWAYS_INLINE InCirclePair orElse(InCirclePair first, InCirclePair second)
{
  return { (first.inside & first.certain) | (second.inside & ~first.certain),
    first.certain | second.certain };
}

/// Of each of two edges and points: the determinant of b, a, c, and a bound on its error. See
/// inCircle() and perturbedInCircle().
AHD_ALWAYS_INLINE Pair inCircleDeterminant(const EdgePair& e, const LiftedPair& c)
{
  const Pair u = productLess(e.a.z, e.b.y, e.b.z * e.a.y);
  const Pair v = productLess(e.b.z, e.a.x, e.a.z * e.b.x);
  return lessProduct(multiplyAdd(c.y, v, c.x * u), c.z, e.crossed);
}

AHD_ALWAYS_INLINE Pair inCircleErrorBound(const EdgePair& e, const LiftedPair& c, Pair guard)
{
  const Pair sum = multiplyAdd(e.a.z, e.b.z, c.z * (e.a.z + e.b.z));
  return multiplyAdd(both(kInCircleBound), sum, guard);
}

/// The square of a bound on its error that is tighter where one point is far nearer than the
/// others. See inCircle(). @pre guard >= inCircleSquaredGuard(A.z + B.z + C.z).
AHD_ALWAYS_INLINE Pair inCircleSquaredBound(const EdgePair& e, const LiftedPair& c, Pair guard)
{
  const Pair product = both(3.0 * kInCircleBound * kInCircleBound) * (e.a.z * e.b.z);
  return multiplyAdd(product, c.z * (e.a.z + e.b.z + c.z), guard);
}

/// For each of two edges a-b and a point c on its right: does P lie in the circle of b, a, c? That
/// is the sign of the determinant
///     A.z C x B + B.z A x C - C.z A x B  =  C.x u + C.y v - C.z A x B,
///     u = A.z B.y - B.z A.y,  v = B.z A.x - A.z B.x.
/// @pre guard >= inCircleSquaredGuard(A.z + B.z + C.z); if it is finite, all points are those
/// of a frame with kFrameExponent, so that nothing overflows (det^2 and the bound are below 2^772).
///
/// Proof, without underflow first. It is that of inCircleIsCertain, with C for the third vector,
/// but for these steps.
/// 2', 3. A.z B.y differs from the true product by a factor (1 + u)^5, the product's own rounding
///    and that of u make 7 factors, C.x and its product with u 9, their sum with C.y v 10; the last
///    sum keeps its sign. C.z A x B has 4 + 4 factors and its own.
/// 4. By the Cauchy-Schwarz inequality |C.x B.y| + |C.y B.x| <= c b, and the same with a: again the
///    error is below ((1 + u)^10 - 1) (a^2 b c + b^2 c a + c^2 a b) = E a b c (a + b + c).
/// 5'. (a + b + c)^2 <= 3 (a^2 + b^2 + c^2), so the error is at most F = 3^(1/2) E p^(1/2) with
///    p = a^2 b^2 c^2 (a^2 + b^2 + c^2). Squares are compared: the bound has less than 30
///    factors 1 + u, and 10.01 u exceeds E by 0.0009 E and more. So |det| > 1.0009 F.
/// Underflow in det: A.z, B.z, C.z and A x B may be wrong by 3e, each product by e more; what
///    multiplies these is at most a length or two: U < 24e (la + lb + lc + 1) in all. In the bound:
///    with M = la + lb + lc it loses at most e (M + 1)^2 (15 (3 (10.01 u)^2) (M + 1) + 1). With
///    m = 2^-40 M + 1, which is at least 2^-40 (M + 1), that is less than 2^-994 m^3, and the guard
///    is 2^34 times that. So what the comparison says is |det|^2 > (1.0009 F)^2 + 0.8 guard. If
///    U <= 0.0009 F, |det| > F + U by the former; else F + U < 1200 U < 2^-1020 m is less than the
///    root of the latter. det^2 itself is normal, as it is above the guard.
/// The ghost (kGhostDistance): with c its distance F is less than 10.1 u c^2 a b and the bound, by
///    its p^(1/2) >= c^2 a b, above 17.3 u c^2 a b, while |R| <= 2^-67 c^2 a b. So the certain
///    answer has the sign of alpha x beta.
AHD_ALWAYS_INLINE InCirclePair inCircle(const EdgePair& e, const LiftedPair& c, Pair guard)
{
  const Pair det = inCircleDeterminant(e, c);
  const Pair bound = inCircleSquaredBound(e, c, guard);
  return { signs(det) ^ 3u, bits(exceeds(det * det, bound)) };
}

/// Properties of points on a grid (Frame.h): determinants with bounds below this are exact.
struct Exactly
{
  double below;
  double perturbation;
};

/// What perturbedDeterminant() adds to the determinants of b, a, c.
AHD_ALWAYS_INLINE Pair perturbing(const EdgePair& e, const LiftedPair& c)
{
  const Pair column = both(kColumn);
  const Pair ofA = multiplyAdd(e.a.x, column, e.a.y);
  const Pair ofB = multiplyAdd(e.b.x, column, e.b.y);
  const Pair ofC = multiplyAdd(c.x, column, c.y);
  const Pair ofAB = larger(ofA, ofB);
  const Pair area = choose(exceeds(ofB, ofA), cross(e.a, c), cross(c, e.b));
  const Pair isC = both(0.0) - e.crossed;
  return choose(exceeds(ofC, larger(ofAB, both(0.0))), isC, smaller(area, ofAB));
}

/// The same for points on a grid, with the bound and the guard of inCircleIsCertain(). Determinants
/// that are exact there, by `exactly`, are certain, and where the determinant is 0 the answer is
/// whether P is in conflict with b, a, c (perturbedDeterminant()). @pre guard >= inCircleGuard(A.z
/// + B.z + C.z).
///
/// Proof of the bound: that of inCircleIsCertain() with the steps 2' to 4 of inCircle(); what
/// underflow costs there is far less than the guard, and on a grid nothing overflows.
/// Proof that the determinant is exact, where exactErrorBound() says so. In units, A, B, C are
/// integers other than 0 (no two points are the same, and the far ghost has too large a bound), so
/// a, b, c >= 1, and s < 2^53. The products in u and v are at most a^2 b and b^2 a, so at most
/// a^2 b^2 <= s. As (a - 1) (b - 1) >= 0, u and v are at most a b (a + b) <= a^2 b^2 + a b <= s, by
/// c^2 (a^2 + b^2) >= 2 a b. As s >= (a b)^2 + c^2 (a^2 + b^2) >= 2 a b c (a^2 + b^2)^(1/2), which
/// is at least 2^(1/2) a b c (a + b), C.x u and its sum with C.y v are at most c a b (a + b)
/// <= 0.71 s, C.z A x B is at most c^2 a b <= s / 2, the determinant 0.87 s. So all are integers
/// that a double represents, and so is each product, fused or not.
AHD_ALWAYS_INLINE InCirclePair perturbedInCircle(
  const EdgePair& e, const LiftedPair& c, Pair guard, const Exactly& exactly)
{
  const Pair det = inCircleDeterminant(e, c);
  const Pair bound = inCircleErrorBound(e, c, guard);
  const MaskPair isExact = exceeds(both(exactly.below), bound);
  const Pair added = orZero(isExact, perturbing(e, c));
  const Pair perturbed = multiplyAdd(added, both(exactly.perturbation), det);
  return { signs(perturbed) ^ 3u, magnitudeExceeds(det, bound) | bits(isExact) };
}

} // namespace AHD_TARGET
} // namespace ahd

#endif
