// SPDX-License-Identifier: BSD-3-Clause
//
// Places on the rim of a surface but for rounding, and what places outside have: against the
// definition, in rational arithmetic; rasters, threads; walls that hide vertices.
#include "Executors.h"
#include "SampleCase.h"

#include "Predicates/Distances.h"
#include "Sample/Outside.h"

#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

const SampleMethod kSurfaceMethods[] = { SampleMethod::Linear, SampleMethod::NaturalNeighbor,
  SampleMethod::Laplace };

Point turned(double x, double y)
{
  const double angle = std::acos(-1.0) / 18.0; // 10 degrees
  return { std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y };
}

/// A grid of 51 by 51 points, turned by 10 degrees.
std::vector<Point> turnedGrid()
{
  std::vector<Point> points;
  for (int k = 0; k < 51 * 51; ++k)
  {
    points.push_back(turned(k % 51, k / 51));
  }
  return points;
}

/// In the middles of its border's edges.
std::vector<Point> middlesOfBorder()
{
  std::vector<Point> places;
  for (int k = 0; k < 50; ++k)
  {
    const double at = k + 0.5;
    for (const Point& p : { turned(at, 0), turned(at, 50), turned(0, at), turned(50, at) })
    {
      places.push_back(p);
    }
  }
  return places;
}

std::vector<double> xOf(const std::vector<Point>& points)
{
  std::vector<double> values;
  for (const Point& p : points)
  {
    values.push_back(p.x);
  }
  return values;
}

/// All valid, and x where they are.
void expectX(SampledCase& given, const std::vector<Point>& places, double most)
{
  for (const SampleMethod method : kSurfaceMethods)
  {
    given.prepare(method);
    const SampledValues found = sample(given.sampler, SamplePlaces(viewOf(places)),
      xOf(given.points), {}, method == SampleMethod::Linear);
    EXPECT_EQ(found.report.valued, places.size()) << int(method);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      ASSERT_EQ(found.mask[k], 1) << k;
      ASSERT_NEAR(found.values[k], places[k].x, most) << k;
      if (!found.gradients.empty())
      {
        ASSERT_NEAR(found.gradients[2 * k], 1.0, 1e-6) << "the triangle's, also of a sliver";
      }
    }
  }
}

TEST(SampleRim, MiddlesOfATurnedGridsBorderHaveValues)
{
  SampledCase given(turnedGrid());
  expectX(given, middlesOfBorder(), 1e-13);
}

TEST(SampleRim, SoTheyHaveWhereTheRimIsTrimmed)
{
  SampledCase given(turnedGrid());
  ASSERT_EQ(trim(std::move(given.engine.made), {}, given.engine.made), Status::Ok);
  expectX(given, middlesOfBorder(), 1e-13);
}

/// Two loops, one in the other, of ordinary coordinates.
ConstraintCase ring()
{
  ConstraintCase given;
  for (const double radius : { 1.0, 0.4 })
  {
    std::vector<std::int64_t> loop;
    for (int k = 0; k < 45; ++k)
    {
      const double angle = 0.139 * k, r = radius * (1.0 + 0.2 * std::sin(11.0 * angle));
      loop.push_back(std::int64_t(given.points.size()));
      given.points.push_back({ 77.7 + r * std::cos(angle), 3.3 + r * std::sin(angle) });
    }
    given.constraints.addLoop(loop);
  }
  Random random(3);
  for (int k = 0; k < 200; ++k)
  {
    given.points.push_back({ 76.7 + 2.0 * random.unit(), 2.3 + 2.0 * random.unit() });
  }
  return given;
}

TEST(SampleRim, APolygonsOwnEdgesHaveValues)
{
  const ConstraintCase given = ring();
  std::vector<Point> places;
  for (std::size_t k = 0; k < 90; ++k)
  {
    const Point a = given.points[k], b = given.points[k % 45 == 44 ? k - 44 : k + 1];
    for (const double t : { 0.25, 0.5, 1.0 / 3.0 })
    {
      places.push_back({ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) });
    }
  }
  SampledCase made(given);
  expectX(made, places, 1e-13);
}

/// Moves places by up to some 40 units in the last place of the largest coordinate.
void nudge(std::vector<Point>& places, double largest, std::uint64_t seed)
{
  Random random(seed);
  const double unit = roundingAt(largest) / 16.0;
  for (Point& p : places)
  {
    p.x += unit * (80.0 * random.unit() - 40.0);
    p.y += unit * (80.0 * random.unit() - 40.0);
  }
}

/// Near the edges of kept triangles, against the definition. Returns how many lie outside and have
/// values.
std::size_t expectAsDefined(
  SampledCase& given, const std::vector<std::int32_t>& triples, const unsigned char* kept)
{
  const SampleOracle oracle(given.points, triples);
  std::vector<Point> places = placesAmong(given.points, reduced(200), 2);
  double largest = 0.0;
  for (std::size_t h = 0; h < triples.size(); ++h)
  {
    const Point a = given.points[std::size_t(triples[h])];
    const Point b = given.points[std::size_t(triples[h % 3 == 2 ? h - 2 : h + 1])];
    places.push_back({ 0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y });
    places.push_back(a);
    largest = std::max({ largest, std::fabs(a.x), std::fabs(a.y) });
  }
  nudge(places, largest, 1);
  given.prepare(SampleMethod::Linear, kept);
  const std::vector<PointWeights> found = weightsAt(given.sampler, places);
  std::size_t count = 0;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    EXPECT_LE(differenceOf(found[k], oracle.linear(places[k])), 1e-12) << hexText(places[k]);
    const Location at = given.engine.made.locate(places[k]);
    count += !found[k].empty() && at.kind == Location::Outside ? 1 : 0;
  }
  return count;
}

TEST(SampleRim, ValuesAreThoseOfTheNearestPlaceOfARim)
{
  for (const Distribution d : { Distribution::Lattice, Distribution::Uniform,
         Distribution::OnCircle, Distribution::Utm, Distribution::NearlyCollinear })
  {
    SCOPED_TRACE(nameOf(d));
    SampledCase given(distinct(makePoints(d, 40, 1)));
    EXPECT_GT(expectAsDefined(given, given.triples(), nullptr), 5u);
  }
}

/// Points some units in the last place apart: several edges are within rounding.
TEST(SampleRim, AmongPointsAFewUnitsApart)
{
  for (const double step : { 0x1p-50, 0x1p-48, 0x1p-46 })
  {
    Random random(7);
    std::vector<Point> points;
    for (int k = 0; k < 40; ++k)
    {
      points.push_back(
        { 1.0 + step * double(random.below(12)), 1.5 + step * double(random.below(12)) });
    }
    SampledCase given(distinct(points));
    ASSERT_EQ(given.engine.made.makeCorners({}), Status::Ok);
    std::vector<unsigned char> kept(given.engine.made.triangleCount());
    std::vector<std::int32_t> triples;
    for (std::size_t t = 0; t < kept.size(); ++t)
    {
      kept[t] = random.below(2) != 0;
      for (HalfEdge h = HalfEdge(3 * t); kept[t] != 0 && h != 3 * t + 3; ++h)
      {
        triples.push_back(std::int32_t(given.engine.made.pointOf(given.engine.made.origin(h))));
      }
    }
    expectAsDefined(given, triples, kept.data());
  }
}

/// Sixteen units and no more, whatever the exponents.
TEST(SampleRim, SixteenUnitsInTheLastPlace)
{
  for (const double scale : { 1.0, 0x1p-1000, 0x1p-1060, 0x1p1000 })
  {
    const double x = 3.0 * scale, y = 2.0 * scale;
    SampledCase given({ { 0, 0 }, { x, 0 }, { x, y }, { 0, y } });
    const double unit = std::nextafter(x, HUGE_VAL) - x;
    std::vector<Point> places;
    for (const double units : { 15.0, 16.0, 17.0 })
    {
      const double by = units * unit;
      places.insert(
        places.end(), { { 0.5 * x, -by }, { -by, 0.5 * y }, { x + by, 0.5 * y }, { -by, 0.0 } });
    }
    given.prepare(SampleMethod::Linear);
    const std::vector<double> values{ 1.0, 2.0, 3.0, 4.0 };
    const SampledValues found = sample(given.sampler, SamplePlaces(viewOf(places)), values);
    for (std::size_t k = 0; k < 12; ++k)
    {
      EXPECT_EQ(found.mask[k], k < 8) << k << ' ' << scale;
    }
    EXPECT_EQ(found.report.outside, 4u);
    EXPECT_EQ(found.values[0], 1.5);
    EXPECT_EQ(found.values[3], 1.0);
    EXPECT_EQ(given.engine.made.locate(places[0]).kind, Location::Outside);
  }
}

/// Tenths that are not the same numbers as multiples of 0.1; with and without threads.
TEST(SampleRim, RastersAlongTheRimAreTheirPlaces)
{
  std::vector<Point> points;
  for (int k = 0; k < 70 * 70; ++k)
  {
    points.push_back({ (k % 70) / 10.0, (k / 70) / 10.0 });
  }
  SampledCase given(points);
  std::vector<double> values(points.size());
  std::iota(values.begin(), values.end(), 0.0);
  const SampleRaster raster{ { 0.0, 0.0 }, { 0.1, 0.1 }, 70, 70, 0, 0 };
  SampleRaster wider{ { -0.5, -0.5 }, { 0.05, 0.05 }, 161, 161, 0, 0 };
  ThreadExecutor threads(3);
  for (const SampleMethod method : kSurfaceMethods)
  {
    given.prepare(method);
    const bool slopes = method == SampleMethod::Linear;
    for (const SampleRaster& cells : { raster, wider })
    {
      const std::vector<Point> places = pointsOf(cells);
      const SampledValues one = sample(
        given.sampler, SamplePlaces(viewOf(places)), values, {}, slopes);
      EXPECT_TRUE(areSame(one, sample(given.sampler, SamplePlaces(cells), values, {}, slopes)));
      EXPECT_TRUE(areSame(
        one, sample(given.sampler, SamplePlaces(cells), values, { nullptr, &threads }, slopes)));
      EXPECT_EQ(one.report.outside, cells.columns == 70 ? 0u : 161u * 161u - 139u * 139u);
    }
  }
}

TEST(SampleRim, PointsOnALine)
{
  std::vector<Point> points;
  for (int k = 0; k < 10; ++k)
  {
    points.push_back({ 0.3 * k, 0.7 });
  }
  SampledCase given(points);
  const double unit = 0x1p-53; // of 0.7
  const std::vector<Point> places{ { 0.4, 0.7 + 15 * unit }, { 0.4, 0.7 + 18 * unit },
    { -unit, 0.7 }, { 2.8, 0.7 } };
  for (const SampleMethod method : kSurfaceMethods)
  {
    given.prepare(method);
    const SampledValues found = sample(
      given.sampler, SamplePlaces(viewOf(places)), xOf(points), {}, true);
    EXPECT_TRUE(areSame(found.mask, { 1, 0, 1, 0 }));
    EXPECT_NEAR(found.values[0], 0.4, 1e-15);
    EXPECT_EQ(found.values[2], 0.0);
    EXPECT_DOUBLE_EQ(found.gradients[4], 1.0);
  }
  SampledCase alone({ { 3.0, 3.0 } });
  alone.prepare(SampleMethod::Linear);
  const std::vector<Point> near{ { 3.0, 3.0 + 0x1p-50 }, { 3.0, 3.1 } };
  EXPECT_TRUE(areSame(sample(alone.sampler, SamplePlaces(viewOf(near)), { 5.0 }).mask, { 1, 0 }));
}

/// Values outside by `method`, with none inside.
std::vector<double> filled(SampledCase& given, SampleMethod method,
  const std::vector<Point>& places, const std::vector<double>& values)
{
  given.prepare(method);
  std::vector<double> out(places.size(), -77.0);
  const std::vector<unsigned char> mask(places.size(), 0);
  const SampleArray array{ values.data(), 1, out.data(), nullptr };
  EXPECT_EQ(fillOutside(given.sampler, SamplePlaces(viewOf(places)), &array, 1, mask.data(), {}),
    Status::Ok);
  return out;
}

/// Places that are not on the surface, near and far.
std::vector<Point> placesOutside(SampledCase& given, const std::vector<Point>& among)
{
  given.prepare(SampleMethod::Linear);
  const SampledValues found = sample(given.sampler, SamplePlaces(viewOf(among)), xOf(given.points));
  std::vector<Point> places;
  for (std::size_t k = 0; k < among.size(); ++k)
  {
    if (found.mask[k] == 0)
    {
      places.push_back(among[k]);
    }
  }
  return places;
}

std::vector<Point> around(const std::vector<Point>& points, std::size_t count)
{
  std::vector<Point> places = placesAmong(points, count, 4);
  Random random(11);
  for (std::size_t k = 0; k < count; ++k)
  {
    const double far = std::ldexp(1.0, int(random.below(90)));
    const Point p = points[random.below(points.size())];
    places.push_back({ p.x + far * (random.unit() - 0.5), p.y + far * (random.unit() - 0.5) });
  }
  return places;
}

TEST(SampleRim, BoundaryIsTheNearestPlace)
{
  ConstraintCase cases[] = { ring(), nestedLoops(4), starPolygon(12) };
  for (ConstraintCase& one : cases)
  {
    SampledCase given(one);
    const std::vector<std::int32_t> triples = given.triples();
    const SampleOracle oracle(given.points, triples);
    const std::vector<Point> places = placesOutside(given, around(given.points, reduced(80)));
    ASSERT_GT(places.size(), 20u);
    const std::vector<double> values = xOf(given.points);
    const std::vector<double> found = filled(given, SampleMethod::Linear, places, values);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      double expected = 0.0;
      for (const auto& weight : oracle.atRim(places[k]))
      {
        expected += weight.second * values[std::size_t(weight.first)];
      }
      ASSERT_NEAR(found[k], expected, 1e-11 * std::fabs(expected) + 1e-13) << hexText(places[k]);
    }
  }
}

/// Also from so far away that all distances round to the same number.
TEST(SampleRim, BoundaryOfAHull)
{
  SampledCase given(makePoints(Distribution::Uniform, 50, 1));
  const std::vector<std::int32_t> triples = given.triples();
  const SampleOracle oracle(given.points, triples);
  const std::vector<Point> places = placesOutside(given, around(given.points, reduced(200)));
  const std::vector<double> found = filled(
    given, SampleMethod::NaturalNeighbor, places, xOf(given.points));
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    double expected = 0.0;
    for (const auto& weight : oracle.atRim(places[k]))
    {
      expected += weight.second * given.points[std::size_t(weight.first)].x;
    }
    ASSERT_NEAR(found[k], expected, 1e-12) << hexText(places[k]);
  }
}

TEST(SampleRim, TheNearestVertexIsBehindNoWall)
{
  ConstraintCase cases[] = { ring(), nestedLoops(4), starPolygon(12) };
  std::size_t others = 0;
  for (ConstraintCase& one : cases)
  {
    SampledCase given(one);
    const std::vector<std::int32_t> triples = given.triples();
    const SampleOracle oracle(given.points, triples);
    given.prepare(SampleMethod::Nearest);
    const std::vector<Point> places = around(given.points, reduced(80));
    const std::vector<PointWeights> found = weightsAt(given.sampler, places);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      ASSERT_EQ(found[k], oracle.nearestInFront(places[k])) << hexText(places[k]);
      others += found[k] != oracle.nearest(places[k]) ? 1 : 0;
    }
  }
  EXPECT_GT(others, 15u);
}

/// A square with a slit: on the one side few points, on the other many.
TEST(SampleRim, ManyVerticesBehindAWall)
{
  ConstraintCase given;
  given.points = { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 }, { 5, 1 }, { 5.01, 1 }, { 5.01, 9 },
    { 5, 9 } };
  given.constraints.addLoop({ 0, 1, 2, 3 });
  given.constraints.addLoop({ 4, 5, 6, 7 });
  Random random(5);
  for (int k = 0; k < 3000; ++k)
  {
    given.points.push_back({ 5.02 + 0.5 * random.unit(), 1.5 + 7.0 * random.unit() });
  }
  SampledCase made(given);
  made.prepare(SampleMethod::Nearest);
  const std::vector<Point> places{ { 4.9, 5.0 }, { 5.005, 5.0 } };
  const std::vector<PointWeights> found = weightsAt(made.sampler, places);
  EXPECT_EQ(found[0].begin()->first, 4) << "of two as far away the smaller";
  EXPECT_GE(found[1].begin()->first, 8) << "in the slit both sides are seen";
}

/// Lines that bound nothing are no walls, nor are limits on size.
TEST(SampleRim, OtherConstraintsHideNoVertex)
{
  ConstraintCase given;
  given.points = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1.9, 2 }, { 2, 1 }, { 2, 3 } };
  given.constraints.addLine({ 5, 6 });
  SampledCase made(given);
  ASSERT_EQ(made.engine.made.makeCorners({}), Status::Ok);
  const std::vector<unsigned char> none(made.engine.made.triangleCount(), 0);
  for (const unsigned char* kept : { static_cast<const unsigned char*>(nullptr), none.data() })
  {
    made.prepare(SampleMethod::Nearest, kept);
    const std::vector<Point> places{ { 2.1, 2 }, { -5, -5 } };
    const std::vector<PointWeights> found = weightsAt(made.sampler, places);
    EXPECT_EQ(found[0].begin()->first, 4);
    EXPECT_EQ(found[1].begin()->first, 0);
  }
}

} // namespace
} // namespace test
} // namespace ahd
