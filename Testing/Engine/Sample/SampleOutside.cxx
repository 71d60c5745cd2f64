// SPDX-License-Identifier: BSD-3-Clause
//
// Places outside of the surface get the values of the nearest vertex: all of them and no others, in
// blocks, with threads; cancelled, and without memory. This program's operator new counts. What is
// asked about a rim is little, by counting polls.
#include "Executors.h"
#include "Listeners.h"
#include "OwnMemory.h"
#include "SampleCase.h"

#include "Sample/Outside.h"

namespace ahd
{
namespace test
{
namespace
{

/// A surface with a hole, sampled and filled.
struct Filled
{
  explicit Filled(SampleMethod method = SampleMethod::Linear)
    : given(nestedLoops(6))
  {
    given.prepare(method);
    EXPECT_EQ(nearest.prepare(given.engine.made, nullptr, SampleMethod::Nearest, {}), Status::Ok);
    for (const Point& p : given.points)
    {
      values.insert(values.end(), { p.x * p.y, -p.x });
    }
    for (const Point& p : given.points)
    {
      low = { std::min(low.x, p.x), std::min(low.y, p.y) };
      high = { std::max(high.x, p.x), std::max(high.y, p.y) };
    }
  }

  /// So many rows and columns, as wide as the surface on each side of it.
  SampleRaster around(std::size_t side) const
  {
    const Point size{ 3 * (high.x - low.x) / double(side), 3 * (high.y - low.y) / double(side) };
    return { { 2 * low.x - high.x, 2 * low.y - high.y }, size, side, side };
  }

  /// Values, two for each place, of the surface alone; their mask.
  void sampleAt(const SamplePlaces& places)
  {
    out.assign(2 * places.count(), -77.0);
    mask.assign(places.count(), 77);
    ASSERT_EQ(
      given.sampler.values(places, arrayOf(out).data(), 1, mask.data(), report, {}), Status::Ok);
  }

  std::vector<SampleArray> arrayOf(std::vector<double>& to) const
  {
    return { { values.data(), 2, to.data(), nullptr } };
  }

  Status fill(const SamplePlaces& places, const Context& context)
  {
    return fillOutside(nearest, places, arrayOf(out).data(), 1, mask.data(), context);
  }

  SampledCase given;
  Sampler nearest;
  std::vector<double> values, out;
  std::vector<unsigned char> mask;
  SampleReport report;
  Point low{ 1e300, 1e300 }, high{ -1e300, -1e300 };
};

/// More places than one block has; each is that of the surface or of the nearest vertex.
TEST(SampleOutside, ThreadsOrNoneFillAllPlacesOutsideAndNoOthers)
{
  ThreadExecutor threads(3);
  for (Executor* executor : { static_cast<Executor*>(nullptr), static_cast<Executor*>(&threads) })
  {
    Filled filled;
    const SampleRaster raster = filled.around(600); // a block has 2 to the 18th places
    const SamplePlaces places(raster);
    filled.sampleAt(places);
    const std::vector<double> before = filled.out;
    const std::vector<unsigned char> mask = filled.mask;
    std::vector<double> nearest(before.size());
    SampleReport report;
    ASSERT_EQ(filled.nearest.values(places, filled.arrayOf(nearest).data(), 1, nullptr, report, {}),
      Status::Ok);
    ASSERT_EQ(filled.fill(places, { nullptr, executor }), Status::Ok);
    EXPECT_EQ(filled.mask, mask);
    std::size_t outside = 0;
    for (std::size_t k = 0; k < places.count(); ++k)
    {
      outside += mask[k] == 0 ? 1 : 0;
      for (std::size_t c = 2 * k; c < 2 * k + 2; ++c)
      {
        ASSERT_EQ(filled.out[c], mask[k] == 0 ? nearest[c] : before[c]) << "place " << k;
      }
    }
    EXPECT_EQ(outside, filled.report.outside);
    EXPECT_GT(outside, places.count() / 2);
    EXPECT_GT(filled.report.valued, 100u);
  }
}

TEST(SampleOutside, PlacesThatAreNotFiniteStayWithoutValue)
{
  Filled filled;
  const std::vector<Point> where{ { kNotANumber, 0 }, { 1e9, 1e9 }, { 0, HUGE_VAL } };
  const SamplePlaces places(viewOf(where));
  filled.sampleAt(places);
  ASSERT_EQ(filled.fill(places, {}), Status::Ok);
  EXPECT_TRUE(std::isnan(filled.out[0]) && std::isnan(filled.out[4]));
  EXPECT_FALSE(std::isnan(filled.out[2]) || std::isnan(filled.out[3]));
  const SamplePlaces none(PointView(static_cast<const double*>(nullptr), 0, 2));
  EXPECT_EQ(filled.fill(none, {}), Status::Ok);
}

TEST(SampleOutside, AnyAskingCanCancel)
{
  Filled filled;
  const SampleRaster raster = filled.around(150);
  const SamplePlaces places(raster);
  filled.sampleAt(places);
  Listener all;
  ASSERT_EQ(filled.fill(places, { &all, nullptr }), Status::Ok);
  EXPECT_GE(all.askings(), 3 * places.count() / kStepsPerAsking);
  for (std::size_t k = 1; k <= all.askings(); ++k)
  {
    Listener listener(k);
    ASSERT_EQ(filled.fill(places, { &listener, nullptr }), Status::Cancelled);
    EXPECT_EQ(listener.askings(), k) << "nobody is asked again";
  }
}

TEST(SampleOutside, AnyAllocationCanFail)
{
  Filled filled;
  const SampleRaster raster = filled.around(20);
  const SamplePlaces places(raster);
  filled.sampleAt(places);
  const std::vector<SampleArray> arrays = filled.arrayOf(filled.out);
  std::size_t failed = 0;
  for (;; ++failed)
  {
    const std::size_t before = account.held;
    account.allocations = 0;
    account.failAt = failed + 1;
    const Status status = fillOutside(
      filled.nearest, places, arrays.data(), 1, filled.mask.data(), {});
    account.failAt = 0;
    EXPECT_EQ(account.held, before);
    if (status == Status::Ok)
    {
      break;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << failed + 1;
  }
  EXPECT_GT(failed, 4u);
}

TEST(SampleOutside, TheEstimateIsKept)
{
  Filled filled;
  for (const std::size_t side : { std::size_t(20), std::size_t(700) })
  {
    const SampleRaster raster = filled.around(side);
    const SamplePlaces places(raster);
    filled.sampleAt(places);
    filled.nearest = Sampler();
    const std::size_t before = account.held;
    account.peak = before;
    ASSERT_EQ(filled.nearest.prepare(filled.given.engine.made, nullptr, SampleMethod::Nearest, {}),
      Status::Ok);
    ASSERT_EQ(filled.fill(places, {}), Status::Ok);
    const std::size_t taken = account.peak - before;
    const std::size_t estimate = fillOutsideMemoryEstimate(filled.given.points.size(), places, 2);
    EXPECT_LE(taken, estimate) << side;
    EXPECT_LE(estimate, 2 * taken + 65536) << side;
  }
}

/// A quadrilateral, one corner of which may be far away, with a round hole.
ConstraintCase roundHole(double far, std::size_t count)
{
  ConstraintCase given;
  given.points = { { -3, -3 }, { far, -3 }, { 3, 3 }, { -3, 3 } };
  given.constraints.addLoop({ 0, 1, 2, 3 });
  std::vector<std::int64_t> hole;
  for (std::size_t k = 0; k < count; ++k)
  {
    const double angle = 2.0 * std::acos(-1.0) * double(k) / double(count);
    hole.push_back(std::int64_t(given.points.size()));
    given.points.push_back({ std::cos(angle), std::sin(angle) });
  }
  given.constraints.addLoop(hole);
  return given;
}

/// Polls of values at places in [-1, 1] x [-1, 1], of 8192 steps each.
std::size_t pollsOf(SampledCase& given, SampleMethod method, std::size_t count)
{
  given.prepare(method);
  Random random(9);
  std::vector<Point> places;
  for (std::size_t k = 0; k < count; ++k)
  {
    places.push_back({ 2.0 * random.unit() - 1.0, 2.0 * random.unit() - 1.0 });
  }
  Listener listener;
  const std::vector<double> values(given.points.size());
  EXPECT_EQ(sample(given.sampler, SamplePlaces(viewOf(places)), values, { &listener, nullptr })
              .report.places(),
    count);
  return listener.askings();
}

/// What is rounding for the edges of a point far away is not for all others.
TEST(SampleOutside, APointFarAwayMakesNoOtherPlacesSlow)
{
  for (const double far : { 3.0, 1e13, 1e18 })
  {
    SampledCase given(roundHole(far, 2000));
    EXPECT_LT(pollsOf(given, SampleMethod::Linear, 1000), 400u) << far;
  }
}

/// Boxes around long edges hold many cells, few of which are near.
TEST(SampleOutside, CellsBesideALongEdgeTakeNoLonger)
{
  SampledCase given({ { 0, 0 }, { 1, 0 }, { 0, 1 } });
  given.prepare(SampleMethod::Linear);
  const SampleRaster raster{ { 0.0, 0.0 }, { 0x1p-9, 0x1p-9 }, 512, 512, 0, 0 };
  Listener listener;
  const SampledValues found = sample(
    given.sampler, SamplePlaces(raster), { 1.0, 2.0, 3.0 }, { &listener, nullptr });
  EXPECT_EQ(found.report.valued, 512u * 513u / 2u + 511u);
  EXPECT_LT(listener.askings(), 150u);
}

/// Of the vertices that walls hide not all are asked about, nor are all walls.
TEST(SampleOutside, AStarOfWalls)
{
  SampledCase given(starPolygon(4000));
  EXPECT_LT(pollsOf(given, SampleMethod::Nearest, 200), 400u);
}

} // namespace
} // namespace test
} // namespace ahd
