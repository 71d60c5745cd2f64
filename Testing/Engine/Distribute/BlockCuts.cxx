// SPDX-License-Identifier: BSD-3-Clause
//
// The owner of a point (Distribute/BlockCuts.h): about as many for each block, coincident points
// together, each block in a box of its own.
#include "Distribute/BlockCuts.h"
#include "EngineRun.h"
#include "Listeners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

BlockCuts cutsOf(const std::vector<Point>& samples, std::size_t blocks)
{
  BlockCuts cuts;
  EXPECT_EQ(cutIntoBlocks(samples, blocks, Context(), cuts), Status::Ok);
  EXPECT_EQ(cuts.blocks(), blocks);
  return cuts;
}

std::vector<std::size_t> sharesOf(
  const BlockCuts& cuts, const std::vector<Point>& points, std::vector<Bounds>& bounds)
{
  std::vector<std::size_t> shares(cuts.blocks());
  bounds.assign(cuts.blocks(), Bounds());
  for (const Point& p : points)
  {
    const std::size_t owner = cuts.ownerOf(p);
    Bounds& b = bounds.at(owner);
    b = shares[owner]++ == 0 ? Bounds{ p.x, p.x, p.y, p.y }
                             : Bounds{ std::min(b.xmin, p.x), std::max(b.xmax, p.x),
                                 std::min(b.ymin, p.y), std::max(b.ymax, p.y) };
  }
  return shares;
}

TEST(BlockCuts, EachBlockHasItsShare)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Mixed, Distribution::Spiral,
         Distribution::KuzminDisc, Distribution::Collinear, Distribution::Huge })
  {
    const std::vector<Point> points = makePoints(d, 20000, 1);
    for (const std::size_t blocks : { 1, 2, 3, 10, 64 })
    {
      std::vector<Point> samples;
      ASSERT_EQ(samplePoints(viewOf(points), 512 * blocks, samples), Status::Ok);
      std::vector<Bounds> bounds;
      const std::vector<std::size_t> shares = sharesOf(cutsOf(samples, blocks), points, bounds);
      const double fair = double(points.size()) / double(blocks);
      EXPECT_GT(double(*std::min_element(shares.begin(), shares.end())), 0.7 * fair) << nameOf(d);
      EXPECT_LT(double(*std::max_element(shares.begin(), shares.end())), 1.4 * fair) << nameOf(d);
    }
  }
}

TEST(BlockCuts, NoTwoBoundsOverlap)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::RepeatedDraws,
         Distribution::Lattice, Distribution::TinyAndHuge })
  {
    const std::vector<Point> points = makePoints(d, 3000, 2);
    std::vector<Bounds> bounds;
    const std::vector<std::size_t> shares = sharesOf(cutsOf(points, 23), points, bounds);
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
      for (std::size_t k = i + 1; k < bounds.size(); ++k)
      {
        const Bounds &a = bounds[i], &b = bounds[k];
        EXPECT_TRUE(shares[i] == 0 || shares[k] == 0 || a.xmax < b.xmin || b.xmax < a.xmin ||
          a.ymax < b.ymin || b.ymax < a.ymin)
          << nameOf(d);
      }
    }
  }
}

TEST(BlockCuts, OneGoesByPlaceAlone)
{
  const BlockCuts cuts = cutsOf(makePoints(Distribution::Lattice, 400, 1), 9);
  EXPECT_EQ(cuts.ownerOf({ 0.0, -0.0 }), cuts.ownerOf({ -0.0, 0.0 }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_LT(cuts.ownerOf({ nan, nan }), 9u);
  EXPECT_EQ(BlockCuts().ownerOf({ 1.0, 2.0 }), 0u);
  EXPECT_EQ(BlockCuts().blocks(), 1u);
}

TEST(BlockCuts, SamplesAtOnePlaceAndNone)
{
  const std::vector<Point> same(50, Point{ 3.0, 4.0 });
  std::vector<Bounds> bounds;
  const std::vector<std::size_t> shares = sharesOf(cutsOf(same, 7), same, bounds);
  EXPECT_EQ(std::count(shares.begin(), shares.end(), 50u), 1);
  EXPECT_LT(cutsOf({}, 7).ownerOf({ 1.0, 2.0 }), 7u);
}

TEST(BlockCuts, SamplesAreFiniteAndNotSkipped)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, 100, 1);
  points[7].x = std::numeric_limits<double>::infinity();
  std::vector<unsigned char> skip(100, 0);
  skip[8] = 1;
  PointView view = viewOf(points);
  view.skip = skip.data();
  std::vector<Point> samples;
  ASSERT_EQ(samplePoints(view, 1000, samples), Status::Ok);
  EXPECT_EQ(samples.size(), 98u);
  ASSERT_EQ(samplePoints(view, 10, samples), Status::Ok);
  ASSERT_EQ(samples.size(), 10u);
  for (std::size_t k = 0; k < 10; ++k)
  {
    EXPECT_EQ(samples[k], points[10 * k]);
  }
}

TEST(BlockCuts, AnyAskingCanCancel)
{
  const std::vector<Point> samples = makePoints(Distribution::Uniform, 40000, 1);
  Listener listener;
  BlockCuts cuts;
  ASSERT_EQ(cutIntoBlocks(samples, 50, { &listener, nullptr }, cuts), Status::Ok);
  ASSERT_GE(listener.askings(), 40000u / kStepsPerAsking);
  for (std::size_t at = 1; at <= listener.askings(); ++at)
  {
    Listener cancelling(at);
    EXPECT_EQ(cutIntoBlocks(samples, 50, { &cancelling, nullptr }, cuts), Status::Cancelled);
  }
}

} // namespace
} // namespace test
} // namespace ahd
