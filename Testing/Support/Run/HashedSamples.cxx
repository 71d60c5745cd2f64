// SPDX-License-Identifier: BSD-3-Clause
#include "HashedResults.h"

#include "Hash.h"
#include "Random.h"
#include "Sample/Outside.h"
#include "Sample/Sample.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

constexpr std::size_t kFewPoints = 2000;
/// Of a row and of a column, where threads share the work: so many that linear values are made
/// triangle after triangle; the other methods have half as many.
constexpr std::size_t kManyCells = 200;
constexpr std::size_t kFewCells = 40;

PointView viewOf(const std::vector<Point>& points)
{
  return points.empty() ? PointView(static_cast<const double*>(nullptr), 0, 2)
                        : PointView(&points[0].x, points.size(), 2);
}

/// On points, halfway between two of them, on their line and anywhere.
std::vector<Point> placesAmong(const PointView& points, std::size_t count)
{
  Random random(3);
  std::vector<Point> places;
  for (std::size_t k = 0; k < count && points.count > 0; ++k)
  {
    const Point a = points[random.below(points.count)], b = points[random.below(points.count)];
    const Point c = points[k % points.count];
    const double t = 1.5 * random.unit() - 0.25, s = random.unit();
    const Point onLine{ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) };
    const Point choices[] = { a, { 0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y }, onLine,
      { onLine.x + s * (c.x - onLine.x), onLine.y + s * (c.y - onLine.y) } };
    places.push_back(choices[k % 4]);
  }
  return places;
}

/// So many cells each way, somewhat beyond the points.
SampleRaster rasterOver(const PointView& points, std::size_t cells)
{
  Bounds box;
  for (std::size_t i = 0; i < points.count; ++i)
  {
    const Point p = points[i];
    const bool isFirst = !(box.xmin <= box.xmax);
    if (isFinite(p))
    {
      box.xmin = isFirst ? p.x : std::min(box.xmin, p.x);
      box.xmax = isFirst ? p.x : std::max(box.xmax, p.x);
      box.ymin = isFirst ? p.y : std::min(box.ymin, p.y);
      box.ymax = isFirst ? p.y : std::max(box.ymax, p.y);
    }
  }
  const auto most = double(cells - 4);
  const Point spacing{ box.xmax / most - box.xmin / most, box.ymax / most - box.ymin / most };
  return { { box.xmin - 1.5 * spacing.x, box.ymin - 1.5 * spacing.y }, spacing, cells, cells };
}

/// Any number, two for each point; some are NaN.
std::vector<double> valuesFor(std::size_t count)
{
  Random random(4);
  std::vector<double> values;
  for (std::size_t k = 0; k < 2 * count; ++k)
  {
    values.push_back(k % 301 == 7 ? std::nan("") : 2.0 * random.unit() - 1.0);
  }
  return values;
}

/// A NaN is a NaN, whatever its sign.
void add(Hash& hash, const std::vector<double>& numbers)
{
  hash.add(numbers.size());
  for (const double number : numbers)
  {
    hash.add(std::isnan(number) ? std::nan("") : number);
  }
}

void add(Hash& hash, const SampleReport& report)
{
  for (const std::size_t count :
    { report.valued, report.outside, report.notFinite, report.withoutValue, report.leftOut })
  {
    hash.add(count);
  }
}

/// The values of a surface by one method.
class Sampled
{
public:
  Sampled(const PointView& points, const Way& way)
    : values_(valuesFor(points.count))
    , way_(way)
  {
  }

  /// False if a step failed.
  bool prepare(Triangulation& made, SampleMethod method)
  {
    method_ = method;
    return call([&] { return sampler_.prepare(made, nullptr, method, context()); }) &&
      call([&] { return nearest_.prepare(made, nullptr, SampleMethod::Nearest, context()); });
  }

  void addValues(const SamplePlaces& places)
  {
    std::vector<double> out(2 * places.count(), -7.0), slopes(2 * out.size(), -7.0);
    std::vector<unsigned char> mask(places.count(), 77);
    const bool hasSlopes = method_ == SampleMethod::Linear;
    const SampleArray array{ values_.data(), 2, out.data(), hasSlopes ? slopes.data() : nullptr };
    SampleReport report;
    if (call([&] { return sampler_.values(places, &array, 1, mask.data(), report, context()); }))
    {
      add(hash, out);
      add(hash, slopes);
      hash.add(mask);
      add(hash, report);
    }
    if (call([&] { return fillOutside(nearest_, places, &array, 1, mask.data(), context()); }))
    {
      add(hash, out);
    }
  }

  void addWeights(const SamplePlaces& places)
  {
    SampleWeights made;
    SampleReport report;
    if (call([&] { return sampler_.weights(places, made, report, context()); }))
    {
      hash.add(
        std::vector<std::uint64_t>(made.offsets.data(), made.offsets.data() + made.offsets.size()));
      hash.add(
        std::vector<std::int32_t>(made.points.data(), made.points.data() + made.points.size()));
      add(
        hash, std::vector<double>(made.weights.data(), made.weights.data() + made.weights.size()));
      add(hash, report);
    }
  }

  Hash hash;

private:
  Context context() const { return { way_.progress, way_.executor }; }

  template <typename Work>
  bool call(const Work& work)
  {
    const Status status = way_.call ? way_.call(work) : work();
    hash.add(status);
    return status == Status::Ok;
  }

  std::vector<double> values_;
  const Way& way_;
  SampleMethod method_ = SampleMethod::Linear;
  Sampler sampler_, nearest_;
};

std::string hashOf(Triangulation& made, const PointView& points, std::size_t cells, const Way& way)
{
  Sampled sampled(points, way);
  const std::vector<Point> places = placesAmong(points, cells * cells / 4);
  for (const SampleMethod method : { SampleMethod::Linear, SampleMethod::NaturalNeighbor,
         SampleMethod::Laplace, SampleMethod::Nearest })
  {
    if (sampled.prepare(made, method))
    {
      const bool isLinear = method == SampleMethod::Linear;
      sampled.addValues(SamplePlaces(rasterOver(points, isLinear ? cells : cells / 2)));
      sampled.addValues(SamplePlaces(viewOf(places)));
      sampled.addWeights(SamplePlaces(viewOf(places)));
    }
  }
  return sampled.hash.text();
}

std::string hashOf(const PointView& points, std::size_t cells, const Way& way)
{
  Engine engine;
  return engine.run(points, Options(), nullptr, way.executor) == Status::Ok
    ? hashOf(engine.made, points, cells, way)
    : "not triangulated";
}

std::string hashOf(const ConstraintCase& given, std::size_t cells, const Way& way)
{
  Engine engine;
  const PointView points = given.view();
  return engine.run(points, Options(), nullptr, way.executor) == Status::Ok &&
      engine.constrain(given.constraints.view(), FillRule::EvenOdd) == Status::Ok
    ? hashOf(engine.made, points, cells, way)
    : "not triangulated";
}

} // namespace

std::string hashOfSamples(const PointView& points, const Way& way)
{
  return hashOf(points, kFewCells, way);
}

std::string hashOfSamples(const ConstraintCase& given, const Way& way)
{
  return hashOf(given, kFewCells, way);
}

Hashes hashesOfSamples(const Way& way)
{
  Hashes result;
  for (const NamedPoints& given : pointsOfDistributions(kFewPoints))
  {
    result.push_back({ "sample/" + given.name, hashOfSamples(viewOf(given.points), way) });
  }
  for (const NamedCase& made : constraintCases())
  {
    result.push_back({ "sample/constrained/" + made.name, hashOfSamples(made.given, way) });
  }
  return result;
}

Hashes hashesOfManySamples(const Way& way)
{
  Hashes result;
  for (const NamedPoints& given : manyPoints())
  {
    result.push_back(
      { "sample/many/" + given.name, hashOf(viewOf(given.points), kManyCells, way) });
  }
  return result;
}

} // namespace test
} // namespace ahd
