// SPDX-License-Identifier: BSD-3-Clause
//
// Linear and nearest values: weights against their definitions in rational arithmetic, at places
// inside, on edges, on vertices and outside; linear functions; holes, dropped triangles; collinear
// points; duplicates; NaN.
#include "Listeners.h"
#include "SampleCase.h"

#include "Surface/Selection.h"

namespace ahd
{
namespace test
{
namespace
{

/// The points that stand for vertices: the oracle supports no duplicates.
std::vector<Point> distinct(const std::vector<Point>& points)
{
  std::vector<Point> result = points;
  std::sort(result.begin(), result.end(), lexicographicallyLess);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void expectWeightsOfDefinition(
  const std::vector<Point>& points, std::size_t places, double mostDifference)
{
  SampledCase given(points);
  const std::vector<std::int32_t> triples = given.triples();
  const SampleOracle oracle(given.points, triples);
  const std::vector<Point> where = placesAmong(points, places, points.size());
  given.prepare(SampleMethod::Linear);
  const std::vector<PointWeights> linear = weightsAt(given.sampler, where);
  given.prepare(SampleMethod::Nearest);
  const std::vector<PointWeights> nearest = weightsAt(given.sampler, where);
  for (std::size_t k = 0; k < where.size(); ++k)
  {
    const PointWeights expected = oracle.linear(where[k]);
    SCOPED_TRACE(testing::Message() << hexText(where[k]));
    ASSERT_LE(differenceOf(linear[k], expected), mostDifference);
    ASSERT_TRUE(expected.size() == 3 || linear[k].size() == expected.size());
    if (!linear[k].empty())
    {
      ASSERT_NEAR(sumOf(linear[k]), 1.0, 1e-15);
    }
    ASSERT_EQ(nearest[k], oracle.nearest(where[k]));
  }
}

TEST(SampleLinear, WeightsAreThoseOfTheDefinition)
{
  for (const Distribution d : allDistributions())
  {
    for (const std::size_t n : { 3, 4, 7, 40 })
    {
      const std::vector<Point> points = distinct(makePoints(d, n, n));
      if (!triangulate(points).triples.empty())
      {
        SCOPED_TRACE(testing::Message() << nameOf(d) << ", " << n);
        ASSERT_NO_FATAL_FAILURE(expectWeightsOfDefinition(points, reduced(300), 1e-12));
      }
    }
  }
}

/// Each place of a finer lattice, among all sets of points of a small one.
TEST(SampleLinear, AllPlacesAmongAllSmallSets)
{
  const std::vector<Point> places = placesBetween(-0.5, 2.5);
  for (unsigned mask = 1; mask < 1u << 9; ++mask)
  {
    const std::vector<Point> points = someOfNine(mask);
    SampledCase given(points);
    const std::vector<std::int32_t> triples = given.triples();
    const SampleOracle oracle(points, triples);
    given.prepare(SampleMethod::Linear);
    const std::vector<PointWeights> linear = weightsAt(given.sampler, places);
    given.prepare(SampleMethod::Nearest);
    const std::vector<PointWeights> nearest = weightsAt(given.sampler, places);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      SCOPED_TRACE(testing::Message() << mask << " " << places[k].x << " " << places[k].y);
      ASSERT_TRUE(triples.empty() || differenceOf(linear[k], oracle.linear(places[k])) < 1e-15);
      ASSERT_EQ(nearest[k], oracle.nearest(places[k]));
    }
  }
}

double plane(const Point& p)
{
  return 0.3 * p.x - 0.7 * p.y + 0.1;
}

std::vector<double> planeAt(const std::vector<Point>& points)
{
  std::vector<double> result;
  for (const Point& p : points)
  {
    result.push_back(plane(p));
  }
  return result;
}

TEST(SampleLinear, LinearFunctionsAreReproduced)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice, Distribution::Utm })
  {
    SCOPED_TRACE(nameOf(d));
    SampledCase given(makePoints(d, reduced(20000), 3));
    const std::vector<double> values = planeAt(given.points);
    double largest = 0.0;
    for (const double value : values)
    {
      largest = std::max(largest, std::fabs(value));
    }
    given.prepare(SampleMethod::Linear);
    const std::vector<Point> where = placesAmong(given.points, reduced(50000), 1);
    const SampledValues sampled = sample(
      given.sampler, SamplePlaces(viewOf(where)), values, {}, true);
    ASSERT_EQ(sampled.status, Status::Ok);
    ASSERT_GT(sampled.report.valued, where.size() / 2);
    for (std::size_t k = 0; k < where.size(); ++k)
    {
      if (sampled.mask[k] != 0)
      {
        ASSERT_LE(std::fabs(sampled.values[k] - plane(where[k])), 1e-13 * largest);
      }
    }
  }
}

TEST(SampleLinear, SlopesAreThoseOfTheTriangle)
{
  // Two triangles that meet in an edge; z = 2 x + 3 y in the one, 5 x - y in the other.
  SampledCase given({ { 0, 0 }, { 2, 0 }, { 0, 2 }, { 2, 3 } });
  const std::vector<std::int32_t> triples = given.triples();
  ASSERT_EQ(triples.size(), 6u);
  given.prepare(SampleMethod::Linear);
  const std::vector<double> values{ 1.0, 5.0, 7.0, 13.0 };
  const std::vector<Point> places{ { 0.5, 0.5 }, { 1.0, 0.25 }, { 1.9, 2.5 }, { 9, 9 } };
  const SampledValues found = sample(given.sampler, SamplePlaces(viewOf(places)), values, {}, true);
  EXPECT_DOUBLE_EQ(found.gradients[0], 2.0);
  EXPECT_DOUBLE_EQ(found.gradients[1], 3.0);
  EXPECT_DOUBLE_EQ(found.gradients[2], 2.0);
  EXPECT_DOUBLE_EQ(found.gradients[3], 3.0);
  // From (2, 0) and (0, 2) to (2, 3): 8 / 3 along y, then (6 - 8 / 3) / 2 along x.
  EXPECT_DOUBLE_EQ(found.gradients[5], 8.0 / 3.0);
  EXPECT_DOUBLE_EQ(found.gradients[4], (6.0 - 8.0 / 3.0) / 2.0);
  EXPECT_TRUE(std::isnan(found.gradients[6]) && std::isnan(found.gradients[7]));
}

/// A triangle of which nothing is left in 106 bits; the same far smaller.
TEST(SampleLinear, SlopesInATriangleOfNoAreaButForWideIntegers)
{
  const double X = 2.0 / 3.0, Y = 0.7;
  for (const double scale : { 1.0, 0x1p-800 })
  {
    SampledCase given(
      { { 0x1p-120 * scale, 0 }, { X * scale, Y * scale }, { 0.5 * X * scale, 0.5 * Y * scale } });
    given.prepare(SampleMethod::Linear);
    const std::vector<Point> places{ given.points[2] };
    const std::vector<double> values{ 1.0, 2.0, 1.0 };
    const SampledValues found = sample(
      given.sampler, SamplePlaces(viewOf(places)), values, {}, true);
    ASSERT_EQ(found.mask[0], 1);
    // The longest edge would reach the origin with 0: from there it is 2^-120 to 1.
    EXPECT_DOUBLE_EQ(found.gradients[0] * scale, 0x1p120);
    EXPECT_DOUBLE_EQ(found.gradients[1] * scale, (2.0 - 0x1p120 * X) / Y);
    const SampledValues none = sample(
      given.sampler, SamplePlaces(viewOf(places)), { 1.0, kNotANumber, 2.0 }, {}, true);
    EXPECT_TRUE(std::isnan(none.gradients[0]) && std::isnan(none.gradients[1]));
  }
}

/// A square with a square hole; places in and on the hole.
TEST(SampleLinear, HolesHaveNoValueTheirBorderHas)
{
  ConstraintCase given;
  given.points = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1, 1 }, { 3, 1 }, { 3, 3 }, { 1, 3 } };
  given.constraints.addLoop({ 0, 1, 2, 3 });
  given.constraints.addLoop({ 4, 7, 6, 5 });
  SampledCase made(given);
  std::vector<double> values;
  for (const Point& p : given.points)
  {
    values.push_back(p.x + 2 * p.y);
  }
  made.prepare(SampleMethod::Linear);
  const std::vector<Point> places{ { 2, 2 }, { 2, 1 }, { 3, 3 }, { 0.5, 2 }, { 1, 2.5 }, { 5, 2 },
    { 1.0 + 0x1p-46, 2 }, { 4, 4 }, { kNotANumber, 1 }, { 1, -HUGE_VAL } };
  const SampledValues found = sample(made.sampler, SamplePlaces(viewOf(places)), values);
  const unsigned char mask[] = { 0, 1, 1, 1, 1, 0, 0, 1, 0, 0 };
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    EXPECT_EQ(found.mask[k], mask[k]) << k;
    EXPECT_TRUE(mask[k] ? std::fabs(found.values[k] - places[k].x - 2 * places[k].y) < 1e-15
                        : std::isnan(found.values[k]))
      << k;
  }
  EXPECT_EQ(found.report.valued, 5u);
  EXPECT_EQ(found.report.outside, 3u);
  EXPECT_EQ(found.report.notFinite, 2u);
  EXPECT_EQ(found.report.withoutValue, 0u);
}

/// Triangles that a Selection does not keep: against the kept ones, each place.
TEST(SampleLinear, DroppedTrianglesHaveNoValue)
{
  SampledCase given(distinct(makePoints(Distribution::Lattice, 100, 1)));
  ASSERT_EQ(given.engine.made.makeCorners({}), Status::Ok);
  Random random(5);
  std::vector<unsigned char> kept(given.engine.made.triangleCount());
  std::vector<std::int32_t> triples;
  for (std::size_t t = 0; t < kept.size(); ++t)
  {
    kept[t] = random.below(3) != 0;
    for (HalfEdge h = HalfEdge(3 * t); kept[t] != 0 && h != 3 * t + 3; ++h)
    {
      const Triangulation& made = given.engine.made;
      triples.push_back(std::int32_t(made.pointOf(made.origin(h))));
    }
  }
  given.prepare(SampleMethod::Linear, kept.data());
  const SampleOracle oracle(given.points, triples);
  const std::vector<Point> places = placesAmong(given.points, reduced(2000), 2);
  const std::vector<PointWeights> found = weightsAt(given.sampler, places);
  std::size_t outside = 0;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    ASSERT_LE(differenceOf(found[k], oracle.linear(places[k])), 1e-12) << hexText(places[k]);
    outside += found[k].empty();
  }
  EXPECT_GT(outside, places.size() / 10);
}

TEST(SampleLinear, BetweenCollinearPoints)
{
  const std::vector<Point> points{ { 6, 12 }, { 0, 0 }, { 1, 2 }, { 3, 6 } };
  const std::vector<double> values{ 4.0, 1.0, 3.0, kNotANumber };
  const std::vector<Point> places{ { 0, 0 }, { 0.25, 0.5 }, { 1, 2 }, { 2, 4 }, { 6, 12 },
    { 7, 14 }, { -1, -2 }, { 0.5, 0.5 }, { 0.25, 0.5 + 0x1p-44 }, { 3, 6 } };
  for (const SampleMethod method :
    { SampleMethod::Linear, SampleMethod::NaturalNeighbor, SampleMethod::Laplace })
  {
    SampledCase given(points);
    given.prepare(method);
    const SampledValues found = sample(
      given.sampler, SamplePlaces(viewOf(places)), values, {}, true);
    const unsigned char mask[] = { 1, 1, 1, 1, 1, 0, 0, 0, 0, 1 };
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      EXPECT_EQ(found.mask[k], mask[k]) << k;
    }
    EXPECT_EQ(found.values[0], 1.0);
    EXPECT_EQ(found.values[1], 1.5);
    EXPECT_EQ(found.values[2], 3.0);
    EXPECT_EQ(std::isnan(found.values[3]), method == SampleMethod::Linear);
    EXPECT_EQ(found.values[4], 4.0);
    EXPECT_TRUE(std::isnan(found.values[9]));
    EXPECT_DOUBLE_EQ(found.gradients[2], 2.0 / 5.0);
    EXPECT_DOUBLE_EQ(found.gradients[3], 4.0 / 5.0);
    EXPECT_EQ(found.report.withoutValue, method == SampleMethod::Linear ? 2u : 1u);
    EXPECT_EQ(found.report.leftOut, method == SampleMethod::Linear ? 0u : 1u);
  }
}

/// Edges so short that a coordinate which both ends share is 2^1060 times as large.
TEST(SampleLinear, OnShortEdgesAlongAnAxisFarAway)
{
  for (const bool isUpright : { false, true })
  {
    const auto at = [isUpright](double x, double y) {
      return isUpright ? Point{ y, x } : Point{ x, y };
    };
    SampledCase given({ at(0, 1e160), at(1e-160, 1e160) });
    given.prepare(SampleMethod::Linear);
    const std::vector<Point> places{ at(2.5e-161, 1e160) };
    const PointWeights found = weightsAt(given.sampler, places)[0];
    ASSERT_EQ(found.size(), 2u);
    EXPECT_DOUBLE_EQ(found.at(0), 0.75);
    EXPECT_DOUBLE_EQ(found.at(1), 0.25);
    const SampledValues slopes = sample(
      given.sampler, SamplePlaces(viewOf(places)), { 1.0, 3.0 }, {}, true);
    EXPECT_DOUBLE_EQ(slopes.values[0], 1.5);
    EXPECT_DOUBLE_EQ(slopes.gradients[isUpright ? 1 : 0], 2e160);
    EXPECT_EQ(slopes.gradients[isUpright ? 0 : 1], 0.0);
  }
}

/// From far away all vertices are at the same distance up to rounding: still the nearest, and
/// without testing each.
TEST(SampleLinear, NearestFromAfar)
{
  const std::vector<double> far{ 1e10, 1e16, 1e30, 0x1p501, 1e200, 1e308 };
  std::vector<Point> places;
  for (const double r : far)
  {
    const Point around[] = { { r, r }, { -r, r }, { r, 0.3 }, { 0.3, -r }, { -r, -0.6 * r },
      { 0.1 * r, 0.9 * r } };
    places.insert(places.end(), std::begin(around), std::end(around));
  }
  for (const double scale : { 1.0, 0x1p-400 })
  {
    std::vector<Point> points = makePoints(Distribution::Uniform, reduced(4000), 1);
    for (Point& p : points)
    {
      p = { p.x * scale, p.y * scale };
    }
    SampledCase given(points);
    given.prepare(SampleMethod::Nearest);
    const std::vector<std::int32_t> none;
    const SampleOracle oracle(given.points, none);
    const std::vector<PointWeights> found = weightsAt(given.sampler, places);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      ASSERT_EQ(found[k], oracle.nearest(places[k])) << hexText(places[k]);
    }
    std::vector<Point> many;
    for (std::size_t k = 0; k < reduced(4000); ++k)
    {
      many.push_back(places[k % places.size()]);
    }
    Listener listener;
    const SampledValues sampled = sample(given.sampler, SamplePlaces(viewOf(many)),
      std::vector<double>(points.size()), { &listener, nullptr });
    EXPECT_EQ(sampled.report.valued, many.size());
    EXPECT_LT(listener.askings(), many.size() / 10) << "of 8192 steps";
  }
}

TEST(SampleLinear, OnePointNoPointNoSurface)
{
  const std::vector<Point> places{ { 1, 2 }, { 1, 2.5 } };
  for (const SampleMethod method : { SampleMethod::Linear, SampleMethod::NaturalNeighbor,
         SampleMethod::Laplace, SampleMethod::Nearest })
  {
    SampledCase one({ { 1, 2 }, { 1, 2 } });
    one.prepare(method);
    const SampledValues found = sample(
      one.sampler, SamplePlaces(viewOf(places)), { 3.0, 4.0 }, {}, true);
    EXPECT_EQ(found.values[0], 3.0);
    EXPECT_TRUE(std::isnan(found.gradients[0]));
    EXPECT_EQ(found.mask[1], method == SampleMethod::Nearest ? 1 : 0);
    SampledCase none{ std::vector<Point>() };
    none.prepare(method);
    EXPECT_EQ(sample(none.sampler, SamplePlaces(viewOf(places)), {}).report.outside, 2u);
    EXPECT_EQ(sample(Sampler(), SamplePlaces(viewOf(places)), {}).report.outside, 2u);
    EXPECT_EQ(sample(one.sampler, SamplePlaces(viewOf({})), { 3.0, 4.0 }).report.valued, 0u);
  }
}

TEST(SampleLinear, TheRepresentativesValueCounts)
{
  const std::vector<Point> points{ { 0, 0 }, { 4, 0 }, { 0, 4 }, { 0, 0 }, { 4, 0 } };
  SampledCase given(points);
  given.prepare(SampleMethod::Linear);
  const std::vector<Point> places{ { 0, 0 }, { 1, 1 } };
  const SampledValues found = sample(
    given.sampler, SamplePlaces(viewOf(places)), { 1.0, 2.0, 3.0, 100.0, 100.0 });
  EXPECT_EQ(found.values[0], 1.0);
  EXPECT_DOUBLE_EQ(found.values[1], 0.5 * 1 + 0.25 * 2 + 0.25 * 3);
}

TEST(SampleLinear, NoValueWhereACornerHasNone)
{
  SampledCase given({ { 0, 0 }, { 4, 0 }, { 0, 4 }, { 4, 5 } });
  given.prepare(SampleMethod::Linear);
  const std::vector<Point> places{ { 0, 0 }, { 1, 1 }, { 2, 0 }, { 0, 2 }, { 2, 2 }, { 4, 4 } };
  const SampledValues found = sample(
    given.sampler, SamplePlaces(viewOf(places)), { 1.0, 2.0, 2.0, kNotANumber });
  EXPECT_EQ(found.values[0], 1.0);
  EXPECT_EQ(found.values[1], 1.5);
  EXPECT_EQ(found.values[2], 1.5);
  EXPECT_EQ(found.values[3], 1.5);
  EXPECT_EQ(found.values[4], 2.0) << "on the edge of two corners that have one";
  EXPECT_TRUE(std::isnan(found.values[5]));
  EXPECT_EQ(found.mask[5], 1);
  EXPECT_EQ(found.report.withoutValue, 1u);
}

TEST(SampleLinear, PointsBeyondTheLimitHaveNoSay)
{
  Options options;
  options.insertionLimit = 50;
  options.keepOrder = true;
  const std::vector<Point> points = makePoints(Distribution::Uniform, 200, 1);
  SampledCase given(points, options);
  std::vector<std::int32_t> order(50);
  ASSERT_EQ(given.engine.writeOrder(order.data()), Status::Ok);
  std::vector<Point> inserted;
  for (const std::int32_t id : order)
  {
    inserted.push_back(points[std::size_t(id)]);
  }
  const std::vector<std::int32_t> none;
  const SampleOracle oracle(inserted, none);
  given.prepare(SampleMethod::Nearest);
  const std::vector<PointWeights> found = weightsAt(given.sampler, points);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const PointWeights expected = oracle.nearest(points[k]);
    ASSERT_EQ(found[k].begin()->first, order[std::size_t(expected.begin()->first)]);
  }
}

TEST(SampleLinear, SeveralArraysOfSeveralComponents)
{
  SampledCase given(makePoints(Distribution::Uniform, 300, 1));
  given.prepare(SampleMethod::Linear);
  std::vector<double> two, one;
  for (const Point& p : given.points)
  {
    two.push_back(p.x);
    two.push_back(p.y);
    one.push_back(p.x + p.y);
  }
  const std::vector<Point> places = placesAmong(given.points, 500, 1); // gathered; one is not
  for (const std::size_t count : { places.size(), std::size_t(1) })
  {
    std::vector<double> outTwo(2 * count), outOne(count);
    const SampleArray arrays[] = { { two.data(), 2, outTwo.data(), nullptr },
      { one.data(), 1, outOne.data(), nullptr } };
    SampleReport report;
    PointView view(&places[10].x, count, 2);
    view = count == 1 ? view : viewOf(places);
    const Point* const first = count == 1 ? &places[10] : places.data();
    ASSERT_EQ(given.sampler.values(SamplePlaces(view), arrays, 2, nullptr, report, {}), Status::Ok);
    for (std::size_t k = 0; k < count; ++k)
    {
      if (!std::isnan(outOne[k]))
      {
        ASSERT_NEAR(outTwo[2 * k], first[k].x, 1e-14);
        ASSERT_NEAR(outTwo[2 * k + 1], first[k].y, 1e-14);
        ASSERT_NEAR(outOne[k], first[k].x + first[k].y, 1e-14);
      }
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
