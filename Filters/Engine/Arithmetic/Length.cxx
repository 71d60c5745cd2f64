// SPDX-License-Identifier: BSD-3-Clause
#include "Length.h"

#include "DoubleDouble.h"

#include <algorithm>
#include <cmath>

namespace ahd
{

double scaleOf(double length)
{
  if (length > 1e-60 && length < 1e60)
  {
    return 1.0;
  }
  int exponent = 0;
  std::frexp(length, &exponent);
  return std::ldexp(1.0, std::min(std::max(-exponent, -1020), 1020));
}

double lengthOf(double x, double y, double z)
{
  const double most = std::max({ std::fabs(x), std::fabs(y), std::fabs(z) });
  const double sum = std::fabs(x) + std::fabs(y) + std::fabs(z);
  if (!(sum > 0.0) || std::isinf(most))
  {
    return sum;
  }
  // Products too small to be exact are negligible beside the largest.
  const double scale = scaleOf(most);
  const auto square = [scale](double v) { return exactProduct(v * scale, v * scale); };
  const DoubleDouble squares = square(x) + square(y) + square(z);
  // A step of Newton's from the rounded root of the rounded sum.
  const double root = std::sqrt(squares.high);
  const double rest = (squares - exactProduct(root, root)).value();
  return (root + rest / (2.0 * root)) / scale;
}

} // namespace ahd
