// SPDX-License-Identifier: BSD-3-Clause
//
// The filter's Update() beside the engine alone on the same coordinates, and with each feature
// beside a plain one. Counters: nsPerPoint, CPU time of the process, and wallNsPerPoint. All are
// warm and keep their memory from one call to the next; the engine alone gets new memory for its
// triangles each time, as the filter makes a new output each time.
//   FilterBenchmark [--points=1000000] [--threads=1] [--features=engine,plain] [Google Benchmark's
//   own]
// Features: see features(); "all" for each of them.
#include "Distributions.h"
#include "Triangulate.h"

#include <vtkAdaptiveHilbertDelaunay2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace ahd;
using Filter = vtkAdaptiveHilbertDelaunay2D;

/// Data shared by all runs.
struct Inputs
{
  std::size_t n = 1000000;
  int threads = 1;
  bool cold = false;
  vtkNew<vtkPolyData> points;        ///< uniform in the unit square, z on a slanted plane
  vtkNew<vtkPolyData> breaklines;    ///< n / 10 short lines, of which no two cross
  vtkNew<vtkPolyData> crossingLines; ///< the same, but that some do

  /// The mean distance between neighbours.
  double spacing() const { return 1.0 / std::sqrt(double(n)); }
};

struct Feature
{
  const char* name;
  std::function<void(Filter&, const Inputs&)> set;
};

const std::vector<Feature>& features()
{
  static const std::vector<Feature> all = {
    { "plain", [](Filter&, const Inputs&) {} },
    { "Voronoi", [](Filter& f, const Inputs&) { f.GenerateVoronoiOn(); } },
    { "Alpha", [](Filter& f, const Inputs& in) { f.SetAlpha(2.0 * in.spacing()); } },
    { "Tolerance", [](Filter& f, const Inputs& in) { f.SetTolerance(1e-3 * in.spacing()); } },
    { "RegionIds", [](Filter& f, const Inputs&) { f.GenerateRegionIdsOn(); } },
    { "Neighbors", [](Filter& f, const Inputs&) { f.GenerateNeighborsOn(); } },
    { "MaximumEdgeLength",
      [](Filter& f, const Inputs& in) { f.SetMaximumEdgeLength(3.0 * in.spacing()); } },
    { "BestFittingPlane",
      [](Filter& f, const Inputs&) { f.SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE); } },
    { "ConstraintEdges", [](Filter& f, const Inputs&) { f.GenerateConstraintEdgesOn(); } },
    { "Curve", [](Filter& f, const Inputs&) { f.GenerateInsertionCurveOn(); } },
    { "Boxes", [](Filter& f, const Inputs&) { f.GenerateBoxesOn(); } },
    { "Breaklines", [](Filter& f, const Inputs& in) { f.SetSourceData(in.breaklines); } },
    { "CrossingLines", [](Filter& f, const Inputs& in) { f.SetSourceData(in.crossingLines); } },
  };
  return all;
}

double secondsOf(clockid_t clock)
{
  timespec t;
  clock_gettime(clock, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// Times the second of two calls, the first fills the caches; cold, the first.
template <typename Run>
void measure(benchmark::State& state, const Inputs& in, Run run)
{
  const std::size_t n = in.n;
  if (!in.cold)
  {
    run();
  }
  for (auto _ : state)
  {
    const double start = secondsOf(CLOCK_PROCESS_CPUTIME_ID);
    const double wallStart = secondsOf(CLOCK_MONOTONIC);
    const std::size_t triangles = run();
    const double wall = secondsOf(CLOCK_MONOTONIC) - wallStart;
    const double seconds = secondsOf(CLOCK_PROCESS_CPUTIME_ID) - start;
    state.SetIterationTime(seconds);
    state.counters["nsPerPoint"] = 1e9 * seconds / double(n);
    state.counters["wallNsPerPoint"] = 1e9 * wall / double(n);
    state.counters["triangles"] = double(triangles);
  }
}

void runEngine(benchmark::State& state, const Inputs& in)
{
  static Workspace workspace;
  static Triangulation made;
  const auto* places = static_cast<const double*>(in.points->GetPoints()->GetVoidPointer(0));
  const PointView view(places, in.n, 3);
  measure(state, in,
    [&]
    {
      triangulate(view, Options(), workspace, {}, made);
      const std::size_t triangles = made.report().triangles;
      std::unique_ptr<std::int32_t[]> triples(new std::int32_t[3 * triangles]);
      made.writeTriangles(triples.get(), {});
      benchmark::DoNotOptimize(triples.get());
      return triangles;
    });
}

void runFilter(benchmark::State& state, const Inputs& in, const Feature& feature)
{
  vtkNew<Filter> filter;
  filter->SetInputData(in.points);
  filter->SetNumberOfThreads(in.threads);
  feature.set(*filter, in);
  measure(state, in,
    [&]
    {
      filter->Modified();
      filter->Update();
      return std::size_t(filter->GetNumberOfTriangles());
    });
}

void makePoints(Inputs& in)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : test::makePoints(test::Distribution::Uniform, in.n, 1))
  {
    points->InsertNextPoint(p.x, p.y, 0.5 + 0.1 * p.x);
  }
  in.points->SetPoints(points);
}

/// The triangles of every `step`-th point, as the caller's ids.
std::vector<std::int64_t> trianglesOfEvery(std::size_t step, const Inputs& in)
{
  const auto* places = static_cast<const double*>(in.points->GetPoints()->GetVoidPointer(0));
  Triangulation made;
  Workspace workspace;
  triangulate(
    PointView(places, (in.n + step - 1) / step, 3 * step), Options(), workspace, {}, made);
  std::vector<std::int64_t> triples(3 * made.report().triangles);
  made.writeTriangles(triples.data(), {});
  std::for_each(
    triples.begin(), triples.end(), [step](std::int64_t& id) { id *= std::int64_t(step); });
  return triples;
}

/// n / 10 lines, one for each of as many corners of the triples: to another one so many places on.
void makeLines(const Inputs& in, std::size_t step, std::size_t placesOn, vtkPolyData* lines)
{
  const std::vector<std::int64_t> triples = trianglesOfEvery(step, in);
  const std::size_t apart = std::max<std::size_t>(1, triples.size() / 3 / (in.n / 10 + 1));
  vtkNew<vtkCellArray> cells;
  for (std::size_t t = 0; 3 * t + placesOn < triples.size(); t += apart)
  {
    const vtkIdType ids[2] = { triples[3 * t], triples[3 * t + placesOn] };
    if (ids[0] != ids[1])
    {
      cells->InsertNextCell(2, ids);
    }
  }
  lines->SetPoints(in.points->GetPoints());
  lines->SetLines(cells);
}

/// Edges of the triangulation of every third point do not cross each other, and few of them are
/// edges of the triangulation of all. Lines between corners of triangles that follow each other
/// may.
void makeBreaklines(Inputs& in)
{
  makeLines(in, 3, 1, in.breaklines);
  makeLines(in, 1, 5, in.crossingLines);
}

/// The value of `--name=`, or nothing.
const char* valueOf(const char* argument, const std::string& name)
{
  const std::string begin = "--" + name + "=";
  return std::string(argument).rfind(begin, 0) == 0 ? argument + begin.size() : nullptr;
}

/// The runs that the list names; false if one is unknown.
bool registerRuns(const std::string& list, const Inputs& in)
{
  std::stringstream words(list);
  for (std::string word; std::getline(words, word, ',');)
  {
    const auto name = [&](const std::string& what)
    { return what + "/Uniform/" + std::to_string(in.n); };
    bool found = word == "engine";
    if (found)
    {
      benchmark::RegisterBenchmark(
        name("engine").c_str(), [&](benchmark::State& state) { runEngine(state, in); })
        ->UseManualTime()
        ->Iterations(1);
    }
    for (const Feature& feature : features())
    {
      if (word == feature.name || word == "all")
      {
        found = true;
        benchmark::RegisterBenchmark(name(feature.name).c_str(),
          [&](benchmark::State& state) { runFilter(state, in, feature); })
          ->UseManualTime()
          ->Iterations(1);
      }
    }
    if (!found)
    {
      std::fprintf(stderr, "no feature is called %s\n", word.c_str());
      return false;
    }
  }
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  Inputs in;
  std::string list = "engine,plain";
  int kept = 1;
  for (int i = 1; i < argc; ++i)
  {
    if (const char* points = valueOf(argv[i], "points"))
    {
      in.n = std::size_t(std::atof(points));
    }
    else if (const char* threads = valueOf(argv[i], "threads"))
    {
      in.threads = std::atoi(threads);
    }
    else if (const char* names = valueOf(argv[i], "features"))
    {
      list = names;
    }
    else if (std::string(argv[i]) == "--cold")
    {
      in.cold = true;
    }
    else
    {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  benchmark::Initialize(&argc, argv);
  if (in.n < 100 || in.n > 200000000 || benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    std::fprintf(stderr, "--points=<100 to 2e8>  --threads=<n>  --features=<names>\n");
    return 1;
  }
  makePoints(in);
  if (list == "all" || list.find("Breaklines") != std::string::npos ||
    list.find("CrossingLines") != std::string::npos)
  {
    makeBreaklines(in);
  }
  if (!registerRuns(list, in))
  {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
