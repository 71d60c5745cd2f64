// SPDX-License-Identifier: BSD-3-Clause
//
// Executions with the points of the one before: the triangles are kept, everything else is new.
#include "KeptTestSupport.h"
#include "ProgressWatch.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace ahdtest;

TEST(Kept, OtherDataOfTheSamePointsAreNotTriangulatedAgain)
{
  const std::vector<Xyz> points = scatteredPoints(500);
  const std::vector<Triangle> expected = triangulate(points);
  Line line;
  for (int step = 0; step < 5; ++step)
  {
    auto cloud = makeCloud(points); // all objects are new
    addData(cloud, step);
    EXPECT_EQ(line.Runs(cloud), step < 2) << "step " << step;
    EXPECT_EQ(trianglesOf(line.Surface()), expected);
    EXPECT_EQ(line.Surface()->GetPoints(), cloud->GetPoints()) << "step " << step;
    EXPECT_EQ(dataOf(line.Surface()), step);
    EXPECT_EQ(line.Surface()->GetPointData()->GetNumberOfArrays(), 1);
    EXPECT_EQ(line.Filter->GetNumberOfTriangles(), vtkIdType(expected.size()));
    EXPECT_EQ(idsOf(line.Surface()->GetFieldData(), "NumberOfTriangles"),
      std::vector<vtkIdType>{ vtkIdType(expected.size()) });
  }
  EXPECT_EQ(line.Filter->GetSortSeconds(), 0.0);
  EXPECT_EQ(line.Filter->GetInsertSeconds(), 0.0);
  EXPECT_EQ(line.Filter->GetOutputSeconds(), 0.0);
}

TEST(Kept, WhatIsChangedWhereItLiesIsSeen)
{
  std::vector<Xyz> points = scatteredPoints(100);
  auto cloud = makeCloud(points);
  Line line;
  EXPECT_TRUE(line.RunsTwice(cloud));
  EXPECT_FALSE(line.Runs(cloud));
  // not even Modified() of the array is called
  double* numbers = vtkDoubleArray::SafeDownCast(cloud->GetPoints()->GetData())->GetPointer(0);
  for (std::size_t i : { std::size_t(0), std::size_t(3 * 57 + 1), std::size_t(3 * 99 + 1) })
  {
    numbers[i] += 0.25;
    points[i / 3][i % 3] += 0.25;
    EXPECT_TRUE(line.Runs(cloud)) << "number " << i;
    EXPECT_EQ(trianglesOf(line.Surface()), triangulate(points));
    EXPECT_FALSE(line.Runs(cloud)) << "number " << i;
  }
}

TEST(Kept, OtherPointsAreTriangulated)
{
  Line line;
  const std::vector<Xyz> points = scatteredPoints(100);
  EXPECT_TRUE(line.RunsTwice(makeCloud(points)));
  EXPECT_TRUE(line.Runs(makeCloud(scatteredPoints(99))));
  EXPECT_TRUE(line.RunsTwice(makeCloud(points)));
  EXPECT_TRUE(line.Runs(makeCloud(points, VTK_FLOAT)));
  EXPECT_TRUE(line.Runs(makeCloud(scatteredPoints(100, 2), VTK_FLOAT)));
  EXPECT_FALSE(line.Runs(makeCloud(scatteredPoints(100, 2), VTK_FLOAT)));
  EXPECT_TRUE(line.Runs(vtkNew<vtkPolyData>()));
  EXPECT_TRUE(line.Runs(makeCloud(points)));
  EXPECT_EQ(trianglesOf(line.Surface()), triangulate(points));
}

TEST(Kept, EverySettingCounts)
{
  auto cloud = makeCloud(scatteredPoints(100));
  Line line;
  EXPECT_TRUE(line.RunsTwice(cloud));
  line.Filter->SetNmax(20);
  EXPECT_TRUE(line.RunsTwice(cloud));
  line.Filter->SetNmax(20);
  EXPECT_FALSE(line.Runs(cloud));
  line.Filter->GenerateFateOn();
  EXPECT_TRUE(line.RunsTwice(cloud));
  line.Filter->SetInsertionLimit(50);
  EXPECT_TRUE(line.RunsTwice(cloud));
  vtkNew<vtkTransform> transform;
  line.Filter->SetTransform(transform);
  EXPECT_TRUE(line.RunsTwice(cloud));
  EXPECT_FALSE(line.Runs(cloud));
  transform->RotateX(10);
  EXPECT_TRUE(line.RunsTwice(cloud));
  EXPECT_FALSE(line.Runs(cloud));
  line.Filter->Modified();
  EXPECT_TRUE(line.Runs(cloud));
}

TEST(Kept, GhostMarksCount)
{
  Line line;
  const std::vector<Xyz> points = scatteredPoints(100);
  const auto marked = [&points](unsigned char mark)
  {
    auto cloud = makeCloud(points);
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfValues(cloud->GetNumberOfPoints());
    marks->FillValue(0);
    marks->SetValue(42, mark);
    cloud->GetPointData()->AddArray(marks);
    return cloud;
  };
  EXPECT_TRUE(line.RunsTwice(marked(0)));
  EXPECT_FALSE(line.Runs(marked(0)));
  EXPECT_TRUE(line.Runs(marked(vtkDataSetAttributes::HIDDENPOINT)));
  EXPECT_EQ(line.Filter->GetNumberOfSkippedPoints(), 1);
  EXPECT_FALSE(line.Runs(marked(vtkDataSetAttributes::HIDDENPOINT)));
  EXPECT_EQ(line.Filter->GetNumberOfSkippedPoints(), 1);
  EXPECT_TRUE(line.Runs(makeCloud(points)));
}

TEST(Kept, TheSourceCounts)
{
  Line line;
  auto cloud = makeCloud(scatteredPoints(100));
  vtkNew<Relay> source;
  const auto makeSource = [](std::initializer_list<vtkIdType> ids, bool isLoop)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(ids);
    isLoop ? data->SetPolys(cells) : data->SetLines(cells);
    return data;
  };
  EXPECT_TRUE(line.Runs(cloud));
  line.Filter->SetSourceConnection(source->GetOutputPort());
  const auto runs = [&](vtkPolyData* data)
  {
    source->Send(data);
    return line.Runs();
  };
  EXPECT_TRUE(runs(makeSource({ 1, 2, 3 }, false)));
  EXPECT_TRUE(runs(makeSource({ 1, 2, 3 }, false)));
  EXPECT_FALSE(runs(makeSource({ 1, 2, 3 }, false)));
  EXPECT_TRUE(runs(makeSource({ 1, 2, 4 }, false)));
  EXPECT_TRUE(runs(makeSource({ 1, 2, 4 }, true)));
  EXPECT_FALSE(runs(makeSource({ 1, 2, 4 }, true)));
  EXPECT_TRUE(runs(makeSource({ 1, 2, 5 }, true)));
  auto withVertex = makeSource({ 1, 2, 4 }, true);
  vtkNew<vtkCellArray> vertex; // the cells behind it have other ids
  vertex->InsertNextCell({ vtkIdType(1) });
  withVertex->SetVerts(vertex);
  EXPECT_TRUE(runs(withVertex));
  EXPECT_FALSE(runs(withVertex));
}

/// The same ids are other cells where these begin elsewhere.
TEST(Kept, WhereCellsOfTheSourceBeginCounts)
{
  const auto cells = [](const std::vector<std::vector<vtkIdType>>& all, bool areLoops)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkCellArray> made;
    for (const std::vector<vtkIdType>& ids : all)
    {
      made->InsertNextCell(vtkIdType(ids.size()), ids.data());
    }
    areLoops ? data->SetPolys(made) : data->SetLines(made);
    return data;
  };
  for (const bool areLoops : { false, true })
  {
    SCOPED_TRACE(areLoops);
    Line line;
    auto cloud = makeCloud({ { 0, 0, 0 }, { 9, 0, 0 }, { 9, 8, 0 }, { 0, 9, 0 }, { 4, 1, 0 },
      { 5, 7, 0 }, { 2, 3, 0 } });
    vtkNew<Relay> source;
    line.Filter->SetSourceConnection(source->GetOutputPort());
    const auto runs = [&](const std::vector<std::vector<vtkIdType>>& all)
    {
      source->Send(cells(all, areLoops));
      return line.Runs();
    };
    source->Send(cells({ { 0, 1, 2, 3, 4, 5 } }, areLoops));
    line.Runs(cloud);
    EXPECT_TRUE(runs({ { 0, 1, 2, 3, 4, 5 } }));
    EXPECT_FALSE(runs({ { 0, 1, 2, 3, 4, 5 } }));
    EXPECT_TRUE(runs({ { 0, 1, 2 }, { 3, 4, 5 } }));
    EXPECT_FALSE(runs({ { 0, 1, 2 }, { 3, 4, 5 } }));
    EXPECT_TRUE(runs({ { 0, 1, 2, 3 }, { 4, 5 } }));
  }
}

TEST(Kept, ArraysThatTheFilterMakesAreKeptWithTheTriangles)
{
  const std::vector<Xyz> points = latticePoints(300, 15); // with duplicates
  Line line;
  line.Filter->GenerateFateOn();
  line.Filter->GenerateInsertionRankOn();
  line.Filter->GenerateInsertionCurveOn();
  line.Filter->GenerateBoxesOn();
  auto first = makeCloud(points);
  addData(first, 1);
  EXPECT_TRUE(line.RunsTwice(first));
  const std::vector<vtkIdType> fates = idsOf(line.Surface()->GetPointData(), "Fate");
  const std::vector<vtkIdType> ranks = idsOf(line.Surface()->GetPointData(), "InsertionRank");
  vtkNew<vtkPolyData> order;
  order->DeepCopy(line.Filter->GetOutput(1));
  ASSERT_EQ(fates.size(), 300u);
  ASSERT_GT(order->GetNumberOfPolys(), 0);
  const vtkIdType duplicates = line.Filter->GetNumberOfDuplicates();
  ASSERT_GT(duplicates, 0);

  auto second = makeCloud(points);
  addData(second, 2);
  EXPECT_FALSE(line.Runs(second));
  EXPECT_EQ(idsOf(line.Surface()->GetPointData(), "Fate"), fates);
  EXPECT_EQ(idsOf(line.Surface()->GetPointData(), "InsertionRank"), ranks);
  EXPECT_EQ(dataOf(line.Surface()), 2);
  EXPECT_EQ(line.Surface()->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_EQ(line.Filter->GetNumberOfDuplicates(), duplicates);
  vtkPolyData* again = line.Filter->GetOutput(1);
  ASSERT_EQ(again->GetNumberOfPoints(), order->GetNumberOfPoints());
  for (vtkIdType i = 0; i < order->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(again->GetPoint(i)[1], order->GetPoint(i)[1]);
  }
  EXPECT_EQ(again->GetNumberOfLines(), 1);
  EXPECT_EQ(idsOf(again->GetCellData(), "Count"), idsOf(order->GetCellData(), "Count"));

  auto third = makeCloud(points); // an input that has such an array itself, then none
  addData(third, 3);
  EXPECT_FALSE(line.Runs(third));
  EXPECT_EQ(idsOf(line.Surface()->GetPointData(), "Fate"), fates);
}

TEST(Kept, TheVoronoiDiagramHasTheDataOfNow)
{
  const std::vector<Xyz> points = latticePoints(200, 12); // with duplicates
  Line line;
  line.Filter->GenerateVoronoiOn();
  line.Filter->GenerateFateOn();
  for (int step = 0; step < 4; ++step)
  {
    auto cloud = makeCloud(points);
    addData(cloud, step);
    EXPECT_EQ(line.Runs(cloud), step < 2);
    vtkNew<vtkAdaptiveHilbertDelaunay2D> other;
    other->GenerateVoronoiOn();
    other->GenerateFateOn();
    other->SetInputData(cloud);
    other->Update();
    vtkPolyData* expected = other->GetOutput(2);
    vtkPolyData* diagram = line.Filter->GetOutput(2);
    ASSERT_EQ(diagram->GetNumberOfCells(), line.Filter->GetNumberOfPointsInserted());
    ASSERT_EQ(diagram->GetNumberOfCells(), expected->GetNumberOfCells());
    ASSERT_EQ(diagram->GetNumberOfPoints(), expected->GetNumberOfPoints());
    vtkCellData* data = diagram->GetCellData();
    EXPECT_EQ(data->GetNumberOfArrays(), expected->GetCellData()->GetNumberOfArrays());
    for (const char* name : { "OriginalPointIds", "Fate" })
    {
      EXPECT_EQ(idsOf(data, name), idsOf(expected->GetCellData(), name)) << name;
    }
    ASSERT_NE(data->GetArray("data"), nullptr);
    EXPECT_EQ(data->GetArray("data")->GetNumberOfTuples(), diagram->GetNumberOfCells());
    EXPECT_EQ(data->GetArray("data")->GetComponent(3, 0), step);
  }
}

TEST(Kept, AddedPointsHaveTheDataOfNow)
{
  Line line;
  line.Filter->BoundingTriangulationOn();
  for (int step = 0; step < 3; ++step)
  {
    auto cloud = makeCloud(scatteredPoints(50));
    addData(cloud, step);
    line.Runs(cloud);
    ASSERT_EQ(line.Surface()->GetNumberOfPoints(), 58);
    vtkDataArray* data = line.Surface()->GetPointData()->GetArray("data");
    ASSERT_NE(data, nullptr);
    EXPECT_EQ(data->GetComponent(49, 0), step);
  }
}

TEST(Kept, NothingIsKeptOfAnExecutionThatFailed)
{
  auto cloud = makeCloud(scatteredPoints(1000));
  vtkNew<Messages> said;
  Line line;
  said->Watch(line.Filter);
  EXPECT_TRUE(line.RunsTwice(cloud));
  line.Filter->SetMemoryLimit(1);
  for (unsigned times = 1; times < 4; ++times)
  {
    EXPECT_TRUE(line.Runs(cloud)) << "a failure was passed on";
    EXPECT_EQ(line.Surface()->GetNumberOfCells(), 0);
    EXPECT_EQ(said->Errors.size(), times);
  }
  line.Filter->SetMemoryLimit(0);
  EXPECT_TRUE(line.Runs(cloud));
  EXPECT_GT(line.Surface()->GetNumberOfCells(), 0);
}

TEST(Kept, NothingIsKeptOfAnExecutionThatWasAborted)
{
  auto cloud = makeCloud(scatteredPoints(1000));
  Line line;
  EXPECT_TRUE(line.RunsTwice(cloud));
  // by an observer: VTK 9.1 drops an abort requested before the execution begins
  vtkNew<ProgressWatch> watch;
  watch->AbortAt = 0.0;
  const unsigned long observed = line.Filter->AddObserver(vtkCommand::ProgressEvent, watch);
  cloud = makeCloud(scatteredPoints(1001));
  EXPECT_TRUE(line.Runs(cloud));
  EXPECT_TRUE(watch->Aborted);
  EXPECT_EQ(line.Surface()->GetNumberOfCells(), 0);
  line.Filter->RemoveObserver(observed);
  line.Filter->SetAbortExecute(0);
  EXPECT_TRUE(line.RunsTwice(cloud));
  EXPECT_GT(line.Surface()->GetNumberOfCells(), 0);
  EXPECT_FALSE(line.Runs(cloud));
}

TEST(Kept, SwitchedOffItAlwaysTriangulates)
{
  auto cloud = makeCloud(scatteredPoints(100));
  Line line;
  line.Filter->KeepTriangulationOff();
  EXPECT_TRUE(line.RunsTwice(cloud));
  EXPECT_TRUE(line.RunsTwice(cloud));
  line.Filter->KeepTriangulationOn();
  EXPECT_TRUE(line.RunsTwice(cloud));
  EXPECT_FALSE(line.Runs(cloud));
}

TEST(Kept, TheInputIsNotHeld)
{
  const std::vector<Xyz> points = scatteredPoints(100);
  Line line;
  auto cloud = makeCloud(points);
  vtkSmartPointer<vtkPoints> old = cloud->GetPoints();
  addData(cloud, 1);
  vtkSmartPointer<vtkDataArray> oldData = cloud->GetPointData()->GetArray("data");
  line.RunsTwice(cloud);
  cloud = nullptr;
  EXPECT_FALSE(line.Runs(makeCloud(points)));
  EXPECT_EQ(old->GetReferenceCount(), 1);
  EXPECT_EQ(oldData->GetReferenceCount(), 1);
}

TEST(Kept, PointsThatDoNotLieOneByOneAreTriangulated)
{
  vtkNew<vtkSOADataArrayTemplate<double>> array;
  array->SetNumberOfComponents(3);
  for (const Xyz& p : scatteredPoints(50))
  {
    array->InsertNextTuple(p.data());
  }
  vtkNew<vtkPoints> stored;
  stored->SetData(array);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(stored);
  Line line;
  EXPECT_TRUE(line.RunsTwice(cloud));
  EXPECT_TRUE(line.Runs(cloud));
  EXPECT_GT(line.Surface()->GetNumberOfCells(), 0);
}

TEST(Kept, WarningsAreNotSaidAgain)
{
  std::vector<Xyz> points = scatteredPoints(100);
  points[3][0] = std::numeric_limits<double>::quiet_NaN();
  vtkNew<Messages> said;
  Line line;
  said->Watch(line.Filter);
  EXPECT_TRUE(line.RunsTwice(makeCloud(points)));
  EXPECT_FALSE(line.Runs(makeCloud(points)));
  EXPECT_EQ(said->Warnings.size(), 2u) << "once for each triangulation";
  EXPECT_EQ(line.Filter->GetNumberOfRejectedPoints(), 1);
}

TEST(Kept, OutputsOfBeforeStayAsTheyWere)
{
  const std::vector<Xyz> points = scatteredPoints(100);
  Line line;
  auto cloud = makeCloud(points);
  addData(cloud, 1);
  line.RunsTwice(cloud);
  vtkNew<vtkPolyData> before;
  before->ShallowCopy(line.Surface());
  auto next = makeCloud(points);
  addData(next, 2);
  EXPECT_FALSE(line.Runs(next));
  EXPECT_EQ(dataOf(before), 1);
  EXPECT_EQ(before->GetPoints(), cloud->GetPoints());
  // callers may modify an output
  line.Surface()->GetPointData()->Initialize();
  line.Surface()->SetPolys(nullptr);
  EXPECT_FALSE(line.Runs(cloud));
  EXPECT_EQ(trianglesOf(line.Surface()), triangulate(points));
}

TEST(Kept, BlocksHaveTheirOwn)
{
  // each block is an execution of its own, in turn; blocks must not be mixed up
  const std::vector<std::vector<Xyz>> points = { scatteredPoints(80, 1), scatteredPoints(80, 2) };
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  for (int step = 0; step < 3; ++step)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (unsigned b = 0; b < 2; ++b)
    {
      auto cloud = makeCloud(points[b]);
      addData(cloud, step + 10 * b);
      blocks->SetBlock(b, cloud);
    }
    filter->SetInputDataObject(blocks);
    filter->Update();
    auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    for (unsigned b = 0; b < 2; ++b)
    {
      auto* surface = vtkPolyData::SafeDownCast(made->GetBlock(b));
      ASSERT_NE(surface, nullptr);
      EXPECT_EQ(trianglesOf(surface), triangulate(points[b]));
      EXPECT_EQ(dataOf(surface), step + 10 * b);
    }
  }
}
