// SPDX-License-Identifier: BSD-3-Clause
//
// Allocations of the engine: no more than estimated, and a failed one is reported and survived.
// This program's operator new counts, and fails on demand.
#include "Distributions.h"
#include "EngineRun.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ahd
{
namespace test
{
namespace
{

/// The most bytes that run() and writeTriangles() held at once, output not counted.
std::size_t peakOf(const std::vector<Point>& points, const Options& options)
{
  std::vector<std::int32_t> triples(6 * points.size() + 6);
  const std::size_t before = account.held;
  account.peak = before;
  Engine engine;
  EXPECT_EQ(engine.run(viewOf(points), options, nullptr), Status::Ok);
  EXPECT_EQ(engine.writeTriangles(triples.data(), nullptr), Status::Ok);
  return account.peak - before;
}

TEST(Memory, NoMoreThanEstimated)
{
  for (const Distribution distribution : allDistributions())
  {
    for (const std::size_t n : { std::size_t(100), affordable(distribution, 100000) })
    {
      const std::vector<Point> points = makePoints(distribution, n, 1);
      EXPECT_LE(peakOf(points, Options()), triangulationMemoryEstimate(n, Options()))
        << nameOf(distribution) << ", " << n << " points";
    }
  }
}

TEST(Memory, NoMoreThanEstimatedUnderAnySetting)
{
  const std::size_t n = reduced(150000); // more than the megabyte that is estimated on top can hide
  const std::vector<Point> points = makePoints(Distribution::Mixed, n, 1);
  for (Options options : everyDistinctSetting({ 1, 50 }))
  {
    options.keepOrder = true;
    EXPECT_LE(peakOf(points, options), triangulationMemoryEstimate(n, options))
      << describe(options);
  }
}

TEST(Memory, NoMoreThanEstimatedForACavityOfAllTriangles)
{
  // The last of these points in the order of insertion lies in the circles of nearly all triangles,
  // which form a chain, so that one open edge of each waits until the end of the cavity is reached.
  std::vector<Point> points;
  for (std::size_t i = 1; i <= 20000; ++i)
  {
    const double x = -double(i);
    points.push_back({ x, x * x });
  }
  points.push_back({ -1.5, 1e10 });
  EXPECT_LE(peakOf(points, Options()), triangulationMemoryEstimate(points.size(), Options()));
  EXPECT_EQ(faultsOf(points, triangulate(points)), "");
}

TEST(Memory, EstimateIsNotFarAboveWhatIsNeeded)
{
  const std::size_t n = 200000;
  const std::vector<Point> points = makePoints(Distribution::Uniform, n, 1);
  EXPECT_LE(triangulationMemoryEstimate(n, Options()), 2 * peakOf(points, Options()));
}

TEST(Memory, BoxesAreHeldOnlyWhileTheyAreWanted)
{
  const std::size_t n = 20000;
  const std::vector<Point> points = makePoints(Distribution::Uniform, n, 1);
  Options options;
  options.nmax = 1;
  options.keepBoxes = true;
  const std::size_t before = account.held;
  Engine engine;
  const auto held = [&] { return account.held - before; };
  ASSERT_EQ(engine.run(viewOf(points), options, nullptr), Status::Ok);
  const std::size_t boxes = engine.boxes().size();
  const std::size_t withBoxes = held();
  EXPECT_GT(boxes, n);
  engine.reclaim();
  EXPECT_LE(held() + boxes * sizeof(GridBox), withBoxes);
  EXPECT_LE(engine.workspace.bytes(), held());
  EXPECT_LE(held(), engine.workspace.bytes() + 4096) << "not all is told";

  options.mostBoxes = boxes - 1;
  EXPECT_EQ(engine.run(viewOf(points), options, nullptr), Status::TooManyBoxes);
  options.mostBoxes = boxes;
  EXPECT_EQ(engine.run(viewOf(points), options, nullptr), Status::Ok);
  options.keepBoxes = false;
  EXPECT_EQ(engine.run(viewOf(points), options, nullptr), Status::Ok);
  EXPECT_LE(held() + boxes * sizeof(GridBox), withBoxes);
}

TEST(Memory, EstimateGrowsWithThePoints)
{
  const std::size_t million = triangulationMemoryEstimate(1000000, Options());
  const std::size_t fourMillion = triangulationMemoryEstimate(4000000, Options());
  EXPECT_GE(million, 64u * 1000000); // two triangles of 32 bytes per point, if nothing else
  EXPECT_GT(fourMillion, 3 * million);
  EXPECT_LT(fourMillion, 5 * million);
}

TEST(Memory, NothingIsHeldOnceWorkspaceAndTriangulationAreGone)
{
  const std::vector<Point> points = makePoints(Distribution::RepeatedDraws, 20000, 1);
  const std::size_t before = account.held;
  peakOf(points, Options());
  EXPECT_EQ(account.held, before);
}

/// Fails the k-th allocation and all that follow, for every k, until a run succeeds.
void expectOutOfMemoryIsSurvived(const std::vector<Point>& points, const Options& options)
{
  const Outcome expected = triangulate(points, options);
  std::vector<std::int32_t> triples(expected.triples.size());
  Engine engine;
  std::size_t failures = 0;
  for (std::size_t k = 1; k < 10000; ++k)
  {
    account.failAt = account.allocations + k;
    const Status ran = engine.run(viewOf(points), options, nullptr);
    const Status status = ran == Status::Ok ? engine.writeTriangles(triples.data(), nullptr) : ran;
    account.failAt = 0;
    if (status == Status::Ok)
    {
      EXPECT_EQ(triples, expected.triples) << "after " << failures << " failures";
      EXPECT_GT(failures, 0u) << "the engine no longer allocates through operator new";
      return;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "at allocation " << k;
    if (ran != Status::Ok)
    {
      ASSERT_EQ(engine.report().triangles, 0u) << "at allocation " << k;
    }
    ++failures;
  }
  FAIL() << "no run got through";
}

TEST(Memory, OutOfMemoryAtAnyAllocationIsReportedAndSurvived)
{
  for (const Distribution distribution : { Distribution::Uniform, Distribution::Lattice,
         Distribution::RepeatedDraws, Distribution::NestedClusters })
  {
    for (const Options& options : everyDistinctSetting({ 50 }))
    {
      SCOPED_TRACE(std::string(nameOf(distribution)) + "; " + describe(options));
      expectOutOfMemoryIsSurvived(makePoints(distribution, 3000, 1), options);
    }
  }
}

/// All edges of the triangulation of the points as constraints: its triangles, as loops.
struct AllEdges
{
  explicit AllEdges(const std::vector<Point>& points)
  {
    const Outcome outcome = triangulate(points);
    ids.assign(outcome.triples.begin(), outcome.triples.end());
    for (std::size_t i = 0; i <= ids.size(); i += 3)
    {
      offsets.push_back(static_cast<std::int64_t>(i));
    }
  }
  ConstraintView view() const { return { ids.data(), offsets.data(), offsets.size() - 1, 0 }; }

  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> offsets;
};

/// run(), constrain(), and all cell data. Returns the first status that is not Ok.
Status runConstrained(Engine& engine, const std::vector<Point>& points, const AllEdges& edges)
{
  const std::size_t most = 2 * points.size();
  static std::vector<std::int64_t> ids;
  static std::vector<std::uint8_t> marks;
  ids.reserve(3 * most);
  marks.reserve(most);
  const Status done[] = { engine.run(viewOf(points), Options(), nullptr),
    engine.constrain(edges.view(), FillRule::Orientation, nullptr),
    engine.writeNeighbors(ids.data(), nullptr), engine.writeRegions(ids.data(), nullptr),
    engine.writeConstraintEdges(marks.data(), nullptr) };
  const auto* bad = std::find_if(
    std::begin(done), std::end(done), [](Status status) { return status != Status::Ok; });
  return bad == std::end(done) ? Status::Ok : *bad;
}

TEST(Memory, NoMoreThanEstimatedWithConstraints)
{
  const std::size_t n = reduced(100000);
  for (const Distribution distribution : { Distribution::Uniform, Distribution::Lattice })
  {
    const std::vector<Point> points = makePoints(distribution, n, 1);
    const AllEdges edges(points);
    Engine warm;
    ASSERT_EQ(runConstrained(warm, points, edges), Status::Ok);
    const std::size_t before = account.held;
    account.peak = before;
    Engine engine;
    ASSERT_EQ(runConstrained(engine, points, edges), Status::Ok);
    EXPECT_LE(account.peak - before,
      triangulationMemoryEstimate(n, Options()) + constraintMemoryEstimate(n, edges.ids.size()) +
        tableMemoryEstimate(n));
    engine.reclaim();
    EXPECT_LE(engine.workspace.bytes(), account.held - before);
    warm.reclaim();
    EXPECT_GE(engine.workspace.bytes(), warm.workspace.bytes() / 2);
  }
}

TEST(Memory, ConstraintsSurviveOutOfMemoryAtAnyAllocation)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, 500, 1);
  AllEdges edges(points);
  points.push_back({ -2.0, -2.0 }); // and a segment that crosses many of them, the first
  points.push_back({ 3.0, 3.1 });
  edges.ids.insert(edges.ids.begin(), { 500, 501, 500 });
  edges.offsets.push_back(edges.offsets.back() + 3);
  Engine engine;
  ASSERT_EQ(runConstrained(engine, points, edges), Status::Ok);
  const std::size_t crossing = engine.constraints().crossing;
  EXPECT_GT(crossing, 10u);
  std::size_t failures = 0;
  for (std::size_t k = 1; k < 10000; ++k, ++failures)
  {
    engine.release();
    account.failAt = account.allocations + k;
    const Status status = runConstrained(engine, points, edges);
    account.failAt = 0;
    if (status == Status::Ok)
    {
      EXPECT_GT(failures, 20u);
      EXPECT_EQ(engine.constraints().crossing, crossing);
      return;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "at allocation " << k;
  }
  FAIL() << "no run got through";
}

} // namespace
} // namespace test
} // namespace ahd
