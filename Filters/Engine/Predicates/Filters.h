// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Filters_h
#define ahd_Filters_h

#include "../Core/Dispatch.h"
#include "../Points/Points.h"

#include <cfloat>
#include <cmath>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||     \
  (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error                                                                                             \
  "Compile the engine without -ffast-math, -Ofast and their parts: its results are exact only where each operation is rounded as written, and it looks for infinities and NaN."
#endif
#if FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2
#error                                                                                             \
  "Compile the engine for arithmetic in double precision (-mfpmath=sse, not 387): its error bounds do not hold where operations are rounded twice."
#endif

/// The floating-point filters: a determinant in plain double arithmetic and a bound on its error.
/// Where the determinant exceeds the bound its sign is the exact one ("certain"); everywhere else,
/// and for every NaN or infinity met on the way, the answer is "uncertain" and an exact predicate
/// has to decide.
///
/// Assumed: IEEE 754 doubles, rounding to nearest, subnormal numbers kept (no flush to zero), no
/// extended intermediate precision, no -ffast-math. Multiply-adds may be fused or not, and are
/// fused below where the machine has the instruction: no proof here depends on it.
///
/// Notation of the proofs: u = 2^-53 and e = 2^-1075. A sum or difference of two doubles has a
/// relative error of at most u and never underflows. A product, or a fused multiply-add, has a
/// relative error of at most u plus an absolute one of at most e, the latter only on underflow.
/// P is the query point; A, B, C are the rounded vectors from P to a, b, c; alpha, beta, gamma are
/// the true ones, each coordinate known to a factor 1 + u; |A| is a length, x the cross product.
namespace ahd
{
inline namespace AHD_TARGET
{

inline int signOf(double value)
{
  return (value > 0.0) - (value < 0.0);
}

/// A point seen from P, lifted to the paraboloid: z = |A|^2.
struct Lifted
{
  double x;
  double y;
  double z;
};

/// a * b + c, with one rounding where that is one instruction.
#if defined(__FMA__) || defined(__FP_FAST_FMA) || defined(AHD_FUSED_MULTIPLY_ADD)
constexpr bool kMultiplyAddIsFused = true;
inline double multiplyAdd(double a, double b, double c)
{
  return std::fma(a, b, c);
}
#else
constexpr bool kMultiplyAddIsFused = false;
inline double multiplyAdd(double a, double b, double c)
{
  return a * b + c;
}
#endif

inline double squaredLength(double x, double y)
{
  return multiplyAdd(x, x, y * y);
}

inline Lifted liftedFrom(const Point& origin, const Point& a)
{
  const double x = a.x - origin.x;
  const double y = a.y - origin.y;
  return { x, y, squaredLength(x, y) };
}

/// A x B, twice the area of P, a, b: positive iff they turn counterclockwise.
inline double cross(const Lifted& a, const Lifted& b)
{
  return multiplyAdd(a.x, b.y, -(a.y * b.x));
}

/// The in-circle determinant of a, b, c and P: for a, b, c counterclockwise, positive iff P lies
/// inside their circle. axb is cross(a, b), and so on.
inline double inCircleDeterminant(
  const Lifted& a, const Lifted& b, const Lifted& c, double axb, double bxc, double cxa)
{
  return multiplyAdd(a.z, bxc, multiplyAdd(b.z, cxa, c.z * axb));
}

inline double inCircleDeterminant(const Lifted& a, const Lifted& b, const Lifted& c, double axb)
{
  return inCircleDeterminant(a, b, c, axb, cross(b, c), cross(c, a));
}

/// Is the sign of A x B that of the true alpha x beta? `det` is cross(A, B), la and lb are |A|^2
/// and |B|^2 as squaredLength computes them.
///
/// Proof. Let d be the value whose rounding is det, l and r the two true products. Each carries
/// two roundings of coordinates and at most one of its own, so |d - (l - r)| is at most
/// ((1 + u)^3 - 1) (|l| + |r|) + 2e. By the Cauchy-Schwarz and the arithmetic-geometric inequality
/// |l| + |r| <= |alpha| |beta| <= (|alpha|^2 + |beta|^2) / 2. So the error is below
/// 1.5 u (1 + 2u) (|alpha|^2 + |beta|^2) + 2e. la + lb has lost at most a factor (1 - u)^5 and 4e;
/// the last rounding of det and those of the bound change a comparison by a factor of at most
/// (1 + u)^3 and an addend e. 1.501 u instead of 1.5 u pays for all factors, the guard for all
/// multiples of e (it is the smallest number that is not subnormal, as those are slow).
/// Overflow: |l|, |r| and |l - r| are at most (|alpha|^2 + |beta|^2) / 2, so whenever one of them
/// overflows la + lb does, and the comparison with infinity fails, as it does with NaN.
constexpr double kOrientBound = 1.501 * 0x1p-53;
constexpr double kOrientGuard = 0x1p-1022;

inline bool orientIsCertain(double det, double la, double lb)
{
  return std::fabs(det) > multiplyAdd(kOrientBound, la + lb, kOrientGuard);
}

/// Is the sign of the in-circle determinant that of the true one? `det` as inCircleDeterminant
/// computes it, or with a, b, c in another order. @pre guard >= inCircleGuard(la + lb + lc).
///
/// Proof, without underflow first. Write a, b, c for the true lengths |alpha|, |beta|, |gamma|.
/// 1. A.z is a^2 up to (1 + u)^4: two roundings of coordinates, the square, the sum.
/// 2. B x C differs from beta x gamma by at most ((1 + u)^4 - 1) b c: the same four roundings, and
///    the two products sum to at most b c in magnitude (Cauchy-Schwarz).
/// 3. So a term of the determinant has an error below ((1 + u)^9 - 1) a^2 b c, and the sum of two
///    of them one more factor 1 + u. The last sum is rounded too, but keeps its sign.
/// 4. The error is below ((1 + u)^10 - 1) (a^2 b c + b^2 c a + c^2 a b), and by the
///    arithmetic-geometric inequality that sum is at most s = a^2 b^2 + b^2 c^2 + c^2 a^2.
/// 5. The computed la * lb + lc * (la + lb) is at least s (1 - u)^12. 10.01 u instead of 10 u pays
///    for this, for the rounding of det and of the bound, and for 45 u^2 and what follows it.
/// Underflow: A.z and the cross products may each be wrong by 3e more, which the other factor of
/// their term multiplies, and each term by e more. As |B x C| <= (|B|^2 + |C|^2) / 2 that is less
/// than 8e (la + lb + lc + 1) in all, and what the bound loses is less. The guard is 2^52 as big.
/// Overflow: la * lb + lc * (la + lb) is computed before the small factor is applied, and it
/// overflows whenever anything in det does, so that the comparison with infinity fails, as it does
/// with NaN. For a cross product: (B x C)^2 <= lb lc. For the terms and their sums: a term is
/// (ab)(ac) |sin(b, c)|, the three together a quadratic form in ab, bc, ca whose symmetric matrix
/// has trace 0, so its largest eigenvalue is at most sqrt(2 / 3) of its norm, and that is
/// sqrt((the sum of the sin^2) / 2) <= sqrt(9 / 8) for three angles between lines of a plane. So
/// the magnitudes of the terms sum to at most 0.87 s.
constexpr double kInCircleBound = 10.01 * 0x1p-53;
constexpr double kInCircleGuard = 0x1p-1020;

/// The guard for lengths of at most this sum. One guard serves a whole point set: in its bounding
/// box no squared length exceeds that of the box's diagonal, roundings included, so
/// inCircleGuard(4 * squaredLength(xmax - xmin, ymax - ymin)) is enough. Infinite is legal: then
/// nothing is certain.
inline double inCircleGuard(double sumOfSquaredLengths)
{
  return kInCircleGuard * (sumOfSquaredLengths + 1.0); // in this order it is never subnormal
}

/// The guard of inCircleSquaredBound() (FilterPairs.h) for lengths of at most this sum. Infinite is
/// legal: then nothing is certain.
inline double inCircleSquaredGuard(double sumOfSquaredLengths)
{
  const double m = multiplyAdd(0x1p-40, sumOfSquaredLengths, 1.0);
  return 0x1p-960 * m * m * m;
}

inline double inCircleErrorBound(double la, double lb, double lc, double guard)
{
  return multiplyAdd(kInCircleBound, multiplyAdd(la, lb, lc * (la + lb)), guard);
}

inline bool inCircleIsCertain(double det, double la, double lb, double lc, double guard)
{
  return std::fabs(det) > inCircleErrorBound(la, lb, lc, guard);
}

/// The ghost, the vertex at infinity, may be a point: (0, g) with g = kGhostDistance * 2^e, where
/// all coordinates are below 2^e. Where the in-circle filter is certain, its answer for a triangle
/// with the ghost is then that for the ghost: p is in conflict with a, b and the ghost if a, b, p
/// turn counterclockwise. Where it is not, the orientation must be computed.
///
/// Proof. Let gamma be the vector to (0, g), D the true determinant. D = |gamma|^2 (alpha x beta) +
/// R with |R| <= |gamma| |alpha| |beta| (|alpha| + |beta|). With c = |gamma| >= 2^70 2^e (1 - u)
/// and |alpha|, |beta| <= 2^1.5 2^e that is |R| <= 2^-67 c^2 |alpha| |beta| <= 2^-68 s, as s is at
/// least c^2 (|alpha|^2 + |beta|^2). The error of the determinant, one triangle at a time or two
/// (FilterPairs.h), is at most ((1 + u)^10 - 1) s < 10 u s + 46 u^2 s. The bound, computed and
/// compared, stands for at least 10.01 u s (1 - u)^15 > 10.01 u s - 151 u^2 s. So it exceeds the
/// error by 0.009 u s > 2^-60 s, which is 2^8 times |R|: the computed determinant has the sign of
/// alpha x beta. Which of the three corners is the ghost does not affect s or R.
constexpr double kGhostDistance = 0x1p70;
/// All exponents of a point set's frame are at most this in magnitude: the coordinates are below
/// 2^e, |e| <= kFrameExponent, so that nothing overflows, squares of determinants with the ghost
/// included, and the guard, which has to be enough for the ghost, too, is at most 2^-758.
constexpr int kFrameExponent = 60;

/// The computed in-circle determinant of points whose coordinates are multiples of a `unit` is the
/// true one where its error bound, inCircleErrorBound(), is below this.
/// @pre no two coordinates, of x or of y, differ by more than kExactSpan units, and
/// unit >= 2^-200, so that no determinant underflows.
///
/// Proof. In units, A, B, C are integers of at most 2^25 in magnitude, so the differences are
/// exact, and products of two, and sums of two products, are integers below 2^53: lengths and cross
/// products are exact, with fused multiply-adds or without. The magnitudes of the terms of the
/// determinant sum to at most 0.87 s (inCircleIsCertain()), and s is below 2^53 units to the fourth
/// power, as the bound is above 10 u s. So every term and every partial sum is an integer that a
/// double represents.
constexpr double kExactSpan = 0x1p25;

inline double exactErrorBound(double unit)
{
  return 10.0 * ((unit * unit) * (unit * unit));
}

/// The determinant of points for which it is exact (exactErrorBound()), where it is 0 raised or
/// lowered by less than the least that is not 0: positive iff P is in conflict with a, b, c, which
/// turn counterclockwise. axb is cross(a, b), and so on; `perturbation` is perturbationFor(unit).
///
/// If the determinant is 0 the largest of the four points in lexicographic order decides: for P the
/// answer is no, for the others it is the sign of the area of the triangle that P makes with the
/// other two (conflictOnCircle() in Stages.h). y is less than 2^26 units apart, so x * 2^26 + y,
/// which is exact, is larger for the larger point; P has 0. The deciding number is below 2^52 units
/// or square units, and the perturbation scales it to less than a quarter of a unit to the fourth
/// power. No branches, as they would be unpredictable.
constexpr double kColumn = 0x1p26;

inline double perturbedDeterminant(double det, const Lifted& a, const Lifted& b, const Lifted& c,
  double axb, double bxc, double cxa, double perturbation)
{
  const double ofA = multiplyAdd(a.x, kColumn, a.y);
  const double ofB = multiplyAdd(b.x, kColumn, b.y);
  const double ofC = multiplyAdd(c.x, kColumn, c.y);
  const double ofAB = ofA > ofB ? ofA : ofB;
  const double ofABP = ofAB > 0.0 ? ofAB : 0.0;
  const double area = ofA > ofB ? bxc : cxa;
  const double decides = area < ofAB ? area : ofAB; // negative if P is larger than A and B
  return multiplyAdd(ofC > ofABP ? axb : decides, perturbation, det);
}

inline double perturbationFor(double unit)
{
  const double square = unit * unit;
  return 0x1p-54 * square * (unit < 1.0 ? unit : 1.0);
}

/// Are these the corners of a rectangle with sides along the axes, p opposite of `far`?
inline bool isRectangle(const Point& p, const Point& far, const Point& a, const Point& b)
{
  return ((a.x == p.x) & (b.y == p.y) & (b.x == far.x) & (a.y == far.y)) |
    ((b.x == p.x) & (a.y == p.y) & (a.x == far.x) & (b.y == far.y));
}

/// Neighbours in a grid are the corners of a rectangle, however coordinates were rounded. Is p, if
/// these are, in conflict with a, b, c, which turn counterclockwise: 1 yes, -1 no? 0: these are
/// not.
///
/// The largest corner decides (conflictOnCircle() in Stages.h). If that is p or opposite of p, the
/// answer is no: the opposite corner sees p on the wrong side of its edge. For both others it is
/// yes.
inline int conflictInRectangle(const Point& a, const Point& b, const Point& c, const Point& p)
{
  if (!((a.x == p.x) | (b.x == p.x) | (c.x == p.x)))
  {
    return 0;
  }
  const Point* const far = isRectangle(p, c, a, b) ? &c
    : isRectangle(p, a, b, c)                      ? &a
    : isRectangle(p, b, c, a)                      ? &b
                                                   : nullptr;
  return !far ? 0 : (far->x > p.x) != (far->y > p.y) ? 1 : -1;
}

} // namespace AHD_TARGET
} // namespace ahd

#endif
