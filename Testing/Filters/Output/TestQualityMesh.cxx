// SPDX-License-Identifier: BSD-3-Clause
//
// The quality mesh of arrays that Python cannot make; all else of it is tested there
// (Testing/Package/Class/test_quality.py).
#include "FilterTestSupport.h"

#include "vtkAdaptiveHilbertQualityMesh2D.h"
#include "vtkDoubleArray.h"
#include "vtkSOADataArrayTemplate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace ahdtest;

/// Each point has its own size, wherever the sizes lie: SetArray() alone lays them apart.
TEST(QualityMesh, SizesOfEachPointInAnyLayout)
{
  const auto meshOf = [](vtkDataArray* sizes)
  {
    sizes->SetName("size");
    auto cloud = makeCloud(scatteredPoints(60));
    cloud->GetPointData()->AddArray(sizes);
    vtkNew<vtkAdaptiveHilbertQualityMesh2D> filter;
    filter->SetInputData(cloud);
    filter->SetSizeArrayName("size");
    filter->Update();
    EXPECT_GT(filter->GetNumberOfAddedPoints(), 10);
    return trianglesOf(filter->GetOutput(0));
  };
  std::vector<double> sizes(60);
  for (std::size_t k = 0; k < sizes.size(); ++k)
  {
    sizes[k] = 0.05 + 0.001 * double(k);
  }
  vtkNew<vtkDoubleArray> together;
  together->SetArray(sizes.data(), 60, 1);
  vtkNew<vtkSOADataArrayTemplate<double>> apart;
  apart->SetNumberOfComponents(1);
  apart->SetArray(0, sizes.data(), 60, true, true);
  const std::vector<Triangle> mesh = meshOf(together);
  EXPECT_EQ(meshOf(apart), mesh);
  std::reverse(sizes.begin(), sizes.end());
  EXPECT_NE(meshOf(together), mesh);
}
