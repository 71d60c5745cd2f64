// SPDX-License-Identifier: BSD-3-Clause
//
// The best-fitting plane of points that have none, or many, or do not all count.
#include "Core/Progress.h"
#include "PlaneMaker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Plane, PointsWithoutAPlaneHaveOne)
{
  EXPECT_EQ(fit({}).normal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit({ { { 1, 2, 3 } } }).normal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit(std::vector<Xyz>(9, { { 0.1, 0.2, 0.3 } })).normal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit(std::vector<Xyz>(9, { { 0.1, 0.2, 0.3 } })).project({ { 0.1, 0.2, 0.3 } }),
    (Xyz{ { 0.1, 0.2, 0 } }));
}

TEST(Plane, PointsWithACoordinateInCommonKeepTheOthers)
{
  Maker maker(11);
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (const double common : { 0.0, 0.1, -12.3, 6e6, 1e300 })
    {
      std::vector<Xyz> points(200);
      for (Xyz& p : points)
      {
        p = { { maker.fraction() * 1e-3, maker.fraction() + 5e5, maker.fraction() * 7 } };
        p[k] = common;
      }
      std::vector<Xyz> more = points; // of points that do not count
      more.push_back({ { 1, 2, 3 } });
      more.push_back({ { kNaN, 2, 3 } });
      std::vector<unsigned char> marks(more.size(), 0);
      marks[points.size()] = 1;
      PointView view(more[0].data(), more.size(), 3);
      view.skip = marks.data();
      Plane plane;
      ASSERT_EQ(plane.fit(view, Context()), Status::Ok);
      EXPECT_TRUE(plane.isOfCoordinates());
      EXPECT_EQ(plane.normal(), unitAxis(k));
      expectFrame(plane);
      for (const Xyz& p : points)
      {
        ASSERT_EQ(plane.project(p), (Xyz{ { p[(k + 1) % 3], p[(k + 2) % 3], 0 } })) << k;
      }
      points[0][k] = common == 0.0 ? 1e-9 : std::nextafter(common, 0.0);
      EXPECT_FALSE(fit(points).isOfCoordinates()) << common;
    }
  }
  // The y of a low wall far north are coarse; its z are not.
  std::vector<float> wall;
  for (int i = 0; i < 600; ++i)
  {
    wall.insert(wall.end(), { 5e5F, 6e6F + float(i / 3), 0.25F * float(i % 3) });
  }
  Plane low;
  ASSERT_EQ(low.fit(PointView(wall.data(), 600, 3), Context()), Status::Ok);
  EXPECT_TRUE(low.isOfCoordinates());
  EXPECT_EQ(low.normal(), unitAxis(0));
  // Many planes contain a line: the rule for lines chooses one.
  EXPECT_FALSE(fit({ { { 0, 1, 0 } }, { { 2, 1, 1 } }, { { 4, 1, 2 } } }).isOfCoordinates());
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
      along = maker.vector(3);
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
    const Xyz expected = perpendicular(unitAxis(isSteep ? 1 : 2), unit);
    const Plane plane = fit(points);
    expectFrame(plane);
    EXPECT_LT(sineBetween(plane.normal(), expected), 1e-8);
    ASSERT_FALSE(HasFailure()) << "line " << i;
  }
}

TEST(Plane, PointsThatLieApartHaveTheSamePlane)
{
  Maker maker(10);
  for (const std::size_t stride : { std::size_t(4), std::size_t(6) })
  {
    std::vector<Xyz> points;
    std::vector<double> apart;
    for (int i = 0; i < 101; ++i)
    {
      points.push_back(maker.vector(3));
      apart.insert(apart.end(), points.back().begin(), points.back().end());
      apart.resize(apart.size() + stride - 3, 1e9);
    }
    PointView view(apart.data(), points.size(), stride);
    Plane plane;
    ASSERT_EQ(plane.fit(view, Context()), Status::Ok);
    EXPECT_EQ(plane.normal(), fit(points).normal()) << stride;
    EXPECT_EQ(plane.project(points[0]), fit(points).project(points[0])) << stride;
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
    const double along = maker.whole(1 << 20) * 0x1p-20;
    const double wide = maker.whole(1 << 10) * 0x1p-30;
    const double thick = maker.whole(1) * 0x1p-40;
    // the band's own system is (1, 1, 0), (1, -1, 0) / sqrt(2), z
    points.push_back({ { along + wide, along - wide, thick } });
  }
  EXPECT_LT(sineBetween(fit(points).normal(), { { 0, 0, 1 } }), 1e-4);
  for (Xyz& p : points)
  {
    p = { { p[0], p[2], p[1] } };
  }
  EXPECT_LT(sineBetween(fit(points).normal(), { { 0, 1, 0 } }), 1e-4);
  for (Xyz& p : points)
  {
    // turned about the band's length: width and thickness share the sums' small digits
    p = { { p[0] + p[1], p[0] - p[1], p[2] * 2 } };
  }
  EXPECT_LT(fit(points).project(points[0])[2], 0x1p-20);
}

TEST(Plane, ThinBandsThatAreTurnedHaveTheirNormal)
{
  // Spanned by (1, 1, 1) and a billionth of (0, 1, 2), whole numbers of both.
  Maker maker(12);
  std::vector<Xyz> points;
  for (int i = 0; i < 500; ++i)
  {
    const double along = maker.whole(1 << 10), across = maker.whole(1 << 10) * 0x1p-30;
    points.push_back({ { along, along + across, along + 2 * across } });
  }
  EXPECT_LT(sineBetween(fit(points).normal(), { { 1, -2, 1 } }), 1e-14);
}

TEST(Plane, PointsThatAreLeftOutDoNotCount)
{
  const std::vector<Xyz> square = { { { 0, 0, 0 } }, { { 1, 0, 1 } }, { { 0, 1, 0 } },
    { { 1, 1, 1 } } };
  const Plane expected = fit(square);
  std::vector<Xyz> more = square;
  more.push_back({ { kNaN, 7, 5 } });
  more.push_back({ { 8, 7, kInfinity } });
  more.push_back({ { 8, -kInfinity, 3 } });
  expectSame(fit(more), expected);

  more = square;
  more.push_back({ { 4, 3, 100 } });
  const std::vector<unsigned char> marks = { 0, 0, 0, 0, 3 };
  PointView view(more[0].data(), more.size(), 3);
  view.skip = marks.data();
  view.skipMask = 2;
  Plane plane;
  ASSERT_EQ(plane.fit(view, Context()), Status::Ok);
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
      floats.push_back(float(maker.fraction()));
      x = floats.back();
    }
  }
  Plane plane;
  ASSERT_EQ(plane.fit(PointView(floats.data(), 200, 3), Context()), Status::Ok);
  expectSame(plane, fit(points));
}

TEST(Plane, AnAbortIsHeard)
{
  struct Refusal : Progress
  {
    bool advance(Phase, double) override { return false; }
  } refusal;
  Context context;
  context.progress = &refusal;
  const std::vector<Xyz> points(10, { { 1, 2, 3 } });
  Plane plane;
  EXPECT_EQ(plane.fit(viewOf(points), context), Status::Cancelled);
  EXPECT_EQ(plane.fit(PointView(points[0].data(), 0, 3), context), Status::Cancelled);
}

TEST(Plane, AnyNumberOfThreadsHearsAnAbort)
{
  struct Countdown : Progress
  {
    int left = 0;
    bool advance(Phase, double) override { return left-- > 0; }
  } countdown;
  const std::vector<Xyz> points(std::size_t(1) << 18, { { 1, 2, 3 } });
  ThreadExecutor executor(3);
  Context context{ &countdown, &executor };
  // The number of polls depends on the threads: at least one a pass.
  for (int asked = 0; asked < 6; ++asked)
  {
    countdown.left = asked;
    Plane plane;
    const Status status = plane.fit(viewOf(points), context);
    const bool wasRefused = countdown.left < 0;
    EXPECT_EQ(status, wasRefused ? Status::Cancelled : Status::Ok) << "asked " << asked;
    EXPECT_TRUE(wasRefused || asked >= 2) << "asked " << asked;
  }
}

} // namespace
} // namespace test
} // namespace ahd
