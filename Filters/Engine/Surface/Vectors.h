// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Vectors_h
#define ahd_Vectors_h

#include <array>
#include <cmath>
#include <cstddef>

namespace ahd
{

/// Three numbers, and three rows of them.
using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;

inline double dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 cross(const Vector3& a, const Vector3& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

/// The part of `a` at right angles to the unit vector `n`, one long. @pre not parallel.
inline Vector3 perpendicular(const Vector3& a, const Vector3& n)
{
  const double along = dot(a, n);
  Vector3 rest = { { a[0] - along * n[0], a[1] - along * n[1], a[2] - along * n[2] } };
  const double length = std::sqrt(dot(rest, rest));
  for (double& component : rest)
  {
    component /= length;
  }
  return rest;
}

inline Vector3 unitAxis(std::size_t k)
{
  Vector3 axis = { { 0, 0, 0 } };
  axis[k % 3] = 1.0;
  return axis;
}

} // namespace ahd

#endif
