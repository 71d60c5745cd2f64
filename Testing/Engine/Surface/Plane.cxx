// SPDX-License-Identifier: BSD-3-Clause
//
// The best-fitting plane: its definition, that it depends on the points alone, and their places in
// it. Random planes are spanned by vectors of whole numbers, so the points lie in them exactly.
#include "PlaneMaker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

TEST(Plane, RandomPlanesAreFound)
{
  Maker maker(1);
  for (int i = 0; i < 5000; ++i)
  {
    const bool far = i % 2 == 1;
    const Xyz at = far ? Xyz{ { 500000.25, 6000000.5, -120.125 } } : maker.vector(100);
    Xyz normal;
    const std::vector<Xyz> points = maker.plane(at, normal);
    const Plane plane = fit(points);
    EXPECT_LT(sineBetween(plane.normal(), normal), 1e-13);
    expectFrame(plane);
    for (const Xyz& p : points)
    {
      EXPECT_NEAR(plane.project(p)[2], 0.0, 1e-11);
    }
    if (HasFailure())
    {
      FAIL() << "plane " << i << " of normal " << normal[0] << ", " << normal[1] << ", "
             << normal[2];
    }
  }
}

TEST(Plane, DistancesInThePlaneAreKept)
{
  Maker maker(2);
  for (int i = 0; i < 1000; ++i)
  {
    Xyz normal;
    const std::vector<Xyz> points = maker.plane({ { 500000, 6000000, 0 } }, normal);
    const Plane plane = fit(points);
    const Xyz first = plane.project(points[0]);
    for (const Xyz& p : points)
    {
      const Xyz q = plane.project(p);
      const double is = std::hypot(q[0] - first[0], q[1] - first[1]);
      const double was = length(
        { { p[0] - points[0][0], p[1] - points[0][1], p[2] - points[0][2] } });
      ASSERT_NEAR(is, was, 1e-11) << "plane " << i;
    }
  }
}

TEST(Plane, OnlyThePointsDecide)
{
  Maker maker(3);
  for (int i = 0; i < 500; ++i)
  {
    std::vector<Xyz> points(3 + std::size_t(i));
    for (Xyz& p : points)
    {
      const double x = maker.fraction();
      const double y = maker.fraction() * 1e5;
      p = { { x, y, maker.fraction() * 10 + 6e6 } };
    }
    const Plane before = fit(points);
    maker.shuffle(points);
    expectSame(fit(points), before);
    ASSERT_FALSE(HasFailure()) << i << " more than 3 points";
  }
}

TEST(Plane, ThreadsDoNotDecide)
{
  Maker maker(4);
  std::vector<Xyz> points(std::size_t(1) << 19); // enough to be shared
  for (Xyz& p : points)
  {
    const double x = maker.fraction();
    const double y = maker.fraction();
    p = { { x, y, x / 3 + y / 7 + maker.fraction() / 100 } };
  }
  const Plane before = fit(points);
  expectSame(fit(points, 4), before);
  maker.shuffle(points);
  expectSame(fit(points, 3), before);
}

TEST(Plane, ScaleChangesNothing)
{
  Maker maker(5);
  for (int i = 0; i < 300; ++i)
  {
    Xyz normal;
    const std::vector<Xyz> points = maker.plane(maker.vector(1000), normal);
    const Plane before = fit(points);
    for (int exponent : { -1060, -1000, -300, -1, 40, 300, 1000, 1009 })
    {
      std::vector<Xyz> scaled = points;
      for (Xyz& p : scaled)
      {
        for (double& x : p)
        {
          x = std::ldexp(x, exponent);
        }
      }
      const Plane plane = fit(scaled);
      EXPECT_EQ(plane.normal(), before.normal());
      EXPECT_EQ(plane.firstAxis(), before.firstAxis());
      const Xyz laid = before.project(points[1]);
      const Xyz laidScaled = plane.project(scaled[1]);
      for (std::size_t k = 0; k < 2; ++k)
      {
        const double expected = std::ldexp(laid[k], exponent);
        EXPECT_NEAR(laidScaled[k], expected, std::fabs(expected) * 1e-12 + 0x1p-1070);
      }
      ASSERT_FALSE(HasFailure()) << "plane " << i << " times 2^" << exponent;
    }
  }
}

TEST(Plane, TheLargestNumbersStayFinite)
{
  constexpr double most = std::numeric_limits<double>::max();
  const Plane plane = fit(
    { { { -most, 0, most } }, { { most, 0, most } }, { { 0, most / 2, most } } });
  EXPECT_EQ(plane.normal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(plane.project({ { -most, 0, most } })[0], -most);
  const Plane tilted = fit({ { { most, 0, most } }, { { -most, 0, -most } },
    { { most / 2, most, most / 2 } }, { { 0, -most, 0 } } });
  EXPECT_LT(sineBetween(tilted.normal(), { { -1, 0, 1 } }), 1e-15);
  EXPECT_TRUE(std::isfinite(tilted.project({ { most / 2, most, most / 2 } })[1]));
}

/// Of x + y + z = const: the plane, or the multiple of a power of two that is closest to the
/// points, is beyond the largest double.
TEST(Plane, TheFarthestPlanesHavePointsInThem)
{
  using Numbers = std::pair<double, double>;
  for (const auto& [far, apart] : { Numbers(0x1.8p1023, 0x1.fp1020),
         Numbers(0x1.f8p1023, 0x1.8p1017), Numbers(0x1.ep1023, 0x1p990) })
  {
    const Xyz at = { { far - apart, far + apart, far } };
    const Plane plane = fit({ at, { { far, far - apart, far + apart } },
      { { far + apart, far, far - apart } }, { { far, far, far } } });
    EXPECT_LT(sineBetween(plane.normal(), { { 1, 1, 1 } }), 1e-14) << apart;
    EXPECT_LT(std::fabs(plane.project(at)[2]), 1e-14 * far) << apart;
  }
}

TEST(Plane, NoOtherPlaneIsCloser)
{
  Maker maker(6);
  for (int i = 0; i < 300; ++i)
  {
    const Xyz stretch = { { 1 + 9 * maker.fraction(), 1 + 9 * maker.fraction(), 1.0 } };
    std::vector<Xyz> points(60);
    Xyz mean = { { 0, 0, 0 } };
    for (Xyz& p : points)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        p[k] = (maker.fraction() - 0.5) * stretch[(k + std::size_t(i)) % 3] + 1000.0;
        mean[k] += p[k] / 60;
      }
    }
    const auto squares = [&](const Xyz& n)
    {
      double sum = 0.0;
      for (const Xyz& p : points)
      {
        const double d = dot(n, { { p[0] - mean[0], p[1] - mean[1], p[2] - mean[2] } }) / length(n);
        sum += d * d;
      }
      return sum;
    };
    const Plane plane = fit(points);
    const double least = squares(plane.normal());
    double heights = 0.0;
    for (const Xyz& p : points)
    {
      heights += plane.project(p)[2];
    }
    EXPECT_NEAR(heights, 0.0, 1e-9);
    for (double turn : { 1e-4, 0.01, 0.3, 1.0, 10.0 })
    {
      Xyz other = plane.normal();
      const Xyz by = maker.vector(10);
      for (std::size_t k = 0; k < 3; ++k)
      {
        other[k] += turn * by[k] / 10;
      }
      EXPECT_GE(squares(other), least * (1 - 1e-9)) << "cloud " << i << " turned by " << turn;
    }
  }
}

TEST(Plane, PlanesAlongTwoAxesKeepEveryDigit)
{
  Maker maker(7);
  for (std::size_t across : { 0u, 1u, 2u })
  {
    for (const Xyz& at : { Xyz{ { 0, 0, 0 } }, Xyz{ { 500000.1, 6000000.1, 99.9 } } })
    {
      std::vector<Xyz> points(500);
      for (Xyz& p : points)
      {
        p = { { at[0] + 0.1 * maker.whole(300), at[1] + 0.1 * maker.whole(300),
          at[2] + 0.1 * maker.whole(300) } };
        p[across] = at[across];
      }
      const Plane plane = fit(points);
      EXPECT_EQ(plane.normal(), unitAxis(across));
      EXPECT_EQ(plane.firstAxis(), unitAxis(across + 1));
      EXPECT_EQ(plane.secondAxis(), unitAxis(across + 2));
      const Xyz origin = plane.project({ { 0, 0, 0 } });
      for (const Xyz& p : points)
      {
        const Xyz q = plane.project(p);
        // adding the origin back gives the coordinate: nothing was rounded away
        EXPECT_EQ(q[0] - origin[0], p[(across + 1) % 3]);
        EXPECT_EQ(q[1] - origin[1], p[(across + 2) % 3]);
        EXPECT_EQ(q[2], 0.0);
      }
    }
  }
}

TEST(Plane, TheSideOfTiesIsDecided)
{
  // three points of x + y + z = 1, of y = x, of z = x, of z = -y: the last of the large components
  const double third = std::sqrt(1.0 / 3), half = std::sqrt(0.5);
  const auto expectNormal = [](const std::vector<Xyz>& points, const Xyz& expected)
  {
    const Xyz normal = fit(points).normal();
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(normal[k], expected[k], 1e-15) << "component " << k;
    }
  };
  expectNormal({ { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } }, { { third, third, third } });
  expectNormal(
    { { { 1, 0, 0 } }, { { 0, -1, 0 } }, { { 0, 0, -1 } } }, { { -third, third, third } });
  expectNormal({ { { 0, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 0, 1 } } }, { { -half, half, 0 } });
  expectNormal({ { { 0, 0, 0 } }, { { 1, 0, 1 } }, { { 0, 1, 0 } } }, { { -half, 0, half } });
  expectNormal({ { { 0, 0, 0 } }, { { 0, 1, -1 } }, { { 1, 0, 0 } } }, { { 0, half, half } });
}

} // namespace
} // namespace test
} // namespace ahd
