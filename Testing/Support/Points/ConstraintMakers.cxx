// SPDX-License-Identifier: BSD-3-Clause
#include "ConstraintMakers.h"

#include "Places.h"
#include "Triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace ahd
{
namespace test
{
namespace
{

Point onCircle(double turns, double radius)
{
  const Place p = onUnitCircle(turns - std::floor(turns));
  return { radius * p.x, radius * p.y };
}

/// A segment along y = 0 from before the first to behind the last of points whose x are in [0, 1].
void addSegmentAcross(ConstraintCase& result)
{
  const auto first = std::int64_t(result.points.size());
  result.points.push_back({ -0.5, 0.0 });
  result.points.push_back({ 1.5, 0.0 });
  result.constraints.addLine({ first, first + 1 });
}

/// n / 2 points above and as many below the segment, at the distances height(x).
template <typename Height>
ConstraintCase acrossTwoRows(std::size_t n, Height height)
{
  ConstraintCase result;
  const std::size_t half = n / 2;
  for (std::size_t i = 0; i < half; ++i)
  {
    const double x = (double(i) + 0.5) / double(half);
    result.points.push_back({ x, height(i, x) });
    result.points.push_back({ x, -height(i, x) });
  }
  addSegmentAcross(result);
  return result;
}

} // namespace

ConstraintCase starPolygon(std::size_t spikes)
{
  ConstraintCase result;
  Chain loop;
  for (std::size_t i = 0; i < 2 * spikes; ++i)
  {
    loop.push_back(std::int64_t(i));
    const double turns = double(i) / double(2 * spikes);
    result.points.push_back(onCircle(turns, i % 2 == 0 ? 1.0 : 0.05));
  }
  const std::vector<Point> more = makePoints(Distribution::Uniform, spikes, 11);
  for (const Point& p : more)
  {
    result.points.push_back({ 2.0 * p.x - 1.0, 2.0 * p.y - 1.0 });
  }
  result.constraints.addLoop(loop);
  return result;
}

ConstraintCase shortSegments(std::size_t n, std::size_t segments)
{
  ConstraintCase result;
  Random random(12);
  const auto side = std::size_t(std::ceil(std::sqrt(double(segments))));
  for (std::size_t i = 0; i < segments; ++i)
  {
    // Each segment has a box of its own.
    for (int end = 0; end < 2; ++end)
    {
      const double x = double(i / side) + random.unit();
      const double y = double(i % side) + random.unit();
      result.points.push_back({ x / double(side), y / double(side) });
    }
    result.constraints.addLine({ std::int64_t(2 * i), std::int64_t(2 * i + 1) });
  }
  const std::vector<Point> more = makePoints(
    Distribution::Uniform, n - std::min(n, 2 * segments), 12);
  result.points.insert(result.points.end(), more.begin(), more.end());
  return result;
}

ConstraintCase edgesOfOthers(std::size_t n, std::size_t segments)
{
  constexpr std::size_t kStep = 3;
  ConstraintCase result;
  result.points = makePoints(Distribution::Uniform, n, 13);
  Triangulation made;
  Workspace workspace;
  triangulate(PointView(&result.points[0].x, n / kStep, 2 * kStep), Options(), workspace, {}, made);
  std::vector<std::int64_t> triples(3 * made.report().triangles);
  made.writeTriangles(triples.data(), {});
  std::size_t taken = 0;
  for (std::size_t h = 0; h < triples.size() && taken < segments; ++h)
  {
    const std::int64_t from = triples[h];
    const std::int64_t to = triples[h % 3 == 2 ? h - 2 : h + 1];
    if (from < to)
    {
      result.constraints.addLine({ std::int64_t(kStep) * from, std::int64_t(kStep) * to });
      ++taken;
    }
  }
  return result;
}

ConstraintCase randomSegments(std::size_t n, std::size_t segments)
{
  ConstraintCase result;
  result.points = makePoints(Distribution::Uniform, n, 14);
  Random random(14);
  for (std::size_t i = 0; i < segments; ++i)
  {
    const auto from = std::int64_t(random.below(n));
    result.constraints.addLine({ from, std::int64_t(random.below(n)) });
  }
  return result;
}

const std::vector<CrossingSegments>& crossingCases()
{
  // n segments of length l have about n^2 l^2 / pi crossings.
  static const std::vector<CrossingSegments> kAll = {
    { "10k-3k", 10000, 0.01, 0 },
    { "10k-300k", 10000, 0.1, 0 },
    { "100k-3k", 100000, 0.001, 0 },
    { "100k-50k", 100000, 0.004, 0 },
    { "100k-316k", 100000, 0.01, 0 },
    { "200k-13k", 200000, 0.001, 0 },
    { "100k-5k-in-1M", 100000, 0.0013, 800000 },
  };
  return kAll;
}

ConstraintCase crossingSegments(const CrossingSegments& shape, double scale)
{
  ConstraintCase result;
  Random random(15);
  const auto count = std::size_t(double(shape.segments) * scale);
  const double length = shape.length / std::sqrt(scale);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point p{ random.unit(), random.unit() };
    const double x = random.unit() - 0.5, y = random.unit() - 0.5;
    const double norm = length / std::max(1e-9, std::sqrt(x * x + y * y));
    const auto id = std::int64_t(result.points.size());
    result.points.insert(result.points.end(), { p, { p.x + norm * x, p.y + norm * y } });
    result.constraints.addLine({ id, id + 1 });
  }
  for (std::size_t i = std::size_t(double(shape.others) * scale); i != 0; --i)
  {
    const double x = random.unit();
    result.points.push_back({ x, random.unit() });
  }
  return result;
}

ConstraintCase segmentAcross(std::size_t n)
{
  ConstraintCase result;
  for (const Point& p : makePoints(Distribution::Uniform, n, 15))
  {
    result.points.push_back({ p.x, p.y - 0.5 });
  }
  addSegmentAcross(result);
  return result;
}

ConstraintCase segmentAcrossParabolas(std::size_t n)
{
  return acrossTwoRows(n, [](std::size_t, double x) { return 0x1p-20 + (x - 0.5) * (x - 0.5); });
}

ConstraintCase segmentAcrossBulges(std::size_t n)
{
  return acrossTwoRows(n, [](std::size_t, double x) { return 1.0 - 3.0 * x * (1.0 - x); });
}

ConstraintCase segmentAcrossCombs(std::size_t n)
{
  return acrossTwoRows(n, [](std::size_t i, double) { return i % 2 == 0 ? 0x1p-20 : 0.5; });
}

ConstraintCase spiralLine(std::size_t n, std::size_t pointsPerTurn)
{
  ConstraintCase result;
  Chain line;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double turns = double(i % pointsPerTurn) / double(pointsPerTurn);
    result.points.push_back(onCircle(turns, 0.1 + 0.9 * double(i) / double(n)));
    line.push_back(std::int64_t(i));
  }
  result.constraints.addLine(line);
  return result;
}

ConstraintCase nearlyCollinearLines(std::size_t n)
{
  ConstraintCase result;
  result.points = makePoints(Distribution::NearlyCollinear, n, 16);
  std::sort(result.points.begin(), result.points.end(), lexicographicallyLess);
  Random random(16);
  for (std::size_t i = 0; i + 1 < n; i += 1 + random.below(40))
  {
    const std::size_t to = std::min(n - 1, i + 1 + random.below(40));
    result.constraints.addLine({ std::int64_t(i), std::int64_t(to) });
  }
  return result;
}

ConstraintCase latticeSegments(std::size_t side, std::size_t segments)
{
  static const std::array<std::array<int, 2>, 8> kWays = { { { 1, 0 }, { 0, 1 }, { 1, 1 },
    { 1, -1 }, { 2, 1 }, { -1, 0 }, { 0, -1 }, { 1, 2 } } };
  ConstraintCase result;
  for (std::size_t i = 0; i < side * side; ++i)
  {
    result.points.push_back({ double(i / side), double(i % side) });
  }
  Random random(17);
  for (std::size_t i = 0; i < segments; ++i)
  {
    const auto x = std::int64_t(random.below(side));
    const auto y = std::int64_t(random.below(side));
    const auto& way = kWays[random.below(kWays.size())];
    const auto length = std::int64_t(1 + random.below(6));
    const std::int64_t x1 = x + way[0] * length;
    const std::int64_t y1 = y + way[1] * length;
    const auto end = std::int64_t(side);
    if (x1 >= 0 && x1 < end && y1 >= 0 && y1 < end)
    {
      result.constraints.addLine({ x * end + y, x1 * end + y1 });
    }
  }
  return result;
}

ConstraintCase nestedLoops(std::size_t depth)
{
  ConstraintCase result;
  const std::size_t side = 4 * depth;
  for (std::size_t i = 0; i < side * side; ++i)
  {
    result.points.push_back({ double(i / side), double(i % side) });
  }
  for (std::size_t k = 0; k < depth; ++k)
  {
    const auto at = [&](std::size_t x, std::size_t y) { return std::int64_t(x * side + y); };
    const std::size_t low = 2 * k;
    const std::size_t high = side - 1 - 2 * k;
    Chain loop = { at(low, low), at(high, low), at(high, high), at(low, high) };
    if (k % 2 == 1)
    {
      std::reverse(loop.begin(), loop.end());
    }
    result.constraints.addLoop(loop);
  }
  return result;
}

ConstraintCase chainsThrough(
  Distribution distribution, std::size_t n, std::size_t chains, std::uint64_t seed)
{
  ConstraintCase result;
  result.points = makePoints(distribution, n, seed);
  Random random(seed);
  std::vector<Chain> loops;
  for (std::size_t k = 0; k < chains; ++k)
  {
    Chain chain(2 + random.below(4));
    for (std::int64_t& id : chain)
    {
      id = std::int64_t(random.below(n));
    }
    if (k % 3 == 2)
    {
      loops.push_back(chain);
    }
    else
    {
      result.constraints.addLine(chain);
    }
  }
  for (const Chain& loop : loops)
  {
    result.constraints.addLoop(loop);
  }
  return result;
}

} // namespace test
} // namespace ahd
