// SPDX-License-Identifier: BSD-3-Clause
//
// Loops along the same edges: one loop in even-odd, whatever their direction and beginning; each
// counts in orientation.
#include "ConstrainedRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

/// A square in a square; the first corner of the inner one once more, and the middle of its lower
/// side.
const std::vector<Point> kPoints = { { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 }, { 3, 3 }, { 6, 3 },
  { 6, 6 }, { 3, 6 }, { 3, 3 }, { 4.5, 3 } };
const Chain kOuter = { 0, 1, 2, 3 }, kInner = { 4, 5, 6, 7 };

ConstraintCase caseOf(const std::vector<Chain>& loops)
{
  ConstraintCase given;
  given.points = kPoints;
  for (const Chain& loop : loops)
  {
    given.constraints.addLoop(loop);
  }
  return given;
}

TEST(ConstrainSameLoops, AreOneInEvenOdd)
{
  const auto expected = constrain(caseOf({ kOuter, kInner }), FillRule::EvenOdd).triples;
  const std::vector<Chain> same = { kInner, { 6, 7, 4, 5 }, { 5, 4, 7, 6 }, { 8, 5, 6, 7 },
    { 8, 5, 6, 7, 4 }, { 4, 9, 5, 6, 7 }, { 7, 7, 6, 5, 9, 8, 4, 7 } };
  for (const Chain& again : same)
  {
    for (const std::vector<Chain>& loops :
      { std::vector<Chain>{ kOuter, kInner, again }, { again, kOuter, kInner },
        { again, again, kOuter, again, kInner }, { kOuter, kInner, again, { 2, 1, 0, 3 } } })
    {
      const ConstraintCase given = caseOf(loops);
      EXPECT_EQ(constrain(given, FillRule::EvenOdd).triples, expected);
      EXPECT_EQ(faultsOfConstraining(given, FillRule::EvenOdd), "");
    }
  }
}

TEST(ConstrainSameLoops, OthersWithSomeOfTheEdgesCount)
{
  // twice around is not once around; three sides are not four
  for (const Chain& other :
    { Chain{ 4, 5, 6, 7, 4, 5, 6, 7 }, Chain{ 4, 5, 6 }, Chain{ 0, 5, 6, 7 } })
  {
    const ConstraintCase given = caseOf({ kOuter, kInner, other });
    EXPECT_EQ(faultsOfConstraining(given, FillRule::EvenOdd), "");
  }
  const auto twice = constrain(caseOf({ kOuter, kInner, kInner, { 4, 5, 6 } }), FillRule::EvenOdd);
  const auto once = constrain(caseOf({ kOuter, { 4, 6, 7 } }), FillRule::EvenOdd);
  EXPECT_EQ(twice.report.triangles, once.report.triangles);
}

TEST(ConstrainSameLoops, EachCountsInOrientation)
{
  const Chain clockwise(kInner.rbegin(), kInner.rend());
  const auto holed = constrain(caseOf({ kOuter, clockwise }), FillRule::Orientation);
  EXPECT_EQ(constrain(caseOf({ kOuter, clockwise, clockwise }), FillRule::Orientation).triples,
    holed.triples);
  const auto both = constrain(caseOf({ kOuter, clockwise, kInner }), FillRule::Orientation);
  EXPECT_EQ(
    both.report.triangles, constrain(caseOf({ kOuter }), FillRule::Orientation).report.triangles)
    << "those of both directions bound nothing";
}

TEST(ConstrainSameLoops, ALoopThatIsNotWholeStandsForNoOther)
{
  const ConstraintCase given = caseOf({ kOuter, { 4, 5, 6, 7, 99 }, kInner });
  EXPECT_EQ(constrain(given, FillRule::EvenOdd).triples,
    constrain(caseOf({ kOuter, kInner }), FillRule::EvenOdd).triples);
  EXPECT_EQ(faultsOfConstraining(given, FillRule::EvenOdd), "");
}

TEST(ConstrainSameLoops, OfManyEachCountsOnce)
{
  // 600 rings around each other, each three times
  ConstraintCase given;
  std::vector<Chain> once;
  for (int k = 600; k > 0; --k)
  {
    const std::int64_t first = std::int64_t(given.points.size());
    for (const Point& corner : { Point{ -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } })
    {
      given.points.push_back({ k * corner.x, k * corner.y });
    }
    once.push_back({ first, first + 1, first + 2, first + 3 });
  }
  ConstraintCase thrice = given;
  for (const Chain& ring : once)
  {
    given.constraints.addLoop(ring);
  }
  for (std::size_t turn = 0; turn < 3; ++turn)
  {
    for (Chain ring : once)
    {
      std::rotate(ring.begin(), ring.begin() + std::ptrdiff_t(turn), ring.end());
      turn == 1 ? std::reverse(ring.begin(), ring.end()) : void();
      thrice.constraints.addLoop(ring);
    }
  }
  const ConstrainedOutcome found = constrain(thrice, FillRule::EvenOdd);
  EXPECT_EQ(found.triples, constrain(given, FillRule::EvenOdd).triples);
  EXPECT_EQ(found.report.triangles, 8u * 300) << "every other ring between two";
}

} // namespace
} // namespace test
} // namespace ahd
