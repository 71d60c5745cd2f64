// SPDX-License-Identifier: BSD-3-Clause
//
// The filter's outputs: the triangles, and data passed from its input.
#include "FilterTestSupport.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace ahdtest;

namespace
{
using Wide = std::int64_t; // exact for whole coordinates below 2^13

Wide area(const Xyz& a, const Xyz& b, const Xyz& c)
{
  return (Wide(b[0]) - Wide(a[0])) * (Wide(c[1]) - Wide(a[1])) -
    (Wide(b[1]) - Wide(a[1])) * (Wide(c[0]) - Wide(a[0]));
}

/// > 0 if d is inside the circle through a, b, c (counterclockwise).
Wide inside(const Xyz& a, const Xyz& b, const Xyz& c, const Xyz& d)
{
  const auto row = [&d](const Xyz& p)
  {
    const Wide x = Wide(p[0]) - Wide(d[0]);
    const Wide y = Wide(p[1]) - Wide(d[1]);
    return std::array<Wide, 3>{ x, y, x * x + y * y };
  };
  const auto p = row(a), q = row(b), r = row(c);
  return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
    p[2] * (q[0] * r[1] - q[1] * r[0]);
}

/// How many sides of triangles have no triangle on the other side.
std::size_t boundarySides(const std::vector<Triangle>& triangles)
{
  std::set<std::pair<vtkIdType, vtkIdType>> sides;
  for (const Triangle& t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(sides.insert({ t[i], t[(i + 1) % 3] }).second)
        << "side " << t[i] << " -> " << t[(i + 1) % 3] << " belongs to two triangles";
    }
  }
  return std::count_if(sides.begin(), sides.end(),
    [&sides](const auto& side) {
      return sides.count({ side.second, side.first }) == 0;
    });
}
}

TEST(Result, IsDelaunayByExactArithmetic)
{
  const std::vector<Xyz> points = latticePoints(150, 1000);
  const std::vector<Triangle> triangles = triangulate(points);
  ASSERT_FALSE(triangles.empty());
  for (const Triangle& t : triangles)
  {
    const Xyz &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    ASSERT_GT(area(a, b, c), 0) << "triangle " << t[0] << " " << t[1] << " " << t[2];
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_LE(inside(a, b, c, points[i]), 0)
        << "point " << i << " is in the circle of " << t[0] << " " << t[1] << " " << t[2];
    }
  }
}

TEST(Result, HasTwoVMinusTwoMinusHTriangles)
{
  const std::vector<Xyz> points = latticePoints(3000, 40); // crowded: many duplicates and ties
  const std::vector<Triangle> triangles = triangulate(points);
  const std::set<Xyz> distinct(points.begin(), points.end());
  EXPECT_EQ(triangles.size(), 2 * distinct.size() - 2 - boundarySides(triangles));
  std::set<vtkIdType> used;
  for (const Triangle& t : triangles)
  {
    used.insert(t.begin(), t.end());
  }
  EXPECT_EQ(used.size(), distinct.size());
}

TEST(Result, IsTheSameForFloatAndDouble)
{
  const std::vector<Xyz> points = latticePoints(2000, 5000);
  EXPECT_EQ(triangulate(points, VTK_FLOAT), triangulate(points, VTK_DOUBLE));
}

TEST(Result, IsTheSameForShuffledPointsUpToTheIds)
{
  const std::vector<Xyz> points = latticePoints(1000, 4000);
  ASSERT_EQ(std::set<Xyz>(points.begin(), points.end()).size(), points.size());
  std::vector<vtkIdType> place(points.size()); // point i of the shuffled is place[i] of the others
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), std::mt19937(7));
  std::vector<Xyz> shuffled;
  for (vtkIdType i : place)
  {
    shuffled.push_back(points[i]);
  }
  std::vector<Triangle> triangles = triangulate(shuffled);
  for (Triangle& t : triangles)
  {
    t = { place[t[0]], place[t[1]], place[t[2]] };
  }
  EXPECT_EQ(triangles, triangulate(points));
}

TEST(Result, IgnoresZ)
{
  std::vector<Xyz> points = latticePoints(500, 300);
  const std::vector<Triangle> flat = triangulate(points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i][2] = 1e6 * double(i % 17);
  }
  EXPECT_EQ(triangulate(points), flat);
}

TEST(Result, UsesNarrowStorageThatVtkFindsValid)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(latticePoints(500, 1000)));
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  vtkCellArray* cells = surface->GetPolys();
  EXPECT_FALSE(cells->IsStorage64Bit());
  EXPECT_TRUE(cells->IsValid());
  EXPECT_EQ(cells->IsHomogeneous(), 3);
  EXPECT_EQ(cells->GetNumberOfCells(), filter->GetNumberOfTriangles());
  EXPECT_EQ(surface->GetNumberOfCells(), filter->GetNumberOfTriangles());
  EXPECT_EQ(surface->GetCellType(0), VTK_TRIANGLE);
}

TEST(Result, SharesPointsAndPassesPointAndFieldData)
{
  auto cloud = makeCloud(latticePoints(100, 1000));
  vtkNew<vtkDoubleArray> depth;
  depth->SetName("depth");
  depth->SetNumberOfValues(100);
  depth->FillValue(3.0);
  cloud->GetPointData()->SetScalars(depth);
  vtkNew<vtkDoubleArray> note;
  note->SetName("note");
  note->InsertNextValue(1.0);
  cloud->GetFieldData()->AddArray(note);

  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(cloud);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  EXPECT_EQ(surface->GetPoints(), cloud->GetPoints());
  EXPECT_EQ(surface->GetPointData()->GetScalars(), depth);
  EXPECT_EQ(surface->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(surface->GetFieldData()->GetArray("note"), note);
  EXPECT_EQ(cloud->GetFieldData()->GetNumberOfArrays(), 1) << "the input was written to";
  EXPECT_EQ(cloud->GetNumberOfCells(), 0) << "the input was written to";
}

TEST(Result, DoesNotPassCellsOrCellData)
{
  auto cloud = makeCloud(latticePoints(100, 1000));
  vtkNew<vtkCellArray> lines;
  const vtkIdType line[] = { 0, 1 };
  lines->InsertNextCell(2, line);
  cloud->SetLines(lines);
  vtkNew<vtkDoubleArray> length;
  length->SetName("length");
  length->InsertNextValue(1.0);
  cloud->GetCellData()->AddArray(length);

  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), filter->GetOutput()->GetNumberOfPolys());
}

TEST(Result, CountsAreMeasuresAndFieldData)
{
  std::vector<Xyz> points = latticePoints(400, 15);
  points[10][0] = std::numeric_limits<double>::quiet_NaN();
  WatchedFilter filter;
  filter->SetInputData(makeCloud(points));
  filter->Update();
  const auto field = [&filter](const char* name)
  {
    auto* array = vtkIdTypeArray::SafeDownCast(filter->GetOutput()->GetFieldData()->GetArray(name));
    return array && array->GetNumberOfTuples() == 1 ? array->GetValue(0) : vtkIdType(-1);
  };
  EXPECT_EQ(field("NumberOfPointsInserted"), filter->GetNumberOfPointsInserted());
  EXPECT_EQ(field("NumberOfDuplicates"), filter->GetNumberOfDuplicates());
  EXPECT_EQ(field("NumberOfRejectedPoints"), 1);
  EXPECT_EQ(field("NumberOfSkippedPoints"), 0);
  EXPECT_EQ(field("NumberOfTriangles"), filter->GetOutput()->GetNumberOfCells());
  std::set<Xyz> distinct(points.begin(), points.begin() + 10);
  distinct.insert(points.begin() + 11, points.end());
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), vtkIdType(distinct.size()));
  EXPECT_EQ(filter->GetNumberOfDuplicates(), vtkIdType(399 - distinct.size()));
  EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 1);
}

TEST(Result, FateSaysWhatBecameOfEachPoint)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  WatchedFilter filter;
  filter->GenerateFateOn();
  filter->SetInputData(
    makeCloud({ { 0, 0, 1 }, { nan, 0, 0 }, { 4, 0, 0 }, { 0, 0, 2 }, { 0, 4, 0 }, { 4, 0, 9 } }));
  filter->Update();
  auto* fate = vtkIdTypeArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray("Fate"));
  ASSERT_NE(fate, nullptr);
  ASSERT_EQ(fate->GetNumberOfTuples(), 6);
  const vtkIdType expected[] = { 0, -1, 2, 0, 4, 2 };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    EXPECT_EQ(fate->GetValue(i), expected[i]) << "point " << i;
  }

  filter->GenerateFateOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Fate"), nullptr);
}
