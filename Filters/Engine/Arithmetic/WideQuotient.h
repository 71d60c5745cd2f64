// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_WideQuotient_h
#define ahd_WideQuotient_h

#include "WideInteger.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

/// Quotients of WideIntegers, rounded once.
namespace ahd::stages
{

/// Room for the largest that are divided, products of three differences of coordinates and one
/// coordinate, and for a bit more.
using Wide = WideInteger<109>;

inline int bitsOf(const Wide& a)
{
  int bits = 64 * a.size;
  for (std::uint64_t top = a.word[a.size - 1]; top >> 63 == 0; top <<= 1)
  {
    --bits;
  }
  return bits;
}

/// |a| << shift. @pre a is not 0.
template <int Capacity>
Wide shifted(const WideInteger<Capacity>& a, int shift)
{
  Wide result;
  for (int i = 0; i < shift / 64; ++i)
  {
    result.push(0);
  }
  const int bits = shift % 64;
  std::uint64_t carry = 0;
  for (int i = 0; i < a.size; ++i)
  {
    result.push(a.word[i] << bits | carry);
    carry = bits == 0 ? 0 : a.word[i] >> (64 - bits);
  }
  if (carry != 0)
  {
    result.push(carry);
  }
  return result;
}

inline void doubleIt(Wide& a)
{
  std::uint64_t carry = 0;
  for (int i = 0; i < a.size; ++i)
  {
    const std::uint64_t top = a.word[i] >> 63;
    a.word[i] = a.word[i] << 1 | carry;
    carry = top;
  }
  if (carry != 0)
  {
    a.push(carry);
  }
}

/// a -= b. @pre |a| >= |b|.
inline void subtract(Wide& a, const Wide& b)
{
  std::uint64_t borrow = 0;
  for (int i = 0; i < a.size; ++i)
  {
    const std::uint64_t subtrahend = i < b.size ? b.word[i] : 0;
    const std::uint64_t partial = a.word[i] - subtrahend;
    const auto next = static_cast<std::uint64_t>((a.word[i] < subtrahend) + (partial < borrow));
    a.word[i] = partial - borrow;
    borrow = next;
  }
  a.dropLeadingZeros();
}

/// (bits + something less than 1, more than 0 if `more`) * 2^exponent, rounded to the nearest
/// double, ties to even. @pre the top bit of `bits` or the one after it is set.
inline double rounded(std::uint64_t bits, bool more, int exponent)
{
  constexpr int kPrecision = 53, kLowest = -1074;
  const int length = (bits >> 63) != 0 ? 64 : 63;
  const int drop = std::max(length - kPrecision, kLowest - exponent);
  if (drop > 64)
  {
    return 0.0;
  }
  const std::uint64_t half = std::uint64_t(1) << (drop - 1);
  const std::uint64_t rest = bits & (half - 1 + half);
  const std::uint64_t kept = drop == 64 ? 0 : bits >> drop;
  const bool up = rest > half || (rest == half && (more || (kept & 1) != 0));
  return std::ldexp(static_cast<double>(kept + up), exponent + drop);
}

/// a / b * 2^exponent, rounded to the nearest double, ties to even; infinite where that overflows.
/// @pre b is not 0.
template <int N, int M>
double roundedQuotient(const WideInteger<N>& a, const WideInteger<M>& b, int exponent)
{
  if (a.size == 0)
  {
    return 0.0;
  }
  Wide rest = shifted(a, 0), divisor = shifted(b, 0);
  const int scale = bitsOf(rest) - bitsOf(divisor);
  rest = shifted(a, std::max(0, -scale));
  divisor = shifted(b, std::max(0, scale));
  // Now both have the same number of bits, and the quotient is between 1/2 and 2: bit by bit, 63 of
  // them after the point.
  std::uint64_t bits = 0;
  for (int i = 0; i < 64; ++i)
  {
    bits <<= 1;
    if (compareMagnitudes(rest, divisor) >= 0)
    {
      subtract(rest, divisor);
      bits |= 1;
    }
    doubleIt(rest);
  }
  const double magnitude = rounded(bits, rest.size != 0, scale + exponent - 63);
  return magnitude != 0.0 && a.negative != b.negative ? -magnitude : magnitude;
}

} // namespace ahd::stages

#endif
