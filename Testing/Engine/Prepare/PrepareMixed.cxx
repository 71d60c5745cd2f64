// SPDX-License-Identifier: BSD-3-Clause
//
// Sources in which some points have heights, and others take theirs from the surface of all that
// have one.
#include "PrepareSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

/// A ridge as a line with heights, over a plain; a road without heights across it, through a place
/// that is no double.
struct Ridge
{
  Ridge()
    : given({ { { 0, 0, 0 } }, { { 10, 0, 0 } }, { { 10, 10, 0 } }, { { 0, 10, 0 } } },
        { { { 4, 1, 8 } }, { { 7, 9, 8 } }, { { 1, 4, kNoHeight } }, { { 9, 4.5, kNoHeight } } },
        { { 0, 1 }, { 2, 3 } })
  {
  }
  PrepareCase given;
};

TEST(PrepareMixed, WithoutHeightsLieOnLinesThatHaveSome)
{
  for (const bool split : { false, true })
  {
    Ridge ridge;
    ridge.given.request.split = split;
    const PreparedInput out = laid(ridge.given, SourceHeights::Mixed);
    EXPECT_EQ(out.outsideCount(), 0u);
    EXPECT_EQ(out.place(4)[2], 8.0);
    EXPECT_EQ(out.place(5)[2], 8.0);
    EXPECT_FALSE(out.surfacePlaces()[0].isInside());
    std::vector<Xyz> corners = ridge.given.input();
    corners.push_back(out.place(4));
    corners.push_back(out.place(5));
    const Surface surface(corners, { { 4, 5 } });
    std::size_t onRidge = 0;
    const ConstraintView chains = out.constraints();
    for (std::int64_t k = chains.offsets[1]; k < chains.offsets[2]; ++k)
    {
      const Xyz p = out.place(std::size_t(chains.ids[k]));
      ASSERT_NEAR(p[2], surface.heightAt({ p[0], p[1] }), 1e-12);
      onRidge += std::size_t(std::abs(p[2] - 8.0) < 1e-12);
    }
    EXPECT_EQ(onRidge, 1u);
    EXPECT_EQ(chains.offsets[1], 3) << "the ridge is led through the same point";
    EXPECT_EQ(std::count(chains.ids + 3, chains.ids + chains.offsets[2], chains.ids[1]), 1);
    EXPECT_EQ(out.crossings().size(), 0u) << "which needs no other";
  }
}

TEST(PrepareMixed, ZeroIsAHeightUnlessItIsSaidToBeMissing)
{
  PrepareCase given({ { { 0, 0, 1 } }, { { 4, 0, 1 } }, { { 0, 4, 1 } } },
    { { { 1, 1, 0 } }, { { 1, 2, -0.0 } }, { { 2, 1, kNoHeight } }, { { 9, 9, kNoHeight } } });
  const PreparedInput out = laid(given, SourceHeights::Mixed);
  EXPECT_EQ(out.place(3)[2], 0.0);
  EXPECT_EQ(out.outsideCount(), 1u);
  EXPECT_TRUE(std::isnan(out.place(6)[2]));
  given.request.zeroIsMissing = true;
  const PreparedInput all = laid(given, SourceHeights::Mixed);
  EXPECT_EQ(all.place(3)[2], 1.0);
  EXPECT_EQ(all.place(4)[2], 1.0);
  EXPECT_EQ(all.place(5)[2], 1.0);
}

TEST(PrepareMixed, AtACrossingTheLineWithHeightsDecides)
{
  Ridge ridge;
  ridge.given.request.split = true;
  ridge.given.request.heights = SourceHeights::Mixed; // and straight
  const PreparedInput out = prepared(ridge.given.request);
  ASSERT_EQ(out.crossings().size(), 1u);
  EXPECT_EQ(out.place(out.firstCrossing())[2], 8.0);
}

TEST(PrepareMixed, FromAPointWithAHeightToOneWithoutLieOnTheSurface)
{
  Ridge ridge;
  PrepareCase given(ridge.given.input(), ridge.given.source(), { { 0, 1 }, { 1, 2 } });
  const PreparedInput out = laid(given, SourceHeights::Mixed);
  const ConstraintView chains = out.constraints();
  EXPECT_GT(chains.offsets[2] - chains.offsets[1], 2) << "points were added";
  EXPECT_EQ(chains.offsets[1], 2) << "none between heights";
}

/// Of the points added to lines, in the order of the numbers.
std::vector<Xyz> addedOf(const PreparedInput& out)
{
  std::vector<Xyz> added;
  for (std::size_t k = 0; k < out.addedToLines(); ++k)
  {
    added.push_back(out.place(out.inputCount() + out.sourceCount() + k));
  }
  std::sort(added.begin(), added.end());
  return added;
}

TEST(PrepareMixed, HaveTheSameHeightsInBothDirections)
{
  const std::vector<Xyz> input = { { { 0, 0, 0 } }, { { 9, 0, 0 } }, { { 9, 9, 0 } },
    { { 0, 9, 0 } } };
  std::vector<Xyz> source = { { { 4, 1, 1.0 / 3 } }, { { 5, 8, 7.7 } } };
  Cells there = { { 0, 1 } }, back = there;
  for (std::int64_t k = 0; k < 40; ++k)
  {
    source.push_back({ { 2, 1.3 + 0.17 * double(k), kNoHeight } });
    source.push_back({ { 7, 1.7 + 0.15 * double(k), kNoHeight } });
    there.push_back({ 2 * k + 2, 2 * k + 3 });
    back.push_back({ 2 * k + 3, 2 * k + 2 });
  }
  PrepareCase first(input, source, there), second(input, source, back);
  const std::vector<Xyz> added = addedOf(laid(first, SourceHeights::Mixed));
  ASSERT_GT(added.size(), 40u);
  EXPECT_EQ(added, addedOf(laid(second, SourceHeights::Mixed)));
}

TEST(PrepareMixed, OneThatCrossesAnotherIsDividedAlikeInBothDirections)
{
  const std::vector<Xyz> input = { { { -5, -5, 0 } }, { { 15, -5, 0 } }, { { 15, 15, 0 } },
    { { -5, 15, 0 } }, { { 3, 0, 8 } } };
  const std::vector<Xyz> source = { { { 7, -1, 8 } }, { { 7, 1, 8 } }, { { 0, 0, 8 } },
    { { 10, 0, 8 } }, { { 6, 0.5, kNoHeight } }, { { 8, 0.6, kNoHeight } } };
  PrepareCase there(input, source, { { 0, 1 }, { 2, 3 }, { 4, 5 } });
  PrepareCase back(input, source, { { 0, 1 }, { 3, 2 }, { 4, 5 } });
  there.request.maximumSegmentLength = back.request.maximumSegmentLength = 4.0;
  EXPECT_EQ(addedOf(laid(there, SourceHeights::Mixed)), addedOf(laid(back, SourceHeights::Mixed)));
}

} // namespace
} // namespace test
} // namespace ahd
