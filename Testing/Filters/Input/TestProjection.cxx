// SPDX-License-Identifier: BSD-3-Clause
//
// Points triangulated in another plane than x, y.
#include "Engine/Surface/Plane.h"
#include "FilterTestSupport.h"

#include "vtkDataSetAttributes.h"
#include "vtkMatrix4x4.h"
#include "vtkPerspectiveTransform.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace ahdtest;

namespace
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A plane of whole numbers: points i * u + j * v, shifted far away.
struct Slope
{
  std::vector<Xyz> Points;
  Xyz Normal;
};

Slope makeSlope(unsigned seed)
{
  std::mt19937 random(seed); // its sequence is fixed by the standard
  const auto whole = [&random](int most)
  { return double(random() % unsigned(2 * most + 1)) - most; };
  Slope slope;
  Xyz u, v;
  do
  {
    u = { whole(5), whole(5), whole(5) };
    v = { whole(5), whole(5), whole(5) };
    slope.Normal = ahd::cross(u, v);
  } while (ahd::dot(slope.Normal, slope.Normal) == 0);
  for (int k = 0; k < 60; ++k)
  {
    const double i = whole(40), j = whole(40);
    slope.Points.push_back(
      { 500000 + i * u[0] + j * v[0], 6000000 + i * u[1] + j * v[1], i * u[2] + j * v[2] });
  }
  return slope;
}

Xyz normalOf(const std::vector<Xyz>& points, const Triangle& t)
{
  const Xyz& a = points[std::size_t(t[0])];
  Xyz u, v;
  for (std::size_t k = 0; k < 3; ++k)
  {
    u[k] = points[std::size_t(t[1])][k] - a[k];
    v[k] = points[std::size_t(t[2])][k] - a[k];
  }
  return ahd::cross(u, v);
}

/// With the whole hull.
std::vector<Triangle> triangulateFitted(const std::vector<Xyz>& points)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->SetRimToConvexHull();
  auto cloud = makeCloud(points);
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPoints(), cloud->GetPoints()) << "points were moved";
  return trianglesOf(filter->GetOutput());
}

/// The points as the transform leaves them.
std::vector<Xyz> transformed(const std::vector<Xyz>& points, vtkAbstractTransform* transform)
{
  std::vector<Xyz> moved = points;
  for (Xyz& p : moved)
  {
    transform->TransformPoint(p.data(), p.data());
  }
  return moved;
}
}

TEST(Projection, SlopesAreTriangulatedInTheirPlane)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    const Slope slope = makeSlope(seed);
    const std::vector<Triangle> triangles = triangulateFitted(slope.Points);
    ASSERT_FALSE(triangles.empty());
    std::size_t main = 2;
    while (std::fabs(slope.Normal[main]) <
      std::max(
        { std::fabs(slope.Normal[0]), std::fabs(slope.Normal[1]), std::fabs(slope.Normal[2]) }))
    {
      --main;
    }
    // Seen along that axis: all counterclockwise, without overlaps or gaps, as the areas add up to
    // the hull's. Points on an edge of the hull may be off it by a rounding and make triangles
    // without area.
    double area = 0.0;
    for (const Triangle& t : triangles)
    {
      const double twice = normalOf(slope.Points, t)[main];
      ASSERT_GE(twice, 0.0) << "slope " << seed;
      area += twice;
    }
    std::vector<Xyz> flat = slope.Points;
    for (Xyz& p : flat)
    {
      p = { p[(main + 1) % 3], p[(main + 2) % 3], 0.0 };
    }
    double hull = 0.0;
    for (const Triangle& t : triangulate(flat))
    {
      hull += normalOf(flat, t)[2];
    }
    ASSERT_EQ(area, hull) << "slope " << seed; // whole numbers
  }
}

TEST(Projection, NoPointLiesInsideACircle)
{
  // in space: the points of the plane inside the sphere around a triangle's circle are those inside
  // the circle
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const Slope slope = makeSlope(seed);
    for (const Triangle& t : triangulateFitted(slope.Points))
    {
      const Xyz& a = slope.Points[std::size_t(t[0])];
      Xyz u, v;
      for (std::size_t k = 0; k < 3; ++k)
      {
        u[k] = slope.Points[std::size_t(t[1])][k] - a[k];
        v[k] = slope.Points[std::size_t(t[2])][k] - a[k];
      }
      const Xyz n = ahd::cross(u, v);
      const Xyz uv = ahd::cross(n, u), vv = ahd::cross(v, n);
      if (n == Xyz{ 0, 0, 0 })
      {
        continue; // on an edge of the hull
      }
      const double nn = ahd::dot(n, n), uu = ahd::dot(u, u), ww = ahd::dot(v, v);
      Xyz centre;
      for (std::size_t k = 0; k < 3; ++k)
      {
        centre[k] = (ww * uv[k] + uu * vv[k]) / (2 * nn);
      }
      const double radius2 = ahd::dot(centre, centre);
      for (const Xyz& p : slope.Points)
      {
        const Xyz d = { p[0] - a[0] - centre[0], p[1] - a[1] - centre[1], p[2] - a[2] - centre[2] };
        ASSERT_GE(ahd::dot(d, d), radius2 * (1 - 1e-9)) << "slope " << seed;
      }
    }
  }
}

TEST(Projection, VerticalWallsAreSeenFromTheFront)
{
  const std::vector<Xyz> flat = latticePoints(300, 30); // many cocircular and coincident
  for (std::size_t across : { 0u, 1u, 2u })
  {
    std::vector<Xyz> wall = flat;
    for (std::size_t i = 0; i < wall.size(); ++i)
    {
      wall[i][across] = 6000000.1;
      wall[i][(across + 1) % 3] = flat[i][0];
      wall[i][(across + 2) % 3] = flat[i][1];
    }
    EXPECT_EQ(triangulateFitted(wall), triangulate(flat)) << "axis " << across;
  }
}

TEST(Projection, TheFittedPlaneIsThatOfTheTransform)
{
  const std::vector<Xyz> points = makeSlope(7).Points;
  auto cloud = makeCloud(points);
  auto transform = vtkSmartPointer<vtkAbstractTransform>::Take(
    vtkAdaptiveHilbertDelaunay2D::ComputeBestFittingPlane(cloud));
  ASSERT_NE(transform, nullptr);
  EXPECT_EQ(transform->GetReferenceCount(), 1);
  for (const Xyz& p : transformed(points, transform))
  {
    EXPECT_NEAR(p[2], 0.0, 1e-8);
  }
  EXPECT_EQ(vtkAdaptiveHilbertDelaunay2D::ComputeBestFittingPlane(nullptr), nullptr);
  auto none = vtkSmartPointer<vtkAbstractTransform>::Take(
    vtkAdaptiveHilbertDelaunay2D::ComputeBestFittingPlane(vtkNew<vtkPolyData>()));
  ASSERT_NE(none, nullptr);
  EXPECT_EQ(transformed({ { 1, 2, 3 } }, none), (std::vector<Xyz>{ { 1, 2, 3 } }));
}

TEST(Projection, GhostsAndOddPointsHaveNoSayInThePlane)
{
  std::vector<Xyz> points = makeSlope(8).Points;
  const std::vector<Triangle> expected = triangulateFitted(points);
  points.push_back({ 500000, 6000000, 1e6 });
  points.push_back({ 500000, 6000000, kNaN });
  auto cloud = makeCloud(points);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(cloud->GetNumberOfPoints());
  marks->FillValue(0);
  marks->SetValue(cloud->GetNumberOfPoints() - 2, vtkDataSetAttributes::HIDDENPOINT);
  cloud->GetPointData()->AddArray(marks);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->SetRimToConvexHull();
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), expected);
  EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 1);
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 1);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("no finite position in the plane"), std::string::npos)
    << filter.Said->Warnings[0];
}

TEST(Projection, TransformedPointsAreTriangulatedWhereTheyWere)
{
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(77, 3, 1, 2);
  const std::vector<Xyz> points = scatteredPoints(500);
  const std::vector<Triangle> expected = triangulate(transformed(points, transform));
  for (int mode : { VTK_SET_TRANSFORM_PLANE, VTK_DELAUNAY_XY_PLANE })
  {
    for (int type : { VTK_DOUBLE, VTK_FLOAT })
    {
      WatchedFilter filter;
      auto cloud = makeCloud(points, type);
      filter->SetInputData(cloud);
      filter->SetTransform(transform);
      filter->SetRimToConvexHull();
      filter->SetProjectionPlaneMode(mode);
      for (int run = 0; run < 2; ++run)
      {
        filter->Modified();
        filter->Update();
        EXPECT_EQ(filter->GetTransform(), transform);
        EXPECT_EQ(filter->GetOutput()->GetPoints(), cloud->GetPoints());
        if (type == VTK_DOUBLE)
        {
          EXPECT_EQ(trianglesOf(filter->GetOutput()), expected) << "mode " << mode;
        }
      }
      EXPECT_TRUE(filter.Said->Warnings.empty());
    }
  }
}

TEST(Projection, AFitTakesNoNoticeOfATransform)
{
  vtkNew<vtkTransform> transform;
  transform->RotateX(90);
  const std::vector<Xyz> points = makeSlope(9).Points;
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(points));
  filter->SetTransform(transform);
  filter->SetRimToConvexHull();
  filter->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulateFitted(points));
  EXPECT_EQ(filter->GetTransform(), transform);
}

TEST(Projection, ChangesOfTheTransformAreNoticed)
{
  const std::vector<Xyz> points = scatteredPoints(100);
  vtkNew<vtkTransform> transform;
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(points));
  filter->SetTransform(transform);
  filter->SetRimToConvexHull();
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(points));
  transform->Scale(1, 0.1, 1);
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(transformed(points, transform)));
  filter->SetTransform(nullptr);
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(points));
}

TEST(Projection, WithoutATransformItIsXAndY)
{
  const std::vector<Xyz> points = scatteredPoints(100);
  WatchedFilter filter;
  filter->SetInputData(makeCloud(points));
  filter->SetProjectionPlaneMode(VTK_SET_TRANSFORM_PLANE);
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(points));
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("Transform, but none is set"), std::string::npos);
}

TEST(Projection, WhatTheTransformLosesIsRejected)
{
  std::vector<Xyz> points = scatteredPoints(50);
  for (Xyz& p : points)
  {
    p[2] = 1.0;
  }
  const std::vector<Triangle> expected = triangulate(points);
  points.push_back({ 0.5, 0.5, 0.0 }); // divided by 0
  vtkNew<vtkPerspectiveTransform> transform;
  vtkNew<vtkMatrix4x4> matrix; // divides by z
  matrix->SetElement(3, 2, 1.0);
  matrix->SetElement(3, 3, 0.0);
  transform->SetMatrix(matrix);
  WatchedFilter filter;
  filter->SetInputData(makeCloud(points));
  filter->SetTransform(transform);
  filter->SetRimToConvexHull();
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), expected);
  EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 1);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("the first is point 50"), std::string::npos)
    << filter.Said->Warnings[0];
}

TEST(Projection, NoPointsNoPlane)
{
  WatchedFilter filter;
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->BoundingTriangulationOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(Projection, MemoryIsEstimatedWithTheCopy)
{
  auto cloud = makeCloud(scatteredPoints(10000));
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->Update();
  const vtkTypeInt64 before = filter->GetMemoryEstimate();
  filter->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->Update();
  EXPECT_GE(filter->GetMemoryEstimate(), before + 24 * 10000 / 1024);
  EXPECT_LE(filter->GetMemoryEstimate(), before + 60 * 10000 / 1024);
}
