// SPDX-License-Identifier: BSD-3-Clause
//
// Loops without an inside, through two vertices only: their edges are constraints, and they
// bound nothing.
#include "ConstrainedRun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

/// A square with a point in it, and its first corner once more.
const std::vector<Point> kPoints = { { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 }, { 5, 3 }, { 0, 0 } };

ConstraintCase caseOf(const std::vector<Chain>& loops, const std::vector<Chain>& lines = {})
{
  ConstraintCase given;
  given.points = kPoints;
  for (const Chain& line : lines)
  {
    given.constraints.addLine(line);
  }
  for (const Chain& loop : loops)
  {
    given.constraints.addLoop(loop);
  }
  return given;
}

TEST(ConstrainTwoPoints, ALoopOfTwoVerticesBoundsNothing)
{
  const std::vector<Chain> loops = { { 0, 2 }, { 0, 2, 0 }, { 0, 2, 5 }, { 5, 2, 2, 0 },
    { 0, 2, 0, 2 }, { 0, 4, 0, 4, 5 } };
  for (const Chain& loop : loops)
  {
    for (const FillRule rule : kFillRules)
    {
      SCOPED_TRACE(nameOf(rule) + std::to_string(loop[1]) + std::to_string(loop.size()));
      const ConstraintCase given = caseOf({ loop });
      const ConstrainedOutcome found = constrain(given, rule);
      EXPECT_EQ(found.triples.size(), 3u * 4u) << "all of the square";
      EXPECT_EQ(found.constraints.edges, 1u);
      EXPECT_EQ(found.constraints.unfilledLoops, 0u);
      EXPECT_EQ(faultsOfConstraining(given, rule), "");
    }
  }
}

TEST(ConstrainTwoPoints, BesideAnotherLoopItChangesNothing)
{
  for (const FillRule rule : kFillRules)
  {
    const ConstraintCase both = caseOf({ { 0, 1, 2 }, { 0, 3 } });
    EXPECT_EQ(constrain(both, rule).triples, constrain(caseOf({ { 0, 1, 2 } }), rule).triples);
    EXPECT_EQ(faultsOfConstraining(both, rule), "");
  }
}

TEST(ConstrainTwoPoints, WithASegmentLeftOutItIsNoUnfilledLoop)
{
  const ConstraintCase given = caseOf({ { 0, 2 }, { 0, 1, -1 } }, { { 1, 3 } });
  const ConstrainedOutcome found = constrain(given, FillRule::EvenOdd);
  EXPECT_EQ(found.constraints.crossing, 2u);
  EXPECT_EQ(found.constraints.withoutVertex, 2u);
  EXPECT_EQ(found.constraints.unfilledLoops, 1u) << "the one with a point that is none";
  EXPECT_EQ(faultsOfConstraining(given, FillRule::EvenOdd), "");
}

} // namespace
} // namespace test
} // namespace ahd
