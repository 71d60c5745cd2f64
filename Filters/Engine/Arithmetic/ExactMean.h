// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ExactMean_h
#define ahd_ExactMean_h

#include "DoubleDouble.h"
#include "WideInteger.h"
#include "WideQuotient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// Means of finite numbers, rounded once: the double nearest to their exact sum over their count,
/// so that their order does not matter. @pre at most 2^28 numbers; rounding to nearest, no
/// contraction.
namespace ahd
{

/// A sum held in two doubles, a few operations per number; it suffices nearly always.
class ShortSum
{
public:
  void add(double x)
  {
    const DoubleDouble high = exactSum(sum_.high, x);
    const DoubleDouble low = exactSum(sum_.low, high.low);
    isExact_ = isExact_ && low.low == 0.0 && std::fabs(high.high) < kMost;
    sum_ = exactSum(high.high, low.high);
  }

  /// Returns false where this sum does not determine the nearest double: use a LongSum then.
  bool mean(std::size_t count, double& mean) const
  {
    mean = 0.0;
    if (!isExact_ || sum_.high == 0.0)
    {
      return isExact_;
    }
    if (std::fabs(sum_.high) < kLeast)
    {
      return false;
    }
    // mean = quotient + (rest + low) / count, of which only the last sum and quotient are rounded
    const double divisor = static_cast<double>(count);
    const double quotient = sum_.high / divisor;
    const DoubleDouble product = exactProduct(quotient, divisor);
    const double rest = (sum_.high - product.high) - product.low;
    const double more = (rest + sum_.low) / divisor;
    const double bound = 0x1p-48 * std::fabs(more);
    mean = quotient + (more - bound);
    return mean == quotient + (more + bound);
  }

private:
  // No product overflows, no part of one underflows.
  static constexpr double kMost = 0x1p490, kLeast = 0x1p-700;

  DoubleDouble sum_;
  bool isExact_ = true;
};

/// For all numbers: an integer of as many bits as doubles have places.
class LongSum
{
public:
  void add(double x)
  {
    int exponent = 0;
    const double fraction = std::frexp(std::fabs(x), &exponent);
    const int last = std::max(exponent - 53, kLowest);
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, exponent - last));
    const std::size_t place = static_cast<std::size_t>((last - kLowest) / kBits);
    const int shift = (last - kLowest) % kBits;
    const std::uint64_t low = (mantissa & kMask) << shift;
    const std::uint64_t high = ((mantissa >> kBits) << shift) + (low >> kBits);
    const std::array<std::uint64_t, 3> parts = { { low & kMask, high & kMask, high >> kBits } };
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      const auto part = static_cast<std::int64_t>(parts[k]);
      digits_[place + k] += x < 0.0 ? -part : part;
    }
  }

  double mean(std::size_t count) const
  {
    std::array<std::int64_t, kDigits> digits = digits_;
    const bool isNegative = carry(digits) < 0;
    if (isNegative)
    {
      std::transform(digits_.begin(), digits_.end(), digits.begin(), [](auto d) { return -d; });
      carry(digits);
    }
    WideInteger<int(kDigits / 2)> sum;
    sum.negative = isNegative;
    for (std::size_t k = 0; k < kDigits; k += 2)
    {
      sum.push(std::uint64_t(digits[k]) | std::uint64_t(digits[k + 1]) << kBits);
    }
    sum.dropLeadingZeros();
    WideInteger<1> divisor;
    divisor.push(count);
    return stages::roundedQuotient(sum, divisor, kLowest);
  }

private:
  static constexpr int kLowest = -1074; ///< exponent of the smallest double
  static constexpr int kBits = 32;      ///< of a digit; the rest of the 64 is for carries
  static constexpr std::uint64_t kMask = 0xFFFFFFFFu;
  static constexpr std::size_t kDigits = 70; ///< 2098 places, and 28 for the count

  /// Brings all digits to [0, 2^32). Returns the carry out of the last: -1 of a negative sum.
  static std::int64_t carry(std::array<std::int64_t, kDigits>& digits)
  {
    std::int64_t carried = 0;
    for (std::int64_t& digit : digits)
    {
      const std::int64_t sum = digit + carried;
      digit = static_cast<std::int64_t>(static_cast<std::uint64_t>(sum) & kMask);
      carried = (sum - digit) / (std::int64_t(1) << kBits);
    }
    return carried;
  }

  std::array<std::int64_t, kDigits> digits_ = {};
};

} // namespace ahd

#endif
