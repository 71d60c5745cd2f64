// SPDX-License-Identifier: BSD-3-Clause
//
// The plane of points that lie in several parts: bit for bit that of all points together.
#include "PlaneMaker.h"
#include "Surface/PlaneFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

/// Runs all parts to the end.
Plane fitParts(const std::vector<PointView>& parts, bool areDoubles)
{
  std::vector<std::unique_ptr<PlaneFitting>> fittings;
  for (const PointView& part : parts)
  {
    fittings.emplace_back(new PlaneFitting(part, areDoubles));
  }
  std::size_t steps = 0;
  while (!fittings[0]->isDone())
  {
    std::vector<std::vector<unsigned char>> all(parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      Ticker ticker(nullptr, Phase::Merge, 0);
      EXPECT_FALSE(fittings[k]->isDone());
      EXPECT_TRUE(fittings[k]->look(ticker));
      fittings[k]->tell(all[k]);
    }
    for (const auto& fitting : fittings)
    {
      fitting->hear(all);
    }
    EXPECT_LE(++steps, 3u);
  }
  Plane plane;
  for (const auto& fitting : fittings)
  {
    EXPECT_TRUE(fitting->isDone());
    EXPECT_EQ(fitting->fit().normal, fittings[0]->fit().normal);
    EXPECT_EQ(fitting->fit().isOfCoordinates, fittings[0]->fit().isOfCoordinates);
    plane.take(fitting->fit());
  }
  return plane;
}

void expectSame(const Plane& plane, const Plane& expected, const std::vector<Xyz>& points)
{
  EXPECT_EQ(plane.normal(), expected.normal());
  EXPECT_EQ(plane.firstAxis(), expected.firstAxis());
  EXPECT_EQ(plane.secondAxis(), expected.secondAxis());
  EXPECT_EQ(plane.stance().isWall, expected.stance().isWall);
  EXPECT_EQ(plane.stance().isSteep, expected.stance().isSteep);
  for (const Xyz& p : points)
  {
    ASSERT_EQ(plane.project(p), expected.project(p)); // no NaN among them
  }
}

/// Dealt out in turn; the last part gets none.
void compareParts(const std::vector<Xyz>& points, std::size_t count)
{
  std::vector<std::vector<Xyz>> dealt(count + 1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    dealt[i * 7 / 3 % count].push_back(points[i]);
  }
  std::vector<PointView> parts;
  for (const std::vector<Xyz>& part : dealt)
  {
    parts.push_back(viewOf(part));
  }
  expectSame(fitParts(parts, true), fit(points), points);
}

TEST(PlaneParts, GiveThePlaneOfAll)
{
  Maker maker(21);
  for (const Xyz& at :
    { Xyz{ { 0, 0, 0 } }, Xyz{ { 5e6, 5.8e6, 120 } }, Xyz{ { 1e300, 0, 1e-300 } } })
  {
    for (const double thick : { 1.0, 1e-3, 0.0 })
    {
      std::vector<Xyz> points;
      for (int i = 0; i < 1500; ++i)
      {
        const Xyz p = maker.vector(100);
        points.push_back(
          { { at[0] + p[0], at[1] + p[1] + p[0] / 3, at[2] + thick * p[2] + p[1] } });
      }
      for (const std::size_t count : { 1u, 2u, 5u, 40u })
      {
        compareParts(points, count);
      }
    }
  }
}

TEST(PlaneParts, OfFewPointsOrNone)
{
  for (std::size_t n = 0; n < 5; ++n)
  {
    std::vector<Xyz> points(n, { { 1, 2, 3 } });
    compareParts(points, 2);
    for (std::size_t i = 0; i < n; ++i)
    {
      points[i][0] += double(i);
    }
    compareParts(points, 3);
  }
}

/// Whole numbers of a plane, each moved by i vectors of it, times a power of two, plus an offset:
/// all exact, so the plane has the normal that it is made with.
struct Hard
{
  const char* name;
  double apart;
  int exponent;
  Xyz offset;
};

TEST(PlaneParts, OfHardPointsAreOnePlaneToo)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Maker maker(22);
  for (const Hard& hard : { Hard{ "huge offsets", 0, 0, { { 0x1p40, -0x1p41, 0x1p39 } } },
         Hard{ "large", 0, 990, { { 0, 0, 0 } } }, Hard{ "subnormal", 0, -1074, { { 0, 0, 0 } } },
         Hard{ "gaps", 0x1p20, 0, { { 0, 0, 0 } } }, Hard{ "tiny", 0, -600, { { 0, 0, 0 } } } })
  {
    SCOPED_TRACE(hard.name);
    for (int i = 0; i < 50; ++i)
    {
      Xyz normal;
      std::vector<Xyz> points = maker.plane({ { 0, 0, 0 } }, normal);
      const Xyz far = points[1];
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        for (std::size_t c = 0; c < 3; ++c)
        {
          const double moved = points[k][c] + (k % 3 == 0 ? hard.apart * far[c] : 0.0);
          points[k][c] = std::ldexp(moved, hard.exponent) + hard.offset[c];
        }
      }
      EXPECT_LT(sineBetween(fit(points).normal(), normal), 1e-13);
      const Plane before = fit(points);
      compareParts(points, 3);
      maker.shuffle(points);
      compareParts(points, 1);
      points.insert(points.begin() + 1, Xyz{ { kNaN, 0, 0 } });
      EXPECT_EQ(fit(points).normal(), before.normal());
    }
  }
}

/// Whether a line's width is but rounding depends on the precision of all parts.
TEST(PlaneParts, CountAsDoublesIfOneHasThese)
{
  std::vector<float> floats;
  std::vector<Xyz> doubles;
  for (int i = 0; i < 200; ++i)
  {
    const float t = float(i) / 7.0f;
    floats.insert(floats.end(), { 1000.0f + t, 1000.0f + 2 * t, float(i % 2) / 8192.0f });
    doubles.push_back({ { floats[floats.size() - 3], floats[floats.size() - 2], floats.back() } });
  }
  const PointView part(floats.data(), doubles.size(), 3);
  Plane ofFloats;
  EXPECT_EQ(ofFloats.fit(part, Context()), Status::Ok);
  expectSame(fitParts({ part, PointView() }, false), ofFloats, doubles);
  expectSame(fitParts({ part, PointView() }, true), fit(doubles), doubles);
  EXPECT_NE(ofFloats.normal(), fit(doubles).normal());
}

} // namespace
} // namespace test
} // namespace ahd
