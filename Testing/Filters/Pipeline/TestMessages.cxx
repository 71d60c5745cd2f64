// SPDX-License-Identifier: BSD-3-Clause
//
// Warnings and errors: which, how often, and with which counts; and the outputs then.
#include "FilterTestSupport.h"

#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>

#if defined(__linux__)
#include "AddressSpaceLimit.h"
#include <sys/mman.h>
#endif

using namespace ahdtest;

namespace
{
const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInf = std::numeric_limits<double>::infinity();

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Runs `filter` on `xyz` and expects exactly one warning, which has each of `parts` in it.
void expectOneWarning(const std::vector<Xyz>& xyz, const std::vector<std::string>& parts)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(xyz));
  filter->Update();
  EXPECT_TRUE(filter.Said->Errors.empty()) << filter.Said->Errors[0];
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  for (const std::string& part : parts)
  {
    EXPECT_TRUE(contains(filter.Said->Warnings[0], part))
      << "no \"" << part << "\" in: " << filter.Said->Warnings[0];
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(xyz.size()));
}
}

TEST(Messages, AWallIsToldOfTheBestFittingPlane)
{
  std::vector<Xyz> wall, line, volume, soup;
  for (int i = 0; i < 40; ++i)
  {
    wall.push_back({ double(i % 8), 2.0 * (i % 8), double(i / 8) });
    line.push_back({ 0.1 * i, 0.2 * i, 0.7 * i });
    volume.push_back({ double(i % 4), double(i / 4 % 4), double(i / 16) });
    soup.push_back({ double(i % 4), double(i / 4 % 4), 7.0 });
  }
  expectOneWarning(
    wall, { "no triangle", "collinear", "not collinear in space", "Best-Fitting Plane" });
  expectOneWarning(volume, { "24 of 40 points", "DuplicatePolicy", "Best-Fitting Plane" });
  WatchedFilter filter;
  filter->SetInputData(makeCloud(soup));
  filter->Update();
  EXPECT_TRUE(filter.Said->Warnings.empty()) << "the same points several times";
  filter->SetInputData(makeCloud(line));
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_FALSE(contains(filter.Said->Warnings[0], "Best-Fitting")) << filter.Said->Warnings[0];
}

TEST(Messages, NoneForGoodPointsAndDuplicates)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(latticePoints(1000, 20)));
  filter->Update();
  EXPECT_GT(filter->GetNumberOfDuplicates(), 0);
  EXPECT_TRUE(filter.Said->Warnings.empty()) << filter.Said->Warnings[0];
  EXPECT_TRUE(filter.Said->Errors.empty()) << filter.Said->Errors[0];
}

TEST(Messages, NoneForNoPoints)
{
  for (bool withPoints : { true, false })
  {
    WatchedFilter filter;
    vtkNew<vtkPolyData> cloud;
    if (withPoints)
    {
      cloud->SetPoints(makePoints({}));
    }
    filter->SetInputData(cloud);
    filter->Update();
    EXPECT_TRUE(filter.Said->Warnings.empty()) << filter.Said->Warnings[0];
    EXPECT_TRUE(filter.Said->Errors.empty()) << filter.Said->Errors[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

TEST(Messages, FewerThanThreeDistinctPoints)
{
  expectOneWarning({ { 1, 2, 3 } }, { "fewer than three distinct", "1 distinct points among 1" });
  expectOneWarning({ { 1, 2, 3 }, { 2, 2, 3 } }, { "fewer than three", "2 distinct points" });
  expectOneWarning({ { 1, 2, 3 }, { 2, 2, 3 }, { 1, 2, 9 }, { 2, 2, 0 } },
    { "fewer than three", "2 distinct points among 4" });
}

TEST(Messages, CollinearPoints)
{
  expectOneWarning({ { 0, 0, 0 }, { 1, 2, 0 }, { 3, 6, 1 }, { -2, -4, 7 }, { 1, 2, 0 } },
    { "collinear", "4 distinct points among 5" });
}

TEST(Messages, RejectedPointsAreCountedAndTheFirstIsNamed)
{
  std::vector<Xyz> points = latticePoints(200, 1000);
  points[17][1] = kInf;
  points[40][0] = kNan;
  points[41][0] = -kInf;
  expectOneWarning(points, { "3 of 200 points", "NaN or infinite", "first is point 17" });

  WatchedFilter filter;
  filter->SetInputData(makeCloud(points, VTK_FLOAT));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 3);
  EXPECT_EQ(filter->GetNumberOfPointsInserted() + filter->GetNumberOfDuplicates(), 197);
}

TEST(Messages, HeightsThatAreNotFiniteAreKeptAndCounted)
{
  std::vector<Xyz> points = latticePoints(200, 100000);
  const std::vector<Triangle> expected = triangulate(points);
  points[5][2] = kNan;
  points[7][2] = kInf;
  expectOneWarning(points, { "2 of 200 points", " z " });

  WatchedFilter filter;
  filter->SetInputData(makeCloud(points));
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), expected);
  EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 0);
}

TEST(Messages, AllPointsRejected)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud({ { kNan, 0, 0 }, { 0, kNan, 0 }, { kInf, kInf, 0 } }));
  filter->Update();
  EXPECT_EQ(filter.Said->Warnings.size(), 2u) << "rejected points, and no triangle";
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 3);
}

TEST(Messages, ComeOncePerRun)
{
  std::vector<Xyz> points = latticePoints(200, 1000);
  points[0][0] = kNan;
  WatchedFilter filter;
  filter->SetInputData(makeCloud(points));
  filter->Update();
  filter->Update(); // nothing to do
  EXPECT_EQ(filter.Said->Warnings.size(), 1u);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter.Said->Warnings.size(), 2u);
}

TEST(Messages, TooLittleMemoryIsRefusedBeforeTheWork)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(latticePoints(10000, 100000)));
  filter->SetMemoryLimit(100);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_TRUE(contains(filter.Said->Errors[0], "MemoryLimit allows 102 KB"))
    << filter.Said->Errors[0];
  EXPECT_TRUE(contains(filter.Said->Errors[0], "10000 points")) << filter.Said->Errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetNumberOfTriangles(), 0);
  EXPECT_EQ(filter->GetInsertSeconds(), 0.0);
  const vtkTypeInt64 needed = filter->GetMemoryEstimate();
  EXPECT_GT(needed, 100);

  filter.Said->Errors.clear();
  filter->SetMemoryLimit(needed); // the requested memory is enough
  filter->Update();
  EXPECT_TRUE(filter.Said->Errors.empty()) << filter.Said->Errors[0];
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(Messages, AnErrorIsSaidOnceAndReachesTheFiltersBehind)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(latticePoints(10000, 100000)));
  vtkNew<vtkAdaptiveHilbertDelaunay2D> behind;
  behind->SetInputConnection(filter->GetOutputPort());
  behind->Update();
  EXPECT_GT(behind->GetOutput()->GetNumberOfCells(), 0);

  filter->SetMemoryLimit(100);
  behind->Update();
  behind->Update(); // as a viewer does repeatedly
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_TRUE(filter.PipelineSaid->Errors.empty()) << filter.PipelineSaid->Errors[0];
  EXPECT_EQ(behind->GetOutput()->GetNumberOfCells(), 0)
    << "an old surface stays where there is none";
}

TEST(Messages, MemoryEstimateGrowsWithWhatIsAskedFor)
{
  const auto estimate = [](std::size_t count, int type, bool fate)
  {
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->SetGenerateFate(fate);
    filter->SetInputData(makeCloud(latticePoints(count, 100000), type));
    filter->Update();
    return filter->GetMemoryEstimate();
  };
  const vtkTypeInt64 plain = estimate(10000, VTK_DOUBLE, false);
  EXPECT_GT(plain, 10000 * 32 / 1024) << "less than the output alone";
  EXPECT_GT(estimate(20000, VTK_DOUBLE, false), plain);
  EXPECT_GT(estimate(10000, VTK_DOUBLE, true), plain);
  EXPECT_GT(estimate(10000, VTK_INT, false), plain);
  EXPECT_EQ(estimate(10000, VTK_FLOAT, false), plain);
}

TEST(Messages, MemoryEstimateHasTheTablesThatAreLookedUp)
{
  constexpr vtkTypeInt64 kCount = 20000;
  WatchedFilter filter;
  filter->SetInputData(makeCloud(latticePoints(kCount, 100000)));
  const auto perPoint = [&filter]
  {
    filter->Update();
    return filter->GetMemoryEstimate() * 1024 / kCount;
  };
  const vtkTypeInt64 plain = perPoint();
  filter->GenerateNeighborsOn();
  const vtkTypeInt64 withNeighbors = perPoint();
  const vtkTypeInt64 ofNeighbors = 2 * 3 * sizeof(vtkIdType);
  EXPECT_GT(withNeighbors, plain + ofNeighbors + 24) << "corners of two triangles, and more";
  EXPECT_LT(withNeighbors, plain + ofNeighbors + 120) << "no more than tables of a triangulation";
  filter->GenerateVoronoiOn();
  const vtkTypeInt64 ofDiagram = 2 * 3 * sizeof(double) + 8 * sizeof(vtkIdType);
  const vtkTypeInt64 withDiagram = perPoint();
  EXPECT_GT(withDiagram, withNeighbors + ofDiagram + 32) << "two centres, and more";
  EXPECT_LT(withDiagram, withNeighbors + ofDiagram + 200);
  // With existing tables, arrays of cells take only their own bytes.
  filter->GenerateRegionIdsOn();
  EXPECT_NEAR(double(perPoint() - withDiagram), 2.0 * sizeof(vtkIdType), 1.0);
  filter->GenerateRegionIdsOff();
  filter->GenerateConstraintEdgesOn();
  EXPECT_NEAR(double(perPoint() - withDiagram), 2.0, 1.0);
  filter->GenerateConstraintEdgesOff();
  filter->GeneratePointStatusOn();
  EXPECT_NEAR(double(perPoint() - withDiagram), double(sizeof(vtkIdType)), 1.0);
}

/// Points that a simplified surface keeps are copies, beside all others until these are gone.
TEST(Messages, MemoryEstimateHasCopiesOfKeptPoints)
{
  constexpr int kCount = 5000;
  const auto estimate = [](int components, bool keptOnly)
  {
    auto cloud = makeCloud(latticePoints(kCount, 100000));
    vtkNew<vtkDoubleArray> data;
    data->SetName("data");
    data->SetNumberOfComponents(components);
    data->SetNumberOfTuples(kCount);
    data->Fill(0.0);
    cloud->GetPointData()->AddArray(data);
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->SetMaximumError(1.0);
    filter->SetKeptPointsOnly(keptOnly);
    filter->SetInputData(cloud);
    filter->Update();
    return 1024.0 * double(filter->GetMemoryEstimate());
  };
  // where they are, an id in an array and in a list, a new number
  constexpr double kPlaceAndIds = 3 * sizeof(double) + 2 * sizeof(vtkIdType) + 4;
  for (const int components : { 50, 100 })
  {
    const double ofData = double(sizeof(double)) * components;
    EXPECT_NEAR(estimate(components, true) - estimate(components, false),
      kCount * (ofData + kPlaceAndIds), 2 * 1024.0);
  }
}

#if defined(__linux__)
TEST(Messages, TooManyPointsAreRefused)
{
  // 2^28 points of address space without memory: only their number may be read.
  const std::size_t numbers = 3 * (std::size_t(1) << 28);
  void* nothing = mmap(nullptr, numbers * sizeof(float), PROT_NONE,
    MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (nothing == MAP_FAILED)
  {
    GTEST_SKIP() << "no 3 GiB of address space";
  }
  {
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfComponents(3);
    array->SetArray(static_cast<float*>(nothing), static_cast<vtkIdType>(numbers), 1);
    vtkNew<vtkPoints> points;
    points->SetData(array);
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    WatchedFilter filter;
    filter->SetInputData(cloud);
    filter->SetMemoryLimit(VTK_TYPE_INT64_MAX);
    for (std::size_t run = 1; run <= 3; ++run) // points that come again are looked at
    {
      cloud->Modified();
      filter->Update();
      ASSERT_EQ(filter.Said->Errors.size(), run);
      EXPECT_TRUE(contains(filter.Said->Errors.back(), "268435456 points are too many"))
        << filter.Said->Errors.back();
      EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
    }
  }
  munmap(nothing, numbers * sizeof(float));
}

TEST(Messages, TheLimitOfTheProcessIsSeen)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(latticePoints(1000000, 1000000), VTK_FLOAT));
  {
    AddressSpaceLimit limit(20 * kMegabyte);
    ASSERT_TRUE(limit.Works);
    filter->Update();
  }
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_TRUE(contains(filter.Said->Errors[0], "but there are ")) << filter.Said->Errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

namespace
{
/// Runs `filter` with more memory each time until it is enough, and expects of each run before an
/// error and nothing else. The estimate is disabled.
void expectErrorsUntilMemoryIsEnough(WatchedFilter& filter, std::size_t step)
{
  filter->SetMemoryLimit(VTK_TYPE_INT64_MAX);
  std::size_t refusals = 0;
  for (std::size_t more = step; more <= 256 * kMegabyte; more += step)
  {
    SCOPED_TRACE(std::to_string(more) + " bytes");
    filter->Modified();
    {
      AddressSpaceLimit limit(more);
      ASSERT_TRUE(limit.Works);
      filter->Update();
    }
    if (filter.Said->Errors.size() == refusals)
    {
      break; // enough
    }
    ++refusals;
    ASSERT_EQ(filter.Said->Errors.size(), refusals) << "more than one error";
    EXPECT_TRUE(contains(filter.Said->Errors.back(), "Out of memory"));
    for (int port : { 0, 1 })
    {
      EXPECT_EQ(filter->GetOutput(port)->GetNumberOfPoints(), 0) << "output " << port;
      EXPECT_EQ(filter->GetOutput(port)->GetNumberOfCells(), 0) << "output " << port;
      EXPECT_EQ(filter->GetOutput(port)->GetPointData()->GetNumberOfArrays(), 0)
        << "output " << port;
    }
    EXPECT_EQ(filter->GetNumberOfTriangles(), 0);
  }
  EXPECT_GT(refusals, 2u) << "memory never ran out: nothing was tested";
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0) << "memory never was enough";
}
}

TEST(Messages, RunningOutOfMemoryAnywhereIsAnErrorAndNoMore)
{
  // In the engine first, then in the output.
  WatchedFilter filter;
  filter->SetInputData(makeCloud(latticePoints(300000, 1000000), VTK_FLOAT));
  filter->GenerateFateOn();
  expectErrorsUntilMemoryIsEnough(filter, 4 * kMegabyte);
}

TEST(Messages, RunningOutOfMemoryInTheSecondOutputIsAnErrorAndNoMore)
{
  // So many boxes that they take more than all the rest.
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(50000)));
  filter->SetNmax(1);
  filter->GenerateInsertionRankOn();
  filter->GenerateInsertionCurveOn();
  filter->GenerateBoxesOn();
  expectErrorsUntilMemoryIsEnough(filter, kMegabyte);
  EXPECT_GT(filter->GetOutput(1)->GetNumberOfCells(), 100000);
}
#endif

TEST(Messages, UnfitMarksAreHeldAgainstThePointsOfTheInput)
{
  auto cloud = makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } });
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName("vtkGhostType");
  marks->SetNumberOfValues(2);
  marks->Fill(0);
  cloud->GetPointData()->AddArray(marks);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->BoundingTriangulationOn();
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("each of the 4 points"), std::string::npos)
    << filter.Said->Warnings[0];
}
