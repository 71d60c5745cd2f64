// SPDX-License-Identifier: BSD-3-Clause
//
// Points moved into a plane by any transform.
#include "ContextSupport.h"
#include "Input/vtkAHDProjection.h"

#include "vtkAlgorithm.h"
#include "vtkCylindricalTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPerspectiveTransform.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace ahdtest;

namespace
{
/// More than two of the pieces in which points are worked on, and the last one not full.
constexpr std::size_t kCount = 40000;

std::vector<double> randomNumbers(std::size_t count)
{
  std::mt19937 random(1); // its sequence is fixed by the standard
  std::vector<double> numbers(count);
  for (double& x : numbers)
  {
    x = double(random()) * 0x1p-32 * 100 + 6000000.0;
  }
  return numbers;
}

/// vtkAHDProjection::project(). False if the filter is aborted.
bool project(
  const ahd::PointView& points, vtkAbstractTransform* transform, double* to, const Work& work)
{
  vtkAHDProjection projection(transform);
  projection.SetContext(work.Context);
  return projection.project(points, to, work.Context);
}

void expectTransformed(vtkAbstractTransform* transform)
{
  const std::vector<double> from = randomNumbers(3 * kCount);
  const vtkMTimeType before = transform->GetMTime();
  Work work;
  std::vector<double> to(3 * kCount);
  ASSERT_TRUE(project(ahd::PointView(from.data(), kCount, 3), transform, to.data(), work));
  EXPECT_EQ(transform->GetMTime(), before);
  for (std::size_t i = 0; i < kCount; ++i)
  {
    double expected[3];
    transform->TransformPoint(from.data() + 3 * i, expected);
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_EQ(to[3 * i + k], expected[k]) << "point " << i;
    }
  }
  std::vector<double> same = from; // written where they are read
  ASSERT_TRUE(project(ahd::PointView(same.data(), kCount, 3), transform, same.data(), work));
  EXPECT_EQ(same, to);
}
}

TEST(Transform, LinearOnes)
{
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(33, 1, 2, 3);
  transform->Translate(1, 2, 3);
  expectTransformed(transform);
}

TEST(Transform, PerspectiveOnes)
{
  vtkNew<vtkPerspectiveTransform> transform;
  transform->Perspective(30, 1.5, 1, 100);
  expectTransformed(transform);
}

TEST(Transform, AnyOthers)
{
  vtkNew<vtkCylindricalTransform> transform;
  expectTransformed(transform);
}

TEST(Transform, ChangesOfItsInputAreSeen)
{
  vtkNew<vtkTransform> inner;
  vtkNew<vtkTransform> outer;
  outer->SetInput(inner);
  inner->Translate(1, 0, 0);
  const double from[3] = { 5, 6, 7 };
  double to[3];
  Work work;
  ASSERT_TRUE(project(ahd::PointView(from, 1, 3), outer, to, work));
  EXPECT_EQ(to[0], 6);
  inner->Translate(1, 0, 0);
  ASSERT_TRUE(project(ahd::PointView(from, 1, 3), outer, to, work));
  EXPECT_EQ(to[0], 7);
}

TEST(Transform, FloatsAreWidened)
{
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(33, 1, 2, 3);
  const float from[3] = { 0.1f, 0.2f, 0.3f };
  const double wide[3] = { from[0], from[1], from[2] };
  double to[3], expected[3];
  Work work;
  ASSERT_TRUE(project(ahd::PointView(from, 1, 3), transform, to, work));
  transform->TransformPoint(wide, expected);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(to[k], expected[k]);
  }
}

TEST(Transform, PointsThatAreNotFiniteStaySo)
{
  // everything to the origin: 0 times infinity is NaN, but a transform need not multiply
  vtkNew<vtkCylindricalTransform> transform;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double from[9] = { nan, 1, 2, 1, 2, std::numeric_limits<double>::infinity(), 1, 2, 3 };
  double to[9];
  Work work;
  ASSERT_TRUE(project(ahd::PointView(from, 3, 3), transform, to, work));
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_TRUE(std::isnan(to[k])) << "number " << k;
  }
  EXPECT_TRUE(std::isfinite(to[6] + to[7] + to[8]));
}

TEST(Transform, WhatHasNoPlaceIsNotFinite)
{
  vtkNew<vtkPerspectiveTransform> transform;
  vtkNew<vtkMatrix4x4> matrix; // divides by z
  matrix->SetElement(3, 2, 1.0);
  matrix->SetElement(3, 3, 0.0);
  transform->SetMatrix(matrix);
  const double from[6] = { 1, 1, 0, 1, 1, 2 };
  double to[6];
  Work work;
  ASSERT_TRUE(project(ahd::PointView(from, 2, 3), transform, to, work));
  EXPECT_FALSE(std::isfinite(to[0]));
  EXPECT_EQ(to[3], 0.5);
}

TEST(Transform, APlanesTransformLaysPointsAsThePlane)
{
  std::vector<double> from = randomNumbers(3 * kCount);
  for (double& x : from)
  {
    x -= 6000000.0; // near the origin, where a matrix rounds as little as the plane
  }
  Work work;
  const ahd::PointView points(from.data(), kCount, 3);
  ahd::Plane plane;
  ASSERT_EQ(plane.fit(points, work.Context), ahd::Status::Ok);
  const auto transform = vtkAHDMakeTransform(plane);
  for (std::size_t i = 0; i < kCount; ++i)
  {
    const ahd::Vector3 p = plane.project({ { from[3 * i], from[3 * i + 1], from[3 * i + 2] } });
    double place[3];
    transform->TransformPoint(from.data() + 3 * i, place);
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_NEAR(place[k], p[k], 1e-12) << "point " << i;
    }
  }
}

TEST(Transform, AnAbortIsHeard)
{
  vtkNew<vtkCylindricalTransform> any;
  vtkNew<vtkTransform> linear;
  const double from[3] = { 1, 2, 3 };
  double to[3];
  Work work;
  work.Filter->SetAbortExecute(1);
  const ahd::PointView points(from, 1, 3);
  EXPECT_FALSE(project(points, any, to, work));
  EXPECT_FALSE(project(points, linear, to, work));
}
