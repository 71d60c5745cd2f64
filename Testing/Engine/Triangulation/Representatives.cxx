// SPDX-License-Identifier: BSD-3-Clause
//
// The representative of several points at one place: in triangles, status, order, tables
// and Voronoi cells alike, and nothing else changes.
#include "ConstrainedRun.h"
#include "EngineRun.h"
#include "Executors.h"
#include "ListOf.h"
#include "Random.h"

#include "Voronoi/Voronoi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Points x, y, z, many at one place, z from a few numbers, some NaN.
struct Spatial
{
  Spatial(std::size_t n, std::uint64_t seed, std::size_t places)
  {
    Random random(seed);
    const std::vector<Point> at = makePoints(Distribution::Uniform, places, seed);
    const double heights[] = { 1.0, 2.0, -3.0, 2.0, kNaN, std::numeric_limits<double>::infinity(),
      0.0, -0.0 };
    for (std::size_t i = 0; i < n; ++i)
    {
      Point p = at[random.below(places)];
      p.x = random.below(50) == 0 ? (random.below(2) == 0 ? 0.0 : -0.0) : p.x;
      xyz.insert(xyz.end(), { p.x, random.below(100) == 0 ? kNaN : p.y, heights[random.below(8)] });
    }
  }
  PointView view() const { return PointView(xyz.data(), xyz.size() / 3, 3); }

  /// Is a better than b? By the definition.
  bool isBetter(std::size_t a, std::size_t b, bool highest) const
  {
    const double za = xyz[3 * a + 2], zb = xyz[3 * b + 2];
    if (std::isfinite(za) != std::isfinite(zb))
    {
      return std::isfinite(za);
    }
    const bool areAlike = !std::isfinite(za) || za == zb;
    return areAlike ? a < b : highest ? za > zb : za < zb;
  }

  std::vector<double> xyz;
};

/// For each point of the first result, the point that represents its vertex now.
std::vector<std::int64_t> bestOf(const Spatial& points, const Outcome& first, bool highest)
{
  std::vector<std::int64_t> best(first.pointStatus.size(), -1);
  for (std::size_t i = 0; i < best.size(); ++i)
  {
    const std::int64_t place = first.pointStatus[i];
    if (place >= 0 &&
      (best[std::size_t(place)] < 0 ||
        points.isBetter(i, std::size_t(best[std::size_t(place)]), highest)))
    {
      best[std::size_t(place)] = std::int64_t(i);
    }
  }
  return best;
}

template <typename Id>
std::vector<Id> replaced(std::vector<Id> ids, const std::vector<std::int64_t>& best)
{
  for (Id& id : ids)
  {
    id = id < 0 ? id : static_cast<Id>(best[std::size_t(id)]);
  }
  return ids;
}

struct All
{
  Outcome outcome;
  std::vector<std::int32_t> order, ranks, neighbors;
  VoronoiCells cells;
  std::vector<std::int32_t> pointOfPoint; ///< by way of the vertex
};

All everything(const Spatial& points, const Options& options, Executor* executor)
{
  All all;
  Engine engine;
  Status status = engine.run(points.view(), options, nullptr, executor);
  all.outcome.status = status;
  all.outcome.report = engine.report();
  all.outcome.triples.resize(3 * engine.report().triangles);
  all.outcome.pointStatus.resize(points.view().count);
  all.neighbors.resize(3 * engine.report().triangles);
  all.order.resize(engine.report().inserted);
  all.ranks.resize(points.view().count);
  EXPECT_EQ(engine.writeTriangles(all.outcome.triples.data()), Status::Ok);
  EXPECT_EQ(engine.writePointStatus(all.outcome.pointStatus.data()), Status::Ok);
  EXPECT_EQ(engine.writeOrder(all.order.data()), Status::Ok);
  EXPECT_EQ(engine.writeInsertionRanks(all.ranks.data()), Status::Ok);
  EXPECT_EQ(engine.writeNeighbors(all.neighbors.data()), Status::Ok);
  EXPECT_EQ(voronoiCells(engine.made, VoronoiClip::Bounds, all.cells, {}), Status::Ok);
  EXPECT_EQ(engine.made.makePointMap({}), Status::Ok);
  for (std::size_t i = 0; i < points.view().count; ++i)
  {
    const Index vertex = engine.made.vertexOf(i);
    all.pointOfPoint.push_back(vertex == kNoIndex ? -1 : std::int32_t(engine.made.pointOf(vertex)));
  }
  return all;
}

void expectChosen(const Spatial& points, Options options, Executor* executor)
{
  SCOPED_TRACE(describe(options));
  options.keepOrder = true;
  const All first = everything(points, options, executor);
  ASSERT_EQ(first.outcome.status, Status::Ok);
  for (const bool highest : { false, true })
  {
    options.representative = highest ? Representative::HighestZ : Representative::LowestZ;
    const All chosen = everything(points, options, executor);
    const std::vector<std::int64_t> best = bestOf(points, first.outcome, highest);
    EXPECT_EQ(chosen.outcome.triples, replaced(first.outcome.triples, best));
    EXPECT_EQ(chosen.outcome.pointStatus, replaced(first.outcome.pointStatus, best));
    EXPECT_EQ(chosen.order, replaced(first.order, best));
    EXPECT_EQ(chosen.pointOfPoint, replaced(first.pointOfPoint, best));
    EXPECT_EQ(chosen.neighbors, first.neighbors);
    EXPECT_EQ(listOf(chosen.cells.sites), replaced(listOf(first.cells.sites), best));
    EXPECT_EQ(listOf(chosen.cells.corners), listOf(first.cells.corners));
    EXPECT_EQ(listOf(chosen.cells.offsets), listOf(first.cells.offsets));
    EXPECT_EQ(chosen.outcome.report.duplicates, first.outcome.report.duplicates);
    std::vector<std::int32_t> ranks(first.ranks.size(), kRankNone);
    for (std::size_t i = 0; i < chosen.order.size(); ++i)
    {
      ranks[std::size_t(chosen.order[i])] = std::int32_t(i);
    }
    EXPECT_TRUE(options.insertionLimit > 0 || chosen.ranks == ranks);
  }
}

TEST(Representatives, AreThoseOfTheDefinition)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    for (const Options& options : everyDistinctSetting({ 2 }))
    {
      expectChosen(Spatial(300, seed, 40), options, nullptr);
    }
  }
}

TEST(Representatives, WithALimit)
{
  Options options;
  options.insertionLimit = 20;
  expectChosen(Spatial(300, 1, 40), options, nullptr);
}

TEST(Representatives, OnThreads)
{
  ThreadExecutor threads(3);
  expectChosen(Spatial(40000, 1, 15000), Options(), &threads);
}

TEST(Representatives, OfCollinearPoints)
{
  Spatial points(100, 1, 10);
  for (std::size_t i = 0; i < points.xyz.size(); i += 3)
  {
    points.xyz[i + 1] = std::isfinite(points.xyz[i + 1]) ? 2.0 * points.xyz[i] : kNaN;
  }
  expectChosen(points, Options(), nullptr);
}

TEST(Representatives, ConstraintsMayNameAnyPointOfAPlace)
{
  ConstraintCase given = latticeSegments(20, 300);
  std::vector<double> xyz;
  for (int copy = 0; copy < 2; ++copy)
  {
    for (const Point& p : given.points)
    {
      xyz.insert(xyz.end(), { p.x, p.y, double(copy) });
    }
  }
  Options options;
  options.representative = Representative::HighestZ;
  Engine engine;
  const ConstrainedOutcome expected = constrain(given, FillRule::EvenOdd);
  const ConstrainedOutcome chosen = constrain(engine,
    PointView(xyz.data(), 2 * given.points.size(), 3), given.constraints.view(), FillRule::EvenOdd,
    options);
  const std::int32_t shift = std::int32_t(given.points.size());
  ASSERT_EQ(chosen.triples.size(), expected.triples.size());
  for (std::size_t i = 0; i < expected.triples.size(); ++i)
  {
    ASSERT_EQ(chosen.triples[i], expected.triples[i] + shift);
  }
  EXPECT_EQ(chosen.regions, expected.regions);
  EXPECT_EQ(chosen.constraintEdges, expected.constraintEdges);
}

} // namespace
} // namespace test
} // namespace ahd
