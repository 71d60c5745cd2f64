// SPDX-License-Identifier: BSD-3-Clause
//
// The engine beside CGAL in one process. Each run is timed whole: ours from coordinates to
// triangles in 32-bit ids of the caller, CGAL's from its points to its data structure, which has no
// ids.
//
// Warm (the default), the engine and the memory for the triangles are those of the call before, and
// so are CGAL's pages as far as malloc has kept them. Cold (--cold), the call is the first of the
// process, and page faults are part of it. One thread is timed by its CPU time, which other work on
// the machine disturbs less; several by the time on the wall.
#include "BenchmarkFlags.h"
#ifdef AHD_WITH_CGAL
#include "CgalRun.h"
#endif
#include "Executors.h"
#include "Interface/ahd.h"
#include "Triangulate.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <memory>
#include <set>

namespace
{

using namespace ahd;
using namespace ahd::test;

/// One thing to measure.
struct Case
{
  std::string engine;
  Distribution distribution;
  std::size_t n;
  bool cold;

  std::string name() const { return engine + "/" + nameOf(distribution) + "/" + std::to_string(n); }
  bool byWall() const { return engine.rfind("threads", 0) == 0; }
};

double secondsOf(clockid_t clock)
{
  timespec t;
  clock_gettime(clock, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// The points of a case, made once: all engines get the same.
const std::vector<Point>& pointsOf(const Case& c)
{
  static std::map<std::pair<Distribution, std::size_t>, std::vector<Point>> made;
  std::vector<Point>& points = made[{ c.distribution, c.n }];
  if (points.empty())
  {
    points = makePoints(c.distribution, c.n, 1);
  }
  return points;
}

/// Times `run(done)` until it calls done(), so that freeing memory is not part of it, and
/// reports the number of triangles it returns. Small cases are run several times in a row, of which
/// the fastest counts: they are over before the clock has moved much.
template <typename Run>
void measure(benchmark::State& state, const Case& c, Run run)
{
  static std::set<std::string> warm;
  std::size_t triangles = 0;
  const clockid_t clock = c.byWall() ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID;
  double end = 0.0;
  const auto done = [&] { end = secondsOf(clock); };
  if (!c.cold && warm.insert(c.name()).second)
  {
    run(done);
  }
  const std::size_t times = c.cold ? 1 : std::max<std::size_t>(1, 200000 / c.n);
  for (auto _ : state)
  {
    double fastest = 1e300;
    for (std::size_t i = 0; i < times; ++i)
    {
      const double start = secondsOf(clock);
      triangles = run(done);
      fastest = std::min(fastest, end - start);
    }
    state.SetIterationTime(fastest);
    state.counters["nsPerPoint"] = 1e9 * fastest / double(c.n);
  }
  state.counters["triangles"] = double(triangles);
}

/// The engine and the memory for its triangles, kept from call to call by cases of one size.
struct Ours
{
  Workspace workspace;
  Triangulation made;
  std::unique_ptr<std::int32_t[]> triples;
  std::size_t capacity = 0;

  std::size_t triangulate(const PointView& points, Executor* executor)
  {
    if (ahd::triangulate(points, Options(), workspace, { nullptr, executor }, made) != Status::Ok)
    {
      return 0;
    }
    const std::size_t triangles = made.report().triangles;
    if (capacity < triangles)
    {
      triples.reset(new std::int32_t[3 * triangles]);
      capacity = triangles;
    }
    const Status written = made.writeTriangles(triples.get(), { nullptr, executor });
    return written == Status::Ok ? triangles : 0;
  }
};

/// The same through the C interface, as the wheel calls it.
struct OursInC
{
  ahd_job* const job = ahd_job_new();
  std::unique_ptr<std::int32_t[]> triples;
  std::uint64_t capacity = 0;

  OursInC() = default;
  OursInC(const OursInC&) = delete;
  OursInC& operator=(const OursInC&) = delete;
  ~OursInC() { ahd_job_free(job); }

  std::size_t triangulate(const std::vector<Point>& points)
  {
    const ahd_array view = { points.data(), AHD_FLOAT64, 2, std::int64_t(points.size()),
      sizeof(Point), sizeof(double) };
    std::uint64_t triangles = 0, three = 0;
    if (ahd_set_int(job, "threads", 1) != AHD_OK || ahd_set_array(job, "points", &view) != AHD_OK ||
      ahd_run(job) != AHD_OK || ahd_array_size(job, "triangles", &triangles, &three) != AHD_OK)
    {
      return 0;
    }
    if (capacity < triangles)
    {
      triples.reset(new std::int32_t[triangles * three]);
      capacity = triangles;
    }
    return ahd_get_array(job, "triangles", AHD_INT32, triples.get(), triangles * three) == AHD_OK
      ? std::size_t(triangles)
      : 0;
  }
};

/// The points of a case as its engine gets them.
std::vector<Point> pointsFor(const Case& c)
{
  std::vector<Point> points = pointsOf(c);
  if (c.engine == "shuffled")
  {
    Random random(2);
    for (std::size_t i = points.size(); i > 1; --i)
    {
      std::swap(points[i - 1], points[random.below(i)]);
    }
  }
  else if (c.engine.rfind("times", 0) == 0)
  {
    const double factor = std::atof(c.engine.c_str() + 5);
    for (Point& p : points)
    {
      p = { p.x * factor, p.y * factor };
    }
  }
  return points;
}

void triangulateOurs(benchmark::State& state, const Case& c)
{
  static std::map<std::size_t, Ours> kept;
  const std::vector<Point> points = pointsFor(c);
  std::vector<float> floats;
  if (c.engine == "float")
  {
    for (const Point& p : points)
    {
      floats.insert(floats.end(), { float(p.x), float(p.y) });
    }
  }
  const unsigned threads = c.byWall() ? unsigned(std::atoi(c.engine.c_str() + 7)) : 1;
  std::unique_ptr<Executor> executor(threads == 1 ? nullptr : new ThreadExecutor(threads));
  const PointView view = floats.empty() ? PointView(&points[0].x, c.n, 2)
                                        : PointView(floats.data(), c.n, 2);
  measure(state, c,
    [&](const auto& done)
    {
      const std::size_t triangles = kept[c.n].triangulate(view, executor.get());
      done();
      return triangles;
    });
}

void triangulateInC(benchmark::State& state, const Case& c)
{
  static std::map<std::size_t, OursInC> kept;
  const std::vector<Point>& points = pointsOf(c);
  measure(state, c,
    [&](const auto& done)
    {
      const std::size_t triangles = kept[c.n].triangulate(points);
      done();
      return triangles;
    });
}

void triangulateByCgal(benchmark::State& state, const Case& c)
{
#ifdef AHD_WITH_CGAL
  const CgalRun run(pointsOf(c));
  measure(state, c, [&](const auto& done) { return run.triangulate(done); });
#else
  (void)c;
  state.SkipWithError("built without CGAL");
#endif
}

void registerAll(const BenchmarkFlags& flags)
{
  for (const std::size_t n : flags.sizes)
  {
    for (const Distribution distribution : flags.distributions)
    {
      for (const std::string& engine : flags.engines)
      {
        const Case c{ engine, distribution, n, flags.cold };
        const auto run = engine == "cgal" ? triangulateByCgal
          : engine == "c"                 ? triangulateInC
                                          : triangulateOurs;
        benchmark::RegisterBenchmark(
          c.name().c_str(), [=](benchmark::State& state) { run(state, c); })
          ->UseManualTime()
          ->Iterations(1)
          ->Repetitions(flags.repeat)
          ->Unit(benchmark::kMillisecond);
      }
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
