// SPDX-License-Identifier: BSD-3-Clause
#include "EngineRun.h"

#include <algorithm>

namespace ahd
{
namespace test
{
namespace
{

void compare(std::string& faults, const char* what, std::size_t reported, std::size_t counted)
{
  if (reported != counted)
  {
    faults += std::string("report: ") + what + " is " + std::to_string(reported) + ", counted " +
      std::to_string(counted) + "\n";
  }
}

} // namespace

Outcome triangulate(
  Engine& engine, const PointView& points, const Options& options, Progress* progress)
{
  Outcome outcome;
  outcome.status = engine.run(points, options, progress);
  outcome.report = engine.report();
  if (outcome.status != Status::Ok)
  {
    return outcome;
  }
  outcome.triples.resize(3 * outcome.report.triangles, -7);
  outcome.status = engine.writeTriangles(outcome.triples.data(), progress);
  if (outcome.status != Status::Ok)
  {
    outcome.triples.clear();
    return outcome;
  }
  outcome.pointStatus.resize(points.count, -7);
  outcome.status = engine.writePointStatus(outcome.pointStatus.data(), progress);
  if (outcome.status != Status::Ok)
  {
    outcome.triples.clear();
    outcome.pointStatus.clear();
  }
  return outcome;
}

Outcome triangulate(const PointView& points, const Options& options)
{
  Engine engine;
  return triangulate(engine, points, options);
}

Outcome triangulate(const std::vector<Point>& points, const Options& options)
{
  return triangulate(viewOf(points), options);
}

PointView viewOf(const std::vector<Point>& points)
{
  static_assert(sizeof(Point) == 2 * sizeof(double), "points are read as pairs of doubles");
  return points.empty() ? PointView(static_cast<const double*>(nullptr), 0, 2)
                        : PointView(&points[0].x, points.size(), 2);
}

std::string faultsOf(const PointView& points, const Outcome& outcome)
{
  if (outcome.status != Status::Ok)
  {
    return "status " + std::to_string(int(outcome.status)) + " instead of Ok\n";
  }
  std::string faults = joined(certify(points, outcome.triples, outcome.pointStatus));
  const auto count = [&](auto isIt)
  {
    std::size_t result = 0;
    for (std::size_t i = 0; i < outcome.pointStatus.size(); ++i)
    {
      result += isIt(outcome.pointStatus[i], std::int64_t(i)) ? 1 : 0;
    }
    return result;
  };
  using Id = std::int64_t;
  const Report& report = outcome.report;
  compare(faults, "inserted", report.inserted, count([](Id f, Id i) { return f == i; }));
  compare(
    faults, "duplicates", report.duplicates, count([](Id f, Id i) { return f >= 0 && f != i; }));
  compare(faults, "notFinite", report.notFinite, count([](Id f, Id) { return f == -1; }));
  compare(faults, "skipped", report.skipped, count([](Id f, Id) { return f == -2; }));
  compare(faults, "triangles", report.triangles, outcome.triples.size() / 3);
  return faults;
}

std::string faultsOf(const std::vector<Point>& points, const Outcome& outcome)
{
  return faultsOf(viewOf(points), outcome);
}

std::vector<Options> everySetting(const std::vector<int>& nmax)
{
  std::vector<Options> result;
  for (int order = 0; order < 4; ++order)
  {
    for (int control = 0; control < 3; ++control)
    {
      for (const int limit : nmax)
      {
        for (const bool genes : { true, false })
        {
          Options options;
          options.order = InsertionOrder(order);
          options.controlPoints = ControlPoints(control);
          options.geneRotation = genes;
          options.nmax = limit;
          result.push_back(options);
        }
      }
    }
  }
  return result;
}

std::vector<Options> everyDistinctSetting(const std::vector<int>& nmax)
{
  std::vector<Options> result = everySetting(nmax);
  const auto isRepeat = [&](const Options& o)
  {
    const bool hasControlPoints = o.order == InsertionOrder::AdaptiveHilbert ||
      o.order == InsertionOrder::MultiGrid;
    return (!hasControlPoints && o.controlPoints != ControlPoints::Off) ||
      (o.order != InsertionOrder::AdaptiveHilbert && o.geneRotation) ||
      (o.order == InsertionOrder::AsGiven && o.nmax != nmax.front());
  };
  result.erase(std::remove_if(result.begin(), result.end(), isRepeat), result.end());
  return result;
}

std::string describe(const Options& options)
{
  static const char* const kOrders[] = { "HG", "MG", "RG", "as given" };
  return std::string(kOrders[int(options.order)]) + ", control points " +
    std::to_string(int(options.controlPoints)) + ", genes " +
    (options.geneRotation ? "on" : "off") + ", Nmax " + std::to_string(options.nmax);
}

std::size_t reduced(std::size_t n)
{
#ifdef AHD_REDUCED_TESTS
  return n <= 1000 ? n : std::max<std::size_t>(1000, n / 20);
#else
  return n;
#endif
}

std::size_t affordable(Distribution distribution, std::size_t n)
{
  const bool isWide = distribution == Distribution::TinyAndHuge ||
    distribution == Distribution::AnyFinite;
  return isWide ? std::max<std::size_t>(80, reduced(n) / 50) : reduced(n);
}

} // namespace test
} // namespace ahd
