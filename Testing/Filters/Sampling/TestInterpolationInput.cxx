// SPDX-License-Identifier: BSD-3-Clause
//
// Points of the interpolation: few, duplicate, collinear, without value, in blocks, bounded by
// constraints; invalid settings.
#include "ConstraintTestSupport.h"
#include "SampleTestSupport.h"

#include "vtkDataSetAttributes.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace
{

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertInterpolation2D;

TEST(InterpolationInput, NoPoints)
{
  for (const int output : { Filter::IMAGE, Filter::SURFACE })
  {
    WatchedInterpolation filter;
    filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    filter->SetOutputType(output);
    for (const int method : { 0, 1, 2, 3 })
    {
      filter->SetMethod(method);
      filter->Update();
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
      EXPECT_EQ(filter->GetNumberOfPlaces(), 0);
    }
    filter->UseBoundsOn(); // then there is a raster, without a value
    for (const int method : { 0, 1, 2, 3 })
    {
      filter.Said->Warnings.clear();
      filter->SetMethod(method);
      filter->SetOutsideToNearestVertex();
      filter->Update();
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 65536);
      EXPECT_EQ(filter->GetNumberOfPlacesOutside(), 65536);
      EXPECT_TRUE(std::isnan(numbersOf(filter->GetOutput(), "Elevation")[77]));
      ASSERT_EQ(filter.Said->Warnings.size(), 1u);
      EXPECT_NE(filter.Said->Warnings[0].find("points: nowhere"), std::string::npos);
    }
    EXPECT_TRUE(filter.Said->Errors.empty());
  }
}

/// What the triangulation warns of, the interpolation does, alone and once.
TEST(InterpolationInput, WarningsOfTheTriangulation)
{
  const auto crossed = makeSource({ { 0, 1 }, { 2, 3 } }, {});
  auto stripped = makeSource({ { 0, 1 } }, {});
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2 });
  stripped->SetStrips(strips);
  const struct
  {
    const char* words;
    Xyz last;
    vtkIdType marks; // so many
    vtkPolyData* source;
  } rows[] = { { "vtkGhostType does not have one value", { 0.5, 0.4, 0 }, 3, nullptr },
    { "1 of 5 points were rejected", { kNaN, 0, 0 }, 0, nullptr },
    { "1 of 5 points have a z that is NaN", { 0.5, 0.4, kNaN }, 0, nullptr },
    { "1 triangle strip of the source is ignored", { 0.5, 0.4, 0 }, 0, stripped },
    { "cross", { 0.5, 0.4, 0 }, 0, crossed } };
  for (const auto& row : rows)
  {
    SCOPED_TRACE(row.words);
    auto points = makeCloud({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, row.last });
    if (row.marks > 0)
    {
      vtkNew<vtkUnsignedCharArray> marks;
      marks->SetName(vtkDataSetAttributes::GhostArrayName());
      marks->SetNumberOfValues(row.marks);
      marks->FillValue(0);
      points->GetPointData()->AddArray(marks);
    }
    WatchedFilter triangulation;
    triangulation->SetInputData(points);
    triangulation->SetSourceData(row.source);
    triangulation->Update();
    WatchedInterpolation filter;
    filter->SetInputData(points);
    filter->SetSourceData(row.source);
    filter->SetPlacesData(makeCloud({ { 0.0, 0.0, 0 } }));
    filter->Update();
    for (const auto& warnings : { triangulation.Said->Warnings, filter.Said->Warnings })
    {
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_NE(warnings[0].find(row.words), std::string::npos) << warnings[0];
    }
  }
}

TEST(InterpolationInput, OnePointHasItsValueAtItsPlace)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud({ { 3, 4, 5 } }));
  filter->Update();
  ASSERT_EQ(filter->GetNumberOfPlaces(), 1);
  EXPECT_EQ(numbersOf(filter->GetOutput(), "Elevation"), std::vector<double>{ 5.0 });
  auto* const image = vtkImageData::SafeDownCast(filter->GetOutput());
  ASSERT_EQ(image->GetNumberOfPoints(), 1);
  EXPECT_EQ(image->GetOrigin()[0], 3.0);
  EXPECT_EQ(image->GetOrigin()[1], 4.0);
  filter->SetPlacesData(makeCloud({ { 3, 4, 0 }, { 3, 4.1, 0 } }));
  filter->Update();
  const auto heights = numbersOf(filter->GetOutput(), "Elevation");
  EXPECT_EQ(heights[0], 5.0);
  EXPECT_TRUE(std::isnan(heights[1]));
  filter->SetMethodToNearest();
  filter->Update();
  EXPECT_EQ(numbersOf(filter->GetOutput(), "Elevation"), (std::vector<double>{ 5.0, 5.0 }));
}

TEST(InterpolationInput, CollinearPointsHaveValuesOnTheirLine)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud({ { 0, 0, 0 }, { 1, 2, 10 }, { 3, 6, 40 } }));
  filter->SetPlacesData(
    makeCloud({ { 0.5, 1, 0 }, { 2, 4, 0 }, { 2, 4.5, 0 }, { 4, 8, 0 }, { 3, 6, 0 } }));
  for (const int method : { 0, 1, 2 })
  {
    filter->SetMethod(method);
    filter->Update();
    const auto heights = numbersOf(filter->GetOutput(), "Elevation");
    EXPECT_EQ(heights[0], 5.0);
    EXPECT_EQ(heights[1], 25.0);
    EXPECT_TRUE(std::isnan(heights[2]) && std::isnan(heights[3]));
    EXPECT_EQ(heights[4], 40.0);
  }
}

TEST(InterpolationInput, DuplicatesByThePolicy)
{
  using Delaunay = vtkAdaptiveHilbertDelaunay2D;
  auto cloud = makeCloud({ { 0, 0, 1 }, { 4, 0, 1 }, { 0, 4, 1 }, { 4, 4, 1 }, { 2, 2, 30 },
    { 2, 2, 10 }, { 2, 2, 50 } });
  addArray<vtkDoubleArray>(cloud, "id", [](vtkIdType i) { return double(i); });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->SetPlacesData(makeCloud({ { 2, 2, 0 } }));
  const std::pair<int, std::pair<double, double>> expected[] = { { Delaunay::FIRST, { 30, 4 } },
    { Delaunay::LOWEST_Z, { 10, 5 } }, { Delaunay::HIGHEST_Z, { 50, 6 } },
    { Delaunay::MEAN_Z, { 30, 4 } } };
  for (const auto& policy : expected)
  {
    filter->GetTriangulation()->SetDuplicatePolicy(policy.first);
    filter->Update();
    EXPECT_EQ(arrayOf(filter->GetOutput(), "Elevation")->GetComponent(0, 0), policy.second.first);
    EXPECT_EQ(arrayOf(filter->GetOutput(), "id")->GetComponent(0, 0), policy.second.second);
  }
  cloud->GetPoints()->SetPoint(4, 2, 2, 60);
  cloud->GetPoints()->Modified();
  filter->Update();
  EXPECT_EQ(arrayOf(filter->GetOutput(), "Elevation")->GetComponent(0, 0), 40.0);
}

/// With NaN for one value: linear none in its triangles, natural neighbours ignore it.
TEST(InterpolationInput, ValuesThatAreNaN)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(400, 5)));
  addArray<vtkDoubleArray>(cloud, "a", [](vtkIdType i) { return i == 200 ? kNaN : 1.0; });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->Update();
  const vtkIdType without = filter->GetNumberOfPlacesWithoutValue();
  EXPECT_GT(without, 50);
  EXPECT_LT(without, 2000);
  const auto values = numbersOf(filter->GetOutput(), "a");
  const auto mask = numbersOf(filter->GetOutput(), "vtkValidPointMask");
  vtkIdType odd = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    odd += mask[i] != 0.0 && std::isnan(values[i]) ? 1 : 0;
  }
  EXPECT_EQ(odd, without);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find(std::to_string(without) + " values"), std::string::npos);
  filter->SetNoValue(-1.0);
  filter->Update();
  const auto filled = numbersOf(filter->GetOutput(), "a");
  EXPECT_EQ(
    std::count(filled.begin(), filled.end(), -1.0), without + filter->GetNumberOfPlacesOutside());
  filter.Said->Warnings.clear();
  filter->SetMethodToNaturalNeighbor();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPlacesWithoutValue(), 0);
  EXPECT_GT(filter->GetNumberOfPlacesWithNeighborsLeftOut(), without);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("natural neighbours"), std::string::npos);
  filter->SetMethodToNearest();
  filter->Update();
  EXPECT_GT(filter->GetNumberOfPlacesWithoutValue(), 50);
}

TEST(InterpolationInput, HeightsThatAreNaN)
{
  std::vector<Xyz> points = onPlane(scatteredPoints(100, 5));
  points[50][2] = kNaN;
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(points));
  filter->SetOutputTypeToSurface();
  filter->Update();
  EXPECT_GT(filter->GetNumberOfPlacesWithoutValue(), 0);
  double bounds[6];
  filter->GetOutput()->GetBounds(bounds);
  EXPECT_TRUE(std::isfinite(bounds[4]) && std::isfinite(bounds[5]));
}

/// 11 x 11 points of a lattice, heights by the plane.
std::vector<Xyz> lattice()
{
  std::vector<Xyz> points;
  for (int i = 0; i < 121; ++i)
  {
    points.push_back({ double(i % 11), double(i / 11), 0.0 });
  }
  return onPlane(points);
}

TEST(InterpolationInput, LoopsBoundTheSurface)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(lattice()));
  // an outer loop, and a hole from (4, 4) to (6, 6)
  filter->SetSourceData(makeSource({}, { { 12, 20, 108, 100 }, { 48, 70, 72, 50 } }));
  filter->SetPlacesData(
    makeCloud({ { 2.5, 2.5, 0 }, { 5.2, 5.3, 0 }, { 0.5, 0.5, 0 }, { 4, 5, 0 }, { 9.5, 3.5, 0 } }));
  for (const int method : { 0, 1, 2 })
  {
    filter->SetMethod(method);
    filter->Update();
    EXPECT_EQ(
      numbersOf(filter->GetOutput(), "vtkValidPointMask"), (std::vector<double>{ 1, 0, 0, 1, 0 }))
      << method;
    EXPECT_LE(farthestFromPlane(filter->GetOutput()), 1e-12);
  }
  EXPECT_EQ(filter->GetSource()->GetNumberOfPolys(), 2);
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
}

/// A breakline keeps the heights on it; points of the source are added with their data.
TEST(InterpolationInput, BreaklinesOfTheSourceWithPointsOfTheirOwn)
{
  auto cloud = makeCloud({ { 0, 0, 0 }, { 10, 0, 0 }, { 10, 10, 0 }, { 0, 10, 0 } });
  addArray<vtkDoubleArray>(cloud, "a", [](vtkIdType) { return 1.0; });
  auto source = makeSource({ { 0, 1 } }, {}, { { 2, 5, 7 }, { 8, 5, 7 } });
  addArray<vtkDoubleArray>(source, "a", [](vtkIdType) { return 3.0; });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->SetSourceData(source);
  filter->GetTriangulation()->SetSourceModeToCoordinates();
  filter->SetPlacesData(makeCloud({ { 5, 5, 0 }, { 5, 0, 0 }, { 5, 2.5, 0 } }));
  filter->Update();
  EXPECT_EQ(numbersOf(filter->GetOutput(), "Elevation"), (std::vector<double>{ 7, 0, 3.5 }));
  EXPECT_EQ(numbersOf(filter->GetOutput(), "a"), (std::vector<double>{ 3, 1, 2 }));
}

TEST(InterpolationInput, LongTrianglesThatAreLeftOutHaveNoValue)
{
  std::vector<Xyz> two = lattice();
  for (const Xyz& p : lattice())
  {
    two.push_back({ p[0] + 30.0, p[1], 0.0 });
  }
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(onPlane(two)));
  filter->SetPlacesData(makeCloud({ { 5.3, 5.4, 0 }, { 20, 5, 0 }, { 35.1, 5.2, 0 } }));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfValidPlaces(), 3);
  filter->GetTriangulation()->SetMaximumEdgeLength(2.0);
  for (const int method : { 0, 1, 2 })
  {
    filter->SetMethod(method);
    filter->Update();
    EXPECT_EQ(
      numbersOf(filter->GetOutput(), "vtkValidPointMask"), (std::vector<double>{ 1, 0, 1 }));
  }
  filter->GetTriangulation()->SetMaximumEdgeLength(0.0);
  filter->GetTriangulation()->SetAlpha(20.0); // in space
  filter->Update();
  EXPECT_EQ(numbersOf(filter->GetOutput(), "vtkValidPointMask"), (std::vector<double>{ 1, 0, 1 }));
}

TEST(InterpolationInput, BlocksAreOneSurface)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  std::vector<Xyz> all = onPlane(scatteredPoints(300, 2));
  blocks->SetBlock(0, makeCloud({ all.begin(), all.begin() + 100 }));
  blocks->SetBlock(3, makeCloud({ all.begin() + 100, all.end() }));
  WatchedInterpolation filter;
  filter->SetInputDataObject(blocks);
  filter->Update();
  const auto merged = numbersOf(filter->GetOutput(), "Elevation");
  EXPECT_TRUE(filter.Said->Warnings.empty());
  filter->SetInputData(makeCloud(all));
  filter->Update();
  const auto whole = numbersOf(filter->GetOutput(), "Elevation");
  ASSERT_EQ(merged.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    EXPECT_TRUE(merged[i] == whole[i] || (std::isnan(merged[i]) && std::isnan(whole[i])));
  }
}

/// Ghosts and points that are not finite are no part of the raster's bounds.
TEST(InterpolationInput, BoundsAreThoseOfPointsThatCount)
{
  auto cloud = makeCloud(
    { { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { 50, 50, 1 }, { kNaN, 7, 0 } });
  addArray<vtkUnsignedCharArray>(cloud, vtkDataSetAttributes::GhostArrayName(),
    [](vtkIdType i) { return i == 4 ? vtkDataSetAttributes::DUPLICATEPOINT : 0; });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->SetDimensions(4, 4);
  filter->Update();
  EXPECT_EQ(filter->GetImageDataOutput()->GetSpacing()[0], 0.25);
  EXPECT_EQ(filter->GetImageDataOutput()->GetOrigin()[1], 0.125);
  EXPECT_EQ(filter->GetNumberOfValidPlaces(), 16);
}

TEST(InterpolationInput, BoundsAreThoseInThePlane)
{
  WatchedInterpolation filter;
  std::vector<Xyz> wall;
  for (const Xyz& p : scatteredPoints(500, 1))
  {
    wall.push_back({ 3.0 * p[0], 0.0, 2.0 * p[1] });
  }
  filter->SetInputData(makeCloud(wall));
  filter->GetTriangulation()->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->Update();
  const double* spacing = filter->GetImageDataOutput()->GetSpacing();
  EXPECT_NEAR(256 * std::max(spacing[0], spacing[1]), 3.0, 0.1);
  EXPECT_NEAR(256 * std::min(spacing[0], spacing[1]), 2.0, 0.1);
  EXPECT_GT(filter->GetNumberOfValidPlaces(), 50000);
  const auto heights = numbersOf(filter->GetOutput(), "Elevation");
  EXPECT_TRUE(
    std::none_of(heights.begin(), heights.end(), [](double h) { return std::abs(h) > 1e-12; }));
}

/// One error, no output, and correct again afterwards.
void expectOneError(WatchedInterpolation& filter, const char* word)
{
  filter.Said->Errors.clear();
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u) << word;
  EXPECT_NE(filter.Said->Errors[0].find(word), std::string::npos) << filter.Said->Errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetNumberOfPlaces(), 0);
  EXPECT_TRUE(filter.PipelineSaid->Errors.empty());
}

TEST(InterpolationInput, SettingsThatMakeNoSense)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(lattice()));
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0.0, 1.0);
  expectOneError(filter, "CellSize is 0, 1");
  filter->SetCellSize(1.0, -2.0);
  expectOneError(filter, "CellSize is 1, -2");
  filter->SetCellSize(kNaN, 1.0);
  expectOneError(filter, "CellSize is nan, 1");
  filter->SetCellSize(1e-10, 1.0);
  expectOneError(filter, "1e+11 x 10 cells");
  filter->SetCellSize(1.0, 1.0);
  filter->UseBoundsOn();
  filter->SetBounds(1, 0, 0, 1);
  expectOneError(filter, "Bounds are x 1 to 0, y 0 to 1");
  filter->SetBounds(0, 1, kNaN, 1);
  expectOneError(filter, "Bounds are");
  filter->SetBounds(-1.7e308, 1.7e308, 0, 1);
  filter->SetRasterSizeToByDimensions();
  expectOneError(filter, "wider or higher than the largest number");
  filter->SetRasterSizeToByCellSize();
  filter->SetBounds(0, 10, 0, 10);
  auto* triangulation = filter->GetTriangulation();
  triangulation->Register(nullptr);
  filter->SetTriangulation(nullptr);
  expectOneError(filter, "Triangulation is null");
  filter->SetTriangulation(triangulation);
  triangulation->UnRegister(nullptr);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPlaces(), 100);
  EXPECT_EQ(filter->GetNumberOfValidPlaces(), 100);
}

TEST(InterpolationInput, NamesThatCannotBe)
{
  for (const bool isSurface : { false, true })
  {
    WatchedInterpolation filter;
    filter->SetInputData(makeCloud(lattice()));
    filter->SetOutputType(isSurface ? Filter::SURFACE : Filter::IMAGE);
    filter->SetHeightArrayName("vtkValidPointMask");
    expectOneError(filter, "are both \"vtkValidPointMask\"");
    filter->SetPlacesData(makeCloud(lattice()));
    expectOneError(filter, "are both \"vtkValidPointMask\"");
    filter->SetHeightArrayName("vtkGhostType");
    expectOneError(filter, "HeightArrayName is \"vtkGhostType\"");
    filter->SetHeightArrayName("z");
    filter->SetValidPointMaskArrayName("vtkGhostType");
    expectOneError(filter, "ValidPointMaskArrayName is \"vtkGhostType\"");
    filter->SetValidPointMaskArrayName("zGradient");
    filter->GenerateGradientsOn();
    expectOneError(filter, "ValidPointMaskArrayName is \"zGradient\"");
    filter->GenerateGradientsOff();
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfValidPlaces(), 121);
    filter->SetHeightArrayName("");
    filter->SetValidPointMaskArrayName(""); // none of both
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfValidPlaces(), 121);
    EXPECT_EQ(filter.Said->Errors.size(), 1u);
  }
}

} // namespace
