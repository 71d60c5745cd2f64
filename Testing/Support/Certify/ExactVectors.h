// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ExactVectors_h
#define ahd_ExactVectors_h

#include "Points/Points.h"

#include <gmpxx.h>

namespace ahd
{
namespace test
{

/// Vectors in rational arithmetic, for oracles. Users must link GMP.
struct Vector
{
  mpq_class x, y;
};

inline Vector between(const Point& from, const Point& to)
{
  return { mpq_class(to.x) - mpq_class(from.x), mpq_class(to.y) - mpq_class(from.y) };
}

inline mpq_class cross(const Vector& a, const Vector& b)
{
  return a.x * b.y - a.y * b.x;
}

/// The position on the ray from p along d, in lengths of d, where it meets the inside of the
/// segment a-b. Negative if it does not, also if only an end touches the ray's line.
inline mpq_class meeting(const Point& p, const Vector& d, const Point& a, const Point& b)
{
  const Vector toA = between(p, a);
  const Vector along = between(a, b);
  const int sideOfA = sgn(cross(d, toA));
  const int sideOfB = sgn(cross(d, between(p, b)));
  return sideOfA * sideOfB < 0 ? mpq_class(cross(toA, along) / cross(d, along)) : mpq_class(-1);
}

} // namespace test
} // namespace ahd

#endif
