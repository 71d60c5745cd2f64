// SPDX-License-Identifier: BSD-3-Clause
//
// The best fitting plane of points that have none, or many, or are not all to be used.
#include "PlaneTestSupport.h"

#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace planetest;

namespace
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}

TEST(Plane, PointsWithoutAPlaneHaveOne)
{
  EXPECT_EQ(fit({}).GetNormal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit({ { { 1, 2, 3 } } }).GetNormal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit(std::vector<Xyz>(9, { { 0.1, 0.2, 0.3 } })).GetNormal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit(std::vector<Xyz>(9, { { 0.1, 0.2, 0.3 } })).Project({ { 0.1, 0.2, 0.3 } }),
    (Xyz{ { 0, 0, 0 } }));
}

TEST(Plane, PointsOnALineHaveThePlaneClosestToZ)
{
  Maker maker(8);
  for (int i = 0; i < 1000; ++i)
  {
    const Xyz at = i % 2 ? Xyz{ { 500000.1, 6000000.7, 12.3 } } : Xyz{ { 0, 0, 0 } };
    Xyz along;
    do
    {
      along = maker.Vector(3);
    } while (length(along) == 0);
    std::vector<Xyz> points;
    for (int j = -20; j < 20; ++j)
    {
      const double t = j / 7.0; // rounded, so the points are next to the line, not on it
      points.push_back({ { at[0] + t * along[0], at[1] + t * along[1], at[2] + t * along[2] } });
    }
    const bool isSteep = std::fabs(along[2]) > std::max(std::fabs(along[0]), std::fabs(along[1]));
    const double norm = length(along);
    const Xyz unit = { { along[0] / norm, along[1] / norm, along[2] / norm } };
    const Xyz expected = vtkAHDPerpendicular(vtkAHDUnitAxis(isSteep ? 1 : 2), unit);
    const vtkAHDPlane plane = fit(points);
    expectFrame(plane);
    EXPECT_LT(sineBetween(plane.GetNormal(), expected), 1e-8);
    ASSERT_FALSE(HasFailure()) << "line " << i;
  }
}

TEST(Plane, ThinBandsHaveTheirOwnPlane)
{
  // A band a millionth as wide as long and a thousandth of that thick, at 45 degrees; the numbers
  // are multiples of powers of two, so they are what they seem.
  Maker maker(9);
  std::vector<Xyz> points;
  for (int i = 0; i < 2000; ++i)
  {
    const double along = maker.Whole(1 << 20) * 0x1p-20;
    const double wide = maker.Whole(1 << 10) * 0x1p-30;
    const double thick = maker.Whole(1) * 0x1p-40;
    // the band's own system is (1, 1, 0), (1, -1, 0) / sqrt(2), z
    points.push_back({ { along + wide, along - wide, thick } });
  }
  EXPECT_LT(sineBetween(fit(points).GetNormal(), { { 0, 0, 1 } }), 1e-4);
  for (Xyz& p : points)
  {
    p = { { p[0], p[2], p[1] } };
  }
  EXPECT_LT(sineBetween(fit(points).GetNormal(), { { 0, 1, 0 } }), 1e-4);
  for (Xyz& p : points)
  {
    // turned about the band's length: width and thickness share the sums' small digits
    p = { { p[0] + p[1], p[0] - p[1], p[2] * 2 } };
  }
  EXPECT_LT(fit(points).Project(points[0])[2], 0x1p-20);
}

TEST(Plane, PointsThatAreLeftOutDoNotCount)
{
  const std::vector<Xyz> square = { { { 0, 0, 0 } }, { { 1, 0, 1 } }, { { 0, 1, 0 } },
    { { 1, 1, 1 } } };
  const vtkAHDPlane expected = fit(square);
  std::vector<Xyz> more = square;
  more.push_back({ { kNaN, 7, 5 } });
  more.push_back({ { 8, 7, kInfinity } });
  more.push_back({ { 8, -kInfinity, 3 } });
  expectSame(fit(more), expected);

  more = square;
  more.push_back({ { 4, 3, 100 } });
  const std::vector<unsigned char> marks = { 0, 0, 0, 0, 3 };
  ahd::PointView view(more[0].data(), more.size(), 3);
  view.skip = marks.data();
  view.skipMask = 2;
  vtkNew<vtkAlgorithm> filter;
  vtkAHDProgress progress(filter);
  vtkAHDExecutor executor(1);
  vtkAHDPlane plane;
  ASSERT_TRUE(plane.Fit(view, executor, progress));
  expectSame(plane, expected);
}

TEST(Plane, FloatsAreFittedAsTheyAre)
{
  Maker maker(10);
  std::vector<Xyz> points(200);
  std::vector<float> floats;
  for (Xyz& p : points)
  {
    for (double& x : p)
    {
      floats.push_back(float(maker.Fraction()));
      x = floats.back();
    }
  }
  vtkNew<vtkAlgorithm> filter;
  vtkAHDProgress progress(filter);
  vtkAHDExecutor executor(1);
  vtkAHDPlane plane;
  ASSERT_TRUE(plane.Fit(ahd::PointView(floats.data(), 200, 3), executor, progress));
  expectSame(plane, fit(points));
}

TEST(Plane, AnAbortIsHeard)
{
  vtkNew<vtkAlgorithm> filter;
  filter->SetAbortExecute(1);
  vtkAHDProgress progress(filter);
  vtkAHDExecutor executor(1);
  const std::vector<Xyz> points(10, { { 1, 2, 3 } });
  vtkAHDPlane plane;
  EXPECT_FALSE(plane.Fit(ahd::PointView(points[0].data(), 10, 3), executor, progress));
}

TEST(Plane, TheTransformIsThePlane)
{
  Maker maker(11);
  for (int i = 0; i < 300; ++i)
  {
    Xyz normal;
    const std::vector<Xyz> points = maker.Plane({ { 5000, -6000, 7 } }, normal);
    const vtkAHDPlane plane = fit(points);
    const vtkSmartPointer<vtkTransform> transform = plane.MakeTransform();
    for (const Xyz& p : points)
    {
      Xyz q;
      transform->TransformPoint(p.data(), q.data());
      const Xyz expected = plane.Project(p);
      for (std::size_t k = 0; k < 3; ++k)
      {
        ASSERT_NEAR(q[k], expected[k], 1e-10) << "plane " << i;
      }
    }
  }
}
