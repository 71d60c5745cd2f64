// SPDX-License-Identifier: BSD-3-Clause
//
// Arrays of the points in other layouts, or with the names of output arrays.
#include "SampleTestSupport.h"

#include "vtkBitArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#if __has_include("vtkAngularPeriodicDataArray.h")
#include "vtkAngularPeriodicDataArray.h"
#endif

namespace
{

using namespace ahdtest;

/// Arrays that are not contiguous give the same results.
TEST(InterpolationArrays, NearestOfOtherLayouts)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(200, 2)));
  vtkNew<vtkSOADataArrayTemplate<float>> apart;
  apart->SetName("apart");
  apart->SetNumberOfComponents(2);
  apart->SetNumberOfTuples(200);
  vtkNew<vtkFloatArray> together;
  vtkNew<vtkSOADataArrayTemplate<long long>> large;
  large->SetName("large");
  large->SetNumberOfComponents(1); // required by VTK 9.1
  large->SetNumberOfTuples(200);
  for (vtkIdType i = 0; i < 200; ++i)
  {
    apart->SetTypedComponent(i, 0, float(i));
    apart->SetTypedComponent(i, 1, i % 3 == 0 ? float(kNaN) : float(-i));
    large->SetTypedComponent(i, 0, (1LL << 60) + i);
  }
  together->DeepCopy(apart);
  together->SetName("together");
  cloud->GetPointData()->AddArray(together);
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->SetMethodToNearest();
  filter->SetPlacesData(makeCloud({ { 0.2, 0.3, 0 }, { 0.7, 0.9, 0 }, { kNaN, 0, 0 },
    { 0.1, 0.9, 0 }, { 0.4, 0.5, 0 }, { 0.9, 0.1, 0 }, { 0.5, 0.1, 0 }, { 0.8, 0.4, 0 } }));
  filter->SetNoValue(1e300); // no float
  filter->Update();
  const vtkIdType missing = filter->GetNumberOfPlacesWithoutValue();
  ASSERT_GT(missing, 0);
  cloud->GetPointData()->AddArray(apart);
  cloud->GetPointData()->AddArray(large);
  cloud->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPlacesWithoutValue(), 2 * missing);
  vtkDataSet* const output = filter->GetOutput();
  EXPECT_EQ(numbersOf(output, "apart"), numbersOf(output, "together"));
  EXPECT_EQ(arrayOf(output, "apart")->GetComponent(2, 0), std::numeric_limits<float>::max());
  auto* const found = vtkLongLongArray::SafeDownCast(arrayOf(output, "large"));
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->GetValue(2), 0);
  EXPECT_EQ(double(found->GetValue(4) - (1LL << 60)), arrayOf(output, "apart")->GetComponent(4, 0));
}

#if __has_include("vtkAngularPeriodicDataArray.h")
/// Arrays that VTK computes, as those of a periodic filter, are as their copies in memory.
TEST(InterpolationArrays, ThatAreComputed)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(200, 2)));
  vtkNew<vtkFloatArray> given, copy;
  given->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 200; ++i)
  {
    given->InsertNextTuple3(double(i), 0.5 * double(i % 7), i % 3 == 0 ? kNaN : 1.0);
  }
  vtkNew<vtkAngularPeriodicDataArray<float>> turned;
  turned->SetAxis(VTK_PERIODIC_ARRAY_AXIS_Z);
  turned->SetAngle(30.0);
  turned->InitializeArray(given);
  turned->SetName("turned");
  ASSERT_FALSE(turned->HasStandardMemoryLayout());
  copy->SetName("copy");
  copy->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 200; ++i)
  {
    copy->InsertNextTuple(turned->GetTuple(i));
  }
  cloud->GetPointData()->AddArray(copy);
  cloud->GetPointData()->AddArray(turned);
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->SetPlacesData(makeCloud(scatteredPoints(50, 3)));
  filter->SetNoValue(-7.0);
  for (const int method : { 0, 1, 2, 3 })
  {
    filter->SetMethod(method);
    filter->Update();
    const auto found = numbersOf(filter->GetOutput(), "turned");
    EXPECT_EQ(found, numbersOf(filter->GetOutput(), "copy")) << method;
    ASSERT_EQ(found.size(), 150u);
    EXPECT_GT(std::count(found.begin(), found.end(), -7.0), 0);
    EXPECT_EQ(arrayOf(filter->GetOutput(), "turned")->GetDataType(), VTK_FLOAT);
  }
}
#endif

/// Bits are those of the nearest point, and 0 where there is none.
TEST(InterpolationArrays, NearestOfBits)
{
  auto cloud = makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  vtkNew<vtkBitArray> bits;
  bits->SetName("bits");
  bits->SetNumberOfComponents(2);
  bits->SetNumberOfTuples(3);
  for (int i = 0; i < 6; ++i)
  {
    bits->SetValue(i, i == 0 || i == 3 || i == 5); // 1 0, 0 1, 0 1
  }
  cloud->GetPointData()->AddArray(bits);
  WatchedInterpolation filter;
  filter->SetInputData(cloud);
  filter->SetMethodToNearest();
  filter->SetPlacesData(
    makeCloud({ { 0.9, 0.1, 0 }, { kNaN, 0, 0 }, { 0.1, 0.1, 0 }, { 0.1, 3, 0 } }));
  filter->Update();
  EXPECT_EQ(
    numbersOf(filter->GetOutput(), "bits"), (std::vector<double>{ 0, 1, 0, 0, 1, 0, 0, 1 }));
  EXPECT_EQ(arrayOf(filter->GetOutput(), "bits")->GetDataType(), VTK_BIT);
}

/// Adds an array of this layout and type, and one of doubles with the same numbers.
template <typename Array>
void addBeside(vtkPolyData* cloud, const std::string& name, int width, double scale)
{
  vtkNew<Array> array;
  vtkNew<vtkDoubleArray> doubles;
  const std::string names[] = { name, name + " as doubles" };
  vtkDataArray* const both[] = { array, doubles };
  for (std::size_t k = 0; k < 2; ++k)
  {
    both[k]->SetName(names[k].c_str());
    both[k]->SetNumberOfComponents(width);
    both[k]->SetNumberOfTuples(cloud->GetNumberOfPoints());
  }
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < width; ++c)
    {
      array->SetComponent(i, c, scale * double((7 * i + 3 * c) % 101));
      doubles->SetComponent(i, c, array->GetComponent(i, c)); // as the type represents it
    }
  }
  cloud->GetPointData()->AddArray(array);
  cloud->GetPointData()->AddArray(doubles);
}

/// Every type and layout, with one to three columns, for an odd number of points: interpolated as
/// its numbers are.
TEST(InterpolationArrays, OtherLayoutsAndTypesAreReadAsTheirNumbers)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(201, 5)));
  std::vector<std::string> names;
  for (int width = 1; width <= 3; ++width)
  {
    const auto name = [&](const char* type)
    {
      names.push_back(type + std::to_string(width));
      return names.back();
    };
    addBeside<vtkSOADataArrayTemplate<double>>(cloud, name("soa double "), width, 0.3);
    addBeside<vtkSOADataArrayTemplate<float>>(cloud, name("soa float "), width, 0.3);
    addBeside<vtkSOADataArrayTemplate<int>>(cloud, name("soa int "), width, -3.0);
    addBeside<vtkFloatArray>(cloud, name("float "), width, 0.7);
    addBeside<vtkIntArray>(cloud, name("int "), width, -5.0);
    addBeside<vtkUnsignedCharArray>(cloud, name("byte "), width, 2.0);
    addBeside<vtkBitArray>(cloud, name("bit "), width, 1.0);
  }
  for (const int method : { 0, 1, 3 })
  {
    WatchedInterpolation filter;
    filter->SetInputData(cloud);
    filter->SetMethod(method);
    filter->SetDimensions(13, 11);
    filter->SetNoValue(-1.0);
    filter->Update();
    EXPECT_GT(filter->GetNumberOfValidPlaces(), 90);
    for (const std::string& name : names)
    {
      const auto found = numbersOf(filter->GetOutput(), name.c_str());
      auto expected = numbersOf(filter->GetOutput(), (name + " as doubles").c_str());
      ASSERT_EQ(found.size(), expected.size()) << name;
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        const bool isFloat = name.find("float") != std::string::npos;
        const bool isOutside = method == 3 && expected[i] == -1.0;
        const double as = isFloat ? double(float(expected[i])) : expected[i];
        EXPECT_TRUE(found[i] == as || isOutside) << name << " " << method << " " << i;
      }
    }
  }
}

/// Whatever the order of the arrays: a gradient has its name.
TEST(InterpolationArrays, ArraysWithTheNamesOfGradients)
{
  const std::vector<const char*> orders[] = { { "T", "TGradient", "TGradientGradient" },
    { "TGradientGradient", "TGradient", "T" }, { "TGradient", "TGradientGradient", "T" } };
  for (const auto& names : orders)
  {
    auto cloud = makeCloud(onPlane(scatteredPoints(100, 4)));
    for (const char* name : names)
    {
      addArray<vtkDoubleArray>(cloud, name, [&](vtkIdType i) { return cloud->GetPoint(i)[0]; });
    }
    WatchedInterpolation filter;
    filter->SetInputData(cloud);
    filter->GenerateGradientsOn();
    filter->Update();
    ASSERT_EQ(filter.Said->Warnings.size(), 1u) << names[0];
    EXPECT_NE(filter.Said->Warnings[0].find("not interpolated: TGradient. See"), std::string::npos);
    // that of TGradient is not made, as TGradient is not interpolated
    vtkPointData* const data = filter->GetOutput()->GetPointData();
    ASSERT_EQ(data->GetNumberOfArrays(), 8); // vtkGhostType, too
    EXPECT_EQ(data->GetArray("TGradient")->GetNumberOfComponents(), 2);
    EXPECT_EQ(data->GetArray("TGradientGradient")->GetNumberOfComponents(), 1);
    EXPECT_EQ(data->GetArray("TGradientGradientGradient")->GetNumberOfComponents(), 2);
  }
}

/// A grid of 5 x 5 points without a corner, with height and array NaN where the functions say so.
vtkSmartPointer<vtkPolyData> grid(
  const std::function<bool(int)>& noHeight, const std::function<bool(int)>& noNumber)
{
  std::vector<Xyz> points;
  std::vector<double> numbers;
  for (int i = 1; i < 25; ++i)
  {
    points.push_back({ double(i % 5), double(i / 5), noHeight(i) ? kNaN : double(i) });
    numbers.push_back(noNumber(i) ? kNaN : 1.0);
  }
  auto cloud = makeCloud(points);
  addArray<vtkFloatArray>(cloud, "number", [&](vtkIdType i) { return numbers[std::size_t(i)]; });
  return cloud;
}

bool never(int)
{
  return false;
}

/// Places of the image, 5 x 5, by their points; empty if there are no marks.
std::vector<int> hiddenOf(WatchedInterpolation& filter, vtkPolyData* cloud)
{
  filter->SetInputData(cloud);
  filter->SetDimensions(5, 5);
  filter->UseBoundsOn();
  filter->SetBounds(-0.5, 4.5, -0.5, 4.5);
  filter->Update();
  std::vector<int> hidden;
  const std::vector<double> marks = numbersOf(filter->GetOutput(), "vtkGhostType");
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    EXPECT_TRUE(marks[i] == 0 || marks[i] == vtkDataSetAttributes::HIDDENPOINT) << i;
    if (marks[i] != 0)
    {
      hidden.push_back(int(i));
    }
  }
  EXPECT_EQ(marks.empty(), hidden.empty()) << "marks that hide nothing";
  EXPECT_FALSE(arrayOf(filter->GetOutput(), "vtkValidPointMask") == nullptr);
  return hidden;
}

const std::vector<int> kNone, kCorner = { 0 };

TEST(HiddenPoints, ThoseOfAnImageAreOutside)
{
  WatchedInterpolation filter;
  auto cloud = grid(never, never);
  addArray<vtkUnsignedCharArray>(
    cloud, vtkDataSetAttributes::GhostArrayName(), [](vtkIdType) { return 0.0; });
  EXPECT_EQ(hiddenOf(filter, cloud), kCorner);
  auto* image = vtkImageData::SafeDownCast(filter->GetOutput());
  EXPECT_FALSE(image->IsPointVisible(0));
  EXPECT_FALSE(image->IsCellVisible(0)) << "its cells are hidden, too";
  EXPECT_TRUE(image->IsCellVisible(1));
  filter->SetOutsideToNearestVertex();
  EXPECT_EQ(hiddenOf(filter, cloud), kNone) << "filled";
  filter->SetOutsideToNoValue();
  filter->SetNoValue(-9999);
  EXPECT_EQ(hiddenOf(filter, cloud), kCorner) << "the number is no value";
  filter->SetMethodToNearest();
  EXPECT_EQ(hiddenOf(filter, cloud), kNone);
}

TEST(HiddenPoints, ThoseOfAnImageHaveNoValueInAnyArray)
{
  const auto upper = [](int i) { return i >= 20; };
  const auto right = [](int i) { return i % 5 == 4; };
  const std::vector<int> both = { 0, 24 };
  for (const int method : { 0, 3 })
  {
    const std::vector<int> found = method == 0 ? both : std::vector<int>{ 24 };
    WatchedInterpolation filter;
    filter->SetMethod(method);
    EXPECT_EQ(hiddenOf(filter, grid(upper, right)), found);
    filter->SetHeightArrayName("");
    EXPECT_EQ(hiddenOf(filter, grid(upper, right)), found);
    filter->SetNoValue(7);
    EXPECT_EQ(hiddenOf(filter, grid(upper, right)), method == 0 ? kCorner : kNone);
  }
  WatchedInterpolation filled; // from nowhere
  filled->SetOutsideToNearestVertex();
  const auto always = [](int) { return true; };
  EXPECT_EQ(hiddenOf(filled, grid(always, always)).size(), 25u);
}

} // namespace
