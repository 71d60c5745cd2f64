// SPDX-License-Identifier: BSD-3-Clause
//
// Natural neighbours and slopes where doubles, and doubles of 106 bits, are not enough: points one
// unit in the last place apart, lattices that nearly coincide, axes of unlike units, coordinates of
// any exponent. Weights against their definition in rational arithmetic, slopes against rationals.
#include "Executors.h"
#include "SampleCase.h"

#include <gmpxx.h>

namespace ahd
{
namespace test
{
namespace
{

void expectWeights(const std::vector<Point>& points, std::size_t count)
{
  SampledCase given(distinct(points));
  ASSERT_FALSE(given.triples().empty());
  expectWeightsOfDefinition(given, hardPlaces(given.points, count));
}

std::vector<Point> stretched(std::vector<Point> points, double x, double y = 1.0)
{
  for (Point& p : points)
  {
    p = { p.x * x, p.y * y };
  }
  return points;
}

/// All of these x with all of these y.
std::vector<Point> grid(const std::vector<double>& x, const std::vector<double>& y)
{
  std::vector<Point> points;
  for (const double b : y)
  {
    for (const double a : x)
    {
      points.push_back({ a, b });
    }
  }
  return points;
}

TEST(SampleHard, APointAndItsCopyNextToIt)
{
  for (const double gap : { 0x1p-53, 0x1p-45, 0x1p-30 })
  {
    expectWeights(
      { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0.5, 0.5 }, { 0.5 + gap, 0.5 } }, reduced(200));
  }
}

/// Steps multiplied, and steps added up.
TEST(SampleHard, LatticesThatNearlyCoincide)
{
  std::vector<double> multiples, sums;
  double sum = 0.0;
  for (int i = 0; i < 10; ++i, sum += 0.1)
  {
    if (i > 4)
    {
      multiples.push_back(i * 0.1);
      sums.push_back(sum);
    }
  }
  std::vector<Point> points = grid(multiples, multiples);
  const std::vector<Point> others = grid(sums, sums);
  points.insert(points.end(), others.begin(), others.end());
  expectWeights(points, reduced(60));
}

TEST(SampleHard, AxesOfUnlikeUnits)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 14, 5);
  for (const double factor : { 1e6, 1e9, 1e12, 1e40, 1e150, 1e300, 1e-12, 1e-150, 1e-300 })
  {
    SCOPED_TRACE(factor);
    ASSERT_NO_FATAL_FAILURE(expectWeights(stretched(points, factor), reduced(60)));
    ASSERT_NO_FATAL_FAILURE(expectWeights(stretched(points, 1.0, factor), reduced(20)));
  }
}

/// So far from 0 that coordinates are a few units in the last place apart.
TEST(SampleHard, CoordinatesAFewUnitsApart)
{
  Random random(3);
  for (int run = 0; run < 4; ++run)
  {
    std::vector<Point> points;
    for (int k = 0; k < 14; ++k)
    {
      points.push_back({ 431234.5 + 0x1p-34 * double(random.below(6)),
        5712345.25 + 0x1p-30 * double(random.below(6)) });
    }
    ASSERT_NO_FATAL_FAILURE(expectWeights(points, reduced(40)));
  }
}

TEST(SampleHard, CirclesAndSpikes)
{
  for (const Distribution d :
    { Distribution::OnCircle, Distribution::OnParabola, Distribution::NearlyCollinear,
      Distribution::Slivers, Distribution::NestedClusters, Distribution::CrowdedBox })
  {
    SCOPED_TRACE(nameOf(d));
    ASSERT_NO_FATAL_FAILURE(expectWeights(makePoints(d, 14, 8), reduced(60)));
    ASSERT_NO_FATAL_FAILURE(expectWeights(stretched(makePoints(d, 10, 9), 1e7, 1e-7), reduced(20)));
  }
}

TEST(SampleHard, AnyExponents)
{
  for (const Distribution d :
    { Distribution::TinyAndHuge, Distribution::AnyFinite, Distribution::Tiny, Distribution::Huge })
  {
    for (const std::uint64_t seed : { 1, 2, 3, 4 })
    {
      SCOPED_TRACE(testing::Message() << nameOf(d) << ", " << seed);
      ASSERT_NO_FATAL_FAILURE(expectWeights(makePoints(d, 7, seed), reduced(20)));
    }
  }
  std::vector<Point> axes;
  for (const double x : { 0x1p-1074, 0x1p-500, 1.0, 0x1p1023 })
  {
    axes.insert(axes.end(), { { x, 0 }, { -x, 0 }, { 0, x }, { 0, -x } });
  }
  expectWeights(axes, reduced(20));
}

/// The squared distances of two neighbours underflow, those of the others do not.
TEST(SampleHard, NeighborsNextToThePlace)
{
  for (const double far : { 1.0, 0x1p190 })
  {
    for (const double near : { 0x1p-535, 0x1p-537, 0x1p-450, 0x1p-300 })
    {
      SampledCase given({ { -far, -1.25 * far }, { 1.5 * far, -far }, { far, far }, { -far, far },
        { 0.9 * near, 0.3 * near }, { -0.7 * near, 0.25 * near } });
      ASSERT_NO_FATAL_FAILURE(expectWeightsOfDefinition(
        given, { { 0, 0 }, { 0.1 * near, 0 }, { 0, 0x1p-20 * near }, { 0.5 * far, 2 * near } }))
        << far << " " << near;
    }
  }
}

/// Seen from the place, the ends of an edge of the hull lie opposite to each other, up to hundreds
/// of bits.
TEST(SampleHard, PlacesNextToADiagonal)
{
  SampledCase given({ { -1, -1 }, { 1, 1 }, { -1, 1 }, { -0.5, 0.75 } });
  std::vector<Point> places;
  for (const double near : { 0x1p-60, 0x1p-130, 0x1p-200, 0x1p-300, 0x1p-900, 0x1p-1074 })
  {
    places.insert(places.end(), { { -near, 0 }, { 0, near }, { -0.25, -0.25 + near } });
  }
  expectWeightsOfDefinition(given, places);
}

/// A wall through clusters: on either side the result is as if the other side had no points.
TEST(SampleHard, NothingIsSeenBeyondAConstraint)
{
  Random random(7);
  std::vector<Point> left{ { 0, 0 }, { 0, 1 }, { 0.5, 0 }, { 0.5, 1 } };
  for (int k = 0; k < 8; ++k)
  {
    left.push_back({ 0.25 + 0x1p-52 * double(random.below(9)), 0.1 * random.unit() });
  }
  left = distinct(left);
  ConstraintCase given;
  given.points = left;
  for (int k = 0; k < 8; ++k)
  {
    given.points.push_back({ 1.0 - 0.4 * random.unit(), random.unit() });
  }
  const auto idOf = [&](const Point& p)
  { return std::int64_t(std::find(left.begin(), left.end(), p) - left.begin()); };
  given.constraints.addLine({ idOf({ 0.5, 0 }), idOf({ 0.5, 1 }) });
  for (const double factor : { 1.0, 1e9 })
  {
    ConstraintCase wide = given;
    wide.points = stretched(given.points, factor);
    SampledCase whole(wide), half(stretched(left, factor));
    const std::vector<std::int32_t> triples = half.triples();
    const SampleOracle oracle(half.points, triples);
    std::vector<Point> places;
    while (places.size() < reduced(60))
    {
      places.push_back({ 0.5 * factor * random.unit(), random.unit() });
    }
    for (const SampleMethod method : kBoth)
    {
      whole.prepare(method);
      const std::vector<PointWeights> found = weightsAt(whole.sampler, places);
      for (std::size_t k = 0; k < places.size(); ++k)
      {
        ASSERT_LE(
          differenceOf(found[k],
            method == SampleMethod::Laplace ? oracle.laplace(places[k]) : oracle.sibson(places[k])),
          1e-12)
          << hexText(places[k]) << ", method " << int(method);
      }
    }
  }
}

/// The same bytes from one thread and several, on a raster and at its places in another order.
TEST(SampleHard, ThreadsAndOtherPlacesHaveNoSay)
{
  ThreadExecutor threads(3);
  for (const double factor : { 1e12, 1e150 })
  {
    SampledCase given(stretched(makePoints(Distribution::Uniform, 300, 1), factor));
    const SampleRaster raster{ { 0.0, 0.0 }, { factor / 60, 1.0 / 40 }, 60, 40 };
    std::vector<Point> places = pointsOf(raster);
    std::reverse(places.begin(), places.end());
    std::vector<double> values;
    for (std::size_t k = 0; k < given.points.size(); ++k)
    {
      values.push_back(double(k % 7));
    }
    for (const SampleMethod method : kBoth)
    {
      given.prepare(method);
      const SampledValues alone = sample(given.sampler, SamplePlaces(raster), values);
      EXPECT_TRUE(
        areSame(alone, sample(given.sampler, SamplePlaces(raster), values, { nullptr, &threads })));
      SampledValues other = sample(
        given.sampler, SamplePlaces(viewOf(places)), values, { nullptr, &threads });
      std::reverse(other.values.begin(), other.values.end());
      std::reverse(other.mask.begin(), other.mask.end());
      EXPECT_TRUE(areSame(alone, other));
      EXPECT_GT(alone.report.valued, 1000u);
    }
  }
}

// ------------------------------------------------------------------------------------------ slopes

/// The error of the slopes in this triangle, over the larger of them.
double errorOfSlopes(const Point (&p)[3], const double (&value)[3])
{
  const mpq_class ux = mpq_class(p[1].x) - mpq_class(p[0].x),
                  uy = mpq_class(p[1].y) - mpq_class(p[0].y),
                  vx = mpq_class(p[2].x) - mpq_class(p[0].x),
                  vy = mpq_class(p[2].y) - mpq_class(p[0].y),
                  u = mpq_class(value[1]) - mpq_class(value[0]),
                  v = mpq_class(value[2]) - mpq_class(value[0]), area = ux * vy - uy * vx;
  const mpq_class x = (u * vy - v * uy) / area, y = (ux * v - vx * u) / area;
  const mpq_class most = std::max(mpq_class(abs(x)), mpq_class(abs(y)));
  SampledCase given(std::vector<Point>(p, p + 3));
  given.prepare(SampleMethod::Linear);
  const SampledValues found = sample(given.sampler, SamplePlaces(viewOf(given.points)),
    { value[0], value[1], value[2] }, Context(), true);
  double error = 0.0;
  for (std::size_t k = 0; k != 3; ++k)
  {
    const double slope[2] = { found.gradients[2 * k], found.gradients[2 * k + 1] };
    if (!std::isfinite(slope[0]) || !std::isfinite(slope[1]))
    {
      return std::numeric_limits<double>::infinity();
    }
    const mpq_class off = abs(mpq_class(slope[0]) - x) + abs(mpq_class(slope[1]) - y);
    error = most == 0 ? off.get_d() : std::max(error, mpq_class(off / most).get_d());
  }
  return error;
}

/// Wherever the larger slope is a double that keeps its bits.
TEST(SampleHard, SlopesOfValuesAndCoordinatesOfAnyExponent)
{
  for (const double size : { 1.0, 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1023 })
  {
    for (const double flat : { 1.0, 0x1p-20, 0x1p-45, 0x1p-51 })
    {
      const Point p[3] = { { 0, 0 }, { size, flat * size / 3 }, { 0.3 * size, 0.7 * flat * size } };
      for (const double height : { 1.0, 0x1p-1050, 0x1p-1000, 0x1p-450, 0x1p450, 0x1p1022 })
      {
        const int exponent = std::ilogb(height) - std::ilogb(size);
        if (exponent > -900 && exponent - std::ilogb(flat) < 1000)
        {
          EXPECT_LE(errorOfSlopes(p, { 0.0, height, 0.3 * height }), 1e-9)
            << size << " " << flat << " " << height;
          EXPECT_LE(errorOfSlopes(p, { -height, height, 0.2 * height }), 1e-9)
            << size << " " << flat << " " << height;
        }
      }
    }
  }
}

TEST(SampleHard, SlopesAlongALine)
{
  for (const double size : { 1.0, 0x1p-900, 0x1p1000 })
  {
    for (const double height : { 1.0, 0x1p-1072, 0x1p-450, 0x1p900, 0x1p1023 })
    {
      const int exponent = std::ilogb(height) - std::ilogb(size);
      if (exponent < -1000 || exponent > 1000)
      {
        continue;
      }
      for (const Point& to : { Point{ 0.75 * size, 0 }, Point{ 0, 0.75 * size } })
      {
        SampledCase given({ { 0, 0 }, to });
        given.prepare(SampleMethod::Linear);
        const SampledValues found = sample(
          given.sampler, SamplePlaces(viewOf(given.points)), { -height, height }, Context(), true);
        const double expected = std::ldexp(2.0 / 0.75, exponent);
        EXPECT_DOUBLE_EQ(found.gradients[to.x == 0.0 ? 1 : 0], expected) << size << " " << height;
        EXPECT_EQ(found.gradients[to.x == 0.0 ? 0 : 1], 0.0) << size << " " << height;
      }
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
