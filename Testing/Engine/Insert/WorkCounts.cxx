// SPDX-License-Identifier: BSD-3-Clause
//
// How much work the engine does, in the paper's measures: NP, the triangles tested to locate a
// point, and NR, the triangles removed, both per inserted point. Counts do not depend on the
// machine.
#include "Distributions.h"
#include "EngineRun.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

Report countedRun(const std::vector<Point>& points, Options options = Options())
{
  options.countWork = true;
  return triangulate(points, options).report;
}

double stepsPerPoint(const Report& report)
{
  return report.np() + report.nr();
}

/// NP and NR of HG in the paper's Table 2 (2 million points).
struct PaperRow
{
  Distribution distribution;
  double np;
  double nr;
};

constexpr PaperRow kPaper[] = {
  { Distribution::Uniform, 3.91, 4.15 },
  { Distribution::Line, 4.43, 4.54 },
  { Distribution::Cross, 3.93, 4.54 },
  { Distribution::Circle, 3.77, 4.36 },
  { Distribution::Spiral, 3.73, 4.73 },
  { Distribution::Mixed, 3.98, 4.15 },
};

void expectBelowThePaper(std::size_t n)
{
  for (const PaperRow& row : kPaper)
  {
    const Report report = countedRun(makePoints(row.distribution, n, 1));
    EXPECT_LT(report.np(), row.np) << nameOf(row.distribution);
    EXPECT_LT(report.nr(), row.nr) << nameOf(row.distribution);
    // Each insertion tests at least the triangle it starts from. It adds two triangles to the mesh
    // and removes at least one; removing fewer than three on average is impossible where the mean
    // degree of a new vertex is near six only if something is not counted.
    EXPECT_GE(report.np(), 1.0) << nameOf(row.distribution);
    EXPECT_GE(report.nr(), 3.0) << nameOf(row.distribution);
  }
}

TEST(WorkCounts, BelowThePapersWithDefaultSettings)
{
  expectBelowThePaper(reduced(200000));
}

TEST(LongWorkCounts, BelowThePapersAtTwoMillionPoints)
{
  expectBelowThePaper(reduced(2000000));
}

TEST(WorkCounts, AdaptiveOrderIsNoWorseThanTheOthers)
{
  for (const Distribution distribution : paperDistributions())
  {
    const std::vector<Point> points = makePoints(distribution, reduced(100000), 1);
    Options multiGrid;
    multiGrid.order = InsertionOrder::MultiGrid;
    multiGrid.controlPoints = ControlPoints::Off;
    Options regularGrid;
    regularGrid.order = InsertionOrder::RegularGrid;
    const double adaptive = stepsPerPoint(countedRun(points));
    EXPECT_LT(adaptive, stepsPerPoint(countedRun(points, multiGrid))) << nameOf(distribution);
    EXPECT_LT(adaptive, stepsPerPoint(countedRun(points, regularGrid))) << nameOf(distribution);
  }
}

TEST(WorkCounts, ControlPointsRemoveFewerTriangles)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, reduced(200000), 1);
  Options off;
  off.controlPoints = ControlPoints::Off;
  Options single;
  single.controlPoints = ControlPoints::SingleLevel;
  const double without = countedRun(points, off).nr();
  const double withOneLevel = countedRun(points, single).nr();
  const double withEveryLevel = countedRun(points).nr();
  EXPECT_LT(withOneLevel, without);
  EXPECT_LT(withEveryLevel, without);
}

void expectAdaptive(Distribution distribution, std::size_t n)
{
  const double uniform = stepsPerPoint(countedRun(makePoints(Distribution::Uniform, n, 1)));
  const Report report = countedRun(makePoints(distribution, n, 1));
  EXPECT_LE(stepsPerPoint(report), 2 * uniform)
    << nameOf(distribution) << ": NP " << report.np() << ", NR " << report.nr();
}

TEST(WorkCounts, ClusteringCostsAtMostTwiceUniform)
{
  expectAdaptive(Distribution::KuzminDisc, reduced(200000));
  expectAdaptive(Distribution::NestedClusters, reduced(200000));
  expectAdaptive(Distribution::CrowdedBox, reduced(200000));
}

TEST(LongWorkCounts, ClusteringCostsAtMostTwiceUniformAtAMillionPoints)
{
  expectAdaptive(Distribution::KuzminDisc, reduced(1000000));
  expectAdaptive(Distribution::NestedClusters, reduced(1000000));
  expectAdaptive(Distribution::CrowdedBox, reduced(1000000));
}

/// 10^5 points in one of 2^30 boxes of the square, and its four corners.
TEST(WorkCounts, AllPointsInOneOfABillionBoxes)
{
  const double box = 0x1p-15;
  std::vector<Point> points = makePoints(Distribution::Uniform, reduced(100000), 1);
  const double uniform = stepsPerPoint(countedRun(points));
  for (Point& p : points)
  {
    p = { (12345 + p.x) * box, (23456 + p.y) * box };
  }
  points.insert(points.end(), { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } });
  const Report report = countedRun(points);
  EXPECT_LE(stepsPerPoint(report), 2 * uniform) << "NP " << report.np() << ", NR " << report.nr();
}

TEST(WorkCounts, StripsAreNoHarderThanSquares)
{
  const std::size_t n = reduced(40000);
  for (const double height : { 1.0, 0.3, 0.1, 1e-3, 1e-9, 1e-300 })
  {
    std::vector<Point> points = makePoints(Distribution::Uniform, n, 3);
    for (Point& p : points)
    {
      p.y *= height;
    }
    EXPECT_LT(countedRun(points).np(), 1.6) << "1 by " << height;
    for (Point& p : points)
    {
      p = { p.y, p.x };
    }
    EXPECT_LT(countedRun(points).np(), 1.6) << height << " by 1";
  }
}

TEST(WorkCounts, FarClustersAreNoHarderThanOne)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, reduced(40000), 4);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = { points[i].x * 1e-12 + double(i % 2), points[i].y * 1e-12 };
  }
  EXPECT_LT(countedRun(points).np(), 1.6);
}

/// Where points lie on a curve, successive ones of the order lie far from each other now and then.
/// Without jumps, and always through the triangles, 2.6, 7.2 and 3.9 triangles are tested a point.
TEST(WorkCounts, LongWalksAreCutShort)
{
  const std::size_t n = 100000;
  EXPECT_LT(countedRun(makePoints(Distribution::OnCircle, n, 1)).np(), 2.3);
  EXPECT_LT(countedRun(makePoints(Distribution::OnParabola, n, 1)).np(), 2.8);
  EXPECT_LT(countedRun(makePoints(Distribution::NearlyCollinear, n, 1)).np(), 2.8);
}

/// In the order of the caller there are no jumps, and inside of a circle it is less far than along.
TEST(WorkCounts, WithoutJumpsTheHullIsLeftSoon)
{
  Options options;
  options.order = InsertionOrder::AsGiven;
  const std::vector<Point> points = makePoints(Distribution::OnCircle, reduced(8000), 1);
  EXPECT_LT(countedRun(points, options).np(), 40.0);
}

/// Nearly all points on the hull, the others inside: along the hull it is far.
TEST(WorkCounts, AWayInsideIsNotTakenAlongTheHull)
{
  std::vector<Point> points = makePoints(Distribution::OnCircle, reduced(100000), 1);
  const std::vector<Point> inner = makePoints(Distribution::OnCircle, reduced(10000), 2);
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    const double radius = std::sqrt((double(i) + 0.5) / double(inner.size()));
    points.push_back({ inner[i].x * radius, inner[i].y * radius });
  }
  EXPECT_LT(countedRun(points).np(), 2.9);
}

} // namespace
} // namespace test
} // namespace ahd
