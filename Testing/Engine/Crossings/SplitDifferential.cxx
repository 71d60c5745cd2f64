// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting against the simple algorithm (SplitOracle.h), which searches all pieces by strips in
// each round and lists every pair: the same, number by number. And results that the simple
// algorithm does not have.
#include "SplitDrawings.h"
#include "SplitOracle.h"

#include <algorithm>

namespace ahd
{
namespace test
{
namespace
{

bool areSame(const CrossingPoint& p, const CrossingPoint& q)
{
  return p.at == q.at && p.chainA == q.chainA && p.segmentA == q.segmentA && p.alongA == q.alongA &&
    p.chainB == q.chainB && p.segmentB == q.segmentB && p.alongB == q.alongB;
}

/// Returns the result.
SplitConstraints expectSame(const Drawing& drawing)
{
  const Chains chains(drawing);
  SplitConstraints expected;
  EXPECT_EQ(splitBySearchingAll(drawing.view(), chains.view(), expected), Status::Ok);
  const SplitConstraints split = splitOf(drawing);
  EXPECT_EQ(split.rounds, expected.rounds);
  EXPECT_EQ(split.crossings, expected.crossings);
  EXPECT_EQ(split.unresolved, expected.unresolved);
  EXPECT_EQ(split.lines, expected.lines);
  EXPECT_EQ(split.offsets, expected.offsets);
  EXPECT_TRUE(split.ids == expected.ids && split.segments == expected.segments);
  EXPECT_TRUE(std::equal(split.points.begin(), split.points.end(), expected.points.begin(),
    expected.points.end(), areSame));
  return split;
}

/// A place of one of many kinds.
Point placeOf(std::size_t kind, Random& random)
{
  const double x = random.unit(), y = random.unit();
  const auto below = [&](std::size_t n) { return double(random.below(n)); };
  switch (kind)
  {
    case 0:
      return { below(9), below(9) };
    case 1:
      return { x, x / 3 + 1e-16 * below(5) };
    case 2:
      return { 1 + 1e-15 * below(9), 1 + 1e-15 * below(9) };
    case 3:
      return { 5e-324 * below(30), 5e-324 * below(30) };
    case 4:
      return { 0.1 * (below(41) - 20), 0.1 * (below(41) - 20) };
    case 5:
      return { random.below(2) == 0 ? x : 1e9 * x, random.below(2) == 0 ? y : 1e-9 * y };
    case 6:
      return { 1e6 + 0.001 * below(20), 5e6 + 0.001 * below(20) };
    case 7:
      return { (random.below(2) == 0 ? -1.0 : 1.0) * below(3), 0.001 * below(1000) };
    default:
      return { x, y };
  }
}

Drawing randomDrawing(std::size_t kind, std::size_t points, Random& random)
{
  Drawing drawing;
  for (std::size_t k = 0; k != points; ++k)
  {
    drawing.points.push_back(placeOf(kind, random));
  }
  for (std::size_t chain = 1 + random.below(points); chain != 0; --chain)
  {
    Ids ids;
    for (std::size_t i = random.below(4) == 0 ? random.below(7) : 2; i != 0; --i)
    {
      ids.push_back(std::int64_t(random.below(points + 2)) - 1);
    }
    (random.below(3) != 0 ? drawing.lines : drawing.loops).push_back(ids);
  }
  drawing.skip.assign(points, 0);
  drawing.skip[random.below(points)] = 1;
  return drawing;
}

TEST(SplitDifferential, RandomChainsOfEveryKind)
{
  Random random(1);
  int most = 0;
  for (std::size_t round = 0; round < reduced(500); ++round)
  {
    const std::size_t size = round % 50 == 0 ? 200 : 50;
    most = std::max(
      most, expectSame(randomDrawing(round % 9, 2 + random.below(size), random)).rounds);
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(most, 2);
}

TEST(SplitDifferential, SegmentsOfEveryLength)
{
  Random random(2);
  for (const double length : { 1.0, 0.1, 0.01, 0.001 })
  {
    Drawing drawing;
    for (std::size_t k = 0; k != reduced(1000); ++k)
    {
      const double own = random.below(100) == 0 ? 1.0 : length;
      const Point p{ random.unit(), random.unit() };
      drawing.addSegment(
        p, { p.x + own * (random.unit() - 0.5), p.y + own * (random.unit() - 0.5) });
    }
    expectSame(drawing);
  }
}

/// Boxes separate nothing.
TEST(SplitDifferential, LongSegmentsSideBySide)
{
  Random random(3);
  Drawing drawing;
  for (int k = 0; k != 3000; ++k)
  {
    const double y = 1e-4 * k;
    drawing.addSegment({ 0, y }, { 1, 1 + y + (k % 100 == 0 ? 2e-3 * random.unit() : 0.0) });
  }
  EXPECT_GT(expectSame(drawing).crossings, 50u);
}

/// Diameters of a star: all cross in one place, two by two.
Drawing starOf(int diameters, bool withVertex)
{
  Drawing drawing;
  if (withVertex)
  {
    drawing.points.push_back({ 0, 0 });
  }
  for (int i = 1; i <= diameters; ++i)
  {
    drawing.addSegment(
      { double(i), double(diameters + 1 - i) }, { -double(i), -double(diameters + 1 - i) });
  }
  return drawing;
}

TEST(SplitDifferential, HubsWithAndWithoutVertex)
{
  for (const bool withVertex : { true, false })
  {
    const SplitConstraints split = expectSame(starOf(300, withVertex));
    EXPECT_EQ(split.crossings, 300u * 299 / 2);
    EXPECT_EQ(split.points.size(), withVertex ? 0u : 1u);
  }
}

TEST(SplitDifferential, HubsAmongOtherSegments)
{
  Random random(4);
  for (int round = 0; round != 12; ++round)
  {
    Drawing drawing = starOf(200 + int(random.below(100)), round % 2 == 0);
    const auto coordinate = [&](std::size_t n) { return double(random.below(2 * n)) - double(n); };
    for (int k = 0; k != 40; ++k) // collinear ones
    {
      const double x = 1 + double(random.below(50)), y = double(random.below(50));
      const double f = 1 + double(random.below(3));
      drawing.addSegment({ -f * x, -f * y }, { x, y });
    }
    for (int k = 0; k != 150; ++k) // others, and in half of the rounds another hub
    {
      const Point p{ coordinate(90), coordinate(90) }, q{ coordinate(200), coordinate(200) };
      round % 4 < 2 ? drawing.addSegment(p, q)
                    : drawing.addSegment({ 100 - p.x, 90 - p.y }, { 100 + p.x, 90 + p.y });
    }
    for (Point& p : drawing.points) // where it is no lattice, and where nothing is left to round to
    {
      const double scale = round == 5 ? 1 / 3.0 : round == 7 ? 1e300 : round == 8 ? 1e-320 : 1.0;
      p = { p.x * scale, p.y * scale };
    }
    for (std::size_t k = drawing.lines.size(); k > 1; --k)
    {
      std::swap(drawing.lines[k - 1], drawing.lines[random.below(k)]);
    }
    expectSame(drawing);
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
}

TEST(SplitDifferential, ManyDiametersAreDoneAtOnce)
{
  const int m = 30000; // 450 million pairs
  const SplitConstraints split = splitOf(starOf(m, true));
  EXPECT_EQ(split.crossings, std::size_t(m) * (m - 1) / 2);
  EXPECT_EQ(split.ids.size(), 3u * m);
}

TEST(SplitDifferential, WhatBendsIsNamed)
{
  // The second segment passes above (1, 1/3), which is rounded down; others pass exactly through
  // (1, 1), or cross where a point is added.
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 3, 1 }, { 1, 1 / 3.0 }, { 1, -1 }, { 1, 2 }, { 0, 2 }, { 2, 0 },
    { 2, 2 }, { 1, 1 } };
  drawing.lines = { { 3, 2 }, { 6, 0, 1 }, { 2, 4 }, { 5, 6 }, { 0, 7 } };
  const SplitConstraints split = splitOf(drawing);
  ASSERT_EQ(split.bent.size(), 1u);
  EXPECT_EQ(split.bent[0].chain, 1u);
  EXPECT_EQ(split.bent[0].segment, 1u);
}

/// The crossing pairs by places, with the fractions; sorted.
std::vector<std::array<double, 12>> sidesOf(const Drawing& drawing, const SplitConstraints& split)
{
  std::vector<std::array<double, 12>> result;
  for (const CrossingPoint& p : split.points)
  {
    std::array<double, 12> row{ { p.at.x, p.at.y } };
    std::size_t k = 2;
    for (const CrossingPoint::Side& side : { p.lower, p.upper })
    {
      Point a = drawing.points[std::size_t(drawing.lines[side.chain][side.segment])];
      Point b = drawing.points[std::size_t(drawing.lines[side.chain][side.segment + 1])];
      if (lexicographicallyLess(b, a))
      {
        std::swap(a, b);
      }
      for (const double value : { a.x, a.y, b.x, b.y, side.along })
      {
        row[k++] = value;
      }
    }
    result.push_back(row);
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(SplitDifferential, SidesDoNotDependOnOrderAndDirection)
{
  Random random(5);
  std::size_t points = 0;
  for (int round = 0; round != 200; ++round)
  {
    Drawing drawing = round % 20 == 0 ? starOf(300, false) : Drawing();
    for (int k = 0; k != 40; ++k)
    {
      drawing.addSegment(
        placeOf(std::size_t(round % 9), random), placeOf(std::size_t(round % 9), random));
    }
    const auto expected = sidesOf(drawing, splitOf(drawing));
    for (std::size_t k = drawing.lines.size(); k > 1; --k)
    {
      std::swap(drawing.lines[k - 1], drawing.lines[random.below(k)]);
      if (random.below(2) == 0)
      {
        std::swap(drawing.lines[k - 1][0], drawing.lines[k - 1][1]);
      }
    }
    EXPECT_EQ(sidesOf(drawing, splitOf(drawing)), expected) << "round " << round;
    points += expected.size();
  }
  EXPECT_GT(points, 2000u);
}

} // namespace
} // namespace test
} // namespace ahd
