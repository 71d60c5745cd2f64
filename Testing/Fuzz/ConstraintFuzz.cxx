// SPDX-License-Identifier: BSD-3-Clause
//
// Bytes become points, chains and settings (FuzzCase.h). The points may be merged within a distance
// and the chains split where they cross, both compared with their definitions; the engine
// constrains, and the certifier of constraints decides; small sets go through the oracle too. Then
// the same with other settings and threads, cancelled or without memory before, to the byte; the
// Voronoi diagram of the points; the same in several blocks; the triangles refined, and edited.
#include "BlocksRun.h"
#include "ConstrainedRun.h"
#include "ConstraintOracle.h"
#include "JobJudge.h"
#include "Judge.h"
#include "LivingJudge.h"
#include "OutlineJudge.h"
#include "PartJudges.h"
#include "SampleJudge.h"
#include "TilesJudge.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr std::size_t kFewPointsForOracle = 7;
constexpr std::size_t kFewSegmentsForOracle = 8;

/// The engine's input, once merged and split.
struct Prepared
{
  explicit Prepared(const FuzzCase& fuzzed)
    : given(fuzzed)
    , points(fuzzed.allPoints())
    , rule(fuzzed.layoutBit(4) ? FillRule::EvenOdd : FillRule::Orientation)
    , own(fuzzed.constraints())
    , chains(own.view())
  {
    const std::vector<unsigned char> marks = fuzzed.skipMarks(points.size());
    for (const unsigned char mark : marks)
    {
      skip.push_back((mark & fuzzed.head[kSkipMask]) != 0 ? 1 : 0);
    }
  }

  PointView view() const
  {
    PointView result = test::viewOf(points);
    result.skip = skip.empty() ? nullptr : skip.data();
    return result;
  }

  const FuzzCase& given;
  std::vector<Point> points;
  std::vector<unsigned char> skip; ///< empty: none
  FillRule rule;
  test::ConstraintSet own;
  SplitConstraints split;
  ConstraintView chains;
};

void mergeAndSplit(Prepared& prepared)
{
  const FuzzCase& given = prepared.given;
  if (given.layoutBit(6))
  {
    MergedPoints merged;
    const double exponent = 0.5 * given.head[kMergeDistance] - 64.0;
    expectNone(mergeAndJudge(prepared.view(), std::exp2(exponent), merged), given);
    expectStops(given,
      [&](Progress* progress)
      {
        MergedPoints again;
        return mergeWithin(prepared.view(), std::exp2(exponent), progress, again);
      });
    prepared.skip = merged.skip;
  }
  if (given.layoutBit(5))
  {
    expectNone(
      splitAndJudge({ prepared.points, prepared.skip, prepared.own }, prepared.split), given);
    expectStops(given,
      [&](Progress* progress)
      {
        SplitConstraints again;
        return splitAtCrossings(prepared.view(), prepared.own.view(), progress, again);
      });
    for (const CrossingPoint& p : prepared.split.points)
    {
      prepared.points.push_back(p.at);
    }
    prepared.skip.resize(prepared.skip.empty() ? 0 : prepared.points.size(), 0);
    prepared.chains = prepared.split.view();
  }
}

test::ConstrainedOutcome constrainWith(
  const Prepared& prepared, test::Engine& engine, const Run& run, const PointView& points)
{
  return test::constrain(
    engine, points, prepared.chains, prepared.rule, run.options, { run.progress, run.executor });
}

/// The same chains, none of them a loop.
test::ConstraintSet openChains(const ConstraintView& chains)
{
  test::ConstraintSet result;
  for (std::size_t k = 0; k < chains.chains; ++k)
  {
    const test::Chain chain(chains.ids + chains.offsets[k], chains.ids + chains.offsets[k + 1]);
    k < chains.lines ? result.addLine(chain) : result.addLoop(chain);
  }
  return result.asLines();
}

void expectAsDefined(const Prepared& prepared, const test::ConstrainedOutcome& found)
{
  if (found.report.inserted > kFewPointsForOracle ||
    found.constraints.segments > kFewSegmentsForOracle ||
    prepared.points.size() > 2 * kFewPointsForOracle)
  {
    return;
  }
  const test::ConstrainedByDefinition expected = test::constrainedByDefinition(
    prepared.view(), prepared.chains, prepared.rule);
  const ConstraintReport &a = found.constraints, &b = expected.report;
  expect(
    test::asSet(found.triples) == expected.kept && found.triples.size() == 3 * expected.kept.size(),
    "the triangles are those of the definition", prepared.given);
  expect(a.segments == b.segments && a.points == b.points && a.withoutVertex == b.withoutVertex &&
      a.crossing == b.crossing && a.unfilledLoops == b.unfilledLoops && a.edges == b.edges,
    "the counts are those of the definition", prepared.given);
}

/// Constrains and writes all cell data, as long as it is Ok.
Status everythingOnce(const Prepared& prepared, test::Engine& engine, Progress* progress)
{
  Status status = engine.constrain(prepared.chains, prepared.rule, progress);
  const std::size_t triangles = status == Status::Ok ? engine.report().triangles : 0;
  std::vector<std::int64_t> numbers;
  std::vector<std::uint8_t> edges;
  {
    const NoMemory pause(0); // of the test's own data
    numbers.resize(3 * triangles);
    edges.resize(triangles);
  }
  const auto next = [&](auto write) { status = status == Status::Ok ? write() : status; };
  next([&] { return engine.writeNeighbors(numbers.data(), progress); });
  next([&] { return engine.writeRegions(numbers.data(), progress); });
  next([&] { return engine.writeConstraintEdges(edges.data(), progress); });
  return status;
}

/// A run that is cancelled or has no memory reports it, at any point.
void expectAllStops(const Prepared& prepared, test::Engine& engine)
{
  Run run = runOf(prepared.given, 0);
  expectStops(prepared.given,
    [&](Progress* progress)
    {
      return progress
        ? constrainWith(prepared, engine, { run.options, run.executor, progress }, prepared.view())
            .status
        : Status::Ok; // it allocates itself
    });
  const auto runFirst = [&]
  {
    const NoMemory pause(0);
    return engine.run(prepared.view(), run.options, nullptr, run.executor);
  };
  expectStops(prepared.given,
    [&](Progress* progress)
    {
      const Status status = runFirst();
      return status == Status::Ok ? everythingOnce(prepared, engine, progress) : status;
    });
}

/// Other settings, threads, layout of the points, and earlier runs of the engine.
void expectTheSame(const Prepared& prepared, const test::ConstrainedOutcome& expected)
{
  test::Engine engine;
  expectAllStops(prepared, engine);
  FuzzCase laidOut = prepared.given;
  laidOut.head[kSkipMarks] = 0;
  const Layout layout(laidOut, prepared.points);
  PointView points = prepared.given.layoutBit(0) && !prepared.split.points.empty()
    ? prepared.view() // added points are no floats
    : layout.view();
  points.skip = prepared.skip.empty() ? nullptr : prepared.skip.data();
  points.skipMask = 1;
  const Run run = runOf(prepared.given, 1);
  expectNone(
    test::difference(expected, constrainWith(prepared, engine, run, points)), prepared.given);
}

void expectDiagram(const Prepared& prepared)
{
  const Run run = runOf(prepared.given, 0);
  test::Engine engine;
  const test::ConstrainedOutcome plain = test::constrain(engine, prepared.view(), ConstraintView(),
    prepared.rule, run.options, { nullptr, run.executor });
  expectNone(faultsOfDiagram(engine.made, plain, run.executor), prepared.given);
  for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
  {
    expectStops(prepared.given,
      [&](Progress* progress)
      {
        VoronoiCells cells;
        {
          const NoMemory pause(0);
          engine.run(prepared.view(), run.options, nullptr, run.executor);
        }
        return voronoiCells(engine.made, clip, cells, { progress, run.executor });
      });
  }
}

/// The same triangles, if there are not too many, in a few blocks.
void expectSameInBlocks(const Prepared& prepared)
{
  constexpr std::size_t kMostPointsInBlocks = 200;
  if (prepared.points.size() > kMostPointsInBlocks)
  {
    return;
  }
  const FuzzCase& given = prepared.given;
  test::BlocksWay way;
  way.blocks = 1 + given.head[kShuffle] % 8u;
  way.blocksPerNode = 2 + given.head[kNmax] % 7u;
  way.samples = 1 + given.head[kExecutors] % 50u;
  const test::BlocksOutcome whole = test::runWhole(prepared.view(), prepared.chains, prepared.rule);
  expectNone(
    test::difference(whole, test::runBlocks(prepared.view(), prepared.chains, prepared.rule, way)),
    given);
}

/// The same triangles leaf by leaf.
void expectSameInTiles(const Prepared& prepared, const std::vector<std::int32_t>& triples)
{
  std::vector<Point> points = prepared.points;
  for (std::size_t k = 0; k < prepared.skip.size(); ++k)
  {
    points[k] = prepared.skip[k] != 0 ? Point{ std::nan(""), 0.0 } : points[k];
  }
  expectTiles(prepared.given, points, prepared.chains, prepared.rule, triples);
}

} // namespace

void fuzzConstraints(const FuzzCase& given)
{
  Prepared prepared(given);
  mergeAndSplit(prepared);
  const Run run = runOf(given, 0);
  test::Engine engine;
  const test::ConstraintSet open = openChains(prepared.chains);
  const test::ConstrainedOutcome whole = test::constrain(
    engine, prepared.view(), open.view(), prepared.rule, run.options, { nullptr, run.executor });
  const test::ConstrainedOutcome filled = constrainWith(prepared, engine, run, prepared.view());
  expect(whole.status == Status::Ok && filled.status == Status::Ok, "both runs are Ok", given);
  expectNone(test::joined(test::certifyConstrained(
               prepared.view(), prepared.chains, prepared.rule, whole, filled)),
    given);
  const bool hasCrossing = filled.constraints.crossing != 0;
  expect(!given.layoutBit(5) || prepared.split.unresolved != 0 || !hasCrossing,
    "nothing crosses once split", given);
  expectAsDefined(prepared, filled);
  const PointView view = prepared.view();
  expectSamples(given, { engine.made, view, filled.triples, run.executor });
  expectOutlines(given, view, filled.triples);
  expectLiving(given, { prepared.points, prepared.skip, prepared.own }, prepared.rule);
  expectTheSame(prepared, filled);
  expectSameInBlocks(prepared);
  expectSameInTiles(prepared, filled.triples);
  expectSameThroughC(given, { prepared.view(), prepared.chains, prepared.rule, filled.triples });
  if (given.layoutBit(7))
  {
    expectDiagram(prepared);
  }
}

} // namespace fuzz
} // namespace ahd

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  ahd::fuzz::fuzzConstraints(ahd::fuzz::FuzzCase::fromBytes(data, size));
  return 0;
}
