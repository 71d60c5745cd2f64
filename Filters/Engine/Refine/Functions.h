// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Functions_h
#define ahd_Functions_h

#include "../Arithmetic/DoubleDouble.h"
#include "../Arithmetic/PowerOfTwo.h"

#include <algorithm>
#include <cmath>

namespace ahd
{

// Of sums, products, quotients and powers of two alone: the same bits with every system's library.

/// The sine of 0 to 90 degrees. Its series, in double-double: the last term counted is below 2^-60.
inline double sineOfDegrees(double degrees)
{
  constexpr DoubleDouble kPi = { 0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53 };
  const DoubleDouble x = kPi * DoubleDouble{ degrees, 0.0 } / DoubleDouble{ 180.0, 0.0 };
  DoubleDouble sum = x, term = x;
  for (int k = 2; k < 28; k += 2)
  {
    term = -(term * x * x) / DoubleDouble{ double(k * (k + 1)), 0.0 };
    sum = sum + term;
  }
  return sum.value();
}

/// The power of two that is nearest, as logarithms are. @pre finite, above 0
inline double nearestPowerOfTwo(double value)
{
  int exponent = 0;
  const double part = std::frexp(value, &exponent); // from 1/2 to 1
  return std::ldexp(1.0, part * part < 0.5 ? exponent - 1 : exponent);
}

/// A unit in the last place of numbers of this magnitude. @pre finite
inline double lastPlaceOf(double magnitude)
{
  int exponent = 0;
  std::frexp(magnitude, &exponent);
  return std::ldexp(1.0, std::max(exponent - 53, -1074));
}

/// The place at this fraction of the way from a to b, rounded once. @pre below 2^1000 in magnitude
inline double between(double a, double b, double fraction)
{
  const double scale = powerOfTwoBelow(std::max(std::fabs(a), std::fabs(b)));
  const DoubleDouble from = { a * scale, 0.0 };
  const DoubleDouble way = exactDifference(b * scale, a * scale) * DoubleDouble{ fraction, 0.0 };
  return (from + way).value() / scale + 0.0; // 0.0 for -0.0
}

} // namespace ahd

#endif
