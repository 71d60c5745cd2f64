// SPDX-License-Identifier: BSD-3-Clause
//
// Places along the curve: each is near the one before it, even if others lie far away.
#include "Order/CurveOrder.h"

#include "Distributions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PointView viewOfPlaces(const std::vector<Point>& places)
{
  return PointView(places.empty() ? nullptr : &places[0].x, places.size(), 2);
}

/// @pre begin < places.size().
std::vector<std::size_t> ordered(const std::vector<Point>& places, std::size_t begin = 0)
{
  Ticker nobody(nullptr, Phase::Outputs, 0);
  CurveOrder order;
  EXPECT_TRUE(order.build(viewOfPlaces(places), begin, places.size(), nobody));
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k != places.size() - begin; ++k)
  {
    numbers.push_back(order[k]);
  }
  std::vector<std::size_t> sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k != sorted.size(); ++k)
  {
    EXPECT_EQ(sorted[k], begin + k) << "each once";
  }
  return numbers;
}

/// From each to the next, those longer than `most` not counted.
double lengthOf(
  const std::vector<Point>& places, const std::vector<std::size_t>& order, double most)
{
  double sum = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k)
  {
    const Point &p = places[order[k - 1]], &q = places[order[k]];
    const double length = std::hypot(p.x - q.x, p.y - q.y);
    sum += length < most ? length : 0.0;
  }
  return sum;
}

TEST(OrderCurve, EachIsNearTheOneBeforeIt)
{
  const std::size_t n = 10000;
  const std::vector<Point> places = makePoints(Distribution::Uniform, n, 1);
  EXPECT_LT(lengthOf(places, ordered(places), 10.0), 2.0 * std::sqrt(double(n)));
  EXPECT_EQ(ordered(places, n - 3).size(), 3u);
}

TEST(OrderCurve, AlsoWhereOthersLieFarAway)
{
  const std::size_t n = 10000;
  for (const double far : { 1e5, 1e12, 1e300 })
  {
    std::vector<Point> places = makePoints(Distribution::Uniform, n, 2);
    places.push_back({ far, -far });
    places.push_back({ -far, 3.0 });
    EXPECT_LT(lengthOf(places, ordered(places), 10.0), 2.0 * std::sqrt(double(n))) << far;
  }
}

TEST(OrderCurve, AlsoOfCrowdsWithinCrowds)
{
  const std::size_t n = 1000;
  std::vector<Point> places;
  constexpr int kLevels = 12;
  for (const Point& p : makePoints(Distribution::Uniform, n, 3))
  {
    for (int level = 0; level < kLevels; ++level)
    {
      places.push_back({ std::ldexp(p.x, -60 * level), std::ldexp(p.y, -60 * level) });
    }
  }
  const std::vector<std::size_t> order = ordered(places);
  std::size_t changes = 0; // of the crowd
  for (std::size_t k = 1; k != order.size(); ++k)
  {
    changes += std::size_t(order[k] % kLevels != order[k - 1] % kLevels);
  }
  EXPECT_LE(changes, 2u * kLevels);
}

TEST(OrderCurve, PlacesThatAreNoneAndPlacesThatAreOne)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> places(5000, Point{ 7.0, 7.0 });
  ordered(places);
  places.assign(5000, Point{ kNaN, 1.0 });
  ordered(places);
  for (std::size_t k = 0; k != places.size(); ++k)
  {
    places[k] = k % 3 == 0 ? Point{ kInfinity, double(k) }
      : k % 3 == 1         ? Point{ 1e308, -1e308 }
                           : Point{ double(k % 7), -kInfinity };
  }
  ordered(places);
  places.assign(1, Point{ kNaN, kNaN });
  ordered(places);
}

} // namespace
} // namespace test
} // namespace ahd
