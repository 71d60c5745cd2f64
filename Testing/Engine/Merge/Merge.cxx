// SPDX-License-Identifier: BSD-3-Clause
//
// Merging of points that are near each other, against its definition by brute force.
#include "Merge/Merge.h"

#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct ByPlace
{
  bool operator()(const Point& a, const Point& b) const { return lexicographicallyLess(a, b); }
};

using Ids = std::vector<std::int64_t>;

/// The contract of Merge.h, taken literally: for each point the id of the one it is merged into, or
/// -1. Cost: n^2.
Ids mergedByDefinition(const PointView& points, double distance)
{
  const double s = distance == kInfinity ? 1.0
                                         : std::ldexp(1.0, std::min(1023, -std::ilogb(distance)));
  std::map<Point, Ids, ByPlace> places;
  for (std::size_t i = 0; i < points.count; ++i)
  {
    if (!points.skipped(i) && isFinite(points[i]))
    {
      places[points[i]].push_back(std::int64_t(i));
    }
  }
  Ids into(points.count, -1);
  std::vector<std::pair<Point, std::int64_t>> kept;
  for (const auto& [place, ids] : places)
  {
    double nearest = kInfinity;
    std::int64_t id = -1;
    for (const auto& [other, otherId] : kept)
    {
      const double dx = (place.x - other.x) * s, dy = (place.y - other.y) * s;
      const double squared = dx * dx + dy * dy;
      if (squared <= (distance * s) * (distance * s) && (id < 0 || squared < nearest))
      {
        nearest = squared;
        id = otherId;
      }
    }
    if (id < 0)
    {
      kept.emplace_back(place, ids.front());
    }
    for (const std::int64_t merged : ids)
    {
      into[std::size_t(merged)] = id;
    }
  }
  return into;
}

Ids mergedIdsOf(const MergedPoints& merged, std::size_t count)
{
  Ids into(count, -1);
  for (const MergedPoint& pair : merged.pairs)
  {
    into.at(pair.id) = pair.keptId;
  }
  return into;
}

/// Runs it and compares the result with the definition.
void expectAsDefined(const PointView& points, double distance)
{
  MergedPoints merged;
  ASSERT_EQ(mergeWithin(points, distance, nullptr, merged), Status::Ok);
  const Ids expected = mergedByDefinition(points, distance);
  EXPECT_EQ(mergedIdsOf(merged, points.count), expected) << "distance " << distance;
  EXPECT_TRUE(std::is_sorted(merged.pairs.begin(), merged.pairs.end(),
    [](const MergedPoint& a, const MergedPoint& b) { return a.id < b.id; }));
  ASSERT_EQ(merged.skip.size(), points.count);
  for (std::size_t i = 0; i < points.count; ++i)
  {
    EXPECT_EQ(merged.skip[i], points.skipped(i) || expected[i] >= 0 ? 1 : 0) << "point " << i;
  }
}

TEST(Merge, AsDefinedOnSmallLattices)
{
  Random random(1);
  std::size_t merges = 0;
  for (int round = 0; round < 4000; ++round)
  {
    const std::size_t n = 1 + random.below(40);
    const std::uint64_t width = 1 + random.below(12);
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i)
    {
      points.push_back({ double(random.below(width)) - 3.0, double(random.below(width)) });
    }
    const double distances[] = { 0.5, 1.0, std::sqrt(2.0), 2.0, 2.3, 3.0, 5.0, 100.0 };
    const double distance = distances[random.below(8)];
    expectAsDefined(viewOf(points), distance);
    MergedPoints merged;
    ASSERT_EQ(mergeWithin(viewOf(points), distance, nullptr, merged), Status::Ok);
    merges += merged.pairs.size();
  }
  EXPECT_GT(merges, 10000u) << "the sets no longer do what they are made for";
}

TEST(Merge, AsDefinedOnEveryDistribution)
{
  for (const Distribution distribution : allDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    const std::vector<Point> points = makePoints(distribution, reduced(600), 3);
    for (const double distance : { 1e-323, 1e-320, 1e-300, 1e-12, 1e-3, 0.01, 0.1, 1.0, 30.0, 1e3,
           1e290, 1e300, 1e308, std::numeric_limits<double>::max(), kInfinity })
    {
      expectAsDefined(viewOf(points), distance);
    }
  }
}

TEST(Merge, AsDefinedWithSkippedAndNonFinitePoints)
{
  Random random(2);
  for (int round = 0; round < 1000; ++round)
  {
    const double numbers[] = { 0.0, -0.0, 1.0, 1.5, -1.0, kNaN, kInfinity, -kInfinity };
    std::vector<Point> points;
    std::vector<unsigned char> flags;
    for (std::size_t i = 0; i < 20; ++i)
    {
      points.push_back({ numbers[random.below(8)], numbers[random.below(8)] });
      flags.push_back(static_cast<unsigned char>(random.below(3)));
    }
    PointView view = viewOf(points);
    view.skip = flags.data();
    view.skipMask = 2;
    expectAsDefined(view, 1.0);
    MergedPoints merged;
    ASSERT_EQ(mergeWithin(view, 1.0, nullptr, merged), Status::Ok);
    const Outcome outcome = triangulate(merged.without(view));
    EXPECT_EQ(faultsOf(merged.without(view), outcome), "");
  }
}

TEST(Merge, OrderOfTheInputHasNoSay)
{
  Random random(3);
  for (int round = 0; round < 200; ++round)
  {
    std::vector<Point> points = makePoints(Distribution::Utm, 300, std::uint64_t(round));
    std::map<Point, Point, ByPlace> expected;
    for (int shuffle = 0; shuffle < 3; ++shuffle)
    {
      MergedPoints merged;
      ASSERT_EQ(mergeWithin(viewOf(points), 60.0, nullptr, merged), Status::Ok);
      std::map<Point, Point, ByPlace> into;
      for (const MergedPoint& pair : merged.pairs)
      {
        into[points[pair.id]] = points[pair.keptId];
      }
      EXPECT_GT(into.size(), 10u);
      EXPECT_TRUE(shuffle == 0 || into == expected);
      expected = into;
      for (std::size_t i = points.size(); i > 1; --i)
      {
        std::swap(points[i - 1], points[random.below(i)]);
      }
    }
  }
}

TEST(Merge, KeptIsTheNearestThenTheSmallestPlaceThenTheSmallestId)
{
  const std::vector<Point> points = { { 1, 0 }, { 0, 0 }, { 2, 0 }, { 0, -0.0 }, { 1.25, 0 },
    { 1, 0 } };
  MergedPoints merged;
  // (0, 0) and (2, 0) are farther than 1.5 from each other; (1, 0) is as near to both, but at its
  // turn only (0, 0) is kept.
  ASSERT_EQ(mergeWithin(viewOf(points), 1.5, nullptr, merged), Status::Ok);
  EXPECT_EQ(mergedIdsOf(merged, points.size()), (Ids{ 1, -1, -1, -1, 1, 1 }));
  // Here both are kept before: (2, -1) and (2, 1) lie between those of x = 1 and x = 3.
  const std::vector<Point> tie = { { 1, 1 }, { 1, -1 }, { 2, 0 }, { 2, 0.5 }, { 2, -0.5 } };
  ASSERT_EQ(mergeWithin(viewOf(tie), 1.75, nullptr, merged), Status::Ok);
  EXPECT_EQ(mergedIdsOf(merged, tie.size()), (Ids{ -1, -1, 1, 0, 1 }));
}

TEST(Merge, NothingIsMergedWithoutADistance)
{
  const std::vector<Point> points = makePoints(Distribution::RepeatedDraws, 5000, 1);
  for (const double distance : { 0.0, -0.0, -1.0, -kInfinity, kNaN })
  {
    MergedPoints merged;
    ASSERT_EQ(mergeWithin(viewOf(points), distance, nullptr, merged), Status::Ok);
    EXPECT_TRUE(merged.pairs.empty());
    EXPECT_EQ(merged.skip, std::vector<unsigned char>(points.size(), 0));
  }
}

TEST(Merge, AllIsMergedByAnInfiniteDistance)
{
  const std::vector<Point> points = { { 1.7e308, 0 }, { -1.7e308, 1.7e308 }, { 0, 5e-324 },
    { -1.7e308, -1.7e308 } };
  MergedPoints merged;
  ASSERT_EQ(mergeWithin(viewOf(points), kInfinity, nullptr, merged), Status::Ok);
  EXPECT_EQ(mergedIdsOf(merged, points.size()), (Ids{ 3, 3, 3, -1 }));
  // The largest double is not infinity: (0, 5e-324) is near the second, the first is not.
  ASSERT_EQ(
    mergeWithin(viewOf(points), std::numeric_limits<double>::max(), nullptr, merged), Status::Ok);
  EXPECT_EQ(mergedIdsOf(merged, points.size()), (Ids{ 2, -1, -1, -1 }));
}

/// Counts the polls, which grow with the work, and cancels at one of them if set.
class Counter : public Progress
{
public:
  explicit Counter(std::size_t cancelAt = 0)
    : cancelAt_(cancelAt)
  {
  }
  void beginPhase(Phase phase) override { EXPECT_EQ(phase, Phase::Merge); }
  bool advance(Phase, double fraction) override
  {
    EXPECT_GE(fraction, fraction_);
    EXPECT_LE(fraction, 1.0);
    fraction_ = fraction;
    return ++askings_ != cancelAt_;
  }
  std::size_t askings() const { return askings_; }

private:
  std::size_t cancelAt_;
  std::size_t askings_ = 0;
  double fraction_ = 0.0;
};

TEST(Merge, ManyPointsAnyDistance)
{
  const std::size_t n = reduced(200000);
  for (const Distribution distribution : { Distribution::Uniform, Distribution::AllEqual,
         Distribution::Collinear, Distribution::NestedClusters, Distribution::RepeatedDraws })
  {
    const std::vector<Point> points = makePoints(distribution, n, 1);
    for (const double distance : { 1e-9, 1e-4, 0.1, 1e9, kInfinity })
    {
      SCOPED_TRACE(std::string(nameOf(distribution)) + ", " + std::to_string(distance));
      MergedPoints merged;
      Counter counter;
      ASSERT_EQ(mergeWithin(viewOf(points), distance, &counter, merged), Status::Ok);
      EXPECT_GE(counter.askings(), n / kStepsPerAsking);
      const Ids into = mergedIdsOf(merged, n);
      for (const MergedPoint& pair : merged.pairs)
      {
        ASSERT_EQ(into[pair.keptId], -1) << "merged into a point that is merged itself";
      }
    }
  }
}

/// Points of which some have one near neighbour, at random places, in random directions and orders
/// of ids.
struct Pairs
{
  std::vector<Point> points;
  Ids into; ///< the point each must be merged into, or -1
};

Pairs makePairs(std::size_t n, double distance)
{
  Random random(7);
  Pairs made;
  const std::size_t width = std::size_t(std::sqrt(double(n))) + 1;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point p = { double(i % width) + 0.5 * random.unit(), double(i / width) };
    made.points.push_back(p);
    made.into.push_back(-1);
    if (random.below(4) == 0)
    {
      const double turn = 7.0 * random.unit(), length = 0.999 * distance;
      const Point q = { p.x + length * std::cos(turn), p.y + length * std::sin(turn) };
      const std::int64_t id = std::int64_t(made.points.size());
      made.points.push_back(q);
      made.into.push_back(lexicographicallyLess(q, p) ? -1 : id - 1);
      made.into[std::size_t(id) - 1] = lexicographicallyLess(q, p) ? id : -1;
    }
  }
  return made;
}

TEST(Merge, FewNearPairsAmongManyPointsAnyNumberOfThreads)
{
  const std::size_t n = reduced(300000);
  for (const double distance : { 1e-9, 1e-4, 0.01, 0.1 })
  {
    const Pairs made = makePairs(n, distance);
    for (const unsigned threads : { 1u, 2u, 3u, 11u })
    {
      SCOPED_TRACE(std::to_string(distance) + ", threads " + std::to_string(threads));
      ThreadExecutor executor(threads);
      MergedPoints merged;
      ASSERT_EQ(mergeWithin(viewOf(made.points), distance, Context{ nullptr, &executor }, merged),
        Status::Ok);
      EXPECT_TRUE(mergedIdsOf(merged, made.points.size()) == made.into);
    }
  }
}

TEST(Merge, ManyNearEachOtherAnyNumberOfThreads)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, reduced(300000), 5);
  for (const double distance : { 1e-4, 0.003 })
  {
    MergedPoints expected;
    ASSERT_EQ(mergeWithin(viewOf(points), distance, nullptr, expected), Status::Ok);
    EXPECT_GT(expected.pairs.size(), points.size() / 1000);
    for (const unsigned threads : { 2u, 11u })
    {
      ThreadExecutor executor(threads);
      MergedPoints merged;
      ASSERT_EQ(
        mergeWithin(viewOf(points), distance, Context{ nullptr, &executor }, merged), Status::Ok);
      EXPECT_EQ(mergedIdsOf(merged, points.size()), mergedIdsOf(expected, points.size()));
    }
  }
}

/// On a vertical line all kept places are within any distance in x. Of each three that follow each
/// other only the first is kept.
TEST(Merge, OnAVerticalLineOfAnyScaleAndPlace)
{
  const std::size_t n = reduced(150000);
  for (const double step : { 0x1p-1074, 0x1p-1060, 0x1p-950, 0x1p-400, 1.0, 0x1p960, 0x1p1004 })
  {
    for (const double from : { 0.0, -0.5 * double(n) * step, step * 0x1p34 })
    {
      std::vector<Point> points;
      Ids into;
      for (std::size_t i = 0; i < n; ++i)
      {
        points.push_back({ 3.0, from + double(i) * step });
        into.push_back(i % 3 == 0 ? -1 : std::int64_t(i - i % 3));
      }
      MergedPoints merged;
      ASSERT_EQ(mergeWithin(viewOf(points), 2.0 * step, nullptr, merged), Status::Ok);
      EXPECT_TRUE(!std::isfinite(points.back().y) || mergedIdsOf(merged, n) == into)
        << "step " << step << " from " << from;
    }
  }
}

/// So far apart that rows as high as the distance could not be numbered.
TEST(Merge, ATinyDistanceOnAnEndlessLine)
{
  std::vector<Point> points;
  Ids into;
  for (int e = -1022; e < 1024; ++e)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      const double y = std::ldexp(sign, e);
      points.push_back({ 0.0, y });
      points.push_back({ 0x1p-1074, y });
      into.push_back(-1);
      into.push_back(std::int64_t(points.size()) - 2);
    }
  }
  for (const double distance : { 0x1p-1074, 0x1p-1030 })
  {
    MergedPoints merged;
    ASSERT_EQ(mergeWithin(viewOf(points), distance, nullptr, merged), Status::Ok);
    EXPECT_EQ(mergedIdsOf(merged, points.size()), into);
  }
}

/// Beside coordinates at the ends of the range rows are few, however large the distance: the row
/// above the highest place is no endless number of rows above the one below it.
TEST(Merge, LargeDistancesAtTheEndsOfTheRange)
{
  constexpr double kMost = std::numeric_limits<double>::max();
  for (int exponent = 960; exponent <= 1023; ++exponent)
  {
    const double distance = std::ldexp(1.0, exponent);
    std::vector<Point> points;
    for (const double end : { kMost, -kMost })
    {
      const double inwards = end > 0.0 ? -distance : distance;
      points.insert(points.end(),
        { { 0.0, end }, { 0.0, end + inwards }, { 0.0, end + 3.0 * inwards },
          { 0.5 * distance, end + 2.5 * inwards }, { end, 0.0 }, { end, distance } });
    }
    expectAsDefined(viewOf(points), distance);
    expectAsDefined(viewOf(points), std::nextafter(distance, 0.0));
  }
}

TEST(Merge, CancelledAtAnyAsking)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, 20000, 1);
  MergedPoints merged;
  for (const double distance : { 1e-6, 0.01 }) // few candidates, many
  {
    Counter whole;
    ASSERT_EQ(mergeWithin(viewOf(points), distance, &whole, merged), Status::Ok);
    ASSERT_GE(whole.askings(), 5u);
    for (std::size_t k = 1; k <= whole.askings(); ++k)
    {
      Counter counter(k);
      EXPECT_EQ(mergeWithin(viewOf(points), distance, &counter, merged), Status::Cancelled);
      EXPECT_EQ(counter.askings(), k);
    }
  }
}

TEST(Merge, TooManyPointsAreRefusedUnread)
{
  const double one[] = { 0, 0 };
  MergedPoints merged;
  EXPECT_EQ(mergeWithin(PointView(one, kMaximumPoints + 1, 2), 1.0, nullptr, merged),
    Status::TooManyPoints);
}

} // namespace
} // namespace test
} // namespace ahd
