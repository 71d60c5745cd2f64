// SPDX-License-Identifier: BSD-3-Clause
//
// Simulated blocks, all in this process, against the engine's one triangulation: the same
// triangles, sorted by the points' global ids, the same statuses, the same report.
#include "BlocksRun.h"
#include "ConstraintMakers.h"
#include "Executors.h"
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

/// Wherever borders are sent, the result is the same bytes.
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
  // Boxes that overlap: no triangle is final on one block. Or all points on one block, none on
  // others.
  way.owner = [](const Point& p)
  { return std::size_t(std::fabs(p.x * 7919.0 + p.y * 104729.0)) % 6; };
  expectEqual(points, way, "scattered");
  // A block in the middle of another one: what is not final there is far from any hull.
  const std::vector<Point> uniform = makePoints(Distribution::Uniform, 2000, 6);
  way.owner = [](const Point& p)
  { return std::size_t(std::hypot(p.x - 0.5, p.y - 0.5) < 0.1 ? 1 : 3); };
  expectEqual(uniform, way, "one in another");
  way.owner = [](const Point&) { return std::size_t(4); };
  expectEqual(points, way, "all on one");
}

void expectEqual(const ConstraintCase& given, FillRule rule, const BlocksWay& way)
{
  const BlocksOutcome whole = runWhole(given.view(), given.constraints.view(), rule);
  const BlocksOutcome found = runBlocks(given.view(), given.constraints.view(), rule, way);
  EXPECT_EQ(difference(whole, found), "") << way.blocks << " blocks";
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

/// Its ends are vertices that no other segment brings to the border.
TEST(Blocks, SegmentsOfNoLengthDeepInside)
{
  ConstraintCase given;
  given.points = makePoints(Distribution::Uniform, 4000, 8);
  given.points.push_back(given.points[17]);
  for (const std::int64_t id : { 5, 17, 99, 1234 })
  {
    given.constraints.addLine({ id, id });
  }
  given.constraints.addLine({ 4000, 17 });
  given.constraints.addLine({ 20, 1000000 });
  given.constraints.addLoop({ 7, 4000, 17 });
  given.constraints.addLoop({ 17, 30, 4000 });
  given.constraints.addLoop({ -1, 30, 1000000 });
  for (const std::size_t perNode : { 2, 64 })
  {
    BlocksWay way;
    way.blocks = 16;
    way.blocksPerNode = perNode;
    expectEqual(given, FillRule::Orientation, way);
  }
}

/// A loop in the middle of a block, and one around blocks: whole blocks are dropped, and pieces of
/// them.
TEST(Blocks, LoopsInsideAndAroundBlocks)
{
  ConstraintCase given;
  given.points = makePoints(Distribution::Uniform, 6000, 9);
  const auto nearest = [&](double x, double y)
  {
    std::int64_t best = 0;
    const auto far = [&](std::int64_t i)
    { return std::hypot(given.points[std::size_t(i)].x - x, given.points[std::size_t(i)].y - y); };
    for (std::int64_t i = 0; i < std::int64_t(given.points.size()); ++i)
    {
      best = far(i) < far(best) ? i : best;
    }
    return best;
  };
  const auto square = [&](double x, double y, double half)
  {
    return Chain{ nearest(x - half, y - half), nearest(x + half, y - half),
      nearest(x + half, y + half), nearest(x - half, y + half) };
  };
  given.constraints.addLoop(square(0.5, 0.5, 0.45));
  given.constraints.addLoop(square(0.3, 0.3, 0.15));
  given.constraints.addLoop(square(0.3, 0.3, 0.05));
  given.constraints.addLoop(square(0.8, 0.2, 0.02));
  for (const std::size_t blocks : { 1, 4, 9, 30 })
  {
    for (const FillRule rule : { FillRule::Orientation, FillRule::EvenOdd })
    {
      BlocksWay way;
      way.blocks = blocks;
      way.blocksPerNode = 2;
      expectEqual(given, rule, way);
    }
  }
}

/// Some ten points of a small lattice, at any scale, in more blocks than points.
void expectLatticesEqual(std::uint64_t first, std::uint64_t end)
{
  for (std::uint64_t seed = first; seed < end && !testing::Test::HasFailure(); ++seed)
  {
    Random random(seed);
    const double scale = std::ldexp(1.0, int(random.below(2000)) - 1000);
    std::vector<Point> points;
    for (std::uint64_t n = 3 + random.below(30); n > 0; --n)
    {
      points.push_back({ double(random.below(6)) * scale, double(random.below(6)) * scale });
      if (random.below(10) == 0)
      {
        points.back().x = random.below(2) == 0 ? 1e300 : -1e-300;
      }
    }
    BlocksWay way;
    way.blocks = 1 + random.below(12);
    way.blocksPerNode = 2 + random.below(7);
    way.samples = 1 + random.below(40);
    expectEqual(points, way, "seed " + std::to_string(seed));
  }
}

void expectSmallCasesEqual(std::uint64_t first, std::uint64_t end)
{
  for (std::uint64_t seed = first; seed < end && !testing::Test::HasFailure(); ++seed)
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

TEST(Blocks, SmallLatticesInManyBlocks)
{
  expectLatticesEqual(0, reduced(4000));
}

TEST(Blocks, SmallConstraintCasesAreAsInOneGo)
{
  expectSmallCasesEqual(0, reduced(3000));
}

TEST(LongBlocks, SmallSetsInManyBlocks)
{
  expectLatticesEqual(10000, 150000);
  expectSmallCasesEqual(10000, 150000);
}

/// The block that has all of several points decides which of them represents the vertex.
TEST(Blocks, RepresentativesByHeight)
{
  std::vector<double> xyz;
  Random random(3);
  for (int i = 0; i < 2000; ++i)
  {
    xyz.push_back(double(random.below(20)));
    xyz.push_back(double(random.below(20)));
    xyz.push_back(double(random.below(5)));
  }
  const PointView view(xyz.data(), 2000, 3);
  for (const Representative which :
    { Representative::FirstId, Representative::LowestZ, Representative::HighestZ })
  {
    BlocksWay way;
    way.blocks = 11;
    way.options.representative = which;
    EXPECT_EQ(difference(runWhole(view, kNone, FillRule::Orientation, way.options),
                runBlocks(view, kNone, FillRule::Orientation, way)),
      "");
  }
}

TEST(Blocks, NoThreadAndNoSettingChangesAnything)
{
  ThreadExecutor threads(3);
  const std::vector<Point> points = makePoints(Distribution::Mixed, 50000, 10);
  BlocksWay way;
  way.blocks = 3;
  way.context.executor = &threads;
  expectEqual(points, way, "threads");
  way.context.executor = nullptr;
  way.options.order = InsertionOrder::RegularGrid;
  expectEqual(points, way, "another order");
}

TEST(Blocks, BordersOfUniformPointsAreShort)
{
  for (const std::size_t blocks : { 4, 16, 64, 256 })
  {
    const std::size_t each = reduced(blocks < 256 ? 10000 : 3000);
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
    RecordProperty("blocks_" + std::to_string(blocks), std::to_string(sum / double(blocks)));
  }
}

} // namespace
} // namespace test
} // namespace ahd
