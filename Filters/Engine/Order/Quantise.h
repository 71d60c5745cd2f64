// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Quantise_h
#define ahd_Quantise_h

#include "../Points/Points.h"

#include <cstdint>

namespace ahd
{

/// Maps an interval of coordinates to the integers 0 .. 2^32 - 1: the columns (or rows) of the
/// finest grid there is. Boxes of r levels are the top r bits.
///
/// Contract, for every pair of finite doubles low <= high:
/// 1. operator() is monotone, maps low to 0 and, if low < high, high to 2^32 - 1 or 2^32 - 2.
///    (The second happens where rounding takes (high - low) * scale below the whole number.)
/// 2. Multiplying all coordinates by one power of two, where that is exact, changes nothing.
/// 3. low == high maps to 0.
///
/// How: t = (v f - low f) s with a power of two f and s = (2^32 - 1) / (high f - low f), cut off to
/// an integer. Each operation is monotone in v. f keeps the span and s within the range of doubles:
/// f = 1/2 where high - low would overflow, and then low and high are beyond 2^969 in magnitude, so
/// the last bit that a subnormal v loses is far below the rounding of the difference; f = 2^500
/// where the span is below 2^-900, and then low and high are below 2^-847 and nothing is lost.
/// The quotient and the product exceed 2^32 - 1 by less than 2^-19, so the cut never gives 2^32.
class Quantiser
{
public:
  Quantiser(double low, double high)
  {
    const double span = high - low;
    factor_ = span > kLargest ? 0.5 : low < high && span < kSmall ? 0x1p500 : 1.0;
    low_ = low * factor_;
    scale_ = low < high ? kLastColumn / (high * factor_ - low_) : 0.0;
  }

  std::uint32_t operator()(double v) const
  {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>((v * factor_ - low_) * scale_));
  }

private:
  static constexpr double kLargest = 1.7976931348623157e308; // an overflowed span is larger
  static constexpr double kSmall = 0x1p-900;
  static constexpr double kLastColumn = 4294967295.0;

  double factor_;
  double low_;
  double scale_;
};

/// The two axes with their separate spans, as in the paper's rule of grid division.
struct Grid
{
  explicit Grid(const Bounds& b)
    : column(b.xmin, b.xmax)
    , row(b.ymin, b.ymax)
  {
  }

  Quantiser column;
  Quantiser row;
};

} // namespace ahd

#endif
