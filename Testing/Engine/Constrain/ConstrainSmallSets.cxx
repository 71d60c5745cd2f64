// SPDX-License-Identifier: BSD-3-Clause
//
// Constraints against the definition: brute force in exact arithmetic (ConstraintOracle.h) on small
// sets, and the large sets' certifier beside it.
#include "ConstrainedRun.h"
#include "ConstraintOracle.h"
#include "Oracle.h"

#include <gtest/gtest.h>

#include <numeric>
#include <tuple>

namespace ahd
{
namespace test
{
namespace
{

// --- The oracle on cases solved by hand ----------------------------------------------------

/// A square of four points, its middle (4) and a point on the lower edge (5).
const std::vector<Point> kHouse = { { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 }, { 4, 5 }, { 4, 0 } };

ConstrainedByDefinition defined(const std::vector<Point>& points, const ConstraintSet& constraints,
  FillRule rule = FillRule::Orientation)
{
  return constrainedByDefinition(viewOf(points), constraints.view(), rule);
}

TEST(ConstraintOracle, WithoutConstraintsItIsTheOther)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const std::vector<Point> points = makePoints(Distribution::Lattice, 9, seed);
    EXPECT_EQ(defined(points, ConstraintSet()).all, delaunayByDefinition(points));
  }
}

TEST(ConstraintOracle, TheDiagonalIsTheOneAskedFor)
{
  const std::vector<Point> square = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
  for (const Chain& diagonal : { Chain{ 0, 3 }, Chain{ 1, 2 } })
  {
    ConstraintSet constraints;
    constraints.addLine(diagonal);
    const ConstrainedByDefinition result = defined(square, constraints);
    const std::set<Triple> expected = diagonal[0] == 0
      ? std::set<Triple>{ { 0, 1, 3 }, { 0, 3, 2 } }
      : std::set<Triple>{ { 0, 1, 2 }, { 1, 3, 2 } };
    EXPECT_EQ(result.all, expected);
    EXPECT_EQ(result.edges, (std::set<EdgeIds>{ { diagonal[0], diagonal[1] } }));
    EXPECT_EQ(result.regions.at(*expected.begin()), 0);
    EXPECT_EQ(result.regions.at(*expected.rbegin()), 1);
  }
}

TEST(ConstraintOracle, APointOnASegmentSplitsIt)
{
  ConstraintSet constraints;
  constraints.addLine({ 0, 1 });
  const ConstrainedByDefinition result = defined(kHouse, constraints);
  EXPECT_EQ(result.edges, (std::set<EdgeIds>{ { 0, 5 }, { 1, 5 } }));
}

TEST(ConstraintOracle, TheLaterOfTwoThatCrossIsLeftOut)
{
  ConstraintSet constraints;
  constraints.addLine({ 3, 5 });
  constraints.addLine({ 5, 2 });
  constraints.addLine({ 4, 0 });
  constraints.addLine({ 4, 1 });
  constraints.addLine({ 4, 4 });
  constraints.addLine({ 4, 99 });
  const ConstraintReport report = defined(kHouse, constraints).report;
  ASSERT_EQ(report.leftOut.size(), 2u);
  EXPECT_EQ(report.leftOut[0].chain, 2u);
  EXPECT_EQ(report.leftOut[0].otherChain, 0u);
  EXPECT_EQ(report.leftOut[1].chain, 3u);
  EXPECT_EQ(report.leftOut[1].otherChain, 1u);
  EXPECT_EQ(report.segments, 6u);
  EXPECT_EQ(report.points, 1u);
  EXPECT_EQ(report.withoutVertex, 1u);
  EXPECT_EQ(report.crossing, 2u);
  EXPECT_EQ(report.edges, 2u);
}

TEST(ConstraintOracle, SegmentsThatMeetInAVertexDoNotCross)
{
  ConstraintSet constraints;
  constraints.addLine({ 0, 3 });
  constraints.addLine({ 1, 2 });
  const ConstraintReport report =
    defined({ { 0, 0 }, { 2, 0 }, { 0, 2 }, { 2, 2 }, { 1, 1 } }, constraints).report;
  EXPECT_EQ(report.crossing, 0u);
  EXPECT_EQ(report.edges, 4u);
}

TEST(ConstraintOracle, LoopsKeepTheirLeft)
{
  for (const bool isHole : { false, true })
  {
    ConstraintSet constraints;
    constraints.addLoop(isHole ? Chain{ 4, 1, 0 } : Chain{ 0, 1, 4 });
    const ConstrainedByDefinition result = defined(kHouse, constraints);
    const std::set<Triple> inside = { { 0, 5, 4 }, { 1, 4, 5 } };
    EXPECT_EQ(result.kept.size(), isHole ? result.all.size() - 2 : 2);
    for (const Triple& t : inside)
    {
      EXPECT_EQ(result.kept.count(t), isHole ? 0u : 1u);
    }
    EXPECT_EQ(defined(kHouse, constraints, FillRule::EvenOdd).kept, inside);
  }
}

TEST(ConstraintOracle, ALoopWithASegmentLeftOutFillsNothing)
{
  ConstraintSet constraints;
  constraints.addLine({ 0, 2 });
  constraints.addLoop({ 3, 1, 0 });
  for (const FillRule rule : kFillRules)
  {
    const ConstrainedByDefinition result = defined(kHouse, constraints, rule);
    EXPECT_EQ(result.report.unfilledLoops, 1u);
    EXPECT_EQ(result.report.crossing, 1u);
    EXPECT_EQ(result.kept, result.all);
  }
}

TEST(ConstraintOracle, AWallHidesWhatIsBehindIt)
{
  // The point 4 lies in the circle of 0, 1, 2; only the wall 0-1 permits that triangle.
  const std::vector<Point> points = { { -4, 0 }, { 4, 0 }, { 0, 3 }, { 0, -9 }, { 0.5, -1 } };
  EXPECT_EQ(defined(points, ConstraintSet()).all.count({ 0, 1, 2 }), 0u);
  ConstraintSet constraints;
  constraints.addLine({ 0, 1 });
  EXPECT_EQ(defined(points, constraints).all.count({ 0, 1, 2 }), 1u);
}

// --- The engine
// --------------------------------------------------------------------------------------

std::vector<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> asTuples(
  const std::vector<LeftOut>& leftOut)
{
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> result;
  for (const LeftOut& left : leftOut)
  {
    result.emplace_back(left.chain, left.segment, left.otherChain, left.otherSegment);
  }
  return result;
}

void expectReport(const ConstraintReport& found, const ConstraintReport& expected)
{
  EXPECT_EQ(found.segments, expected.segments);
  EXPECT_EQ(found.points, expected.points);
  EXPECT_EQ(found.withoutVertex, expected.withoutVertex);
  EXPECT_EQ(found.crossing, expected.crossing);
  EXPECT_EQ(found.unfilledLoops, expected.unfilledLoops);
  EXPECT_EQ(found.edges, expected.edges);
  EXPECT_EQ(asTuples(found.leftOut), asTuples(expected.leftOut));
}

/// The constraint edges of the triangles as the engine marks them.
std::set<EdgeIds> markedEdges(const ConstrainedOutcome& outcome)
{
  std::set<EdgeIds> result;
  for (std::size_t h = 0; h < outcome.triples.size(); ++h)
  {
    if ((outcome.constraintEdges[h / 3] >> h % 3 & 1) != 0)
    {
      result.insert(std::minmax(outcome.triples[h], outcome.triples[h % 3 == 2 ? h - 2 : h + 1]));
    }
  }
  return result;
}

/// Regions by the first triangle that has their number.
std::map<Triple, int> regionsOf(const ConstrainedOutcome& outcome)
{
  std::map<Triple, int> result;
  for (std::size_t t = 0; t < outcome.regions.size(); ++t)
  {
    const std::int32_t* v = &outcome.triples[3 * t];
    result[smallestFirst({ v[0], v[1], v[2] })] = int(outcome.regions[t]);
  }
  return result;
}

/// Is each number of `a` always beside the same number of `b`, and the other way round?
bool isSamePartition(const std::map<Triple, int>& a, const std::map<Triple, int>& b)
{
  std::map<int, int> there, back;
  bool same = a.size() == b.size();
  for (const auto& entry : a)
  {
    const auto other = b.find(entry.first);
    same = same && other != b.end() &&
      there.emplace(entry.second, other->second).first->second == other->second &&
      back.emplace(other->second, entry.second).first->second == entry.second;
  }
  return same;
}

void expectAsDefined(const ConstraintCase& given, FillRule rule)
{
  SCOPED_TRACE(given.text() + nameOf(rule));
  const ConstrainedByDefinition expected = constrainedByDefinition(
    given.view(), given.constraints.view(), rule);
  const ConstrainedOutcome found = constrain(given, rule);
  ASSERT_EQ(found.status, Status::Ok);
  EXPECT_EQ(asSet(found.triples), expected.kept);
  ASSERT_EQ(found.triples.size(), 3 * expected.kept.size());
  expectReport(found.constraints, expected.report);
  std::set<EdgeIds> keptEdges;
  for (const Triple& t : expected.kept)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const EdgeIds edge = std::minmax(t[i], t[(i + 1) % 3]);
      if (expected.edges.count(edge) != 0)
      {
        keptEdges.insert(edge);
      }
    }
  }
  EXPECT_EQ(markedEdges(found), keptEdges);
  EXPECT_TRUE(isSamePartition(regionsOf(found), expected.regions)) << "regions";
  EXPECT_EQ(faultsOfConstraining(given, rule), "");
}

constexpr std::uint64_t kCases = 2000;

TEST(ConstrainSmallSets, AsDefined)
{
  for (std::uint64_t seed = 0; seed < reduced(kCases) && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectAsDefined(smallConstraintCase(seed), kFillRules[seed % 2]);
  }
}

TEST(LongConstrainSmallSets, AsDefined)
{
  for (std::uint64_t seed = kCases; seed < 400000 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectAsDefined(smallConstraintCase(seed), kFillRules[seed % 2]);
  }
}

TEST(ConstrainSmallSets, TheMakerMakesWhatItIsMeantTo)
{
  std::size_t leftOut = 0, points = 0, withoutVertex = 0, unfilled = 0, dropped = 0, split = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed)
  {
    const ConstraintCase given = smallConstraintCase(seed);
    const ConstrainedByDefinition made = constrainedByDefinition(
      given.view(), given.constraints.view(), kFillRules[seed % 2]);
    const ConstraintReport& report = made.report;
    leftOut += report.crossing > 0 ? 1 : 0;
    points += report.points > 0 ? 1 : 0;
    withoutVertex += report.withoutVertex > 0 ? 1 : 0;
    unfilled += report.unfilledLoops > 0 ? 1 : 0;
    dropped += !made.kept.empty() && made.kept.size() < made.all.size() ? 1 : 0;
    split += report.edges > report.segments ? 1 : 0;
  }
  for (const std::size_t count : { leftOut, points, withoutVertex, unfilled, dropped, split })
  {
    EXPECT_GE(count, 10u);
  }
}

} // namespace
} // namespace test
} // namespace ahd
