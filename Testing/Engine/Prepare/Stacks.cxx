// SPDX-License-Identifier: BSD-3-Clause
//
// Walls, volumes and lines, distinguished from terrain.
#include "Prepare/Stacks.h"
#include "PrepareCase.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

bool isOnOneLine(const std::vector<Xyz>& points)
{
  bool found = false;
  EXPECT_EQ(findIfOnOneLine(viewOf(points), Context(), found), Status::Ok);
  return found;
}

bool isStacked(const std::vector<Xyz>& points)
{
  bool found = false;
  EXPECT_EQ(findIfStacked(viewOf(points), Context(), found), Status::Ok);
  return found;
}

std::vector<Xyz> block(int nx, int ny, int nz)
{
  std::vector<Xyz> points;
  for (int i = 0; i < nx * ny * nz; ++i)
  {
    points.push_back({ { 0.1 * (i % nx), 0.3 * (i / nx % ny), 0.7 * (i / nx / ny) } });
  }
  return points;
}

TEST(Stacks, ALineIsOneWhereverItRuns)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(isOnOneLine({}));
  EXPECT_TRUE(isOnOneLine({ { { 1, 2, 3 } }, { { 1, 2, 3 } } }));
  EXPECT_TRUE(isOnOneLine(block(9, 1, 1)));
  EXPECT_TRUE(isOnOneLine(block(1, 1, 9)));
  for (const double scale : { 1.0, 1e-200, 1e307 })
  {
    std::vector<Xyz> points;
    for (int i = -8; i < 9; ++i)
    {
      points.push_back({ { 0.1 * i * scale, 0.3 * i * scale, 0.7 * i * scale } });
    }
    points.push_back({ { nan, 3, 4 } });
    EXPECT_TRUE(isOnOneLine(points)) << scale;
    points.push_back({ { 0, 0, 0.3 * scale } });
    EXPECT_FALSE(isOnOneLine(points)) << scale;
  }
}

TEST(Stacks, AWallIsNoLine)
{
  EXPECT_FALSE(isOnOneLine(block(9, 1, 2)));
  EXPECT_FALSE(isOnOneLine(block(1, 9, 9)));
}

TEST(Stacks, AVolumeIsStackedAndTerrainIsNot)
{
  EXPECT_TRUE(isStacked(block(10, 10, 3)));
  EXPECT_TRUE(isStacked(block(300, 1, 20)));
  EXPECT_FALSE(isStacked(block(50, 50, 1)));
  EXPECT_FALSE(isStacked({}));
}

TEST(Stacks, PointsThatAreTheSameInSpaceAreNoStack)
{
  std::vector<Xyz> points = block(20, 20, 1);
  for (int i = 0; i < 5; ++i) // a triangle soup names each corner about six times
  {
    points.insert(points.end(), points.begin(), points.begin() + 400);
  }
  EXPECT_FALSE(isStacked(points));
}

TEST(Stacks, MostIsMoreThanHalf)
{
  std::vector<Xyz> points = block(100, 1, 1);
  for (std::size_t i = 0; i < 30; ++i)
  {
    points.push_back({ { points[i][0], points[i][1], 5 } });
  }
  EXPECT_FALSE(isStacked(points)) << "60 of 130";
  for (std::size_t i = 30; i < 60; ++i)
  {
    points.push_back({ { points[i][0], points[i][1], 5 } });
  }
  EXPECT_TRUE(isStacked(points)) << "120 of 160";
}

} // namespace
} // namespace test
} // namespace ahd
