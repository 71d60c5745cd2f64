// SPDX-License-Identifier: BSD-3-Clause
//
// Sources with invalid offsets of cells: one error that says where, no output, no read out of
// bounds.
#include "BadDataSupport.h"
#include "SampleTestSupport.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

using namespace ahdtest;

namespace
{
const std::vector<Xyz> kSquare = { { 0, 0, 1 }, { 4, 0, 2 }, { 4, 4, 3 }, { 0, 4, 4 } };
const std::vector<vtkIdType> kIds = { 0, 1, 2, 3 };

/// Two cells by invalid offsets, and the message about the first of them.
struct Lie
{
  std::vector<vtkIdType> Offsets;
  std::string Said;
};

const std::vector<Lie> kLies = { { { 0, 2, 200000000 }, "number 1 among them are 2 and 200000000" },
  { { 0, 2, 5 }, "number 1 among them are 2 and 5" },
  { { 0, 3, 1 }, "number 1 among them are 3 and 1" },
  { { 0, -5, 4 }, "number 0 among them are 0 and -5" },
  { { -1, 2, 4 }, "number 0 among them are -1 and 2" },
  { { 7, 7, 4 }, "number 0 among them are 7 and 7" } };

template <typename Array>
vtkSmartPointer<Array> arrayOf(const std::vector<vtkIdType>& numbers)
{
  auto array = vtkSmartPointer<Array>::New();
  for (const vtkIdType number : numbers)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(number));
  }
  return array;
}

vtkSmartPointer<vtkCellArray> cellsOf(
  const std::vector<vtkIdType>& offsets, const std::vector<vtkIdType>& ids, bool isWide)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (isWide)
  {
    cells->SetData(arrayOf<vtkTypeInt64Array>(offsets), arrayOf<vtkTypeInt64Array>(ids));
  }
  else
  {
    cells->SetData(arrayOf<vtkTypeInt32Array>(offsets), arrayOf<vtkTypeInt32Array>(ids));
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> sourceOf(vtkCellArray* cells, bool areLines)
{
  auto source = makeCloud(kSquare);
  areLines ? source->SetLines(cells) : source->SetPolys(cells);
  return source;
}

/// The source alone, or as one of two blocks.
vtkSmartPointer<vtkDataObject> given(vtkPolyData* source, bool isBlock)
{
  if (!isBlock)
  {
    return source;
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, makeSource({ { 0, 1 } }, {}, kSquare));
  blocks->SetBlock(1, source);
  return blocks;
}

void expectOneError(const std::vector<std::string>& errors, const std::vector<std::string>& parts)
{
  ASSERT_EQ(errors.size(), 1u);
  for (const std::string& part : parts)
  {
    EXPECT_NE(errors[0].find(part), std::string::npos) << "no \"" << part << "\" in: " << errors[0];
  }
}
}

/// Of lines and polygons, of 32 and of 64 bits, in blocks too.
TEST(BadCells, OffsetsThatLieAreAnError)
{
  for (const Lie& lie : kLies)
  {
    for (unsigned kind = 0; kind < 16; ++kind)
    {
      const bool isWide = kind & 1, areLines = kind & 2, isBlock = kind & 4, byIds = kind & 8;
      SCOPED_TRACE(lie.Said + ", kind " + std::to_string(kind));
      WatchedFilter filter;
      filter->SetInputData(makeCloud(kSquare));
      filter->SetSourceMode(byIds ? 0 : 1);
      filter->SetInputDataObject(
        1, given(sourceOf(cellsOf(lie.Offsets, kIds, isWide), areLines), isBlock));
      filter->Update();
      expectOneError(filter.Said->Errors,
        { lie.Said, std::string(areLines ? "lines" : "polygons") + (isBlock ? " of a block" : ""),
          "point ids, 4." });
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
      EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
      filter->SetSourceData(makeSource({ { 0, 2 } }, {}, kSquare));
      filter->Update();
      EXPECT_EQ(filter->GetNumberOfTriangles(), 2);
      EXPECT_TRUE(hasEdge(filter->GetOutput(), 0, 2));
    }
  }
}

TEST(BadCells, InterpolationSaysTheSame)
{
  for (const Lie& lie : kLies)
  {
    WatchedInterpolation filter;
    filter->SetInputData(makeCloud(kSquare));
    filter->SetInputDataObject(2, sourceOf(cellsOf(lie.Offsets, kIds, true), true));
    filter->SetDimensions(3, 3);
    filter->Update();
    expectOneError(filter.Said->Errors, { lie.Said, "lines of the source" });
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

/// Of a surface that looks as if all its cells were triangles.
TEST(BadCells, SurfaceToInterpolateIn)
{
  std::vector<Xyz> points = kSquare;
  points.push_back({ 1, 2, 0 });
  WatchedFilter triangulating;
  triangulating->SetInputData(makeCloud(points));
  triangulating->Update();
  ASSERT_EQ(triangulating->GetNumberOfTriangles(), 4);
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(triangulating->GetOutput());
  std::vector<vtkIdType> ids;
  for (const Triangle& t : trianglesOf(surface))
  {
    ids.insert(ids.end(), t.begin(), t.end());
  }
  surface->SetPolys(cellsOf({ 0, 3, -6, -3, 0 }, ids, true));
  WatchedInterpolation filter;
  filter->SetInputData(surface);
  filter->SetDimensions(3, 3);
  filter->Update();
  expectOneError(filter.Said->Errors, { "triangles of the surface", "are 3 and -6" });
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

/// VTK's own filters take these too: ids that no cell has, and arrays without an offset.
TEST(BadCells, IdsOfNoCellAreNoFault)
{
  for (const bool isWide : { false, true })
  {
    const auto surplus = cellsOf({ 1, 3 }, { 77, 0, 2, 1, 3 }, isWide);
    for (const bool isBlock : { false, true })
    {
      WatchedFilter filter;
      filter->SetInputData(makeCloud(kSquare));
      auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      blocks->SetBlock(0, sourceOf(surplus, true));
      blocks->SetBlock(1, sourceOf(surplus, true));
      filter->SetInputDataObject(
        1, isBlock ? vtkDataObject::SafeDownCast(blocks) : sourceOf(surplus, true).Get());
      filter->Update();
      expectWarnings(filter, 0);
      EXPECT_TRUE(hasEdge(filter->GetOutput(), 0, 2));
      EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);
    }
    WatchedFilter filter;
    filter->SetInputData(makeCloud(kSquare));
    filter->SetSourceData(sourceOf(cellsOf({}, kIds, isWide), false));
    filter->Update();
    EXPECT_TRUE(filter.Said->Errors.empty());
    EXPECT_EQ(filter->GetNumberOfTriangles(), 2);
  }
}
