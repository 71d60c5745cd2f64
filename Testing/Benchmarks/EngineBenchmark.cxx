// SPDX-License-Identifier: BSD-3-Clause
//
// The engine beside CGAL, in one process, on one core, by the CPU time of the thread: other work on
// the machine disturbs it less than the time on the wall. Each run is timed whole, from coordinates
// in doubles to triangles in 32-bit ids, buffers allocated and freed; CGAL's from points to its
// data structure. What each run reports is the fastest of its repetitions.
#include "BenchmarkFlags.h"
#ifdef AHD_WITH_CGAL
#include "CgalRun.h"
#endif
#include "Triangulate.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>

namespace
{

using namespace ahd;
using namespace ahd::test;

/// CPU time of this thread in seconds.
double threadSeconds()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// The points of the benchmark that runs. Kept from one to the next: both engines get the same.
const std::vector<Point>& pointsOf(Distribution distribution, std::size_t n)
{
  static Distribution last;
  static std::vector<Point> points;
  if (points.size() != n || last != distribution)
  {
    points = makePoints(distribution, n, 1);
    last = distribution;
  }
  return points;
}

PointView viewOf(const std::vector<Point>& points)
{
  return PointView(&points[0].x, points.size(), 2);
}

/// Times `run` once per iteration, after one that does not count (the process has grown by then);
/// `nsPerPoint` reports the fastest.
template <typename Run>
void measure(benchmark::State& state, std::size_t n, Run run)
{
  run();
  double fastest = 1e300;
  for (auto _ : state)
  {
    const double start = threadSeconds();
    run();
    const double seconds = threadSeconds() - start;
    state.SetIterationTime(seconds);
    fastest = std::min(fastest, seconds);
  }
  state.counters["nsPerPoint"] = 1e9 * fastest / double(n);
}

void triangulateOurs(benchmark::State& state, Distribution distribution, std::size_t n)
{
  const std::vector<Point>& points = pointsOf(distribution, n);
  Report report;
  bool ok = true;
  measure(state, n,
    [&]
    {
      Triangulator triangulator;
      ok = ok && triangulator.run(viewOf(points), Options(), nullptr) == Status::Ok;
      report = triangulator.report();
      std::unique_ptr<std::int32_t[]> triples(new std::int32_t[3 * report.triangles]);
      ok = ok && triangulator.writeTriangles(triples.get(), nullptr) == Status::Ok;
      benchmark::DoNotOptimize(triples.get());
    });
  if (!ok)
  {
    state.SkipWithError("the engine did not finish");
    return;
  }
  Options counting;
  counting.countWork = true;
  Triangulator counted;
  counted.run(viewOf(points), counting, nullptr);
  state.counters["NP"] = counted.report().np();
  state.counters["NR"] = counted.report().nr();
  state.counters["triangles"] = double(report.triangles);
}

#ifdef AHD_WITH_CGAL
void triangulateByCgal(benchmark::State& state, Distribution distribution, std::size_t n)
{
  const CgalRun run(pointsOf(distribution, n));
  std::size_t triangles = 0;
  measure(state, n, [&] { triangles = run.triangulate(); });
  state.counters["triangles"] = double(triangles);
}
#endif

void registerOne(const std::string& name, const BenchmarkFlags& flags,
  void (*function)(benchmark::State&, Distribution, std::size_t), Distribution distribution,
  std::size_t n)
{
  benchmark::RegisterBenchmark(
    name.c_str(), [=](benchmark::State& state) { function(state, distribution, n); })
    ->UseManualTime()
    ->Iterations(flags.repeat)
    ->Unit(benchmark::kMillisecond);
}

void registerAll(const BenchmarkFlags& flags)
{
  for (const std::size_t n : flags.sizes)
  {
    for (const Distribution distribution : flags.distributions)
    {
      const std::string what = std::string(nameOf(distribution)) + "/" + std::to_string(n);
      if (flags.ours)
      {
        registerOne("ours/" + what, flags, triangulateOurs, distribution, n);
      }
#ifdef AHD_WITH_CGAL
      if (flags.cgal)
      {
        registerOne("cgal/" + what, flags, triangulateByCgal, distribution, n);
      }
#endif
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::string error;
  const BenchmarkFlags flags = takeFlags(argc, argv, error);
  benchmark::Initialize(&argc, argv);
  if (!error.empty() || benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    std::fprintf(stderr, "%s", error.c_str());
    return 1;
  }
  registerAll(flags);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
