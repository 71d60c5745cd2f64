// SPDX-License-Identifier: BSD-3-Clause
//
// The filter's inputs: every vtkPointSet, every type of number, points marked to be left out.
#include "ConstraintTestSupport.h"
#include "FilterTestSupport.h"

#include "vtkAdaptiveHilbertInterpolation2D.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
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

TEST(Inputs, MarksThatDoNotFitThePointsAreIgnoredAndTold)
{
  const std::vector<Xyz> points = latticePoints(1000, 1000);
  for (const auto& [tuples, components] :
    std::vector<std::pair<vtkIdType, int>>{ { 0, 1 }, { 1, 1 }, { 1001, 1 }, { 1000, 2 } })
  {
    auto cloud = makeCloud(points);
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfComponents(components);
    marks->SetNumberOfTuples(tuples);
    marks->FillValue(vtkDataSetAttributes::DUPLICATEPOINT);
    cloud->GetPointData()->AddArray(marks);
    WatchedFilter filter;
    filter->SetInputData(cloud);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 0) << tuples << " marks";
    ASSERT_EQ(filter.Said->Warnings.size(), 1u) << tuples << " marks";
    EXPECT_NE(
      filter.Said->Warnings[0].find("one value for each of the 1000 points"), std::string::npos)
      << filter.Said->Warnings[0];
  }
}

TEST(Inputs, BlocksThatHaveNoPointsOfTheirOwnAreTold)
{
  // The pipeline passes on the blocks of a composite data set whatever their type.
  const std::vector<Xyz> points = latticePoints(200, 1000);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkImageData>());
  blocks->SetBlock(2, vtkNew<vtkPolyData>());
  blocks->SetBlock(3, makeCloud(points));
  WatchedFilter filter;
  filter->SetInputDataObject(blocks);
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("vtkImageData"), std::string::npos)
    << filter.Said->Warnings[0];
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(made, nullptr);
  EXPECT_EQ(made->GetBlock(1), nullptr);
  for (unsigned int block : { 0u, 2u })
  {
    auto* surface = vtkPolyData::SafeDownCast(made->GetBlock(block));
    ASSERT_NE(surface, nullptr) << "block " << block;
    EXPECT_EQ(surface->GetNumberOfCells(), 0) << "block " << block;
  }
  EXPECT_EQ(trianglesOf(vtkPolyData::SafeDownCast(made->GetBlock(3))), triangulate(points));
}

/// An array whose time changed makes all its other users run again.
TEST(Inputs, TimesOfWhatIsReadStay)
{
  auto cloud = makeCloud(scatteredPoints(50));
  auto source = makeSource({ { 0, 1 } }, {}, { { 0.1, 0.2, 0 }, { 0.8, 0.7, 0 } });
  const auto times = [&]
  {
    return std::vector<vtkMTimeType>{ cloud->GetMTime(), cloud->GetPoints()->GetMTime(),
      cloud->GetPoints()->GetData()->GetMTime(), source->GetMTime(),
      source->GetPoints()->GetData()->GetMTime() };
  };
  const auto before = times();
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->SetSourceData(source);
  filter->SetSourceModeToCoordinates();
  filter->Update();
  EXPECT_EQ(times(), before);
  vtkNew<vtkAdaptiveHilbertInterpolation2D> values;
  values->SetInputData(cloud);
  values->SetSourceData(source);
  values->SetDimensions(4, 4);
  values->Update();
  EXPECT_EQ(times(), before);
}
