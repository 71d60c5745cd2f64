// SPDX-License-Identifier: BSD-3-Clause
//
// Leaves: the places of boxes of the grid, what is counted in passes, plans and visits as bytes.
#include "TilesRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

bool has(const Bounds& box, const Point& p)
{
  return box.xmin <= p.x && p.x <= box.xmax && box.ymin <= p.y && p.y <= box.ymax;
}

/// The box of a level that has the key.
TileBox boxAround(std::uint64_t key, unsigned level)
{
  TileBox box;
  while (box.level != level)
  {
    unsigned q = 0;
    while (!box.quarter(q).has(key))
    {
      ++q;
    }
    box = box.quarter(q);
  }
  return box;
}

TEST(TilesPlan, APlaceIsInTheRectangleOfABoxIfItsKeyIsInTheBox)
{
  constexpr double kHuge = std::numeric_limits<double>::max();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Bounds all[] = { { 0, 1, 0, 1 }, { -3, 5, 1e6, 1e6 + 1 }, { -1e-300, 1e-310, -1, 1 },
    { -kHuge, kHuge, -kHuge, 1 }, { 2, 2, 7, 9 }, { 0, 0, 0, 0 }, { 5e5, 5.1e5, -0x1p-1074, 0 } };
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  for (const Bounds& bounds : all)
  {
    const TileGrid grid(bounds);
    for (std::size_t k = 0; k != reduced(400); ++k)
    {
      const double u = part(random), v = part(random);
      const Point p{ bounds.xmin * (1 - u) + bounds.xmax * u,
        bounds.ymin * (1 - v) + bounds.ymax * v };
      const TileBox box = boxAround(grid.keyOf(p), unsigned(k % 33));
      const Bounds b = grid.placesOf(box);
      ASSERT_TRUE(has(b, p)) << k;
      for (const double x :
        { b.xmin, b.xmax, std::nextafter(b.xmin, -kInfinity), std::nextafter(b.xmax, kInfinity) })
      {
        for (const double y :
          { b.ymin, b.ymax, std::nextafter(b.ymin, -kInfinity), std::nextafter(b.ymax, kInfinity) })
        {
          const Point q{ x, y };
          ASSERT_TRUE(!has(bounds, q) || has(b, q) == box.has(grid.keyOf(q))) << k;
        }
      }
    }
  }
}

std::vector<Point> farClusters()
{
  std::vector<Point> points = { { 0, 0 }, { 1e9, 1e9 } };
  for (int k = 0; k != 300; ++k)
  {
    points.push_back({ 1e6 + 0.01 * (k % 20), 5e6 + 0.01 * (k / 20) });
  }
  return points;
}

TEST(TilesPlan, CountsAreThoseOfThePointsAndFewEnough)
{
  const std::vector<std::vector<Point>> all = { {}, { { 3, 4 } }, farClusters(),
    makePoints(Distribution::Uniform, 3000, 1), makePoints(Distribution::NestedClusters, 3000, 1),
    makePoints(Distribution::AllEqual, 100, 1), makePoints(Distribution::Collinear, 500, 1) };
  for (const std::vector<Point>& points : all)
  {
    TilesWay way;
    way.most = 7;
    const TilesRun run(viewOf(points), way);
    ASSERT_EQ(run.fault, "");
    const TilePlan& plan = run.plan();
    std::vector<std::uint64_t> counts(plan.leaves(), 0);
    for (const Point& p : points)
    {
      const std::size_t leaf = std::size_t(plan.leafOf(p));
      ++counts[leaf];
      EXPECT_TRUE(has(plan.box(leaf), p));
    }
    for (std::size_t k = 0; k != plan.leaves(); ++k)
    {
      EXPECT_EQ(counts[k], plan.leaf(k).count);
      EXPECT_TRUE(counts[k] <= way.most || plan.leaf(k).level == TileBox::kLevels);
    }
    EXPECT_EQ(plan.facts().points, points.size());
  }
}

TEST(TilesPlan, NeitherGuessNorOrderNorPlacesChangeLeaves)
{
  std::vector<Point> points = farClusters();
  points.push_back({ NAN, 1 });
  points.push_back({ 1, -INFINITY });
  TilesWay way;
  way.most = 20;
  const TilesRun first(viewOf(points), way);
  EXPECT_EQ(first.plan().facts().notFinite, 2u);
  EXPECT_EQ(first.plan().leafOf({ NAN, 1 }), -1);
  std::mt19937 random(7);
  for (const Bounds& guess :
    { Bounds{ 0, 1e9, 0, 1e9 }, Bounds{ 0, 1e9, 0, 2e9 }, Bounds{ 1, 2, 1, 2 } })
  {
    std::shuffle(points.begin(), points.end(), random);
    way.guess = guess;
    const TilesRun other(viewOf(points), way);
    ASSERT_EQ(other.fault, "");
    EXPECT_EQ(other.plan().write(), first.plan().write());
  }
  way.extent = { -5, 3e9, 0, 1 };
  const TilesRun larger(viewOf(points), way);
  EXPECT_EQ(larger.plan().leaves(), first.plan().leaves());
  EXPECT_NE(larger.plan().fingerprint(), first.plan().fingerprint());
}

TEST(TilesPlan, AnExactGuessSavesAPass)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 1000, 1);
  Bounds bounds;
  for (const Point& p : points)
  {
    bounds = joined(bounds, p);
  }
  const std::vector<Point> fewer(points.begin(), points.end() - 1);
  TileFacts facts;
  TileCounter guessed(bounds), other({ 0, 7, 0, 7 });
  ASSERT_EQ(guessed.count(viewOf(points), {}), Status::Ok);
  ASSERT_EQ(other.count(viewOf(points), {}), Status::Ok);
  EXPECT_EQ(guessed.endPass(100, facts), TileCounter::Next::Done);
  EXPECT_EQ(other.endPass(100, facts), TileCounter::Next::Again);
  ASSERT_EQ(other.count(viewOf(fewer), {}), Status::Ok);
  EXPECT_EQ(other.endPass(100, facts), TileCounter::Next::Different);
}

TEST(TilesPlan, PartsAreBehindThoseThatTheyJoin)
{
  TilesWay way;
  way.most = 10;
  const TilesRun run(viewOf(makePoints(Distribution::KuzminDisc, 2000, 1)), way);
  const TilePlan& plan = run.plan();
  std::size_t joined = 0;
  for (std::size_t part = 0; part != plan.parts(); ++part)
  {
    const std::vector<std::size_t>& parts = plan.joinedBy(part);
    EXPECT_EQ(parts.empty(), part < plan.leaves());
    joined += parts.size();
    std::size_t leaves = parts.empty() ? 1 : 0;
    for (const std::size_t below : parts)
    {
      EXPECT_LT(below, part);
      EXPECT_EQ(plan.parents()[below], part);
      EXPECT_GE(plan.rowOf(below).begin, plan.rowOf(part).begin);
      leaves += plan.rowOf(below).end - plan.rowOf(below).begin;
    }
    EXPECT_EQ(plan.rowOf(part).end - plan.rowOf(part).begin, leaves);
  }
  EXPECT_EQ(joined, plan.parts() - 1);
  EXPECT_EQ(plan.rowOf(plan.root()).end, plan.leaves());
}

/// Whatever is cut off or changed.
TEST(TilesPlan, OtherBytesAreRefused)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 1000, 1);
  TilesRun run(viewOf(points), TilesWay());
  const TilePlan& plan = run.plan();
  const BlockBytes bytes = plan.write();
  TileFacts facts;
  EXPECT_TRUE(TilePlan::read(bytes.data(), bytes.size(), facts));
  EXPECT_EQ(TilePlan(facts).write(), bytes);
  for (std::size_t k = 0; k < bytes.size(); k += 3)
  {
    BlockBytes changed = bytes;
    changed[k] ^= 1;
    EXPECT_FALSE(TilePlan::read(changed.data(), changed.size(), facts));
    EXPECT_FALSE(TilePlan::read(bytes.data(), k, facts));
  }
  const std::vector<TileView> right = run.sharesFor(3);
  TileKept kept;
  ASSERT_TRUE(run.visits().readKept(3, nullptr, right, kept));
  for (std::size_t size = 0; size < right.back().size; size += 1 + size / 20)
  {
    std::vector<TileView> shares = right;
    shares.back().size = size;
    EXPECT_FALSE(run.visits().readKept(3, nullptr, shares, kept)) << size;
  }
  std::vector<TileBorder> borders;
  const std::size_t node = plan.parents()[0];
  std::vector<TileView> given;
  for (const std::size_t part : plan.joinedBy(node))
  {
    given.push_back(viewOf(run.borders()[part]));
  }
  EXPECT_TRUE(run.visits().readBorders(node, given, borders));
  std::swap(given[0], given[1]);
  EXPECT_FALSE(run.visits().readBorders(node, given, borders));
}

} // namespace
} // namespace test
} // namespace ahd
