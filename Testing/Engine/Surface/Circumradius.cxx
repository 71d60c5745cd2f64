// SPDX-License-Identifier: BSD-3-Clause
//
// Circles through three points in space, and lengths.
#include "Surface/Circumradius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Xyz = Vector3;

TEST(Circumradius, OfTrianglesOfAllSizes)
{
  for (const double size : { 1e-300, 1e-100, 1e-3, 1.0, 1e61, 1e150, 1e290 })
  {
    const Xyz a = { { 3 * size, 0, 0 } }, b = { { 0, 0, 4 * size } }, o = { { 0, 0, 0 } };
    for (const double radius :
      { circumradius(a, b, o), circumradius(b, o, a), circumradius(o, a, b) })
    {
      EXPECT_NEAR(radius / size, 2.5, 1e-12) << size;
    }
  }
}

TEST(Circumradius, OfCollinearOrOddPoints)
{
  EXPECT_EQ(circumradius({ { 0, 0, 0 } }, { { 1, 1, 1 } }, { { 3, 3, 3 } }), 1e299);
  EXPECT_EQ(circumradius({ { 1, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 0, 0 } }), 1e299);
  const double most = std::numeric_limits<double>::max() / 4;
  EXPECT_EQ(circumradius({ { -most, 0, 0 } }, { { most, 0, 0 } }, { { 0, most, 0 } }), 1e299);
  EXPECT_TRUE(std::isnan(circumradius({ { 0, 0, kNaN } }, { { 1, 0, 0 } }, { { 0, 1, 0 } })));
}

TEST(Circumradius, LengthsNeitherOverflowNorUnderflow)
{
  for (const double size : { 1e-320, 1e-160, 1.0, 1e160, 1e307 })
  {
    EXPECT_NEAR(
      lengthOf({ { 2 * size, -3 * size, 6 * size } }) / size, 7.0, size < 1e-300 ? 1e-2 : 1e-14);
  }
}

TEST(Circumradius, LimitsDecideAsTheRoundedNumbersDo)
{
  std::mt19937_64 random(1); // its sequence is fixed by the standard
  const auto fraction = [&random] { return double(random() >> 11) * 0x1p-53; };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double size : { 1e-300, 1e-142, 1e-60, 1e-39, 1.0, 1e39, 1e60, 1e142, 1e290 })
  {
    for (int i = 0; i < 300; ++i)
    {
      const double flat = i % 3 == 0 ? 1e-5 : i % 3 == 1 ? 1e-15 : 1.0;
      Xyz p[3];
      for (Xyz& at : p)
      {
        at = { { size * fraction(), flat * size * fraction(), flat * size * fraction() } };
      }
      const double radius = circumradius(p[0], p[1], p[2]), length = lengthOf(p[0]);
      for (const double factor : { 0.5, 1 - 1e-9, 1 - 1e-12, 1.0, 1 + 1e-12, 1 + 1e-9, 2.0 })
      {
        EXPECT_EQ(RadiusLimit(factor * radius).isExceeded(p[0], p[1], p[2]), factor < 1.0);
        EXPECT_EQ(LengthLimit(factor * length).isExceeded(p[0]), factor < 1.0);
      }
      EXPECT_TRUE(RadiusLimit(std::nextafter(radius, 0.0)).isExceeded(p[0], p[1], p[2]));
      EXPECT_FALSE(RadiusLimit(std::nextafter(radius, kInfinity)).isExceeded(p[0], p[1], p[2]));
      EXPECT_TRUE(LengthLimit(std::nextafter(length, 0.0)).isExceeded(p[0]));
      const Point flatOnes[3] = { { p[0][0], p[0][1] }, { p[1][0], p[1][1] },
        { p[2][0], p[2][1] } };
      for (int k = 0; k < 3; ++k)
      {
        const Point a = flatOnes[k], b = flatOnes[(k + 1) % 3], c = flatOnes[(k + 2) % 3];
        const LengthLimit limit(lengthOf({ { a.x - b.x, a.y - b.y, 0.0 } }));
        EXPECT_FALSE(limit.isExceeded(a, b));
        EXPECT_EQ(limit.isExceeded(a, b, c), limit.isExceeded(b, c) || limit.isExceeded(c, a));
        EXPECT_EQ(limit.isExceeded(a, a, c), limit.isExceeded(a, c));
      }
    }
  }
  EXPECT_FALSE(RadiusLimit(1.0).isExceeded({ { 0, 0, kNaN } }, { { 9, 0, 0 } }, { { 0, 9, 0 } }));
  EXPECT_FALSE(LengthLimit(1.0).isExceeded({ { 9, kNaN, 0 } }));
}

} // namespace
} // namespace test
} // namespace ahd
