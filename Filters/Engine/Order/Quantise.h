// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Quantise_h
#define ahd_Quantise_h

#include "../Points/Points.h"

#include <algorithm>
#include <cstdint>

namespace ahd
{

/// Maps an interval of coordinates to the integers 0 .. 2^32 - 1: the columns (or rows) of the
/// finest grid. Boxes of r levels are the top r bits.
///
/// Contract, for every pair of finite doubles low <= high:
/// 1. operator() is monotone, maps low to 0 and, if low < high, high to 2^32 - 1 or 2^32 - 2.
///    (The second happens where rounding takes (high - low) * scale below the whole number.)
/// 2. Multiplying all coordinates by one power of two, where that is exact, changes nothing.
/// 3. low == high maps to 0.
/// 4. Where the interval is less than 1 / kLongestBox of the one of the other axis, the columns are
///    as wide as if it were just that, and high maps to a lower number.
///
/// How: t = (v f - low f) s with a power of two f and s = (2^32 - 1) / (high f - low f), cut off to
/// an integer. Each operation is monotone in v. f keeps the span and s within the range of doubles:
/// f = 1/2 where high - low would overflow (on either axis), and then the last bit that a subnormal
/// v loses is far below the width of a column, as that is at least a 2^34-th of 2^1023; f = 2^500
/// where the span is below 2^-900, and then low and high are below 2^-847 and nothing is lost (not
/// where the other span is above 2^500: then every v is in column 0 anyway).
/// The quotient and the product exceed 2^32 - 1 by less than 2^-19, so the cut never gives 2^32.
class Quantiser
{
public:
  static constexpr double kLongestBox = 2.0;

  Quantiser(double low, double high, double otherLow = 0.0, double otherHigh = 0.0)
  {
    const double span = high - low;
    const double other = otherHigh - otherLow;
    const bool overflows = span > kLargest || other > kLargest;
    const bool isSmall = low < high && span < kSmall && other < 0x1p500;
    factor_ = overflows ? 0.5 : isSmall ? 0x1p500 : 1.0;
    low_ = low * factor_;
    const double otherWidth = overflows ? otherHigh * factor_ - otherLow * factor_
                                        : other * factor_;
    const double width = std::max(high * factor_ - low_, otherWidth / kLongestBox);
    scale_ = low < high ? kLastColumn / width : 0.0;
    pitch_ = width / kLastColumn;
  }

  std::uint32_t operator()(double v) const
  {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>((v * factor_ - low_) * scale_));
  }

  /// Where a column begins, up to rounding; the next to last, 2^32, is where the last one ends. For
  /// drawing: the order of the points is decided by operator() alone. Finite.
  double begin(std::uint64_t column) const
  {
    const double v = (low_ + static_cast<double>(column) * pitch_) / factor_;
    return std::min(std::max(v, -kLargest), kLargest);
  }

private:
  static constexpr double kLargest = 1.7976931348623157e308; // an overflowed span is larger
  static constexpr double kSmall = 0x1p-900;
  static constexpr double kLastColumn = 4294967295.0;

  double factor_;
  double low_;
  double scale_;
  double pitch_;
};

/// The two axes with their separate spans, as in the paper's rule of grid division, but no box more
/// than twice (Quantiser::kLongestBox) as long as it is wide: where the bounds are, the grid
/// reaches beyond them on their shorter side. Else, in a long strip, neighbours along it are far
/// apart on the curve, as it has to visit all rows first; README.md has the numbers.
struct Grid
{
  explicit Grid(const Bounds& b)
    : column(b.xmin, b.xmax, b.ymin, b.ymax)
    , row(b.ymin, b.ymax, b.xmin, b.xmax)
  {
  }

  Quantiser column;
  Quantiser row;
};

} // namespace ahd

#endif
