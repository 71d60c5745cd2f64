// SPDX-License-Identifier: BSD-3-Clause
//
// vtkPlanarSurfaceOutline: kept surfaces, groups of cells, data, what cannot be outlined. Rings
// themselves: Testing/Engine/Outline.
#include "vtkPlanarSurfaceOutline.h"

#include "FilterTestSupport.h"
#include "ProgressWatch.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkShortArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace ahdtest;

namespace
{
struct WatchedOutline
{
  WatchedOutline()
  {
    this->Said->Watch(this->Filter);
    this->PipelineSaid->Watch(this->Filter->GetExecutive());
  }
  vtkPlanarSurfaceOutline* operator->() { return this->Filter; }
  vtkPolyData* Of(vtkPolyData* input)
  {
    this->Filter->SetInputData(input);
    this->Filter->Update();
    EXPECT_TRUE(this->PipelineSaid->Errors.empty());
    return this->Filter->GetOutput();
  }

  vtkNew<vtkPlanarSurfaceOutline> Filter;
  vtkNew<Messages> Said;
  vtkNew<Messages> PipelineSaid;
};

/// Of each line its points; they are closed.
std::vector<std::vector<Xyz>> ringsOf(vtkPolyData* outline)
{
  std::vector<std::vector<Xyz>> rings;
  for (vtkIdType cell = 0; cell < outline->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    outline->GetCellPoints(cell, size, ids);
    EXPECT_EQ(ids[0], ids[size - 1]);
    rings.emplace_back();
    for (vtkIdType i = 0; i + 1 < size; ++i)
    {
      Xyz p;
      outline->GetPoint(ids[i], p.data());
      rings.back().push_back(p);
    }
  }
  return rings;
}

std::vector<int> intsOf(vtkPolyData* outline, const char* name)
{
  vtkDataArray* const array = outline->GetCellData()->GetArray(name);
  std::vector<int> numbers;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    numbers.push_back(int(array->GetComponent(i, 0)));
  }
  return numbers;
}

/// Four squares in a row from (0, 0), each a polygon; with a vertex and a line before them.
vtkSmartPointer<vtkPolyData> fourSquares(int type = VTK_DOUBLE)
{
  std::vector<Xyz> xyz;
  for (int i = 0; i < 10; ++i)
  {
    xyz.push_back({ double(i / 2), double(i % 2), double(i) });
  }
  auto squares = makeCloud(xyz, type);
  vtkNew<vtkCellArray> verts, lines, polys;
  verts->InsertNextCell({ 3 });
  lines->InsertNextCell({ 0, 9 });
  for (vtkIdType k = 0; k < 4; ++k)
  {
    polys->InsertNextCell({ 2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1 });
  }
  squares->SetVerts(verts);
  squares->SetLines(lines);
  squares->SetPolys(polys);
  return squares;
}

template <typename Array>
void addNumbers(vtkPolyData* data, const char* name, const std::vector<double>& numbers)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(vtkIdType(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    array->SetComponent(vtkIdType(i), 0, numbers[i]);
  }
  data->GetCellData()->AddArray(array);
}
}

/// A square with a hole, as the source keeps it.
TEST(Outline, OfASurfaceWithAHole)
{
  const auto cloud = makeCloud({ { 0, 0, 1 }, { 9, 0, 2 }, { 9, 9, 3 }, { 0, 9, 4 }, { 3, 3, 5 },
    { 6, 3, 6 }, { 6, 6, 7 }, { 3, 6, 8 } });
  vtkNew<vtkPolyData> source;
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  polys->InsertNextCell({ 4, 7, 6, 5 });
  source->SetPoints(cloud->GetPoints());
  source->SetPolys(polys);
  vtkNew<vtkAdaptiveHilbertDelaunay2D> surface;
  surface->SetInputData(cloud);
  surface->SetSourceData(source);
  WatchedOutline outline;
  outline->SetInputConnection(surface->GetOutputPort());
  outline->Update();
  EXPECT_EQ(ringsOf(outline->GetOutput()),
    (std::vector<std::vector<Xyz>>{ { { 0, 0, 1 }, { 9, 0, 2 }, { 9, 9, 3 }, { 0, 9, 4 } },
      { { 3, 3, 5 }, { 3, 6, 8 }, { 6, 6, 7 }, { 6, 3, 6 } } }));
  EXPECT_EQ(intsOf(outline->GetOutput(), "PolygonId"), (std::vector<int>{ 0, 0 }));
  EXPECT_EQ(intsOf(outline->GetOutput(), "IsHole"), (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(outline->GetOutput()->GetPointData()->GetNumberOfArrays(),
    surface->GetOutput()->GetPointData()->GetNumberOfArrays());
  EXPECT_TRUE(outline.Said->Warnings.empty());
}

TEST(Outline, GroupsAreOutlinedApart)
{
  const auto squares = fourSquares();
  addNumbers<vtkShortArray>(squares, "Band", { -9, -9, 7, 7, 3, 7 });
  WatchedOutline outline;
  outline->SetGroupArrayName("Band");
  vtkPolyData* const out = outline.Of(squares);
  EXPECT_EQ(intsOf(out, "Band"), (std::vector<int>{ 3, 7, 7 }));
  EXPECT_NE(vtkShortArray::SafeDownCast(out->GetCellData()->GetArray("Band")), nullptr);
  EXPECT_EQ(intsOf(out, "PolygonId"), (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(ringsOf(out)[0][0], (Xyz{ 2, 0, 4 }));
  EXPECT_EQ(ringsOf(out)[1].size(), 6u); // two squares
  addNumbers<vtkFloatArray>(squares, "Band", { 0, 0, 1, vtkMath::Nan(), 1, vtkMath::Nan() });
  EXPECT_EQ(intsOf(outline.Of(squares), "Band"), (std::vector<int>{ 1, 1 }));
  outline->SetGroupArrayName("None");
  EXPECT_EQ(ringsOf(outline.Of(squares)).size(), 1u);
  EXPECT_TRUE(outline.Said->Warnings.empty());
  outline->SetGroupArrayName("Missing");
  EXPECT_EQ(ringsOf(outline.Of(squares)).size(), 1u);
  ASSERT_EQ(outline.Said->Warnings.size(), 1u);
  EXPECT_NE(outline.Said->Warnings[0].find("Missing"), std::string::npos);
}

TEST(Outline, GhostsAreLeftOut)
{
  const auto squares = fourSquares();
  addNumbers<vtkUnsignedCharArray>(squares, vtkDataSetAttributes::GhostArrayName(),
    { 0, 0, 0, vtkDataSetAttributes::DUPLICATECELL, 0, vtkDataSetAttributes::HIDDENCELL });
  WatchedOutline outline;
  vtkPolyData* const out = outline.Of(squares);
  EXPECT_EQ(ringsOf(out).size(), 2u);
  EXPECT_EQ(out->GetNumberOfPoints(), 8);
  EXPECT_EQ(out->GetCellData()->GetNumberOfArrays(), 2);
}

TEST(Outline, PointsKeepTypeAndData)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    const auto squares = fourSquares(type);
    vtkNew<vtkIntArray> ids;
    ids->SetName("Own");
    for (int i = 0; i < 10; ++i)
    {
      ids->InsertNextValue(i);
    }
    vtkNew<vtkIntArray> few;
    few->SetName("Few");
    few->InsertNextValue(1);
    squares->GetPointData()->AddArray(ids);
    squares->GetPointData()->AddArray(few);
    addNumbers<vtkDoubleArray>(squares, "Band", { 0, 0, vtkMath::Nan(), 1, 1, vtkMath::Nan() });
    WatchedOutline outline;
    outline->SetGroupArrayName("Band");
    vtkPolyData* const out = outline.Of(squares);
    EXPECT_EQ(out->GetPoints()->GetDataType(), type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
    ASSERT_EQ(out->GetNumberOfPoints(), 6); // those of the two in the middle
    for (vtkIdType i = 0; i < 6; ++i)
    {
      EXPECT_EQ(out->GetPointData()->GetArray("Own")->GetComponent(i, 0), out->GetPoint(i)[2]);
    }
    EXPECT_EQ(out->GetPointData()->GetArray("Few"), nullptr);
  }
}

TEST(Outline, WhatIsNotOutlinedIsSaid)
{
  WatchedOutline outline;
  outline.Of(makeCloud({ { 0, 0, 0 }, { 1, 0, 0 } }));
  ASSERT_EQ(outline.Said->Warnings.size(), 1u);
  EXPECT_NE(outline.Said->Warnings[0].find("no polygon"), std::string::npos);
  const auto squares = fourSquares();
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  squares->SetStrips(strips);
  squares->GetPolys()->InsertNextCell({ 0, 1, 77 });
  EXPECT_EQ(ringsOf(outline.Of(squares)).size(), 1u);
  ASSERT_EQ(outline.Said->Warnings.size(), 3u);
  EXPECT_NE(outline.Said->Warnings[1].find("1 triangle strip is not"), std::string::npos);
  EXPECT_NE(outline.Said->Warnings[2].find("1 cell has fewer"), std::string::npos);
  vtkNew<vtkPolyData> nothing;
  outline.Of(nothing);
  EXPECT_EQ(outline.Said->Warnings.size(), 3u);
  EXPECT_TRUE(outline.Said->Errors.empty());
}

TEST(Outline, DamagedCellsAreAnError)
{
  const auto squares = fourSquares();
  vtkNew<vtkIdTypeArray> offsets, ids;
  for (const vtkIdType offset : { 0, 4, 2, 12 })
  {
    offsets->InsertNextValue(offset);
  }
  for (vtkIdType i = 0; i < 12; ++i)
  {
    ids->InsertNextValue(i % 10);
  }
  squares->GetPolys()->SetData(offsets, ids);
  WatchedOutline outline;
  EXPECT_EQ(outline.Of(squares)->GetNumberOfCells(), 0);
  ASSERT_EQ(outline.Said->Errors.size(), 1u);
  EXPECT_NE(outline.Said->Errors[0].find("polygons are damaged"), std::string::npos);
}

TEST(Outline, MemoryIsLimited)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> surface;
  surface->SetInputData(makeCloud(scatteredPoints(5000)));
  surface->Update();
  WatchedOutline outline;
  outline->SetMemoryLimit(500);
  EXPECT_EQ(outline.Of(surface->GetOutput())->GetNumberOfCells(), 0);
  ASSERT_EQ(outline.Said->Errors.size(), 1u);
  EXPECT_NE(outline.Said->Errors[0].find("MemoryLimit allows 512 KB"), std::string::npos);
  outline->SetMemoryLimit(2000);
  EXPECT_EQ(outline.Of(surface->GetOutput())->GetNumberOfCells(), 1);
  EXPECT_EQ(outline.Said->Errors.size(), 1u);
}

/// With an array of 4 MB at the points that rings pass.
TEST(Outline, MemoryOfItsArraysIsLimited)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> surface;
  surface->SetInputData(makeCloud(scatteredPoints(5000)));
  surface->Update();
  vtkPolyData* const made = surface->GetOutput();
  vtkNew<vtkDoubleArray> numbers, wide;
  numbers->SetName("Number"); // each triangle is a polygon
  for (vtkIdType k = 0; k < made->GetNumberOfCells(); ++k)
  {
    numbers->InsertNextValue(double(k));
  }
  made->GetCellData()->AddArray(numbers);
  WatchedOutline outline;
  outline->SetGroupArrayName("Number");
  outline->SetMemoryLimit(5000);
  EXPECT_EQ(outline.Of(made)->GetNumberOfCells(), made->GetNumberOfCells());
  wide->SetName("Wide");
  wide->SetNumberOfComponents(100);
  wide->SetNumberOfTuples(made->GetNumberOfPoints());
  wide->Fill(1.0);
  made->GetPointData()->AddArray(wide);
  EXPECT_EQ(outline.Of(made)->GetNumberOfCells(), 0);
  ASSERT_EQ(outline.Said->Errors.size(), 1u);
  EXPECT_NE(outline.Said->Errors[0].find("MemoryLimit allows 5.12 MB"), std::string::npos)
    << outline.Said->Errors[0];
  outline->SetMemoryLimit(12000);
  EXPECT_EQ(outline.Of(made)->GetNumberOfCells(), made->GetNumberOfCells());
}

TEST(Outline, IsAborted)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> surface;
  surface->SetInputData(makeCloud(scatteredPoints(200000)));
  surface->Update();
  WatchedOutline outline;
  vtkNew<ProgressWatch> watch;
  watch->AbortAt = 0.3;
  outline->AddObserver(vtkCommand::ProgressEvent, watch);
  EXPECT_EQ(outline.Of(surface->GetOutput())->GetNumberOfCells(), 0);
  EXPECT_TRUE(watch->Aborted);
  EXPECT_EQ(outline.Said->Errors.size(), 0u);
  watch->AbortAt = 2.0;
  outline->SetAbortExecute(0);
  outline->Modified();
  EXPECT_EQ(outline.Of(surface->GetOutput())->GetNumberOfCells(), 1);
}

/// An observer takes the memory away: nothing of it is read any more.
TEST(Outline, InputThatChangesMeanwhileIsAnError)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> surface;
  surface->SetInputData(makeCloud(scatteredPoints(200000)));
  surface->Update();
  struct Taker : vtkCommand
  {
    static Taker* New() { return new Taker; }
    void Execute(vtkObject*, unsigned long, void* amount) override
    {
      if (*static_cast<double*>(amount) > 0.2 && this->Points)
      {
        this->Points->SetNumberOfPoints(3);
        this->Points->Squeeze();
        this->Points = nullptr;
      }
    }
    vtkPoints* Points = nullptr;
  };
  vtkNew<Taker> taker;
  taker->Points = surface->GetOutput()->GetPoints();
  WatchedOutline outline;
  outline->AddObserver(vtkCommand::ProgressEvent, taker);
  EXPECT_EQ(outline.Of(surface->GetOutput())->GetNumberOfCells(), 0);
  EXPECT_EQ(outline.Said->Errors.size(), 1u);
}

/// An observer gives the input's vtkPoints another array: the outline is of the one it had.
TEST(Outline, PointsThatAreReplacedMeanwhileAreHeld)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> surface;
  surface->SetInputData(makeCloud(scatteredPoints(200000)));
  surface->Update();
  struct Replacer : vtkCommand
  {
    static Replacer* New() { return new Replacer; }
    void Execute(vtkObject*, unsigned long, void* amount) override
    {
      if (*static_cast<double*>(amount) > 0.2)
      {
        vtkNew<vtkFloatArray> few;
        few->SetNumberOfComponents(3);
        few->SetNumberOfTuples(3);
        this->Points->SetData(few);
      }
    }
    vtkPoints* Points = nullptr;
  };
  std::array<double, 6> bounds, outlined;
  surface->GetOutput()->GetBounds(bounds.data());
  vtkNew<Replacer> replacer;
  replacer->Points = surface->GetOutput()->GetPoints();
  WatchedOutline outline;
  outline->AddObserver(vtkCommand::ProgressEvent, replacer);
  vtkPolyData* const out = outline.Of(surface->GetOutput());
  EXPECT_EQ(surface->GetOutput()->GetNumberOfPoints(), 3);
  ASSERT_EQ(out->GetNumberOfCells(), 1);
  out->GetBounds(outlined.data());
  EXPECT_EQ(std::vector<double>(outlined.begin(), outlined.begin() + 4),
    std::vector<double>(bounds.begin(), bounds.begin() + 4));
}

/// Blocks are one surface: what two have in common at an edge is joined.
TEST(Outline, BlocksAreOneSurface)
{
  const auto squares = fourSquares();
  addNumbers<vtkShortArray>(squares, "Band", { -9, -9, 7, 7, 3, 7 });
  const auto more = makeCloud({ { 4, 0, 0 }, { 5, 0, 0 }, { 5, 1, 0 }, { 4, 1, 0 } });
  more->GetPoints()->SetPoint(0, 4, 0, 8); // the last corners of the squares
  more->GetPoints()->SetPoint(3, 4, 1, 9);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  more->SetPolys(polys);
  addNumbers<vtkShortArray>(more, "Band", { 7 });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, squares);
  blocks->SetBlock(2, more);
  WatchedOutline outline;
  outline->SetInputData(blocks);
  outline->Update();
  EXPECT_EQ(ringsOf(outline->GetOutput()).size(), 1u);
  EXPECT_EQ(outline->GetOutput()->GetNumberOfPoints(), 12);
  outline->SetGroupArrayName("Band");
  outline->Update();
  EXPECT_EQ(intsOf(outline->GetOutput(), "Band"), (std::vector<int>{ 3, 7, 7 }));
  EXPECT_EQ(ringsOf(outline->GetOutput())[2].size(), 6u); // of both blocks
  EXPECT_TRUE(outline.Said->Warnings.empty());
  blocks->SetBlock(1, vtkSmartPointer<vtkImageData>::New());
  outline->Modified();
  outline->Update();
  ASSERT_EQ(outline.Said->Warnings.size(), 1u);
  EXPECT_NE(outline.Said->Warnings[0].find("1 block is not"), std::string::npos);
}

TEST(Outline, IdsOfABlockAreItsOwn)
{
  const auto squares = fourSquares();
  squares->GetPolys()->InsertNextCell({ 0, 1, 12 }); // of 10 points
  const auto more = makeCloud({ { 7, 0, 0 }, { 8, 0, 0 }, { 8, 1, 0 } });
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 0, 1, -5 });
  more->SetPolys(polys);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, squares);
  blocks->SetBlock(1, more);
  WatchedOutline outline;
  outline->SetInputData(blocks);
  outline->Update();
  const auto rings = ringsOf(outline->GetOutput());
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_EQ(rings[0].size(), 10u);
  EXPECT_EQ(rings[1].size(), 3u);
  ASSERT_EQ(outline.Said->Warnings.size(), 1u);
  EXPECT_NE(outline.Said->Warnings[0].find("2 cells have fewer"), std::string::npos);
}

TEST(Outline, TheFirstPieceHasAll)
{
  vtkNew<vtkPlanarSurfaceOutline> outline;
  outline->SetInputData(fourSquares());
  outline->UpdatePiece(0, 3, 0);
  EXPECT_EQ(outline->GetOutput()->GetNumberOfCells(), 1);
  outline->UpdatePiece(2, 3, 0);
  EXPECT_EQ(outline->GetOutput()->GetNumberOfCells(), 0);
}
