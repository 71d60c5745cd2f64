// SPDX-License-Identifier: BSD-3-Clause
//
// The tables of a triangulation: they equal the outputs, neighbours are mutual, and after any
// failure they can be made again.
#include "ConstrainedRun.h"
#include "EngineRun.h"
#include "Executors.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

/// A vertex with very many neighbours inside, and one on the hull.
std::vector<Point> hubs(std::size_t spokes)
{
  std::vector<Point> points = { { 0.0, 0.0 }, { 0.0, 1e9 } };
  for (std::size_t i = 0; i < spokes; ++i)
  {
    const double angle = 6.28 * double(i) / double(spokes);
    points.push_back({ std::cos(angle), std::sin(angle) });
    points.push_back({ double(i) - 0.5 * double(spokes), -2.0 - 1e-9 * double(i * i) });
  }
  return points;
}

struct Input
{
  const char* name;
  std::vector<Point> points;
};

std::vector<Input> inputs()
{
  return { { "uniform", makePoints(Distribution::Uniform, reduced(40000), 1) },
    { "duplicates", makePoints(Distribution::RepeatedDraws, 3000, 1) },
    { "circle", makePoints(Distribution::OnCircle, 3000, 1) }, { "hubs", hubs(3000) },
    { "line", makePoints(Distribution::Collinear, 100, 1) },
    { "triangle", { { 0, 0 }, { 1, 0 }, { 0, 1 } } }, { "two", { { 0, 0 }, { 1, 0 } } },
    { "none", {} } };
}

/// The triples of all triangles that are kept, by the tables.
std::vector<std::int32_t> keptTriples(const Triangulation& made)
{
  std::vector<std::int32_t> result;
  for (std::size_t t = 0; t < made.triangleCount(); ++t)
  {
    for (HalfEdge h = HalfEdge(3 * t); made.isKept(t) && h < 3 * t + 3; ++h)
    {
      result.push_back(std::int32_t(made.pointOf(made.origin(h))));
    }
  }
  return result;
}

void expectTwins(const Triangulation& made)
{
  std::size_t hull = 0;
  for (HalfEdge h = 0; h < 3 * made.triangleCount(); ++h)
  {
    const HalfEdge twin = made.twin(h);
    hull += twin == kNoHalfEdge ? 1 : 0;
    if (twin != kNoHalfEdge)
    {
      ASSERT_EQ(made.twin(twin), h);
      ASSERT_EQ(made.origin(twin), made.target(h));
      ASSERT_EQ(made.target(twin), made.origin(h));
      ASSERT_EQ(made.isConstrained(twin), made.isConstrained(h));
    }
  }
  const std::size_t vertices = made.report().inserted;
  EXPECT_TRUE(made.triangleCount() == 0 || made.triangleCount() == 2 * vertices - 2 - hull);
}

/// Turning from each start passes all triangles of the vertex, the hull last.
void expectTurns(const Triangulation& made)
{
  std::vector<std::size_t> corners(made.vertexCount());
  for (HalfEdge h = 0; h < 3 * made.triangleCount(); ++h)
  {
    ++corners[made.origin(h)];
  }
  for (Index v = 0; v < made.vertexCount(); ++v)
  {
    const HalfEdge start = made.start(v);
    ASSERT_EQ(start == kNoHalfEdge, corners[v] == 0);
    std::size_t passed = 0;
    for (HalfEdge h = start; h != kNoHalfEdge && (passed == 0 || h != start); ++passed)
    {
      ASSERT_EQ(made.origin(h), v);
      h = made.nextAround(h);
    }
    ASSERT_EQ(passed, corners[v]);
  }
}

void expectVertices(const Triangulation& made, const std::vector<std::int64_t>& status)
{
  for (Index v = 0; v < made.vertexCount(); ++v)
  {
    const Point a = made.at(v), b = made.points()[made.pointOf(v)];
    ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << "with the sign of its zeros";
  }
  for (std::size_t i = 0; i < status.size(); ++i)
  {
    const Index vertex = made.vertexOf(i);
    ASSERT_EQ(vertex == kNoIndex, status[i] < 0);
    ASSERT_TRUE(vertex == kNoIndex || std::int64_t(made.pointOf(vertex)) == status[i]);
  }
}

/// Made before the triangles are written or after, on threads or not: the same.
void expectTables(const Input& input, bool isWrittenFirst, Executor* executor)
{
  SCOPED_TRACE(std::string(input.name) + (isWrittenFirst ? ", written" : ""));
  const Outcome expected = triangulate(input.points);
  Engine engine;
  ASSERT_EQ(engine.run(viewOf(input.points), Options(), nullptr, executor), Status::Ok);
  std::vector<std::int32_t> triples(expected.triples.size(), -7);
  if (isWrittenFirst)
  {
    ASSERT_EQ(engine.writeTriangles(triples.data(), nullptr, executor), Status::Ok);
  }
  const Context context{ nullptr, executor };
  ASSERT_EQ(engine.made.makeCorners(context), Status::Ok);
  ASSERT_EQ(engine.made.makeNeighbors(context), Status::Ok);
  ASSERT_EQ(engine.made.makePointMap(context), Status::Ok);
  ASSERT_EQ(engine.writeTriangles(triples.data(), nullptr, executor), Status::Ok);
  EXPECT_EQ(triples, expected.triples);
  EXPECT_EQ(keptTriples(engine.made), expected.triples);
  expectTwins(engine.made);
  expectTurns(engine.made);
  expectVertices(engine.made, expected.pointStatus);
}

TEST(Tables, SayWhatIsWritten)
{
  for (const Input& input : inputs())
  {
    expectTables(input, false, nullptr);
    expectTables(input, true, nullptr);
  }
}

TEST(Tables, OnThreads)
{
  ThreadExecutor threads(3);
  expectTables(inputs()[0], false, &threads);
  expectTables(inputs()[0], true, &threads);
}

TEST(Tables, OfPointsBeyondTheLimitAndLeftOut)
{
  std::vector<Point> points = makePoints(Distribution::RepeatedDraws, 500, 1);
  points.push_back({ std::nan(""), 0.0 });
  std::vector<unsigned char> skip(points.size());
  skip[7] = 1;
  PointView view = viewOf(points);
  view.skip = skip.data();
  Options options;
  options.insertionLimit = 50;
  Engine engine;
  const Outcome outcome = triangulate(engine, view, options);
  ASSERT_EQ(outcome.status, Status::Ok);
  ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
  ASSERT_EQ(engine.made.makePointMap({}), Status::Ok);
  EXPECT_GT(outcome.report.beyondLimit, 10u);
  expectTwins(engine.made);
  expectTurns(engine.made);
  expectVertices(engine.made, outcome.pointStatus);
}

TEST(Tables, WithConstraints)
{
  ThreadExecutor threads(3);
  const ConstraintCase all[] = { starPolygon(1000), nestedLoops(30), shortSegments(5000, 1000),
    latticeSegments(40, 800), edgesOfOthers(20000, 2000) };
  for (const ConstraintCase& given : all)
  {
    for (Executor* const executor :
      { static_cast<Executor*>(nullptr), static_cast<Executor*>(&threads) })
    {
      const ConstrainedOutcome expected = constrain(given, FillRule::EvenOdd);
      Engine engine;
      ASSERT_EQ(engine.run(given.view(), Options(), nullptr, executor), Status::Ok);
      ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok) << "to be forgotten";
      ASSERT_EQ(engine.constrain(given.constraints.view(), FillRule::EvenOdd), Status::Ok);
      ASSERT_EQ(engine.made.makeNeighbors({ nullptr, executor }), Status::Ok);
      EXPECT_EQ(keptTriples(engine.made), expected.triples);
      std::vector<std::int32_t> triples(expected.triples.size(), -7);
      ASSERT_EQ(engine.writeTriangles(triples.data(), nullptr, executor), Status::Ok);
      EXPECT_EQ(triples, expected.triples);
      expectTwins(engine.made);
      expectTurns(engine.made);
      std::size_t halves = 0; // of constraints that are no edges of the hull, twice
      for (HalfEdge h = 0; h < 3 * engine.made.triangleCount(); ++h)
      {
        const bool isOnHull = engine.made.twin(h) == kNoHalfEdge;
        halves += engine.made.isConstrained(h) ? (isOnHull ? 2 : 1) : 0;
      }
      EXPECT_EQ(halves, 2 * expected.constraints.edges);
    }
  }
}

class StopAt : public Progress
{
public:
  explicit StopAt(std::size_t at)
    : at_(at)
  {
  }
  bool advance(Phase phase, double fraction) override
  {
    EXPECT_EQ(phase, Phase::Outputs);
    EXPECT_TRUE(fraction >= 0.0 && fraction <= 1.0);
    return ++asked != at_;
  }
  std::size_t asked = 0;

private:
  std::size_t at_;
};

TEST(Tables, CanBeMadeAfterAnyCancelling)
{
  const ConstraintCase given = edgesOfOthers(20000, 2000);
  const ConstrainedOutcome expected = constrain(given, FillRule::EvenOdd);
  Engine engine;
  const auto make = [&](Progress* progress)
  {
    const Context context{ progress, nullptr };
    Status made = engine.made.makeNumbers(context);
    made = made == Status::Ok ? engine.made.makeNeighbors(context) : made;
    return made == Status::Ok ? engine.made.makePointMap(context) : made;
  };
  std::size_t stopped = 0;
  for (std::size_t at = 1; stopped < at; ++at)
  {
    std::vector<std::int32_t> triples(expected.triples.size());
    ASSERT_EQ(engine.run(given.view()), Status::Ok);
    ASSERT_EQ(engine.constrain(given.constraints.view(), FillRule::EvenOdd), Status::Ok);
    ASSERT_EQ(engine.writeTriangles(triples.data()), Status::Ok);
    StopAt progress(at);
    const Status status = make(&progress);
    if (progress.asked < at)
    {
      ASSERT_EQ(status, Status::Ok);
      EXPECT_GT(stopped, 10u);
      return;
    }
    ++stopped;
    ASSERT_EQ(status, Status::Cancelled);
    ASSERT_EQ(make(nullptr), Status::Ok);
    ASSERT_EQ(keptTriples(engine.made), expected.triples);
    expectTwins(engine.made);
  }
}

/// Outputs and queries of a triangulation whose triangles were numbered first.
void expectAfterNumbers(
  Engine& engine, const std::vector<std::int32_t>& expected, const Context& context)
{
  ASSERT_EQ(engine.made.makeNumbers(context), Status::Ok);
  ASSERT_EQ(engine.made.makeNumbers(context), Status::Ok) << "again";
  std::vector<std::int32_t> triples(expected.size(), -7);
  ASSERT_EQ(engine.made.writeTriangles(triples.data(), context), Status::Ok);
  EXPECT_EQ(triples, expected);
  ASSERT_EQ(engine.made.makeNeighbors(context), Status::Ok);
  EXPECT_EQ(keptTriples(engine.made), expected);
  expectTwins(engine.made);
  expectTurns(engine.made);
}

TEST(Tables, NumbersFirstOnThreads)
{
  ThreadExecutor threads(3);
  for (const Input& input : inputs())
  {
    SCOPED_TRACE(input.name);
    const Outcome expected = triangulate(input.points);
    for (Executor* const executor :
      { static_cast<Executor*>(nullptr), static_cast<Executor*>(&threads) })
    {
      Engine engine;
      ASSERT_EQ(engine.run(viewOf(input.points), Options(), nullptr, executor), Status::Ok);
      expectAfterNumbers(engine, expected.triples, { nullptr, executor });
      ASSERT_EQ(engine.made.makePointMap({}), Status::Ok);
      expectVertices(engine.made, expected.pointStatus);
    }
  }
}

/// Numbers of before are those of other triangles; some of those numbered are dropped.
TEST(Tables, NumbersBeforeConstraintsAndAfter)
{
  for (const ConstraintCase& given : { nestedLoops(30), edgesOfOthers(20000, 2000) })
  {
    const ConstrainedOutcome expected = constrain(given, FillRule::EvenOdd);
    Engine engine;
    ASSERT_EQ(engine.run(given.view()), Status::Ok);
    ASSERT_EQ(engine.made.makeNumbers({}), Status::Ok);
    ASSERT_EQ(engine.constrain(given.constraints.view(), FillRule::EvenOdd), Status::Ok);
    expectAfterNumbers(engine, expected.triples, {});
  }
}

class Asked : public Progress
{
public:
  bool advance(Phase, double) override { return ++times != 0; }
  std::size_t times = 0;
};

/// Called first, it sorts the triangles once.
TEST(Tables, NumbersFirstSaveWork)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, reduced(100000), 1);
  std::size_t asked[2];
  for (const bool numbersFirst : { false, true })
  {
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    std::vector<std::int32_t> triples(3 * engine.report().triangles);
    Asked progress;
    const Context context{ &progress, nullptr };
    ASSERT_EQ(numbersFirst ? engine.made.makeNumbers(context) : Status::Ok, Status::Ok);
    ASSERT_EQ(engine.made.writeTriangles(triples.data(), context), Status::Ok);
    ASSERT_EQ(engine.made.makeNeighbors(context), Status::Ok);
    asked[numbersFirst ? 1 : 0] = progress.times;
  }
  EXPECT_LT(asked[1] + points.size() / kStepsPerAsking, asked[0]);
}

/// Corners before the neighbours: no more work than the neighbours at once.
TEST(Tables, NumbersAndCornersFirstCostNothing)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, reduced(100000), 1);
  std::size_t asked[2];
  for (const bool cornersFirst : { false, true })
  {
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    Asked progress;
    const Context context{ &progress, nullptr };
    if (cornersFirst)
    {
      ASSERT_EQ(engine.made.makeNumbersAndCorners(context), Status::Ok);
      EXPECT_GT(progress.times, 0u);
      EXPECT_EQ(engine.made.triangleCount(), keptTriples(engine.made).size() / 3);
    }
    ASSERT_EQ(engine.made.makeNeighbors(context), Status::Ok);
    expectTwins(engine.made);
    asked[cornersFirst ? 1 : 0] = progress.times;
  }
  EXPECT_LT(asked[1], asked[0] + points.size() / kStepsPerAsking);
}

TEST(Tables, CanBeMadeAfterAnyWantOfMemory)
{
  const std::vector<Point> points = hubs(100);
  const Outcome expected = triangulate(points);
  Status status = Status::OutOfMemory;
  for (std::size_t k = 1; status != Status::Ok; ++k)
  {
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    account.failAt = account.allocations + k;
    status = engine.made.makeNumbers({});
    status = status == Status::Ok ? engine.made.makeNeighbors({}) : status;
    account.failAt = 0;
    ASSERT_TRUE(status == Status::Ok || status == Status::OutOfMemory);
    ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
    ASSERT_EQ(keptTriples(engine.made), expected.triples);
    expectTwins(engine.made);
    EXPECT_GT(status == Status::Ok ? k : 5, 4u);
  }
}

TEST(Tables, TakeNoMoreMemoryThanEstimated)
{
  for (const Input& input : inputs())
  {
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(input.points)), Status::Ok);
    const std::size_t before = account.held;
    account.peak = before;
    ASSERT_EQ(engine.made.makeNumbers({}), Status::Ok);
    ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
    ASSERT_EQ(engine.made.makePointMap({}), Status::Ok);
    EXPECT_LE(account.peak - before, tableMemoryEstimate(input.points.size()) + 100000)
      << input.name;
  }
}

} // namespace
} // namespace test
} // namespace ahd
