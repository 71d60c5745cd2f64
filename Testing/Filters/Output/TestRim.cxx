// SPDX-License-Identifier: BSD-3-Clause
//
// Rim: grids in another plane than x, y get the triangles of their squares and no walls, unless the
// convex hull is requested; other bounds of the surface stay; removed triangles are reported.
#include "ConstraintTestSupport.h"
#include "FilterTestSupport.h"

#include "vtkCellData.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertDelaunay2D;

namespace
{

using Height = std::function<double(int, int)>;

/// n x m points with a spacing of 1, row by row.
std::vector<Xyz> gridOf(int n, int m, const Height& height)
{
  std::vector<Xyz> points;
  for (int i = 0; i < n; ++i)
  {
    for (int k = 0; k < m; ++k)
    {
      points.push_back({ double(i), double(k), height(i, k) });
    }
  }
  return points;
}

/// Another number from 0 to 1 for each pair.
double noise(int i, int k)
{
  std::mt19937_64 random(unsigned(1000 * i + k + 1));
  return double(random() >> 11) * 0x1p-53;
}

/// Turned, and moved to where maps have their coordinates.
std::vector<Xyz> onAMap(const std::vector<Xyz>& points)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(450000, 5600000, 800);
  transform->RotateZ(33);
  transform->RotateX(21);
  std::vector<Xyz> moved = points;
  for (Xyz& p : moved)
  {
    transform->TransformPoint(p.data(), p.data());
  }
  return moved;
}

double areaOf(const std::vector<Xyz>& points, const std::vector<Triangle>& triangles)
{
  double area = 0.0;
  for (const Triangle& t : triangles)
  {
    Xyz u, v;
    for (std::size_t k = 0; k < 3; ++k)
    {
      u[k] = points[std::size_t(t[1])][k] - points[std::size_t(t[0])][k];
      v[k] = points[std::size_t(t[2])][k] - points[std::size_t(t[0])][k];
    }
    area += 0.5 *
      std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }
  return area;
}

/// The grid's squares, cut along one diagonal or the other.
std::vector<Triangle> squaresOf(int n, int m, bool isOther)
{
  std::vector<Triangle> triangles;
  for (int i = 0; i + 1 < n; ++i)
  {
    for (int k = 0; k + 1 < m; ++k)
    {
      const vtkIdType a = i * m + k, b = a + 1, c = a + m, d = c + 1;
      triangles.push_back(isOther ? Triangle{ a, b, c } : Triangle{ a, b, d });
      triangles.push_back(isOther ? Triangle{ b, d, c } : Triangle{ a, d, c });
    }
  }
  return triangles;
}

/// In the best-fitting plane.
struct Fitted : WatchedFilter
{
  explicit Fitted(const std::vector<Xyz>& points)
  {
    this->Filter->SetInputData(makeCloud(points));
    this->Filter->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  }
  vtkIdType Count()
  {
    this->Filter->Update();
    return this->Filter->GetOutput()->GetNumberOfPolys();
  }
};

struct Grid
{
  const char* Name;
  int N, M;
  Height At;
};

const std::vector<Grid>& grids()
{
  static const std::vector<Grid> all = {
    { "4 x 4, z = x y modulo 3", 4, 4, [](int i, int k) { return i * k % 3; } },
    { "a plane", 10, 10, [](int i, int) { return 0.1 * i; } },
    { "VTK's example", 10, 10, [](int i, int k) { return (i + k) / (k + 1); } },
    { "a saddle", 10, 10, [](int i, int k) { return i * k / 10.0; } },
    { "noise", 10, 10, noise },
    { "45 degrees", 60, 40, [](int i, int k) { return 0.8 * i + 0.6 * k; } },
    { "steeper", 30, 30, [](int i, int k) { return 2.5 * i + 0.2 * k; } },
    { "hills on a slope", 50, 50,
      [](int i, int k) { return 0.5 * i + 2 * std::sin(0.2 * i + 1) * std::cos(0.2 * k); } },
  };
  return all;
}

}

TEST(Rim, GridsInAFittedPlaneHaveNoWalls)
{
  for (const Grid& grid : grids())
  {
    for (const bool isMap : { false, true })
    {
      SCOPED_TRACE(std::string(grid.Name) + (isMap ? ", on a map" : ""));
      const std::vector<Xyz> own = gridOf(grid.N, grid.M, grid.At);
      const std::vector<Xyz> points = isMap ? onAMap(own) : own;
      Fitted filter(points);
      EXPECT_EQ(filter.Count(), 2 * (grid.N - 1) * (grid.M - 1));
      EXPECT_TRUE(filter.Said->Warnings.empty()) << filter.Said->Warnings[0];
      const double one = areaOf(points, squaresOf(grid.N, grid.M, false));
      const double other = areaOf(points, squaresOf(grid.N, grid.M, true));
      const double area = areaOf(points, trianglesOf(filter->GetOutput()));
      EXPECT_GT(area, 0.99 * std::min(one, other));
      EXPECT_LT(area, 1.01 * std::max(one, other));
    }
  }
}

TEST(Rim, SlopesWithNoiseHaveHardlyMoreTriangles)
{
  for (const double slope : { 0.3, 1.0 })
  {
    const std::vector<Xyz> points = onAMap(
      gridOf(40, 60, [slope](int i, int k) { return slope * i + noise(i, k); }));
    Fitted filter(points);
    const vtkIdType expected = 2 * 39 * 59;
    EXPECT_GE(filter.Count(), expected);
    EXPECT_LE(filter.Count(), expected * 105 / 100);
    const double one = areaOf(points, squaresOf(40, 60, false));
    const double other = areaOf(points, squaresOf(40, 60, true));
    EXPECT_LT(areaOf(points, trianglesOf(filter->GetOutput())), 1.03 * std::max(one, other));
  }
}

TEST(Rim, IrregularPointsLoseLittle)
{
  double lost = 0.0;
  for (unsigned seed = 1; seed <= 16; ++seed)
  {
    const std::vector<Xyz> points = scatteredPoints(3000, seed);
    WatchedFilter filter;
    filter->SetInputData(makeCloud(points));
    filter->Update();
    const double whole = areaOf(points, trianglesOf(filter->GetOutput()));
    filter->SetRimToTrimmed();
    filter->Update();
    lost += (1 - areaOf(points, trianglesOf(filter->GetOutput())) / whole) / 16;
  }
  EXPECT_NEAR(lost, 0.0150, 0.0008) << "0.0134 with an arc tangent of 1/3, 0.0170 with 1/2";
}

TEST(Rim, HullAndTrimmedCanBeAskedForInAnyPlane)
{
  const std::vector<Xyz> points = gridOf(10, 10, noise);
  Fitted filter(points);
  const vtkIdType trimmed = filter.Count();
  filter->SetRimToConvexHull();
  const vtkIdType whole = filter.Count();
  EXPECT_GT(whole, trimmed);
  EXPECT_EQ(filter->GetNumberOfTrimmedTriangles(), 0);
  filter->SetRimToTrimmed();
  EXPECT_EQ(filter.Count(), trimmed);
  EXPECT_EQ(filter->GetNumberOfTrimmedTriangles(), whole - trimmed);
  EXPECT_EQ(filter->GetNumberOfTriangles(), trimmed);
  EXPECT_EQ(idsOf(filter->GetOutput()->GetFieldData(), "NumberOfTrimmedTriangles"),
    std::vector<vtkIdType>{ whole - trimmed });

  // A bent rim in x, y: trimmed only on request.
  std::vector<Xyz> bent = gridOf(10, 10, [](int, int) { return 0.0; });
  for (Xyz& p : bent)
  {
    p[1] += 0.02 * p[0] * (9 - p[0]) * (p[1] - 4.5) * -0.1;
  }
  WatchedFilter plane;
  plane->SetInputData(makeCloud(bent));
  plane->Update();
  const vtkIdType hull = plane->GetOutput()->GetNumberOfPolys();
  EXPECT_GT(hull, 162);
  plane->SetRimToConvexHull();
  plane->Update();
  EXPECT_EQ(plane->GetOutput()->GetNumberOfPolys(), hull);
  plane->SetRimToTrimmed();
  plane->Update();
  EXPECT_EQ(plane->GetOutput()->GetNumberOfPolys(), 162);
  plane->SetRimToAutomatic();
  vtkNew<vtkTransform> transform;
  transform->Scale(2, 2, 2);
  plane->SetTransform(transform);
  plane->Update();
  EXPECT_EQ(plane->GetOutput()->GetNumberOfPolys(), 162) << "a plane of its own";
}

TEST(Rim, WhatBoundsTheSurfaceIsLeftAlone)
{
  const std::vector<Xyz> points = gridOf(10, 10, noise);
  Fitted hull(points);
  hull->SetRimToConvexHull();
  const vtkIdType whole = hull.Count();
  Fitted filter(points);
  filter->SetRimToTrimmed();
  filter->SetAlpha(1e6);
  EXPECT_EQ(filter.Count(), whole);
  filter->SetAlpha(0);
  filter->SetMaximumEdgeLength(1e6);
  EXPECT_EQ(filter.Count(), whole);
  filter->SetMaximumEdgeLength(0);
  EXPECT_LT(filter.Count(), whole);

  WatchedFilter bounded;
  bounded->SetInputData(makeCloud(points));
  bounded->SetRimToTrimmed();
  bounded->BoundingTriangulationOn();
  bounded->Update();
  EXPECT_EQ(bounded->GetNumberOfTrimmedTriangles(), 0);
}

TEST(Rim, LinesAndLoopsStayEdges)
{
  const std::vector<Xyz> points = gridOf(10, 10, noise);
  // From corner to corner past the rim's points: its edge is one of a flat triangle.
  Fitted filter(points);
  filter->SetSourceData(makeSource({ { 0, 90 }, { 3, 57 } }, {}));
  filter->GenerateConstraintEdgesOn();
  EXPECT_GE(filter.Count(), 162);
  std::set<std::set<vtkIdType>> edges;
  for (const Triangle& t : trianglesOf(filter->GetOutput()))
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      edges.insert({ t[e], t[(e + 1) % 3] });
    }
  }
  EXPECT_EQ(edges.count({ 0, 90 }), 1u);
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 2);

  // Along the grid's own rim a loop bounds the same as lines.
  std::vector<vtkIdType> ring;
  for (vtkIdType i = 0; i < 9; ++i)
  {
    ring.push_back(10 * i);
  }
  for (vtkIdType i = 0; i < 9; ++i)
  {
    ring.push_back(90 + i);
  }
  for (vtkIdType i = 9; i > 0; --i)
  {
    ring.push_back(10 * i + 9);
  }
  for (vtkIdType i = 9; i > 0; --i)
  {
    ring.push_back(i);
  }
  Fitted looped(points);
  looped->SetSourceData(makeSource({}, { ring }));
  looped->SetFillRuleToEvenOdd();
  EXPECT_EQ(looped.Count(), 162);
  EXPECT_EQ(looped->GetNumberOfTrimmedTriangles(), 0);
}

TEST(Rim, ArraysAndDiagramFitTheTriangles)
{
  Fitted filter(gridOf(10, 10, noise));
  filter->GenerateNeighborsOn();
  filter->GenerateRegionIdsOn();
  filter->GenerateVoronoiOn();
  filter->GeneratePointStatusOn();
  EXPECT_EQ(filter.Count(), 162);
  const std::vector<vtkIdType> neighbors = idsOf(filter->GetOutput()->GetCellData(), "Neighbors");
  ASSERT_EQ(neighbors.size(), 3 * 162u);
  EXPECT_EQ(std::count(neighbors.begin(), neighbors.end(), -1), 36) << "the grid's own rim";
  const std::vector<vtkIdType> regions = idsOf(filter->GetOutput()->GetCellData(), "RegionId");
  EXPECT_EQ(regions, std::vector<vtkIdType>(162, 0));
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfPolys(), 100) << "a cell for each vertex";
  const std::vector<vtkIdType> status = idsOf(filter->GetOutput()->GetPointData(), "Fate");
  EXPECT_TRUE(std::is_sorted(status.begin(), status.end()));
}

TEST(Rim, PointsWithACoordinateInCommonKeepTheirHull)
{
  std::vector<Xyz> points = scatteredPoints(2000);
  for (Xyz& p : points)
  {
    p[2] = 7.25;
  }
  WatchedFilter plane;
  plane->SetInputData(makeCloud(points));
  plane->Update();
  const std::vector<Triangle> whole = trianglesOf(plane->GetOutput());
  for (std::size_t turn = 0; turn < 3; ++turn)
  {
    SCOPED_TRACE(turn);
    std::vector<Xyz> turned = points;
    for (Xyz& p : turned)
    {
      std::rotate(p.begin(), p.begin() + std::ptrdiff_t(turn), p.end());
    }
    Fitted filter(turned);
    filter.Count();
    EXPECT_EQ(trianglesOf(filter->GetOutput()), whole);
    EXPECT_EQ(filter->GetNumberOfTrimmedTriangles(), 0);
    filter->SetRimToTrimmed();
    EXPECT_LT(filter.Count(), vtkIdType(whole.size()));
  }
}

TEST(Rim, WhatGoesIsSaid)
{
  Fitted three({ { 0, 0, 0 }, { 10, 0, 1 }, { 5, 0.5, 3 } });
  Fitted flat({ { 0, 0, 0 }, { 10, 0, 10 }, { 5, 0.5, 5 } });
  EXPECT_EQ(three.Count(), 1) << "not flat in its plane";
  EXPECT_TRUE(three.Said->Warnings.empty());
  EXPECT_EQ(flat.Count(), 0);
  ASSERT_EQ(flat.Said->Warnings.size(), 1u);
  EXPECT_EQ(flat.Said->Errors.size(), 0u);
  EXPECT_NE(
    flat.Said->Warnings[0].find("There is no triangle left: trimming the rim removed all 1 of "
                                "1 triangles, 100 % of the area in the plane, and "
                                "left 3 points without a triangle"),
    std::string::npos)
    << flat.Said->Warnings[0];
  EXPECT_EQ(flat->GetNumberOfPointsInserted(), 3);
  EXPECT_EQ(flat->GetOutput()->GetNumberOfPoints(), 3);

  std::vector<Xyz> strip = scatteredPoints(400);
  for (Xyz& p : strip)
  {
    p[0] *= 300;
    p[2] = p[0];
  }
  Fitted thin(strip);
  EXPECT_GT(thin.Count(), 0);
  ASSERT_EQ(thin.Said->Warnings.size(), 1u);
  EXPECT_NE(thin.Said->Warnings[0].find("Trimming the rim removed "), std::string::npos);
  thin->SetRimToConvexHull();
  thin.Count();
  EXPECT_EQ(thin.Said->Warnings.size(), 1u) << "none more";
}
