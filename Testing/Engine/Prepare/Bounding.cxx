// SPDX-License-Identifier: BSD-3-Clause
//
// The eight points of vtkDelaunay2D's bounding triangulation. test_filter.py (Testing/Filters)
// compares them with vtkDelaunay2D itself.
#include "Prepare/Bounding.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

TEST(Bounding, EightPointsOnACircle)
{
  const auto points = boundingPoints({ { 1, 2, 3 } }, { { 5, 6, 5 } }, 2.0);
  const double radius = 2.0 * 6.0; // the diagonal of 4, 4, 2
  const double s = radius * std::sqrt(0.5);
  const double expected[8][2] = { { radius, 0 }, { s, s }, { 0, radius }, { -s, s }, { -radius, 0 },
    { -s, -s }, { 0, -radius }, { s, -s } };
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_NEAR(points[i][0], 3 + expected[i][0], 1e-14) << "point " << i;
    EXPECT_NEAR(points[i][1], 4 + expected[i][1], 1e-14) << "point " << i;
    EXPECT_EQ(points[i][2], 4) << "point " << i;
  }
}

TEST(Bounding, TinyAndHugeBoxes)
{
  const auto tiny = boundingPoints({ { 0, 0, 0 } }, { { 3e-300, 4e-300, 0 } }, 1.0);
  EXPECT_NEAR(tiny[0][0] / 1e-300, 6.5, 1e-14);
  const auto huge = boundingPoints({ { -DBL_MAX, 0, 0 } }, { { DBL_MAX, DBL_MAX, DBL_MAX } }, 4.0);
  EXPECT_EQ(huge[0][0], DBL_MAX);
  EXPECT_EQ(huge[4][0], -DBL_MAX);
  EXPECT_EQ(huge[0][1], DBL_MAX / 2);
  const auto none = boundingPoints({ { 7, 8, 9 } }, { { 7, 8, 9 } }, DBL_MAX);
  for (const Vector3& p : none)
  {
    EXPECT_EQ(p, (Vector3{ { 7, 8, 9 } }));
  }
}

} // namespace
} // namespace test
} // namespace ahd
