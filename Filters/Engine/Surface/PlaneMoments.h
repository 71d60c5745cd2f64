// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlaneMoments_h
#define ahd_PlaneMoments_h

#include "../Arithmetic/WideInteger.h"
#include "Vectors.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Around points, and how many these are.
struct PlaneExtent
{
  Vector3 low = { { DBL_MAX, DBL_MAX, DBL_MAX } };
  Vector3 high = { { -DBL_MAX, -DBL_MAX, -DBL_MAX } };
  double count = 0.0;

  void add(const Vector3& p)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
    count += 1.0;
  }
  void merge(const PlaneExtent& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
    count += other.count;
  }
};

/// A power of two in two factors, so that multiplying by one after the other stays finite where the
/// result is.
struct PowerOfTwo
{
  double first, second;
};

/// 2^e. @pre it is the product of two doubles.
inline PowerOfTwo powerOfTwo(int e)
{
  return { std::ldexp(1.0, e / 2), std::ldexp(1.0, e - e / 2) };
}

/// One axis on which places are whole numbers: the distance from the origin in units of 2^exponent,
/// cut off, and kZero more: from 0 to 2^63.
struct PlaneScale
{
  static constexpr int kBits = 62;
  static constexpr std::uint64_t kZero = std::uint64_t(1) << kBits;

  PlaneScale() = default;
  /// `reach`: the largest distance from the origin; 0: all have one place.
  PlaneScale(double from, double reach)
    : origin(from)
  {
    std::frexp(reach, &exponent); // reach < 2^exponent
    exponent -= kBits;
    factor = reach > 0.0 ? powerOfTwo(-exponent) : PowerOfTwo{ 0.0, 0.0 };
  }

  /// @pre it is within reach
  std::uint64_t operator()(double coordinate) const
  {
    const double d = (coordinate * factor.first - origin * factor.first) * factor.second;
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(d)) + kZero;
  }

  double origin = 0.0;
  int exponent = 0;
  PowerOfTwo factor{ 0.0, 0.0 };
};

/// A sum of products, exact below 2^192.
struct WideSum
{
  void add(std::uint64_t a, std::uint64_t b)
  {
    std::uint64_t high = 0;
    words[0] = multiplyAddCarry(a, b, words[0], high);
    words[1] += high;
    words[2] += words[1] < high;
  }
  void merge(const WideSum& other)
  {
    std::uint64_t carry = 0;
    for (std::size_t k = 0; k < words.size(); ++k)
    {
      words[k] = multiplyAddCarry(other.words[k], 1, words[k], carry);
    }
  }
  WideInteger<3> value() const
  {
    WideInteger<3> whole;
    for (const std::uint64_t word : words)
    {
      whole.push(word);
    }
    whole.dropLeadingZeros();
    return whole;
  }

  std::array<std::uint64_t, 3> words = {};
};

/// Sums over points, as whole numbers on three scales, and over products of two of their
/// coordinates: exact, so independent of order and parts.
struct PlaneMoments
{
  static constexpr std::size_t kFirst[6] = { 0, 0, 0, 1, 1, 2 };
  static constexpr std::size_t kSecond[6] = { 0, 1, 2, 1, 2, 2 };

  void add(const std::array<std::uint64_t, 3>& q)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      single[k].add(q[k], 1);
    }
    for (std::size_t k = 0; k < 6; ++k)
    {
      product[k].add(q[kFirst[k]], q[kSecond[k]]);
    }
  }
  void merge(const PlaneMoments& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      single[k].merge(other.single[k]);
    }
    for (std::size_t k = 0; k < 6; ++k)
    {
      product[k].merge(other.product[k]);
    }
  }

  std::array<WideSum, 3> single;
  std::array<WideSum, 6> product; ///< of coordinates kFirst and kSecond
};

} // namespace ahd

#endif
