// SPDX-License-Identifier: BSD-3-Clause
//
// The stack that the engine takes for any input: everything runs on threads with stacks of 64 KiB,
// and their use is measured. No depth depends on the input, but for logarithms. Sanitizers take
// more stack: not run under them.
#include "BlocksRun.h"
#include "ConstrainedRun.h"
#include "Corpus.h"
#include "SmallStack.h"

#include "Crossings/Crossings.h"
#include "Merge/Merge.h"
#include "Sample/Sample.h"
#include "Voronoi/Voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{
namespace test
{
namespace
{

/// The limit on stack bytes in Filters/Engine/README.md. For the optimised build; others take more.
#ifdef NDEBUG
constexpr std::size_t kMostBytes = std::size_t(32) << 10;
#else
constexpr std::size_t kMostBytes = kSmallStack;
#endif

/// Records the maximum over a whole test.
class Stack : public testing::Test
{
protected:
  void SetUp() override
  {
#ifdef AHD_REDUCED_TESTS
    GTEST_SKIP() << "sanitizers take more stack";
#endif
  }
  void TearDown() override
  {
    RecordProperty("most_bytes", std::to_string(most_));
  }

  /// Runs `work` on a small stack, and checks it and the threads of `executor` against the limit.
  void expectLittle(const std::function<void()>& work, const SmallStackExecutor* executor = nullptr)
  {
    const std::size_t bytes = std::max(onSmallStack(work), executor ? executor->mostBytes() : 0);
    EXPECT_LE(bytes, kMostBytes);
    most_ = std::max(most_, bytes);
  }

  void useAll(const std::vector<Point>& points);
  void useManyPoints(std::size_t n);
  void useManyConstraints(std::size_t n);

private:
  std::size_t most_ = 0;
};
class LongStack : public Stack
{
};

// ------------------------------------------------------------------------------------ what is done

void useTriangulation(const PointView& points, const Options& options, Executor* executor)
{
  Engine engine;
  ASSERT_EQ(engine.run(points, options, nullptr, executor), Status::Ok);
  std::vector<std::int32_t> triples(3 * engine.report().triangles);
  std::vector<std::int64_t> numbers(std::max(points.count, triples.size()));
  EXPECT_EQ(engine.writeTriangles(triples.data(), nullptr, executor), Status::Ok);
  EXPECT_EQ(engine.writeNeighbors(numbers.data(), nullptr, executor), Status::Ok);
  if (!triples.empty())
  {
    ASSERT_EQ(engine.made.makeNeighbors({ nullptr, executor }), Status::Ok);
    const Location found = engine.made.locate(points[0], triples.size() / 3 - 1);
    EXPECT_EQ(found.kind == Location::Nowhere, !isFinite(points[0]));
  }
  EXPECT_EQ(engine.writePointStatus(numbers.data(), nullptr, executor), Status::Ok);
  if (options.keepOrder)
  {
    EXPECT_EQ(engine.writeOrder(numbers.data(), nullptr, executor), Status::Ok);
    EXPECT_EQ(engine.writeInsertionRanks(numbers.data(), nullptr, executor), Status::Ok);
  }
}

void useVoronoi(const PointView& points, Executor* executor)
{
  Engine engine;
  ASSERT_EQ(engine.run(points, Options(), nullptr, executor), Status::Ok);
  for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
  {
    VoronoiCells cells;
    EXPECT_EQ(voronoiCells(engine.made, clip, cells, { nullptr, executor }), Status::Ok);
  }
}

void useSampler(const PointView& points, Executor* executor)
{
  const Context context{ nullptr, executor };
  Engine engine;
  ASSERT_EQ(engine.run(points, Options(), nullptr, executor), Status::Ok);
  const SampleRaster raster{ { 0.1, 0.2 }, { 0.1, 0.2 }, 8, 5 };
  PointView few = points;
  few.count = std::min<std::size_t>(points.count, 100);
  std::vector<double> values(points.count, 1.0);
  std::vector<double> out(std::max(points.count, raster.columns * raster.rows));
  const SampleArray array{ values.data(), 1, out.data(), nullptr };
  for (const SampleMethod method :
    { SampleMethod::Linear, SampleMethod::NaturalNeighbor, SampleMethod::Nearest })
  {
    Sampler sampler;
    SampleReport report;
    ASSERT_EQ(sampler.prepare(engine.made, nullptr, method, context), Status::Ok);
    for (const SamplePlaces& places : { SamplePlaces(few), SamplePlaces(raster) })
    {
      EXPECT_EQ(sampler.values(places, &array, 1, nullptr, report, context), Status::Ok);
    }
  }
}

void useMerge(const PointView& points)
{
  for (const double distance : { 1e-3, 0.3, std::numeric_limits<double>::infinity() })
  {
    MergedPoints merged;
    EXPECT_EQ(mergeWithin(points, distance, nullptr, merged), Status::Ok);
  }
}

void useBlocks(const PointView& points, const ConstraintView& constraints, FillRule rule)
{
  BlocksWay way;
  way.blocks = 5;
  way.blocksPerNode = 2;
  EXPECT_EQ(runBlocks(points, constraints, rule, way).status, Status::Ok);
}

void useConstraints(const ConstraintCase& given)
{
  for (const FillRule rule : kFillRules)
  {
    EXPECT_EQ(constrain(given, rule).status, Status::Ok);
    useBlocks(given.view(), given.constraints.view(), rule);
  }
}

void useSplit(const ConstraintCase& given)
{
  SplitConstraints split;
  EXPECT_EQ(splitAtCrossings(given.view(), given.constraints.view(), nullptr, split), Status::Ok);
}

void Stack::useAll(const std::vector<Point>& points)
{
  SmallStackExecutor executor(3);
  const PointView view = viewOf(points);
  const auto work = [&]
  {
    useTriangulation(view, Options(), nullptr);
    useTriangulation(view, Options(), &executor);
    useVoronoi(view, &executor);
    useSampler(view, &executor);
    useMerge(view);
    useBlocks(view, ConstraintView(), FillRule::Orientation);
  };
  expectLittle(work, &executor);
}

// ----------------------------------------------------------------------------------------- points

/// Teeth of two lengths, in a row that is long and thin.
std::vector<Point> zigzag(std::size_t n)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i)
  {
    points.push_back({ double(i) / double(n), i % 2 == 0 ? 0.0 : 1e-7 });
  }
  return points;
}

/// Clusters within clusters, as deep as double goes: half of the points, then half of the rest, ...
/// ever nearer to the origin.
std::vector<Point> everDeeper(std::size_t n)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, n, 1);
  for (std::size_t i = 0; i < n; ++i)
  {
    const int depth = int(i * 1000 / n);
    points[i] = { std::ldexp(points[i].x, -depth), std::ldexp(points[i].y, -depth) };
  }
  return points;
}

/// Powers of two on both axes, either way: every predicate needs its last stage.
std::vector<Point> axesOfPowers(int step)
{
  std::vector<Point> points;
  for (int k = -1074; k < 1024; k += step)
  {
    const double x = std::ldexp(1.0, k);
    points.insert(points.end(), { { x, 0 }, { -x, 0 }, { 0, x }, { 0, -x } });
  }
  return points;
}

void Stack::useManyPoints(std::size_t n)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice,
         Distribution::OnCircle, Distribution::OnParabola, Distribution::Collinear,
         Distribution::NearlyCollinear, Distribution::AllEqual, Distribution::RepeatedDraws,
         Distribution::NestedClusters, Distribution::Spiral, Distribution::Slivers })
  {
    SCOPED_TRACE(nameOf(d));
    useAll(makePoints(d, n, 1));
  }
  useAll(zigzag(n));
  useAll(everDeeper(n));
}

TEST_F(Stack, Points)
{
  useManyPoints(20000);
}

TEST_F(LongStack, AMillionPoints)
{
  useManyPoints(1000000);
}

TEST_F(Stack, AllStagesOfThePredicates)
{
  useAll(axesOfPowers(13));
  for (const Distribution d :
    { Distribution::TinyAndHuge, Distribution::AnyFinite, Distribution::Tiny, Distribution::Huge })
  {
    SCOPED_TRACE(nameOf(d));
    useAll(makePoints(d, affordable(d, 20000), 1));
  }
  for (const CorpusFile& file : readCorpus(AHD_CORPUS_DIRECTORY))
  {
    SCOPED_TRACE(file.name);
    useAll(file.points);
  }
}

TEST_F(Stack, EverySetting)
{
  for (const Distribution d :
    { Distribution::Mixed, Distribution::NestedClusters, Distribution::Lattice })
  {
    const std::vector<Point> points = makePoints(d, 8000, 1);
    for (Options options : everyDistinctSetting({ 1, 50 }))
    {
      SCOPED_TRACE(describe(options));
      options.keepOrder = true;
      options.keepBoxes = true;
      SmallStackExecutor executor(2);
      expectLittle([&] { useTriangulation(viewOf(points), options, &executor); }, &executor);
    }
  }
}

// ------------------------------------------------------------------------------------ constraints

/// A loop around every second of `depth` squares within squares, and one the other way round around
/// the others.
ConstraintCase squaresWithinSquares(std::size_t depth)
{
  ConstraintCase result;
  for (std::size_t k = 0; k < depth; ++k)
  {
    const double r = 1.0 + double(k);
    const auto id = std::int64_t(result.points.size());
    result.points.insert(result.points.end(), { { -r, -r }, { r, -r }, { r, r }, { -r, r } });
    Chain loop = { id, id + 1, id + 2, id + 3 };
    if ((depth - k) % 2 == 0)
    {
      std::reverse(loop.begin(), loop.end());
    }
    result.constraints.addLoop(loop);
  }
  return result;
}

/// A polygon with `teeth` teeth.
ConstraintCase comb(std::size_t teeth)
{
  ConstraintCase result;
  Chain loop;
  for (std::size_t i = 0; i < 2 * teeth; ++i)
  {
    loop.push_back(std::int64_t(i));
    result.points.push_back({ double(2 * teeth - i), i % 2 == 0 ? 1.0 : double(teeth) });
  }
  for (const double x : { 0.0, double(2 * teeth) })
  {
    loop.push_back(std::int64_t(result.points.size()));
    result.points.push_back({ x, 0.0 });
  }
  result.constraints.addLoop(loop);
  return result;
}

/// A closed band along a spiral: its line there and back again, a little to the side.
ConstraintCase spiralBand(std::size_t n)
{
  const ConstraintCase line = spiralLine(n, 100);
  ConstraintCase result;
  Chain loop;
  for (const double scale : { 1.0, 1.0 + 0.01 / double(n) })
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const Point& p = line.points[scale == 1.0 ? i : n - 1 - i];
      loop.push_back(std::int64_t(result.points.size()));
      result.points.push_back({ scale * p.x, scale * p.y });
    }
  }
  result.constraints.addLoop(loop);
  return result;
}

void Stack::useManyConstraints(std::size_t n)
{
  const ConstraintCase cases[] = { starPolygon(n / 10), shortSegments(n, n / 4),
    randomSegments(n, n / 10), segmentAcross(n), segmentAcrossParabolas(n), segmentAcrossBulges(n),
    segmentAcrossCombs(n), spiralLine(n / 2, 10), nearlyCollinearLines(n / 2),
    latticeSegments(100, n / 5), squaresWithinSquares(1000), comb(n / 2), spiralBand(n / 4) };
  for (const ConstraintCase& given : cases)
  {
    SCOPED_TRACE(&given - cases);
    expectLittle([&] { useConstraints(given); });
  }
}

TEST_F(Stack, Constraints)
{
  useManyConstraints(20000);
}

TEST_F(LongStack, ManyConstraints)
{
  useManyConstraints(1000000);
}

TEST_F(Stack, ConstraintsAndCrossingsAtTheEndsOfTheExponentRange)
{
  for (const Distribution d :
    { Distribution::Tiny, Distribution::Huge, Distribution::TinyAndHuge, Distribution::AnyFinite })
  {
    SCOPED_TRACE(nameOf(d));
    const ConstraintCase given = chainsThrough(d, 120, 30, 3);
    expectLittle([&] { useConstraints(given); });
    expectLittle([&] { useSplit(given); });
  }
}

TEST_F(Stack, Crossings)
{
  const ConstraintCase cases[] = { randomSegments(2000, 300), shortSegments(40000, 10000),
    starPolygon(5000), latticeSegments(60, 2000), nearlyCollinearLines(5000),
    squaresWithinSquares(1000), comb(10000), chainsThrough(Distribution::OnCircle, 400, 30, 1) };
  for (const ConstraintCase& given : cases)
  {
    SCOPED_TRACE(&given - cases);
    expectLittle([&] { useSplit(given); });
  }
}

} // namespace
} // namespace test
} // namespace ahd
