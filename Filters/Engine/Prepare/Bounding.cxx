// SPDX-License-Identifier: BSD-3-Clause
#include "Bounding.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace ahd
{
namespace
{

/// Sums and products in half the size, so that only the result can overflow.
double finiteDouble(double half)
{
  return std::max(-DBL_MAX, std::min(half * 2, DBL_MAX));
}

} // namespace

std::array<Vector3, 8> boundingPoints(const Vector3& low, const Vector3& high, double offset)
{
  Vector3 halfCentre;
  Vector3 halfSize;
  for (std::size_t k = 0; k < 3; ++k)
  {
    halfCentre[k] = (low[k] / 2 + high[k] / 2) / 2;
    halfSize[k] = high[k] / 2 - low[k] / 2;
  }
  // not by the library's cosine, which differs from system to system
  const double diagonal = 0.5 * std::sqrt(2.0);
  const double x[8] = { 1, diagonal, 0, -diagonal, -1, -diagonal, 0, diagonal };
  const double largest = std::max({ halfSize[0], halfSize[1], halfSize[2], DBL_MIN });
  double squares = 0.0;
  for (double size : halfSize)
  {
    squares += (size / largest) * (size / largest);
  }
  const double halfRadius = halfSize == Vector3{ { 0, 0, 0 } }
    ? 0.0
    : std::sqrt(squares) * largest * offset;
  std::array<Vector3, 8> points;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const double halfX = x[i] == 0 ? 0.0 : x[i] * halfRadius;
    const double halfY = x[(i + 6) % 8] == 0 ? 0.0 : x[(i + 6) % 8] * halfRadius;
    points[i] = { { finiteDouble(halfCentre[0] + halfX), finiteDouble(halfCentre[1] + halfY),
      finiteDouble(halfCentre[2]) } };
  }
  return points;
}

} // namespace ahd
