// SPDX-License-Identifier: BSD-3-Clause
//
// The outputs of the interpolation: values of all methods, arrays of all types, mask, slopes,
// images and surfaces.
#include "SampleTestSupport.h"

#include "Engine/Sample/Sample.h"
#include "Engine/Triangulate.h"

#include "vtkBitArray.h"
#include "vtkCharArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkShortArray.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstring>

namespace
{

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertInterpolation2D;

const int kMethods[] = { Filter::LINEAR, Filter::NATURAL_NEIGHBOR, Filter::LAPLACE,
  Filter::NEAREST };

/// The engine's values at these places.
std::vector<double> sampled(
  const std::vector<Xyz>& points, const ahd::SamplePlaces& places, int method)
{
  std::vector<double> heights, out(places.count());
  for (const Xyz& p : points)
  {
    heights.push_back(p[2]);
  }
  ahd::Workspace workspace;
  ahd::Triangulation surface;
  ahd::Sampler sampler;
  ahd::SampleReport report;
  const ahd::SampleArray array{ heights.data(), 1, out.data(), nullptr };
  const ahd::PointView view(points[0].data(), points.size(), 3);
  EXPECT_EQ(ahd::triangulate(view, {}, workspace, {}, surface), ahd::Status::Ok);
  EXPECT_EQ(sampler.prepare(surface, nullptr, ahd::SampleMethod(method), {}), ahd::Status::Ok);
  EXPECT_EQ(sampler.values(places, &array, 1, nullptr, report, {}), ahd::Status::Ok);
  return out;
}

bool areSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

std::vector<Xyz> wavyPoints(std::size_t count)
{
  std::vector<Xyz> points = scatteredPoints(count, 7);
  for (Xyz& p : points)
  {
    p[2] = std::sin(9.0 * p[0]) * p[1];
  }
  return points;
}

TEST(Interpolation, IsTheEnginesToTheBit)
{
  const std::vector<Xyz> points = wavyPoints(3000);
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(points));
  filter->SetDimensions(97, 61);
  for (const int method : kMethods)
  {
    filter->SetMethod(method);
    filter->Update();
    auto* image = filter->GetImageDataOutput();
    ASSERT_EQ(image->GetNumberOfPoints(), 97 * 61);
    ahd::SampleRaster raster;
    raster.origin = { image->GetOrigin()[0], image->GetOrigin()[1] };
    raster.spacing = { image->GetSpacing()[0], image->GetSpacing()[1] };
    raster.columns = 97;
    raster.rows = 61;
    EXPECT_TRUE(
      areSame(numbersOf(image, "Elevation"), sampled(points, ahd::SamplePlaces(raster), method)))
      << method;
  }
  EXPECT_TRUE(filter.Said->Warnings.empty());
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
}

TEST(Interpolation, LinearFunctionsStay)
{
  for (const double away : { 0.0, 4.5e6 })
  {
    std::vector<Xyz> points = scatteredPoints(2000, 3);
    for (Xyz& p : points)
    {
      p = { 100.0 * p[0] + away, 100.0 * p[1], 0.0 };
    }
    WatchedInterpolation filter;
    filter->SetInputData(makeCloud(onPlane(points)));
    for (const int method : { Filter::LINEAR, Filter::NATURAL_NEIGHBOR, Filter::LAPLACE })
    {
      filter->SetMethod(method);
      filter->Update();
      EXPECT_GT(filter->GetNumberOfValidPlaces(), 60000);
      const double largest = std::abs(planeAt(away + 100.0, 0.0)) + 300.0;
      EXPECT_LE(farthestFromPlane(filter->GetOutput()), 1e-13 * largest) << method << " " << away;
    }
  }
}

TEST(Interpolation, MaskSaysWhereValuesAre)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(wavyPoints(500)));
  for (const int method : kMethods)
  {
    filter->SetMethod(method);
    filter->Update();
    const auto mask = numbersOf(filter->GetOutput(), "vtkValidPointMask");
    const auto heights = numbersOf(filter->GetOutput(), "Elevation");
    ASSERT_EQ(mask.size(), heights.size());
    vtkIdType valid = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      EXPECT_EQ(mask[i], std::isnan(heights[i]) ? 0.0 : 1.0);
      valid += mask[i] != 0.0 ? 1 : 0;
    }
    EXPECT_EQ(valid, filter->GetNumberOfValidPlaces());
    EXPECT_EQ(valid + filter->GetNumberOfPlacesOutside(), filter->GetNumberOfPlaces());
    EXPECT_EQ(valid == filter->GetNumberOfPlaces(), method == Filter::NEAREST);
    EXPECT_NE(
      vtkCharArray::SafeDownCast(arrayOf(filter->GetOutput(), "vtkValidPointMask")), nullptr);
  }
}

vtkSmartPointer<vtkPolyData> cloudOfAllTypes(std::size_t count)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(count, 9)));
  const auto whole = [](vtkIdType i) { return double(i % 100); };
  addArray<vtkFloatArray>(cloud, "float", whole);
  addArray<vtkDoubleArray>(cloud, "double", whole);
  addArray<vtkIntArray>(cloud, "int", whole);
  addArray<vtkShortArray>(cloud, "short", whole);
  addArray<vtkUnsignedCharArray>(cloud, "byte", whole);
  addArray<vtkBitArray>(cloud, "bit", [](vtkIdType i) { return double(i % 2); });
  addArray<vtkIdTypeArray>(cloud, "id", whole);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("vector");
  vectors->SetNumberOfComponents(3);
  vectors->SetComponentName(1, "north");
  vectors->SetNumberOfTuples(cloud->GetNumberOfPoints());
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    const double* p = cloud->GetPoint(i);
    vectors->SetTuple3(i, p[0], p[1], 7.0);
  }
  cloud->GetPointData()->SetVectors(vectors);
  return cloud;
}

TEST(Interpolation, TypesOfArrays)
{
  WatchedInterpolation filter;
  filter->SetInputData(cloudOfAllTypes(300));
  filter->Update();
  vtkDataSet* output = filter->GetOutput();
  for (const char* name : { "double", "int", "short", "byte", "bit", "id" })
  {
    EXPECT_STREQ(arrayOf(output, name)->GetClassName(), "vtkDoubleArray") << name;
  }
  EXPECT_STREQ(arrayOf(output, "float")->GetClassName(), "vtkFloatArray");
  EXPECT_STREQ(arrayOf(output, "vector")->GetClassName(), "vtkFloatArray");
  EXPECT_STREQ(arrayOf(output, "vector")->GetComponentName(1), "north");
  EXPECT_EQ(output->GetPointData()->GetVectors(), arrayOf(output, "vector"));
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Elevation");
  const auto vectors = numbersOf(output, "vector");
  const auto mask = numbersOf(output, "vtkValidPointMask");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const std::size_t k = std::size_t(i);
    if (mask[k] != 0.0)
    {
      EXPECT_NEAR(vectors[3 * k], output->GetPoint(i)[0], 1e-6);
      EXPECT_EQ(vectors[3 * k + 2], 7.0);
    }
    EXPECT_EQ(std::isnan(vectors[3 * k + 1]), mask[k] == 0.0);
  }
  filter->SetMethodToNearest();
  filter->Update();
  output = filter->GetOutput();
  EXPECT_STREQ(arrayOf(output, "int")->GetClassName(), "vtkIntArray");
  EXPECT_STREQ(arrayOf(output, "short")->GetClassName(), "vtkShortArray");
  EXPECT_STREQ(arrayOf(output, "byte")->GetClassName(), "vtkUnsignedCharArray");
  EXPECT_STREQ(arrayOf(output, "bit")->GetClassName(), "vtkBitArray");
  EXPECT_STREQ(arrayOf(output, "id")->GetClassName(), "vtkIdTypeArray");
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

/// With NEAREST each value is a point's, in all arrays of the same point.
TEST(Interpolation, NearestTakesValuesAsTheyAre)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(200, 2)));
  vtkNew<vtkLongLongArray> large;
  large->SetName("large");
  const long long first = (1LL << 60) + 1; // no double
  for (vtkIdType i = 0; i < 200; ++i)
  {
    large->InsertNextValue(first + i);
  }
  cloud->GetPointData()->AddArray(large);
  addArray<vtkBitArray>(cloud, "odd", [](vtkIdType i) { return double(i % 2); });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->SetMethodToNearest();
  filter->SetDimensions(40, 40);
  filter->Update();
  auto* found = vtkLongLongArray::SafeDownCast(arrayOf(filter->GetOutput(), "large"));
  ASSERT_NE(found, nullptr);
  for (vtkIdType i = 0; i < 1600; ++i)
  {
    const vtkIdType id = vtkIdType(found->GetValue(i) - first);
    ASSERT_TRUE(id >= 0 && id < 200);
    EXPECT_EQ(arrayOf(filter->GetOutput(), "Elevation")->GetComponent(i, 0),
      cloud->GetPoints()->GetPoint(id)[2]);
    EXPECT_EQ(arrayOf(filter->GetOutput(), "odd")->GetComponent(i, 0), double(id % 2));
    double best = 1e300;
    const double* at = filter->GetOutput()->GetPoint(i);
    const Xyz place = { at[0], at[1], 0 };
    const auto distance = [&](vtkIdType k)
    {
      const double* p = cloud->GetPoint(k);
      return std::hypot(p[0] - place[0], p[1] - place[1]);
    };
    for (vtkIdType k = 0; k < 200; ++k)
    {
      best = std::min(best, distance(k));
    }
    EXPECT_LE(distance(id), best * (1 + 1e-15));
  }
}

TEST(Interpolation, Gradients)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(400, 4)));
  addArray<vtkFloatArray>(cloud, "f", [&](vtkIdType i) { return cloud->GetPoint(i)[0]; });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->GenerateGradientsOn();
  filter->Update();
  vtkDataSet* output = filter->GetOutput();
  const auto slopes = numbersOf(output, "ElevationGradient");
  const auto others = numbersOf(output, "fGradient");
  const auto mask = numbersOf(output, "vtkValidPointMask");
  EXPECT_STREQ(arrayOf(output, "ElevationGradient")->GetClassName(), "vtkDoubleArray");
  EXPECT_STREQ(arrayOf(output, "fGradient")->GetClassName(), "vtkFloatArray");
  ASSERT_EQ(slopes.size(), 2 * mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    EXPECT_EQ(std::isnan(slopes[2 * i]), mask[i] == 0.0);
    if (mask[i] != 0.0)
    {
      EXPECT_NEAR(slopes[2 * i], 2.0, 1e-9);
      EXPECT_NEAR(slopes[2 * i + 1], -3.0, 1e-9);
      EXPECT_NEAR(others[2 * i], 1.0, 0.01);
    }
  }
  filter->SetMethodToLaplace();
  filter->Update();
  EXPECT_EQ(arrayOf(filter->GetOutput(), "ElevationGradient"), nullptr);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("gradients"), std::string::npos);
}

TEST(Interpolation, OutsideByTheNearestVertex)
{
  const std::vector<Xyz> points = wavyPoints(300);
  auto cloud = makeCloud(points);
  addArray<vtkIntArray>(cloud, "id", [](vtkIdType i) { return double(i); });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->UseBoundsOn();
  filter->SetBounds(-1, 2, -1, 2);
  filter->SetMethodToNearest();
  filter->Update();
  const auto nearest = numbersOf(filter->GetOutput(), "Elevation");
  filter->SetMethodToLinear();
  filter->Update();
  const auto without = numbersOf(filter->GetOutput(), "Elevation");
  const vtkIdType outside = filter->GetNumberOfPlacesOutside();
  const auto mask = numbersOf(filter->GetOutput(), "vtkValidPointMask");
  filter->SetOutsideToNearestVertex();
  filter->GenerateGradientsOn();
  filter->Update();
  const auto with = numbersOf(filter->GetOutput(), "Elevation");
  const auto ids = numbersOf(filter->GetOutput(), "id");
  const auto slopes = numbersOf(filter->GetOutput(), "ElevationGradient");
  EXPECT_EQ(numbersOf(filter->GetOutput(), "vtkValidPointMask"), mask);
  EXPECT_EQ(filter->GetNumberOfPlacesOutside(), outside);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    EXPECT_EQ(with[i], mask[i] != 0.0 ? without[i] : nearest[i]);
    EXPECT_EQ(std::isnan(slopes[2 * i]), mask[i] == 0.0);
    if (mask[i] == 0.0)
    {
      EXPECT_EQ(points[std::size_t(ids[i])][2], nearest[i]);
    }
  }
}

/// More places outside than one block of look-ups.
TEST(Interpolation, OutsideInBatches)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(wavyPoints(50)));
  filter->UseBoundsOn();
  filter->SetBounds(-9, 10, -9, 10);
  filter->SetDimensions(700, 700);
  filter->SetOutsideToNearestVertex();
  filter->Update();
  const auto heights = numbersOf(filter->GetOutput(), "Elevation");
  EXPECT_GT(filter->GetNumberOfPlacesOutside(), 1 << 18);
  EXPECT_TRUE(std::none_of(heights.begin(), heights.end(), [](double h) { return std::isnan(h); }));
}

TEST(Interpolation, NoValueOfTheUser)
{
  auto cloud = makeCloud(wavyPoints(300));
  addArray<vtkFloatArray>(cloud, "f", [](vtkIdType i) { return double(i); });
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->UseBoundsOn();
  filter->SetBounds(-1, 1, -1, 1);
  filter->GenerateGradientsOn();
  filter->SetNoValue(-9999.0);
  filter->Update();
  vtkDataSet* output = filter->GetOutput();
  const auto mask = numbersOf(output, "vtkValidPointMask");
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    for (const char* name : { "Elevation", "f", "ElevationGradient", "fGradient" })
    {
      const double value = arrayOf(output, name)->GetComponent(vtkIdType(i), 0);
      EXPECT_FALSE(std::isnan(value)) << name;
      EXPECT_EQ(value == -9999.0, mask[i] == 0.0) << name;
    }
  }
  filter->SetNoValue(1e300); // no float
  filter->Update();
  EXPECT_EQ(arrayOf(filter->GetOutput(), "f")->GetComponent(0, 0),
    double(std::numeric_limits<float>::max()));
  EXPECT_EQ(arrayOf(filter->GetOutput(), "Elevation")->GetComponent(0, 0), 1e300);
}

TEST(Interpolation, ASurfaceIsTheImageAtItsHeights)
{
  WatchedInterpolation filter;
  filter->SetInputData(makeCloud(wavyPoints(600)));
  filter->SetDimensions(50, 40);
  filter->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(filter->GetImageDataOutput());
  filter->SetOutputTypeToSurface();
  filter->Update();
  auto* grid = filter->GetStructuredGridOutput();
  ASSERT_NE(grid, nullptr);
  int dimensions[3];
  grid->GetDimensions(dimensions);
  EXPECT_EQ(dimensions[0], 50);
  EXPECT_EQ(dimensions[1], 40);
  EXPECT_EQ(dimensions[2], 1);
  const auto heights = numbersOf(image, "Elevation");
  double lowest = 1e300;
  for (const double height : heights)
  {
    lowest = std::isnan(height) ? lowest : std::min(lowest, height);
  }
  for (vtkIdType i = 0; i < 2000; ++i)
  {
    double p[3], q[3];
    grid->GetPoint(i, p);
    image->GetPoint(i, q);
    EXPECT_EQ(p[0], q[0]);
    EXPECT_EQ(p[1], q[1]);
    const bool isHidden = std::isnan(heights[std::size_t(i)]);
    EXPECT_EQ(p[2], isHidden ? lowest : heights[std::size_t(i)]);
    EXPECT_EQ(grid->IsPointVisible(i) == 0, isHidden);
  }
  EXPECT_TRUE(areSame(numbersOf(grid, "Elevation"), heights));
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
}

TEST(Interpolation, NamesOfArraysThatAreMade)
{
  auto cloud = makeCloud(wavyPoints(100));
  addArray<vtkDoubleArray>(cloud, "Elevation", [](vtkIdType) { return 5.0; });
  addArray<vtkDoubleArray>(cloud, "Other", [](vtkIdType) { return 6.0; });
  cloud->GetPointData()->SetActiveScalars("Other");
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("Elevation"), std::string::npos);
  EXPECT_NE(arrayOf(filter->GetOutput(), "Elevation")->GetRange()[1], 5.0);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "Other");
  filter->SetHeightArrayName("z");
  filter->SetValidPointMaskArrayName("isThere");
  filter->Update();
  EXPECT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_EQ(arrayOf(filter->GetOutput(), "Elevation")->GetComponent(5000, 0), 5.0);
  EXPECT_NE(arrayOf(filter->GetOutput(), "z"), nullptr);
  EXPECT_NE(arrayOf(filter->GetOutput(), "isThere"), nullptr);
  EXPECT_EQ(arrayOf(filter->GetOutput(), "vtkValidPointMask"), nullptr);
  filter->SetHeightArrayName("");
  filter->SetValidPointMaskArrayName("");
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 3); // and vtkGhostType
}

TEST(Interpolation, ArraysThatCannotBeInterpolatedAreSaidOnce)
{
  auto cloud = makeCloud(wavyPoints(100));
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  names->SetNumberOfValues(100);
  cloud->GetPointData()->AddArray(names);
  vtkNew<vtkDoubleArray> few;
  few->SetName("few");
  few->SetNumberOfTuples(99);
  cloud->GetPointData()->AddArray(few);
  vtkNew<vtkDoubleArray> nameless;
  nameless->SetNumberOfTuples(100);
  cloud->GetPointData()->AddArray(nameless);
  addArray<vtkUnsignedCharArray>(
    cloud, vtkDataSetAttributes::GhostArrayName(), [](vtkIdType) { return 0.0; });
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfTuples(100);
  cloud->GetPointData()->SetGlobalIds(ids);
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 3); // vtkGhostType of its own
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("names, few, one without a name."), std::string::npos);
  filter->SetMethodToNearest(); // takes ids as they are
  filter->Update();
  EXPECT_NE(arrayOf(filter->GetOutput(), "ids"), nullptr);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetGlobalIds(), nullptr);
}

TEST(Interpolation, CountsAreFieldData)
{
  WatchedInterpolation filter;
  const auto withFieldData = [](const std::vector<Xyz>& points, const char* name)
  {
    auto cloud = makeCloud(points);
    vtkNew<vtkIdTypeArray> array;
    array->SetName(name);
    cloud->GetFieldData()->AddArray(array);
    return cloud;
  };
  filter->SetInputData(withFieldData(wavyPoints(100), "points'"));
  filter->Update();
  vtkFieldData* data = filter->GetOutput()->GetFieldData();
  EXPECT_EQ(idsOf(data, "NumberOfPlaces"), std::vector<vtkIdType>{ 65536 });
  EXPECT_TRUE(data->HasArray("points'"));
  EXPECT_EQ(
    idsOf(data, "NumberOfValidPlaces"), std::vector<vtkIdType>{ filter->GetNumberOfValidPlaces() });
  for (const char* name : { "NumberOfPlacesOutside", "NumberOfNotFinitePlaces",
         "NumberOfPlacesWithoutValue", "NumberOfPlacesWithNeighborsLeftOut" })
  {
    EXPECT_EQ(idsOf(data, name).size(), 1u) << name;
  }
  filter->SetPlacesData(withFieldData(wavyPoints(10), "places'"));
  filter->Update();
  data = filter->GetOutput()->GetFieldData();
  EXPECT_TRUE(data->HasArray("places'"));
  EXPECT_FALSE(data->HasArray("points'"));
  EXPECT_EQ(idsOf(data, "NumberOfPlaces"), std::vector<vtkIdType>{ 10 });
}

} // namespace
