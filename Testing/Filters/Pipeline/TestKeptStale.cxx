// SPDX-License-Identifier: BSD-3-Clause
//
// Data that must not be passed on from one execution to another, or be held longer than needed.
#include "ContextSupport.h"
#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDOutputCache.h"
#include "KeptTestSupport.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkWeakPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace ahdtest;

namespace
{
void setTime(vtkDataObject* data, double time)
{
  vtkNew<vtkDoubleArray> value;
  value->SetName("TimeValue");
  value->InsertNextValue(time);
  data->GetFieldData()->AddArray(value);
}

/// A filter whose source has two lines that cross, and the points for it.
struct CrossedLine : Line
{
  CrossedLine()
  {
    vtkNew<vtkPolyData> crossing;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ vtkIdType(0), vtkIdType(1) });
    lines->InsertNextCell({ vtkIdType(2), vtkIdType(3) });
    crossing->SetLines(lines);
    this->Source->Send(crossing);
    this->Filter->SetSourceConnection(this->Source->GetOutputPort());
  }

  static vtkSmartPointer<vtkPolyData> makePoints()
  {
    return makeCloud({ { 0, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 2, 0, 0 }, { 3, 1, 0 } });
  }

  vtkNew<Relay> Source;
};

/// The names of the surface's field data in their order, for an input with field data of these
/// names.
std::vector<std::string> fieldsFor(Line& line, const std::vector<std::string>& names)
{
  auto cloud = CrossedLine::makePoints();
  for (const std::string& name : names)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    cloud->GetFieldData()->AddArray(array);
  }
  line.Points->Send(cloud);
  line.Filter->Update();
  std::vector<std::string> found;
  vtkFieldData* data = line.Surface()->GetFieldData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    found.push_back(data->GetArrayName(i));
  }
  return found;
}

double timeOf(vtkDataObject* data)
{
  vtkDataArray* value = data->GetFieldData()->GetArray("TimeValue");
  return value ? value->GetComponent(0, 0) : -1;
}

/// Acts at the first progress from a given one on.
class AtProgress : public vtkCommand
{
public:
  static AtProgress* New() { return new AtProgress; }

  void Execute(vtkObject*, unsigned long, void* amount) override
  {
    if (this->Do && *static_cast<double*>(amount) >= this->From)
    {
      this->Do();
      this->Do = nullptr;
    }
  }

  std::function<void()> Do;
  double From = 0.0;
};
}

TEST(KeptStale, FieldDataAreThoseOfNow)
{
  CrossedLine line;
  for (int step = 0; step < 4; ++step)
  {
    auto cloud = CrossedLine::makePoints();
    setTime(cloud, step);
    EXPECT_EQ(line.Runs(cloud), step < 2);
    for (int port = 0; port < 3; ++port)
    {
      EXPECT_EQ(timeOf(line.Filter->GetOutput(port)), step) << "port " << port;
    }
    vtkFieldData* data = line.Surface()->GetFieldData();
    EXPECT_EQ(idsOf(data, "Crossings"), (std::vector<vtkIdType>{ 1, 0 }));
    EXPECT_EQ(idsOf(data, "NumberOfCrossings"), std::vector<vtkIdType>{ 1 });
    EXPECT_EQ(line.Filter->GetOutput(2)->GetFieldData()->GetNumberOfArrays(), 1);
  }
  auto without = CrossedLine::makePoints();
  EXPECT_FALSE(line.Runs(without));
  EXPECT_EQ(timeOf(line.Surface()), -1);
}

TEST(KeptStale, FieldDataHaveTheOrderOfAFreshRun)
{
  const std::vector<std::vector<std::string>> inputs = { { "mine" }, { "Crossings", "mine" },
    { "mine", "Crossings" }, { "NumberOfTriangles", "mine", "Crossings" } };
  for (const auto& first : inputs) // for which it is kept
  {
    CrossedLine line;
    fieldsFor(line, first);
    fieldsFor(line, first);
    for (const auto& then : inputs)
    {
      CrossedLine fresh;
      EXPECT_EQ(fieldsFor(line, then), fieldsFor(fresh, then)) << first[0] << ", " << then[0];
    }
    EXPECT_EQ(line.Filter->GetNumberOfTriangulations(), 2);
  }
}

TEST(KeptStale, BlocksWithTheSamePointsHaveTheirOwnFieldData)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned b = 0; b < 4; ++b)
  {
    auto cloud = makeCloud(scatteredPoints(50));
    setTime(cloud, b);
    blocks->SetBlock(b, cloud);
  }
  filter->SetInputDataObject(blocks);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (unsigned b = 0; b < 4; ++b)
  {
    EXPECT_EQ(timeOf(made->GetBlock(b)), b);
  }
}

TEST(KeptStale, ASettingChangedWhileItRunsCounts)
{
  auto cloud = makeCloud(scatteredPoints(2000));
  Line line;
  vtkNew<AtProgress> watch;
  line.Filter->AddObserver(vtkCommand::ProgressEvent, watch);
  EXPECT_TRUE(line.Runs(cloud));
  watch->From = 0.5; // points have been merged before
  watch->Do = [&line] { line.Filter->SetTolerance(0.1); };
  EXPECT_TRUE(line.Runs(cloud));
  ASSERT_EQ(line.Filter->GetTolerance(), 0.1);
  ASSERT_EQ(line.Filter->GetNumberOfMergedPoints(), 0);
  EXPECT_TRUE(line.Runs(cloud)) << "the result of other settings was passed on";
  EXPECT_GT(line.Filter->GetNumberOfMergedPoints(), 0);
}

TEST(KeptStale, WhatDoesNotFitIsLetGoBeforeTheNextIsMade)
{
  Line line;
  EXPECT_TRUE(line.RunsTwice(makeCloud(scatteredPoints(1000))));
  vtkWeakPointer<vtkDataArray> old = line.Surface()->GetPolys()->GetConnectivityArray();
  vtkNew<AtProgress> watch;
  bool isThere = true;
  watch->From = 0.1; // before that, messages are the pipeline's
  watch->Do = [&] { isThere = old != nullptr; };
  line.Filter->AddObserver(vtkCommand::ProgressEvent, watch);
  EXPECT_TRUE(line.Runs(makeCloud(scatteredPoints(1000, 2))));
  EXPECT_FALSE(isThere);
  ASSERT_FALSE(watch->Do) << "there was no progress";
  EXPECT_FALSE(line.Runs(makeCloud(scatteredPoints(1000, 2)))) << "that one is kept again";
}

TEST(KeptStale, AnEmptyVoronoiDiagramHasTheArraysOfNow)
{
  Line line;
  vtkNew<Messages> said; // "all distinct points are collinear"
  said->Watch(line.Filter);
  line.Filter->GenerateVoronoiOn();
  for (int step = 0; step < 3; ++step)
  {
    auto cloud = makeCloud({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } });
    vtkNew<vtkIntArray> array;
    const std::string name = "step" + std::to_string(step);
    array->SetName(name.c_str());
    array->SetNumberOfValues(3);
    array->FillValue(step);
    cloud->GetPointData()->AddArray(array);
    EXPECT_EQ(line.Runs(cloud), step < 2);
    vtkCellData* data = line.Filter->GetOutput(2)->GetCellData();
    EXPECT_EQ(line.Filter->GetOutput(2)->GetNumberOfCells(), 0);
    EXPECT_EQ(data->GetNumberOfArrays(), 2);
    EXPECT_TRUE(data->HasArray("OriginalPointIds"));
    EXPECT_TRUE(data->HasArray(name.c_str())) << name;
  }
}

/// Outputs belong to their holder. Changes of their arrays are not passed on, with or without
/// Modified().
TEST(KeptStale, AnEditedOutputIsNotPassedOn)
{
  using Edit = std::function<void(vtkPolyData*, vtkPolyData*)>; // surface, diagram
  const auto numbersOf = [](vtkDataArray* array)
  { return static_cast<vtkTypeInt32*>(array->GetVoidPointer(0)); };
  const std::vector<std::pair<const char*, Edit>> edits = {
    { "corners",
      [&](vtkPolyData* s, vtkPolyData*)
      {
        vtkTypeInt32* const ids = numbersOf(s->GetPolys()->GetConnectivityArray());
        ids[0] = ids[1];
      } },
    { "offsets",
      [&](vtkPolyData* s, vtkPolyData*) { numbersOf(s->GetPolys()->GetOffsetsArray())[1] = 2; } },
    { "cells", [](vtkPolyData* s, vtkPolyData*) { s->GetPolys()->Reset(); } },
    { "points", [](vtkPolyData* s, vtkPolyData*) { s->GetPoints()->SetPoint(3, 9, 9, 9); } },
    { "regions",
      [](vtkPolyData* s, vtkPolyData*)
      { s->GetCellData()->GetArray("RegionId")->SetComponent(0, 0, 77); } },
    { "a name",
      [](vtkPolyData* s, vtkPolyData*)
      { s->GetCellData()->GetArray("RegionId")->SetName("mine"); } },
    { "a component's name",
      [](vtkPolyData* s, vtkPolyData*)
      { s->GetCellData()->GetArray("RegionId")->SetComponentName(0, "mine"); } },
    { "a table of colours",
      [](vtkPolyData* s, vtkPolyData*)
      { s->GetCellData()->GetArray("RegionId")->CreateDefaultLookupTable(); } },
    { "status",
      [](vtkPolyData* s, vtkPolyData*)
      { s->GetPointData()->GetArray("Fate")->SetComponent(9, 0, 77); } },
    { "counts",
      [](vtkPolyData* s, vtkPolyData*)
      { s->GetFieldData()->GetArray("NumberOfTriangles")->SetComponent(0, 0, 1); } },
    { "diagram's corners",
      [](vtkPolyData*, vtkPolyData* d) { d->GetPoints()->SetPoint(0, 5, 5, 5); } },
    { "diagram's ids",
      [](vtkPolyData*, vtkPolyData* d)
      { d->GetCellData()->GetArray("OriginalPointIds")->SetComponent(0, 0, 1e6); } },
  };
  for (const auto& edit : edits)
  {
    SCOPED_TRACE(edit.first);
    std::vector<Xyz> xyz = scatteredPoints(200);
    xyz.push_back(xyz[11]);
    xyz.back()[2] = 3.0;
    Line line;
    line.Filter->SetDuplicatePolicyToMeanZ(); // the surface has points of its own
    line.Filter->GenerateRegionIdsOn();
    line.Filter->GenerateFateOn();
    line.Filter->GenerateVoronoiOn();
    EXPECT_TRUE(line.RunsTwice(makeCloud(xyz)));
    EXPECT_FALSE(line.Runs(makeCloud(xyz)));
    vtkNew<vtkPolyData> surface, diagram;
    surface->DeepCopy(line.Surface());
    diagram->DeepCopy(line.Filter->GetOutput(2));
    edit.second(line.Surface(), line.Filter->GetOutput(2));
    EXPECT_TRUE(line.Runs(makeCloud(xyz)));
    EXPECT_EQ(trianglesOf(line.Surface()), trianglesOf(surface));
    EXPECT_EQ(
      idsOf(line.Surface()->GetCellData(), "RegionId"), idsOf(surface->GetCellData(), "RegionId"));
    EXPECT_EQ(
      idsOf(line.Surface()->GetPointData(), "Fate"), idsOf(surface->GetPointData(), "Fate"));
    EXPECT_EQ(idsOf(line.Filter->GetOutput(2)->GetCellData(), "OriginalPointIds"),
      idsOf(diagram->GetCellData(), "OriginalPointIds"));
    EXPECT_FALSE(line.Runs(makeCloud(xyz))) << "that one is kept again";
  }
}

TEST(KeptStale, ASingleExecutionKeepsNothing)
{
  vtkWeakPointer<vtkDataArray> corners;
  Line line;
  EXPECT_TRUE(line.Runs(makeCloud(scatteredPoints(100))));
  corners = line.Surface()->GetPolys()->GetConnectivityArray();
  line.Surface()->Initialize();
  EXPECT_EQ(corners, nullptr);
}

/// A source that cannot be known again: what was made with it is of no use later.
TEST(KeptStale, WhatCannotBeKnownAgainIsNotHeld)
{
  vtkNew<vtkSOADataArrayTemplate<double>> apart;
  apart->SetNumberOfComponents(3);
  apart->InsertNextTuple3(0.2, 0.2, 0.0);
  apart->InsertNextTuple3(0.8, 0.7, 0.0);
  vtkNew<vtkPoints> ends;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ vtkIdType(0), vtkIdType(1) });
  vtkNew<vtkPolyData> source;
  source->SetPoints(ends);
  source->SetLines(lines);
  const auto cloud = makeCloud(scatteredPoints(100));
  for (const bool isKnown : { true, false })
  {
    isKnown ? ends->SetNumberOfPoints(2) : ends->SetData(apart);
    Line line;
    line.Filter->SetSourceData(source); // ids of the input's points: none are added
    line.Filter->SetReuseLimit(0);
    EXPECT_TRUE(line.RunsTwice(cloud));
    EXPECT_EQ(line.Runs(cloud), !isKnown);
    const vtkWeakPointer<vtkDataArray> corners = line.Surface()->GetPolys()->GetConnectivityArray();
    line.Surface()->Initialize();
    EXPECT_EQ(corners != nullptr, isKnown);
  }
}

/// Nor is what an aborted execution has made.
TEST(KeptStale, NothingIsKeptOnAnAbort)
{
  const Work work(1);
  const auto cloud = makeCloud(scatteredPoints(100));
  std::array<vtkNew<vtkPolyData>, 3> outputs;
  vtkAHDDataSets data;
  data.Input = cloud;
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    data.Outputs[k] = outputs[k];
  }
  vtkAHDOutputCache cache;
  for (const bool isAborted : { true, false })
  {
    EXPECT_FALSE(cache.Fits(data, 1, work.Context));
    EXPECT_FALSE(cache.Fits(data, 1, work.Context)) << "the second takes fingerprints";
    outputs[0]->DeepCopy(makeCloud(scatteredPoints(100)));
    const vtkWeakPointer<vtkDataArray> points = outputs[0]->GetPoints()->GetData();
    const Work keeping(1);
    keeping.Filter->SetAbortExecute(isAborted);
    cache.Keep(data, keeping.Context);
    outputs[0]->Initialize();
    EXPECT_EQ(points == nullptr, isAborted);
    EXPECT_EQ(cache.Fits(data, 1, work.Context), !isAborted);
  }
}
