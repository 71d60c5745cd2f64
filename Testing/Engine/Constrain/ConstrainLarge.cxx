// SPDX-License-Identifier: BSD-3-Clause
//
// Constraints in large sets, in shapes that are hard for a reason: certified
// (ConstraintCertifier.h).
#include "ConstrainedRun.h"

#include <gtest/gtest.h>

#include <functional>

namespace ahd
{
namespace test
{
namespace
{

struct Shape
{
  const char* name;
  std::function<ConstraintCase()> make;
  std::size_t leastEdges; ///< of constraints; fewer would mean another shape
};

void PrintTo(const Shape& shape, std::ostream* out)
{
  *out << shape.name;
}

class ConstrainLarge : public testing::TestWithParam<Shape>
{
};

TEST_P(ConstrainLarge, IsCertified)
{
  const ConstraintCase given = GetParam().make();
  for (const FillRule rule : kFillRules)
  {
    if (rule != FillRule::Orientation && given.constraints.lines() == given.constraints.chains())
    {
      continue; // nothing to fill
    }
    EXPECT_EQ(faultsOfConstraining(given, rule), "") << nameOf(rule);
  }
  EXPECT_GE(constrain(given, FillRule::Orientation).constraints.edges, GetParam().leastEdges);
}

const Shape kShapes[] = {
  { "Star", [] { return starPolygon(reduced(10000)); }, reduced(20000) },
  { "ShortSegments", [] { return shortSegments(reduced(300000), reduced(100000)); },
    reduced(100000) },
  { "EdgesOfOthers", [] { return edgesOfOthers(reduced(200000), reduced(100000)); },
    reduced(100000) },
  { "RandomSegments", [] { return randomSegments(reduced(20000), reduced(4000)); }, 50 },
  { "Across", [] { return segmentAcross(reduced(300000)); }, 1 },
  { "AcrossParabolas", [] { return segmentAcrossParabolas(reduced(100000)); }, 1 },
  { "AcrossBulges", [] { return segmentAcrossBulges(reduced(100000)); }, 1 },
  { "AcrossCombs", [] { return segmentAcrossCombs(reduced(100000)); }, 1 },
  { "Spiral", [] { return spiralLine(reduced(20000), 10); }, reduced(20000) - 1 },
  { "NearlyCollinear", [] { return nearlyCollinearLines(reduced(20000)); }, 100 },
  { "Lattice", [] { return latticeSegments(100, 20000); }, 1000 },
  { "Nested", [] { return nestedLoops(30); }, 3000 },
  { "Tiny", [] { return chainsThrough(Distribution::Tiny, 2000, 150, 1); }, 10 },
  { "Huge", [] { return chainsThrough(Distribution::Huge, 2000, 150, 2); }, 10 },
  { "TinyAndHuge", [] { return chainsThrough(Distribution::TinyAndHuge, 120, 30, 3); }, 2 },
  { "AnyFinite", [] { return chainsThrough(Distribution::AnyFinite, 120, 30, 4); }, 2 },
  { "IntegerCircle", [] { return chainsThrough(Distribution::OnIntegerCircle, 400, 300, 5); }, 50 },
  { "RepeatedDraws", [] { return chainsThrough(Distribution::RepeatedDraws, 3000, 400, 6); }, 50 },
  { "Slivers", [] { return chainsThrough(Distribution::Slivers, 2000, 400, 7); }, 10 },
};

INSTANTIATE_TEST_SUITE_P(Of, ConstrainLarge, testing::ValuesIn(kShapes),
  [](const testing::TestParamInfo<Shape>& shape) { return std::string(shape.param.name); });

TEST(ConstrainLarge, EveryDistribution)
{
  for (const Distribution distribution : allDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    const ConstraintCase given = chainsThrough(distribution, affordable(distribution, 1500), 60, 8);
    EXPECT_EQ(faultsOfConstraining(given, FillRule::EvenOdd), "");
  }
}

TEST(ConstrainLarge, EdgesThatAreThereChangeNothing)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, reduced(50000), 9);
  Engine engine;
  const Outcome plain = triangulate(engine, viewOf(points));
  ConstraintCase given;
  given.points = points;
  for (std::size_t h = 0; h < plain.triples.size(); ++h)
  {
    given.constraints.addLine({ plain.triples[h], plain.triples[h % 3 == 2 ? h - 2 : h + 1] });
  }
  const ConstrainedOutcome all = constrain(given, FillRule::Orientation);
  EXPECT_EQ(all.triples, plain.triples);
  EXPECT_EQ(all.constraints.segments, plain.triples.size());
  EXPECT_EQ(all.constraints.edges, plain.report.inserted + plain.report.triangles - 1); // Euler
  EXPECT_EQ(all.regions.back(), std::int64_t(plain.report.triangles) - 1);
}

TEST(ConstrainLarge, ConstrainingAgainByWhatWasMadeChangesNothing)
{
  const ConstraintCase given = randomSegments(reduced(5000), reduced(1000));
  const ConstrainedOutcome first = constrain(given, FillRule::Orientation);
  ConstraintCase again;
  again.points = given.points;
  for (std::size_t h = first.triples.size(); h-- > 0;) // in another order than before
  {
    if ((first.constraintEdges[h / 3] >> h % 3 & 1) != 0)
    {
      again.constraints.addLine({ first.triples[h], first.triples[h % 3 == 2 ? h - 2 : h + 1] });
    }
  }
  const ConstrainedOutcome second = constrain(again, FillRule::Orientation);
  EXPECT_EQ(second.triples, first.triples);
  EXPECT_EQ(second.constraintEdges, first.constraintEdges);
  EXPECT_EQ(second.regions, first.regions);
  EXPECT_EQ(second.constraints.crossing, 0u);
}

TEST(ConstrainLarge, ASegmentThatLeavesACrowdNamesTheFirstItCrosses)
{
  // Two walls between a vertex of many neighbours and one of few: on the way from either end, the
  // nearer one is the first.
  ConstraintCase given;
  given.points = { { 0, 0 }, { 10, 0 }, { 3, -1 }, { 3, 1 }, { 6, -1 }, { 6, 1 } };
  for (int i = 0; i < 400; ++i)
  {
    const double t = (2 * i - 39) /
      40.0; // a circle by its rational parametrisation, and its mirror
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    given.points.push_back({ sign * (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t) });
  }
  given.constraints.addLine({ 2, 3 });
  given.constraints.addLine({ 4, 5 });
  given.constraints.addLine({ 0, 1 });
  given.constraints.addLine({ 1, 0 });
  const std::vector<LeftOut> leftOut = constrain(given, FillRule::Orientation).constraints.leftOut;
  ASSERT_EQ(leftOut.size(), 2u);
  EXPECT_EQ(leftOut[0].otherChain, 0u);
  EXPECT_EQ(leftOut[1].otherChain, 1u);
  EXPECT_EQ(faultsOfConstraining(given, FillRule::Orientation), "");
}

TEST(ConstrainLarge, NoConstraintsChangeNothing)
{
  ConstraintCase given;
  given.points = makePoints(Distribution::Mixed, 5000, 10);
  const ConstrainedOutcome found = constrain(given, FillRule::EvenOdd);
  EXPECT_EQ(found.triples, triangulate(given.points).triples);
  EXPECT_EQ(faultsOfConstraining(given, FillRule::EvenOdd), "");
}

} // namespace
} // namespace test
} // namespace ahd
