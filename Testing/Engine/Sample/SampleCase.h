// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SampleCase_h
#define ahd_SampleCase_h

// A surface and its sampler, for the tests of Sample/.
#include "ConstraintMakers.h"
#include "Engine.h"
#include "EngineRun.h"
#include "ExactSigns.h"
#include "Random.h"
#include "SampleOracle.h"

#include "Sample/Sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace ahd
{
namespace test
{

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// A triangulation, and a sampler of it.
struct SampledCase
{
  explicit SampledCase(const std::vector<Point>& where, const Options& options = Options())
    : points(where)
  {
    EXPECT_EQ(engine.run(viewOf(points), options), Status::Ok);
  }
  explicit SampledCase(const ConstraintCase& given, FillRule rule = FillRule::EvenOdd)
    : points(given.points)
  {
    EXPECT_EQ(engine.run(viewOf(points)), Status::Ok);
    EXPECT_EQ(engine.constrain(given.constraints.view(), rule), Status::Ok);
  }

  void prepare(SampleMethod method, const unsigned char* kept = nullptr)
  {
    ASSERT_EQ(sampler.prepare(engine.made, kept, method, {}), Status::Ok);
  }

  /// Ids of the kept triangles.
  std::vector<std::int32_t> triples()
  {
    std::vector<std::int32_t> result(3 * engine.report().triangles);
    EXPECT_EQ(engine.writeTriangles(result.data()), Status::Ok);
    return result;
  }

  std::vector<Point> points;
  Engine engine;
  Sampler sampler;
};

/// All results of values() for one array.
struct SampledValues
{
  std::vector<double> values;
  std::vector<unsigned char> mask;
  std::vector<double> gradients;
  SampleReport report;
  Status status = Status::Ok;
};

inline SampledValues sample(const Sampler& sampler, const SamplePlaces& places,
  const std::vector<double>& values, const Context& context = Context(), bool slopes = false)
{
  SampledValues result;
  result.values.assign(places.count(), -77.0);
  result.mask.assign(places.count(), 77);
  result.gradients.assign(slopes ? 2 * places.count() : 0, -77.0);
  const SampleArray array{ values.data(), 1, result.values.data(),
    slopes ? result.gradients.data() : nullptr };
  result.status = sampler.values(places, &array, 1, result.mask.data(), result.report, context);
  return result;
}

template <typename T>
bool areSame(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline bool areSame(const SampledValues& a, const SampledValues& b)
{
  return areSame(a.values, b.values) && areSame(a.gradients, b.gradients) &&
    areSame(a.mask, b.mask) && std::memcmp(&a.report, &b.report, sizeof a.report) == 0;
}

inline std::vector<Point> pointsOf(const SampleRaster& raster)
{
  std::vector<Point> result;
  const SamplePlaces places(raster);
  for (std::size_t k = 0; k < places.count(); ++k)
  {
    result.push_back(places[k]);
  }
  return result;
}

/// Of the nine points with coordinates 0, 1 and 2 those whose bit is set.
inline std::vector<Point> someOfNine(unsigned mask)
{
  std::vector<Point> points;
  for (unsigned k = 0; k < 9; ++k)
  {
    if ((mask >> k & 1u) != 0)
    {
      points.push_back({ double(k % 3), double(k / 3) });
    }
  }
  return points;
}

/// In steps of a quarter, from `low` to `high` in x and y.
inline std::vector<Point> placesBetween(double low, double high)
{
  std::vector<Point> places;
  for (double y = low; y <= high; y += 0.25)
  {
    for (double x = low; x <= high; x += 0.25)
    {
      places.push_back({ x, y });
    }
  }
  return places;
}

/// The weights of each place.
inline std::vector<PointWeights> weightsAt(const Sampler& sampler, const std::vector<Point>& places)
{
  SampleWeights weights;
  SampleReport report;
  EXPECT_EQ(sampler.weights(SamplePlaces(viewOf(places)), weights, report, {}), Status::Ok);
  std::vector<PointWeights> result(places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    for (std::uint64_t i = weights.offsets[k]; i < weights.offsets[k + 1]; ++i)
    {
      EXPECT_GE(weights.weights[i], 0.0);
      EXPECT_EQ(result[k].count(weights.points[i]), 0u) << "twice";
      result[k][weights.points[i]] = weights.weights[i];
    }
  }
  return result;
}

inline double sumOf(const PointWeights& weights)
{
  double sum = 0.0;
  for (const auto& weight : weights)
  {
    sum += weight.second;
  }
  return sum;
}

/// The largest difference between weights; infinite if one has no value and the other has.
inline double differenceOf(const PointWeights& a, const PointWeights& b)
{
  double most = a.empty() == b.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (const auto& weight : a)
  {
    const auto found = b.find(weight.first);
    most = std::max(most, std::fabs(weight.second - (found == b.end() ? 0.0 : found->second)));
  }
  for (const auto& weight : b)
  {
    most = std::max(most, a.count(weight.first) == 0 ? weight.second : 0.0);
  }
  return most;
}

/// Places within the bounds of the points and somewhat beyond, on points, between two of them, and
/// anywhere.
inline std::vector<Point> placesAmong(
  const std::vector<Point>& points, std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Point> places;
  while (places.size() < count)
  {
    const Point a = points[random.below(points.size())], b = points[random.below(points.size())];
    const Point c = points[random.below(points.size())];
    const double t = 1.2 * random.unit() - 0.1, s = random.unit();
    const Point onLine{ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) };
    const Point middle{ 0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y };
    const Point anywhere{ onLine.x + s * (c.x - onLine.x), onLine.y + s * (c.y - onLine.y) };
    const Point choices[] = { a, middle, onLine, anywhere, anywhere, anywhere, anywhere, anywhere };
    places.push_back(choices[random.below(8)]);
  }
  return places;
}

/// Those of natural neighbours.
const SampleMethod kBoth[] = { SampleMethod::NaturalNeighbor, SampleMethod::Laplace };

inline std::vector<Point> distinct(std::vector<Point> points)
{
  std::sort(points.begin(), points.end(), lexicographicallyLess);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Finite places on and next to vertices, edges and the hull, and anywhere.
inline std::vector<Point> hardPlaces(const std::vector<Point>& points, std::size_t count)
{
  std::vector<Point> places = placesAmong(points, count, points.size());
  Random random(count);
  for (std::size_t k = 0; k < count; k += 4)
  {
    const Point a = points[random.below(points.size())], b = places[k];
    const double near = std::ldexp(1.0, -int(random.below(50)));
    places[k] = { a.x + near * (b.x - a.x), a.y + near * (b.y - a.y) };
  }
  places.erase(
    std::remove_if(places.begin(), places.end(), [](const Point& p) { return !isFinite(p); }),
    places.end());
  return places;
}

/// Natural neighbours' weights at these places against their definition.
inline void expectWeightsOfDefinition(SampledCase& given, const std::vector<Point>& places)
{
  const std::vector<std::int32_t> triples = given.triples();
  const SampleOracle oracle(given.points, triples);
  for (const SampleMethod method : kBoth)
  {
    given.prepare(method);
    const std::vector<PointWeights> found = weightsAt(given.sampler, places);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      SCOPED_TRACE(testing::Message() << hexText(places[k]) << ", method " << int(method));
      const PointWeights expected = method == SampleMethod::Laplace ? oracle.laplace(places[k])
                                                                    : oracle.sibson(places[k]);
      ASSERT_LE(differenceOf(found[k], expected), 1e-12);
      if (!expected.empty())
      {
        ASSERT_NEAR(sumOf(found[k]), 1.0, 1e-14);
      }
    }
  }
}

} // namespace test
} // namespace ahd

#endif
