// SPDX-License-Identifier: BSD-3-Clause
//
// One result with any threads: triples, pointStatus and counts are the same bytes for any
// number of threads, in whatever order and on whichever threads the tasks run.
#include "Corpus.h"
#include "EngineRun.h"
#include "Executors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>

namespace ahd
{
namespace test
{
namespace
{

/// Enough points for all phases to be shared; fewer under sanitizers.
std::size_t shared(std::size_t n)
{
  return reduced(n) == n ? n : std::min<std::size_t>(n, 34000);
}

/// Wide distributions take fewer: each of their predicates costs as much as a thousand others.
std::size_t sharedOf(Distribution distribution, std::size_t n)
{
  return affordable(distribution, 100000) < reduced(100000) ? affordable(distribution, n)
                                                            : shared(n);
}

Outcome runOn(
  Executor* executor, Engine& engine, const PointView& points, const Options& options = Options())
{
  Outcome outcome;
  outcome.status = engine.run(points, options, nullptr, executor);
  outcome.report = engine.report();
  outcome.triples.resize(3 * outcome.report.triangles, -7);
  outcome.pointStatus.resize(points.count, -7);
  if (outcome.status == Status::Ok)
  {
    outcome.status = engine.writeTriangles(outcome.triples.data(), nullptr, executor);
  }
  if (outcome.status == Status::Ok)
  {
    outcome.status = engine.writePointStatus(outcome.pointStatus.data(), nullptr, executor);
  }
  return outcome;
}

Outcome runOn(Executor* executor, const PointView& points, const Options& options = Options())
{
  Engine engine;
  return runOn(executor, engine, points, options);
}

void expectSame(const Outcome& expected, const Outcome& found)
{
  ASSERT_EQ(expected.status, found.status);
  EXPECT_TRUE(expected.triples == found.triples) << "the triples differ";
  EXPECT_TRUE(expected.pointStatus == found.pointStatus) << "the pointStatus differ";
  EXPECT_EQ(expected.report.inserted, found.report.inserted);
  EXPECT_EQ(expected.report.duplicates, found.report.duplicates);
  EXPECT_EQ(expected.report.notFinite, found.report.notFinite);
  EXPECT_EQ(expected.report.skipped, found.report.skipped);
  EXPECT_EQ(expected.report.triangles, found.report.triangles);
  if (found.report.triangles != 0)
  {
    EXPECT_GE(
      found.report.insertionAttempts, expected.report.inserted + found.report.deferredPoints);
  }
  EXPECT_LE(found.report.criticalPath, found.report.insertionAttempts);
}

#ifdef AHD_REDUCED_TESTS
constexpr unsigned kThreads[] = { 2, 5 };
#else
constexpr unsigned kThreads[] = { 1, 2, 3, 5, 8 };
#endif

/// Runs with every number of threads and compares with the run on the calling thread alone.
void expectSameOnAnyThreads(const PointView& points, const Options& options = Options())
{
  const Outcome expected = runOn(nullptr, points, options);
  ASSERT_EQ(expected.status, Status::Ok);
  for (const unsigned threads : kThreads)
  {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    ThreadExecutor together(threads);
    expectSame(expected, runOn(&together, points, options));
    if (!kOnlyThreadsMatter)
    {
      BackwardExecutor backward(threads);
      expectSame(expected, runOn(&backward, points, options));
    }
  }
}

TEST(Threads, SameOnTheDistributionsOfThePaper)
{
  for (const Distribution distribution : paperDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    expectSameOnAnyThreads(viewOf(makePoints(distribution, shared(200000), 1)));
  }
}

TEST(Threads, SameOnEveryDistribution)
{
  for (const Distribution distribution : allDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    expectSameOnAnyThreads(viewOf(makePoints(distribution, sharedOf(distribution, 60000), 2)));
  }
}

TEST(Threads, ResultIsCertified)
{
  ThreadExecutor executor(3);
  for (const Distribution distribution : { Distribution::Mixed, Distribution::Lattice,
         Distribution::NestedClusters, Distribution::OnCircle })
  {
    const std::vector<Point> points = makePoints(distribution, shared(200000), 3);
    EXPECT_EQ(faultsOf(points, runOn(&executor, viewOf(points))), "") << nameOf(distribution);
  }
}

TEST(Threads, InsertionIsShared)
{
  // Else the tests above compare one thread with itself.
  const std::vector<Point> points = makePoints(Distribution::Uniform, shared(200000), 1);
  BackwardExecutor executor(2);
  const Report report = runOn(&executor, viewOf(points)).report;
  EXPECT_LT(report.criticalPath, report.inserted * 3 / 4);
}

TEST(Threads, SameUnderEverySetting)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, shared(60000), 4);
  const Outcome expected = runOn(nullptr, viewOf(points));
  ThreadExecutor executor(3);
  for (Options options : everyDistinctSetting({ 50 }))
  {
    if (options.order == InsertionOrder::AsGiven)
    {
      continue; // points in random order take very long
    }
    for (const bool count : { false, true })
    {
      SCOPED_TRACE(describe(options) + (count ? ", counted" : ""));
      options.countWork = count;
      expectSame(expected, runOn(&executor, viewOf(points), options));
    }
  }
}

TEST(Threads, SameOnTheCorpus)
{
  for (const CorpusFile& file : readCorpus(AHD_CORPUS_DIRECTORY))
  {
    SCOPED_TRACE(file.name);
    expectSameOnAnyThreads(viewOf(file.points));
  }
}

/// Copies of the file side by side: its difficulty in an input large enough to be shared.
std::vector<Point> tiled(const std::vector<Point>& points, std::size_t n)
{
  std::vector<Point> result;
  for (double tile = 0; result.size() < n; ++tile)
  {
    for (const Point& p : points)
    {
      result.push_back({ p.x + 16 * tile, p.y + 3 * tile });
    }
  }
  return result;
}

TEST(Threads, SameOnTheCorpusRepeated)
{
  for (const CorpusFile& file : readCorpus(AHD_CORPUS_DIRECTORY))
  {
    SCOPED_TRACE(file.name);
    const auto isModest = [](const Point& p)
    { return std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6; }; // tiles of others would coincide
    if (std::all_of(file.points.begin(), file.points.end(), isModest))
    {
      const std::vector<Point> points = tiled(file.points, shared(40000));
      ThreadExecutor executor(3);
      expectSame(runOn(nullptr, viewOf(points)), runOn(&executor, viewOf(points)));
    }
  }
}

TEST(Threads, SameForFloats)
{
  std::vector<float> numbers;
  for (const Point& p : makePoints(Distribution::Cross, shared(100000), 5))
  {
    numbers.insert(numbers.end(), { float(p.x), float(p.y), 7.0f });
  }
  expectSameOnAnyThreads(PointView(numbers.data(), numbers.size() / 3, 3));
}

/// Some points skipped, some not finite, some equal.
struct Patchy
{
  explicit Patchy(std::size_t n)
    : points(makePoints(Distribution::Mixed, n, 6))
    , skip(n)
  {
    Random random(7);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < n; ++i)
    {
      skip[i] = random.below(5) == 0 ? 2 : random.below(3) == 0 ? 1 : 0;
      switch (random.below(6))
      {
        case 0:
          points[i] = points[random.below(n)];
          break;
        case 1:
          points[i].x = nan;
          break;
        case 2:
          points[i].y = -std::numeric_limits<double>::infinity();
          break;
        default:
          break;
      }
    }
  }

  PointView view() const
  {
    PointView result = viewOf(points);
    result.skip = skip.data();
    result.skipMask = 2;
    return result;
  }

  std::vector<Point> points;
  std::vector<unsigned char> skip;
};

TEST(Threads, SameWithSkippedEqualAndNotFinitePoints)
{
  const Patchy patchy(shared(150000));
  expectSameOnAnyThreads(patchy.view());
  ThreadExecutor executor(5);
  EXPECT_EQ(faultsOf(patchy.view(), runOn(&executor, patchy.view())), "");
}

TEST(Threads, ShufflingChangesNothingButTheIds)
{
  const std::size_t n = shared(100000);
  const std::vector<Point> points = makePoints(Distribution::Spiral, n, 8);
  const Outcome expected = runOn(nullptr, viewOf(points));
  Random random(9);
  std::vector<std::int32_t> from(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    from[i] = std::int32_t(i);
  }
  for (const unsigned threads : { 2, 3, 8 })
  {
    for (std::size_t i = n; i > 1; --i)
    {
      std::swap(from[i - 1], from[random.below(i)]);
    }
    std::vector<Point> shuffled(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      shuffled[i] = points[std::size_t(from[i])];
    }
    ThreadExecutor executor(threads);
    Outcome outcome = runOn(&executor, viewOf(shuffled));
    for (std::int32_t& id : outcome.triples)
    {
      id = from[std::size_t(id)];
    }
    EXPECT_TRUE(outcome.triples == expected.triples) << threads << " threads";
  }
}

TEST(Threads, FewPoints)
{
  ThreadExecutor executor(8);
  for (std::size_t n = 0; n < 70; ++n)
  {
    SCOPED_TRACE(n);
    const std::vector<Point> points = makePoints(Distribution::RepeatedDraws, n, 10);
    expectSame(runOn(nullptr, viewOf(points)), runOn(&executor, viewOf(points)));
  }
}

TEST(Threads, OneWorkspaceWithManyExecutorsAndSizes)
{
  Engine reused;
  Random random(11);
  for (int run = 0; run < 20; ++run)
  {
    const std::size_t n = 3 + random.below(shared(120000));
    const unsigned threads = unsigned(random.below(6));
    SCOPED_TRACE(std::to_string(n) + " points, " + std::to_string(threads) + " threads");
    const std::vector<Point> points = makePoints(Distribution::Mixed, n, std::uint64_t(run));
    std::unique_ptr<Executor> executor(threads == 0 ? nullptr : new ThreadExecutor(threads));
    expectSame(runOn(nullptr, viewOf(points)), runOn(executor.get(), reused, viewOf(points)));
  }
}

TEST(Threads, WhoeverRunsTheTasks)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, shared(100000), 12);
  const Outcome expected = runOn(nullptr, viewOf(points));
  ElsewhereExecutor elsewhere(4);
  LateExecutor late(4);
  ThreadExecutor many(64);
  ThreadExecutor boastful(2, 64);
  for (Executor* executor : { static_cast<Executor*>(&elsewhere), static_cast<Executor*>(&late),
         static_cast<Executor*>(&many), static_cast<Executor*>(&boastful) })
  {
    expectSame(expected, runOn(executor, viewOf(points)));
  }
}

TEST(Threads, AnExecutorForRunAndAnotherForWriting)
{
  const std::vector<Point> points = makePoints(Distribution::Lattice, shared(100000), 13);
  const Outcome expected = runOn(nullptr, viewOf(points));
  ThreadExecutor three(3);
  ThreadExecutor five(5);
  Engine engine;
  Outcome outcome = expected;
  ASSERT_EQ(engine.run(viewOf(points), Options(), nullptr, &three), Status::Ok);
  for (Executor* writer : { static_cast<Executor*>(nullptr), static_cast<Executor*>(&five) })
  {
    std::fill(outcome.triples.begin(), outcome.triples.end(), -7);
    std::fill(outcome.pointStatus.begin(), outcome.pointStatus.end(), -7);
    EXPECT_EQ(engine.writeTriangles(outcome.triples.data(), nullptr, writer), Status::Ok);
    EXPECT_EQ(engine.writePointStatus(outcome.pointStatus.data(), nullptr, writer), Status::Ok);
    EXPECT_TRUE(outcome.triples == expected.triples);
    EXPECT_TRUE(outcome.pointStatus == expected.pointStatus);
  }
}

TEST(Threads, TwoWorkspacesAtOnce)
{
  const std::vector<Point> points = makePoints(Distribution::Cross, shared(100000), 14);
  const Outcome expected = runOn(nullptr, viewOf(points));
  Outcome outcomes[2];
  const auto work = [&](std::size_t k)
  {
    ThreadExecutor executor(unsigned(2 + k));
    outcomes[k] = runOn(&executor, viewOf(points));
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  expectSame(expected, outcomes[0]);
  expectSame(expected, outcomes[1]);
}

} // namespace
} // namespace test
} // namespace ahd
