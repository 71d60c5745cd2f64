// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_WideFloat_h
#define ahd_WideFloat_h

#include "../Core/Chunks.h"
#include "WideInteger.h"

#include <algorithm>

namespace ahd
{

/// The most digits of 64 bits that a WideFloat may have. One is some 2 KiB: keep several on the
/// heap where the stack is small.
constexpr int kMostDigits = 266;

/// whole * 2^(64 * exponent): a number that neither overflows nor underflows, with as many digits
/// as its value needs. The lowest digit is not 0.
struct WideFloat
{
  WideInteger<kMostDigits> whole;
  int exponent = 0;

  WideFloat() = default;
  WideFloat(const WideFloat& other) { *this = other; }
  WideFloat& operator=(const WideFloat& other)
  {
    std::copy_n(other.whole.word, other.whole.size, whole.word); // the others are not set
    whole.size = other.whole.size;
    whole.negative = other.whole.negative;
    exponent = other.exponent;
    return *this;
  }

  int sign() const { return whole.sign(); }

  /// |value| < 2^bits(), and half of that at most. @pre it is not 0.
  int bits() const
  {
    return 64 * (exponent + whole.size - 1) + int(bitLength(whole.word[whole.size - 1]));
  }

  /// |value| = leading() * 2^(64 * leadingExponent()), up to a relative error of 2^-52. @pre it is
  /// not 0.
  double leading() const
  {
    const int size = whole.size;
    const double low = size > 1 ? static_cast<double>(whole.word[size - 2]) : 0.0;
    return static_cast<double>(whole.word[size - 1]) * 0x1p64 + low;
  }
  int leadingExponent() const { return exponent + whole.size - 2; }
};

/// Sums, products and inverses of WideFloats, truncated to so many digits: the relative error of
/// sums and products is less than unit(), that of inverses 4 unit(). A result may be an operand.
///
/// Proof. Of n digits the highest is at least 1, and less than 1 of the lowest is cut off. A
/// summand that is left out is less than 2^(-64 (n + 1)) of the other. Of an inverse x of a that is
/// wrong by e, x (2 - a x) is wrong by e^2, and by the rounding of a x, of the difference from 2
/// and of the product.
class WideArithmetic
{
public:
  /// @pre 2 <= digits <= kMostDigits.
  void setDigits(int digits) { digits_ = digits; }
  int digits() const { return digits_; }
  /// As an exponent of 2.
  int unit() const { return -64 * (digits_ - 1); }

  static void setZero(WideFloat& result) { result.whole.size = 0; }

  /// a - b. @pre both are finite.
  void difference(double a, double b, WideFloat& result);

  void sum(const WideFloat& a, const WideFloat& b, WideFloat& result)
  {
    add(a, b, b.whole.negative, result);
  }
  void difference(const WideFloat& a, const WideFloat& b, WideFloat& result)
  {
    add(a, b, !b.whole.negative, result);
  }

  void product(const WideFloat& a, const WideFloat& b, WideFloat& result);
  /// 1 / a. @pre a is not 0.
  void inverse(const WideFloat& a, WideFloat& result);

private:
  void set(double value, WideFloat& result) const;
  template <int N>
  void put(const WideInteger<N>& whole, int exponent, WideFloat& result) const;
  void add(const WideFloat& a, const WideFloat& b, bool isNegative, WideFloat& result);

  int digits_ = 2;
  WideInteger<2 * kMostDigits + 1> moved_;
  WideInteger<2 * kMostDigits + 2> long_;
  WideFloat first_, second_, inverse_;
};

} // namespace ahd

#endif
