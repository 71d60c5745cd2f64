// SPDX-License-Identifier: BSD-3-Clause
//
// simplify() beside a plain triangulation of the same points, in turns, CPU time:
//   SimplifyBenchmark [POINTS [BOUND [ROUNDS [THREADS]]]]
// The points are hills without noise; with threads the time is that on the wall.
#include "Core/Clock.h"
#include "Core/Threads.h"
#include "Distributions.h"
#include "Simplify/Simplify.h"
#include "Triangulate.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

namespace
{

using namespace ahd;
using namespace ahd::test;

double seconds(bool byWall)
{
  return byWall ? steadySeconds() : double(std::clock()) / CLOCKS_PER_SEC;
}

/// x, y and z of uniform points on 40 hills.
std::vector<double> hills(std::size_t count)
{
  Random random(1);
  std::vector<double> hill, numbers;
  for (int k = 0; k < 40; ++k)
  {
    const double width = 0.02 + 0.2 * random.unit() * random.unit();
    const double height = (random.unit() - 0.3) * 20.0;
    hill.insert(hill.end(), { random.unit(), random.unit(), width, height });
  }
  for (const Point& p : makePoints(Distribution::Uniform, count, 1))
  {
    double z = 0.0;
    for (std::size_t k = 0; k < hill.size(); k += 4)
    {
      const double x = (p.x - hill[k]) / hill[k + 2], y = (p.y - hill[k + 1]) / hill[k + 2];
      z += hill[k + 3] / (1.0 + x * x + y * y);
    }
    numbers.insert(numbers.end(), { p.x, p.y, z });
  }
  return numbers;
}

double median(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

} // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int k, double otherwise)
  { return argc > k ? std::atof(argv[k]) : otherwise; };
  const std::vector<double> numbers = hills(static_cast<std::size_t>(argument(1, 1e6)));
  const auto rounds = static_cast<std::size_t>(argument(3, 5.0));
  const auto count = static_cast<unsigned>(argument(4, 1.0));
  Threads threads(count);
  const Context context{ nullptr, count > 1 ? &threads : nullptr };
  SimplifyRequest request;
  request.points = PointView(numbers.data(), numbers.size() / 3, 3);
  request.maximumError = argument(2, 0.05);
  SimplifyResult result;
  std::vector<double> simple, twice, plain;
  Workspace workspace;
  for (std::size_t round = 0; round < rounds; ++round)
  {
    for (const bool secondPass : { false, true })
    {
      request.secondPass = secondPass;
      const double begin = seconds(count > 1);
      simplify(request, context, result);
      (secondPass ? twice : simple).push_back(seconds(count > 1) - begin);
    }
    const double begin = seconds(count > 1);
    Triangulation made;
    triangulate(request.points, Options(), workspace, context, made);
    plain.push_back(seconds(count > 1) - begin);
    workspace.reclaim(std::move(made));
  }
  std::printf("%zu points, bound %g: %zu kept, largest error %g, %zu rounds\n",
    request.points.count, request.maximumError, result.kept, result.largestError, result.rounds);
  std::printf(
    "plain %.3f s; simplified %.3f s, %.2f times; with the second pass %.3f s, %.2f times\n",
    median(plain), median(simple), median(simple) / median(plain), median(twice),
    median(twice) / median(plain));
  return 0;
}
