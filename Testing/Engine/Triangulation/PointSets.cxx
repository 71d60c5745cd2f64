// SPDX-License-Identifier: BSD-3-Clause
//
// The bits of the point sets that tests, benchmarks and vtkPlanarPointSource make. Built twice, the
// second time for processors with AVX2 and fused multiply-adds, which must not change a bit.
#include "Distributions.h"

#include <gtest/gtest.h>

#include <cstring>

namespace
{

using namespace ahd;
using namespace ahd::test;

struct Hash
{
  Distribution distribution;
  std::uint64_t value;
};

/// Of 100003 points with seed 7: must never change. Budgets of instructions and counts of work in
/// other tests hold for these points.
constexpr Hash kHashes[] = {
  { Distribution::Uniform, 0xD7F0D9252F579630ull },
  { Distribution::Line, 0xC827701BAE361EA6ull },
  { Distribution::Cross, 0x4A168C97E5D44CE6ull },
  { Distribution::Circle, 0xCDDDCCCE30334542ull },
  { Distribution::Spiral, 0xE62FA66E6756A35Cull },
  { Distribution::Mixed, 0x546974C87C482827ull },
  { Distribution::KuzminDisc, 0xDAB4344C9CEB4FF2ull },
  { Distribution::NestedClusters, 0x7D5A19E38F692983ull },
  { Distribution::CrowdedBox, 0xFA5A6F2DA87293EAull },
  { Distribution::Lattice, 0x42458A1F6AB3A738ull },
  { Distribution::DecimalLattice, 0xFD9E9AFC76DB26AEull },
  { Distribution::OnCircle, 0x30EA4CA8B2C148DAull },
  { Distribution::OnIntegerCircle, 0x0FA350EC794E5DB6ull },
  { Distribution::OnParabola, 0xA7C7B67180F7270Dull },
  { Distribution::Collinear, 0x52FB1CFFFCD9D63Dull },
  { Distribution::NearlyCollinear, 0x8636538EB26F63E2ull },
  { Distribution::AllEqual, 0x3E53702608A17DBBull },
  { Distribution::RepeatedDraws, 0xC59143236F97CE62ull },
  { Distribution::Utm, 0x87DD8B91DC06F52Full },
  { Distribution::UtmRaster, 0x3B0C2F20F58DCBF0ull },
  { Distribution::Slivers, 0x54F5BBA05B878559ull },
  { Distribution::Tiny, 0x3D757486275C7B62ull },
  { Distribution::Huge, 0x894390BDF09AFF3Bull },
  { Distribution::TinyAndHuge, 0xF60DD0AC54942885ull },
  { Distribution::AnyFinite, 0x028F961C431A8B07ull },
};

/// FNV-1a of the bytes of all coordinates, the least byte of each first.
std::uint64_t hashOf(const std::vector<Point>& points)
{
  std::uint64_t hash = 0xCBF29CE484222325ull;
  for (const Point& p : points)
  {
    for (const double coordinate : { p.x, p.y })
    {
      std::uint64_t bits;
      std::memcpy(&bits, &coordinate, sizeof bits);
      for (int shift = 0; shift < 64; shift += 8)
      {
        hash = (hash ^ ((bits >> shift) & 0xFF)) * 0x100000001B3ull;
      }
    }
  }
  return hash;
}

TEST(PointSets, BitsAreTheSameEverywhereAndForEver)
{
  ASSERT_EQ(sizeof kHashes / sizeof kHashes[0], allDistributions().size());
  for (const Hash& hash : kHashes)
  {
    EXPECT_EQ(hashOf(makePoints(hash.distribution, 100003, 7)), hash.value)
      << nameOf(hash.distribution);
  }
}

TEST(PointSets, MorePointsAreAppended)
{
  for (const Distribution distribution : paperDistributions())
  {
    const std::vector<Point> few = makePoints(distribution, 1000, 3);
    std::vector<Point> many = makePoints(distribution, 5000, 3);
    many.resize(few.size());
    EXPECT_EQ(many, few) << nameOf(distribution);
  }
}

TEST(PointSets, LatticesAreFilledRowByRow)
{
  EXPECT_EQ(latticeSide(0), 0u);
  EXPECT_EQ(latticeSide(1), 1u);
  EXPECT_EQ(latticeSide(9), 3u);
  EXPECT_EQ(latticeSide(10), 4u);
  EXPECT_EQ(latticeSide(std::size_t(1) << 40), std::size_t(1) << 20);
  EXPECT_EQ(latticeSide((std::size_t(1) << 40) + 1), (std::size_t(1) << 20) + 1);
  const std::vector<Point> expected = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 1, 1 } };
  EXPECT_EQ(makePoints(Distribution::Lattice, 5, 1), expected);
}

} // namespace
