// SPDX-License-Identifier: BSD-3-Clause
//
// Simulated blocks, all in this process, against the engine's one triangulation: the same
// triangles, sorted by the points' global ids, the same statuses, the same report.
#include "BlocksRun.h"
#include "ConstraintMakers.h"
#include "HashedResults.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

const ConstraintView kNone;

void expectEqual(const std::vector<Point>& points, const BlocksWay& way, const std::string& name)
{
  const PointView view = viewOf(points);
  const BlocksOutcome whole = runWhole(view, kNone, FillRule::Orientation);
  EXPECT_EQ(difference(whole, runBlocks(view, kNone, FillRule::Orientation, way)), "")
    << name << ", " << way.blocks << " blocks";
}

TEST(Blocks, EveryDistributionIsAsInOneGo)
{
  for (const Distribution d : allDistributions())
  {
    for (const std::size_t blocks : { 1, 2, 3, 7, 16, 100 })
    {
      BlocksWay way;
      way.blocks = blocks;
      expectEqual(makePoints(d, affordable(d, 2000), 1), way, nameOf(d));
    }
  }
}

TEST(Blocks, EveryFileOfTheCorpusIsAsInOneGo)
{
  for (const NamedPoints& given : pointsOfCorpus(AHD_CORPUS_DIRECTORY))
  {
    for (const std::size_t blocks : { 1, 2, 5, 8, 40 })
    {
      BlocksWay way;
      way.blocks = blocks;
      expectEqual(given.points, way, given.name);
    }
  }
}

/// So that wherever borders are handed to, the result is the same bytes.
TEST(Blocks, NoTreeChangesAnything)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, 3000, 3);
  for (const std::size_t perNode : { 0, 2, 3, 8, 64, 1000 })
  {
    BlocksWay way;
    way.blocks = 37;
    way.blocksPerNode = perNode;
    expectEqual(points, way, "per node " + std::to_string(perNode));
  }
}

TEST(Blocks, GatheredToOneBlockAtAnyLevel)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 3000, 4);
  for (const std::size_t level : { 0, 1, 2 })
  {
    BlocksWay way;
    way.blocks = 20;
    way.blocksPerNode = 2;
    way.gatherLevel = level;
    way.gatherBlock = 13;
    expectEqual(points, way, "gathered at level " + std::to_string(level));
  }
}

TEST(Blocks, AThousandBlocks)
{
  BlocksWay way;
  way.blocks = 1000;
  way.samples = 16;
  expectEqual(makePoints(Distribution::Uniform, reduced(30000), 5), way, "uniform");
  expectEqual(makePoints(Distribution::Lattice, reduced(30000), 5), way, "lattice");
  expectEqual(makePoints(Distribution::RepeatedDraws, reduced(5000), 5), way, "repeated draws");
}

TEST(Blocks, WhereverThePointsAre)
{
  const std::vector<Point> points = makePoints(Distribution::RepeatedDraws, 2000, 6);
  BlocksWay way;
  way.blocks = 6;
  // Boxes that overlap: nothing is safe. All on one block, of which others have none.
  way.owner = [](const Point& p)
  { return std::size_t(std::fabs(p.x * 7919.0 + p.y * 104729.0)) % 6; };
  expectEqual(points, way, "scattered");
  way.owner = [](const Point&) { return std::size_t(4); };
  expectEqual(points, way, "all on one");
}

void expectEqual(const ConstraintCase& given, FillRule rule, const BlocksWay& way)
{
  const BlocksOutcome whole = runWhole(given.view(), given.constraints.view(), rule);
  const BlocksOutcome found = runBlocks(given.view(), given.constraints.view(), rule, way);
  EXPECT_EQ(difference(whole, found), "") << way.blocks << " blocks";
}

TEST(Blocks, SmallConstraintCasesAreAsInOneGo)
{
  for (std::uint64_t seed = 0; seed < reduced(3000) && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    BlocksWay way;
    way.blocks = 1 + seed % 9;
    way.blocksPerNode = seed % 3 == 0 ? 2 : 8;
    const ConstraintCase given = smallConstraintCase(seed);
    SCOPED_TRACE(given.text());
    expectEqual(given, seed % 2 == 0 ? FillRule::Orientation : FillRule::EvenOdd, way);
  }
}

TEST(Blocks, LargeConstraintCasesAreAsInOneGo)
{
  for (const NamedCase& named : constraintCases())
  {
    for (const std::size_t blocks : { 1, 2, 5, 16 })
    {
      SCOPED_TRACE(named.name);
      BlocksWay way;
      way.blocks = blocks;
      way.blocksPerNode = 4;
      expectEqual(named.given, FillRule::Orientation, way);
      expectEqual(named.given, FillRule::EvenOdd, way);
    }
  }
}

TEST(Blocks, BordersOfUniformPointsAreShort)
{
  for (const std::size_t blocks : { 4, 16, 64 })
  {
    const std::size_t each = reduced(10000);
    BlocksWay way;
    way.blocks = blocks;
    const std::vector<Point> points = makePoints(Distribution::Uniform, blocks * each, 7);
    const BlocksOutcome found = runBlocks(viewOf(points), kNone, FillRule::Orientation, way);
    ASSERT_EQ(found.border.size(), blocks);
    double sum = 0.0;
    for (std::size_t b = 0; b < blocks; ++b)
    {
      sum += double(found.border[b]) / std::sqrt(double(found.own[b]));
      EXPECT_LE(double(found.border[b]), 8.0 * std::sqrt(double(found.own[b]))) << b;
    }
    EXPECT_LE(sum / double(blocks), 6.0) << blocks << " blocks";
    std::printf("%zu blocks: %.2f\n", blocks, sum / double(blocks));
  }
}

} // namespace
} // namespace test
} // namespace ahd
