// SPDX-License-Identifier: BSD-3-Clause
#include "Predicates.h"

#include "../Arithmetic/WideVectors.h"
#include "Filters.h"
#include "Stages.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

namespace ahd
{
namespace stages
{
namespace
{

using ahd::signOf; // beside that of integers

// -------------------------------------------------------------------------------------------- Grid

#ifdef AHD_HAS_INT128

int signOf(Int128 value)
{
  return (value > 0) - (value < 0);
}

/// A vector in units of the grid. Coordinates are below 2^62 in magnitude, those of a difference of
/// two below 2^63, so that cross and dot products stay below 2^127.
struct GridVector
{
  std::int64_t x;
  std::int64_t y;
};

/// A scale that makes a value less than 2^61, and its reciprocal, both powers of two.
struct GridScale
{
  double up;
  double down;

  /// @pre 2^-900 <= largest <= 2^1000, so that neither scale overflows.
  explicit GridScale(double largest)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &largest, sizeof bits);
    const std::uint64_t exponent = bits >> 52; // biased by 1023
    const std::uint64_t upBits = (2 * 1023 + 60 - exponent) << 52;
    const std::uint64_t downBits = (exponent - 60) << 52;
    std::memcpy(&up, &upBits, sizeof up);
    std::memcpy(&down, &downBits, sizeof down);
  }

  /// value in units of `down`. `residue` stays 0 while all values are integers: one that is not, or
  /// whose product underflows, differs when scaled back; scaling back rounds nothing, as `down` is
  /// at least 2^-961.
  std::int64_t integer(double value, double& residue) const
  {
    const auto result = static_cast<std::int64_t>(value * up);
    residue += std::fabs(static_cast<double>(result) * down - value);
    return result;
  }
};

/// a - b = high + low exactly, high being the rounded difference (Knuth's error of a sum).
struct ExactDifference
{
  double high;
  double low;

  ExactDifference(double a, double b)
    : high(a - b)
  {
    const double bTaken = a - high;
    const double aTaken = high + bTaken;
    low = (a - aTaken) + (bTaken - b);
  }
};

/// The vectors from an origin to `Count` points, in units of one power of two.
template <std::size_t Count>
class Grid
{
public:
  /// False if they do not fit.
  bool fit(const Point& origin, const Point* const (&points)[Count]);
  const GridVector& operator[](int i) const { return vectors_[i]; }

private:
  GridVector vectors_[Count];
};

template <std::size_t Count>
bool Grid<Count>::fit(const Point& origin, const Point* const (&points)[Count])
{
  double x[Count], y[Count], lowX[Count], lowY[Count];
  double largest = 0.0, rounded = 0.0;
  for (std::size_t i = 0; i < Count; ++i)
  {
    const ExactDifference dx(points[i]->x, origin.x), dy(points[i]->y, origin.y);
    x[i] = dx.high;
    y[i] = dy.high;
    lowX[i] = dx.low;
    lowY[i] = dy.low;
    largest = std::max(largest, std::max(std::fabs(x[i]), std::fabs(y[i])));
    rounded += std::fabs(lowX[i]) + std::fabs(lowY[i]);
  }
  if (!(largest >= 0x1p-900 && largest <= 0x1p+1000))
  {
    return false;
  }
  const GridScale scale(largest);
  double residue = 0.0;
  for (std::size_t i = 0; i < Count; ++i)
  {
    vectors_[i].x = scale.integer(x[i], residue);
    vectors_[i].y = scale.integer(y[i], residue);
  }
  if (rounded != 0.0)
  {
    for (std::size_t i = 0; i < Count; ++i)
    {
      vectors_[i].x += scale.integer(lowX[i], residue);
      vectors_[i].y += scale.integer(lowY[i], residue);
    }
  }
  return residue == 0.0;
}

GridVector operator-(const GridVector& a, const GridVector& b)
{
  return { a.x - b.x, a.y - b.y };
}

/// A x B.
Int128 crossOnGrid(const GridVector& a, const GridVector& b)
{
  return Int128(a.x) * b.y - Int128(a.y) * b.x;
}

/// A . B.
Int128 dotOnGrid(const GridVector& a, const GridVector& b)
{
  return Int128(a.x) * b.x + Int128(a.y) * b.y;
}

/// a * b in two's complement. The words of a negative number are those of the number + 2^128.
struct Product256
{
  Int128 high;
  UInt128 low;

  Product256(Int128 a, Int128 b)
  {
    const std::uint64_t a0 = std::uint64_t(a), a1 = std::uint64_t(a >> 64);
    const std::uint64_t b0 = std::uint64_t(b), b1 = std::uint64_t(b >> 64);
    const UInt128 p00 = UInt128(a0) * b0, p01 = UInt128(a0) * b1;
    const UInt128 p10 = UInt128(a1) * b0, p11 = UInt128(a1) * b1;
    const UInt128 middle = p10 + (p00 >> 64) + std::uint64_t(p01); // at most 2^128 - 1
    low = (middle << 64) | std::uint64_t(p00);
    const UInt128 unsignedHigh = p11 + (middle >> 64) + (p01 >> 64);
    high = Int128(
      unsignedHigh - (UInt128(a >> 127) & UInt128(b)) - (UInt128(b >> 127) & UInt128(a)));
  }
};

/// The sign of a - b.
int compare(const Product256& a, const Product256& b)
{
  return a.high != b.high ? (a.high < b.high ? -1 : 1) : (a.low > b.low) - (a.low < b.low);
}

#endif // AHD_HAS_INT128

} // namespace

// ---------------------------------------------------------------------------------------- orient2d

/// The products themselves give a tighter bound here than squared lengths (Filters.h): their error
/// is at most 3 u (1 + 2u) (|l| + |r|) + 2e.
std::optional<int> orient2dByFilter(const Point& a, const Point& b, const Point& c)
{
  const double l = (a.x - c.x) * (b.y - c.y);
  const double r = (a.y - c.y) * (b.x - c.x);
  const double det = l - r;
  if (std::fabs(det) > 2.0 * kOrientBound * (std::fabs(l) + std::fabs(r)) + kOrientGuard)
  {
    return signOf(det);
  }
  return std::nullopt;
}

std::optional<int> orient2dOnGrid(
  [[maybe_unused]] const Point& a, [[maybe_unused]] const Point& b, [[maybe_unused]] const Point& c)
{
#ifdef AHD_HAS_INT128
  Grid<2> grid;
  if (grid.fit(c, { &a, &b }))
  {
    return signOf(crossOnGrid(grid[0], grid[1]));
  }
#endif
  return std::nullopt;
}

int orient2dUnbounded(const Point& a, const Point& b, const Point& c)
{
  const Unit unit{ &a, &b, &c };
  return crossUnbounded(WideVector(unit, c, a), WideVector(unit, c, b)).sign();
}

// ---------------------------------------------------------------------------------------- flatness

/// Each of the four products has three roundings, the cross and the dot product one more, five
/// times the cross product and the sum another each: the error is at most ((1 + u)^6 - 1) (5 |l| +
/// 5 |r| + 2 |p| + 2 |q|) + 14e. 8 u pays for the rounding of the bound, the guard for all
/// multiples of e. Where something overflows the bound does, or the sum is NaN, and the comparison
/// fails.
std::optional<int> flatnessByFilter(const Point& a, const Point& b, const Point& c)
{
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  const double l = ax * by, r = ay * bx, p = ax * bx, q = ay * by;
  const double sum = 5.0 * (l - r) + 2.0 * (p + q);
  const double size = 5.0 * (std::fabs(l) + std::fabs(r)) + 2.0 * (std::fabs(p) + std::fabs(q));
  if (std::fabs(sum) > 8.0 * 0x1p-53 * size + kOrientGuard)
  {
    return signOf(sum);
  }
  return std::nullopt;
}

/// Five times a cross product may have 131 bits.
std::optional<int> flatnessOnGrid(
  [[maybe_unused]] const Point& a, [[maybe_unused]] const Point& b, [[maybe_unused]] const Point& c)
{
#ifdef AHD_HAS_INT128
  Grid<2> grid;
  if (grid.fit(c, { &a, &b }))
  {
    return compare(
      Product256(crossOnGrid(grid[0], grid[1]), 5), Product256(dotOnGrid(grid[0], grid[1]), -2));
  }
#endif
  return std::nullopt;
}

int flatnessUnbounded(const Point& a, const Point& b, const Point& c)
{
  const Unit unit{ &a, &b, &c };
  const WideVector A(unit, c, a), B(unit, c, b);
  const auto cross = crossUnbounded(A, B);
  const auto half = cross + cross + dotUnbounded(A, B); // less half a cross product
  return (half + half + cross).sign();
}

// ---------------------------------------------------------------------------------------- inCircle

std::optional<int> inCircleByFilter(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const Lifted A = liftedFrom(d, a);
  const Lifted B = liftedFrom(d, b);
  const Lifted C = liftedFrom(d, c);
  const double det = inCircleDeterminant(A, B, C, cross(A, B));
  if (inCircleIsCertain(det, A.z, B.z, C.z, inCircleGuard(A.z + B.z + C.z)))
  {
    return signOf(det);
  }
  return std::nullopt;
}

// The exact stages compute the in-circle determinant in another form, with fewer products. Let A,
// B, C run from d to a, b, c, and U = A - C, V = B - C from c to a, b. Then
//   |A|^2 (B x C) + |B|^2 (C x A) + |C|^2 (A x B)  =  (A x B)(U . V) - (U x V)(A . B).
// Proof: on the right U . V = A . B - A . C - B . C + |C|^2 and U x V = A x B + B x C + C x A. On
// the left A (B x C) + B (C x A) + C (A x B) = 0, multiplied by A and by B, replaces |A|^2 (B x C)
// and |B|^2 (C x A). The right side compares the angles under which d and c see the edge a, b.

std::optional<int> inCircleOnGrid([[maybe_unused]] const Point& a, [[maybe_unused]] const Point& b,
  [[maybe_unused]] const Point& c, [[maybe_unused]] const Point& d)
{
#ifdef AHD_HAS_INT128
  Grid<3> grid;
  if (grid.fit(d, { &a, &b, &c }))
  {
    const GridVector &A = grid[0], &B = grid[1], &C = grid[2];
    const GridVector U = A - C, V = B - C;
    return compare(Product256(crossOnGrid(A, B), dotOnGrid(U, V)),
      Product256(crossOnGrid(U, V), dotOnGrid(A, B)));
  }
#endif
  return std::nullopt;
}

int inCircleUnbounded(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const Unit unit{ &a, &b, &c, &d };
  const WideVector A(unit, d, a), B(unit, d, b);
  const WideVector U(unit, c, a), V(unit, c, b);
  const auto first = crossUnbounded(A, B) * dotUnbounded(U, V);
  const auto second = crossUnbounded(U, V) * dotUnbounded(A, B);
  return (first - second).sign();
}

// -------------------------------------------------------------------------------------- inConflict

/// Let the lifted height |p|^2 of each point be raised by an infinitesimal, that of a larger point
/// in lexicographic order by infinitely more than those of all smaller ones. The in-circle
/// determinant is linear in the heights: it says by how much d lies below the plane through the
/// lifted a, b, c, times their area, so that the heights of a, b, c, d have the coefficients
/// orient2d(b, c, d), orient2d(c, a, d), orient2d(a, b, d) and -orient2d(a, b, c). Where the
/// unraised heights cancel, the coefficient of the largest point decides. It is not 0, as no three
/// of four distinct points of a circle are collinear.
bool conflictOnCircle(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const Point* largest = &a;
  for (const Point* p : { &b, &c, &d })
  {
    largest = lexicographicallyLess(*largest, *p) ? p : largest;
  }
  if (largest == &d)
  {
    return false;
  }
  if (largest == &c)
  {
    return orient2d(a, b, d) > 0;
  }
  return (largest == &b ? orient2d(c, a, d) : orient2d(b, c, d)) > 0;
}

} // namespace stages

int orient2dExact(const Point& a, const Point& b, const Point& c)
{
  const std::optional<int> sign = stages::orient2dOnGrid(a, b, c);
  return sign ? *sign : stages::orient2dUnbounded(a, b, c);
}

int orient2d(const Point& a, const Point& b, const Point& c)
{
  const std::optional<int> sign = stages::orient2dByFilter(a, b, c);
  return sign ? *sign : orient2dExact(a, b, c);
}

bool isFlat(const Point& a, const Point& b, const Point& c)
{
  std::optional<int> sign = stages::flatnessByFilter(a, b, c);
  sign = sign ? sign : stages::flatnessOnGrid(a, b, c);
  return (sign ? *sign : stages::flatnessUnbounded(a, b, c)) < 0;
}

int inCircleExact(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const std::optional<int> sign = stages::inCircleOnGrid(a, b, c, d);
  return sign ? *sign : stages::inCircleUnbounded(a, b, c, d);
}

int inCircle(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const std::optional<int> sign = stages::inCircleByFilter(a, b, c, d);
  return sign ? *sign : inCircleExact(a, b, c, d);
}

bool inConflictExact(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const int sign = inCircleExact(a, b, c, d);
  return sign != 0 ? sign > 0 : stages::conflictOnCircle(a, b, c, d);
}

bool inConflict(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const std::optional<int> sign = stages::inCircleByFilter(a, b, c, d);
  return sign ? *sign > 0 : inConflictExact(a, b, c, d);
}

} // namespace ahd
