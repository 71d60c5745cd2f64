// SPDX-License-Identifier: BSD-3-Clause
//
// Bytes become points and settings (FuzzCase.h), the engine triangulates them, and the certifier
// decides; small sets go through the oracle too. Then it varies what must not change the result:
// settings, threads, the order and layout of the points, a run cancelled or without memory before,
// the door: the C interface, with all its features.
#include "JobJudge.h"
#include "Judge.h"
#include "OutlineJudge.h"
#include "SampleJudge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr std::size_t kFewForOracle = 7;

/// The first run of a case, which all others are compared with.
struct First
{
  const FuzzCase& given;
  const std::vector<Point> points; ///< as the engine reads them
  const Layout layout;
  test::Outcome outcome;

  explicit First(const FuzzCase& fuzzed)
    : given(fuzzed)
    , points(fuzzed.allPoints())
    , layout(fuzzed, points)
  {
  }
};

std::string differenceOf(const test::Outcome& a, const test::Outcome& b)
{
  return a.status != b.status        ? "other status"
    : a.triples != b.triples         ? "other triangles"
    : a.pointStatus != b.pointStatus ? "other status of points"
                                     : "";
}

/// Points left out become NaN, which the oracle leaves out.
std::vector<Point> withoutSkipped(const PointView& view)
{
  std::vector<Point> result;
  for (std::size_t i = 0; i < view.count; ++i)
  {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    result.push_back(view.skipped(i) ? Point{ kNaN, kNaN } : view[i]);
  }
  return result;
}

void expectAsDefined(const First& first)
{
  if (first.outcome.report.inserted <= kFewForOracle)
  {
    expect(test::asSet(first.outcome.triples) ==
        test::delaunayByDefinition(withoutSkipped(first.layout.view())),
      "the triangles are those of the definition", first.given);
  }
}

/// Other settings, threads, ids and layout.
void expectSameWhenShuffled(const First& first, test::Engine& engine)
{
  const std::vector<std::size_t> oldId = shuffledIds(
    first.points.size(), first.given.head[kShuffle]);
  const PointView before = first.layout.view();
  std::vector<Point> points;
  std::vector<unsigned char> skip;
  for (const std::size_t id : oldId)
  {
    points.push_back(first.points[id]);
    skip.push_back(before.skipped(id) ? 1 : 0);
  }
  PointView view = test::viewOf(points);
  view.skip = skip.data();
  Watch watch;
  Run run = runOf(first.given, 1);
  run.progress = &watch;
  test::Outcome outcome = triangulate(engine, view, run);
  expectNone(faultsOf(view, outcome), first.given);
  expectNone(watch.fault(), first.given);
  for (std::int32_t& id : outcome.triples)
  {
    id = std::int32_t(first.outcome.pointStatus[oldId[std::size_t(id)]]);
  }
  expect(
    outcome.triples == first.outcome.triples, "the shuffled triangles are the same", first.given);
}

/// The order that a run kept is one of all vertices, and the ranks are its inverse.
void expectOrder(const First& first, test::Engine& engine, Executor* executor)
{
  std::vector<std::int64_t> order(engine.report().inserted, -7);
  std::vector<std::int64_t> ranks(first.points.size(), -7);
  expect(
    engine.writeOrder(order.data(), nullptr, executor) == Status::Ok, "order written", first.given);
  expect(engine.writeInsertionRanks(ranks.data(), nullptr, executor) == Status::Ok, "ranks written",
    first.given);
  std::vector<std::int64_t> expected(first.points.size(), kRankNone);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const auto id = std::size_t(order[i]);
    expect(
      id < expected.size() && expected[id] == kRankNone, "each in the order once", first.given);
    expect(
      first.outcome.pointStatus[id] == order[i], "those in the order are vertices", first.given);
    expected[id] = std::int64_t(i);
  }
  expect(ranks == expected, "ranks are places in the order", first.given);
}

/// The boxes hold all vertices, and have an inside.
void expectBoxes(const First& first, const test::Engine& engine, InsertionOrder order)
{
  std::size_t count = 0;
  for (const GridBox& box : engine.boxes())
  {
    count += box.count;
    expect(box.xmin <= box.xmax && box.ymin <= box.ymax && box.level >= 0, "boxes are boxes",
      first.given);
  }
  const std::size_t vertices = order == InsertionOrder::AsGiven ? 0 : first.outcome.report.inserted;
  expect(count == vertices, "each vertex is in one box", first.given);
}

/// Twins are mutual, and each vertex is located at its place.
void expectTables(const First& first, const Triangulation& made)
{
  const HalfEdge halfEdges = static_cast<HalfEdge>(3 * made.triangleCount());
  std::size_t hull = 0;
  for (HalfEdge h = 0; h < halfEdges; ++h)
  {
    const HalfEdge twin = made.twin(h);
    hull += twin == kNoHalfEdge ? 1 : 0;
    expect(twin == kNoHalfEdge ||
        (made.twin(twin) == h && made.origin(twin) == made.target(h) &&
          made.target(twin) == made.origin(h)),
      "twins are the same edge", first.given);
    if (h % (1 + halfEdges / 300) == 0)
    {
      const Location found = made.locate(made.at(made.origin(h)), h * std::size_t(7));
      expect(found.kind == Location::OnVertex && found.halfEdge == made.start(made.origin(h)),
        "a vertex is found", first.given);
    }
  }
  expect(made.triangleCount() == 0 ||
      made.triangleCount() + hull + 2 == 2 * first.outcome.report.inserted,
    "the hull has as many edges as Euler says", first.given);
}

/// Which point of each place stands for the vertex follows z; nothing else does.
void expectRepresentatives(const First& first, const Run& run)
{
  const PointView view = first.layout.view();
  std::vector<double> xyz;
  for (std::size_t i = 0; i < view.count; ++i)
  {
    const double z = first.given.head[kShuffle] * i % 5 == 4 ? std::nan("") : double(i * 7 % 4);
    xyz.insert(xyz.end(), { view[i].x, view[i].y, z });
  }
  PointView points(xyz.data(), view.count, 3);
  points.skip = view.skip;
  points.skipMask = view.skipMask;
  Run wanted = run;
  const bool isLowest = first.given.head[kShuffle] % 2 != 0;
  wanted.options.representative = isLowest ? Representative::LowestZ : Representative::HighestZ;
  test::Engine engine;
  const test::Outcome outcome = triangulate(engine, points, wanted);
  const auto rank = [&](std::size_t i)
  {
    const double z = xyz[3 * i + 2];
    return std::isfinite(z) ? (isLowest ? -z : z) : -1e300;
  };
  std::vector<std::int64_t> expected = first.outcome.pointStatus;
  std::vector<std::int64_t> best(view.count, -1); // of each smallest id
  for (std::size_t i = 0; i < view.count; ++i)
  {
    std::int64_t& chosen = best[std::size_t(std::max<std::int64_t>(0, expected[i]))];
    if (expected[i] >= 0 && (chosen < 0 || rank(i) > rank(std::size_t(chosen))))
    {
      chosen = std::int64_t(i);
    }
  }
  for (std::int64_t& status : expected)
  {
    status = status < 0 ? status : best[std::size_t(status)];
  }
  std::vector<std::int32_t> triples = first.outcome.triples;
  for (std::int32_t& id : triples)
  {
    id = std::int32_t(best[std::size_t(id)]);
  }
  expect(outcome.pointStatus == expected, "z says who stands for a vertex", first.given);
  expect(outcome.triples == triples, "z says whose ids triangles have", first.given);
}

/// Further queries of the first run.
void expectExtras(const First& first, test::Engine& engine)
{
  const Run run = runOf(first.given, 0);
  std::vector<std::int64_t> wide(first.outcome.triples.size(), -7);
  for (const bool withTables : { false, true }) // before there are tables, and from these
  {
    expect(engine.writeTriangles(wide.data(), nullptr, run.executor) == Status::Ok,
      "triangles written again", first.given);
    expect(std::equal(wide.begin(), wide.end(), first.outcome.triples.begin()),
      "64-bit ids are those of 32 bits", first.given);
    wide.assign(wide.size(), -7);
    expect(withTables || engine.made.makeNeighbors({ nullptr, run.executor }) == Status::Ok,
      "tables made", first.given);
  }
  expectTables(first, engine.made);
  if (first.given.layoutBit(3))
  {
    expectRepresentatives(first, run);
  }
  if (run.options.keepOrder)
  {
    expectOrder(first, engine, run.executor);
  }
  if (run.options.keepBoxes)
  {
    expectBoxes(first, engine, run.options.order);
  }
}

/// A run with a limit gives the triangulation of the first points of the order.
void expectMeshOfTheFirst(const First& first, test::Engine& engine)
{
  Run run = runOf(first.given, 0);
  run.options.keepOrder = true;
  run.options.insertionLimit = first.given.head[kLimit];
  const test::Outcome limited = triangulate(engine, first.layout.view(), run);
  expect(limited.status == Status::Ok, "the run with a limit is Ok", first.given);
  std::vector<std::int64_t> order(limited.report.inserted);
  expect(engine.writeOrder(order.data(), nullptr) == Status::Ok, "order", first.given);
  std::vector<Point> points;
  for (const std::int64_t id : order)
  {
    points.push_back(first.points[std::size_t(id)]);
  }
  test::Outcome expected = test::triangulate(points, first.given.options(1));
  expectNone(faultsOf(points, expected), first.given);
  for (std::int32_t& id : expected.triples)
  {
    id = std::int32_t(order[std::size_t(id)]);
  }
  expect(test::asSet(expected.triples) == test::asSet(limited.triples) &&
      expected.triples.size() == limited.triples.size(),
    "a limit gives the triangles of the first", first.given);
  const Report &report = limited.report, &whole = first.outcome.report;
  expect(report.inserted == std::min(whole.inserted, run.options.insertionLimit) &&
      report.inserted + report.beyondLimit == whole.inserted,
    "as many as the limit says", first.given);
}

void expectTooManyBoxes(const First& first, test::Engine& engine)
{
  Run run = runOf(first.given, 0);
  run.options.keepBoxes = true;
  const Status all = engine.run(first.layout.view(), run.options, nullptr, run.executor);
  expect(all == Status::Ok, "the run with boxes is Ok", first.given);
  const std::size_t boxes = engine.boxes().size();
  run.options.mostBoxes = first.given.head[kMostBoxes];
  const Status some = engine.run(first.layout.view(), run.options, nullptr, run.executor);
  expect(
    some == (boxes > run.options.mostBoxes ? Status::TooManyBoxes : Status::Ok), "", first.given);
}

/// A run that is cancelled reports it.
void expectCancelled(const First& first, test::Engine& engine)
{
  Run run = runOf(first.given, 0);
  Watch watch(first.given.head[kCancelAt]);
  run.progress = &watch;
  const test::Outcome stopped = triangulate(engine, first.layout.view(), run);
  expectNone(watch.fault(), first.given);
  expect(stopped.status == (watch.cancelled() ? Status::Cancelled : Status::Ok),
    "cancelled if told to", first.given);
  expect(watch.cancelled() || differenceOf(first.outcome, stopped).empty(), "the same, watched",
    first.given);
}

/// A run without memory reports it, or is correct.
void expectOutOfMemory(const First& first, test::Engine& engine)
{
  engine.release();
  const NoMemory none(first.given.head[kFailAt]);
  const test::Outcome failed = triangulate(engine, first.layout.view(), runOf(first.given, 0));
  const NoMemory again(0);
  expect(failed.status == Status::OutOfMemory || differenceOf(first.outcome, failed).empty(),
    "out of memory or right", first.given);
}

/// More points than the engine takes are refused unread; released memory is gone; the estimate is
/// no less than the memory kept.
void expectRefusals(const First& first, test::Engine& engine)
{
  const Run run = runOf(first.given, 0);
  engine.reclaim();
  expect(engine.workspace.bytes() <= triangulationMemoryEstimate(first.points.size(), run.options) +
        triangulationMemoryEstimate(first.points.size(), first.given.options(1)),
    "no more memory is kept than was estimated", first.given);
  PointView view = first.layout.view();
  view.count = kMaximumPoints + 1;
  expect(engine.run(view, run.options, nullptr) == Status::TooManyPoints,
    "too many points are refused", first.given);
  expect(engine.report().triangles == 0, "nothing is left", first.given);
  engine.release();
}

/// Failures leave nothing behind: the next run is unaffected.
void expectTrouble(const First& first, test::Engine& engine)
{
  using Trouble = void (*)(const First&, test::Engine&);
  constexpr std::pair<HeadByte, Trouble> kAll[] = { { kLimit, expectMeshOfTheFirst },
    { kMostBoxes, expectTooManyBoxes }, { kCancelAt, expectCancelled },
    { kFailAt, expectOutOfMemory }, { kRefusals, expectRefusals } };
  bool isAny = false;
  for (const auto& [byte, trouble] : kAll)
  {
    if (first.given.head[byte] != 0)
    {
      isAny = true;
      trouble(first, engine);
    }
  }
  if (isAny)
  {
    const test::Outcome again = triangulate(engine, first.layout.view(), runOf(first.given, 0));
    expectNone(differenceOf(first.outcome, again), first.given);
  }
}

} // namespace

void fuzzEngine(const FuzzCase& given)
{
  First first(given);
  test::Engine engine;
  first.outcome = triangulate(engine, first.layout.view(), runOf(given, 0));
  expectNone(faultsOf(first.layout.view(), first.outcome), given);
  expectAsDefined(first);
  expectExtras(first, engine);
  const PointView view = first.layout.view();
  expectSamples(given, { engine.made, view, first.outcome.triples, runOf(given, 0).executor });
  expectOutlines(given, view, first.outcome.triples);
  expectSameWhenShuffled(first, engine);
  expectTrouble(first, engine);
  expectSameThroughC(
    given, { first.layout.view(), ConstraintView(), FillRule::Orientation, first.outcome.triples });
}

} // namespace fuzz
} // namespace ahd

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  ahd::fuzz::fuzzEngine(ahd::fuzz::FuzzCase::fromBytes(data, size));
  return 0;
}
