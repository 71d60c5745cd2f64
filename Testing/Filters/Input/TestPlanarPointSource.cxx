// SPDX-License-Identifier: BSD-3-Clause
//
// The source of points: its points are those of the tests and benchmarks, each distribution follows
// its formula, and it behaves in a pipeline.
#include "vtkPlanarPointSource.h"

#include "Distributions.h"
#include "FilterTestSupport.h"
#include "ProgressWatch.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#if defined(__linux__)
#include "AddressSpaceLimit.h"
#endif

using namespace ahdtest;
using ahd::Point;

namespace
{
using Points = std::vector<Point>;

constexpr vtkIdType kMany = 200000;
constexpr int kAll[] = { vtkPlanarPointSource::UNIFORM, vtkPlanarPointSource::LINE,
  vtkPlanarPointSource::CROSS, vtkPlanarPointSource::CIRCLE, vtkPlanarPointSource::SPIRAL,
  vtkPlanarPointSource::MIXED, vtkPlanarPointSource::LATTICE };

Points pointsOf(vtkPolyData* data)
{
  Points points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* xyz = data->GetPoint(i);
    EXPECT_EQ(xyz[2], 0.0) << "point " << i;
    points.push_back({ xyz[0], xyz[1] });
  }
  return points;
}

Points make(int distribution, vtkIdType count, int seed = 1)
{
  vtkNew<vtkPlanarPointSource> source;
  source->SetDistribution(distribution);
  source->SetNumberOfPoints(count);
  source->SetSeed(seed);
  source->Update();
  return pointsOf(source->GetOutput());
}

/// The distribution of the tests with the same name.
ahd::test::Distribution ofTests(int distribution)
{
  using ahd::test::Distribution;
  static const Distribution kSame[] = { Distribution::Uniform, Distribution::Line,
    Distribution::Cross, Distribution::Circle, Distribution::Spiral, Distribution::Mixed,
    Distribution::Lattice };
  return kSame[distribution];
}

/// Number of points for which `holds`, as a part of all.
double share(const Points& points, const std::function<bool(const Point&)>& holds)
{
  return double(std::count_if(points.begin(), points.end(), holds)) / double(points.size());
}

/// Expects `values` to be distributed as 0.01 g of the documentation about `mean`.
void expectBand(const std::vector<double>& values, double mean)
{
  ASSERT_GT(values.size(), 10000u);
  const double n = double(values.size());
  const double found = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0, largest = 0.0;
  for (const double value : values)
  {
    squares += (value - found) * (value - found);
    largest = std::max(largest, std::abs(value - mean));
  }
  // Five standard errors of 10,000 values.
  EXPECT_NEAR(found, mean, 0.0005);
  EXPECT_NEAR(std::sqrt(squares / n), 0.01, 0.0004);
  EXPECT_LE(largest, 0.06 + 1e-15);
  EXPECT_GE(largest, 0.03) << "the tails are cut off";
}

double radius(const Point& p)
{
  return std::hypot(p.x - 0.5, p.y - 0.5);
}

/// Direction from (0.5, 0.5), in turns, from 0 to 1.
double turns(const Point& p)
{
  const double angle = std::atan2(p.y - 0.5, p.x - 0.5) / (2.0 * vtkMath::Pi());
  return angle < 0.0 ? angle + 1.0 : angle;
}
}

TEST(PlanarPointSource, MakesThePointsOfTheTestsAndBenchmarks)
{
  for (const int distribution : kAll)
  {
    for (const int seed : { 1, 0, -1, 12345, INT_MAX, INT_MIN })
    {
      for (const vtkIdType count : { 1, 2, 10, 40000 })
      {
        const auto expected = ahd::test::makePoints(
          ofTests(distribution), std::size_t(count), static_cast<std::uint64_t>(seed));
        EXPECT_TRUE(make(distribution, count, seed) == expected)
          << ahd::test::nameOf(ofTests(distribution)) << ", seed " << seed << ", " << count;
      }
    }
  }
}

TEST(PlanarPointSource, Uniform)
{
  const Points points = make(vtkPlanarPointSource::UNIFORM, kMany);
  std::vector<int> counts(16, 0);
  for (const Point& p : points)
  {
    ASSERT_TRUE(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0) << p.x << " " << p.y;
    ++counts[std::size_t(p.x * 4.0) * 4 + std::size_t(p.y * 4.0)];
  }
  for (const int count : counts)
  {
    EXPECT_NEAR(count, kMany / 16.0, 5.0 * std::sqrt(kMany / 16.0));
  }
}

TEST(PlanarPointSource, Line)
{
  std::vector<double> across;
  const Points points = make(vtkPlanarPointSource::LINE, kMany);
  for (const Point& p : points)
  {
    ASSERT_TRUE(p.x >= 0.0 && p.x < 1.0) << p.x;
    across.push_back(p.y - p.x);
  }
  expectBand(across, 0.0);
  for (const double end : { 0.25, 0.5, 0.75 })
  {
    EXPECT_NEAR(share(points, [end](const Point& p) { return p.x < end; }), end, 0.006);
  }
}

TEST(PlanarPointSource, Cross)
{
  std::vector<double> rising, falling;
  const Points points = make(vtkPlanarPointSource::CROSS, kMany);
  for (const Point& p : points)
  {
    const double up = p.y - p.x, down = p.y - (1.0 - p.x);
    ASSERT_TRUE(p.x >= 0.0 && p.x < 1.0) << p.x;
    ASSERT_LE(std::min(std::abs(up), std::abs(down)), 0.06 + 1e-15) << p.x << " " << p.y;
    if (std::abs(p.x - 0.5) > 0.1) // where the bands are apart
    {
      (std::abs(up) < std::abs(down) ? rising : falling)
        .push_back(std::abs(up) < std::abs(down) ? up : down);
    }
  }
  expectBand(rising, 0.0);
  expectBand(falling, 0.0);
  EXPECT_NEAR(double(rising.size()) / double(rising.size() + falling.size()), 0.5, 0.007);
  EXPECT_NEAR(share(points, [](const Point& p) { return p.x < 0.4; }), 0.4, 0.006);
}

TEST(PlanarPointSource, Circle)
{
  std::vector<double> radii;
  const Points points = make(vtkPlanarPointSource::CIRCLE, kMany);
  std::transform(points.begin(), points.end(), std::back_inserter(radii), radius);
  expectBand(radii, 0.4);
  for (const double end : { 0.125, 0.25, 0.5, 0.75 })
  {
    EXPECT_NEAR(share(points, [end](const Point& p) { return turns(p) < end; }), end, 0.006);
  }
}

TEST(PlanarPointSource, Spiral)
{
  // Away from the centre each point belongs to one turn: they are 0.15 apart, and 0.12 wide.
  std::vector<double> across, along;
  const Points points = make(vtkPlanarPointSource::SPIRAL, kMany);
  for (const Point& p : points)
  {
    ASSERT_LE(radius(p), 0.51 + 1e-15);
    if (radius(p) > 0.1)
    {
      const double turn = std::round(radius(p) / 0.15 - turns(p)) + turns(p);
      across.push_back(radius(p) - 0.15 * turn);
      along.push_back(turn);
    }
  }
  expectBand(across, 0.0);
  // As many points from turn to turn as the curve is long there: in proportion to the squares.
  for (const double end : { 1.0, 1.5, 2.0, 2.5 })
  {
    const auto beyond = std::count_if(
      along.begin(), along.end(), [end](double turn) { return turn >= end; });
    EXPECT_NEAR(double(beyond) / double(kMany), 1.0 - end * end / 9.0, 0.006) << end;
  }
  EXPECT_LE(*std::max_element(along.begin(), along.end()), 3.0 + 0.06 / 0.15);
}

TEST(PlanarPointSource, Mixed)
{
  constexpr int kSeed = 5;
  Points centres;
  for (std::uint64_t k = 0; k < 20; ++k)
  {
    const ahd::Place centre = ahd::placeOfSet(kSeed, k);
    centres.push_back({ centre.x, centre.y });
  }
  const auto isNear = [](const Point& p, const Point& c, double distance)
  { return std::abs(p.x - c.x) <= distance && std::abs(p.y - c.y) <= distance; };
  const auto isInCluster = [&](const Point& p)
  {
    return std::any_of(
      centres.begin(), centres.end(), [&](const Point& c) { return isNear(p, c, 0.06 + 1e-15); });
  };
  const Points points = make(vtkPlanarPointSource::MIXED, kMany, kSeed);
  for (const Point& p : points)
  {
    const bool inSquare = p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0;
    ASSERT_TRUE(inSquare || isInCluster(p)) << p.x << " " << p.y;
  }
  // Beside the clusters lies half of what a uniform set has there.
  const double beside = 1.0 - share(make(vtkPlanarPointSource::UNIFORM, kMany), isInCluster);
  EXPECT_NEAR(1.0 - share(points, isInCluster), 0.5 * beside, 0.008);
  // In each cluster its own 1/40, nearly all within three deviations, and what is uniform.
  for (const Point& c : centres)
  {
    const double found = share(points, [&](const Point& p) { return isNear(p, c, 0.03); });
    EXPECT_GE(found, 0.95 / 40.0) << c.x << " " << c.y;
  }
}

TEST(PlanarPointSource, Lattice)
{
  const Points seven = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 0, 2 } };
  EXPECT_EQ(make(vtkPlanarPointSource::LATTICE, 7), seven);
  EXPECT_EQ(make(vtkPlanarPointSource::LATTICE, 7, 99), seven) << "the seed is not used";

  vtkNew<vtkPlanarPointSource> source;
  source->SetDistributionToLattice();
  source->SetNumberOfPoints(100 * 100);
  vtkNew<vtkAdaptiveHilbertDelaunay2D> surface;
  surface->SetInputConnection(source->GetOutputPort());
  surface->Update();
  EXPECT_EQ(surface->GetNumberOfTriangles(), 2 * 99 * 99);
  EXPECT_EQ(surface->GetNumberOfDuplicates(), 0);
}

TEST(PlanarPointSource, SeedsGiveOtherPointsAndMorePointsAreAppended)
{
  for (const int distribution : kAll)
  {
    if (distribution == vtkPlanarPointSource::LATTICE)
    {
      continue;
    }
    const Points first = make(distribution, 1000, 1);
    Points more = make(distribution, 3000, 1);
    std::set<double> known;
    for (const Point& p : more)
    {
      known.insert(p.x);
    }
    EXPECT_EQ(known.size(), 3000u) << "distribution " << distribution << " repeats itself";
    for (const int seed : { 2, 0, -1 })
    {
      for (const Point& p : make(distribution, 1000, seed))
      {
        EXPECT_EQ(known.count(p.x), 0u) << "distribution " << distribution << ", seed " << seed;
      }
    }
    more.resize(1000);
    EXPECT_EQ(more, first) << "distribution " << distribution;
  }
}

TEST(PlanarPointSource, RunsAgainWithTheSameResultAndLeavesVtksRandomNumbersAlone)
{
  vtkNew<vtkPlanarPointSource> source;
  source->SetDistributionToMixed();
  source->Update();
  const Points first = pointsOf(source->GetOutput());
  EXPECT_EQ(first.size(), 10000u) << "the default";
  vtkMath::RandomSeed(4711);
  const int state = vtkMath::GetSeed();
  source->Modified();
  source->Update();
  EXPECT_EQ(pointsOf(source->GetOutput()), first);
  EXPECT_EQ(vtkMath::GetSeed(), state);

  source->SetDistributionToLine();
  source->Update();
  EXPECT_NE(pointsOf(source->GetOutput()), first) << "a changed setting must make it run again";
}

TEST(PlanarPointSource, OneVertexCellHasAllPoints)
{
  vtkNew<vtkPlanarPointSource> source;
  source->SetNumberOfPoints(1000);
  source->Update();
  vtkPolyData* output = source->GetOutput();
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  ASSERT_EQ(output->GetNumberOfCells(), 1);
  EXPECT_EQ(output->GetCellType(0), VTK_POLY_VERTEX);
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  output->GetCellPoints(0, size, ids);
  ASSERT_EQ(size, 1000);
  for (vtkIdType i = 0; i < size; ++i)
  {
    EXPECT_EQ(ids[i], i);
  }
}

TEST(PlanarPointSource, NoPointsAreNoError)
{
  vtkNew<vtkPlanarPointSource> source;
  vtkNew<Messages> said;
  said->Watch(source);
  for (const int distribution : kAll)
  {
    source->SetDistribution(distribution);
    source->SetNumberOfPoints(0);
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 0);
  }
  EXPECT_TRUE(said->Errors.empty());
  EXPECT_TRUE(said->Warnings.empty());
}

TEST(PlanarPointSource, SinglePrecisionIsTheRoundedDouble)
{
  for (const int distribution : kAll)
  {
    vtkNew<vtkPlanarPointSource> source;
    source->SetDistribution(distribution);
    source->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
    Points expected = make(distribution, source->GetNumberOfPoints());
    for (Point& p : expected)
    {
      p = { double(float(p.x)), double(float(p.y)) };
    }
    EXPECT_EQ(pointsOf(source->GetOutput()), expected) << "distribution " << distribution;

    source->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  }
}

TEST(PlanarPointSource, SettingsStayWithinTheirRanges)
{
  vtkNew<vtkPlanarPointSource> source;
  source->SetNumberOfPoints(-1);
  EXPECT_EQ(source->GetNumberOfPoints(), 0);
  source->SetNumberOfPoints(VTK_INT_MAX);
  EXPECT_EQ(source->GetNumberOfPoints(), 536870912);
  source->SetDistribution(7);
  EXPECT_EQ(source->GetDistribution(), vtkPlanarPointSource::LATTICE);
  source->SetDistribution(-1);
  EXPECT_EQ(source->GetDistribution(), vtkPlanarPointSource::UNIFORM);
}

TEST(PlanarPointSource, NoPointTwice)
{
  for (const int distribution : kAll)
  {
    vtkNew<vtkPlanarPointSource> source;
    source->SetDistribution(distribution);
    source->SetNumberOfPoints(kMany);
    vtkNew<vtkAdaptiveHilbertDelaunay2D> surface;
    surface->SetInputConnection(source->GetOutputPort());
    surface->Update();
    EXPECT_EQ(surface->GetNumberOfPointsInserted(), kMany) << "distribution " << distribution;
    EXPECT_GT(surface->GetNumberOfTriangles(), kMany) << "distribution " << distribution;
  }
}

TEST(PlanarPointSource, ProgressRisesAndAnAbortLeavesNothing)
{
  constexpr vtkIdType kCount = 1000000;
  vtkNew<vtkPlanarPointSource> source;
  source->SetNumberOfPoints(kCount);
  vtkNew<Messages> said;
  said->Watch(source);
  vtkNew<ProgressWatch> watch;
  source->AddObserver(vtkCommand::ProgressEvent, watch);
  source->Update();
  EXPECT_GT(watch->Seen.size(), 20u);
  EXPECT_LE(watch->Seen.size(), 110u) << "observers may be slow";
  EXPECT_TRUE(std::is_sorted(watch->Seen.begin(), watch->Seen.end()));
  EXPECT_EQ(watch->Seen.back(), 1.0);

  for (const double at : { 0.01, 0.5, 0.9 })
  {
    watch->AbortAt = at;
    watch->Aborted = false;
    watch->SeenAfterAbort = 0;
    source->Modified();
    source->Update();
    EXPECT_TRUE(watch->Aborted) << at;
    EXPECT_LE(watch->SeenAfterAbort, 1) << "work went on after the abort at " << at;
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0) << at;
    EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 0) << at;
    watch->AbortAt = 2.0;
    source->SetAbortExecute(0); // VTK 9.1 does this by itself, later VTK leaves it to the user
    source->Modified();
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), kCount) << "after an abort at " << at;
  }
  EXPECT_TRUE(said->Errors.empty());
}

#if defined(__linux__)
TEST(PlanarPointSource, TooLittleMemoryIsAnErrorAndNoMore)
{
  vtkNew<vtkPlanarPointSource> source;
  vtkNew<Messages> said;
  said->Watch(source);
  source->SetNumberOfPoints(536870912); // 14 GiB
  {
    AddressSpaceLimit limit(100 * kMegabyte);
    ASSERT_TRUE(limit.Works);
    source->Update();
    source->Update();
  }
  ASSERT_EQ(said->Errors.size(), 1u);
  const std::string& text = said->Errors[0];
  EXPECT_NE(text.find("Making 536870912 points takes 15.1 GB"), std::string::npos) << text;
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);

  source->SetNumberOfPoints(1000);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 1000);
  EXPECT_EQ(said->Errors.size(), 1u);
}

TEST(PlanarPointSource, MemoryThatIsRefusedAfterAllIsAnErrorToo)
{
  // A limit that the estimate of available memory does not include.
  std::size_t size, resident, shared, text, library, data = 0; // in pages
  std::ifstream("/proc/self/statm") >> size >> resident >> shared >> text >> library >> data;
  vtkNew<vtkPlanarPointSource> source;
  vtkNew<Messages> said;
  said->Watch(source);
  source->SetNumberOfPoints(5000000);
  rlimit before;
  getrlimit(RLIMIT_DATA, &before);
  rlimit limit = before;
  limit.rlim_cur = data * std::size_t(sysconf(_SC_PAGESIZE)) + 50 * kMegabyte;
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &limit), 0);
  source->Update();
  setrlimit(RLIMIT_DATA, &before);
  ASSERT_EQ(said->Errors.size(), 1u);
  EXPECT_NE(said->Errors[0].find("Out of memory while making 5000000 points"), std::string::npos)
    << said->Errors[0];
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 0);
}
#endif
