// SPDX-License-Identifier: BSD-3-Clause
//
// The representative of the points at one place, and their mean; against a literal search. This
// program's operator new fails on demand.
#include "Core/Progress.h"
#include "Surface/Means.h"
#include "Triangulate.h"

#include "Listeners.h"
#include "OwnMemory.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Xyz = Vector3;
using Place = std::pair<double, double>;

/// Points at few places, with few z; every tenth is marked as left out.
struct Crowd
{
  Crowd(std::size_t count, unsigned seed)
    : points(count)
    , marks(count, 0)
  {
    std::mt19937 random(seed); // its sequence is fixed by the standard
    for (Xyz& p : points)
    {
      const double x = double(random() % 6), y = double(random() % 6);
      p = { { x, y, double(random() % 5) / 10 } };
      const unsigned odd = unsigned(random() % 10);
      p[2] = odd == 0 ? kNaN : odd == 1 ? (random() % 2 ? kInfinity : -kInfinity) : p[2];
    }
    for (std::size_t i = 9; i < count; i += 10)
    {
      marks[i] = 1;
    }
  }

  PointView view() const
  {
    PointView result(points[0].data(), points.size(), 3);
    result.skip = marks.data();
    return result;
  }

  /// The points at each place, those to be left out excepted.
  std::map<Place, std::vector<std::size_t>> places() const
  {
    std::map<Place, std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (!marks[i])
      {
        result[{ points[i][0], points[i][1] }].push_back(i);
      }
    }
    return result;
  }

  std::vector<Xyz> points;
  std::vector<unsigned char> marks;
};

PointView viewOf(const std::vector<Xyz>& points)
{
  return PointView(points[0].data(), points.size(), 3);
}

void make(const PointView& points, Triangulation& out, const Options& options = Options())
{
  Workspace workspace;
  ASSERT_EQ(triangulate(points, options, workspace, Context(), out), Status::Ok);
}

std::vector<Mean> meansOf(const PointView& points, const PointView& inSpace, std::size_t count)
{
  Triangulation triangulation;
  make(points, triangulation);
  std::vector<Mean> means(1); // the old content is gone
  EXPECT_EQ(findMeans(triangulation, count, inSpace, Context(), means), Status::Ok);
  return means;
}

std::vector<Mean> meansOf(const std::vector<Xyz>& points)
{
  return meansOf(viewOf(points), viewOf(points), points.size());
}

TEST(Duplicates, TheLowestOrTheHighestStandsForTheVertex)
{
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    SCOPED_TRACE(seed);
    const bool highest = seed % 2 == 1;
    const Crowd crowd(1 + seed, seed);
    Options options;
    options.representative = highest ? Representative::HighestZ : Representative::LowestZ;
    Triangulation triangulation;
    make(crowd.view(), triangulation, options);
    std::vector<std::int64_t> status(crowd.points.size());
    ASSERT_EQ(triangulation.writePointStatus(status.data(), Context()), Status::Ok);
    ASSERT_EQ(triangulation.makePointMap(Context()), Status::Ok);
    for (const auto& [place, ids] : crowd.places())
    {
      std::size_t best = ids.front();
      for (const std::size_t id : ids)
      {
        const double z = crowd.points[id][2], than = crowd.points[best][2];
        const bool better = std::isfinite(z) &&
          (!std::isfinite(than) || (highest ? z > than : z < than));
        best = better ? id : best;
      }
      for (const std::size_t id : ids)
      {
        ASSERT_EQ(status[id], std::int64_t(best)) << "point " << id;
        ASSERT_EQ(triangulation.pointOf(triangulation.vertexOf(id)), best) << "point " << id;
      }
    }
  }
}

TEST(Duplicates, TheSmallerIdStandsWhereTheZAreTheSame)
{
  const std::vector<Xyz> points = { { { 1, 2, 3 } }, { { 2, 2, 3 } }, { { 1, 2, 3 } } };
  for (const Representative wanted : { Representative::LowestZ, Representative::HighestZ })
  {
    Options options;
    options.representative = wanted;
    Triangulation triangulation;
    make(viewOf(points), triangulation, options);
    ASSERT_EQ(triangulation.makePointMap(Context()), Status::Ok);
    EXPECT_EQ(triangulation.pointOf(triangulation.vertexOf(2)), 0u);
  }
}

TEST(Duplicates, MeansAreOfFiniteZ)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    const Crowd crowd(1 + seed, seed);
    const std::size_t count = crowd.points.size() - seed % 3 * crowd.points.size() / 4;
    const std::vector<Mean> means = meansOf(crowd.view(), viewOf(crowd.points), count);
    std::map<std::size_t, std::pair<double, int>> expected; // sum and number
    for (const auto& [place, all] : crowd.places())
    {
      std::vector<std::size_t> ids = all;
      ids.erase(std::remove_if(ids.begin(), ids.end(), [&](std::size_t i) { return i >= count; }),
        ids.end());
      for (const std::size_t id : ids)
      {
        if (ids.size() > 1 && std::isfinite(crowd.points[id][2]))
        {
          expected[ids.front()].first += crowd.points[id][2];
          ++expected[ids.front()].second;
        }
      }
    }
    ASSERT_EQ(means.size(), expected.size());
    std::size_t next = 0;
    for (const auto& [id, sum] : expected)
    {
      const Mean& mean = means[next++];
      ASSERT_EQ(mean.id, id);
      EXPECT_EQ(mean.position[0], crowd.points[id][0]);
      EXPECT_EQ(mean.position[1], crowd.points[id][1]);
      EXPECT_NEAR(mean.position[2], sum.first / sum.second, 1e-15);
    }
  }
}

TEST(Duplicates, TheOrderOfThePointsHasNoSayInTheirMean)
{
  std::mt19937 random(1);
  std::vector<Xyz> points(10000);
  for (Xyz& p : points)
  {
    p = { { 0.1, 0.2, double(random()) / 7 } };
  }
  const std::vector<Mean> means = meansOf(points);
  ASSERT_EQ(means.size(), 1u);
  EXPECT_EQ(means[0].position[0], 0.1) << "what all have in common is not rounded";
  for (int round = 0; round < 20; ++round)
  {
    for (std::size_t i = points.size(); i > 1; --i)
    {
      std::swap(points[i - 1], points[random() % i]);
    }
    const std::vector<Mean> others = meansOf(points);
    ASSERT_EQ(others.size(), 1u);
    EXPECT_EQ(others[0].position, means[0].position);
  }
}

TEST(Duplicates, MeansOfHugeAndOfOddNumbers)
{
  const double most = std::numeric_limits<double>::max();
  const std::vector<Xyz> points = { { { 0, 0, most } }, { { 0, 0, most / 2 } },
    { { 0, 0, kInfinity } }, { { 1, 0, kNaN } }, { { 1, 0, kInfinity } } };
  const std::vector<Mean> means = meansOf(points);
  ASSERT_EQ(means.size(), 1u);
  EXPECT_EQ(means[0].position[2], most * 0.75);
}

/// Is this the double nearest to the exact mean, an even one of two?
bool isNearestToMean(double found, const std::vector<double>& numbers)
{
  mpq_class mean = 0;
  for (const double x : numbers)
  {
    mean += mpq_class(x);
  }
  mean /= static_cast<unsigned long>(numbers.size());
  const mpq_class below(std::nextafter(found, -kInfinity)), above(std::nextafter(found, kInfinity));
  const mpq_class low = (below + mpq_class(found)) / 2, high = (mpq_class(found) + above) / 2;
  int exponent = 0;
  const bool isEven = std::fmod(std::ldexp(std::frexp(found, &exponent), 53), 2.0) == 0.0;
  return isEven || std::fabs(found) < 0x1p-1021 ? low <= mean && mean <= high
                                                : low < mean && mean < high;
}

double meanOf(const std::vector<double>& numbers)
{
  std::vector<Xyz> points;
  for (const double z : numbers)
  {
    points.push_back({ { 1, 2, z } });
  }
  const std::vector<Mean> means = meansOf(points);
  return means.size() == 1 ? means[0].position[2] : kNaN;
}

TEST(Duplicates, MeansAreNearestToTheExactOnes)
{
  EXPECT_EQ(meanOf({ 1e16, 1, -1e16 }), 1.0 / 3);
  EXPECT_EQ(meanOf({ 1e16, -1e16, 0 }), 0.0);
  EXPECT_EQ(meanOf({ 1e300, 1e-300, -1e300 }), 1e-300 / 3);
  EXPECT_EQ(meanOf({ 1.7e308, 1.7e308, 1.7e308, -1.7e308 }), 0.85e308);
  EXPECT_EQ(meanOf({ 5e-324, 0, 0 }), 0.0);
  EXPECT_EQ(meanOf({ 5e-324, 5e-324, 0 }), 5e-324);
  EXPECT_FALSE(std::signbit(meanOf({ -0.0, 0.0 })));
  EXPECT_TRUE(std::signbit(meanOf({ -0.0, -0.0 })));
  std::mt19937_64 random(7);
  const int widths[] = { 0, 3, 30, 60, 300, 2040 };
  for (int trial = 0; trial < 3000; ++trial)
  {
    // all digits, or few; exponents near each other or far; sums that cancel
    const int width = widths[random() % 6], lowest = int(random() % 2046) - 1073;
    std::vector<double> numbers(2 + random() % 9);
    for (double& x : numbers)
    {
      const std::uint64_t digits = random() >> (random() % 2 == 0 ? 11 : 58);
      const int exponent = std::min(970, lowest + int(random() % unsigned(width + 1)));
      x = std::ldexp(double(digits), exponent) * (random() % 2 == 0 ? 1 : -1);
    }
    if (trial % 3 == 0)
    {
      numbers.push_back(-numbers[0]);
      numbers.push_back(std::nextafter(-numbers[1], 0));
    }
    ASSERT_TRUE(isNearestToMean(meanOf(numbers), numbers))
      << trial << ": " << testing::PrintToString(numbers);
  }
}

/// Half-way between two doubles, and next to that.
TEST(Duplicates, MeansThatAreTies)
{
  const double above = std::nextafter(1.0, 2.0);
  EXPECT_EQ(meanOf({ 1.0, above }), 1.0);
  EXPECT_EQ(meanOf({ above, std::nextafter(above, 2.0) }), std::nextafter(above, 2.0));
  EXPECT_EQ(meanOf({ 1.0, above, 1e-200, -1e-200 }), 0.5);
  EXPECT_EQ(meanOf({ 1.0, above, 1e-200, 0.0 }), std::nextafter(0.5, 1.0));
  EXPECT_EQ(meanOf({ 1.0, above, -1e-200, 0.0 }), 0.5);
}

TEST(Duplicates, InAPlaneTheMeanIsOneOfPositions)
{
  // two points one above the other in a plane that is not x, y; the third has no place in it
  const std::vector<Xyz> places = { { { 5, 5, 1 } }, { { 5, 5, 3 } }, { { kNaN, kNaN, kNaN } } };
  const std::vector<float> positions = { 1, 2, 3, 5, 2, 7, float(kNaN), 0, 0 };
  const std::vector<Mean> means = meansOf(viewOf(places), PointView(positions.data(), 3, 3), 3);
  ASSERT_EQ(means.size(), 1u);
  EXPECT_EQ(means[0].position, (Xyz{ { 3, 2, 5 } }));
}

TEST(Duplicates, AnyAskingCanCancelTheMeans)
{
  const Crowd crowd(30000, 1); // some hundred at each place
  const PointView inSpace = viewOf(crowd.points);
  Triangulation triangulation;
  make(crowd.view(), triangulation);
  std::vector<Mean> means;
  Listener all;
  ASSERT_EQ(findMeans(triangulation, 30000, inSpace, Context{ &all, nullptr }, means), Status::Ok);
  EXPECT_EQ(means.size(), 36u);
  for (std::size_t k = 1; k <= all.askings(); ++k)
  {
    Triangulation fresh;
    make(crowd.view(), fresh);
    Listener listener(k);
    EXPECT_EQ(
      findMeans(fresh, 30000, inSpace, Context{ &listener, nullptr }, means), Status::Cancelled)
      << "asking " << k;
  }
}

TEST(Duplicates, AnyAllocationOfTheMeansCanFail)
{
  const Crowd crowd(9000, 1);
  const PointView inSpace = viewOf(crowd.points);
  Triangulation triangulation;
  make(crowd.view(), triangulation);
  const std::size_t before = account.held;
  std::size_t failed = 0;
  for (;; ++failed)
  {
    Triangulation fresh;
    make(crowd.view(), fresh);
    std::vector<Mean> means;
    account.allocations = 0;
    account.failAt = failed + 1;
    const Status status = findMeans(fresh, 9000, inSpace, Context(), means);
    account.failAt = 0;
    if (status == Status::Ok)
    {
      EXPECT_EQ(means.size(), 36u);
      break;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << failed + 1;
  }
  EXPECT_GT(failed, 5u);
  EXPECT_EQ(account.held, before) << "something leaked";
}

} // namespace
} // namespace test
} // namespace ahd
