// SPDX-License-Identifier: BSD-3-Clause
//
// The cost of values between the points: linear, natural neighbour, Laplace and nearest, on a
// raster and at scattered places, on one thread by its CPU time; natural neighbours beside CGAL's
// natural_neighbor_coordinates_2 at the same places in the same order. The triangulation and the
// Sampler are prepared, the output memory is warm. On two threads by the clock on the wall, and,
// for busy machines, as it would be if tasks took the CPU time that they take alone.
#include "BesideCgal.h"
#include "Core/Threads.h"
#include "Random.h"
#include "Sample/Sample.h"
#ifdef AHD_WITH_CGAL
#include "CgalNatural.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace ahd;
using namespace ahd::test;

struct Surface
{
  explicit Surface(std::size_t n, Distribution d)
    : points(makePoints(d, n, 1))
  {
    Workspace workspace;
    triangulate(PointView(&points[0].x, n, 2), Options(), workspace, Context(), made);
    for (const Point& p : points)
    {
      bounds = values.empty() ? Bounds{ p.x, p.x, p.y, p.y }
                              : Bounds{ std::min(bounds.xmin, p.x), std::max(bounds.xmax, p.x),
                                  std::min(bounds.ymin, p.y), std::max(bounds.ymax, p.y) };
      values.push_back(std::sin(3.0 * p.x) * std::cos(2.0 * p.y));
    }
  }

  /// So many cells, about square.
  SampleRaster raster(std::size_t cells) const
  {
    const double width = bounds.xmax - bounds.xmin, height = bounds.ymax - bounds.ymin;
    const double pitch = std::sqrt(width * height / double(cells));
    const auto columns = std::size_t(width / pitch), rows = std::size_t(height / pitch);
    return { { bounds.xmin + 0.5 * pitch, bounds.ymin + 0.5 * pitch }, { pitch, pitch }, columns,
      rows };
  }

  std::vector<Point> scattered(std::size_t count) const
  {
    Random random(2);
    std::vector<Point> places;
    for (std::size_t k = 0; k < count; ++k)
    {
      const double x = random.unit(), y = random.unit();
      places.push_back({ bounds.xmin + x * (bounds.xmax - bounds.xmin),
        bounds.ymin + y * (bounds.ymax - bounds.ymin) });
    }
    return places;
  }

  std::vector<Point> points;
  std::vector<double> values;
  Bounds bounds;
  Triangulation made;
};

/// Runs all tasks itself, and computes how much sooner two threads would have ended.
class Pretended : public Executor
{
public:
  unsigned threads() const override { return 2; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>&) override
  {
    double busy[2] = { 0.0, 0.0 };
    for (std::size_t k = 0; k < count; ++k)
    {
      const double begin = seconds();
      task(k);
      *std::min_element(busy, busy + 2) += seconds() - begin;
    }
    saved += std::min(busy[0], busy[1]);
  }

  double saved = 0.0;
};

double secondsOnTheWall()
{
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// The least time of so many runs.
double least(int repeat, double (*clock)(), const std::function<void()>& work)
{
  double best = HUGE_VAL;
  for (int k = 0; k < repeat; ++k)
  {
    const double begin = clock();
    work();
    best = std::min(best, clock() - begin);
  }
  return best;
}

void print(const std::string& name, std::size_t places, double time)
{
  std::printf("%-22s %9zu places  %7.2f million a second", name.c_str(), places,
    1e-6 * double(places) / time);
}

void measure(Surface& surface, const std::string& name, SampleMethod method,
  const SamplePlaces& places, int repeat)
{
  static Threads two(2);
  Sampler sampler;
  std::vector<double> out(places.count());
  std::vector<unsigned char> mask(places.count());
  const SampleArray array{ surface.values.data(), 1, out.data(), nullptr };
  SampleReport report;
  const auto run = [&](const Context& context)
  { return sampler.values(places, &array, 1, mask.data(), report, context); };
  if (sampler.prepare(surface.made, nullptr, method, Context()) != Status::Ok ||
    run(Context()) != Status::Ok || report.valued == 0)
  {
    std::printf("%s: nothing was sampled\n", name.c_str());
    std::exit(1);
  }
  const double alone = least(repeat, seconds, [&] { run(Context()); });
  const double onWall = least(repeat, secondsOnTheWall, [&] { run(Context()); });
  const double shared = least(repeat, secondsOnTheWall, [&] { run({ nullptr, &two }); });
  double implied = 0.0;
  for (int k = 0; k < repeat; ++k)
  {
    Pretended threads;
    const double time = least(1, seconds, [&] { run({ nullptr, &threads }); });
    implied = std::max(implied, time / (time - threads.saved));
  }
  print(name, places.count(), alone);
  std::printf("  two threads: %.2f times, implied %.2f\n", onWall / shared, implied);
  std::fflush(stdout);
}

void measureAll(std::size_t n, Distribution d, int repeat)
{
  Surface surface(n, d);
  std::printf("%zu points, %s\n", n, nameOf(d));
  const std::vector<Point> where = surface.scattered(n);
  const SamplePlaces scattered(PointView(&where[0].x, where.size(), 2));
  const SamplePlaces fine(surface.raster(10 * n)), coarse(surface.raster(n));
  const SamplePlaces few(surface.raster(n / 100));
  measure(surface, "linear, raster", SampleMethod::Linear, fine, repeat);
  measure(surface, "linear, raster", SampleMethod::Linear, coarse, repeat);
  measure(surface, "linear, raster", SampleMethod::Linear, few, repeat);
  measure(surface, "linear, scattered", SampleMethod::Linear, scattered, repeat);
  measure(surface, "natural, raster", SampleMethod::NaturalNeighbor, coarse, repeat);
  measure(surface, "natural, scattered", SampleMethod::NaturalNeighbor, scattered, repeat);
  measure(surface, "Laplace, raster", SampleMethod::Laplace, coarse, repeat);
  measure(surface, "nearest, raster", SampleMethod::Nearest, coarse, repeat);
  measure(surface, "nearest, scattered", SampleMethod::Nearest, scattered, repeat);
#ifdef AHD_WITH_CGAL
  const CgalNatural cgal(surface.points, surface.values);
  std::vector<Point> places;
  for (std::size_t k = 0; k < few.count(); ++k)
  {
    places.push_back(few[k]);
  }
  print(
    "CGAL, natural, raster", places.size(), least(1, seconds, [&] { cgal.interpolate(places); }));
  std::printf("\n");
#endif
}

} // namespace

/// --points=1e6 --repeat=3 --distribution=Uniform
int main(int argc, char** argv)
{
  double points = 1e6;
  int repeat = 3;
  Distribution distribution = Distribution::Uniform;
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
    for (const Distribution d : allDistributions())
    {
      distribution = argument == std::string("--distribution=") + nameOf(d) ? d : distribution;
    }
  }
  if (!(points >= 1000 && points <= 1e8))
  {
    std::fprintf(stderr, "--points=<1e3 to 1e8>  --repeat=<n>  --distribution=<name>\n");
    return 1;
  }
  measureAll(std::size_t(points), distribution, repeat);
  return 0;
}
