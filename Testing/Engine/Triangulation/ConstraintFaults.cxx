// SPDX-License-Identifier: BSD-3-Clause
//
// The certifier of constraints must detect faults: every kind is planted here and must be named.
// The engine is not used: the correct results come from the oracle.
#include "ConstraintCertifier.h"
#include "ConstraintOracle.h"
#include "ConstraintSets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

/// Neighbours, constraint edges and regions, from the oracle.
void describe(const ConstrainedByDefinition& defined, ConstrainedOutcome& outcome)
{
  std::map<EdgeIds, std::int64_t> sideOf; // of a directed edge: its triangle
  const auto corner = [&](std::size_t h) { return outcome.triples[h]; };
  const auto edge = [&](std::size_t h)
  { return EdgeIds(corner(h), corner(h % 3 == 2 ? h - 2 : h + 1)); };
  for (std::size_t h = 0; h < outcome.triples.size(); ++h)
  {
    sideOf[edge(h)] = std::int64_t(h / 3);
  }
  std::map<int, std::int64_t> numbers;
  for (std::size_t t = 0; 3 * t < outcome.triples.size(); ++t)
  {
    int bits = 0;
    for (std::size_t e = 0; e < 3; ++e)
    {
      const EdgeIds along = edge(3 * t + e);
      const auto other = sideOf.find({ along.second, along.first });
      outcome.neighbors.push_back(other == sideOf.end() ? -1 : other->second);
      bits |= defined.edges.count(std::minmax(along.first, along.second)) != 0 ? 1 << e : 0;
    }
    outcome.constraintEdges.push_back(std::uint8_t(bits));
    const Triple triple = smallestFirst({ corner(3 * t), corner(3 * t + 1), corner(3 * t + 2) });
    const int region = defined.regions.at(triple);
    outcome.regions.push_back(numbers.emplace(region, std::int64_t(numbers.size())).first->second);
  }
}

/// Points and constraints with their correct outcomes, to be corrupted.
struct Sample
{
  Sample(std::vector<Point> p, ConstraintSet set, FillRule r = FillRule::Orientation)
    : points(std::move(p))
    , constraints(std::move(set))
    , rule(r)
  {
    const ConstraintSet open = constraints.asLines();
    whole = outcomeOf(open);
    filled = outcomeOf(constraints);
  }

  PointView view() const { return PointView(&points[0].x, points.size(), 2); }

  ConstrainedOutcome outcomeOf(const ConstraintSet& set) const
  {
    const ConstrainedByDefinition defined = constrainedByDefinition(view(), set.view(), rule);
    ConstrainedOutcome outcome;
    for (const Triple& t : defined.kept)
    {
      outcome.triples.insert(outcome.triples.end(), t.begin(), t.end());
    }
    outcome.report.triangles = defined.kept.size();
    outcome.constraints = defined.report;
    outcome.pointStatus.resize(points.size());
    std::iota(outcome.pointStatus.begin(), outcome.pointStatus.end(), 0);
    describe(defined, outcome);
    return outcome;
  }

  std::string complaints() const
  {
    return joined(certifyConstrained(view(), constraints.view(), rule, whole, filled));
  }

  /// Corrupts both outcomes, as if there were no loops to fill.
  template <typename Spoil>
  void spoil(Spoil spoil)
  {
    spoil(whole);
    spoil(filled);
  }

  std::vector<Point> points;
  ConstraintSet constraints;
  FillRule rule;
  ConstrainedOutcome whole, filled;
};

/// A 3 x 3 lattice, column by column: 4 is the middle.
std::vector<Point> lattice()
{
  std::vector<Point> result;
  for (int i = 0; i < 9; ++i)
  {
    result.push_back({ double(i / 3), double(i % 3) });
  }
  return result;
}

Sample withLines(const std::vector<Chain>& lines)
{
  ConstraintSet set;
  for (const Chain& line : lines)
  {
    set.addLine(line);
  }
  return Sample(lattice(), set);
}

Sample withLoop(const Chain& loop, FillRule rule = FillRule::Orientation)
{
  ConstraintSet set;
  set.addLoop(loop);
  return Sample(lattice(), set, rule);
}

#define EXPECT_COMPLAINT(sample, words)                                                            \
  EXPECT_NE((sample).complaints().find(words), std::string::npos) << "complaints:\n"               \
                                                                  << (sample).complaints()

const Chain kLongWay = { 0, 5 };       // through the squares of the first row, no vertex on it
const Chain kCrossesIt = { 3, 2 };     // crosses 0-5
const Chain kDiamond = { 1, 3, 7, 5 }; // clockwise or not is up to the order

TEST(ConstraintFaults, RightOnesAreCertified)
{
  EXPECT_EQ(withLines({}).complaints(), "");
  EXPECT_EQ(withLines({ kLongWay, kCrossesIt, { 0, 8 }, { 4, 4 }, { 6, 77 } }).complaints(), "");
  for (const FillRule rule : { FillRule::Orientation, FillRule::EvenOdd })
  {
    EXPECT_EQ(withLoop(kDiamond, rule).complaints(), "");
    EXPECT_EQ(withLoop({ 5, 7, 3, 1 }, rule).complaints(), "");
  }
}

TEST(ConstraintFaults, ConstraintThatIsNoEdge)
{
  Sample sample = withLines({});
  sample.constraints.addLine(kLongWay);
  EXPECT_COMPLAINT(sample, "constraint missing: chain 0, segment 0 from point 0 (0x0p+0, 0x0p+0)");
}

TEST(ConstraintFaults, ConstraintThatStopsHalfway)
{
  // 0-8 runs through the middle, where only its first half is an edge.
  Sample sample = withLines({ { 0, 4 } });
  sample.constraints = withLines({ { 0, 8 } }).constraints;
  EXPECT_COMPLAINT(sample, "(0x1p+1, 0x1p+1) ends at point 4 (0x1p+0, 0x1p+0)");
}

TEST(ConstraintFaults, EdgeThatIsNeitherDelaunayNorAConstraint)
{
  Sample sample = withLines({ kLongWay });
  sample.constraints = ConstraintSet();
  EXPECT_COMPLAINT(sample, "not Delaunay: edge point");
}

TEST(ConstraintFaults, TieBrokenTheWrongWay)
{
  Sample sample = withLines({ { 0, 4 } });
  Sample other = withLines({ { 3, 1 } });
  // One of the two diagonals breaks the rule for ties.
  sample.constraints = ConstraintSet();
  other.constraints = ConstraintSet();
  EXPECT_NE(
    (sample.complaints() + other.complaints()).find("tie broken the wrong way"), std::string::npos);
}

TEST(ConstraintFaults, LeftOutWithoutCrossing)
{
  Sample sample = withLines({ kLongWay });
  sample.constraints.addLine({ 3, 7 });
  sample.spoil(
    [](ConstrainedOutcome& outcome)
    {
      outcome.constraints.segments = 2;
      outcome.constraints.crossing = 1;
      outcome.constraints.leftOut = { { 1, 0, 0, 0 } };
    });
  EXPECT_COMPLAINT(sample, "left out: chain 1, segment 0 from point 3");
  EXPECT_COMPLAINT(sample, "does not cross chain 0, segment 0 from point 0");
}

TEST(ConstraintFaults, LeftOutThoughTheyMeetInAVertex)
{
  Sample sample = withLines({ { 0, 8 } });
  sample.constraints.addLine({ 2, 6 });
  sample.spoil(
    [](ConstrainedOutcome& outcome) {
      outcome.constraints.leftOut = { { 1, 0, 0, 0 } };
    });
  EXPECT_COMPLAINT(sample, "which does not cross chain 0, segment 0");
}

TEST(ConstraintFaults, LeftOutForOneThatComesLater)
{
  Sample sample = withLines({ kLongWay, kCrossesIt });
  sample.spoil(
    [](ConstrainedOutcome& outcome) {
      outcome.constraints.leftOut[0] = { 0, 0, 1, 0 };
    });
  EXPECT_COMPLAINT(sample, "for chain 1, segment 0, which is not accepted before it");
}

TEST(ConstraintFaults, LeftOutForTheSecondThatItCrosses)
{
  Sample crossing = withLines({ { 0, 5 }, { 3, 8 }, { 2, 6 }, { 4, 3 }, { 1, 6 } });
  EXPECT_EQ(crossing.complaints(), "");
  ASSERT_FALSE(crossing.whole.constraints.leftOut.empty());
  crossing.spoil(
    [](ConstrainedOutcome& outcome)
    {
      LeftOut& last = outcome.constraints.leftOut.back();
      last.otherChain = last.otherChain == 0 ? 1 : 0;
    });
  EXPECT_COMPLAINT(crossing, "left out: chain 4, segment 0");
  EXPECT_COMPLAINT(crossing, "first");
}

TEST(ConstraintFaults, LeftOutOfOrderOrOfNoSegment)
{
  Sample sample = withLines({ kLongWay, kCrossesIt });
  sample.spoil(
    [](ConstrainedOutcome& outcome) {
      outcome.constraints.leftOut.push_back({ 0, 0, 1, 0 });
    });
  EXPECT_COMPLAINT(sample, "does not exist, or comes out of order");
}

TEST(ConstraintFaults, WrongCounts)
{
  const Sample right = withLines({ kLongWay, kCrossesIt, { 4, 4 }, { 6, 77 } });
  std::size_t ConstraintReport::*const counts[] = { &ConstraintReport::segments,
    &ConstraintReport::points, &ConstraintReport::withoutVertex, &ConstraintReport::crossing,
    &ConstraintReport::unfilledLoops, &ConstraintReport::edges };
  const char* const names[] = { "segments", "points", "withoutVertex", "crossing", "unfilledLoops",
    "edges" };
  for (std::size_t i = 0; i < 6; ++i)
  {
    Sample sample = right;
    ++(sample.filled.constraints.*counts[i]);
    EXPECT_COMPLAINT(sample, std::string("report: ") + names[i] + " is ");
  }
}

TEST(ConstraintFaults, TriangleKeptAgainstTheRule)
{
  for (const FillRule rule : { FillRule::Orientation, FillRule::EvenOdd })
  {
    Sample sample = withLoop({ 1, 3, 7, 5 }, rule);
    sample.filled.triples = sample.whole.triples;
    sample.filled.report = sample.whole.report;
    EXPECT_COMPLAINT(sample, "kept against the rule: triangle");
  }
}

TEST(ConstraintFaults, TriangleDroppedAgainstTheRule)
{
  Sample sample = withLoop(kDiamond);
  sample.filled.triples.resize(sample.filled.triples.size() - 3);
  --sample.filled.report.triangles;
  EXPECT_COMPLAINT(sample, "missing: triangle");
}

TEST(ConstraintFaults, TriangleThatIsNone)
{
  Sample sample = withLoop(kDiamond);
  std::rotate(sample.filled.triples.begin(), sample.filled.triples.begin() + 1,
    sample.filled.triples.begin() + 3);
  EXPECT_COMPLAINT(sample, "filled triangles: number 0");
}

TEST(ConstraintFaults, FilledTheOtherWayRound)
{
  Sample sample = withLoop(kDiamond);
  const Sample other = withLoop({ 5, 7, 3, 1 });
  sample.filled = other.filled;
  EXPECT_COMPLAINT(sample, "kept against the rule");
  EXPECT_COMPLAINT(sample, "missing: triangle");
}

TEST(ConstraintFaults, WrongNeighbour)
{
  Sample sample = withLines({ kLongWay });
  sample.whole.neighbors[1] += 1;
  EXPECT_COMPLAINT(sample, "neighbor: ");
}

TEST(ConstraintFaults, WrongConstraintEdge)
{
  Sample sample = withLines({ kLongWay });
  sample.filled.constraintEdges[0] ^= 2;
  EXPECT_COMPLAINT(sample, "constraint edges: ");
}

TEST(ConstraintFaults, WrongRegion)
{
  Sample sample = withLines({ { 0, 8 } });
  ASSERT_EQ(*std::max_element(sample.whole.regions.begin(), sample.whole.regions.end()), 1);
  for (std::int64_t& region : sample.filled.regions)
  {
    region = 1 - region; // the correct parts, but not in the order of their first triangles
  }
  EXPECT_COMPLAINT(sample, "region: 1 instead of 0: triangle 0");
}

TEST(ConstraintFaults, TooFewNumbers)
{
  Sample sample = withLines({ kLongWay });
  sample.whole.regions.pop_back();
  EXPECT_COMPLAINT(sample, "report: number of regions");
}

TEST(ConstraintFaults, WhatTheOtherCertifierFinds)
{
  Sample sample = withLines({ kLongWay });
  std::swap(sample.whole.triples[0], sample.whole.triples[1]);
  EXPECT_COMPLAINT(sample, "clockwise: triangle 0");
}

} // namespace
} // namespace test
} // namespace ahd
