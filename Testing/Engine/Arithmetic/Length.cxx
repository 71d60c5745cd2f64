// SPDX-License-Identifier: BSD-3-Clause
//
// Lengths against rational arithmetic: nearly correctly rounded, at all scales.
#include "Arithmetic/Length.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Is sqrt(x * x + y * y + z * z) between length - ulp * share and length + ulp * share?
bool isWithin(double share, double length, double x, double y, double z)
{
  const mpq_class square = mpq_class(x) * mpq_class(x) + mpq_class(y) * mpq_class(y) +
    mpq_class(z) * mpq_class(z);
  const mpq_class unit = mpq_class(std::nextafter(length, kInfinity)) - mpq_class(length);
  const mpq_class low = mpq_class(length) - unit * mpq_class(share);
  const mpq_class high = mpq_class(length) + unit * mpq_class(share);
  return low * low <= square && square <= high * high;
}

/// As many bits as a double has, between 1 and 2.
double mantissa(std::mt19937_64& random)
{
  return 1.0 + double(random() >> 12) * 0x1p-52;
}

TEST(Length, IsNearlyCorrectlyRounded)
{
  std::mt19937_64 random(1); // its sequence is fixed by the standard
  for (const int scale : { 0, 30, -195, 195, -205, 205, 500, -500, 900, -900, 1020, -1020 })
  {
    for (int i = 0; i < 300; ++i)
    {
      double v[3];
      for (double& number : v)
      {
        const int less = int(random() % 60);
        number = std::ldexp(mantissa(random), scale - (i % 2 == 0 ? 0 : less));
      }
      v[2] = i % 3 == 0 ? 0.0 : v[2];
      const double length = lengthOf(v[0], -v[1], v[2]);
      ASSERT_TRUE(isWithin(length < 0x1p-1022 ? 1.0 : 0.5001, length, v[0], v[1], v[2]))
        << v[0] << " " << v[1] << " " << v[2];
    }
  }
}

TEST(Length, OfWhatHasARoot)
{
  EXPECT_EQ(lengthOf(3, 4), 5);
  EXPECT_EQ(lengthOf(-2, 3, 6), 7);
  EXPECT_EQ(lengthOf(0x3p1020, 0x1p1022), 0x5p1020);
  EXPECT_EQ(lengthOf(0x3p-1070, 0x1p-1068), 0x5p-1070);
  EXPECT_EQ(lengthOf(0, 0, 0x1p-1074), 0x1p-1074);
  EXPECT_EQ(lengthOf(0x1p-1074, 0, 1), 1);
  EXPECT_EQ(lengthOf(0x1p-1074, 0x1p1023, 0), 0x1p1023);
  EXPECT_EQ(lengthOf(0, -0.0), 0);
}

TEST(Length, OfWhatIsTooLongOrNoNumber)
{
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(lengthOf(largest, largest), kInfinity);
  EXPECT_EQ(lengthOf(largest, 1), largest);
  EXPECT_EQ(lengthOf(1, -kInfinity, 2), kInfinity);
  EXPECT_EQ(lengthOf(kInfinity, kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(lengthOf(1, std::numeric_limits<double>::quiet_NaN())));
}

/// The bits are those of every system, compiler and processor: compiled for one that can add and
/// multiply at once, too (PointSetsFma).
TEST(Length, HasTheSameBitsEverywhere)
{
  std::mt19937_64 random(2);
  std::uint64_t hash = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const double x = mantissa(random), y = mantissa(random), z = i % 2 == 0 ? 0 : mantissa(random);
    const double length = lengthOf(x, y, z);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &length, sizeof(bits));
    hash = (hash ^ bits) * 0x100000001b3u;
  }
  EXPECT_EQ(hash, 10720143741182402401u);
}

} // namespace
} // namespace test
} // namespace ahd
