// SPDX-License-Identifier: BSD-3-Clause
//
// The canonical rank: order, duplicates, and that it depends on the point set alone.
#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"
#include "Order/HilbertCurve.h"
#include "Order/Quantise.h"
#include "Order/Rank.h"
#include "PaperOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

RankedPoints ranked(const PointView& view, Executor* executor = nullptr)
{
  RankedPoints result;
  Ticker reading(nullptr, Phase::Read, view.count, executor);
  EXPECT_EQ(readPoints(view, reading, result), Status::Ok);
  Ticker ticker(nullptr, Phase::Sort, view.count, executor);
  EXPECT_EQ(rankPoints(view, ticker, result), Status::Ok);
  return result;
}

RankedPoints ranked(const std::vector<Point>& points)
{
  return ranked(viewOf(points));
}

std::vector<Index> idsOf(const RankedPoints& points)
{
  return std::vector<Index>(points.id.data(), points.id.data() + points.count);
}

/// The fault of a RankedPoints, by its contract and a map of places; empty if none.
std::string faultsOfRank(const std::vector<Point>& points, const RankedPoints& sorted)
{
  std::map<std::pair<double, double>, Index> kept; // -0.0 and +0.0 are equal as map keys, too
  std::map<Index, Index> duplicates;
  for (Index id = 0; id < points.size(); ++id)
  {
    const auto place = kept.insert({ { points[id].x, points[id].y }, id });
    if (!place.second)
    {
      duplicates[id] = place.first->second;
    }
  }
  if (sorted.count != kept.size() || sorted.duplicates.size() != duplicates.size())
  {
    return std::to_string(sorted.count) + " points and " +
      std::to_string(sorted.duplicates.size()) + " duplicates instead of " +
      std::to_string(kept.size()) + " and " + std::to_string(duplicates.size());
  }
  for (const Duplicate& d : sorted.duplicates)
  {
    const auto known = duplicates.find(d.id);
    if (known == duplicates.end() || known->second != d.keptId)
    {
      return "point " + std::to_string(d.id) + " is no duplicate of " + std::to_string(d.keptId);
    }
    duplicates.erase(known);
  }
  const Grid grid(sorted.bounds);
  for (Index r = 0; r < sorted.count; ++r)
  {
    const Point& p = sorted.xy[r];
    const auto place = kept.find({ p.x, p.y });
    const std::string at = "rank " + std::to_string(r);
    if (place == kept.end() || place->second != sorted.id[r])
    {
      return at + ": wrong id " + std::to_string(sorted.id[r]);
    }
    if (sorted.key[r] != hilbertKey(grid.column(p.x), grid.row(p.y)))
    {
      return at + ": wrong key";
    }
    if (r > 0 && sorted.key[r] < sorted.key[r - 1])
    {
      return at + ": key descends";
    }
    kept.erase(place); // a second rank for this place would not find it
  }
  const Point& infinite = sorted.xy[sorted.count];
  return std::isnan(infinite.x) && std::isnan(infinite.y) ? "" : "no vertex at infinity";
}

std::string nameOfParam(const ::testing::TestParamInfo<Distribution>& info)
{
  return nameOf(info.param);
}

class Rank : public ::testing::TestWithParam<Distribution>
{
protected:
  static std::size_t size(std::size_t usual)
  {
    return GetParam() == Distribution::AnyFinite ? usual / 10 : usual;
  }
};

TEST_P(Rank, IsTheDefinitions)
{
  for (const std::size_t n : std::vector<std::size_t>{ 2, 3, 17, 300, 3000 })
  {
    const std::vector<Point> points = makePoints(GetParam(), size(n) + 1, n);
    EXPECT_EQ(idsOf(ranked(points)), rankByDefinition(points)) << n << " points";
  }
}

TEST_P(Rank, ManyPointsAreCompleteAndSorted)
{
#ifdef AHD_REDUCED_TESTS
  const std::size_t n = 20000;
#else
  const std::size_t n = 150000;
#endif
  const std::vector<Point> points = makePoints(GetParam(), n, 21);
  EXPECT_EQ(faultsOfRank(points, ranked(points)), "");
}

TEST_P(Rank, DoesNotDependOnTheOrderOfTheInput)
{
  const std::vector<Point> points = makePoints(GetParam(), size(20000), 22);
  std::vector<Point> shuffled = points;
  Random random(23);
  for (std::size_t i = shuffled.size(); i > 1; --i)
  {
    std::swap(shuffled[i - 1], shuffled[random.below(i)]);
  }
  const RankedPoints a = ranked(points);
  const RankedPoints b = ranked(shuffled);
  ASSERT_EQ(a.count, b.count);
  for (Index r = 0; r < a.count; ++r)
  {
    ASSERT_TRUE(a.xy[r] == b.xy[r]) << "rank " << r;
  }
}

/// All coordinates times 2^e; empty if that is not exact.
std::vector<Point> scaled(const std::vector<Point>& points, int e)
{
  std::vector<Point> result;
  for (const Point& p : points)
  {
    const Point q{ std::ldexp(p.x, e), std::ldexp(p.y, e) };
    if (!isFinite(q) || std::ldexp(q.x, -e) != p.x || std::ldexp(q.y, -e) != p.y)
    {
      return {};
    }
    result.push_back(q);
  }
  return result;
}

TEST_P(Rank, DoesNotDependOnTheUnitOfLength)
{
  const std::vector<Point> points = makePoints(GetParam(), size(3000), 24);
  const std::vector<Index> expected = idsOf(ranked(points));
  std::size_t tried = 0;
  for (const int e : { -2000, -1000, -950, -900, -500, -1, 1, 26, 27, 500, 900, 1000, 2000 })
  {
    const std::vector<Point> other = scaled(points, e);
    tried += other.empty() ? 0 : 1;
    if (!other.empty())
    {
      EXPECT_EQ(idsOf(ranked(other)), expected) << "times 2^" << e;
    }
  }
  EXPECT_TRUE(
    tried > 0 || GetParam() == Distribution::AnyFinite || GetParam() == Distribution::TinyAndHuge)
    << "no scaling was exact";
}

bool sameBytes(const void* a, const void* b, std::size_t bytes)
{
  return bytes == 0 || std::memcmp(a, b, bytes) == 0;
}

/// The first difference of two results, byte for byte; empty if they are the same.
std::string differenceOf(const RankedPoints& a, const RankedPoints& b)
{
  const auto same = [](const auto& x, const auto& y, std::size_t n)
  { return sameBytes(x.data(), y.data(), n * sizeof(x[0])); };
  return a.count != b.count || a.duplicates.size() != b.duplicates.size() ||
      a.notFinite != b.notFinite || a.skipped != b.skipped
    ? "counts"
    : !sameBytes(&a.bounds, &b.bounds, sizeof(Bounds))       ? "bounds"
    : !same(a.xy, b.xy, a.count)                             ? "locations"
    : !same(a.id, b.id, a.count)                             ? "ids"
    : !same(a.key, b.key, a.count)                           ? "keys"
    : !same(a.duplicates, b.duplicates, a.duplicates.size()) ? "duplicates"
                                                             : "";
}

/// For any number of threads, and whichever task comes first.
void expectTheSameOnManyThreads(const PointView& view)
{
  const RankedPoints expected = ranked(view);
  for (const unsigned threads : { 1u, 2u, 3u, 5u, 8u })
  {
    ThreadExecutor executor(threads);
    EXPECT_EQ(differenceOf(ranked(view, &executor), expected), "") << threads << " threads";
  }
  if (kOnlyThreadsMatter)
  {
    return;
  }
  for (const unsigned threads : { 2u, 64u, 1000u })
  {
    BackwardExecutor backward(threads);
    EXPECT_EQ(differenceOf(ranked(view, &backward), expected), "") << "backward, " << threads;
  }
}

TEST_P(Rank, IsTheSameOnManyThreads)
{
  for (const std::size_t n : std::vector<std::size_t>{ 3, 300, reduced(50000) })
  {
    SCOPED_TRACE(std::to_string(n) + " points");
    expectTheSameOnManyThreads(viewOf(makePoints(GetParam(), n, 25)));
  }
}

TEST_P(Rank, IsTheSameOnManyThreadsWithDuplicatesAndBadPoints)
{
  // Places drawn twice on average, so that every task leaves gaps; some points are left out.
  const std::size_t n = reduced(100000);
  const std::vector<Point> places = makePoints(GetParam(), n / 2, 26);
  Random random(27);
  std::vector<Point> points;
  std::vector<unsigned char> skip(n, 0);
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool bad = random.below(50) == 0;
    points.push_back(bad ? Point{ kNaN, 0.0 } : places[random.below(places.size())]);
    skip[i] = random.below(40) == 0 ? 1 : 0;
  }
  PointView view = viewOf(points);
  expectTheSameOnManyThreads(view);
  view.skip = skip.data();
  expectTheSameOnManyThreads(view);
}

INSTANTIATE_TEST_SUITE_P(All, Rank, ::testing::ValuesIn(allDistributions()), nameOfParam);

TEST(Crowd, SharesAKeyUpToSixteenDistinctPointsAndMore)
{
  // Distinct points in one box of the finest grid, each drawn several times, between two corners.
  for (const std::size_t distinct : std::vector<std::size_t>{ 2, 15, 16, 17, 18, 100, 2000 })
  {
    for (const std::size_t draws : std::vector<std::size_t>{ 1, 3, 50 })
    {
      Random random(distinct * 100 + draws);
      const std::vector<Point> places = makePoints(Distribution::Uniform, distinct, 31);
      std::vector<Point> points{ { 0.0, 0.0 }, { 1.0, 1.0 } };
      for (std::size_t i = 0; i < distinct * draws; ++i)
      {
        const Point& q = places[i % distinct];
        points.push_back({ 0.25 + q.x * 0x1p-40, 0.75 + q.y * 0x1p-40 });
      }
      for (std::size_t i = points.size(); i > 1; --i)
      {
        std::swap(points[i - 1], points[random.below(i)]);
      }
      const RankedPoints sorted = ranked(points);
      SCOPED_TRACE(std::to_string(distinct) + " places, " + std::to_string(draws) + " draws");
      EXPECT_EQ(faultsOfRank(points, sorted), "");
      EXPECT_EQ(idsOf(sorted), rankByDefinition(points));
    }
  }
}

TEST(Crowd, WithinCrowds)
{
  // Each level 2^-40 as wide as the one above: far below the finest grid every time.
  std::vector<Point> points;
  double width = 1.0;
  for (int level = 0; level < 20; ++level, width *= 0x1p-40)
  {
    for (const Point& q : makePoints(Distribution::Uniform, 100, std::uint64_t(level)))
    {
      points.push_back({ q.x * width, q.y * width });
    }
  }
  const RankedPoints sorted = ranked(points);
  EXPECT_EQ(faultsOfRank(points, sorted), "");
  EXPECT_EQ(idsOf(sorted), rankByDefinition(points));
}

TEST(Read, CountsWhatIsLeftOut)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, 30000, 41);
  std::vector<unsigned char> skip(points.size(), 0);
  std::size_t notFinite = 0, skipped = 0;
  for (std::size_t i = 0; i < points.size(); i += 7)
  {
    const double bad = i % 3 == 0 ? kNaN : i % 3 == 1 ? kInfinity : -kInfinity;
    (i % 2 == 0 ? points[i].x : points[i].y) = bad;
    skip[i] = i % 5 == 0 ? 6 : 8; // 8 is not in the mask
    (i % 5 == 0 ? skipped : notFinite) += 1;
  }
  points[10].x = 1000.0; // a skipped point does not widen the bounds
  skip[10] = 2;
  ++skipped;
  PointView view = viewOf(points);
  view.skip = skip.data();
  view.skipMask = 2;
  const RankedPoints sorted = ranked(view);
  EXPECT_EQ(sorted.notFinite, notFinite);
  EXPECT_EQ(sorted.skipped, skipped);
  EXPECT_EQ(sorted.count, points.size() - notFinite - skipped);
  EXPECT_LT(sorted.bounds.xmax, 1.0);
  std::set<Index> seen(sorted.id.data(), sorted.id.data() + sorted.count);
  EXPECT_EQ(seen.size(), sorted.count);
  for (const Index id : seen)
  {
    EXPECT_TRUE(isFinite(points[id]) && (skip[id] & 2) == 0) << "point " << id;
  }
}

TEST(Read, NothingButBadPoints)
{
  const std::vector<Point> points(5000, Point{ kNaN, 1.0 });
  const RankedPoints sorted = ranked(points);
  EXPECT_EQ(sorted.count, 0u);
  EXPECT_EQ(sorted.notFinite, points.size());
  EXPECT_TRUE(std::isnan(sorted.xy[0].x));
}

TEST(Read, NoPoints)
{
  const RankedPoints sorted = ranked(std::vector<Point>());
  EXPECT_EQ(sorted.count, 0u);
  EXPECT_GT(sorted.bounds.xmin, sorted.bounds.xmax);
}

TEST(Read, BoundsAreTheExtremes)
{
  const std::vector<Point> points = makePoints(Distribution::AnyFinite, 10000, 42);
  Bounds b{ kInfinity, -kInfinity, kInfinity, -kInfinity };
  for (const Point& p : points)
  {
    b = { std::min(b.xmin, p.x), std::max(b.xmax, p.x), std::min(b.ymin, p.y),
      std::max(b.ymax, p.y) };
  }
  const Bounds found = ranked(points).bounds;
  EXPECT_EQ(found.xmin, b.xmin);
  EXPECT_EQ(found.xmax, b.xmax);
  EXPECT_EQ(found.ymin, b.ymin);
  EXPECT_EQ(found.ymax, b.ymax);
}

TEST(Read, FloatsAndStridesGiveWhatDoublesGive)
{
  std::vector<float> floats;
  std::vector<double> doubles;
  std::vector<Point> points;
  for (const Point& p : makePoints(Distribution::Uniform, 5000, 43))
  {
    const float x = float(p.x), y = float(p.y);
    floats.insert(floats.end(), { x, y, float(kNaN) });
    doubles.insert(doubles.end(), { x, y, kNaN });
    points.push_back({ x, y });
  }
  const std::vector<Index> expected = idsOf(ranked(points));
  EXPECT_EQ(idsOf(ranked(PointView(floats.data(), points.size(), 3))), expected);
  EXPECT_EQ(idsOf(ranked(PointView(doubles.data(), points.size(), 3))), expected);
}

TEST(Duplicates, BothZerosAreOnePlace)
{
  const std::vector<Point> points{ { 1.0, 1.0 }, { -0.0, 0.0 }, { 0.0, -0.0 }, { -0.0, 2.0 },
    { 0.0, 2.0 }, { 0.0, 0.0 } };
  const RankedPoints sorted = ranked(points);
  EXPECT_EQ(faultsOfRank(points, sorted), "");
  EXPECT_EQ(sorted.count, 3u);
}

} // namespace
} // namespace test
} // namespace ahd
