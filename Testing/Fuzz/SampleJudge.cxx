// SPDX-License-Identifier: BSD-3-Clause
#include "SampleJudge.h"

#include "Judge.h"
#include "Sample/NearestSeen.h"
#include "Sample/Sample.h"
#include "SampleOracle.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr std::size_t kMostPointsToSample = 2000;
constexpr std::size_t kPlaces = 48;
constexpr std::size_t kFewForOracle = 6;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const SampleMethod kMethods[] = { SampleMethod::Linear, SampleMethod::NaturalNeighbor,
  SampleMethod::Laplace, SampleMethod::Nearest };

/// On points, halfway between two, with the x of one and the y of another, near one, and nowhere.
std::vector<Point> placesFor(const FuzzCase& given, const PointView& points)
{
  std::vector<Point> places{ { kNaN, 0.0 }, { 0.0, 0.0 } };
  const std::size_t n = points.count, step = 1 + given.head[kShuffle];
  for (std::size_t k = 0; k < kPlaces && n > 0; ++k)
  {
    const Point a = points[k * step % n], b = points[(k * 7 + step) % n];
    const double t = double(given.head[k % kHeadBytes]) / 256.0;
    const Point choices[] = { a, { 0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y }, { a.x, b.y },
      { a.x + t * (b.x - a.x), b.y + t * (a.y - b.y) } };
    places.push_back(choices[k % 4]);
  }
  return places;
}

/// Sampled once, by one method, with all results.
class Judgement
{
public:
  Judgement(const FuzzCase& given, const ToSample& surface, SampleMethod method)
    : given_(given)
    , surface_(surface)
    , method_(method)
    , places_(placesFor(given, surface.points))
  {
    for (std::size_t i = 0; i < surface.points.count; ++i)
    {
      values_.push_back(double(i * 37 % 101) - 50.0);
      const Point p = surface.points[i];
      largest_ = std::max(largest_, isFinite(p) ? sizeOf(p) : 0.0);
    }
  }

  void judge()
  {
    const Context context{ nullptr, surface_.executor };
    is(sampler_.prepare(surface_.made, nullptr, method_, context) == Status::Ok, "prepared");
    is(sampler_.weights(list(), weights_, counts_, context) == Status::Ok, "weighed");
    out_.assign(places_.size(), -7.0);
    mask_.assign(places_.size(), 77);
    SampleReport report;
    is(valuesAt(list(), out_, mask_, report, nullptr) == Status::Ok, "sampled");
    is(report.valued == counts_.valued && report.outside == counts_.outside &&
        report.notFinite == counts_.notFinite &&
        report.valued + report.outside + report.notFinite == places_.size(),
      "each place is counted once");
    for (std::size_t k = 0; k < places_.size(); ++k)
    {
      expectWeights(k);
      expectWhere(k);
    }
    expectRaster();
    expectOracle();
    expectStops(given_,
      [&](Progress* progress)
      {
        SampleReport some;
        SampleWeights again;
        Sampler other;
        const Context own{ progress, surface_.executor };
        const Status status = other.prepare(surface_.made, nullptr, method_, own);
        return status != Status::Ok ? status : other.weights(list(), again, some, own);
      });
  }

private:
  void is(bool isTrue, const char* what) const { expect(isTrue, what, given_); }

  SamplePlaces list() const { return SamplePlaces(PointView(&places_[0].x, places_.size(), 2)); }

  Status valuesAt(const SamplePlaces& places, std::vector<double>& out,
    std::vector<unsigned char>& mask, SampleReport& report, Progress* progress) const
  {
    const SampleArray array{ values_.data(), 1, out.data(), nullptr };
    return sampler_.values(places, &array, 1, mask.data(), report, { progress, surface_.executor });
  }

  /// Those of a place: each of a vertex, once, not below 0, together 1; the value is made of them.
  void expectWeights(std::size_t k) const
  {
    const std::uint64_t begin = weights_.offsets[k], end = weights_.offsets[k + 1];
    is((mask_[k] == 1) == (begin != end) && mask_[k] <= 1, "the mask says where weights are");
    if (begin == end)
    {
      is(std::isnan(out_[k]), "no value outside");
      return;
    }
    std::set<std::int32_t> ids;
    double sum = 0.0, value = 0.0;
    for (std::uint64_t i = begin; i < end; ++i)
    {
      const std::int32_t id = weights_.points[i];
      is(id >= 0 && std::size_t(id) < values_.size() && ids.insert(id).second, "ids of points");
      is(isFinite(surface_.points[std::size_t(id)]), "of finite points");
      is(weights_.weights[i] >= 0.0 && weights_.weights[i] <= 1.0, "a weight is 0 to 1");
      sum += weights_.weights[i];
      value += weights_.weights[i] * values_[std::size_t(id)];
    }
    is(std::fabs(sum - 1.0) <= 1e-11, "weights sum to 1");
    is(std::memcmp(&value, &out_[k], sizeof value) == 0, "the value is that of the weights");
    if (method_ != SampleMethod::Nearest && begin + 1 == end)
    {
      is(isAtItsWeights(k) && weights_.weights[begin] == 1.0,
        "one weight alone is that of a vertex at its place");
    }
  }

  /// Does it lie where its weights put it, but for rounding? With one weight, the other end of the
  /// edge that it is at may be any point.
  bool isAtItsWeights(std::size_t k) const
  {
    constexpr double kRounding = 0x1p-46; // 16 units in the last place, and of the sums
    double x = 0.0, y = 0.0, largest = std::max(largest_, sizeOf(places_[k]));
    for (std::uint64_t i = weights_.offsets[k]; i < weights_.offsets[k + 1]; ++i)
    {
      const Point p = surface_.points[std::size_t(weights_.points[i])];
      x += weights_.weights[i] * (p.x / 2.0 - places_[k].x / 2.0);
      y += weights_.weights[i] * (p.y / 2.0 - places_[k].y / 2.0);
    }
    const double most = kRounding * largest + 0x1p-1069;
    return std::fabs(x) <= most && std::fabs(y) <= most;
  }

  bool hasKept() const { return surface_.made.report().triangles > 0; }

  /// locate() agrees.
  void expectWhere(std::size_t k) const
  {
    const Location found = surface_.made.locate(places_[k]);
    const bool isAnywhere = isFinite(places_[k]) && surface_.made.vertexCount() > 0 &&
      (hasKept() || surface_.made.triangleCount() == 0);
    if (method_ == SampleMethod::Nearest)
    {
      is((mask_[k] == 1) == isAnywhere, "there is a nearest vertex everywhere");
    }
    else if (found.kind == Location::InTriangle)
    {
      is(surface_.made.isKept(found.halfEdge / 3) ? mask_[k] == 1
                                                  : mask_[k] == 0 || isAtItsWeights(k),
        "valued in kept triangles, or at their rim");
    }
    else if (found.kind == Location::Outside)
    {
      is(mask_[k] == 0 || isAtItsWeights(k), "no value outside of the hull");
    }
  }

  /// A raster gives the same bytes as its places.
  void expectRaster() const
  {
    const std::size_t last = places_.size() - 1;
    const Point a = places_[last], b = places_[last / 2];
    SampleRaster raster;
    raster.columns = 9;
    raster.rows = 7;
    raster.spacing = { std::fabs(b.x / 6.0 - a.x / 6.0), std::fabs(b.y / 4.0 - a.y / 4.0) };
    raster.origin = { std::min(a.x, b.x) - raster.spacing.x,
      std::min(a.y, b.y) - raster.spacing.y };
    const SamplePlaces cells(raster);
    std::vector<Point> places;
    for (std::size_t k = 0; k < cells.count(); ++k)
    {
      places.push_back(cells[k]);
    }
    std::vector<double> some(places.size(), -7.0), same(places.size(), -7.0);
    std::vector<unsigned char> mask(places.size(), 77), other(places.size(), 77);
    SampleReport report, again;
    is(valuesAt(cells, some, mask, report, nullptr) == Status::Ok &&
        valuesAt(SamplePlaces(PointView(&places[0].x, places.size(), 2)), same, other, again,
          nullptr) == Status::Ok,
      "a raster is sampled");
    is(mask == other && report.valued == again.valued, "a raster is its places");
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      is(mask[k] == 0 ? std::isnan(some[k]) && std::isnan(same[k])
                      : std::memcmp(&some[k], &same[k], sizeof(double)) == 0,
        "values of a raster are those of its places");
    }
  }

  /// Are they so small that natural weights have the accuracy promised for shapes that are not
  /// flat?
  bool areSmallIntegers(const std::vector<Point>& points) const
  {
    return std::all_of(points.begin(), points.end(),
      [](const Point& p)
      {
        return std::fabs(p.x) <= 1024 && std::fabs(p.y) <= 1024 && p.x == std::floor(p.x) &&
          p.y == std::floor(p.y);
      });
  }

  void expectOracle() const
  {
    std::vector<Point> points;
    for (std::size_t i = 0; i < surface_.points.count && i <= kFewForOracle; ++i)
    {
      points.push_back(surface_.points[i]);
    }
    const bool areAll = points.size() <= kFewForOracle &&
      surface_.made.vertexCount() == points.size() && surface_.made.triangleCount() > 0;
    const bool isWhole = 3 * surface_.made.triangleCount() == surface_.triples.size();
    const bool isNatural = method_ == SampleMethod::NaturalNeighbor ||
      method_ == SampleMethod::Laplace;
    if (!areAll ||
      (isNatural &&
        !(isWhole && surface_.made.constraints().edges == 0 && areSmallIntegers(points))))
    {
      return;
    }
    const test::SampleOracle oracle(points, surface_.triples);
    for (std::size_t k = 0; k < places_.size(); ++k)
    {
      if (isFinite(places_[k]))
      {
        compare(k, byOracle(oracle, places_[k]), isNatural ? 2e-8 : 1e-11);
      }
    }
  }

  test::PointWeights byOracle(const test::SampleOracle& oracle, const Point& place) const
  {
    return method_ == SampleMethod::Linear       ? oracle.linear(place)
      : method_ == SampleMethod::Nearest         ? oracle.nearestInFront(place)
      : method_ == SampleMethod::NaturalNeighbor ? oracle.sibson(place)
                                                 : oracle.laplace(place);
  }

  void compare(std::size_t k, test::PointWeights expected, double most) const
  {
    is(expected.empty() == (mask_[k] == 0), "there is a value where the oracle has one");
    for (std::uint64_t i = weights_.offsets[k]; i < weights_.offsets[k + 1]; ++i)
    {
      double& left = expected[weights_.points[i]];
      left -= weights_.weights[i];
    }
    for (const auto& weight : expected)
    {
      is(std::fabs(weight.second) <= most, "weights are those of the definition");
    }
  }

  const FuzzCase& given_;
  const ToSample& surface_;
  SampleMethod method_;
  std::vector<Point> places_;
  double largest_ = 0.0; ///< coordinate of the points
  std::vector<double> values_, out_;
  std::vector<unsigned char> mask_;
  Sampler sampler_;
  SampleWeights weights_;
  SampleReport counts_;
};

} // namespace

void expectSamples(const FuzzCase& given, const ToSample& surface)
{
  if (surface.points.count > kMostPointsToSample)
  {
    return;
  }
  expect(surface.made.makeNeighbors({ nullptr, surface.executor }) == Status::Ok, "tables", given);
  Judgement(given, surface, kMethods[given.head[kMergeDistance] % 4]).judge();
}

} // namespace fuzz
} // namespace ahd
