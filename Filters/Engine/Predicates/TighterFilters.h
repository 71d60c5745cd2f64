// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TighterFilters_h
#define ahd_TighterFilters_h

#include "Filters.h"

#include <algorithm>
#include <optional>

/// Filters for cases that Filters.h leaves open: each takes a few nanoseconds more and decides
/// nearly all of them, slivers above all. Assumptions and notation are the same. No value means
/// that only an exact predicate can decide.
namespace ahd
{
inline namespace AHD_TARGET
{

/// Three points as they are seen from P.
struct SeenTriangle
{
  Lifted a, b, c;
  double sum; ///< of their squared distances

  SeenTriangle(const Point& p, const Point& pa, const Point& pb, const Point& pc)
    : a(liftedFrom(p, pa))
    , b(liftedFrom(p, pb))
    , c(liftedFrom(p, pc))
    , sum(a.z + b.z + c.z)
  {
  }

  /// Are all distances between about 2^-110 and 2^110? No where one is infinite or NaN.
  bool isOfMiddleSize() const
  {
    return (std::min(a.z, std::min(b.z, c.z)) >= 0x1p-220) & (sum <= 0x1p220);
  }
};

/// The sign of the in-circle determinant, by the bound of inCircleIsCertain() before its step from
/// products of lengths to their squares, which loses much where one point is far nearer than the
/// others. That of pairs (inCircleSquaredBound()) is the same; this one is for points on a grid and
/// those that no scale brings into a frame, and its guard is less.
///
/// Proof, continued from step 4 there: the error is below ((1 + u)^10 - 1) a b c (a + b + c), and
/// (a + b + c)^2 <= 3 (a^2 + b^2 + c^2). The squares of both are compared; their roundings,
/// some 20 factors 1 + u, are paid for by 10.01 in place of 10. Of middle size, the product is
/// between 2^-880 and 2^881, with its factor above 2^-980, and |det| below 2^442: nothing
/// overflows, and what underflows in det, e times a length or two, is below 2^-850, while a 2^-10th
/// of the bound is above 2^-500.
inline std::optional<int> inCircleByLengths(
  const Point& a, const Point& b, const Point& c, const Point& p)
{
  const SeenTriangle seen(p, a, b, c);
  const double det = inCircleDeterminant(seen.a, seen.b, seen.c, cross(seen.a, seen.b));
  const double product = (seen.a.z * seen.b.z) * (seen.c.z * seen.sum);
  const bool isCertain = det * det > 3.0 * kInCircleBound * kInCircleBound * product;
  return isCertain && seen.isOfMiddleSize() ? std::optional<int>(signOf(det)) : std::nullopt;
}

#if defined(__FMA__) || defined(__FP_FAST_FMA) || defined(AHD_FUSED_MULTIPLY_ADD)
/// Is `difference`, a - b rounded, a - b? One of the two sums is exact: that with the larger of a
/// and b (Dekker 1971).
inline bool isExactDifference(double a, double b, double difference)
{
  return (a - difference == b) & (b + difference == a);
}

inline bool isSeenExactly(const Point& p, const Point& a, const Lifted& seen)
{
  return isExactDifference(a.x, p.x, seen.x) && isExactDifference(a.y, p.y, seen.y);
}

/// A x B with a relative error of at most 2u, however much of it cancels, if nothing underflows or
/// overflows: Kahan's algorithm (Jeannerod, Louvet, Muller, Mathematics of Computation 82, 2013).
inline double sharpCross(const Lifted& a, const Lifted& b)
{
  const double right = a.y * b.x;
  const double lost = std::fma(a.y, b.x, -right);
  return std::fma(a.x, b.y, -right) - lost;
}

/// The sign of the in-circle determinant where all coordinates are seen exactly, as those of points
/// near each other are: on a line that is rounded, too.
///
/// Proof. A.z has a relative error of at most 2u and each cross product one of 2u, so a term,
/// rounded, one of 5u + 11 u^2, and the sum of two is rounded once more; the last sum keeps its
/// sign. So the error is below 6.01 u times the sum of the magnitudes of the terms, and 8u pays for
/// what that sum has lost. Of middle size nothing overflows; an underflow in a cross product, of a
/// few e, is multiplied by less than 2^220.
inline std::optional<int> inCircleBySharpCrosses(
  const Point& a, const Point& b, const Point& c, const Point& p)
{
  const SeenTriangle seen(p, a, b, c);
  if (!(seen.isOfMiddleSize() && isSeenExactly(p, a, seen.a) && isSeenExactly(p, b, seen.b) &&
        isSeenExactly(p, c, seen.c)))
  {
    return std::nullopt;
  }
  const double ofA = seen.a.z * sharpCross(seen.b, seen.c);
  const double ofB = seen.b.z * sharpCross(seen.c, seen.a);
  const double ofC = seen.c.z * sharpCross(seen.a, seen.b);
  const double det = ofA + ofB + ofC;
  const double sum = std::fabs(ofA) + std::fabs(ofB) + std::fabs(ofC);
  const bool isCertain = std::fabs(det) > 0x1p-50 * sum + 0x1p-800;
  return isCertain ? std::optional<int>(signOf(det)) : std::nullopt;
}

/// The sign of the orientation of a, b, p, 0 included, where a and b are seen exactly: that of the
/// cross product, as its error is a part of it.
///
/// Nothing that counts underflows or overflows: between the limits the product A.y B.x and what its
/// rounding loses are representable; if A.x B.y is so small that it loses bits, or so large that it
/// overflows, it is the other one by far that gives the sign, or it itself.
inline std::optional<int> orient2dBySharpCross(const Point& a, const Point& b, const Point& p)
{
  const Lifted A = liftedFrom(p, a), B = liftedFrom(p, b);
  const double right = std::fabs(A.y * B.x);
  const bool isCertain = isSeenExactly(p, a, A) && isSeenExactly(p, b, B) && right > 0x1p-900 &&
    right < 0x1p900;
  return isCertain ? std::optional<int>(signOf(sharpCross(A, B))) : std::nullopt;
}
#else
// Without fused multiply-adds they would take as long as the exact predicates.
inline std::optional<int> inCircleBySharpCrosses(
  const Point&, const Point&, const Point&, const Point&)
{
  return std::nullopt;
}
inline std::optional<int> orient2dBySharpCross(const Point&, const Point&, const Point&)
{
  return std::nullopt;
}
#endif

} // namespace AHD_TARGET
} // namespace ahd

#endif
