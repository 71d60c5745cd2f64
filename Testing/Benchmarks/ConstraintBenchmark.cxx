// SPDX-License-Identifier: BSD-3-Clause
//
// What constraints cost, beside CGAL's Constrained_Delaunay_triangulation_2 on the same points and
// segments, one thread, by its CPU time. `plain` is the triangulation alone; `constrained` that and
// the constraints; `cgal` CGAL's points and then its constraints, without ids. Each is timed from
// the points to the triangles written (CGAL: to its data structure); `constrain` is what the
// constraints alone took, and is given for CGAL as well.
//
// What is made, and how many segments it has, depends on --points; see shapes().
#include "BesideCgal.h"

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
    { "Across", [](std::size_t n) { return segmentAcross(n); } },
    { "AcrossParabolas", [](std::size_t n) { return segmentAcrossParabolas(n / 10); } },
    { "AcrossBulges", [](std::size_t n) { return segmentAcrossBulges(n / 10); } },
    { "AcrossCombs", [](std::size_t n) { return segmentAcrossCombs(n / 10); } },
    { "Star", [](std::size_t n) { return starPolygon(n / 100); } },
  };
  return all;
}

/// What one call took, and what it made.
struct Measured
{
  double whole = 0.0;
  double constrain = 0.0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
};

Measured byUs(const ConstraintCase& given, bool constrained)
{
  static Workspace workspace;
  static Triangulation made;
  static std::vector<std::int32_t> triples;
  Measured result;
  const double begin = seconds();
  bool ok = triangulate(given.view(), Options(), workspace, {}, made) == Status::Ok;
  const double run = seconds();
  if (constrained && ok)
  {
    ok = constrain(std::move(made), given.constraints.view(), FillRule::Orientation, {}, made) ==
      Status::Ok;
    result.edges = made.constraints().edges;
  }
  result.constrain = seconds() - run;
  result.triangles = made.report().triangles;
  triples.resize(std::max(triples.size(), 3 * result.triangles));
  ok = ok && made.writeTriangles(triples.data(), {}) == Status::Ok;
  result.whole = seconds() - begin;
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
  const auto run = [&]
  { return engine == "cgal" ? byCgal(given) : byUs(given, engine == "constrained"); };
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
    for (const char* engine : { "plain", "constrained", "cgal" })
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
