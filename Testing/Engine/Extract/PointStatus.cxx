// SPDX-License-Identifier: BSD-3-Clause
//
// The input: any number of points, in any storage, some of them rejected; and the status of each.
#include "Distributions.h"
#include "EngineRun.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using PointStatuses = std::vector<std::int64_t>;

TEST(PointStatus, NoPoints)
{
  const std::vector<Point> none;
  for (const Options& options : everySetting())
  {
    const Outcome outcome = triangulate(none, options);
    EXPECT_EQ(outcome.status, Status::Ok) << describe(options);
    EXPECT_EQ(outcome.report.triangles, 0u);
    EXPECT_EQ(outcome.report.inserted, 0u);
  }
}

TEST(PointStatus, OneTwoAndThreePoints)
{
  const std::vector<Point> all = { { 1, 2 }, { 4, 2 }, { 1, 7 } };
  for (const Options& options : everySetting())
  {
    for (std::size_t n = 1; n <= 3; ++n)
    {
      const std::vector<Point> points(all.begin(), all.begin() + std::ptrdiff_t(n));
      const Outcome outcome = triangulate(points, options);
      EXPECT_EQ(outcome.report.inserted, n) << describe(options);
      EXPECT_EQ(outcome.report.triangles, n == 3 ? 1u : 0u) << describe(options);
      EXPECT_EQ(faultsOf(points, outcome), "") << describe(options);
    }
  }
}

TEST(PointStatus, TwoPlacesManyTimes)
{
  std::vector<Point> points;
  PointStatuses expected;
  for (int i = 0; i < 1000; ++i)
  {
    points.push_back({ double(i % 2), 0.5 });
    expected.push_back(i % 2);
  }
  const Outcome outcome = triangulate(points);
  EXPECT_EQ(outcome.pointStatus, expected);
  EXPECT_EQ(outcome.report.duplicates, 998u);
  EXPECT_EQ(outcome.report.triangles, 0u);
}

TEST(PointStatus, SignedZerosAreOnePlace)
{
  const std::vector<Point> points = { { 0.0, -0.0 }, { -0.0, 0.0 }, { 1, 0 }, { 1, -0.0 },
    { -0.0, 1 }, { 0.0, 1 } };
  const Outcome outcome = triangulate(points);
  EXPECT_EQ(outcome.pointStatus, (PointStatuses{ 0, 0, 2, 2, 4, 4 }));
  EXPECT_EQ(faultsOf(points, outcome), "");
}

TEST(PointStatus, SmallestIdOfCoincidentPointsIsKept)
{
  const std::vector<Point> points = { { 5, 5 }, { 0, 0 }, { 9, 1 }, { 0, 0 }, { 5, 5 }, { 0, 0 } };
  for (const Options& options : everySetting())
  {
    const Outcome outcome = triangulate(points, options);
    EXPECT_EQ(outcome.pointStatus, (PointStatuses{ 0, 1, 2, 1, 0, 1 })) << describe(options);
    EXPECT_EQ(outcome.report.duplicates, 3u);
  }
}

TEST(PointStatus, NotFiniteAmongGoodPoints)
{
  const std::vector<Point> good = makePoints(Distribution::Uniform, 2000, 4);
  const Point bad[] = { { kNaN, 0.5 }, { 0.5, kNaN }, { kNaN, kNaN }, { kInfinity, 0.5 },
    { 0.5, -kInfinity }, { -kInfinity, kInfinity } };
  std::vector<Point> points;
  for (std::size_t i = 0; i < good.size(); ++i)
  {
    if (i % 7 == 0)
    {
      points.push_back(bad[i / 7 % 6]);
    }
    points.push_back(good[i]);
  }
  for (const Options& options : everySetting({ 50 }))
  {
    const Outcome outcome = triangulate(points, options);
    EXPECT_EQ(outcome.report.notFinite, points.size() - good.size());
    EXPECT_EQ(faultsOf(points, outcome), "") << describe(options);
    EXPECT_EQ(outcome.triples.size(), triangulate(good).triples.size());
  }
}

TEST(PointStatus, NothingButNotFinite)
{
  const std::vector<Point> points = { { kNaN, 1 }, { 1, kInfinity }, { -kInfinity, kNaN } };
  const Outcome outcome = triangulate(points);
  EXPECT_EQ(outcome.pointStatus, (PointStatuses{ -1, -1, -1 }));
  EXPECT_EQ(faultsOf(points, outcome), "");
}

TEST(PointStatus, SkippedPointsDoNotExist)
{
  const std::vector<Point> points = makePoints(Distribution::RepeatedDraws, 5000, 4);
  std::vector<unsigned char> flags(points.size());
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    flags[i] = static_cast<unsigned char>(i % 5); // bits 0 and 1 set in 1, 2, 3
  }
  PointView view = viewOf(points);
  view.skip = flags.data();
  const std::map<int, std::size_t> skippedByMask = { { 0, 0 }, { 1, 2000 }, { 2, 2000 },
    { 3, 3000 }, { 255, 4000 } };
  for (const auto& expected : skippedByMask)
  {
    view.skipMask = static_cast<unsigned char>(expected.first);
    const Outcome outcome = triangulate(view);
    EXPECT_EQ(faultsOf(view, outcome), "") << "mask " << expected.first;
    EXPECT_EQ(outcome.report.skipped, expected.second) << "mask " << expected.first;
  }
}

TEST(PointStatus, SkippedPointMayBeNotFiniteAndItsTwinIsAVertex)
{
  const std::vector<Point> points = { { 0, 0 }, { kNaN, 0 }, { 0, 0 }, { 3, 0 }, { 0, 3 } };
  const unsigned char flags[] = { 1, 1, 0, 0, 0 };
  PointView view = viewOf(points);
  view.skip = flags;
  const Outcome outcome = triangulate(view);
  EXPECT_EQ(outcome.pointStatus, (PointStatuses{ -2, -2, 2, 3, 4 }));
  EXPECT_EQ(faultsOf(view, outcome), "");
}

TEST(PointStatus, EveryPointSkipped)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 10, 4);
  const std::vector<unsigned char> flags(points.size(), 1);
  PointView view = viewOf(points);
  view.skip = flags.data();
  const Outcome outcome = triangulate(view);
  EXPECT_EQ(outcome.report.skipped, 10u);
  EXPECT_EQ(faultsOf(view, outcome), "");
}

TEST(PointStatus, FloatsGiveWhatTheirWidenedDoublesGive)
{
  for (const Distribution distribution : allDistributions())
  {
    std::vector<float> floats;
    std::vector<Point> doubles;
    for (const Point& p : makePoints(distribution, affordable(distribution, 10000), 9))
    {
      // Beyond float's range this makes infinities and zeros, which are input as well.
      const float x = p.x > 3e38 ? float(kInfinity) : p.x < -3e38 ? -float(kInfinity) : float(p.x);
      const float y = p.y > 3e38 ? float(kInfinity) : p.y < -3e38 ? -float(kInfinity) : float(p.y);
      floats.insert(floats.end(), { x, y });
      doubles.push_back({ double(x), double(y) });
    }
    const PointView view(floats.data(), doubles.size(), 2);
    const Outcome narrow = triangulate(view);
    EXPECT_EQ(faultsOf(view, narrow), "") << nameOf(distribution);
    const Outcome wide = triangulate(doubles);
    EXPECT_EQ(narrow.triples, wide.triples) << nameOf(distribution);
    EXPECT_EQ(narrow.pointStatus, wide.pointStatus) << nameOf(distribution);
  }
}

TEST(PointStatus, NumbersBetweenTheCoordinatesAreNotLookedAt)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, reduced(10000), 9);
  const Outcome expected = triangulate(points);
  for (const std::size_t stride : { 3u, 5u })
  {
    std::vector<double> numbers(points.size() * stride, kNaN);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      numbers[i * stride] = points[i].x;
      numbers[i * stride + 1] = points[i].y;
    }
    const Outcome outcome = triangulate(PointView(numbers.data(), points.size(), stride));
    EXPECT_EQ(outcome.triples, expected.triples) << "stride " << stride;
    EXPECT_EQ(outcome.pointStatus, expected.pointStatus) << "stride " << stride;
  }
}

TEST(PointStatus, MorePointsThanTheEngineTakesAreRefusedUnread)
{
  // This view has the memory of one point only: it must be refused by its count.
  const double one[] = { 0, 0 };
  Engine engine;
  const PointView view(one, kMaximumPoints + 1, 2);
  EXPECT_EQ(engine.run(view, Options(), nullptr), Status::TooManyPoints);
  EXPECT_EQ(engine.report().triangles, 0u);
  const std::vector<Point> points = makePoints(Distribution::Uniform, 100, 1);
  EXPECT_EQ(faultsOf(points, triangulate(engine, viewOf(points))), "");
}

} // namespace
} // namespace test
} // namespace ahd
