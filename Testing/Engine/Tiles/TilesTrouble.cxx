// SPDX-License-Identifier: BSD-3-Clause
//
// Visits whose memory runs out at any allocation, or that are cancelled at any poll: the status
// reports it, nothing is thrown or leaked. And they take little memory. This program's operator new
// fails on demand.
#include "Listeners.h"
#include "MemoryListener.h"
#include "OwnMemory.h"
#include "TilesRun.h"
#include "Triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

/// Memory of the caller's neither fails nor counts.
Status counted(const std::function<Status()>& work)
{
  account.countsNothing = false;
  const Status status = work();
  account.countsNothing = true;
  return status;
}

struct Divided
{
  std::vector<Point> points;
  std::uint64_t most;
  TileLines lines;
};

std::vector<Divided> cases()
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 200, 1);
  const std::vector<Point> corners(points.begin(), points.begin() + 7);
  return { { makePoints(Distribution::RepeatedDraws, 300, 1), 80, {} },
    { makePoints(Distribution::Collinear, 40, 1), 10, {} }, { points, 1000, {} },
    { points, 70, { corners, { 0, 4, 7 }, 1, 0 } } };
}

/// All calls: two visits of each leaf.
Status runAll(const Divided& given, const Context& context, std::vector<std::int64_t>& triangles)
{
  TilesWay way;
  way.most = given.most;
  way.lines = given.lines;
  way.context = context;
  way.call = counted;
  TilesRun run(viewOf(given.points), way);
  if (run.status == Status::Ok)
  {
    triangles = run.triangles();
  }
  for (std::size_t leaf = 0; run.status == Status::Ok && leaf != run.plan().leaves(); ++leaf)
  {
    run.second(leaf);
    if (run.isFine())
    {
      run.surface(leaf);
    }
  }
  return run.status;
}

TEST(TilesTrouble, AnyAllocationCanFail)
{
  account.countsNothing = true;
  for (const Divided& given : cases())
  {
    const std::size_t before = account.blocks;
    {
      std::vector<std::int64_t> expected, found;
      account.allocations = 0;
      ASSERT_EQ(runAll(given, {}, expected), Status::Ok);
      const std::size_t all = account.allocations;
      ASSERT_GT(all, 50u);
      const std::size_t step = 1 + all / reduced(500);
      for (std::size_t k = 1; k <= all; k += step)
      {
        account.allocations = 0;
        account.failsOnce = k % 2 == 0;
        account.failAt = k;
        const Status status = runAll(given, {}, found);
        account.failAt = 0;
        ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << k << " of " << all;
      }
      ASSERT_EQ(runAll(given, {}, found), Status::Ok);
      ASSERT_EQ(found, expected);
    }
    EXPECT_EQ(account.blocks, before) << "something leaked";
  }
  account.countsNothing = false;
}

TEST(TilesTrouble, AnyAskingCanCancel)
{
  for (const Divided& given : cases())
  {
    std::vector<std::int64_t> triangles;
    Listener listener;
    ASSERT_EQ(runAll(given, { &listener, nullptr }, triangles), Status::Ok);
    ASSERT_GE(listener.askings(), 5u);
    for (std::size_t at = 1; at <= listener.askings(); at += 1 + listener.askings() / 300)
    {
      Listener cancelling(at);
      ASSERT_EQ(runAll(given, { &cancelling, nullptr }, triangles), Status::Cancelled) << at;
    }
  }
}

/// The discs of a circle meet all of its leaves, and of a line each leaf has all points: what is
/// shared is as much as points times leaves. It is requested, and may be refused.
TEST(TilesTrouble, MemoryOfSharesIsRequested)
{
  for (const Distribution d :
    { Distribution::OnCircle, Distribution::Collinear, Distribution::Uniform })
  {
    const std::vector<Point> points = makePoints(d, 1000, 1);
    TilesWay way;
    way.most = 10;
    MemoryListener all, some(1000000);
    way.context = { &all, nullptr };
    const TilesRun whole(viewOf(points), way);
    EXPECT_EQ(whole.status, Status::Ok);
    way.context = { &some, nullptr };
    const TilesRun limited(viewOf(points), way);
    if (d == Distribution::Uniform)
    {
      EXPECT_LT(all.memory.most(), std::size_t(1000000));
      EXPECT_EQ(limited.status, Status::Ok);
    }
    else
    {
      const std::size_t root = whole.plan().root();
      EXPECT_GT(all.memory.most(), whole.shares()[root].size()) << nameOf(d);
      EXPECT_GT(whole.shares()[root].size(), std::size_t(1000000)) << nameOf(d);
      EXPECT_EQ(limited.status, Status::OutOfMemory) << nameOf(d);
    }
  }
}

/// What a call takes beyond what is there before it: a run of a leaf's points, or some of a border.
TEST(TilesTrouble, MemoryIsThatOfALeafOrABorder)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, reduced(60000), 1);
  std::size_t most = 0;
  TilesWay way;
  way.most = 4000;
  way.call = [&most](const std::function<Status()>& work)
  {
    account.peak = account.held.load();
    const std::size_t before = account.held;
    const Status status = work();
    most = std::max(most, account.peak - before);
    return status;
  };
  TilesRun run(viewOf(points), way);
  EXPECT_LE(most, triangulationMemoryEstimate(way.most, {}) + 100 * way.most);
  EXPECT_LE(run.borderPoints, 8 * std::size_t(std::sqrt(double(way.most))) * run.plan().leaves());
  EXPECT_EQ(run.triangles(), trianglesOfOneRun(viewOf(points)));
}

} // namespace
} // namespace test
} // namespace ahd
