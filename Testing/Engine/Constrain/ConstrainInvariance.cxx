// SPDX-License-Identifier: BSD-3-Clause
//
// The constrained result is a function of the points and of the segments that are accepted:
// settings, threads, ids and the order of segments that do not cross change nothing.
#include "ConstrainedRun.h"
#include "Executors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

std::vector<ConstraintCase> cases()
{
  return { randomSegments(reduced(3000), 400), latticeSegments(30, 600), nestedLoops(6),
    starPolygon(300), segmentAcrossCombs(400),
    chainsThrough(Distribution::RepeatedDraws, 1500, 60, 1),
    chainsThrough(Distribution::OnIntegerCircle, 300, 40, 2) };
}

TEST(ConstrainInvariance, NoSettingChangesAByte)
{
  Engine engine;
  for (const ConstraintCase& given : cases())
  {
    const ConstrainedOutcome expected = constrain(given, FillRule::EvenOdd);
    ASSERT_EQ(expected.status, Status::Ok);
    for (const Options& options : everyDistinctSetting({ 1, 50 }))
    {
      const ConstrainedOutcome found = constrain(
        engine, given.view(), given.constraints.view(), FillRule::EvenOdd, options);
      ASSERT_EQ(difference(expected, found), "") << describe(options);
    }
  }
}

/// Enough points for all phases to share, and segments for several territories: short ones, ones
/// that share triangles, a hub with very many, rows through vertices, and one that crosses others.
std::vector<ConstraintCase> casesForThreads()
{
  std::vector<ConstraintCase> all = { edgesOfOthers(34000, 12000), shortSegments(34000, 12000),
    starPolygon(12000), latticeSegments(185, 9000), randomSegments(34000, 6000) };
  ConstraintCase rows;
  rows.points = makePoints(Distribution::Lattice, 184 * 184, 1);
  for (std::int64_t row = 0; row < 184; ++row)
  {
    Chain chain;
    for (std::int64_t i = 0; i < 184; i += 1 + row % 3 * 20)
    {
      chain.push_back(row * 184 + i);
    }
    rows.constraints.addLine(chain);
  }
  all.push_back(rows);
  all.push_back(edgesOfOthers(34000, 12000));
  all.back().points.push_back({ -1.0, 0.4 });
  all.back().points.push_back({ 2.0, 0.6 });
  all.back().constraints.addLine({ 34000, 34001 });
  return all;
}

TEST(ConstrainInvariance, NoThreadChangesAByte)
{
  ThreadExecutor two(2);
  ThreadExecutor five(5);
  BackwardExecutor backward(4);
  for (const ConstraintCase& given : casesForThreads())
  {
    const ConstrainedOutcome expected = constrain(given, FillRule::Orientation);
    for (Executor* executor : { static_cast<Executor*>(&two), static_cast<Executor*>(&five),
           static_cast<Executor*>(&backward) })
    {
      if (executor != &backward || !kOnlyThreadsMatter)
      {
        EXPECT_EQ(differenceByThreads(given, FillRule::Orientation, expected, *executor), "");
      }
    }
  }
}

/// Segments that do not cross are made edges in another order than theirs; one more that crosses
/// many, as the last one, makes the engine insert these in the order given, and then changes
/// nothing else.
TEST(ConstrainInvariance, OneThatCrossesChangesNothingElse)
{
  ConstraintCase given = shortSegments(3000, 1000);
  given.points.push_back({ -1.0, 0.4 });
  given.points.push_back({ 2.0, 0.6 });
  const ConstrainedOutcome expected = constrain(given, FillRule::Orientation);
  EXPECT_EQ(expected.constraints.crossing, 0u);
  given.constraints.addLine({ 3000, 3001 });
  const ConstrainedOutcome found = constrain(given, FillRule::Orientation);
  EXPECT_EQ(found.constraints.crossing, 1u);
  EXPECT_EQ(found.triples, expected.triples);
  EXPECT_EQ(found.constraints.edges, expected.constraints.edges);
}

/// The same outcome in other ids.
std::vector<std::int32_t> renamedTriples(
  const ConstrainedOutcome& outcome, const std::vector<std::int32_t>& newId)
{
  std::vector<std::int32_t> result = outcome.triples;
  for (std::int32_t& id : result)
  {
    id = newId[std::size_t(id)];
  }
  return result;
}

/// By vertex of `from`: the vertex of `to` at the same place.
std::vector<std::int32_t> samePlaces(const ConstraintCase& from, const ConstraintCase& to)
{
  std::vector<Point> both = to.points;
  both.insert(both.end(), from.points.begin(), from.points.end());
  const std::vector<std::int32_t> vertices = verticesOf(viewOf(both));
  return std::vector<std::int32_t>(
    vertices.begin() + std::ptrdiff_t(to.points.size()), vertices.end());
}

void expectSameInOtherIds(const ConstraintCase& given, std::uint64_t seed, FillRule rule)
{
  SCOPED_TRACE(given.points.size() < 20 ? given.text() : "");
  const ConstraintCase shuffled = shuffledCase(given, seed);
  const ConstrainedOutcome expected = constrain(given, rule);
  ConstrainedOutcome found = constrain(shuffled, rule);
  if (given.skip.empty())
  {
    found.triples = renamedTriples(found, samePlaces(shuffled, given));
  }
  else
  {
    found.triples = expected.triples; // which of coincident points is left out may differ
  }
  found.pointStatus = expected.pointStatus;
  EXPECT_EQ(difference(expected, found), "");
}

TEST(ConstrainInvariance, OtherIdsChangeNothingElse)
{
  std::uint64_t seed = 0;
  for (const ConstraintCase& given : cases())
  {
    expectSameInOtherIds(given, ++seed, FillRule::Orientation);
  }
  for (; seed < 800 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectSameInOtherIds(smallConstraintCase(seed), seed, kFillRules[seed % 2]);
  }
}

/// The chains in another order, and each of them backwards if `backwards`. @pre lines only.
ConstraintSet shuffledChains(const ConstraintSet& constraints, std::uint64_t seed, bool backwards)
{
  std::vector<std::size_t> order(constraints.chains());
  std::iota(order.begin(), order.end(), std::size_t(0));
  Random random(seed);
  for (std::size_t i = order.size(); i > 1; --i)
  {
    std::swap(order[i - 1], order[random.below(i)]);
  }
  ConstraintSet result;
  for (const std::size_t k : order)
  {
    Chain chain = constraints.chain(k);
    if (backwards)
    {
      std::reverse(chain.begin(), chain.end());
    }
    result.addLine(chain);
  }
  return result;
}

TEST(ConstrainInvariance, TheOrderOfSegmentsThatDoNotCrossChangesNothing)
{
  for (const ConstraintCase& given : { edgesOfOthers(reduced(3000), 800), nestedLoops(5),
         starPolygon(200), spiralLine(500, 10), segmentAcrossBulges(300) })
  {
    ConstraintCase lines = given;
    lines.constraints = given.constraints.asLines();
    const ConstrainedOutcome expected = constrain(lines, FillRule::Orientation);
    ASSERT_EQ(expected.constraints.crossing, 0u);
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
    {
      ConstraintCase other = lines;
      other.constraints = shuffledChains(lines.constraints, seed, seed % 2 == 0);
      EXPECT_EQ(difference(expected, constrain(other, FillRule::Orientation)), "");
    }
  }
}

TEST(ConstrainInvariance, ANewTriangulationForgetsTheConstraintsBefore)
{
  Engine engine;
  for (std::uint64_t seed = 0; seed < 400; ++seed)
  {
    const ConstraintCase given = smallConstraintCase(seed);
    const FillRule rule = kFillRules[seed % 2];
    const ConstrainedOutcome again = constrain(
      engine, given.view(), given.constraints.view(), rule);
    ASSERT_EQ(difference(constrain(given, rule), again), "") << given.text();
    if (seed % 5 == 0)
    {
      const Outcome plain = triangulate(engine, given.view());
      ASSERT_EQ(plain.triples, triangulate(given.view()).triples) << given.text();
      ASSERT_EQ(engine.constraints().segments, 0u) << "constraints of the run before";
    }
  }
}

TEST(ConstrainInvariance, TheTrianglesCanBeHadBeforeAndAfter)
{
  Engine engine;
  for (const ConstraintCase& given : cases())
  {
    const Outcome plain = triangulate(given.view());
    const Outcome before = triangulate(engine, given.view());
    EXPECT_EQ(before.triples, plain.triples);
    ASSERT_EQ(engine.constrain(given.constraints.view(), FillRule::EvenOdd, nullptr), Status::Ok);
    std::vector<std::int32_t> triples(3 * engine.report().triangles);
    ASSERT_EQ(engine.writeTriangles(triples.data(), nullptr), Status::Ok);
    EXPECT_EQ(triples, constrain(given, FillRule::EvenOdd).triples);
  }
}

TEST(ConstrainInvariance, FloatsAndStridesAreTheSame)
{
  const ConstraintCase given = latticeSegments(20, 300);
  std::vector<float> floats;
  for (const Point& p : given.points)
  {
    floats.insert(floats.end(), { float(p.x), float(p.y), 7.0f });
  }
  Engine engine;
  EXPECT_EQ(difference(constrain(given, FillRule::EvenOdd),
              constrain(engine, PointView(floats.data(), given.points.size(), 3),
                given.constraints.view(), FillRule::EvenOdd)),
    "");
}

} // namespace
} // namespace test
} // namespace ahd
