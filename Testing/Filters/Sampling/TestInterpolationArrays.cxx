// SPDX-License-Identifier: BSD-3-Clause
//
// Arrays of the points that are kept otherwise, or have the names of arrays that are made.
#include "SampleTestSupport.h"

#include "vtkFloatArray.h"
#include "vtkLongLongArray.h"
#include "vtkSOADataArrayTemplate.h"

#include <gtest/gtest.h>

namespace
{

using namespace ahdtest;

/// Numbers that do not lie one after the other are the same as others.
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
  large->SetNumberOfComponents(1); // VTK 9.1 wants it said
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
    ASSERT_EQ(data->GetNumberOfArrays(), 7);
    EXPECT_EQ(data->GetArray("TGradient")->GetNumberOfComponents(), 2);
    EXPECT_EQ(data->GetArray("TGradientGradient")->GetNumberOfComponents(), 1);
    EXPECT_EQ(data->GetArray("TGradientGradientGradient")->GetNumberOfComponents(), 2);
  }
}

} // namespace
