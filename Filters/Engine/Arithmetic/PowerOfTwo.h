// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PowerOfTwo_h
#define ahd_PowerOfTwo_h

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace ahd
{

/// The power of two that brings a magnitude into [0.5, 1), at most 2^1000 and at least 2^-1000; 1
/// for 0 and what is not finite.
inline double powerOfTwoBelow(double magnitude)
{
  constexpr int kMost = 1000, kBias = 1023, kMantissa = 52;
  constexpr double kLeastNormal = std::numeric_limits<double>::min();
  if (!(magnitude > 0.0) || magnitude > std::numeric_limits<double>::max())
  {
    return 1.0;
  }
  std::uint64_t bits;
  std::memcpy(&bits, &magnitude, sizeof bits);
  // of subnormal numbers less, which is beyond the limit anyway
  const int exponent = magnitude < kLeastNormal ? -kBias
                                                : static_cast<int>(bits >> kMantissa) - (kBias - 1);
  bits = static_cast<std::uint64_t>(kBias + std::min(kMost, std::max(-kMost, -exponent)))
    << kMantissa;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

} // namespace ahd

#endif
