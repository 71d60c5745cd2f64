// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_WideVectors_h
#define ahd_WideVectors_h

#include "../Points/Points.h"
#include "WideInteger.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <initializer_list>

/// Points as integers of as many bits as their exponents need, up to the whole range of double.
namespace ahd::stages
{

/// A finite double as mantissa * 2^exponent.
struct Parts
{
  std::uint64_t mantissa;
  int exponent;
  bool negative;
};

inline Parts partsOf(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const int biased = static_cast<int>((bits >> 52) & 0x7FF);
  std::uint64_t mantissa = bits & 0xFFFFFFFFFFFFFu;
  mantissa |= biased != 0 ? std::uint64_t(1) << 52 : 0;
  const int exponent = (biased != 0 ? biased : 1) - 1075;
  return { mantissa, exponent, (bits >> 63) != 0 };
}

/// The largest double has 1024 bits before the point, the smallest one 1074 after it.
using Coordinate = WideInteger<(1024 + 1074 + 63) / 64>;
using Difference = WideInteger<(1024 + 1074 + 63) / 64 + 1>;

/// Coordinates as integers in a unit small enough for all of them.
class Unit
{
public:
  explicit Unit(std::initializer_list<const Point*> points)
  {
    for (const Point* p : points)
    {
      include(p->x);
      include(p->y);
    }
  }

  Difference difference(double a, double b) const { return integer(a) - integer(b); }

  Coordinate integer(double value) const
  {
    const Parts parts = partsOf(value);
    return wideFrom<Coordinate>(parts.mantissa, parts.exponent - exponent_, parts.negative);
  }

  /// The unit is 2^exponent(). @pre a coordinate is not 0.
  int exponent() const { return exponent_; }

private:
  void include(double value)
  {
    const Parts parts = partsOf(value);
    if (parts.mantissa != 0)
    {
      exponent_ = std::min(exponent_, parts.exponent);
    }
  }

  int exponent_ = 1024;
};

struct WideVector
{
  Difference x;
  Difference y;

  WideVector(const Unit& unit, const Point& from, const Point& to)
    : x(unit.difference(to.x, from.x))
    , y(unit.difference(to.y, from.y))
  {
  }
};

inline auto crossUnbounded(const WideVector& a, const WideVector& b)
{
  return a.x * b.y - a.y * b.x;
}

inline auto dotUnbounded(const WideVector& a, const WideVector& b)
{
  return a.x * b.x + a.y * b.y;
}

} // namespace ahd::stages

#endif
