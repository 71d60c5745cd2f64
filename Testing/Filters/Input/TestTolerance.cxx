// SPDX-License-Identifier: BSD-3-Clause
//
// Points within the tolerance of others: the merged ones, their counts, and their arrays.
#include "ConstraintTestSupport.h"

#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

using namespace ahdtest;

namespace
{
/// A square of side 3 and 4, its diagonal 5, and points at distances of 0.05 and 0.11 from corners.
const std::vector<Xyz> kPoints = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 4, 0 }, { 0, 4, 0 },
  { 0.03, 0.04, 0 }, { 2.89, 4, 0 }, { 0.03, 0.04, 9 }, { 3, 0, 9 } };
}

TEST(Tolerance, PointsWithinAreMergedAndCounted)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(kPoints));
  filter->GenerateFateOn();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 0);
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 6);
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 2);

  filter->SetTolerance(0.02); // a distance of 0.1
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 2);
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 5);
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 1);
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 0);
  EXPECT_EQ(idsOf(filter->GetOutput()->GetPointData(), "Fate"), (Chain{ 0, 1, 2, 3, 0, 5, 0, 1 }));
  EXPECT_EQ(idsOf(filter->GetOutput()->GetFieldData(), "NumberOfMergedPoints"), Chain{ 2 });
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 8);
  EXPECT_EQ(
    filter->GetOutput()->GetPoints(), vtkPolyData::SafeDownCast(filter->GetInput())->GetPoints());
  EXPECT_TRUE(filter.Said->Warnings.empty());

  filter->SetTolerance(0.03);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 3); // (3, 4) into (2.89, 4), of smaller x
  EXPECT_EQ(idsOf(filter->GetOutput()->GetPointData(), "Fate"), (Chain{ 0, 1, 5, 3, 0, 5, 0, 1 }));
  EXPECT_EQ(filter->GetNumberOfTriangles(), 2);
}

TEST(Tolerance, IsOfTheDiagonalInThePlane)
{
  std::vector<Xyz> deep = kPoints; // depths in metres over degrees: the diagonal in space is long
  for (std::size_t i = 0; i < deep.size(); ++i)
  {
    deep[i][2] = 1000.0 * double(i);
  }
  WatchedFilter filter;
  filter->SetInputData(makeCloud(deep));
  filter->SetTolerance(0.02);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 2);
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 5);
}

TEST(Tolerance, TheOrderOfTheInputHasNoSay)
{
  std::vector<Xyz> points = scatteredPoints(3000);
  const auto outcome = [&]
  {
    WatchedFilter filter;
    filter->SetInputData(makeCloud(points));
    filter->SetTolerance(0.01);
    filter->GenerateFateOn();
    filter->Update();
    EXPECT_GT(filter->GetNumberOfMergedPoints(), 100);
    const auto fates = idsOf(filter->GetOutput()->GetPointData(), "Fate");
    std::map<Xyz, Xyz> into;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      into[points[i]] = points[std::size_t(fates[i])];
    }
    std::vector<std::array<Xyz, 3>> triangles;
    for (const Triangle& t : trianglesOf(filter->GetOutput()))
    {
      triangles.push_back(
        { points[std::size_t(t[0])], points[std::size_t(t[1])], points[std::size_t(t[2])] });
    }
    return std::make_pair(into, triangles);
  };
  const auto expected = outcome();
  std::shuffle(points.begin(), points.end(), std::mt19937(7));
  EXPECT_EQ(outcome(), expected);
}

TEST(Tolerance, ConstraintsFollowTheirPoints)
{
  std::vector<Xyz> points = squareLattice(10);
  points.push_back({ 0.001, 0.002, 0 }); // 100
  points.push_back({ 9.001, 7.002, 0 }); // 101, merged into 97
  ConstrainedFilter filter(points, makeSource({ { 100, 101 } }, {}));
  filter->SetTolerance(0.001);
  EXPECT_TRUE(hasEdge(filter.Run(), 0, 97));
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 2);
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 0);
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);
}

TEST(Tolerance, PointsOfTheSourceAreMergedWithThoseOfTheInput)
{
  ConstrainedFilter filter(
    squareLattice(10), makeSource({ { 0, 1 } }, {}, { { 0.001, 0.001, 0 }, { 9, 7.001, 0 } }));
  filter->SetSourceModeToCoordinates();
  filter->SetTolerance(0.001);
  EXPECT_TRUE(hasEdge(filter.Run(), 0, 97));
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 2);
}

TEST(Tolerance, CrossingsAreFoundAfterMerging)
{
  // merged, the two lines end in one point; else they cross near it
  std::vector<Xyz> points = { { 0, 0, 0 }, { 10, 10, 0 }, { 10, 0, 0 }, { 0, 10, 0 }, { 5, 5, 0 },
    { 5.001, 5.001, 0 } };
  const auto source = makeSource({ { 0, 5 }, { 2, 4 }, { 4, 3 } }, {});
  ConstrainedFilter filter(points, source);
  filter->SetCrossingModeToSplit();
  filter->SetTolerance(0.001);
  filter.Run();
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 0);
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 3);
}

TEST(Tolerance, SkippedPointsAreNeitherMergedNorCounted)
{
  auto cloud = makeCloud(kPoints);
  auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  marks->SetName("vtkGhostType");
  marks->SetNumberOfValues(8);
  marks->Fill(0);
  marks->SetValue(4, vtkDataSetAttributes::DUPLICATEPOINT);
  cloud->GetPointData()->AddArray(marks);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->SetTolerance(0.02);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 1);
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 1);
}

TEST(Tolerance, OneMergesAllAndHugeCoordinatesDoNotOverflow)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(kPoints));
  filter->SetTolerance(7.0);
  EXPECT_EQ(filter->GetTolerance(), 1.0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 1);
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 7);

  const double huge = std::numeric_limits<double>::max();
  filter->SetInputData(
    makeCloud({ { -huge, -huge, 0 }, { huge, -huge, 0 }, { 0, huge, 0 }, { 0, huge / 2, 0 } }));
  filter->SetTolerance(0.1);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 0);
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 4);
}

TEST(Tolerance, WithALimitMergedPointsFollowTheOnesKept)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(kPoints));
  filter->SetTolerance(0.02);
  filter->SetInsertionOrderToAsGiven();
  filter->SetInsertionLimit(3);
  filter->GenerateFateOn();
  filter->Update();
  EXPECT_EQ(
    idsOf(filter->GetOutput()->GetPointData(), "Fate"), (Chain{ 0, 1, 2, -2, 0, -2, 0, 1 }));
  EXPECT_EQ(filter->GetNumberOfPointsBeyondLimit(), 2);
}

TEST(Tolerance, WhatIsMergedIntoAPointBeyondTheLimitIsBeyondItToo)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(kPoints));
  filter->SetTolerance(0.03); // 2 into 5
  filter->SetInsertionOrderToAsGiven();
  filter->SetInsertionLimit(3);
  filter->SetAlpha(0.001); // nothing but vertices
  filter->GenerateFateOn();
  filter->Update();
  EXPECT_EQ(
    idsOf(filter->GetOutput()->GetPointData(), "Fate"), (Chain{ 0, 1, -2, 3, 0, -2, 0, 1 }));
  Chain verts;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetVerts()->GetNumberOfConnectivityIds(); ++i)
  {
    verts.push_back(
      vtkIdType(filter->GetOutput()->GetVerts()->GetConnectivityArray()->GetComponent(i, 0)));
  }
  EXPECT_EQ(verts, (Chain{ 0, 1, 3, 4, 6, 7 }));
}

TEST(Tolerance, IsNamedWhereItLeavesNoTriangle)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }));
  filter->SetTolerance(1.0);
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("among 4, of which Tolerance merged 3 into others."),
    std::string::npos)
    << filter.Said->Warnings[0];
}
