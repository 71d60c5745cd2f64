// SPDX-License-Identifier: BSD-3-Clause
//
// Where segments cross: all pairs are found, against brute force in the tests' own arithmetic, and
// the points are the exact ones, rounded.
#include "Crossings/SplitFind.h"
#include "Predicates/Predicates.h"

#include "../Predicates/PredicatesSegments.h"
#include "Distributions.h"
#include "EngineRun.h"
#include "ExactSigns.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

using Pairs = std::vector<std::pair<Index, Index>>;

/// The ends two by two, without segments of no length.
RankedSegments segmentsBetween(const std::vector<Point>& ends)
{
  RankedSegments result;
  result.places = ends;
  std::sort(result.places.begin(), result.places.end(), lexicographicallyLess);
  result.places.erase(std::unique(result.places.begin(), result.places.end()), result.places.end());
  const auto rankOf = [&](const Point& p)
  {
    const auto found = std::lower_bound(
      result.places.begin(), result.places.end(), p, lexicographicallyLess);
    return static_cast<Index>(found - result.places.begin());
  };
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    const Index a = rankOf(ends[i]), b = rankOf(ends[i + 1]);
    if (a != b)
    {
      result.ends.push_back({ std::min(a, b), std::max(a, b) });
    }
  }
  return result;
}

bool crossByDefinition(const Segment& s, const Segment& t)
{
  return orientSign(s.left, s.right, t.left) * orientSign(s.left, s.right, t.right) < 0 &&
    orientSign(t.left, t.right, s.left) * orientSign(t.left, t.right, s.right) < 0;
}

Pairs crossingsByDefinition(const RankedSegments& segments)
{
  Pairs result;
  for (Index a = 0; a < segments.ends.size(); ++a)
  {
    for (Index b = a + 1; b < segments.ends.size(); ++b)
    {
      if (crossByDefinition(segments[a], segments[b]))
      {
        result.emplace_back(a, b);
      }
    }
  }
  return result;
}

Pairs crossingsFound(const RankedSegments& segments)
{
  Ticker ticker(nullptr, Phase::Split, 0);
  std::vector<Crossing> crossings;
  EXPECT_TRUE(findCrossings(segments, ticker, crossings));
  Pairs result;
  for (const Crossing& crossing : crossings)
  {
    result.emplace_back(crossing.a, crossing.b);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::string textOf(const RankedSegments& segments)
{
  std::string text;
  for (Index s = 0; s < segments.ends.size(); ++s)
  {
    text += hexText(segments[s].left) + " to " + hexText(segments[s].right) + "\n";
  }
  return text;
}

/// Returns how many cross.
std::size_t expectAllFound(const std::vector<Point>& ends)
{
  const RankedSegments segments = segmentsBetween(ends);
  const Pairs expected = crossingsByDefinition(segments);
  EXPECT_EQ(crossingsFound(segments), expected)
    << (segments.ends.size() < 30 ? textOf(segments) : "");
  return expected.size();
}

TEST(SplitFind, NoneOneAndTwoSegments)
{
  EXPECT_EQ(expectAllFound({}), 0u);
  EXPECT_EQ(expectAllFound({ { 1, 1 }, { 1, 1 } }), 0u);
  EXPECT_EQ(expectAllFound({ { 1, 1 }, { 2, 2 } }), 0u);
  EXPECT_EQ(expectAllFound({ { 0, 0 }, { 2, 2 }, { 0, 2 }, { 2, 0 } }), 1u);
  EXPECT_EQ(expectAllFound({ { 0, 0 }, { 2, 0 }, { 1, -1 }, { 1, 1 } }), 1u);
  EXPECT_EQ(expectAllFound({ { 0, 0 }, { 2, 2 }, { 1, 1 }, { 2, 0 } }), 0u) << "touches";
  EXPECT_EQ(expectAllFound({ { 0, 0 }, { 2, 2 }, { 1, 1 }, { 3, 3 } }), 0u) << "overlaps";
  EXPECT_EQ(expectAllFound({ { 0, 0 }, { 2, 2 }, { 0, 0 }, { 2, 0 } }), 0u) << "shares an end";
}

TEST(SplitFind, AllPairsOfSegmentsOnA3x3Lattice)
{
  std::vector<Point> lattice;
  for (int i = 0; i < 9; ++i)
  {
    lattice.push_back({ double(i / 3), double(i % 3) });
  }
  // All segments at once, and each three of them.
  std::vector<std::pair<Point, Point>> segments;
  std::vector<Point> all;
  for (std::size_t i = 0; i < 9; ++i)
  {
    for (std::size_t k = i + 1; k < 9; ++k)
    {
      segments.emplace_back(lattice[i], lattice[k]);
      all.insert(all.end(), { lattice[i], lattice[k] });
    }
  }
  EXPECT_GT(expectAllFound(all), 50u);
  for (std::size_t a = 0; a < segments.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      for (std::size_t c = 0; c <= b; ++c)
      {
        expectAllFound({ segments[a].first, segments[a].second, segments[b].first,
          segments[b].second, segments[c].first, segments[c].second });
      }
    }
  }
}

TEST(SplitFind, RandomSegmentsOnSmallLattices)
{
  Random random(1);
  std::size_t crossings = 0;
  for (std::size_t round = 0; round < reduced(20000); ++round)
  {
    const std::size_t width = 2 + random.below(9), height = 1 + random.below(9);
    std::vector<Point> ends(2 * (1 + random.below(40)));
    for (Point& p : ends)
    {
      p = { double(random.below(width)), double(random.below(height)) };
    }
    crossings += expectAllFound(ends);
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(crossings, reduced(20000));
}

TEST(SplitFind, RandomSegmentsOfEveryLength)
{
  Random random(2);
  for (std::size_t round = 0; round < 1000; ++round)
  {
    const double length = std::ldexp(1.0, -int(random.below(12)));
    std::vector<Point> ends;
    for (int k = 0; k < 60; ++k)
    {
      const Point p{ random.unit(), random.unit() };
      const double own = random.below(5) == 0 ? 1.0 : length;
      ends.push_back(p);
      ends.push_back({ p.x + own * (random.unit() - 0.5), p.y + own * (random.unit() - 0.5) });
    }
    expectAllFound(ends);
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
}

TEST(SplitFind, EndsOfEveryDistribution)
{
  for (const Distribution distribution : allDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    expectAllFound(makePoints(distribution, affordable(distribution, 400), 5));
    std::vector<Point> chain; // of a kind that shares ends
    for (const Point& p : makePoints(distribution, affordable(distribution, 200), 6))
    {
      chain.insert(chain.end(), { p, p });
    }
    chain.erase(chain.begin());
    expectAllFound(chain);
  }
}

/// A point of the segment's line: exactly, by rational arithmetic.
std::pair<mpq_class, mpq_class> exactCrossing(const Segment& s, const Segment& t)
{
  const mpq_class ax(s.left.x), ay(s.left.y), cx(t.left.x), cy(t.left.y);
  const mpq_class ux = mpq_class(s.right.x) - ax, uy = mpq_class(s.right.y) - ay;
  const mpq_class vx = mpq_class(t.right.x) - cx, vy = mpq_class(t.right.y) - cy;
  const mpq_class along = ((cx - ax) * vy - (cy - ay) * vx) / (ux * vy - uy * vx);
  return { ax + along * ux, ay + along * uy };
}

/// Returns how many cross.
std::size_t expectRounded(const std::vector<Point>& ends)
{
  const RankedSegments segments = segmentsBetween(ends);
  const Pairs pairs = crossingsByDefinition(segments);
  for (const auto& [a, b] : pairs)
  {
    const Point p = crossingOf(segments[a], segments[b]);
    const auto [x, y] = exactCrossing(segments[a], segments[b]);
    bool isTie = false; // of no interest
    EXPECT_TRUE(isNearest(p.x, x, isTie) && isNearest(p.y, y, isTie)) << hexText(p) << " of\n"
                                                                      << textOf(segments);
    EXPECT_FALSE((p.x == 0.0 && std::signbit(p.x)) || (p.y == 0.0 && std::signbit(p.y)));
    const Point q = crossingOf(segments[b], segments[a]);
    EXPECT_EQ(hexText(p), hexText(q));
  }
  return pairs.size();
}

TEST(SplitFind, CrossingIsTheExactOneRounded)
{
  Random random(3);
  std::size_t crossings = 0;
  for (const Distribution distribution : allDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    for (std::uint64_t seed = 0; seed < 3; ++seed)
    {
      crossings += expectRounded(makePoints(distribution, 40, seed));
    }
  }
  EXPECT_GT(crossings, 500u);
}

TEST(SplitFind, CrossingOfSegmentsThatAreNearlyParallel)
{
  Random random(4);
  std::size_t crossings = 0;
  for (std::size_t round = 0; round < reduced(3000); ++round)
  {
    const double tiny = std::ldexp(1.0, -int(20 + random.below(40)));
    const Point a{ random.unit(), random.unit() }, b{ 1 + random.unit(), random.unit() };
    crossings += expectRounded({ a, b, { a.x, a.y + tiny }, { b.x, b.y - tiny * random.unit() } });
  }
  EXPECT_GT(crossings, reduced(3000) / 10);
}

/// Both segments round to their rounded crossing, even where it is many roundings away from them,
/// in a corner of the set that rounds there.
TEST(SplitFind, SegmentsRoundToTheirCrossings)
{
  Random random(7);
  std::size_t crossings = 0;
  for (std::size_t round = 0; round < reduced(20000); ++round)
  {
    const Segment s{ { random.unit(), random.unit() }, { 1 + random.unit(), random.unit() } };
    const Segment t{ { random.unit(), random.unit() }, { 1 + random.unit(), random.unit() } };
    if (orient2d(s.left, s.right, t.left) * orient2d(s.left, s.right, t.right) < 0 &&
      orient2d(t.left, t.right, s.left) * orient2d(t.left, t.right, s.right) < 0)
    {
      ++crossings;
      const Point p = crossingOf(s, t);
      EXPECT_TRUE(roundsTo(s, p) && roundsTo(t, p)) << hexText(p) << " in round " << round;
    }
  }
  EXPECT_GT(crossings, reduced(20000) / 10);
}

/// Powers of two: the long integers have words without a bit, and words with all of them, through
/// which carries and borrows run on.
TEST(SplitFind, CrossingOfNumbersWithOneBit)
{
  Random random(6);
  std::size_t crossings = 0;
  const auto power = [&](double sign) { return std::ldexp(sign, int(random.below(400)) - 200); };
  for (std::size_t round = 0; round < 2000; ++round)
  {
    const Point a{ power(-1.0), power(-1.0) }, b{ power(1.0), power(1.0) };
    const Point c{ power(-1.0), power(1.0) }, d{ power(1.0), power(-1.0) };
    crossings += expectRounded({ a, b, c, d });
  }
  EXPECT_GT(crossings, 500u);
}

TEST(SplitFind, CrossingAmongSubnormalNumbers)
{
  Random random(5);
  std::size_t crossings = 0;
  for (std::size_t round = 0; round < 2000; ++round)
  {
    std::vector<Point> ends(4);
    for (Point& p : ends)
    {
      p = { 5e-324 * (double(random.below(41)) - 20), 5e-324 * (double(random.below(41)) - 20) };
    }
    crossings += expectRounded(ends);
  }
  EXPECT_GT(crossings, 300u);
}

} // namespace
} // namespace test
} // namespace ahd
