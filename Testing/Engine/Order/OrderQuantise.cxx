// SPDX-License-Identifier: BSD-3-Clause
//
// Coordinates on the grid of the insertion order: quantisation, and the shape of the boxes.
#include "Distributions.h"
#include "Order/HilbertCurve.h"
#include "Order/Quantise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSubnormal = std::numeric_limits<double>::denorm_min();

struct Interval
{
  double low, high;
};

std::vector<Interval> intervals()
{
  return { { 0.0, 1.0 }, { -1.0, 1.0 }, { 1.0, std::nextafter(1.0, 2.0) }, { 0.0, kSubnormal },
    { -kSubnormal, kSubnormal }, { -kSubnormal, 5 * kSubnormal }, { 0.0, 1e-310 },
    { 1e-300, 2e-300 }, { 1e300, std::nextafter(1e300, kLargest) }, { 1e300, 2e300 },
    { -kLargest, kLargest }, { 0.0, kLargest }, { -1.0, kLargest }, { -kLargest, -kSubnormal },
    { -kLargest / 2, kLargest / 2 }, { -0x1p969, kLargest }, { -1e300, 1e-300 }, { 5e5, 5.02e5 },
    { 0x1p-900, 0x1p-899 }, { 0.0, 0x1p-900 }, { 0.0, std::nextafter(0x1p-900, 0.0) },
    { 0.1, 0.3 } };
}

/// Values of the interval, ascending: its ends, their neighbours, and some between.
std::vector<double> valuesOf(const Interval& i)
{
  std::vector<double> values{ i.low, i.high };
  double up = i.low, down = i.high;
  for (int k = 0; k < 40; ++k)
  {
    up = std::nextafter(up, i.high);
    down = std::nextafter(down, i.low);
    values.insert(values.end(), { up, down });
  }
  Random random(51);
  for (int k = 0; k < 3000; ++k)
  {
    const double u = random.unit();
    values.push_back(i.low * (1.0 - u) + i.high * u);
    values.push_back(i.low + std::ldexp(i.high / 2 - i.low / 2, -int(random.below(1200))));
    values.push_back(std::ldexp(u - 0.5, -int(random.below(1074))));
  }
  for (double& v : values)
  {
    v = std::min(std::max(v, i.low), i.high);
  }
  std::sort(values.begin(), values.end());
  return values;
}

TEST(Quantiser, IsMonotoneAndMeetsTheEnds)
{
  for (const Interval& i : intervals())
  {
    const Quantiser quantiser(i.low, i.high);
    EXPECT_EQ(quantiser(i.low), 0u) << i.low << " .. " << i.high;
    EXPECT_GE(quantiser(i.high), 0xFFFFFFFEu) << i.low << " .. " << i.high;
    std::uint32_t last = 0;
    for (const double v : valuesOf(i))
    {
      const std::uint32_t q = quantiser(v);
      ASSERT_LE(last, q) << v << " in " << i.low << " .. " << i.high;
      last = q;
    }
  }
}

TEST(Quantiser, IsEvenUpToRounding)
{
  if (std::numeric_limits<long double>::max_exponent == std::numeric_limits<double>::max_exponent)
  {
    GTEST_SKIP() << "long double has no larger range here";
  }
  for (const Interval& i : intervals())
  {
    const long double span = (long double)i.high - (long double)i.low;
    const Quantiser quantiser(i.low, i.high);
    for (const double v : valuesOf(i))
    {
      // A subnormal or overflowing span is possible here.
      const long double t = ((long double)v - (long double)i.low) / span * 4294967295.0L;
      ASSERT_NEAR(double(quantiser(v)), double(t), 1.001)
        << v << " in " << i.low << " .. " << i.high;
    }
  }
}

TEST(Quantiser, ScalesByPowersOfTwo)
{
  for (const Interval& i : intervals())
  {
    const Quantiser quantiser(i.low, i.high);
    for (const int e : { -1800, -950, -60, -2, -1, 1, 2, 60, 950, 1800 })
    {
      const double low = std::ldexp(i.low, e), high = std::ldexp(i.high, e);
      if (!std::isfinite(low) || !std::isfinite(high) || std::ldexp(low, -e) != i.low ||
        std::ldexp(high, -e) != i.high)
      {
        continue;
      }
      const Quantiser other(low, high);
      for (const double v : valuesOf(i))
      {
        const double w = std::ldexp(v, e);
        if (std::ldexp(w, -e) == v)
        {
          ASSERT_EQ(other(w), quantiser(v))
            << v << " in " << i.low << " .. " << i.high << " times 2^" << e;
        }
      }
    }
  }
}

TEST(Quantiser, NoSpanIsZero)
{
  for (const double v : { 0.0, -0.0, 1.0, kLargest, -kLargest, kSubnormal, 1e300 })
  {
    EXPECT_EQ(Quantiser(v, v)(v), 0u) << v;
  }
}

TEST(Grid, BoxesAreAtMostTwiceAsLongAsWide)
{
  for (const double unit : { 1.0, 0x1p-1000, 0x1p1000, 3.0 * kSubnormal })
  {
    const Grid wide(Bounds{ 0.0, 6.0 * unit, 0.0, unit });
    EXPECT_GE(wide.column(6.0 * unit), 0xFFFFFFFEu);
    EXPECT_NEAR(wide.row(unit), 0xFFFFFFFFu / 3.0, 1.0) << "2 to 6 times the unit are one grid";
    const Grid high(Bounds{ 0.0, unit, 0.0, 6.0 * unit });
    EXPECT_NEAR(high.column(unit), 0xFFFFFFFFu / 3.0, 1.0);
    const Grid square(Bounds{ 0.0, 2.0 * unit, 0.0, unit });
    EXPECT_GE(square.column(2.0 * unit), 0xFFFFFFFEu);
    EXPECT_GE(square.row(unit), 0xFFFFFFFEu);
  }
  const Grid strip(Bounds{ -kLargest, kLargest, 0.0, 1.0 });
  EXPECT_EQ(strip.row(1.0), 0u);
  EXPECT_GE(strip.column(kLargest), 0xFFFFFFFEu);
  const Grid needle(Bounds{ 0.0, kLargest, 0.0, kSubnormal });
  EXPECT_EQ(needle.row(kSubnormal), 0u);
}

} // namespace
} // namespace test
} // namespace ahd
