// SPDX-License-Identifier: BSD-3-Clause
//
// Cells that are joined by ids, and whose rounded places turn nothing over.
#include "OutlineCase.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

/// A frame whose inner corners are at the places of the outer ones, or beyond them by rounding.
TEST(OutlinesDirected, CellsAreJoinedByIds)
{
  for (const double beyond : { 0.0, 0x1p-52 })
  {
    for (std::size_t first = 0; first < 4; ++first) // either ring is found first
    {
      OutlineCase given;
      const double low = 1 - beyond, high = 2 + beyond;
      given.points = { { 1, 1, 0 }, { 2, 1, 0 }, { 2, 2, 0 }, { 1, 2, 0 }, { low, low, 0 },
        { high, low, 0 }, { high, high, 0 }, { low, high, 0 } };
      for (std::size_t k = first; k < first + 4; ++k)
      {
        const auto a = std::int64_t(k % 4), b = std::int64_t((k + 1) % 4);
        given.addCell({ a, b, b + 4, a + 4 });
      }
      const Outline made = given.outline(true);
      EXPECT_EQ(made.corners, std::vector<Index>({ 0, 1, 2, 3, 4, 7, 6, 5 }));
      EXPECT_EQ(made.polygons, std::vector<Index>({ 0, 2 }));
      EXPECT_NE(given.outline().corners, made.corners);
    }
  }
}

TEST(OutlinesDirected, CellsHaveNoArea)
{
  OutlineCase noArea;
  noArea.points = { { 0, 0, 0 }, { 1e-200, 0, 1 }, { 1e-200, 1e-200, 0 } };
  noArea.addCell({ 0, 1, 2 });
  EXPECT_EQ(noArea.outline().plane, OutlinePlane::Yz);
  EXPECT_EQ(noArea.outline(true).plane, OutlinePlane::Xy);
  noArea.points[2] = { 1e-200, -1e-200, 0 }; // turned over by rounding
  EXPECT_EQ(noArea.outline(true).corners, std::vector<Index>({ 0, 1, 2 }));
}

/// Computed areas have the wrong signs: of the outer ring, and of the hole.
TEST(OutlinesDirected, CellsAreThinnerThanRounding)
{
  for (std::size_t first = 0; first < 3; ++first)
  {
    OutlineCase given;
    given.points = { { 0, 0, 0 }, { 0.484, 0.668, 0 }, { 1.2584, 1.7368000000000001, 0 },
      { 0, 0, 0 }, { 1.4050000000000002, 2.2600000000000002, 0 }, { 0.562, 0.904, 0 } };
    for (std::size_t k = first; k < first + 3; ++k)
    {
      const auto a = std::int64_t(k % 3), b = std::int64_t((k + 1) % 3);
      given.addCell({ a, b, b + 3, a + 3 });
    }
    EXPECT_EQ(given.outline(true).corners, std::vector<Index>({ 0, 1, 2, 3, 5, 4 }));
  }
}

/// Two corners of the hole are where both rings begin.
TEST(OutlinesDirected, AHoleBeginsWithOnePlaceTwice)
{
  for (std::size_t first = 0; first < 5; ++first)
  {
    OutlineCase given;
    given.points = { { 1, 1, 0 }, { 2, 1, 0 }, { 2, 2, 0 }, { 1, 2, 0 }, { 1, 1, 0 }, { 1, 1, 0 },
      { 2, 1, 0 }, { 2, 2, 0 }, { 1, 2, 0 } };
    const std::vector<std::int64_t> frame[] = { { 0, 1, 6, 5 }, { 1, 2, 7, 6 }, { 2, 3, 8, 7 },
      { 3, 0, 4, 8 }, { 0, 5, 4 } };
    for (std::size_t k = first; k < first + 5; ++k)
    {
      given.addCell(frame[k % 5]);
    }
    const Outline made = given.outline(true);
    ASSERT_EQ(made.polygons, std::vector<Index>({ 0, 2 }));
    EXPECT_EQ(std::vector<Index>(made.corners.begin(), made.corners.begin() + 4),
      std::vector<Index>({ 0, 1, 2, 3 }));
  }
}

} // namespace
} // namespace test
} // namespace ahd
