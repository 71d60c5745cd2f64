// SPDX-License-Identifier: BSD-3-Clause
//
// Large inputs that break inexact or careless triangulators, certified one by one.
#include "Distributions.h"
#include "EngineRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

void expectCertified(const std::vector<Point>& points, const Options& options = Options())
{
  EXPECT_EQ(faultsOf(points, triangulate(points, options)), "");
}

void expectCertified(Distribution distribution, std::size_t n)
{
  SCOPED_TRACE(std::string(nameOf(distribution)) + ", " + std::to_string(n) + " points");
  expectCertified(makePoints(distribution, n, 11));
}

TEST(HardInputs, SixDistributionsOfThePaper)
{
  for (const Distribution distribution : paperDistributions())
  {
    expectCertified(distribution, reduced(200000));
  }
}

TEST(HardInputs, StrongClusters)
{
  expectCertified(Distribution::KuzminDisc, reduced(200000));
  expectCertified(Distribution::NestedClusters, reduced(200000));
  expectCertified(Distribution::CrowdedBox, reduced(200000));
}

TEST(HardInputs, IntegerLatticeOf1000By1000)
{
  const std::size_t side = reduced(1000000) == 1000000 ? 1000 : 200;
  const std::vector<Point> points = makePoints(Distribution::Lattice, side * side, 1);
  const Outcome outcome = triangulate(points);
  EXPECT_EQ(outcome.report.triangles, 2 * (side - 1) * (side - 1));
  EXPECT_EQ(faultsOf(points, outcome), "");
}

TEST(HardInputs, DecimalLattice)
{
  expectCertified(Distribution::DecimalLattice, reduced(200000));
}

TEST(HardInputs, Circles)
{
  expectCertified(Distribution::OnCircle, reduced(50000));
  expectCertified(Distribution::OnIntegerCircle, 5000);
}

TEST(HardInputs, Parabola)
{
  expectCertified(Distribution::OnParabola, reduced(50000));
}

TEST(HardInputs, CollinearPointsHaveNoTriangle)
{
  const std::vector<Point> points = makePoints(Distribution::Collinear, reduced(200000), 1);
  const Outcome outcome = triangulate(points);
  EXPECT_EQ(outcome.report.triangles, 0u);
  EXPECT_GT(outcome.report.inserted, reduced(200000) / 2);
  EXPECT_EQ(faultsOf(points, outcome), "");
}

TEST(HardInputs, CollinearPointsOnAxesAndDiagonals)
{
  for (const Point& direction : { Point{ 1, 0 }, Point{ 0, 1 }, Point{ 1, 1 }, Point{ 1, -1 } })
  {
    std::vector<Point> points;
    for (int i = 0; i < 5000; ++i)
    {
      const double t = double(i * 7919 % 5000) * 0.25;
      points.push_back({ t * direction.x, t * direction.y });
    }
    const Outcome outcome = triangulate(points);
    EXPECT_EQ(outcome.report.triangles, 0u);
    EXPECT_EQ(faultsOf(points, outcome), "");
  }
}

TEST(HardInputs, CollinearPointsAndOneApex)
{
  for (const std::size_t apexAt : { std::size_t(0), reduced(50000) / 2, reduced(50000) })
  {
    std::vector<Point> points = makePoints(Distribution::Collinear, reduced(50000), 1);
    points.insert(points.begin() + std::ptrdiff_t(apexAt), { 0.25, 0.75 });
    const Outcome outcome = triangulate(points);
    EXPECT_EQ(outcome.report.triangles, outcome.report.inserted - 2);
    EXPECT_EQ(faultsOf(points, outcome), "");
  }
}

TEST(HardInputs, TheApexComesLast)
{
  // No triangle exists until the caller's last point.
  std::vector<Point> points = makePoints(Distribution::Collinear, 2000, 1);
  points.push_back({ 0.25, 0.75 });
  Options options;
  options.order = InsertionOrder::AsGiven;
  expectCertified(points, options);
}

TEST(HardInputs, OneCavityOfAllTriangles)
{
  // The last point lies inside the circles of all triangles: the whole mesh is one cavity.
  std::vector<Point> points = makePoints(Distribution::OnIntegerCircle, 5000, 1);
  points.push_back({ 1, 1 });
  Options options;
  options.order = InsertionOrder::AsGiven;
  expectCertified(points, options);
}

/// The last point sees the ghost's place exactly, and lies so near a hull edge, on either side of
/// it, that a point there would be on the other side of its circle.
TEST(HardInputs, BesideAHullEdgeOnTheAxis)
{
  Options options;
  options.order = InsertionOrder::AsGiven;
  for (const int exponent : { -60, -75, -90, -140, -300, -500 })
  {
    const double off = std::ldexp(1.0, exponent);
    for (const Point& apex : { Point{ 0.25, 1 }, Point{ 0.25, -1 } })
    {
      for (const double side : { off, -off })
      {
        std::vector<Point> points = { { -1, 0 }, { 1, side }, apex, { 0.125, 2 * apex.y } };
        std::sort(points.begin(), points.end(), lexicographicallyLess);
        do
        {
          std::vector<Point> all = points;
          all.push_back({ 0.5, 0 });
          expectCertified(all, options);
        } while (std::next_permutation(points.begin(), points.end(), lexicographicallyLess));
      }
    }
  }
}

TEST(HardInputs, AllEqual)
{
  const std::vector<Point> points = makePoints(Distribution::AllEqual, reduced(1000000), 1);
  const Outcome outcome = triangulate(points);
  EXPECT_EQ(outcome.report.inserted, 1u);
  EXPECT_EQ(outcome.report.duplicates, points.size() - 1);
  EXPECT_EQ(faultsOf(points, outcome), "");
}

TEST(HardInputs, MillionDrawsOfAThousandPoints)
{
  const std::vector<Point> points = makePoints(Distribution::RepeatedDraws, reduced(1000000), 1);
  const Outcome outcome = triangulate(points);
  EXPECT_EQ(outcome.report.inserted, 1000u);
  EXPECT_EQ(faultsOf(points, outcome), "");
}

TEST(HardInputs, Utm)
{
  expectCertified(Distribution::Utm, reduced(200000));
}

TEST(HardInputs, Slivers)
{
  expectCertified(Distribution::Slivers, reduced(50000));
}

TEST(HardInputs, EndsOfTheExponentRange)
{
  expectCertified(Distribution::Tiny, reduced(20000));
  expectCertified(Distribution::Huge, reduced(20000));
  expectCertified(Distribution::TinyAndHuge, affordable(Distribution::TinyAndHuge, 50000));
  expectCertified(Distribution::AnyFinite, affordable(Distribution::AnyFinite, 50000));
}

TEST(HardInputs, FarFromTheOriginByOneUnitInTheLastPlace)
{
  // Neighbouring doubles near 1: a lattice whose differences are the last bits.
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i)
  {
    for (int j = 0; j < 100; ++j)
    {
      points.push_back({ 1 + i * 0x1p-52, 1 + (i * 3 + j) % 100 * 0x1p-52 });
    }
  }
  expectCertified(points);
}

TEST(HardInputs, OnePointFarAway)
{
  for (const double far : { 1e6, 1e15, 1e100, 1e307 })
  {
    std::vector<Point> points = makePoints(Distribution::Uniform, 5000, 2);
    points.push_back({ far, -far / 3 });
    expectCertified(points);
  }
}

TEST(HardInputs, LargestFiniteCoordinates)
{
  const double m = 1.7976931348623157e308;
  expectCertified({ { m, m }, { -m, m }, { m, -m }, { -m, -m }, { 0, 0 }, { 0x1p-1074, 0 },
    { 0, 0x1p-1074 }, { -0x1p-1074, 0 }, { 0, -0x1p-1074 }, { m, 0 }, { 0, -m } });
}

TEST(LongHardInputs, EveryDistributionOfAMillionPoints)
{
  for (const Distribution distribution : allDistributions())
  {
    expectCertified(distribution, affordable(distribution, 1000000));
  }
}

TEST(LongHardInputs, FourMillionPointsOfThePapersDistributions)
{
  for (const Distribution distribution : paperDistributions())
  {
    expectCertified(distribution, reduced(4000000));
  }
}

TEST(HardInputs, AreFewerUnderSanitizersOnly)
{
#ifdef AHD_REDUCED_TESTS
  EXPECT_LT(reduced(100000), 100000u) << "the tests' support was compiled for full sizes";
#else
  EXPECT_EQ(reduced(100000), 100000u);
#endif
}

TEST(LongHardInputs, ThousandsOfSmallRandomSets)
{
  Engine engine;
  for (std::uint64_t seed = 0; seed < 4000; ++seed)
  {
    for (const Distribution distribution : allDistributions())
    {
      const std::vector<Point> points = makePoints(distribution, 3 + seed % 60, seed);
      ASSERT_EQ(faultsOf(points, triangulate(engine, viewOf(points))), "")
        << nameOf(distribution) << ", seed " << seed << ", " << points.size() << " points";
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
