// SPDX-License-Identifier: BSD-3-Clause
//
// What the filter takes: every vtkPointSet, every type of number, points marked to be left out.
#include "FilterTestSupport.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

using namespace ahdtest;

namespace
{
std::vector<Triangle> run(vtkPointSet* input)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(input);
  filter->Update();
  return trianglesOf(filter->GetOutput());
}
}

TEST(Inputs, UnstructuredGrid)
{
  const std::vector<Xyz> points = latticePoints(200, 1000);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(makePoints(points));
  EXPECT_EQ(run(grid), triangulate(points));
}

TEST(Inputs, StructuredGrid)
{
  const std::vector<Xyz> points = latticePoints(200, 1000);
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(20, 10, 1);
  grid->SetPoints(makePoints(points));
  EXPECT_EQ(run(grid), triangulate(points));
}

TEST(Inputs, PointsOfWholeNumbersAreConverted)
{
  const std::vector<Xyz> points = latticePoints(200, 1000);
  const std::vector<Triangle> expected = triangulate(points);
  for (int type : { VTK_INT, VTK_SHORT, VTK_UNSIGNED_INT, VTK_ID_TYPE })
  {
    auto cloud = makeCloud(points, type);
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->SetInputData(cloud);
    filter->Update();
    EXPECT_EQ(trianglesOf(filter->GetOutput()), expected) << "VTK type " << type;
    EXPECT_EQ(filter->GetOutput()->GetPoints(), cloud->GetPoints()) << "VTK type " << type;
  }
}

TEST(Inputs, PointsStoredComponentByComponentAreConverted)
{
  const std::vector<Xyz> points = latticePoints(200, 1000);
  vtkNew<vtkSOADataArrayTemplate<double>> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), points[i].data());
  }
  vtkNew<vtkPoints> stored;
  stored->SetData(array);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(stored);
  EXPECT_EQ(run(cloud), triangulate(points));
}

TEST(Inputs, GhostAndHiddenPointsAreLeftOut)
{
  // A square with two points in it, one a ghost, one hidden; a mark of another kind does not count.
  auto cloud = makeCloud(
    { { 0, 0, 0 }, { 8, 0, 0 }, { 8, 8, 0 }, { 0, 8, 0 }, { 3, 4, 0 }, { 5, 3, 0 }, { 4, 6, 0 } });
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(7);
  marks->FillValue(0);
  marks->SetValue(4, vtkDataSetAttributes::DUPLICATEPOINT);
  marks->SetValue(5, vtkDataSetAttributes::HIDDENPOINT);
  marks->SetValue(6, 128);
  cloud->GetPointData()->AddArray(marks);

  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->GenerateFateOn();
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 2);
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 5);
  EXPECT_EQ(filter->GetNumberOfTriangles(), 4);
  for (const Triangle& t : trianglesOf(filter->GetOutput()))
  {
    for (vtkIdType id : t)
    {
      EXPECT_TRUE(id != 4 && id != 5) << "point " << id << " is marked and was used";
    }
  }
  auto* fate = vtkIdTypeArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray("Fate"));
  ASSERT_NE(fate, nullptr);
  EXPECT_EQ(fate->GetValue(4), -2);
  EXPECT_EQ(fate->GetValue(5), -2);
  EXPECT_EQ(fate->GetValue(6), 6);
}

TEST(Inputs, BlankedPointsOfAStructuredGridAreLeftOut)
{
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(2, 2, 1);
  grid->SetPoints(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }));
  grid->BlankPoint(3);
  EXPECT_EQ(run(grid).size(), 1u);
}
