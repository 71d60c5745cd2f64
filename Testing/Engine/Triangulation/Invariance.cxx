// SPDX-License-Identifier: BSD-3-Clause
//
// The result is a function of the point set: settings and order do not change a byte of it, and
// turning the points turns the result.
#include "Distributions.h"
#include "EngineRun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

using Ids = std::vector<std::size_t>;

Ids shuffledIds(std::size_t n, std::uint64_t seed)
{
  Ids ids(n);
  std::iota(ids.begin(), ids.end(), std::size_t(0));
  Random random(seed);
  for (std::size_t i = n; i > 1; --i)
  {
    std::swap(ids[i - 1], ids[random.below(i)]);
  }
  return ids;
}

/// The first difference between two lists of triples, in words; empty if there is none.
std::string difference(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b)
{
  if (a.size() != b.size())
  {
    return std::to_string(a.size() / 3) + " and " + std::to_string(b.size() / 3) + " triangles";
  }
  const auto found = std::mismatch(a.begin(), a.end(), b.begin());
  if (found.first == a.end())
  {
    return "";
  }
  const std::ptrdiff_t first = (found.first - a.begin()) / 3 * 3;
  const auto text = [first](const std::vector<std::int32_t>& v)
  {
    const auto at = [&](std::ptrdiff_t k) { return std::to_string(v[std::size_t(first + k)]); };
    return at(0) + " " + at(1) + " " + at(2);
  };
  return "triangle " + std::to_string(first / 3) + ": " + text(a) + " and " + text(b);
}

/// Every distribution, as a test of its own.
class Invariance : public testing::TestWithParam<Distribution>
{
protected:
  std::vector<Point> points(std::size_t n, std::uint64_t seed = 1) const
  {
    return makePoints(GetParam(), affordable(GetParam(), n), seed);
  }
};

std::string distributionName(const testing::TestParamInfo<Distribution>& info)
{
  return nameOf(info.param);
}

TEST_P(Invariance, NoSettingChangesTheResult)
{
  const std::vector<Point> p = points(2000);
  const Outcome expected = triangulate(p);
  ASSERT_EQ(faultsOf(p, expected), "");
  Engine engine;
  for (const Options& options : everyDistinctSetting())
  {
    const Outcome outcome = triangulate(engine, viewOf(p), options);
    ASSERT_EQ(outcome.status, Status::Ok) << describe(options);
    ASSERT_EQ(difference(expected.triples, outcome.triples), "") << describe(options);
    ASSERT_EQ(expected.pointStatus, outcome.pointStatus) << describe(options);
  }
}

TEST_P(Invariance, CountingTheWorkChangesNothing)
{
  const std::vector<Point> p = points(20000);
  Options counting;
  counting.countWork = true;
  const Outcome plain = triangulate(p);
  const Outcome counted = triangulate(p, counting);
  EXPECT_EQ(difference(plain.triples, counted.triples), "");
  EXPECT_EQ(plain.pointStatus, counted.pointStatus);
  EXPECT_EQ(plain.report.trianglesWalked, 0u);
  EXPECT_EQ(plain.report.trianglesRemoved, 0u);
}

TEST_P(Invariance, ShufflingChangesOnlyTheIds)
{
  const std::vector<Point> p = points(20000);
  const Outcome expected = triangulate(p);
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    const Ids oldId = shuffledIds(p.size(), seed);
    std::vector<Point> shuffled;
    for (const std::size_t id : oldId)
    {
      shuffled.push_back(p[id]);
    }
    Outcome outcome = triangulate(shuffled);
    ASSERT_EQ(faultsOf(shuffled, outcome), "") << "seed " << seed;
    for (std::int32_t& id : outcome.triples)
    {
      id = std::int32_t(expected.pointStatus[oldId[std::size_t(id)]]);
    }
    ASSERT_EQ(difference(expected.triples, outcome.triples), "") << "seed " << seed;
  }
}

TEST_P(Invariance, ScalingByPowersOfTwoChangesNothing)
{
  const std::vector<Point> p = points(20000);
  const Outcome expected = triangulate(p);
  int compared = 0;
  for (const int exponent : { -60, -3, 1, 60, 500 })
  {
    std::vector<Point> scaled;
    bool exact = true;
    for (const Point& q : p)
    {
      const Point s = { std::ldexp(q.x, exponent), std::ldexp(q.y, exponent) };
      const Point back = { std::ldexp(s.x, -exponent), std::ldexp(s.y, -exponent) };
      exact = exact && back == q;
      scaled.push_back(s);
    }
    if (exact)
    {
      const Outcome outcome = triangulate(scaled);
      EXPECT_EQ(difference(expected.triples, outcome.triples), "") << "exponent " << exponent;
      ++compared;
    }
  }
  if (GetParam() != Distribution::AnyFinite) // no scaling of these is exact
  {
    EXPECT_GT(compared, 0);
  }
}

TEST_P(Invariance, MirroredAndTurnedPointsAreCertified)
{
  const std::vector<Point> p = points(20000);
  std::vector<Point> mirrored, turned, swapped;
  for (const Point& q : p)
  {
    mirrored.push_back({ -q.x, q.y });
    turned.push_back({ -q.y, q.x });
    swapped.push_back({ q.y, q.x });
  }
  EXPECT_EQ(faultsOf(mirrored, triangulate(mirrored)), "");
  EXPECT_EQ(faultsOf(turned, triangulate(turned)), "");
  EXPECT_EQ(faultsOf(swapped, triangulate(swapped)), "");
}

INSTANTIATE_TEST_SUITE_P(Of, Invariance, testing::ValuesIn(allDistributions()), distributionName);

TEST(InvarianceOfRandomPoints, TurnedTriangulationIsTheSame)
{
  // No four random points lie on a circle: the set of triangles is the same, not just certified.
  const std::vector<Point> p = makePoints(Distribution::Uniform, reduced(50000), 3);
  const std::set<Triple> expected = asSet(triangulate(p).triples);
  std::vector<Point> turned, mirrored;
  for (const Point& q : p)
  {
    turned.push_back({ -q.y, q.x });
    mirrored.push_back({ -q.x, q.y });
  }
  EXPECT_EQ(asSet(triangulate(turned).triples), expected);
  std::set<Triple> reversed;
  for (const Triple& t : asSet(triangulate(mirrored).triples))
  {
    reversed.insert(smallestFirst({ t[0], t[2], t[1] }));
  }
  EXPECT_EQ(reversed, expected);
}

TEST(InvarianceOfTriangulation, RunningAgainForgetsThePreviousRun)
{
  Engine engine;
  for (std::uint64_t seed = 0; seed < 3; ++seed)
  {
    for (const Distribution distribution : allDistributions())
    {
      // Growing and shrinking, with and without duplicates, in one engine.
      const std::size_t n = seed == 1 ? 50 : affordable(distribution, 5000);
      const std::vector<Point> p = makePoints(distribution, n, seed);
      const Outcome again = triangulate(engine, viewOf(p));
      const Outcome fresh = triangulate(p);
      ASSERT_EQ(difference(fresh.triples, again.triples), "")
        << nameOf(distribution) << ", seed " << seed;
      ASSERT_EQ(fresh.pointStatus, again.pointStatus) << nameOf(distribution) << ", seed " << seed;
    }
  }
}

TEST(InvarianceOfTriangulation, IdsOf64BitsAreThoseOf32Bits)
{
  const std::vector<Point> p = makePoints(Distribution::Mixed, 5000, 5);
  const Outcome expected = triangulate(p);
  Engine engine;
  ASSERT_EQ(engine.run(viewOf(p), Options(), nullptr), Status::Ok);
  std::vector<std::int64_t> wide(3 * engine.report().triangles);
  ASSERT_EQ(engine.writeTriangles(wide.data(), nullptr), Status::Ok);
  EXPECT_EQ(std::vector<std::int64_t>(expected.triples.begin(), expected.triples.end()), wide);
}

} // namespace
} // namespace test
} // namespace ahd
