// SPDX-License-Identifier: BSD-3-Clause
//
// The filter's Update() beside the engine alone on the same coordinates, by the CPU time of the
// process. Both are warm and have what they keep from one call to the next; the engine alone gets
// new memory for its triangles each time, as the filter makes a new output each time.
//   FilterBenchmark [--points=1000000] [Google Benchmark's own]
#include "Distributions.h"
#include "Triangulate.h"

#include <vtkAdaptiveHilbertDelaunay2D.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>

namespace
{

using namespace ahd;

double processSeconds()
{
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

template <typename Run>
void measure(benchmark::State& state, std::size_t n, Run run)
{
  run();
  for (auto _ : state)
  {
    const double start = processSeconds();
    const std::size_t triangles = run();
    const double seconds = processSeconds() - start;
    state.SetIterationTime(seconds);
    state.counters["nsPerPoint"] = 1e9 * seconds / double(n);
    state.counters["triangles"] = double(triangles);
  }
}

void runEngine(benchmark::State& state, vtkPoints* points)
{
  static Workspace workspace;
  static Triangulation made;
  const std::size_t n = std::size_t(points->GetNumberOfPoints());
  const PointView view(static_cast<const double*>(points->GetVoidPointer(0)), n, 3);
  measure(state, n,
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

void runFilter(benchmark::State& state, vtkPolyData* input)
{
  static vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(input);
  measure(state, std::size_t(input->GetNumberOfPoints()),
    [&]
    {
      filter->Modified();
      filter->Update();
      return std::size_t(filter->GetNumberOfTriangles());
    });
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  std::size_t n = 1000000;
  const std::string prefix = "--points=";
  if (argc > 1 && std::string(argv[1]).rfind(prefix, 0) == 0)
  {
    n = std::size_t(std::atof(argv[1] + prefix.size()));
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : test::makePoints(test::Distribution::Uniform, n, 1))
  {
    points->InsertNextPoint(p.x, p.y, 0.5);
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  const std::string what = "/Uniform/" + std::to_string(n);
  benchmark::RegisterBenchmark(
    ("engine" + what).c_str(), [&](benchmark::State& state) { runEngine(state, points); })
    ->UseManualTime()
    ->Iterations(1);
  benchmark::RegisterBenchmark(
    ("filter" + what).c_str(), [&](benchmark::State& state) { runFilter(state, input); })
    ->UseManualTime()
    ->Iterations(1);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
