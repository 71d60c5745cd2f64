// SPDX-License-Identifier: BSD-3-Clause
//
// Points that are added: those of the source, and where constraints cross; their ids, their data,
// and messages about them.
#include "ConstraintTestSupport.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertDelaunay2D;

namespace
{
const double kNan = std::numeric_limits<double>::quiet_NaN();

/// An array of one component.
template <typename Array>
vtkSmartPointer<Array> makeArray(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (double value : values)
  {
    array->InsertNextTuple1(value);
  }
  return array;
}

double valueOf(vtkPolyData* data, const char* name, vtkIdType id)
{
  return data->GetPointData()->GetArray(name)->GetComponent(id, 0);
}

Xyz pointOf(vtkPolyData* data, vtkIdType id)
{
  Xyz p;
  data->GetPoint(id, p.data());
  return p;
}

const std::vector<Xyz> kSquare = { { 0, 0, 1 }, { 4, 0, 3 }, { 4, 4, 1 }, { 0, 4, 3 } };
}

TEST(SourceCoordinates, AreAddedBehindTheInputsPoints)
{
  // a square with a square hole in it that is given by its own points
  const std::vector<Xyz> hole = { { 1, 1, 7 }, { 1, 2.1, 7 }, { 2.1, 2.1, 7 }, { 2.1, 1, 7 },
    { 0, 4, 9 }, { 3, 3, 8 } };
  ConstrainedFilter filter(kSquare, makeSource({}, { { 0, 1, 2, 3 } }, hole));
  filter->SetSourceModeToCoordinates();
  filter->GenerateFateOn();
  vtkPolyData* surface = filter.Run();
  ASSERT_EQ(surface->GetNumberOfPoints(), 10);
  EXPECT_NEAR(areaOf(surface), 16.0 - 1.21, 1e-12);
  EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(pointOf(surface, vtkIdType(i)), kSquare[i]);
  }
  for (std::size_t i = 0; i < hole.size(); ++i)
  {
    EXPECT_EQ(pointOf(surface, vtkIdType(4 + i)), hole[i]);
  }
  EXPECT_EQ(idsOf(surface->GetPointData(), "Fate"), (Chain{ 0, 1, 2, 3, 4, 5, 6, 7, 3, 9 }));
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 6);
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 1);
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 9);
  EXPECT_EQ(idsOf(surface->GetFieldData(), "NumberOfAddedPoints"), Chain{ 6 });
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(SourceCoordinates, AnEndThatCoincidesWithAPointOfTheInputIsADuplicateOfIt)
{
  ConstrainedFilter filter(
    squareLattice(10), makeSource({ { 0, 1 } }, {}, { { 0, 0, 5 }, { 9, 7, 5 } }));
  filter->SetSourceModeToCoordinates();
  EXPECT_TRUE(hasEdge(filter.Run(), 0, 97));
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 2);
}

TEST(SourceCoordinates, FloatAndIntegerPointsBecomeDoubles)
{
  for (int type : { VTK_FLOAT, VTK_INT })
  {
    WatchedFilter filter;
    filter->SetInputData(makeCloud(kSquare, type));
    filter->SetSourceData(makeSource({ { 0, 1 } }, {}, { { 0.1, 0.1, 0 }, { 2, 2.2, 0 } }));
    filter->SetSourceModeToCoordinates();
    filter->Update();
    EXPECT_EQ(pointOf(filter->GetOutput(), 5), (Xyz{ 2, 2.2, 0 }));
    EXPECT_EQ(pointOf(filter->GetOutput(), 1), kSquare[1]);
    EXPECT_TRUE(hasEdge(filter->GetOutput(), 4, 5));
    EXPECT_NEAR(areaOf(filter->GetOutput()), 16.0, 1e-12);
  }
}

TEST(SourceCoordinates, TheirDataComeFromTheSourceWhereItHasThem)
{
  auto cloud = makeCloud(kSquare);
  auto marks = makeArray<vtkUnsignedCharArray>("vtkGhostType", { 0, 0, 0, 0 });
  auto text = vtkSmartPointer<vtkStringArray>::New();
  text->SetName("text");
  auto vectors = vtkSmartPointer<vtkFloatArray>::New();
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(2);
  for (int i = 0; i < 4; ++i)
  {
    text->InsertNextValue("t" + std::to_string(i));
    vectors->InsertNextTuple2(i, -i);
  }
  vtkPointData* data = cloud->GetPointData();
  data->SetScalars(makeArray<vtkDoubleArray>("depth", { 1, 2, 3, 4 }));
  for (vtkAbstractArray* array : { static_cast<vtkAbstractArray*>(marks),
         static_cast<vtkAbstractArray*>(text), static_cast<vtkAbstractArray*>(vectors) })
  {
    data->AddArray(array);
  }
  data->AddArray(makeArray<vtkIntArray>("class", { 5, 6, 7, 8 }));
  data->AddArray(makeArray<vtkFloatArray>("short", { 5, 6 }));
  auto source = makeSource({}, {}, { { 1, 1, 0 }, { 2, 1, 0 } });
  source->GetPointData()->AddArray(makeArray<vtkFloatArray>("depth", { 10, 20 }));
  source->GetPointData()->AddArray(makeArray<vtkDoubleArray>("vectors", { 1, 1 })); // too narrow
  source->GetPointData()->AddArray(makeArray<vtkDoubleArray>("other", { 1, 1 }));

  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->SetSourceData(source);
  filter->SetSourceModeToCoordinates();
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  vtkPointData* made = surface->GetPointData();
  EXPECT_EQ(made->GetNumberOfArrays(), 6);
  EXPECT_EQ(made->GetScalars(), made->GetArray("depth"));
  EXPECT_EQ(made->GetScalars()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(valueOf(surface, "depth", i), double(i + 1));
    EXPECT_EQ(valueOf(surface, "class", i), double(i + 5));
    EXPECT_EQ(valueOf(surface, "vectors", i), double(i));
  }
  EXPECT_EQ(valueOf(surface, "depth", 4), 10.0);
  EXPECT_EQ(valueOf(surface, "depth", 5), 20.0);
  EXPECT_TRUE(std::isnan(valueOf(surface, "vectors", 5)));
  EXPECT_EQ(valueOf(surface, "class", 4), 0.0);
  EXPECT_EQ(valueOf(surface, "vtkGhostType", 5), 0.0);
  EXPECT_EQ(valueOf(surface, "short", 1), 6.0);
  EXPECT_TRUE(std::isnan(valueOf(surface, "short", 2)));
  auto* texts = vtkStringArray::SafeDownCast(made->GetAbstractArray("text"));
  ASSERT_NE(texts, nullptr);
  EXPECT_EQ(texts->GetValue(3), "t3");
  EXPECT_EQ(texts->GetValue(5), "");
  EXPECT_EQ(cloud->GetPointData()->GetArray("depth")->GetNumberOfTuples(), 4);
}

TEST(SourceCoordinates, SkippedAndRejectedPointsStaySo)
{
  auto cloud = makeCloud(squareLattice(10));
  auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  marks->SetName("vtkGhostType");
  marks->SetNumberOfValues(100);
  marks->Fill(0);
  marks->SetValue(55, vtkDataSetAttributes::HIDDENPOINT);
  cloud->GetPointData()->AddArray(marks);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->SetSourceData(makeSource({ { 0, 1 } }, {}, { { 0.5, 0.25, 0 }, { kNan, 0, 0 } }));
  filter->SetSourceModeToCoordinates();
  filter->GenerateFateOn();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 1);
  EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 1);
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 100);
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 1);
  const auto fates = idsOf(filter->GetOutput()->GetPointData(), "Fate");
  EXPECT_EQ(fates[55], -2);
  EXPECT_EQ(fates[100], 100);
  EXPECT_EQ(fates[101], -1);
  ASSERT_EQ(filter.Said->Warnings.size(), 2u);
  EXPECT_NE(filter.Said->Warnings[0].find("1 of 102 points"), std::string::npos);
  EXPECT_NE(filter.Said->Warnings[0].find("first is point 101"), std::string::npos);
}

TEST(SourceCoordinates, NoPointsInTheInputAreNoReasonForNone)
{
  WatchedFilter filter;
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->SetSourceData(makeSource({}, { { 0, 1, 2, 3 } }, kSquare));
  filter->SetSourceModeToCoordinates();
  filter->Update();
  EXPECT_EQ(areaOf(filter->GetOutput()), 16.0);
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(SourceCoordinates, ASourceWithoutPointsHasNoIds)
{
  ConstrainedFilter filter(kSquare, makeSource({ { 0, 2 } }, {}));
  filter->SetSourceModeToCoordinates();
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 1);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("points of the source"), std::string::npos);
}

TEST(SourceCoordinates, AreTransformedLikeTheInputAndPutOutAsTheyWere)
{
  // the square stands upright: y and z change places
  std::vector<Xyz> upright;
  for (const Xyz& p : squareLattice(6))
  {
    upright.push_back({ p[0], 0.5 * p[1], p[1] });
  }
  vtkNew<vtkTransform> turn;
  turn->RotateX(-90);
  const vtkMTimeType before = turn->GetMTime();
  const std::vector<Xyz> own = { { 0.5, 0.1, 0.5 }, { 4.5, 0.2, 4.25 } };
  ConstrainedFilter filter(upright, makeSource({ { 0, 1 } }, {}, own));
  filter->SetTransform(turn);
  filter->SetProjectionPlaneMode(VTK_SET_TRANSFORM_PLANE);
  filter->SetSourceModeToCoordinates();
  for (int run = 0; run < 2; ++run)
  {
    filter->Modified();
    vtkPolyData* surface = filter.Run();
    EXPECT_TRUE(hasEdge(surface, 36, 37));
    EXPECT_EQ(pointOf(surface, 36), own[0]);
    EXPECT_EQ(pointOf(surface, 37), own[1]);
    EXPECT_EQ(pointOf(surface, 35), upright[35]);
    EXPECT_EQ(filter->GetTransform(), turn.Get());
    EXPECT_EQ(turn->GetMTime(), before);
  }
}

TEST(SourceCoordinates, TheInsertionIsShownAtTheirPlaces)
{
  ConstrainedFilter filter(kSquare, makeSource({}, {}, { { 1, 2, 3 } }));
  filter->SetSourceModeToCoordinates();
  filter->GenerateInsertionCurveOn();
  filter->GenerateInsertionRankOn();
  vtkPolyData* surface = filter.Run();
  vtkPolyData* order = filter->GetOutput(1);
  ASSERT_EQ(order->GetNumberOfPoints(), 5);
  const auto ids = idsOf(order->GetPointData(), "OriginalPointIds");
  const auto ranks = idsOf(surface->GetPointData(), "InsertionRank");
  ASSERT_EQ(ranks.size(), 5u);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    EXPECT_EQ(pointOf(order, i), pointOf(surface, ids[std::size_t(i)]));
    EXPECT_EQ(ranks[std::size_t(ids[std::size_t(i)])], i);
  }
}

TEST(SplitCrossings, APointIsAddedWithTheMeanOfBothInterpolations)
{
  auto cloud = makeCloud({ { 0, 0, 1 }, { 4, 0, 30 }, { 4, 4, 5 }, { 0, 4, 50 } });
  cloud->GetPointData()->AddArray(makeArray<vtkFloatArray>("depth", { 0, 10, 8, 30 }));
  cloud->GetPointData()->AddArray(makeArray<vtkIntArray>("class", { 1, 3, 2, 5 }));
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->SetSourceData(makeSource({ { 0, 2 }, { 1, 3 } }, {}));
  filter->SetCrossingModeToSplit();
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  ASSERT_EQ(surface->GetNumberOfPoints(), 5);
  EXPECT_EQ(pointOf(surface, 4), (Xyz{ 2, 2, 21.5 })); // of 3 and 40
  EXPECT_EQ(valueOf(surface, "depth", 4), 12.0);       // of 4 and 20
  EXPECT_EQ(valueOf(surface, "class", 4), 3.0);        // of 1.5 and 4, rounded
  EXPECT_EQ(filter->GetNumberOfTriangles(), 4);
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 4);
  EXPECT_EQ(filter->GetNumberOfCrossings(), 1);
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 1);
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 0);
  EXPECT_EQ(idsOf(surface->GetFieldData(), "Crossings"), (Chain{ 1, 0 }));
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(SplitCrossings, LoopsThatCrossAreFilled)
{
  // two squares that overlap in a square of side 1
  const std::vector<Xyz> corners = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 },
    { 2, 2, 0 }, { 5, 2, 0 }, { 5, 5, 0 }, { 2, 5, 0 } };
  ConstrainedFilter filter(corners, makeSource({}, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } }));
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfUnfilledLoops(), 1);
  filter->SetCrossingModeToSplit();
  filter->SetFillRuleToEvenOdd();
  EXPECT_EQ(areaOf(filter.Run()), 9.0 + 9.0 - 2.0);
  EXPECT_EQ(filter->GetNumberOfUnfilledLoops(), 0);
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 2);
  EXPECT_TRUE(filter.Said->Warnings.empty());
}

TEST(SplitCrossings, ReachTheLastSegmentOfALoopAndPointsOfTheSource)
{
  // the line crosses the loop's first and its closing segment
  const std::vector<Xyz> own = { { 1, 1, 0 }, { 3, 1, 0 }, { 2, 3, 6 }, { 1.25, 0, 8 },
    { 1.25, 4, 8 } };
  ConstrainedFilter filter(kSquare, makeSource({ { 3, 4 } }, { { 0, 1, 2 } }, own));
  filter->SetSourceModeToCoordinates();
  filter->SetCrossingModeToSplit();
  vtkPolyData* surface = filter.Run();
  ASSERT_EQ(surface->GetNumberOfPoints(), 4 + 5 + 2);
  EXPECT_EQ(pointOf(surface, 9), (Xyz{ 1.25, 1, 4 }));
  EXPECT_EQ(pointOf(surface, 10), (Xyz{ 1.25, 1.5, 4.75 })); // a quarter of the way from 0 to 6
  EXPECT_EQ(areaOf(surface), 2.0);
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 7);
  EXPECT_EQ(filter->GetNumberOfCrossings(), 2);
}

TEST(SplitCrossings, InAnotherPlaneTheyAreInterpolatedInSpace)
{
  const std::vector<Xyz> upright = { { 0, 7, 0 }, { 4, 7, 0 }, { 4, 7, 4 }, { 0, 7, 4 } };
  ConstrainedFilter filter(upright, makeSource({ { 0, 2 }, { 1, 3 } }, {}));
  filter->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->SetCrossingModeToSplit();
  vtkPolyData* surface = filter.Run();
  ASSERT_EQ(surface->GetNumberOfPoints(), 5);
  EXPECT_EQ(pointOf(surface, 4), (Xyz{ 2, 7, 2 }));
  EXPECT_EQ(filter->GetNumberOfTriangles(), 4);
}

TEST(SplitCrossings, AnEndThatLiesOnALineButForRoundingNeedsNoPoint)
{
  // the second line begins on the first, up to rounding, but on its other side
  const std::vector<Xyz> roads = { { 650918.04581886868, 5000487.6271896446, 0 },
    { 651544.78632731084, 5001249.2579914005, 0 }, { 650923.72225737572, 5000494.5253402395, 0 },
    { 650827.84740761865, 5000770.9921042062, 0 } };
  ConstrainedFilter filter(roads, makeSource({ { 0, 1 }, { 2, 3 } }, {}));
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 1);
  filter.Said->Warnings.clear();
  filter->SetCrossingModeToSplit();
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 0);
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 3);
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 0);
  EXPECT_EQ(filter->GetNumberOfBentConstraints(), 1);
  EXPECT_EQ(filter.Said->Warnings.size(), 1u);
}

TEST(SplitCrossings, WithoutAnyNothingIsAdded)
{
  ConstrainedFilter filter(kSquare, makeSource({ { 0, 2 } }, { { 0, 1, 2, 3 } }));
  filter->SetCrossingModeToSplit();
  vtkPolyData* surface = filter.Run();
  EXPECT_EQ(surface->GetPoints(), vtkPolyData::SafeDownCast(filter->GetInput())->GetPoints());
  EXPECT_EQ(filter->GetNumberOfTriangles(), 2);
}

TEST(SplitCrossings, WhatTheyNeedBeyondTheLimitIsRefused)
{
  std::vector<Xyz> points;
  std::vector<Chain> lines;
  for (vtkIdType i = 0; i < 60; ++i)
  {
    const double along = double(i) + 0.5;
    points.insert(
      points.end(), { { along, 0, 0 }, { along, 60, 0 }, { 0, along, 0 }, { 60, along, 0 } });
    lines.insert(lines.end(), { { 4 * i, 4 * i + 1 }, { 4 * i + 2, 4 * i + 3 } });
  }
  ConstrainedFilter filter(points, makeSource(lines, {}));
  filter->SetCrossingModeToSplit();
  filter->SetMemoryLimit(1500);
  EXPECT_EQ(filter.Run()->GetNumberOfPoints(), 0);
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(filter.Said->Errors[0].find("need points in more than "), std::string::npos)
    << filter.Said->Errors[0];
  EXPECT_NE(filter.Said->Errors[0].find("MemoryLimit allows 1.53 MB"), std::string::npos);
  EXPECT_GT(filter->GetMemoryEstimate(), 1500) << "what is named as needed is more than there was";
  filter->SetMemoryLimit(0);
  EXPECT_EQ(filter.Run()->GetNumberOfPoints(), 240 + 3600);
  EXPECT_EQ(areaOf(filter->GetOutput()), 3600.0 - 0.5);
  const vtkTypeInt64 needed = filter->GetMemoryEstimate();
  for (const vtkTypeInt64 limit : { needed - 1, needed })
  {
    filter->SetMemoryLimit(limit);
    EXPECT_EQ(filter.Run()->GetNumberOfPoints(), limit == needed ? 240 + 3600 : 0) << limit;
    EXPECT_EQ(filter->GetMemoryEstimate(), needed);
  }
}

namespace
{
/// A square whose diagonals cross, each corner twice, at z = 0 and at z = 10; "depth" is z.
vtkSmartPointer<vtkPolyData> squareOfPairs(bool upright)
{
  const double corners[4][2] = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } };
  std::vector<Xyz> points;
  std::vector<double> depths;
  for (double z : { 0.0, 10.0 })
  {
    for (const auto& p : corners)
    {
      points.push_back(upright ? Xyz{ p[0], z, p[1] } : Xyz{ p[0], p[1], z });
      depths.push_back(z);
    }
  }
  auto cloud = makeCloud(points);
  cloud->GetPointData()->AddArray(makeArray<vtkDoubleArray>("depth", depths));
  return cloud;
}
}

TEST(SplitCrossings, LieBetweenThePointsThatAreShown)
{
  const std::pair<int, double> heights[] = { { Filter::FIRST, 0 }, { Filter::LOWEST_Z, 0 },
    { Filter::HIGHEST_Z, 10 }, { Filter::MEAN_Z, 5 } };
  for (const vtkIdType first : { 0, 4 })
  {
    for (const auto& height : heights)
    {
      SCOPED_TRACE("first " + std::to_string(first) + ", policy " + std::to_string(height.first));
      WatchedFilter filter;
      filter->SetInputData(squareOfPairs(false));
      filter->SetSourceData(makeSource({ { first, first + 2 }, { first + 1, first + 3 } }, {}));
      filter->SetCrossingModeToSplit();
      filter->SetDuplicatePolicy(height.first);
      filter->Update();
      ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9);
      EXPECT_EQ(pointOf(filter->GetOutput(), 8), (Xyz{ 2, 2, height.second }));
      EXPECT_EQ(valueOf(filter->GetOutput(), "depth", 8),
        height.first == Filter::HIGHEST_Z ? 10.0 : 0.0); // MEAN_Z has no mean of other data
    }
  }
}

TEST(SplitCrossings, InAnotherPlaneTheyLieBetweenTheMeans)
{
  vtkNew<vtkTransform> swap; // y and z
  const double rows[16] = { 1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1 };
  swap->SetMatrix(rows);
  WatchedFilter filter;
  filter->SetInputData(squareOfPairs(true));
  filter->SetTransform(swap);
  filter->SetSourceData(makeSource({ { 0, 2 }, { 5, 7 } }, {}));
  filter->SetCrossingModeToSplit();
  filter->SetDuplicatePolicyToMeanZ();
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9);
  EXPECT_EQ(pointOf(filter->GetOutput(), 8), (Xyz{ 2, 5, 2 }));
}

TEST(SourceCoordinates, AddedPointsHaveNoGlobalAndPedigreeIds)
{
  auto cloud = makeCloud(kSquare);
  cloud->GetPointData()->SetGlobalIds(makeArray<vtkIdTypeArray>("global", { 10, 20, 30, 40 }));
  cloud->GetPointData()->SetPedigreeIds(
    makeArray<vtkUnsignedCharArray>("pedigree", { 5, 6, 7, 8 }));
  auto source = makeSource(
    { { 0, 1 }, { 2, 3 } }, {}, { { 1, 1, 0 }, { 3, 3, 0 }, { 3, 1, 0 }, { 1, 3, 0 } });
  source->GetPointData()->AddArray(makeArray<vtkIdTypeArray>("global", { 10, 11, 12, 13 }));
  source->GetPointData()->AddArray(makeArray<vtkUnsignedCharArray>("pedigree", { 1, 1, 1, 1 }));
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->SetSourceData(source);
  filter->Update();
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetGlobalIds(), nullptr); // nothing is added
  filter->SetSourceModeToCoordinates();
  filter->SetCrossingModeToSplit();
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  ASSERT_EQ(surface->GetNumberOfPoints(), 9);
  EXPECT_EQ(surface->GetPointData()->GetGlobalIds(), nullptr);
  EXPECT_EQ(surface->GetPointData()->GetPedigreeIds(), nullptr);
  EXPECT_EQ(
    idsOf(surface->GetPointData(), "global"), (Chain{ 10, 20, 30, 40, -1, -1, -1, -1, -1 }));
  EXPECT_EQ(valueOf(surface, "pedigree", 3), 8.0);
  for (vtkIdType i = 4; i < 9; ++i)
  {
    EXPECT_EQ(valueOf(surface, "pedigree", i), 0.0);
  }
}
