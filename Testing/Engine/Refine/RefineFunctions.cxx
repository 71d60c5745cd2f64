// SPDX-License-Identifier: BSD-3-Clause
//
// The functions that refinement has in place of a system's own.
#include "Refine/Functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace ahd
{
namespace
{

TEST(RefineFunctions, SinesAreRounded)
{
  EXPECT_EQ(sineOfDegrees(0.0), 0.0);
  EXPECT_EQ(sineOfDegrees(30.0), 0.5);
  EXPECT_EQ(sineOfDegrees(90.0), 1.0);
  EXPECT_EQ(sineOfDegrees(45.0), std::sqrt(0.5));
  EXPECT_EQ(sineOfDegrees(60.0), std::sqrt(0.75));
  for (double degrees = 0.01; degrees < 90.0; degrees += 0.37)
  {
    const long double pi = std::acos(-1.0L);
    const double expected = double(std::sin(degrees * pi / 180.0L));
    EXPECT_NEAR(sineOfDegrees(degrees), expected, 0x1p-53 * expected) << degrees;
  }
}

TEST(RefineFunctions, PowersOfTwoAreTheNearest)
{
  for (int power = -1000; power <= 1000; power += 40)
  {
    const double one = std::ldexp(1.0, power);
    EXPECT_EQ(nearestPowerOfTwo(one), one);
    EXPECT_EQ(nearestPowerOfTwo(1.41 * one), one);
    EXPECT_EQ(nearestPowerOfTwo(1.42 * one), 2.0 * one);
    EXPECT_EQ(nearestPowerOfTwo(0.71 * one), one);
    EXPECT_EQ(nearestPowerOfTwo(0.70 * one), 0.5 * one);
    EXPECT_EQ(lastPlaceOf(one), std::nextafter(one, 2.0 * one) - one);
    EXPECT_EQ(lastPlaceOf(1.9 * one), lastPlaceOf(one));
  }
}

/// Against integers: the place on a segment of the largest ones that doubles hold.
TEST(RefineFunctions, PlacesAreRoundedOnce)
{
  EXPECT_EQ(between(1.0, 3.0, 0.25), 1.5);
  EXPECT_EQ(between(5.0, 5.0, 0.3), 5.0);
  EXPECT_FALSE(std::signbit(between(-0.0, -0.0, 0.5)));
  EXPECT_EQ(between(-1.0, 0x1p-60, 0.5), -0.5); // a + b loses what is below
  EXPECT_EQ(between(-0x1p70, 0x1p70, 0.5), 0.0);
  const std::int64_t a = 9007199254740881, b = -9007199254740113;
  for (std::int64_t k = 1; k < 1024; ++k)
  {
    // exactly (a (1024 - k) + b k) / 1024, below 2^63 before the division
    const std::int64_t sum = a * (1024 - k) + b * k;
    EXPECT_EQ(between(double(a), double(b), double(k) / 1024.0), double(sum) / 1024.0) << k;
  }
}

} // namespace
} // namespace ahd
