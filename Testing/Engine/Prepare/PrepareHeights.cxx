// SPDX-License-Identifier: BSD-3-Clause
//
// Points of the source moved to the surface of the input.
#include "PrepareCase.h"

#include "Executors.h"
#include "Listeners.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

PreparedInput laid(PrepareCase& given)
{
  given.request.heights = SourceHeights::FromSurface;
  PreparedInput out;
  EXPECT_EQ(prepare(given.request, Context(), out), Status::Ok);
  return out;
}

/// Of the point of the source.
double heightOf(const PreparedInput& prepared, std::size_t i)
{
  return prepared.place(prepared.inputCount() + i)[2];
}

/// A roof over a square: 0 at the corners (0, 0) and (8, 8), 8 at the other two.
const std::vector<Xyz> kRoof = { { { 0, 0, 0 } }, { { 8, 0, 8 } }, { { 8, 8, 0 } }, { { 0, 8, 8 } },
  { { 4, 4, 0 } } };

TEST(PrepareHeights, KeepTheirOwnUnlessAskedFor)
{
  PrepareCase given(kRoof, { { { 1, 1, 7 } } });
  PreparedInput out;
  ASSERT_EQ(prepare(given.request, Context(), out), Status::Ok);
  EXPECT_EQ(heightOf(out, 0), 7.0);
  EXPECT_TRUE(out.surfacePlaces().empty());
}

TEST(PrepareHeights, AreInterpolated)
{
  PrepareCase given(kRoof,
    { { { 8, 0, -1 } }, { { 4, 4, -1 } }, { { 4, 0, -1 } }, { { 6, 2, -1 } }, { { 4, 1, -1 } },
      { { 9, 4, -1 } }, { { kNaN, 4, -1 } }, { { 1, 1, kNaN } } });
  const PreparedInput out = laid(given);
  EXPECT_EQ(heightOf(out, 0), 8.0) << "at a vertex";
  EXPECT_EQ(heightOf(out, 1), 0.0) << "at a vertex";
  EXPECT_EQ(heightOf(out, 2), 4.0) << "on an edge of the hull";
  EXPECT_EQ(heightOf(out, 3), 4.0) << "on an edge";
  EXPECT_EQ(heightOf(out, 4), 3.0) << "in a triangle";
  EXPECT_EQ(heightOf(out, 5), -1.0) << "outside";
  EXPECT_EQ(heightOf(out, 6), -1.0) << "nowhere";
  EXPECT_EQ(heightOf(out, 7), 0.0) << "its own is no number";
  EXPECT_EQ(out.outsideCount(), 2u);
  ASSERT_EQ(out.surfacePlaces().size(), 8u);
  EXPECT_FALSE(out.surfacePlaces()[5].isInside());
  EXPECT_EQ(interpolate(out.surfacePlaces()[4], [](Index id) { return kRoof[id][0]; }), 4.0);
  for (std::size_t i = 0; i < kRoof.size(); ++i)
  {
    EXPECT_EQ(out.place(i), kRoof[i]) << "the input's stay";
  }
}

TEST(PrepareHeights, WithoutATriangleAllKeepTheirOwn)
{
  for (const std::size_t count : { 0, 2 })
  {
    PrepareCase given(
      { kRoof.begin(), kRoof.begin() + std::ptrdiff_t(count) }, { { { 0, 0, 7 } } });
    const PreparedInput out = laid(given);
    EXPECT_EQ(heightOf(out, 0), 7.0);
    EXPECT_EQ(out.outsideCount(), 1u);
  }
}

TEST(PrepareHeights, WhatHasNoWeightHasNoSay)
{
  std::vector<Xyz> roof = kRoof;
  roof[2][2] = kNaN;
  PrepareCase given(roof, { { { 4, 0, -1 } }, { { 8, 0, -1 } }, { { 5, 4, -1 } } });
  const PreparedInput out = laid(given);
  EXPECT_EQ(heightOf(out, 0), 4.0);
  EXPECT_EQ(heightOf(out, 1), 8.0);
  EXPECT_TRUE(std::isnan(heightOf(out, 2))) << "between corners of which one has no height";
}

TEST(PrepareHeights, PointsThatAreLeftOutAreNotPartOfTheSurface)
{
  const std::vector<unsigned char> marks = { 0, 0, 0, 0, 1 };
  PrepareCase given(kRoof, { { { 4, 4, -1 } } });
  given.request.points.skip = marks.data();
  given.request.points.skipMask = 1;
  const double height = heightOf(laid(given), 0);
  EXPECT_TRUE(height == 0.0 || height == 8.0) << "the diagonal taken is the set's: " << height;
}

TEST(PrepareHeights, OfPointsAtOnePlaceTheRepresentativesCounts)
{
  std::vector<Xyz> roof = kRoof;
  roof.push_back({ { 4, 4, -3 } });
  roof.push_back({ { 4, 4, 9 } });
  PrepareCase given(roof, { { { 4, 4, 1 } } });
  EXPECT_EQ(heightOf(laid(given), 0), 0.0);
  given.request.representative = Representative::LowestZ;
  EXPECT_EQ(heightOf(laid(given), 0), -3.0);
  given.request.representative = Representative::HighestZ;
  EXPECT_EQ(heightOf(laid(given), 0), 9.0);
  given.request.representative = Representative::FirstId;
  given.request.meanHeights = true;
  EXPECT_EQ(heightOf(laid(given), 0), 2.0);
}

TEST(PrepareHeights, InThePlaneOfAProjectionTheHeightIsAboveIt)
{
  class Swapped : public Projection // a wall along x and z
  {
  public:
    bool project(const PointView& points, double* to, const Context&) const override
    {
      for (std::size_t i = 0; i < points.count; ++i)
      {
        std::swap(to[3 * i + 1], to[3 * i + 2]);
      }
      return true;
    }
  } projection;
  std::vector<Xyz> wall = kRoof;
  for (Xyz& p : wall)
  {
    std::swap(p[1], p[2]);
  }
  PrepareCase given(wall, { { { 4, 77, 1 } } });
  given.request.projection = &projection;
  EXPECT_EQ(heightOf(laid(given), 0), 3.0);
}

TEST(PrepareHeights, CrossingsLieBetweenTheNewHeights)
{
  PrepareCase given(kRoof,
    { { { 3, 1, -9 } }, { { 5, 1, -9 } }, { { 4, 0.5, -9 } }, { { 4, 1.5, -9 } } },
    { { 0, 1 }, { 2, 3 } });
  given.request.split = true;
  const PreparedInput out = laid(given);
  ASSERT_EQ(out.crossings().size(), 1u);
  EXPECT_EQ(out.place(out.firstCrossing())[2], 3.0) << "the roof's slope is even there";
}

TEST(PrepareHeights, EveryPlaceIsOnAPlaneThatTheInputLiesOn)
{
  for (const double scale : { 1.0, 1e-300, 1e300 })
  {
    SCOPED_TRACE(scale);
    std::vector<Xyz> input = oddPoints(2000, 5), source = oddPoints(500, 6);
    for (auto* points : { &input, &source })
    {
      for (Xyz& p : *points)
      {
        p[2] = 3 * p[0] - 2 * p[1] + 1;
        p[0] *= scale;
        p[1] *= scale;
      }
    }
    PrepareCase given(input, source);
    const PreparedInput out = laid(given);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < source.size(); ++i)
    {
      if (out.surfacePlaces()[i].isInside() && std::isfinite(source[i][2]))
      {
        ++inside;
        ASSERT_NEAR(heightOf(out, i), source[i][2], 1e-9) << i;
      }
    }
    EXPECT_GT(inside, 400u);
  }
}

/// `count` points in the corridor of a road, 10 points wide, and as many of a source on it.
void addRoad(std::size_t count, std::vector<Xyz>& input, std::vector<Xyz>& source)
{
  std::mt19937_64 random(3);
  const auto fraction = [&random] { return double(random() >> 11) * 0x1p-53; };
  for (std::size_t i = 0; i != count; ++i)
  {
    const double x = double(i / 10), y = double(i % 10);
    input.push_back({ { x + 0.1 * fraction(), y + 0.1 * fraction(), fraction() } });
    const double along = fraction() * double(count / 10), across = 9.0 * fraction();
    source.push_back({ { along, across, 0.0 } });
  }
}

TEST(PrepareHeights, TakeFewStepsInAnyOrder)
{
  const std::size_t count = 20000;
  for (const double far : { 0.0, 1e9 })
  {
    SCOPED_TRACE(far);
    std::vector<Xyz> input, source;
    addRoad(count, input, source);
    for (auto* points : { &input, &source })
    {
      points->push_back({ { far, far, 0.0 } });
      points->push_back({ { 0.5 * far, -far, 0.0 } });
    }
    PrepareCase given(input, source);
    given.request.heights = SourceHeights::FromSurface;
    Listener counter;
    PreparedInput out;
    ASSERT_EQ(prepare(given.request, Context{ &counter, nullptr }, out), Status::Ok);
    EXPECT_LE(double(counter.askings()) * double(kStepsPerAsking), 400.0 * double(count));
  }
}

TEST(PrepareHeights, ThreadsChangeNothing)
{
  PrepareCase given(oddPoints(40000, 7), oddPoints(30000, 8));
  const PreparedInput expected = laid(given);
  ThreadExecutor threads(4);
  PreparedInput out;
  ASSERT_EQ(prepare(given.request, Context{ nullptr, &threads }, out), Status::Ok);
  EXPECT_EQ(bytesOf(out), bytesOf(expected));
}

} // namespace
} // namespace test
} // namespace ahd
