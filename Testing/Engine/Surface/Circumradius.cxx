// SPDX-License-Identifier: BSD-3-Clause
//
// Circles through three points in space, and lengths.
#include "Surface/Circumradius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

} // namespace
} // namespace test
} // namespace ahd
