// SPDX-License-Identifier: BSD-3-Clause
#include "WideFloat.h"

#include "WideVectors.h"

#include <cstdint>

namespace ahd
{

/// Truncates to the digits.
template <int N>
void WideArithmetic::put(const WideInteger<N>& whole, int exponent, WideFloat& result) const
{
  int first = std::max(0, whole.size - digits_);
  while (first < whole.size && whole.word[first] == 0)
  {
    ++first;
  }
  const int size = whole.size - first;
  for (int i = 0; i < size; ++i) // upwards: `whole` may be result.whole
  {
    result.whole.word[i] = whole.word[first + i];
  }
  result.whole.size = size;
  result.whole.negative = whole.negative;
  result.exponent = exponent + first;
}

void WideArithmetic::set(double value, WideFloat& result) const
{
  const stages::Parts parts = stages::partsOf(value);
  const int exponent = (parts.exponent + 64 * 32) / 64 - 32; // rounded down
  put(wideFrom<WideInteger<2>>(parts.mantissa, parts.exponent - 64 * exponent, parts.negative),
    exponent, result);
}

/// a + b, b with this sign.
void WideArithmetic::add(const WideFloat& a, const WideFloat& b, bool isNegative, WideFloat& result)
{
  const bool isSame = a.whole.negative == isNegative;
  const bool aIsHigh = b.sign() == 0 || (a.sign() != 0 && a.exponent >= b.exponent);
  const WideFloat &high = aIsHigh ? a : b, &low = aIsHigh ? b : a;
  const bool highIsNegative = aIsHigh ? a.whole.negative : isNegative;
  const int gap = high.exponent - low.exponent;
  if (low.sign() == 0 || gap + high.whole.size > low.whole.size + digits_ + 1)
  {
    put(high.whole, high.exponent, result);
    result.whole.negative = highIsNegative;
    return;
  }
  std::fill_n(moved_.word, gap, std::uint64_t(0));
  std::copy_n(high.whole.word, high.whole.size, moved_.word + gap);
  moved_.size = gap + high.whole.size;
  moved_.negative = highIsNegative;
  addSigned(moved_, low.whole, isSame, long_);
  put(long_, low.exponent, result);
}

void WideArithmetic::difference(double a, double b, WideFloat& result)
{
  set(a, first_);
  set(b, second_);
  difference(first_, second_, result);
}

void WideArithmetic::product(const WideFloat& a, const WideFloat& b, WideFloat& result)
{
  multiply(a.whole, b.whole, long_);
  put(long_, a.exponent + b.exponent, result);
}

/// Newton's method; each step uses about as many digits as are correct.
void WideArithmetic::inverse(const WideFloat& a, WideFloat& result)
{
  constexpr int kRight = 48; // bits of a quotient of doubles
  const int all = digits_;
  set(1.0 / a.leading(), inverse_);
  inverse_.exponent -= a.leadingExponent();
  inverse_.whole.negative = a.whole.negative;
  for (int right = kRight; right < 64 * all; right = 2 * right - 4)
  {
    digits_ = std::min(all, right / 32 + 2);
    product(a, inverse_, second_);
    set(2.0, first_);
    difference(first_, second_, second_);
    product(inverse_, second_, inverse_);
  }
  digits_ = all;
  result = inverse_;
}

} // namespace ahd
