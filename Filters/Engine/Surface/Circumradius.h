// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Circumradius_h
#define ahd_Circumradius_h

#include "../Points/Points.h"
#include "Vectors.h"

#include <algorithm>
#include <cmath>

namespace ahd
{

inline Vector3 minus(const Vector3& a, const Vector3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

/// Is the square of a length far from overflow and underflow?
inline bool isOrdinarySquare(double square)
{
  return square > 1e-290 && square < 1e300;
}

/// The length of a vector. Neither overflows nor underflows before it has to.
double lengthOf(const Vector3& v);

/// The radius of the circle through three points in space; 1e299 if it is larger or there is none,
/// as they are collinear. Neither overflows nor underflows before that.
double circumradius(const Vector3& a, const Vector3& b, const Vector3& c);

/// Tells whether circumradius() > limit, by squares where they decide.
class RadiusLimit
{
public:
  explicit RadiusLimit(double limit);

  bool isExceeded(const Vector3& a, const Vector3& b, const Vector3& c) const;

private:
  double limit_;
  double square_;   ///< of twice the limit
  bool isModerate_; ///< neither squares nor their products overflow or underflow
};

/// Tells whether lengthOf() > limit, by squares where these are in range.
class LengthLimit
{
public:
  explicit LengthLimit(double limit);

  bool isExceeded(const Vector3& v) const;
  /// By two points of the plane.
  bool isExceeded(const Point& p, const Point& q) const
  {
    return isExceeded(Vector3{ { p.x - q.x, p.y - q.y, 0.0 } });
  }
  /// By a side of the triangle of three points of the plane, which are finite.
  bool isExceeded(const Point& a, const Point& b, const Point& c) const
  {
    const double ab = squareOf(a, b), bc = squareOf(b, c), ca = squareOf(c, a);
    const double longest = std::max(ab, std::max(bc, ca));
    return isModerate_ && isOrdinarySquare(std::min(ab, std::min(bc, ca))) &&
        isOrdinarySquare(longest)
      ? longest > largest_
      : isExceeded(a, b) || isExceeded(b, c) || isExceeded(c, a);
  }

private:
  static double squareOf(const Point& p, const Point& q)
  {
    return dot(Vector3{ { p.x - q.x, p.y - q.y, 0.0 } }, Vector3{ { p.x - q.x, p.y - q.y, 0.0 } });
  }

  double limit_;
  double largest_;  ///< square whose root, rounded, is not greater than the limit
  bool isModerate_; ///< the square is in range
};

/// With u = 2^-53, and L the longest side: a side is off by u of itself, a component of the cross
/// product of any two by less than 6 u L^2, so the area of the parallelogram by less than 11 u L^2,
/// whichever two; circumradius() takes those at the corner opposite to L. If the area is at least
/// 1e-3 L^2, the two areas differ by less than 22e3 u < 3e-12 of it. All other operations, here and
/// there, are off by less than 20 u in sum. So if the squares differ by more than 1e-9 of the
/// larger one, the radii differ in the same direction.
inline bool RadiusLimit::isExceeded(const Vector3& a, const Vector3& b, const Vector3& c) const
{
  const Vector3 u = minus(b, a), v = minus(c, b), w = minus(a, c);
  const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const Vector3 normal = cross(u, v);
  const double area = dot(normal, normal);
  const double longest = std::max(uu, std::max(vv, ww));
  const double shortest = std::min(uu, std::min(vv, ww));
  const double product = uu * vv * ww;
  const double bound = square_ * area;
  const bool isSure = isModerate_ && shortest > 1e-80 && longest < 1e80 &&
    area > 1e-6 * (longest * longest) && std::abs(product - bound) > 1e-9 * (product + bound);
  return isSure ? product > bound : circumradius(a, b, c) > limit_;
}

/// Roots, rounded, keep the order.
inline bool LengthLimit::isExceeded(const Vector3& v) const
{
  const double square = dot(v, v);
  return isModerate_ && isOrdinarySquare(square) ? square > largest_ : lengthOf(v) > limit_;
}

} // namespace ahd

#endif
