// SPDX-License-Identifier: BSD-3-Clause
//
// Circumcentres of many triangles at once are those of one at a time, bit by bit, as compiled for
// each kind of processor; these are held to exact ones in VoronoiCorners.cxx.
#include "Voronoi/CentreBlocks.h"
#include "Voronoi/Circumcentre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace ahd::test
{
namespace
{

constexpr std::size_t kTriangles = 10001; // no multiple of what is computed at once

/// Triangles of points that are `origin` and `size` times a number below 1, on a lattice with
/// `steps` steps if that is not 0.
std::vector<Point> corners(double origin, double size, double steps, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  const auto any = [&]
  {
    const double x = std::ldexp(double(random() >> 11), -53);
    return origin + size * (steps > 0.0 ? std::floor(x * steps) / steps : x);
  };
  std::vector<Point> result;
  while (result.size() < 3 * kTriangles)
  {
    const Point a{ any(), any() }, b{ any(), any() }, c{ any(), any() };
    const bool isFlat = (b.x - a.x) * (c.y - a.y) == (b.y - a.y) * (c.x - a.x);
    if (!isFlat)
    {
      result.insert(result.end(), { a, b, c });
    }
  }
  return result;
}

void expectTheSame(CentresOf* compute, const std::vector<Point>& places)
{
  std::vector<Index> vertices(places.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    vertices[i] = static_cast<Index>(i);
  }
  std::vector<Point> centres(kTriangles);
  compute(vertices.data(), places.data(), kTriangles, centres.data());
  for (std::size_t t = 0; t < kTriangles; ++t)
  {
    const Point one = circumcentre({ places[3 * t], places[3 * t + 1], places[3 * t + 2] });
    ASSERT_EQ(std::memcmp(&one, &centres[t], sizeof one), 0) << t;
  }
}

TEST(VoronoiCentres, ManyAtOnceAreThoseOfOne)
{
  const struct
  {
    double origin, size, steps;
  } kSets[] = { { 0.0, 1.0, 0.0 }, { -0.5, 1.0, 0.0 }, { 0.25, 1e-3, 0.0 }, { 1.0, 1e-13, 0.0 },
    { 0.0, 1.0, 8.0 }, { 0.0, 1.0, 10.0 }, { -1e6, 2e6, 0.0 }, { 0.0, 0x1p60, 64.0 },
    { 0.0, 0x1p-50, 512.0 } };
  std::uint64_t seed = 1;
  for (const auto& set : kSets)
  {
    const std::vector<Point> places = corners(set.origin, set.size, set.steps, seed++);
    SCOPED_TRACE(seed);
    expectTheSame(circumcentres(), places);
    expectTheSame(baseline::circumcentresHere, places);
#if AHD_HAS_X86_TARGETS
    if (processorHas(InstructionSet::Avx2))
    {
      expectTheSame(avx2::circumcentresHere, places);
    }
#endif
  }
}

} // namespace
} // namespace ahd::test
