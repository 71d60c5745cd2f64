// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles leaf by leaf, byte for byte those of one run with all points.
#include "Executors.h"
#include "HashedResults.h"
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

/// So that about so many leaves have points.
std::uint64_t mostFor(std::size_t points, std::size_t leaves)
{
  return std::max<std::uint64_t>(1, leaves == 1 ? points : 2 * points / leaves);
}

/// Both ways to the stream of all triangles.
void expectTheStream(const PointView& points, const TilesWay& way, const std::string& name)
{
  const std::vector<std::int64_t> whole = trianglesOfOneRun(points, way.representative);
  TilesRun run(points, way);
  ASSERT_EQ(run.fault, "") << name;
  EXPECT_EQ(run.triangles(), whole) << name << ", " << run.plan().leaves() << " leaves";
  EXPECT_EQ(run.trianglesOfSecondVisits(), whole)
    << name << ", " << run.plan().leaves() << " leaves, second visits";
  EXPECT_EQ(run.status, Status::Ok);
  EXPECT_EQ(run.fault, "") << name;
}

TEST(Tiles, EveryDistributionIsAsInOneRun)
{
  for (const Distribution d : allDistributions())
  {
    const std::vector<Point> points = makePoints(d, affordable(d, 2000), 1);
    for (const std::size_t leaves : { 1, 16, 300 })
    {
      TilesWay way;
      way.most = mostFor(points.size(), leaves);
      expectTheStream(viewOf(points), way, nameOf(d));
    }
  }
}

TEST(Tiles, EveryFileOfTheCorpusIsAsInOneRun)
{
  for (const NamedPoints& given : pointsOfCorpus(AHD_CORPUS_DIRECTORY))
  {
    for (const std::uint64_t most : { 1, 5, 40 })
    {
      TilesWay way;
      way.most = most;
      expectTheStream(viewOf(given.points), way, given.name);
    }
  }
}

/// More than 16 points in one cell, of which some are near other leaves.
TEST(Tiles, CrowdsAreAsInOneRun)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    std::vector<Point> points = makePoints(Distribution::Uniform, 300, seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0, 1e-12);
    for (std::size_t crowd = 0; crowd != 30; ++crowd)
    {
      for (int k = 0; k != 40; ++k)
      {
        points.push_back({ points[crowd].x + part(random), points[crowd].y + part(random) });
      }
    }
    for (const std::uint64_t most : { 5, 50, 400 })
    {
      TilesWay way;
      way.most = most;
      expectTheStream(viewOf(points), way, "crowds");
    }
  }
}

TEST(Tiles, ThreadsGiveTheSameBytes)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, reduced(20000), 1);
  for (const std::uint64_t most : { 100, 2000, 100000 })
  {
    TilesWay way;
    way.most = most;
    TilesRun one(viewOf(points), way);
    way.threads = 2;
    TilesRun two(viewOf(points), way);
    EXPECT_EQ(one.borders(), two.borders());
    EXPECT_EQ(one.owns(), two.owns());
    EXPECT_EQ(one.shares(), two.shares());
    EXPECT_EQ(two.triangles(), trianglesOfOneRun(viewOf(points)));
  }
}

/// Any leaves, places beyond the points or none.
TEST(Tiles, AnyLeavesAreAsInOneRun)
{
  std::mt19937_64 random(1);
  const auto upTo = [&random](std::size_t most) { return std::size_t(random() % most) + 1; };
  for (std::size_t k = 0; k != reduced(150); ++k)
  {
    const Distribution d = allDistributions()[k % allDistributions().size()];
    const std::vector<Point> points = makePoints(d, upTo(affordable(d, 400)), k);
    TilesWay way;
    way.most = upTo(points.size());
    const double far = double(upTo(3));
    way.extent = k % 2 == 0 ? Bounds() : Bounds{ -far, 1, 0, far };
    expectTheStream(viewOf(points), way, std::string(nameOf(d)) + ", " + std::to_string(k));
  }
}

std::vector<Point> placesOf(const std::vector<std::int64_t>& ids, const std::vector<Point>& points)
{
  std::vector<Point> places;
  for (const std::int64_t id : ids)
  {
    places.push_back(points[std::size_t(id)]);
  }
  return places;
}

TEST(Tiles, TheOrderOfPointsChangesIdsOnly)
{
  std::vector<Point> points = makePoints(Distribution::Utm, 3000, 1);
  const TilesWay way;
  const std::vector<Point> first = placesOf(TilesRun(viewOf(points), way).triangles(), points);
  std::mt19937 random(1);
  std::shuffle(points.begin(), points.end(), random);
  EXPECT_EQ(placesOf(TilesRun(viewOf(points), way).triangles(), points), first);
}

/// Of points at one place the lowest, the highest or the first is in the triangles.
TEST(Tiles, RepresentativesAreThoseOfOneRun)
{
  const std::vector<Point> places = makePoints(Distribution::RepeatedDraws, 4000, 1);
  std::vector<double> xyz;
  for (std::size_t i = 0; i != places.size(); ++i)
  {
    xyz.insert(xyz.end(), { places[i].x, places[i].y, double(i * 7919 % 100) });
  }
  const PointView points(xyz.data(), places.size(), 3);
  for (const Representative chosen :
    { Representative::FirstId, Representative::LowestZ, Representative::HighestZ })
  {
    TilesWay way;
    way.representative = chosen;
    EXPECT_EQ(TilesRun(points, way).triangles(), trianglesOfOneRun(points, chosen));
  }
}

} // namespace
} // namespace test
} // namespace ahd
