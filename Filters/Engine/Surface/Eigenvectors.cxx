// SPDX-License-Identifier: BSD-3-Clause
#include "Eigenvectors.h"

#include <cmath>
#include <cstddef>

namespace ahd
{
namespace
{

/// Turns columns p and q of `vectors` so that element p, q of `a` becomes zero: one step of
/// Jacobi's method. @pre the element is not zero.
void rotate(Matrix3& a, Matrix3& vectors, std::size_t p, std::size_t q)
{
  const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = (theta < 0 ? -1.0 : 1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  const std::size_t r = 3 - p - q;
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0.0;
  const double rp = a[r][p];
  const double rq = a[r][q];
  a[r][p] = a[p][r] = c * rp - s * rq;
  a[r][q] = a[q][r] = s * rp + c * rq;
  for (Vector3& row : vectors)
  {
    const double vp = row[p];
    const double vq = row[q];
    row[p] = c * vp - s * vq;
    row[q] = s * vp + c * vq;
  }
}

} // namespace

Matrix3 findEigenvectors(Matrix3& a)
{
  Matrix3 vectors = { { unitAxis(0), unitAxis(1), unitAxis(2) } };
  constexpr int kMostSweeps = 50; // 5 to 8 do
  for (int sweep = 0; sweep < kMostSweeps; ++sweep)
  {
    bool turned = false;
    for (std::size_t r = 0; r < 3; ++r)
    {
      const std::size_t p = r == 0 ? 1 : 0;
      const std::size_t q = r == 2 ? 1 : 2;
      const double both = std::sqrt(std::fabs(a[p][p])) * std::sqrt(std::fabs(a[q][q]));
      if (std::fabs(a[p][q]) > 0x1p-54 * both)
      {
        rotate(a, vectors, p, q);
        turned = true;
      }
    }
    if (!turned)
    {
      break;
    }
  }
  return vectors;
}

} // namespace ahd
