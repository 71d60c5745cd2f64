// SPDX-License-Identifier: BSD-3-Clause
//
// Circumcentres of many triangles at once are those of one at a time, bit by bit, as compiled for
// each kind of processor; VoronoiCorners.cxx compares these with exact ones.
#include "Predicates/Predicates.h"
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

constexpr std::size_t kTriangles = 10001; // no multiple of the block size

class Drawn
{
public:
  explicit Drawn(std::uint64_t seed)
    : random_(seed)
  {
  }
  double unit() { return std::ldexp(double(random_() >> 11), -53); }
  /// `steps` of them from 0 to below 1; any number if that is 0.
  double of(double steps) { return steps > 0.0 ? std::floor(unit() * steps) / steps : unit(); }
  std::uint64_t below(std::uint64_t end) { return random_() % end; }

private:
  std::mt19937_64 random_;
};

/// Triples of corners, all by make(), without flat ones.
template <typename Make>
std::vector<Point> triangles(Make make)
{
  std::vector<Point> result;
  while (result.size() < 3 * kTriangles)
  {
    const Corners t = make();
    if (orient2d(t.a, t.b, t.c) != 0)
    {
      result.insert(result.end(), { t.a, t.b, t.c });
    }
  }
  return result;
}

void expectTheSame(CentresOf* compute, const std::vector<Point>& places, std::size_t count)
{
  // The last corner first, and every other triangle reversed: places differ from numbers.
  std::vector<Index> vertices(3 * count);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const std::size_t t = count - 1 - i / 3, k = t % 2 != 0 ? 2 - i % 3 : i % 3;
    vertices[i] = static_cast<Index>(3 * t + k);
  }
  std::vector<Point> centres(count + 1, Point{ -7.0, -7.0 });
  compute(vertices.data(), places.data(), count, centres.data());
  EXPECT_EQ(centres[count], (Point{ -7.0, -7.0 })) << "beyond the last of " << count;
  for (std::size_t t = 0; t < count; ++t)
  {
    const Index* const v = &vertices[3 * t];
    const Point one = circumcentre({ places[v[0]], places[v[1]], places[v[2]] });
    ASSERT_EQ(std::memcmp(&one, &centres[t], sizeof one), 0) << t << " of " << count;
  }
}

void expectTheSame(const std::vector<Point>& places)
{
  for (const std::size_t count : { std::size_t(0), std::size_t(1), std::size_t(31), std::size_t(32),
         std::size_t(33), kTriangles })
  {
    expectTheSame(circumcentres(), places, count);
    expectTheSame(baseline::circumcentresHere, places, count);
#if AHD_HAS_X86_TARGETS
    if (processorHas(InstructionSet::Avx2))
    {
      expectTheSame(avx2::circumcentresHere, places, count);
    }
#endif
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
    SCOPED_TRACE(seed);
    Drawn drawn(seed++);
    const auto any = [&]
    {
      const double x = set.origin + set.size * drawn.of(set.steps);
      return Point{ x, set.origin + set.size * drawn.of(set.steps) };
    };
    expectTheSame(triangles(
      [&]
      {
        const Point a = any(), b = any();
        return Corners{ a, b, any() };
      }));
  }
}

/// Flatter and flatter, beyond the limit of the blocks: centres far away, on either side.
TEST(VoronoiCentres, OfNearlyFlatTriangles)
{
  Drawn drawn(20);
  expectTheSame(triangles(
    [&]
    {
      const double flat = std::ldexp(drawn.unit() - 0.5, -int(drawn.below(50)));
      const Point a{ drawn.unit(), drawn.unit() }, b{ drawn.unit(), drawn.unit() };
      const double way = drawn.of(drawn.below(2) == 0 ? 4.0 : 0.0);
      const Point c{ a.x + way * (b.x - a.x) - flat * (b.y - a.y),
        a.y + way * (b.y - a.y) + flat * (b.x - a.x) };
      return Corners{ a, b, isModest(c) ? c : b };
    }));
}

/// Right angles with sides of a few units in the last place: half of the centres' coordinates lie
/// in the middle between two doubles, or so near to it that only the last bits decide.
TEST(VoronoiCentres, BetweenTwoDoubles)
{
  for (const double origin : { 1.0, -1.0, 1.5, 0x1p20 })
  {
    Drawn drawn(30);
    const double unit = 0x1p-52 * std::fabs(origin);
    expectTheSame(triangles(
      [&]
      {
        const auto units = [&] { return unit * double(drawn.below(16)); };
        const Point a{ origin + units(), origin + units() };
        const double far = drawn.below(2) == 0 ? units() : 0.25 * drawn.unit();
        return Corners{ a, { a.x + units(), a.y }, { a.x + units() * drawn.of(2.0), a.y + far } };
      }));
  }
}

} // namespace
} // namespace ahd::test
