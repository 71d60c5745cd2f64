// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_WideInteger_h
#define ahd_WideInteger_h

#include <algorithm>
#include <cassert>
#include <cstdint>

/// Signed integers of up to a fixed number of bits, on the stack, with as many words as their value
/// needs. Only the operations that the exact predicates need.
namespace ahd
{

#if defined(__SIZEOF_INT128__) && !defined(AHD_WITHOUT_INT128)
#define AHD_HAS_INT128 1
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;
#endif

/// a * b + c + carry, which always fits into two words. Returns the low one, carry becomes the
/// high.
inline std::uint64_t multiplyAddCarry(
  std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t& carry)
{
#ifdef AHD_HAS_INT128
  const UInt128 sum = UInt128(a) * b + c + carry;
  carry = std::uint64_t(sum >> 64);
  return std::uint64_t(sum);
#else
  const std::uint64_t mask = 0xFFFFFFFFu;
  const std::uint64_t low = (a & mask) * (b & mask) + (c & mask) + (carry & mask);
  const std::uint64_t mid1 = (a >> 32) * (b & mask) + (c >> 32) + (low >> 32);
  const std::uint64_t mid2 = (a & mask) * (b >> 32) + (carry >> 32) + (mid1 & mask);
  carry = (a >> 32) * (b >> 32) + (mid1 >> 32) + (mid2 >> 32);
  return (mid2 << 32) | (low & mask);
#endif
}

/// Sign and magnitude; `word` is little endian, only the first `size` words are set and the highest
/// of them is not 0; zero has size 0.
template <int Capacity>
struct WideInteger
{
  std::uint64_t word[static_cast<std::size_t>(Capacity)];
  int size = 0;
  bool negative = false;

  WideInteger() {} // leaves `word` unset on purpose: most of it is never used
  int sign() const { return size == 0 ? 0 : (negative ? -1 : 1); }

  void push(std::uint64_t w)
  {
    assert(size < Capacity);
    word[size++] = w;
  }
  void dropLeadingZeros()
  {
    while (size > 0 && word[size - 1] == 0)
    {
      --size;
    }
  }
};

/// mantissa * 2^shift. @pre shift >= 0 and room for the bits.
template <class Wide>
Wide wideFrom(std::uint64_t mantissa, int shift, bool negative)
{
  Wide result;
  if (mantissa == 0)
  {
    return result;
  }
  result.negative = negative;
  for (int i = 0; i < shift / 64; ++i)
  {
    result.push(0);
  }
  const int bits = shift % 64;
  result.push(mantissa << bits);
  if (bits != 0 && (mantissa >> (64 - bits)) != 0)
  {
    result.push(mantissa >> (64 - bits));
  }
  result.dropLeadingZeros();
  return result;
}

/// The sign of |a| - |b|.
template <int N, int M>
int compareMagnitudes(const WideInteger<N>& a, const WideInteger<M>& b)
{
  if (a.size != b.size)
  {
    return a.size < b.size ? -1 : 1;
  }
  for (int i = a.size - 1; i >= 0; --i)
  {
    if (a.word[i] != b.word[i])
    {
      return a.word[i] < b.word[i] ? -1 : 1;
    }
  }
  return 0;
}

/// |a| + |b|, written to the empty `result`. @pre a.size >= b.size.
template <int R, int N, int M>
void addMagnitudes(const WideInteger<N>& a, const WideInteger<M>& b, WideInteger<R>& result)
{
  std::uint64_t carry = 0;
  for (int i = 0; i < a.size; ++i)
  {
    const std::uint64_t partial = a.word[i] + carry;
    carry = partial < carry;
    const std::uint64_t sum = partial + (i < b.size ? b.word[i] : 0);
    carry += sum < partial;
    result.push(sum);
  }
  if (carry != 0)
  {
    result.push(carry);
  }
}

/// |a| - |b|, written to the empty `result`. @pre |a| >= |b|.
template <int R, int N, int M>
void subtractMagnitudes(const WideInteger<N>& a, const WideInteger<M>& b, WideInteger<R>& result)
{
  std::uint64_t borrow = 0;
  for (int i = 0; i < a.size; ++i)
  {
    const std::uint64_t subtrahend = i < b.size ? b.word[i] : 0;
    const std::uint64_t partial = a.word[i] - subtrahend;
    const auto next = static_cast<std::uint64_t>((a.word[i] < subtrahend) + (partial < borrow));
    result.push(partial - borrow);
    borrow = next;
  }
  result.dropLeadingZeros();
}

/// |a| + |b| with the sign of a if `sameSign`, else |a| - |b| with the sign of that.
template <int R, int N, int M>
void addSigned(
  const WideInteger<N>& a, const WideInteger<M>& b, bool sameSign, WideInteger<R>& result)
{
  result.size = 0;
  result.negative = a.negative;
  if (sameSign)
  {
    a.size >= b.size ? addMagnitudes(a, b, result) : addMagnitudes(b, a, result);
  }
  else if (compareMagnitudes(a, b) >= 0)
  {
    subtractMagnitudes(a, b, result);
  }
  else
  {
    subtractMagnitudes(b, a, result);
    result.negative = !a.negative;
  }
}

template <int N, int M>
WideInteger<std::max(N, M) + 1> addSigned(
  const WideInteger<N>& a, const WideInteger<M>& b, bool sameSign)
{
  WideInteger<std::max(N, M) + 1> result; // the only one, so that returning it copies nothing
  addSigned(a, b, sameSign, result);
  return result;
}

template <int N, int M>
WideInteger<std::max(N, M) + 1> operator+(const WideInteger<N>& a, const WideInteger<M>& b)
{
  return addSigned(a, b, a.negative == b.negative);
}

template <int N, int M>
WideInteger<std::max(N, M) + 1> operator-(const WideInteger<N>& a, const WideInteger<M>& b)
{
  return addSigned(a, b, a.negative != b.negative);
}

/// a * b. @pre `result` is neither of them.
template <int R, int N, int M>
void multiply(const WideInteger<N>& a, const WideInteger<M>& b, WideInteger<R>& result)
{
  if (a.size == 0 || b.size == 0)
  {
    result.size = 0;
    return;
  }
  result.negative = a.negative != b.negative;
  result.size = a.size + b.size;
  for (int i = 0; i < result.size; ++i)
  {
    result.word[i] = 0;
  }
  for (int i = 0; i < a.size; ++i)
  {
    std::uint64_t carry = 0;
    for (int k = 0; k < b.size; ++k)
    {
      result.word[i + k] = multiplyAddCarry(a.word[i], b.word[k], result.word[i + k], carry);
    }
    result.word[i + b.size] = carry;
  }
  result.dropLeadingZeros();
}

template <int N, int M>
WideInteger<N + M> operator*(const WideInteger<N>& a, const WideInteger<M>& b)
{
  WideInteger<N + M> result;
  multiply(a, b, result);
  return result;
}

} // namespace ahd

#endif
