// SPDX-License-Identifier: BSD-3-Clause
//
// What was kept and has changed is refused; a plan is the same whatever a host program has set;
// lines that fail leave the plan as it was.
#include "HostModes.h"
#include "Job/JobTiles.h"
#include "OwnMemory.h"
#include "TilesRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

/// Lines, then a loop, between points.
TileLines linesAmong(const std::vector<Point>& points)
{
  return { { points.begin(), points.begin() + 9 }, { 0, 4, 9 }, 1, 0 };
}

/// Some of its bits, one at a time, are turned while work(bit) runs.
template <typename Work>
void eachChange(BlockBytes bytes, std::size_t most, Work work)
{
  std::mt19937_64 random(1);
  for (std::size_t k = 0; k != most; ++k)
  {
    const std::size_t bit = random() % (8 * bytes.size());
    const auto turned = static_cast<unsigned char>(1u << bit % 8);
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ turned);
    work(viewOf(bytes), bit);
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ turned);
  }
}

class TilesBytes : public testing::Test
{
protected:
  TilesBytes()
    : points_(makePoints(Distribution::Uniform, 600, 1))
  {
    TilesWay way;
    way.most = 60;
    way.lines = linesAmong(points_);
    run_ = std::make_unique<TilesRun>(viewOf(points_), way);
  }

  const TileVisits& visits() const { return run_->visits(); }
  const TilePlan& plan() const { return run_->plan(); }
  bool readsOwn(std::size_t leaf, const TileView& own) const
  {
    TileKept kept;
    return visits().readKept(leaf, &own, run_->sharesFor(leaf), kept);
  }

  std::vector<Point> points_;
  std::unique_ptr<TilesRun> run_;
};

TEST_F(TilesBytes, ChangedBordersAreRefused)
{
  for (std::size_t part = 0; part != plan().root(); ++part)
  {
    const std::size_t node = plan().parents()[part];
    const std::vector<std::size_t>& parts = plan().joinedBy(node);
    std::vector<TileView> given;
    for (const std::size_t below : parts)
    {
      given.push_back(viewOf(run_->borders()[below]));
    }
    std::vector<TileBorder> borders;
    ASSERT_TRUE(visits().readBorders(node, given, borders));
    TileView& own = given[std::size_t(std::find(parts.begin(), parts.end(), part) - parts.begin())];
    eachChange(run_->borders()[part], 100,
      [&](const TileView& changed, std::size_t bit)
      {
        own = changed;
        ASSERT_FALSE(visits().readBorders(node, given, borders)) << "part " << part << " " << bit;
      });
  }
}

TEST_F(TilesBytes, ChangedOwnsAreRefused)
{
  for (std::size_t leaf = 0; leaf != plan().leaves(); ++leaf)
  {
    ASSERT_TRUE(readsOwn(leaf, viewOf(run_->owns()[leaf])));
    eachChange(run_->owns()[leaf], 100,
      [&](const TileView& changed, std::size_t bit)
      { ASSERT_FALSE(readsOwn(leaf, changed)) << "leaf " << leaf << " " << bit; });
  }
}

/// By the leaf whose section was changed; others read what they did.
TEST_F(TilesBytes, ChangedSharesAreRefused)
{
  const auto isSame = [](const TileSection& a, const TileSection& b)
  {
    BlockBytes first, second;
    BytesWriter{ first }(a);
    BytesWriter{ second }(b);
    return first == second;
  };
  for (std::size_t node = plan().leaves(); node != plan().parts(); ++node)
  {
    const BlockRow row = plan().rowOf(node);
    eachChange(run_->shares()[node], 300,
      [&](const TileView& changed, std::size_t bit)
      {
        std::size_t refused = 0;
        for (std::size_t leaf = row.begin; leaf != row.end; ++leaf)
        {
          TileSection right, found;
          ASSERT_TRUE(readSection(plan(), node, leaf, viewOf(run_->shares()[node]), right));
          const bool isRead = readSection(plan(), node, leaf, changed, found);
          ASSERT_TRUE(!isRead || isSame(found, right)) << "node " << node << " " << bit;
          refused += isRead ? 0u : 1u;
        }
        ASSERT_GT(refused, 0u) << "node " << node << " " << bit;
      });
  }
}

// ------------------------------------------------------------------------- of jobs, and their
// plans

GivenArray given(const std::vector<Point>& points)
{
  return { points.data(), kFloat64, 2, std::int64_t(points.size()), sizeof(Point), sizeof(double) };
}

BlockBytes planOf(const std::vector<Point>& points, JobTiles& tiles)
{
  const double extent[] = { -0.7, 1.9, -0.3, 1.1 };
  tiles.begin(nullptr);
  do
  {
    tiles.count(given(points), {});
  } while (tiles.endPass(40, extent));
  return tiles.tables().plan;
}

TEST(TilesOfJobs, ModesOfAHostChangeNoPlan)
{
  const std::vector<Point> points = makePoints(Distribution::Utm, 500, 1);
  JobTiles expected;
  planOf(points, expected);
  expected.setLines(linesAmong(points));
  for (const HostMode& mode : hostModes())
  {
    enter(mode);
    JobTiles tiles;
    planOf(points, tiles);
    tiles.setLines(linesAmong(points));
    leaveHostMode();
    EXPECT_EQ(tiles.tables().plan, expected.tables().plan) << mode.name;
    EXPECT_EQ(tiles.tables().boxes, expected.tables().boxes) << mode.name;
    for (std::size_t k = 0; k != expected.plan().parts(); ++k)
    {
      const Bounds a = tiles.plan().reach(k), b = expected.plan().reach(k);
      EXPECT_TRUE(a.xmin == b.xmin && a.xmax == b.xmax && a.ymin == b.ymin && a.ymax == b.ymax)
        << mode.name;
    }
  }
}

/// Where memory runs out, there is the plan of before.
TEST(TilesOfJobs, LinesThatFailLeaveThePlan)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 500, 1);
  JobTiles tiles;
  const BlockBytes plan = planOf(points, tiles);
  const std::size_t leaves = tiles.plan().leaves();
  bool isDone = false;
  for (std::size_t k = 1; !isDone; ++k)
  {
    TileLines lines = linesAmong(points);
    account.allocations = 0;
    account.failsOnce = true;
    account.failAt = k;
    try
    {
      tiles.setLines(std::move(lines));
      isDone = true;
    }
    catch (const std::bad_alloc&)
    {
    }
    account.failAt = 0;
    ASSERT_EQ(tiles.plan().hasLines(), isDone) << "allocation " << k;
    ASSERT_EQ(tiles.tables().plan == plan, !isDone) << "allocation " << k;
    ASSERT_EQ(tiles.tables().boxes.size(), 4 * leaves) << "allocation " << k;
  }
}

} // namespace
} // namespace test
} // namespace ahd
