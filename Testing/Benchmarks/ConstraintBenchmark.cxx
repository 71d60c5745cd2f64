// SPDX-License-Identifier: BSD-3-Clause
//
// The cost of constraints, beside CGAL's Constrained_Delaunay_triangulation_2 on the same points
// and segments, one thread, by its CPU time. `plain` is the triangulation alone; `constrained` that
// and the constraints; `two` the same by two threads, by the clock on the wall; `cgal` CGAL's
// points and then its constraints, without ids. Each is timed from the points to the triangles
// written (CGAL: to its data structure); `constrain` is the time of the constraints alone, given
// for CGAL as well.
//
// Shapes and numbers of segments depend on --points; see shapes().
#include "BesideCgal.h"
#include "Core/Threads.h"
#include "Places.h"
#include "Random.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace ahd;
using namespace ahd::test;

/// All edges of the triangulation of n uniform points, each once: they are there already.
ConstraintCase edgesThatAreThere(std::size_t n)
{
  ConstraintCase result;
  result.points = makePoints(Distribution::Uniform, n, 21);
  Workspace workspace;
  Triangulation made;
  triangulate(result.view(), Options(), workspace, {}, made);
  std::vector<std::int32_t> triples(3 * made.report().triangles);
  made.writeTriangles(triples.data(), {});
  for (std::size_t h = 0; h < triples.size(); ++h)
  {
    const std::int32_t from = triples[h];
    const std::int32_t to = triples[h % 3 == 2 ? h - 2 : h + 1];
    if (from < to) // the others are seen from the other side, but for some of the hull
    {
      result.constraints.addLine({ from, to });
    }
  }
  return result;
}

/// The rows of a lattice, each a chain: as outlines would bring edges that are there.
ConstraintCase rowsOfALattice(std::size_t n)
{
  ConstraintCase result;
  result.points = makePoints(Distribution::Lattice, n, 1);
  const std::size_t side = latticeSide(n);
  for (std::size_t row = 0; (row + 1) * side <= n; ++row)
  {
    Chain chain;
    for (std::size_t i = 0; i < side; ++i)
    {
      chain.push_back(std::int64_t(row * side + i));
    }
    result.constraints.addLine(chain);
  }
  return result;
}

/// Takes a neighbour out of one of the lists, and the way back out of its list. -1 if there is
/// none.
std::int64_t takeWay(std::vector<std::vector<std::int64_t>>& ways, std::int64_t from)
{
  std::vector<std::int64_t>& out = ways[std::size_t(from)];
  if (out.empty())
  {
    return -1;
  }
  const std::int64_t to = out.back();
  out.pop_back();
  std::vector<std::int64_t>& back = ways[std::size_t(to)];
  back.erase(std::remove(back.begin(), back.end(), from), back.end());
  return to;
}

/// n / 10 breaklines of five segments among n points, in no order: ways along the edges of the
/// triangulation of every third point, each edge once. So none crosses another, and most of their
/// segments are no edges of the triangulation of all points.
ConstraintCase breaklines(std::size_t n)
{
  constexpr std::size_t kSegments = 5;
  const ConstraintCase edges = edgesOfOthers(n, n);
  ConstraintCase result;
  result.points = edges.points;
  std::vector<std::vector<std::int64_t>> ways(n);
  for (const GivenSegment& edge : segmentsOf(edges.constraints.view()))
  {
    ways[std::size_t(edge.from)].push_back(edge.to);
    ways[std::size_t(edge.to)].push_back(edge.from);
  }
  Random random(22);
  for (std::size_t line = 0; line < n / 10;)
  {
    Chain chain(1, std::int64_t(random.below(n)));
    for (std::int64_t to = 0; chain.size() <= kSegments && to >= 0;)
    {
      to = takeWay(ways, chain.back());
      chain.push_back(to);
    }
    if (chain.back() >= 0)
    {
      result.constraints.addLine(chain);
      ++line;
    }
  }
  return result;
}

/// A loop of n / 10 points around a circle, and uniform points around its middle that make n.
ConstraintCase ringAmongPoints(std::size_t n)
{
  ConstraintCase result;
  result.points = makePoints(Distribution::Uniform, n - n / 10, 23);
  Chain loop;
  for (std::size_t i = 0; i < n / 10; ++i)
  {
    const Place p = onUnitCircle(double(i) / double(n / 10));
    loop.push_back(std::int64_t(result.points.size()));
    result.points.push_back({ 0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y });
  }
  result.constraints.addLoop(loop);
  return result;
}

struct Shape
{
  const char* name;
  std::function<ConstraintCase(std::size_t points)> make;
};

const std::vector<Shape>& shapes()
{
  static const std::vector<Shape> all = {
    { "EdgesThere", edgesThatAreThere },
    { "LatticeRows", rowsOfALattice },
    { "ShortSegments", [](std::size_t n) { return shortSegments(n, n / 10); } },
    { "OtherEdges", [](std::size_t n) { return edgesOfOthers(n, n / 10); } },
    { "Breaklines", breaklines },
    { "Ring", ringAmongPoints },
    { "Across", [](std::size_t n) { return segmentAcross(n); } },
    { "AcrossParabolas", [](std::size_t n) { return segmentAcrossParabolas(n / 10); } },
    { "AcrossBulges", [](std::size_t n) { return segmentAcrossBulges(n / 10); } },
    { "AcrossCombs", [](std::size_t n) { return segmentAcrossCombs(n / 10); } },
    { "Star", [](std::size_t n) { return starPolygon(n / 100); } },
  };
  return all;
}

/// The time and the result of one call.
struct Measured
{
  double whole = 0.0;
  double constrain = 0.0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
};

double secondsOnTheWall()
{
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// With threads lent by `executor`, if it is not null.
Measured byUs(const ConstraintCase& given, bool constrained, Executor* executor)
{
  const Context context{ nullptr, executor };
  const auto clock = executor ? secondsOnTheWall : seconds;
  static Workspace workspace;
  static Triangulation made;
  static std::vector<std::int32_t> triples;
  Measured result;
  const double begin = clock();
  bool ok = triangulate(given.view(), Options(), workspace, context, made) == Status::Ok;
  const double run = clock();
  if (constrained && ok)
  {
    ok = constrain(std::move(made), given.constraints.view(), FillRule::Orientation, context,
           made) == Status::Ok;
    result.edges = made.constraints().edges;
  }
  result.constrain = clock() - run;
  result.triangles = made.report().triangles;
  triples.resize(std::max(triples.size(), 3 * result.triangles));
  ok = ok && made.writeTriangles(triples.data(), context) == Status::Ok;
  result.whole = clock() - begin;
  return ok ? result : Measured();
}

Measured byCgal(const ConstraintCase& given)
{
#ifdef AHD_WITH_CGAL
  static std::map<const ConstraintCase*, std::unique_ptr<CgalConstrained>> known;
  std::unique_ptr<CgalConstrained>& input = known[&given];
  if (!input)
  {
    input.reset(new CgalConstrained(given));
  }
  Measured result;
  const double begin = seconds();
  double triangulated = 0.0, ended = 0.0;
  result.triangles = input->triangulate(
    [&] { triangulated = seconds(); }, [&] { ended = seconds(); });
  result.constrain = ended - triangulated;
  result.whole = ended - begin;
  return result;
#else
  (void)given;
  return Measured();
#endif
}

void measure(benchmark::State& state, const std::string& engine, const Shape& shape, std::size_t n)
{
  static std::map<std::string, ConstraintCase> made;
  const auto found = made.find(shape.name);
  const ConstraintCase& given = found != made.end()
    ? found->second
    : made.emplace(shape.name, shape.make(n)).first->second;
  const auto segments = double(segmentsOf(given.constraints.view()).size());
  static Threads two(2);
  const auto run = [&]
  {
    return engine == "cgal" ? byCgal(given)
                            : byUs(given, engine != "plain", engine == "two" ? &two : nullptr);
  };
  run(); // warm
  for (auto _ : state)
  {
    const Measured measured = run();
    if (measured.triangles == 0)
    {
      state.SkipWithError("nothing was made");
      return;
    }
    state.SetIterationTime(measured.whole);
    state.counters["constrain"] = measured.constrain;
    state.counters["triangles"] = double(measured.triangles);
    state.counters["edges"] = double(measured.edges);
  }
  state.counters["points"] = double(given.points.size());
  state.counters["segments"] = segments;
}

void registerAll(std::size_t n, int repeat)
{
  for (const Shape& shape : shapes())
  {
    for (const char* engine : { "plain", "constrained", "two", "cgal" })
    {
      const std::string name = std::string(engine) + "/" + shape.name;
      benchmark::RegisterBenchmark(
        name.c_str(), [=](benchmark::State& state) { measure(state, engine, shape, n); })
        ->UseManualTime()
        ->Iterations(1)
        ->Repetitions(repeat)
        ->Unit(benchmark::kMillisecond);
    }
  }
}

} // namespace

/// --points=1e6 --repeat=3, and Google Benchmark's own flags.
int main(int argc, char** argv)
{
  double points = 1e6;
  int repeat = 3;
  int kept = 1;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind("--points=", 0) == 0)
    {
      points = std::atof(argument.c_str() + 9);
    }
    else if (argument.rfind("--repeat=", 0) == 0)
    {
      repeat = std::max(1, std::atoi(argument.c_str() + 9));
    }
    else
    {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  benchmark::Initialize(&argc, argv);
  if (!(points >= 1000 && points <= 1e8) || benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    std::fprintf(stderr, "--points=<1e3 to 1e8>  --repeat=<n>\n");
    return 1;
  }
  registerAll(std::size_t(points), repeat);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
