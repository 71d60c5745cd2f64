// SPDX-License-Identifier: BSD-3-Clause
//
// Places of the second input: data sets of all types, in another plane, and rejected places.
#include "SampleTestSupport.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkTransform.h"
#include "vtkUniformGrid.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

namespace
{

using namespace ahdtest;

vtkSmartPointer<vtkPolyData> plane(std::size_t count = 500)
{
  return makeCloud(onPlane(scatteredPoints(count, 11)));
}

template <typename Image>
vtkSmartPointer<vtkDataSet> anImage()
{
  auto image = vtkSmartPointer<Image>::New();
  image->SetExtent(3, 9, -2, 4, 0, 1);
  image->SetOrigin(0.1, 0.6, 5.0);
  image->SetSpacing(0.05, 0.05, 1.0);
  return image;
}

vtkSmartPointer<vtkDataSet> aRectilinearGrid()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> along;
  for (const double x : { 0.2, 0.3, 0.55, 0.8 })
  {
    along->InsertNextValue(x);
  }
  vtkNew<vtkDoubleArray> up;
  up->InsertNextValue(0.0);
  grid->SetDimensions(4, 4, 1);
  grid->SetXCoordinates(along);
  grid->SetYCoordinates(along);
  grid->SetZCoordinates(up);
  return grid;
}

template <typename Set>
vtkSmartPointer<vtkDataSet> aPointSet(int type = VTK_DOUBLE)
{
  auto set = vtkSmartPointer<Set>::New();
  std::vector<Xyz> points;
  for (int i = 0; i < 60; ++i)
  {
    points.push_back({ 0.2 + 0.01 * i, 0.3 + 0.005 * i, 100.0 });
  }
  set->SetPoints(makePoints(points, type));
  return set;
}

std::vector<vtkSmartPointer<vtkDataSet>> allKinds()
{
  auto grid = aPointSet<vtkStructuredGrid>();
  vtkStructuredGrid::SafeDownCast(grid)->SetDimensions(6, 10, 1);
  return { anImage<vtkImageData>(), anImage<vtkUniformGrid>(), aRectilinearGrid(), grid,
    aPointSet<vtkPolyData>(), aPointSet<vtkPolyData>(VTK_FLOAT), aPointSet<vtkUnstructuredGrid>() };
}

TEST(InterpolationPlaces, OfAllTypesOfDataSets)
{
  WatchedInterpolation filter;
  filter->SetInputData(plane());
  for (const auto& places : allKinds())
  {
    filter->SetPlacesData(places);
    filter->Update();
    vtkDataSet* output = filter->GetOutput();
    EXPECT_STREQ(output->GetClassName(), places->GetClassName());
    ASSERT_EQ(output->GetNumberOfPoints(), places->GetNumberOfPoints());
    for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
    {
      Xyz p, q;
      output->GetPoint(i, p.data());
      places->GetPoint(i, q.data());
      EXPECT_EQ(p, q);
    }
    EXPECT_EQ(filter->GetNumberOfValidPlaces(), places->GetNumberOfPoints());
    EXPECT_LE(farthestFromPlane(output), 1e-14) << places->GetClassName();
  }
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  EXPECT_TRUE(filter.Said->Warnings.empty());
  EXPECT_TRUE(filter.Said->Errors.empty());
  EXPECT_TRUE(filter.PipelineSaid->Errors.empty());
  filter->SetPlacesConnection(nullptr); // a raster again
  filter->Update();
  EXPECT_NE(filter->GetImageDataOutput(), nullptr);
}

TEST(InterpolationPlaces, KeepTheirOwnArrays)
{
  auto places = makeCloud({ { 0.4, 0.4, 0 }, { 0.5, 0.5, 0 } });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0, 1 });
  places->SetVerts(verts);
  addArray<vtkDoubleArray>(places, "own", [](vtkIdType i) { return double(i); });
  addArray<vtkDoubleArray>(places, "Elevation", [](vtkIdType) { return 77.0; });
  vtkNew<vtkDoubleArray> cell;
  cell->SetName("cell");
  cell->InsertNextValue(3.0);
  places->GetCellData()->AddArray(cell);
  WatchedInterpolation filter;
  filter->SetInputData(plane());
  filter->SetPlacesData(places);
  filter->Update();
  vtkPolyData* output = filter->GetPolyDataOutput();
  EXPECT_EQ(arrayOf(output, "own"), arrayOf(places, "own"));
  EXPECT_EQ(output->GetCellData()->GetArray("cell"), cell);
  EXPECT_EQ(output->GetNumberOfVerts(), 1);
  EXPECT_NEAR(arrayOf(output, "Elevation")->GetComponent(1, 0), planeAt(0.5, 0.5), 1e-14);
  EXPECT_EQ(arrayOf(places, "Elevation")->GetComponent(1, 0), 77.0); // the input stays
  EXPECT_EQ(filter->GetPlaces(), places);
}

TEST(InterpolationPlaces, NotFiniteOnesHaveNoValueAndAreCounted)
{
  const double inf = std::numeric_limits<double>::infinity();
  WatchedInterpolation filter;
  filter->SetInputData(plane());
  filter->SetPlacesData(makeCloud(
    { { kNaN, 0.5, 0 }, { 0.5, inf, 0 }, { 0.5, 0.5, kNaN }, { 9.0, 9.0, 0 }, { 0.5, kNaN, 0 } }));
  for (const int method : { 0, 1, 2, 3 })
  {
    filter.Said->Warnings.clear();
    filter->SetMethod(method);
    filter->SetOutsideToNearestVertex();
    filter->Update();
    const auto heights = numbersOf(filter->GetOutput(), "Elevation");
    EXPECT_EQ(filter->GetNumberOfNotFinitePlaces(), 3);
    EXPECT_EQ(filter->GetNumberOfValidPlaces(), method == 3 ? 2 : 1);
    EXPECT_TRUE(std::isnan(heights[0]) && std::isnan(heights[1]) && std::isnan(heights[4]));
    EXPECT_FALSE(std::isnan(heights[2])); // z is ignored
    EXPECT_FALSE(std::isnan(heights[3]));
    ASSERT_EQ(filter.Said->Warnings.size(), 1u);
    EXPECT_NE(filter.Said->Warnings[0].find("3 of 5 places"), std::string::npos);
  }
}

TEST(InterpolationPlaces, NoneAtAll)
{
  WatchedInterpolation filter;
  filter->SetInputData(plane());
  filter->SetPlacesData(vtkSmartPointer<vtkPolyData>::New());
  for (const int method : { 0, 1, 2, 3 })
  {
    filter->SetMethod(method);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfPlaces(), 0);
    EXPECT_NE(arrayOf(filter->GetOutput(), "Elevation"), nullptr);
  }
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(InterpolationPlaces, NoneOnTheSurfaceNamesBothBounds)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  filter->SetPlacesData(makeCloud({ { 5, 6, 0 }, { 7, 8, 0 } }));
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("None of 2 places"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("x 5 to 7, y 6 to 8"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("x 0 to 1, y 0 to 1"), std::string::npos);
  WatchedInterpolation raster;
  raster->SetInputData(makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  raster->UseBoundsOn();
  raster->SetBounds(5, 9, -4, 20);
  raster->SetDimensions(3, 2);
  raster->Update();
  ASSERT_EQ(raster.Said->Warnings.size(), 1u);
  EXPECT_NE(
    raster.Said->Warnings[0].find("None of 6 places is on the surface of 1 triangles. "
                                  "Places: x 5.66666667 to 8.33333333, y 2 to 14; points: x 0"),
    std::string::npos)
    << raster.Said->Warnings[0];
}

/// A wall: points in x, z are triangulated in the plane that fits them.
TEST(InterpolationPlaces, AreMovedIntoThePlaneOfThePoints)
{
  std::vector<Xyz> wall, on;
  for (const Xyz& p : scatteredPoints(400, 6))
  {
    wall.push_back({ p[0], 0.01 * p[0] * p[1], p[1] });
  }
  for (const Xyz& p : scatteredPoints(50, 8))
  {
    on.push_back({ 0.2 + 0.5 * p[0], 0.0, 0.2 + 0.5 * p[1] });
  }
  auto cloud = makeCloud(wall);
  addArray<vtkDoubleArray>(cloud, "z", [&](vtkIdType i) { return wall[std::size_t(i)][2]; });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->SetPlacesData(makeCloud(on));
  filter->GetTriangulation()->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->Update();
  const auto fitted = numbersOf(filter->GetOutput(), "z");
  vtkNew<vtkTransform> turn;
  turn->RotateX(-90.0); // z becomes y
  filter->GetTriangulation()->SetProjectionPlaneMode(VTK_SET_TRANSFORM_PLANE);
  filter->GetTriangulation()->SetTransform(turn);
  filter->Update();
  const auto turned = numbersOf(filter->GetOutput(), "z");
  ASSERT_EQ(fitted.size(), 50u);
  ASSERT_EQ(turned.size(), 50u);
  for (std::size_t i = 0; i < 50; ++i)
  {
    EXPECT_NEAR(fitted[i], on[i][2], 0.01);
    EXPECT_NEAR(turned[i], on[i][2], 1e-12);
  }
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
}

TEST(InterpolationPlaces, AnImagesAreThoseOfItsRaster)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(onPlane(scatteredPoints(800, 12))));
  filter->SetDimensions(33, 21);
  for (const int method : { 0, 1, 3 })
  {
    filter->SetMethod(method);
    filter->SetPlacesConnection(nullptr);
    filter->Update();
    vtkNew<vtkImageData> raster;
    raster->ShallowCopy(filter->GetImageDataOutput());
    vtkNew<vtkImageData> places;
    places->CopyStructure(raster);
    filter->SetPlacesData(places);
    filter->Update();
    const auto a = numbersOf(raster, "Elevation"), b = numbersOf(filter->GetOutput(), "Elevation");
    ASSERT_EQ(a.size(), 33u * 21);
    ASSERT_EQ(a.size(), b.size());
    std::size_t valued = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      EXPECT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])));
      if (!std::isnan(b[i]))
      {
        ++valued;
        const double* at = filter->GetImageDataOutput()->GetPoint(vtkIdType(i));
        EXPECT_NEAR(b[i], planeAt(at[0], at[1]), method == 3 ? 0.5 : 1e-12);
      }
    }
    EXPECT_EQ(valued, static_cast<std::size_t>(filter->GetNumberOfValidPlaces()));
    EXPECT_GT(valued, 600u) << "most of the raster is on the surface";
  }
}

TEST(InterpolationPlaces, BlocksOfACompositeOneByOne)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, aPointSet<vtkPolyData>());
  blocks->SetBlock(2, anImage<vtkImageData>());
  WatchedInterpolation filter;
  filter->SetInputData(plane());
  filter->SetInputDataObject(1, blocks);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_LE(farthestFromPlane(vtkDataSet::SafeDownCast(output->GetBlock(0))), 1e-14);
  EXPECT_LE(farthestFromPlane(vtkDataSet::SafeDownCast(output->GetBlock(2))), 1e-14);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  filter->GetTriangulation()->KeepTriangulationOff();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
}

/// The outputs of all blocks exist at the same time, and are estimated before the first one.
TEST(InterpolationPlaces, BlocksAreRefusedBeforeTheFirst)
{
  constexpr vtkIdType kPlaces = 20000;
  constexpr int kBlocks = 20;
  const auto places = makeCloud(scatteredPoints(kPlaces, 3));
  WatchedInterpolation filter;
  filter->SetInputData(plane());
  const auto estimateOf = [&](int count)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (int k = 0; k < count; ++k)
    {
      blocks->SetBlock(static_cast<unsigned>(k), places);
    }
    filter->SetInputDataObject(1, blocks);
    filter->Update();
    return filter->GetMemoryEstimate();
  };
  const vtkTypeInt64 ofOne = estimateOf(1);
  const vtkTypeInt64 ofAll = estimateOf(kBlocks);
  constexpr vtkTypeInt64 kPutOut = kPlaces * 9 / 1024; // height and mask
  EXPECT_NEAR(double(ofAll), double(ofOne + (kBlocks - 1) * kPutOut), kBlocks);
  filter->GetTriangulation()->SetMemoryLimit(ofAll);
  EXPECT_EQ(estimateOf(kBlocks), ofAll);
  EXPECT_TRUE(filter.Said->Errors.empty());
  const int before = filter->GetNumberOfTriangulations();
  filter->GetTriangulation()->SetMemoryLimit(ofAll - 1);
  EXPECT_EQ(estimateOf(kBlocks), ofAll);
  EXPECT_EQ(filter->GetNumberOfTriangulations(), before);
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(filter.Said->Errors[0].find("400000 places"), std::string::npos);
}

/// The values that are missing of each array in all blocks together.
TEST(InterpolationPlaces, MissingValuesOfBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud({ { 0.5, 0.25, 0 }, { 0.25, 0.25, 0 }, { 0.0, 0.0, 0 } }));
  blocks->SetBlock(1, makeCloud({ { 0.0, 1.0, 0 } })); // on a vertex that has values
  blocks->SetBlock(2, makeCloud({ { 0.5, 0.5, 0 }, { 5.0, 5.0, 0 } }));
  auto points = makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  addArray<vtkDoubleArray>(points, "a", [](vtkIdType i) { return i == 1 ? kNaN : 1.0; });
  addArray<vtkDoubleArray>(points, "b", [](vtkIdType i) { return i == 0 ? kNaN : 1.0; });
  addArray<vtkDoubleArray>(points, "c", [](vtkIdType) { return 1.0; });
  WatchedInterpolation filter;
  filter->SetInputData(points);
  filter->SetInputDataObject(1, blocks);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPlacesWithoutValue(), 3 + 3);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(
    filter.Said->Warnings[0].find(
      "6 values at places on the surface are missing, because values of points are NaN: 3 of "
      "a, 3 of b. No height is missing."),
    std::string::npos)
    << filter.Said->Warnings[0];
}

/// There are some, and none where nothing ran.
TEST(InterpolationPlaces, SecondsOfBlocks)
{
  const auto places = makeCloud(scatteredPoints(20000, 5));
  const auto secondsOf = [&](std::size_t count, vtkTypeInt64 limit)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (unsigned k = 0; k < count; ++k)
    {
      blocks->SetBlock(k, places);
    }
    WatchedInterpolation filter;
    filter->SetInputData(makeCloud(scatteredPoints(2000, 3)));
    filter->SetInputDataObject(1, blocks);
    filter->GetTriangulation()->SetMemoryLimit(limit);
    filter->GetTriangulation()->SetNumberOfThreads(1);
    filter->Update();
    EXPECT_EQ(filter.Said->Errors.size(), limit > 0 ? 1u : 0u);
    return filter->GetSampleSeconds();
  };
  EXPECT_GT(secondsOf(1, 0), 0.0);
  EXPECT_GT(secondsOf(3, 0), 0.0);
  EXPECT_EQ(secondsOf(3, 1), 0.0);
}

/// Of all blocks together, once.
TEST(InterpolationPlaces, WarningsOfBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud({ { 5, 6, 0 }, { 7, 8, 0 }, { kNaN, 0, 0 } }));
  blocks->SetBlock(1, makeCloud({ { 9, -4, 0 } }));
  blocks->SetBlock(2, vtkSmartPointer<vtkPolyData>::New());
  blocks->SetBlock(3, makeCloud({ { 6, 20, 0 }, { kNaN, 0, 0 } }));
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  filter->SetInputDataObject(1, blocks);
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 2u);
  EXPECT_NE(filter.Said->Warnings[0].find("2 of 6 places have no value"), std::string::npos);
  EXPECT_NE(
    filter.Said->Warnings[1].find("None of 6 places is on the surface of 1 triangles. Places: x 5 "
                                  "to 9, y -4 to 20; points: x 0 to 1, y 0 to 1."),
    std::string::npos);
  EXPECT_EQ(filter->GetNumberOfPlacesOutside(), 4);
  filter.Said->Warnings.clear();
  blocks->SetBlock(2, makeCloud({ { 0.25, 0.25, 0 } })); // one that is on it
  blocks->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfValidPlaces(), 1);
  EXPECT_EQ(filter.Said->Warnings.size(), 1u);
}

} // namespace
