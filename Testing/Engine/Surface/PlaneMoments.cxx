// SPDX-License-Identifier: BSD-3-Clause
//
// The sums of the best-fitting plane: exact, and so the same for any order and any parts.
#include "Surface/PlaneMoments.h"

#include "Random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

using Words = std::array<std::uint64_t, 3>;
constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

TEST(PlaneMoments, CarriesGoThrough)
{
  WideSum sum;
  for (int k = 0; k < 3; ++k)
  {
    sum.add(kMost, kMost); // 2^128 - 2^65 + 1
  }
  EXPECT_EQ(sum.words, (Words{ { 3, kMost - 5, 2 } }));
  WideSum twice = sum;
  twice.merge(sum);
  EXPECT_EQ(twice.words, (Words{ { 6, kMost - 11, 5 } }));
  WideSum full, one;
  full.words = { { kMost, kMost, 7 } };
  one.add(1, 1);
  full.merge(one);
  EXPECT_EQ(full.words, (Words{ { 0, 0, 8 } }));
  EXPECT_EQ(WideSum().value().size, 0);
  EXPECT_EQ(full.value().size, 3);
}

TEST(PlaneMoments, PartsAddUpToAll)
{
  Random random(1);
  std::vector<std::array<std::uint64_t, 3>> places(5000);
  for (auto& place : places)
  {
    place = { { random.bits() >> 1, random.bits() >> 1, random.bits() >> 20 } };
  }
  PlaneMoments all;
  std::array<PlaneMoments, 7> parts;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    all.add(places[i]);
    parts[i * i % 7].add(places[i]);
  }
  PlaneMoments sum;
  for (const PlaneMoments& part : parts)
  {
    sum.merge(part);
  }
  for (std::size_t k = 0; k < 6; ++k)
  {
    EXPECT_EQ(sum.product[k].words, all.product[k].words);
    EXPECT_EQ(sum.single[k / 2].words, all.single[k / 2].words);
  }
}

TEST(PlaneMoments, EachIsOfItsCoordinates)
{
  PlaneMoments moments;
  moments.add({ { 2, 3, 5 } });
  moments.add({ { 7, 11, 13 } });
  const std::uint64_t single[] = { 9, 14, 18 }, product[] = { 53, 83, 101, 130, 158, 194 };
  for (std::size_t k = 0; k < 6; ++k)
  {
    EXPECT_EQ(moments.product[k].words[0], product[k]);
    EXPECT_EQ(moments.single[k / 2].words[0], single[k / 2]);
  }
}

/// 62 bits of the farthest, whatever its size.
TEST(PlaneMoments, PlacesAreWholeNumbersFromTheOrigin)
{
  constexpr std::uint64_t zero = PlaneScale::kZero, quarter = zero / 4;
  for (const int exponent : { -1074, -1022, -300, 0, 300, 1022 })
  {
    const double unit = std::ldexp(1.0, exponent);
    for (const double origin : { 0.0, exponent < 900 ? 1024 * unit : 0.0 })
    {
      const PlaneScale scale(origin, 2 * unit); // below 4 units
      EXPECT_EQ(scale(origin), zero);
      EXPECT_EQ(scale(origin + unit), zero + quarter) << exponent;
      EXPECT_EQ(scale(origin - 2 * unit), zero - 2 * quarter) << exponent;
    }
  }
  const PlaneScale scale(0.0, 1.75);
  EXPECT_EQ(scale(1.0 + 0x1p-52), zero + zero / 2 + 512);
  EXPECT_EQ(scale(0x1p-61), zero + 1);
  EXPECT_EQ(scale(0x1.8p-61), zero + 1); // cut off
  EXPECT_EQ(scale(-0x1.8p-61), zero - 1);
  EXPECT_EQ(PlaneScale(1e300, 0.0)(1e300), zero);
}

} // namespace
} // namespace test
} // namespace ahd
