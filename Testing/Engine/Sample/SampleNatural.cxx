// SPDX-License-Identifier: BSD-3-Clause
//
// Natural neighbours: weights against their definition in rational arithmetic, for points of every
// kind and places inside, on edges, on vertices and near the hull; linear functions; constraints,
// holes and dropped triangles; NaN.
#include "SampleCase.h"

namespace ahd
{
namespace test
{
namespace
{

TEST(SampleNatural, WeightsAreThoseOfTheDefinition)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Circle, Distribution::Mixed,
         Distribution::KuzminDisc, Distribution::Lattice, Distribution::DecimalLattice,
         Distribution::OnCircle, Distribution::OnIntegerCircle, Distribution::OnParabola,
         Distribution::Utm, Distribution::UtmRaster, Distribution::Tiny, Distribution::Huge })
  {
    for (const std::size_t n : { 3, 4, 9, 20 })
    {
      const std::vector<Point> points = distinct(makePoints(d, n, n + 1));
      if (!triangulate(points).triples.empty())
      {
        SCOPED_TRACE(testing::Message() << nameOf(d) << ", " << n);
        SampledCase given(points);
        ASSERT_NO_FATAL_FAILURE(expectWeightsOfDefinition(given, hardPlaces(points, reduced(40))));
      }
    }
  }
}

TEST(SampleNatural, AllPlacesAmongAllSmallSets)
{
  const std::vector<Point> places = placesBetween(-0.25, 2.25);
  const std::size_t step = reduced(100) == 100 ? 3 : 41;
  for (unsigned mask = 1; mask < 1u << 9; mask += unsigned(step))
  {
    const std::vector<Point> points = someOfNine(mask);
    SampledCase given(points);
    const std::vector<std::int32_t> triples = given.triples();
    const SampleOracle oracle(points, triples);
    given.prepare(SampleMethod::NaturalNeighbor);
    const std::vector<PointWeights> found = weightsAt(given.sampler, places);
    for (std::size_t k = 0; k < places.size() && !triples.empty(); ++k)
    {
      ASSERT_LE(differenceOf(found[k], oracle.sibson(places[k])), 1e-14)
        << mask << " " << places[k].x << " " << places[k].y;
    }
  }
}

double plane(const Point& p)
{
  return 0.3 * p.x - 0.7 * p.y + 0.1;
}

/// The largest error of a linear function at these places, over the largest value at a point.
double errorOfPlane(SampledCase& given, SampleMethod method, const std::vector<Point>& places)
{
  std::vector<double> values;
  double largest = 0.0, most = 0.0;
  for (const Point& p : given.points)
  {
    values.push_back(plane(p));
    largest = std::max(largest, std::fabs(values.back()));
  }
  given.prepare(method);
  const SampledValues found = sample(given.sampler, SamplePlaces(viewOf(places)), values);
  EXPECT_GT(found.report.valued, places.size() / 4);
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    most = found.mask[k] == 0 ? most
                              : std::max(most, std::fabs(found.values[k] - plane(places[k])));
  }
  return most / largest;
}

TEST(SampleNatural, LinearFunctionsAreReproduced)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice, Distribution::Utm })
  {
    SampledCase given(makePoints(d, reduced(20000), 3));
    const std::vector<Point> places = hardPlaces(given.points, reduced(50000));
    for (const SampleMethod method : kBoth)
    {
      EXPECT_LE(errorOfPlane(given, method, places), 1e-13) << nameOf(d) << " " << int(method);
    }
  }
}

/// With constraints and holes, too: Sibson's identity holds for the cavity that they leave.
TEST(SampleNatural, LinearFunctionsAreReproducedBetweenConstraints)
{
  for (const ConstraintCase& given :
    { shortSegments(2000, 400), nestedLoops(10), edgesOfOthers(1000, 300), starPolygon(50) })
  {
    SampledCase made(given);
    const std::vector<Point> places = hardPlaces(given.points, reduced(20000));
    for (const SampleMethod method : kBoth)
    {
      EXPECT_LE(errorOfPlane(made, method, places), 1e-13) << int(method);
    }
  }
}

/// A wall from top to bottom: on either side the result is as if the other side had no points.
TEST(SampleNatural, NothingIsSeenBeyondAConstraint)
{
  Random random(7);
  std::vector<Point> left{ { 0, 0 }, { 0, 1 }, { 0.5, 0 }, { 0.5, 1 } },
    right{ { 1, 0 }, { 1, 1 } };
  for (int k = 0; k < 30; ++k)
  {
    left.push_back({ 0.49 * random.unit(), random.unit() });
    right.push_back({ 0.51 + 0.49 * random.unit(), random.unit() });
  }
  ConstraintCase given;
  given.points = left;
  given.points.insert(given.points.end(), right.begin(), right.end());
  given.constraints.addLine({ 2, 3 });
  SampledCase whole(given), half(left);
  std::vector<Point> places{ { 0.5, 0.25 } };
  while (places.size() < 500)
  {
    places.push_back({ 0.5 * random.unit(), random.unit() });
  }
  for (const SampleMethod method : kBoth)
  {
    whole.prepare(method);
    half.prepare(method);
    const std::vector<PointWeights> found = weightsAt(whole.sampler, places);
    const std::vector<PointWeights> expected = weightsAt(half.sampler, places);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      ASSERT_LE(differenceOf(found[k], expected[k]), 1e-13) << hexText(places[k]);
    }
    EXPECT_EQ(found[0], (PointWeights{ { 2, 0.75 }, { 3, 0.25 } })) << "on the wall: its ends";
  }
}

/// The same where the wall is made of triangles that are not kept.
TEST(SampleNatural, NothingIsSeenBeyondDroppedTriangles)
{
  std::vector<Point> points;
  for (int k = 0; k < 25; ++k)
  {
    points.push_back({ double(k % 5), double(k / 5) });
  }
  SampledCase whole(points);
  ASSERT_EQ(whole.engine.made.makeCorners({}), Status::Ok);
  std::vector<unsigned char> kept(whole.engine.made.triangleCount());
  std::vector<Point> left;
  for (std::size_t t = 0; t < kept.size(); ++t)
  {
    const Triangulation& made = whole.engine.made;
    double least = 9.0;
    for (HalfEdge h = HalfEdge(3 * t); h != 3 * t + 3; ++h)
    {
      least = std::min(least, made.at(made.origin(h)).x);
    }
    kept[t] = least != 2.0; // none between 2 and 3
  }
  for (const Point& p : points)
  {
    left.push_back({ std::min(p.x, 2.0), p.y });
  }
  SampledCase half(left); // duplicates have the ids of the first at their place
  const std::vector<Point> places{ { 2, 1.5 }, { 1.75, 1.5 }, { 2.5, 1 }, { 3, 2 }, { 1.9, 2.1 } };
  for (const SampleMethod method : kBoth)
  {
    ASSERT_NO_FATAL_FAILURE(whole.prepare(method, kept.data()));
    const std::vector<PointWeights> found = weightsAt(whole.sampler, places);
    half.prepare(method);
    const std::vector<PointWeights> expected = weightsAt(half.sampler, places);
    EXPECT_EQ(found[0], (PointWeights{ { 7, 0.5 }, { 12, 0.5 } }));
    EXPECT_LE(differenceOf(found[1], expected[1]), 1e-14);
    EXPECT_TRUE(found[2].empty());
    EXPECT_EQ(found[3], (PointWeights{ { 13, 1.0 } }));
    EXPECT_LE(differenceOf(found[4], expected[4]), 1e-14);
  }
}

/// Nearer and nearer to an edge of the hull, where the cell grows without end.
TEST(SampleNatural, NextToTheHullWeightsAreThoseOfTheDefinition)
{
  // The first of them is a neighbour of places between the last two.
  SampledCase given({ { 0.3, 0.7 }, { 0.8, 0.9 }, { 0.5, 0.1 }, { 0, 0 }, { 1, 0 } });
  const std::vector<std::int32_t> triples = given.triples();
  const SampleOracle oracle(given.points, triples);
  std::vector<Point> places;
  for (int k = 0; k < 1060; k = k < 60 ? k + 1 : k + 100)
  {
    places.push_back({ 1.0 / 3.0, std::ldexp(1.0, -k - 4) });
  }
  given.prepare(SampleMethod::Laplace);
  const std::vector<PointWeights> laplace = weightsAt(given.sampler, places);
  given.prepare(SampleMethod::NaturalNeighbor);
  const std::vector<PointWeights> sibson = weightsAt(given.sampler, places);
  for (std::size_t k = 0; k != places.size(); ++k)
  {
    SCOPED_TRACE(testing::Message() << places[k].y);
    EXPECT_LE(differenceOf(laplace[k], oracle.laplace(places[k])), 1e-14);
    const PointWeights expected = oracle.sibson(places[k]);
    EXPECT_EQ(expected.count(0), 1u);
    EXPECT_LE(differenceOf(sibson[k], expected), 1e-14);
  }
}

TEST(SampleNatural, NeighborsWithoutValueAreLeftOut)
{
  SampledCase given({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } });
  const std::vector<Point> places{ { 2, 2 }, { 4, 4 }, { 2, 0 } };
  for (const SampleMethod method : kBoth)
  {
    given.prepare(method);
    const SampledValues found = sample(
      given.sampler, SamplePlaces(viewOf(places)), { 1.0, 2.0, kNotANumber, 6.0 });
    EXPECT_DOUBLE_EQ(found.values[0], 3.0);
    EXPECT_TRUE(std::isnan(found.values[1]));
    EXPECT_DOUBLE_EQ(found.values[2], 1.5);
    EXPECT_EQ(found.report.valued, 3u);
    EXPECT_EQ(found.report.leftOut, 1u);
    EXPECT_EQ(found.report.withoutValue, 1u);
  }
}

/// A value within those around, wherever points are.
TEST(SampleNatural, AnyFinitePointsHaveValues)
{
  for (const Distribution d : { Distribution::AnyFinite, Distribution::TinyAndHuge,
         Distribution::Slivers, Distribution::NearlyCollinear })
  {
    SampledCase given(distinct(makePoints(d, 40, 2)));
    std::vector<double> values;
    for (std::size_t k = 0; k < given.points.size(); ++k)
    {
      values.push_back(double(k));
    }
    const std::vector<Point> places = placesAmong(given.points, reduced(500), 2);
    for (const SampleMethod method : kBoth)
    {
      given.prepare(method);
      const SampledValues found = sample(given.sampler, SamplePlaces(viewOf(places)), values);
      EXPECT_EQ(found.report.withoutValue, 0u);
      for (std::size_t k = 0; k < places.size(); ++k)
      {
        ASSERT_TRUE(found.mask[k] == 0 ||
          (found.values[k] >= -1e-9 && found.values[k] <= double(values.size())));
      }
      for (const PointWeights& weights : weightsAt(given.sampler, places))
      {
        ASSERT_TRUE(weights.empty() || std::fabs(sumOf(weights) - 1.0) < 1e-14);
      }
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
