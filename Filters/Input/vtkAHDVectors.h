// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDVectors_h
#define vtkAHDVectors_h

#include <array>
#include <cmath>
#include <cstddef>

/// Three numbers, and three rows of them.
using vtkAHDVector = std::array<double, 3>;
using vtkAHDMatrix = std::array<vtkAHDVector, 3>;

inline double vtkAHDDot(const vtkAHDVector& a, const vtkAHDVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline vtkAHDVector vtkAHDCross(const vtkAHDVector& a, const vtkAHDVector& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

/// The part of `a` at right angles to the unit vector `n`, one long. REQUIRES: not parallel.
inline vtkAHDVector vtkAHDPerpendicular(const vtkAHDVector& a, const vtkAHDVector& n)
{
  const double along = vtkAHDDot(a, n);
  vtkAHDVector rest = { { a[0] - along * n[0], a[1] - along * n[1], a[2] - along * n[2] } };
  const double length = std::sqrt(vtkAHDDot(rest, rest));
  for (double& component : rest)
  {
    component /= length;
  }
  return rest;
}

inline vtkAHDVector vtkAHDUnitAxis(std::size_t k)
{
  vtkAHDVector axis = { { 0, 0, 0 } };
  axis[k % 3] = 1.0;
  return axis;
}

#endif
