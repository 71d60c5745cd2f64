// SPDX-License-Identifier: BSD-3-Clause
//
// The cell arrays against the cells, with all triangles and where Alpha or MaximumEdgeLength drops
// some.
#include "FilterTestSupport.h"

#include "vtkCellData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace
{

using ahdtest::idsOf;
using ahdtest::Triangle;
using ahdtest::WatchedFilter;

void switchAllOn(vtkAdaptiveHilbertDelaunay2D* filter)
{
  filter->GenerateNeighborsOn();
  filter->GenerateRegionIdsOn();
  filter->GenerateConstraintEdgesOn();
}

std::vector<int> edgesOf(vtkPolyData* surface)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(
    surface->GetCellData()->GetAbstractArray("ConstraintEdges"));
  return array
    ? std::vector<int>(array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues())
    : std::vector<int>();
}

/// The correct "Neighbors", from the cells alone.
std::vector<vtkIdType> expectedNeighbors(vtkPolyData* surface)
{
  const std::vector<Triangle> cells = ahdtest::trianglesOf(surface);
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> owners;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    for (std::size_t e = 0; e < 3 && cells[cell][0] >= 0; ++e)
    {
      owners[{ cells[cell][e], cells[cell][(e + 1) % 3] }] = vtkIdType(cell);
    }
  }
  std::vector<vtkIdType> neighbors;
  for (const Triangle& cell : cells)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      const auto found = owners.find({ cell[(e + 1) % 3], cell[e] });
      neighbors.push_back(cell[0] < 0 || found == owners.end() ? -1 : found->second);
    }
  }
  return neighbors;
}

void expectRight(vtkPolyData* surface)
{
  const vtkIdType cells = surface->GetNumberOfCells();
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  vtkCellData* data = surface->GetCellData();
  ASSERT_NE(data->GetArray("Neighbors"), nullptr);
  EXPECT_EQ(data->GetArray("Neighbors")->GetNumberOfComponents(), 3);
  EXPECT_EQ(idsOf(data, "Neighbors"), expectedNeighbors(surface));
  std::vector<vtkIdType> regions(std::size_t(cells), 0);
  std::fill(regions.begin(), regions.begin() + before, -1);
  EXPECT_EQ(idsOf(data, "RegionId"), regions);
  EXPECT_EQ(edgesOf(surface), std::vector<int>(std::size_t(cells), 0));
}

TEST(CellArrays, AreOffByDefault)
{
  WatchedFilter filter;
  filter->SetInputData(ahdtest::makeCloud(ahdtest::scatteredPoints(50)));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 0);
}

TEST(CellArrays, OfAllTriangles)
{
  WatchedFilter filter;
  switchAllOn(filter.Filter);
  filter->SetInputData(ahdtest::makeCloud(ahdtest::scatteredPoints(500)));
  filter->Update();
  ASSERT_GT(filter->GetOutput()->GetNumberOfCells(), 900);
  expectRight(filter->GetOutput());
}

TEST(CellArrays, OfWhatIsKept)
{
  for (int hidden = 0; hidden < 8; ++hidden)
  {
    SCOPED_TRACE(hidden);
    WatchedFilter filter;
    switchAllOn(filter.Filter);
    filter->SetInputData(ahdtest::makeCloud(ahdtest::scatteredPoints(500)));
    filter->SetAlpha(0.025);
    filter->SetMaximumEdgeLength(0.045);
    filter->SetAlphaTris((hidden & 1) == 0);
    filter->SetAlphaLines((hidden & 2) == 0);
    filter->SetAlphaVerts((hidden & 4) == 0);
    filter->Update();
    vtkPolyData* surface = filter->GetOutput();
    EXPECT_EQ(surface->GetNumberOfPolys() == 0, (hidden & 1) != 0);
    EXPECT_EQ(surface->GetNumberOfLines() == 0, (hidden & 2) != 0);
    EXPECT_EQ(surface->GetNumberOfVerts() == 0, (hidden & 4) != 0);
    expectRight(surface);
  }
}

TEST(CellArrays, OfAConstraint)
{
  // A square cut in two by a line, and a triangle that is dropped.
  WatchedFilter filter;
  switchAllOn(filter.Filter);
  filter->SetInputData(
    ahdtest::makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 9, 0.5, 0 } }));
  vtkNew<vtkPolyData> source;
  vtkNew<vtkCellArray> lines;
  const vtkIdType diagonal[] = { 1, 3 };
  lines->InsertNextCell(2, diagonal);
  source->SetLines(lines);
  filter->SetSourceData(source);
  filter->SetMaximumEdgeLength(2.0);
  filter->Update();
  const std::vector<Triangle> triangles = ahdtest::trianglesOf(filter->GetOutput());
  ASSERT_EQ(triangles.size(), 2u);
  const std::vector<int> edges = edgesOf(filter->GetOutput());
  for (std::size_t t = 0; t < 2; ++t)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      const vtkIdType sum = triangles[t][e] + triangles[t][(e + 1) % 3];
      const bool isDiagonal = sum == 4 && triangles[t][e] % 2 == 1;
      EXPECT_EQ((edges[t] >> e) & 1, isDiagonal ? 1 : 0);
    }
  }
  EXPECT_EQ(
    idsOf(filter->GetOutput()->GetCellData(), "Neighbors"), expectedNeighbors(filter->GetOutput()));
  const auto regions = idsOf(filter->GetOutput()->GetCellData(), "RegionId");
  EXPECT_NE(regions[0], regions[1]);
}

TEST(CellArrays, RegionsAreNumberedAmongWhatIsPutOut)
{
  // A square cut in two, beside a region that is dropped whole.
  for (const double far : { -9.0, 9.0 })
  {
    SCOPED_TRACE(far);
    WatchedFilter filter;
    filter->GenerateRegionIdsOn();
    filter->SetInputData(
      ahdtest::makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { far, 0.5, 0 } }));
    vtkNew<vtkPolyData> source;
    vtkNew<vtkCellArray> lines;
    const vtkIdType ids[3][2] = { { 1, 3 }, { 0, 3 }, { 1, 2 } };
    for (const auto& line : ids)
    {
      lines->InsertNextCell(2, line);
    }
    source->SetLines(lines);
    filter->SetSourceData(source);
    filter->Update();
    EXPECT_EQ(
      idsOf(filter->GetOutput()->GetCellData(), "RegionId"), (std::vector<vtkIdType>{ 0, 1, 2 }));
    filter->SetMaximumEdgeLength(2.0);
    filter->Update();
    EXPECT_EQ(
      idsOf(filter->GetOutput()->GetCellData(), "RegionId"), (std::vector<vtkIdType>{ 0, 1 }));
  }
}

TEST(CellArrays, WithoutCells)
{
  WatchedFilter filter;
  switchAllOn(filter.Filter);
  filter->SetInputData(ahdtest::makeCloud({ { 0, 0, 0 }, { 1, 0, 0 } }));
  filter->SetAlpha(1.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 1);
  EXPECT_EQ(idsOf(filter->GetOutput()->GetCellData(), "RegionId"), std::vector<vtkIdType>{ -1 });
  EXPECT_EQ(
    idsOf(filter->GetOutput()->GetCellData(), "Neighbors"), (std::vector<vtkIdType>{ -1, -1, -1 }));
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

}
