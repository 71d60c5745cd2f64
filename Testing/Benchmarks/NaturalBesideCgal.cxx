// SPDX-License-Identifier: BSD-3-Clause
//
// A test, here for CGAL's sake: Sibson's weights against those of CGAL's natural neighbours over an
// exact kernel, at 10^4 places inside, on edges, on vertices and next to the hull.
#include "CgalNatural.h"
#include "Distributions.h"
#include "Random.h"
#include "Sample/Sample.h"
#include "Triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace
{

using namespace ahd;
using namespace ahd::test;

std::vector<Point> distinct(std::vector<Point> points)
{
  std::sort(points.begin(), points.end(), lexicographicallyLess);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<Point> placesAmong(const std::vector<Point>& points, std::size_t count)
{
  Random random(7);
  std::vector<Point> places;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Point a = points[random.below(points.size())], b = points[random.below(points.size())];
    const Point c = points[random.below(points.size())];
    const double t[] = { 0.0, 0.5, std::ldexp(1.0, -int(random.below(40))), random.unit() };
    const double u = t[random.below(4)], v = random.below(4) == 0 ? 0.0 : random.unit();
    const Point d{ a.x + u * (b.x - a.x), a.y + u * (b.y - a.y) };
    places.push_back({ d.x + v * (c.x - d.x), d.y + v * (c.y - d.y) });
  }
  return places;
}

/// The largest difference of a weight; infinite where only one side has a value. On the hull's
/// edges CGAL has none.
double largestDifference(
  const std::vector<Point>& points, const std::vector<Point>& places, std::size_t& compared)
{
  Workspace workspace;
  Triangulation made;
  triangulate(PointView(&points[0].x, points.size(), 2), Options(), workspace, Context(), made);
  Sampler sampler;
  SampleWeights ours;
  SampleReport report;
  if (sampler.prepare(made, nullptr, SampleMethod::NaturalNeighbor, Context()) != Status::Ok ||
    sampler.weights(SamplePlaces(PointView(&places[0].x, places.size(), 2)), ours, report,
      Context()) != Status::Ok)
  {
    return HUGE_VAL;
  }
  const auto theirs = exactNaturalWeights(points, places);
  double most = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    auto left = theirs[k];
    const std::size_t size = ours.offsets[k + 1] - ours.offsets[k];
    if (left.empty() && size <= 2)
    {
      continue;
    }
    ++compared;
    for (std::uint64_t i = ours.offsets[k]; i != ours.offsets[k + 1]; ++i)
    {
      most = std::max(most, std::fabs(left[ours.points[i]] - ours.weights[i]));
      left.erase(ours.points[i]);
    }
    for (const auto& weight : left)
    {
      most = std::max(most, weight.second);
    }
  }
  return most;
}

} // namespace

int main()
{
  bool isFine = true;
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice,
         Distribution::DecimalLattice, Distribution::OnIntegerCircle, Distribution::Utm })
  {
    const std::vector<Point> points = distinct(makePoints(d, 400, 1));
    const std::vector<Point> places = placesAmong(points, d == Distribution::Uniform ? 6000 : 1000);
    std::size_t compared = 0;
    const double most = largestDifference(points, places, compared);
    isFine = isFine && most < 1e-12 && compared > 900;
    std::printf("%-16s %zu places, weights differ by %.2g at most\n", nameOf(d), compared, most);
  }
  return isFine ? EXIT_SUCCESS : EXIT_FAILURE;
}
