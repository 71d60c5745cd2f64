// SPDX-License-Identifier: BSD-3-Clause
//
// A Sampler where it is cancelled, has no memory, or several threads; no more memory than
// estimated. This program's operator new counts, and fails on demand.
#include "Executors.h"
#include "Listeners.h"
#include "OwnMemory.h"
#include "Sample/BoxNeighbors.h"
#include "SampleCase.h"

#include <cstring>

namespace ahd
{
namespace test
{
namespace
{

const SampleMethod kMethods[] = { SampleMethod::Linear, SampleMethod::NaturalNeighbor,
  SampleMethod::Laplace, SampleMethod::Nearest };

std::vector<double> valuesFor(const std::vector<Point>& points)
{
  std::vector<double> values;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const Point p = points[k];
    values.push_back(k % 97 == 5 ? kNotANumber : std::sin(9 * p.x) * std::cos(7 * p.y));
  }
  return values;
}

/// Fewer rows under sanitizers.
std::size_t fewer(std::size_t rows)
{
  return reduced(20000) == 20000 ? rows : rows / 5;
}

Bounds boundsOf(const std::vector<Point>& points)
{
  Bounds b{ points[0].x, points[0].x, points[0].y, points[0].y };
  for (const Point& p : points)
  {
    b = { std::min(b.xmin, p.x), std::max(b.xmax, p.x), std::min(b.ymin, p.y),
      std::max(b.ymax, p.y) };
  }
  return b;
}

/// A raster that reaches beyond the unit square.
SampleRaster rasterOf(std::size_t columns, std::size_t rows)
{
  return { { -0.05, -0.03 }, { 1.1 / double(columns), 1.06 / double(rows) }, columns, rows };
}

/// The same bytes from one thread and several, on a raster and at its places in another order.
TEST(SampleTrouble, ThreadsAndOtherPlacesHaveNoSay)
{
  ThreadExecutor threads(3);
  SampledCase given(makePoints(Distribution::Uniform, reduced(20000), 1));
  SampledCase holes(nestedLoops(30));
  for (SampledCase* made : { &given, &holes })
  {
    const Bounds b = boundsOf(made->points);
    SampleRaster raster = rasterOf(290, fewer(300));
    raster.spacing = { raster.spacing.x * (b.xmax - b.xmin), raster.spacing.y * (b.ymax - b.ymin) };
    const std::vector<double> values = valuesFor(made->points);
    for (const SampleMethod method : kMethods)
    {
      SCOPED_TRACE(int(method));
      made->prepare(method);
      const bool slopes = method == SampleMethod::Linear;
      const SampledValues alone = sample(
        made->sampler, SamplePlaces(raster), values, Context(), slopes);
      Listener listener;
      EXPECT_TRUE(areSame(alone,
        sample(made->sampler, SamplePlaces(raster), values, { &listener, &threads }, slopes)));
      const std::vector<Point> places = pointsOf(raster);
      EXPECT_TRUE(areSame(
        alone, sample(made->sampler, SamplePlaces(viewOf(places)), values, Context(), slopes)));
      EXPECT_TRUE(areSame(alone,
        sample(
          made->sampler, SamplePlaces(viewOf(places)), values, { nullptr, &threads }, slopes)));
      EXPECT_GT(alone.report.valued, 1000u);
      EXPECT_GT(alone.report.outside + (method == SampleMethod::Nearest), 0u);
    }
  }
}

/// Prepares and samples anew; `call` wraps it.
Status sampleAnew(SampledCase& given, SampleMethod method, const SamplePlaces& places,
  const std::vector<double>& values, const Context& context)
{
  const Status status = given.sampler.prepare(given.engine.made, nullptr, method, context);
  if (status != Status::Ok)
  {
    return status;
  }
  SampleWeights weights;
  SampleReport report;
  const Status weighed = given.sampler.weights(places, weights, report, context);
  return weighed != Status::Ok ? weighed : sample(given.sampler, places, values, context).status;
}

TEST(SampleTrouble, AnyAskingCanCancelAlsoWithThreads)
{
  ThreadExecutor threads(3);
  const SampleRaster raster = rasterOf(60, fewer(50));
  const std::vector<Point> few = placesAmong({ { 0, 0 }, { 1, 0 }, { 0.3, 1 } }, fewer(3000), 1);
  for (const Distribution d : { Distribution::Uniform, Distribution::Collinear })
  {
    SampledCase given(makePoints(d, fewer(3000), 1));
    ASSERT_EQ(given.engine.made.makeNeighbors({}), Status::Ok);
    const std::vector<double> values = valuesFor(given.points);
    for (const SampleMethod method : kMethods)
    {
      for (const SamplePlaces& places : { SamplePlaces(raster), SamplePlaces(viewOf(few)) })
      {
        Listener all;
        ASSERT_EQ(sampleAnew(given, method, places, values, { &all, nullptr }), Status::Ok);
        for (std::size_t k = 1; k <= all.askings(); ++k)
        {
          Listener listener(k);
          ASSERT_EQ(
            sampleAnew(given, method, places, values, { &listener, nullptr }), Status::Cancelled);
          EXPECT_EQ(listener.askings(), k) << "nobody is asked again";
        }
        Listener early(2);
        EXPECT_EQ(
          sampleAnew(given, method, places, values, { &early, &threads }), Status::Cancelled);
      }
    }
  }
}

/// Polls at least once for so many places, of any kind: also where all are beyond the hull, or
/// there is one vertex alone.
TEST(SampleTrouble, AsksOftenEnough)
{
  std::vector<SampleRaster> rasters{ rasterOf(500, 500) };
  for (const Point& beyond : { Point{ -3, -3 }, Point{ 2, 2 }, Point{ -3, 2 }, Point{ 2, -3 } })
  {
    rasters.push_back({ beyond, { 0.002, 0.002 }, 500, 500 });
  }
  for (const std::size_t points : { 30, 3, 1 })
  {
    SampledCase given(makePoints(Distribution::Uniform, points, 1));
    const std::vector<double> values = valuesFor(given.points);
    for (const SampleMethod method : kMethods)
    {
      given.prepare(method);
      for (const SampleRaster& raster : rasters)
      {
        Listener listener;
        const SampledValues found = sample(
          given.sampler, SamplePlaces(raster), values, { &listener, nullptr });
        ASSERT_EQ(found.status, Status::Ok);
        EXPECT_GE(listener.askings(), 250000 / kStepsPerAsking)
          << int(method) << ", " << points << " points, from " << raster.origin.x << " "
          << raster.origin.y;
      }
    }
  }
}

/// Points on a circle, and a place near its centre: all are its neighbours.
std::vector<Point> placeAmidst(const std::vector<Point>& points)
{
  const Bounds b = boundsOf(points);
  return { { 0.499 * b.xmin + 0.501 * b.xmax, 0.5 * (b.ymin + b.ymax) } };
}

/// Neighbours are visited many times, each time with polls: in the search (8 steps for each),
/// twice, as the first weights are not accurate, around the place (3), to measure and divide (2),
/// once for the scale, and to hand over. With NaturalNeighbor the second weights are not accurate
/// either: once more around the place, 32 steps each, for the exponents, to measure and divide.
TEST(SampleTrouble, AsksOftenEnoughAroundOnePlace)
{
  constexpr std::size_t n = 100000, kSteps = 8 + 2 * (3 + 2) + 1, kWideSteps = 3 * 32 + 3;
  SampledCase given(makePoints(Distribution::OnCircle, n, 1));
  const std::vector<Point> where = placeAmidst(given.points);
  const SamplePlaces places(viewOf(where));
  const std::vector<double> values = valuesFor(given.points);
  for (const SampleMethod method : { SampleMethod::NaturalNeighbor, SampleMethod::Laplace })
  {
    SCOPED_TRACE(testing::Message() << int(method));
    given.prepare(method);
    const std::size_t steps = kSteps + (method == SampleMethod::Laplace ? 0 : kWideSteps);
    SampleWeights weights;
    SampleReport report;
    Listener ofWeights, ofValues;
    ASSERT_EQ(given.sampler.weights(places, weights, report, { &ofWeights, nullptr }), Status::Ok);
    EXPECT_EQ(weights.points.size(), n);
    const std::size_t batch = kStepsPerAsking / 2, few = 3;
    EXPECT_GE((ofWeights.askings() + few) * batch, (2 * steps + 1) * n) << "each twice";
    const SampledValues found = sample(given.sampler, places, values, { &ofValues, nullptr });
    EXPECT_EQ(found.report.leftOut, 1u) << "they are added up again without the NaNs";
    EXPECT_GE((ofValues.askings() + few) * batch, (steps + 2) * n);
  }
}

/// Neighbours whose weights take more digits than doubles of 106 bits have, if x is stretched as
/// much.
std::vector<Point> pointsOfUnlikeUnits(double stretch = 0x1p900)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, 40, 1);
  for (Point& p : points)
  {
    p.x *= stretch;
  }
  return points;
}

/// The same for all the digits that a place needs.
TEST(SampleTrouble, AnyAskingCanCancelWhereDoublesAreNotEnough)
{
  SampledCase given(pointsOfUnlikeUnits());
  const std::vector<Point> few = placesAmong(given.points, 40, 1);
  ASSERT_EQ(given.engine.made.makeNeighbors({}), Status::Ok);
  const std::vector<double> values = valuesFor(given.points);
  const SamplePlaces places(viewOf(few));
  for (const SampleMethod method : { SampleMethod::NaturalNeighbor, SampleMethod::Laplace })
  {
    Listener all;
    ASSERT_EQ(sampleAnew(given, method, places, values, { &all, nullptr }), Status::Ok);
    EXPECT_GT(all.askings(), 60u) << "work of many digits counts many steps";
    for (std::size_t k = 1; k <= all.askings(); ++k)
    {
      Listener listener(k);
      ASSERT_EQ(
        sampleAnew(given, method, places, values, { &listener, nullptr }), Status::Cancelled);
      EXPECT_EQ(listener.askings(), k) << "nobody is asked again";
    }
  }
}

TEST(SampleTrouble, AnyAllocationCanFail)
{
  const SampleRaster raster = rasterOf(30, 20);
  const std::vector<Point> few = placesAmong({ { 0, 0 }, { 1, 0 }, { 0.3, 1 } }, 300, 1);
  for (const std::vector<Point>& points : { makePoints(Distribution::Uniform, 300, 1),
         makePoints(Distribution::Collinear, 300, 1), pointsOfUnlikeUnits() })
  {
    const std::vector<double> values = valuesFor(points);
    for (const SampleMethod method : kMethods)
    {
      for (const SamplePlaces& places : { SamplePlaces(raster), SamplePlaces(viewOf(few)) })
      {
        std::size_t failed = 0;
        for (;; ++failed)
        {
          account.countsNothing = true;
          SampledCase given(points);
          std::vector<double> out(places.count());
          const SampleArray array{ values.data(), 1, out.data(), nullptr };
          SampleWeights weights;
          SampleReport report;
          const std::size_t before = account.blocks;
          account.countsNothing = false;
          account.allocations = 0;
          account.failAt = failed + 1;
          Status status = given.sampler.prepare(given.engine.made, nullptr, method, {});
          status = status != Status::Ok ? status
                                        : given.sampler.weights(places, weights, report, {});
          status = status != Status::Ok
            ? status
            : given.sampler.values(places, &array, 1, nullptr, report, {});
          account.failAt = 0;
          if (status == Status::Ok)
          {
            break;
          }
          ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << failed + 1;
          ASSERT_TRUE(account.blocks >= before);
          const SampledValues again = sample(given.sampler, places, values);
          ASSERT_EQ(again.status, Status::Ok);
        }
        EXPECT_GT(failed, 5u);
      }
    }
  }
}

/// All requests of blocks to each other.
Status askBlock(Triangulation& part, const PointView& places, const Context& context)
{
  std::vector<Bounds> boxes;
  std::vector<Index> ids;
  std::size_t most = 0;
  Status status = coverByBoxes(places, 8, context, boxes);
  status = status != Status::Ok ? status : findBoxNeighbors(part, boxes, context, ids);
  status = status != Status::Ok ? status : findExtremes(part, true, context, ids);
  return status != Status::Ok ? status : findCrowd(part, context, most);
}

TEST(SampleTrouble, AnyAskingOfABlockCanCancel)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::Collinear })
  {
    SampledCase given(makePoints(d, fewer(20000), 1));
    ASSERT_EQ(given.engine.made.makeNeighbors({}), Status::Ok);
    Listener all;
    ASSERT_EQ(askBlock(given.engine.made, viewOf(given.points), { &all, nullptr }), Status::Ok);
    EXPECT_GE(all.askings(), 5 * given.points.size() / kStepsPerAsking);
    for (std::size_t k = 1; k <= all.askings(); ++k)
    {
      Listener listener(k);
      ASSERT_EQ(askBlock(given.engine.made, viewOf(given.points), { &listener, nullptr }),
        Status::Cancelled);
      EXPECT_EQ(listener.askings(), k) << "nobody is asked again";
    }
  }
}

TEST(SampleTrouble, AnyAllocationOfABlockCanFail)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 300, 1);
  std::size_t failed = 0;
  for (;; ++failed)
  {
    account.countsNothing = true;
    SampledCase given(points);
    account.countsNothing = false;
    account.allocations = 0;
    account.failAt = failed + 1;
    const Status status = askBlock(given.engine.made, viewOf(points), {});
    account.failAt = 0;
    if (status == Status::Ok)
    {
      break;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << failed + 1;
    ASSERT_EQ(askBlock(given.engine.made, viewOf(points), {}), Status::Ok);
  }
  EXPECT_GT(failed, 20u);
}

TEST(SampleTrouble, NothingLeaks)
{
  const std::size_t before = account.held;
  {
    SampledCase given(makePoints(Distribution::Uniform, 300, 1));
    const std::vector<double> values = valuesFor(given.points);
    for (const SampleMethod method : kMethods)
    {
      ASSERT_EQ(sampleAnew(given, method, SamplePlaces(rasterOf(30, 20)), values, {}), Status::Ok);
    }
  }
  EXPECT_EQ(account.held, before);
}

/// The bytes that prepare() and values() take, for arrays that are all the same.
std::size_t bytesTaken(SampledCase& given, SampleMethod method, const SamplePlaces& places,
  const std::vector<double>& values, std::size_t arrays = 1)
{
  std::vector<double> out(places.count());
  const std::vector<SampleArray> all(arrays, { values.data(), 1, out.data(), nullptr });
  SampleReport report;
  EXPECT_EQ(given.engine.made.makeNeighbors({}), Status::Ok);
  given.sampler = Sampler();
  const std::size_t before = account.held;
  account.peak = before;
  given.prepare(method);
  EXPECT_EQ(given.sampler.values(places, all.data(), arrays, nullptr, report, {}), Status::Ok);
  return account.peak - before;
}

TEST(SampleTrouble, TakesNoMoreMemoryThanEstimated)
{
  const SampleRaster raster = rasterOf(300, 200);
  const std::vector<Point> scattered = makePoints(Distribution::Uniform, 60000, 9);
  for (const Distribution d : { Distribution::Uniform, Distribution::Collinear })
  {
    SampledCase given(makePoints(d, reduced(50000), 1));
    const std::vector<double> values = valuesFor(given.points);
    for (const SampleMethod method : kMethods)
    {
      for (const SamplePlaces& places : { SamplePlaces(raster), SamplePlaces(viewOf(scattered)) })
      {
        const std::size_t taken = bytesTaken(given, method, places, values);
        const std::size_t estimate = sampleMemoryEstimate(given.points.size(), places, 1);
        EXPECT_LE(taken, estimate) << int(method);
        EXPECT_GE(6 * taken, estimate) << int(method) << ": most have a short rim";
      }
    }
  }
}

/// Many arrays of few values.
TEST(SampleTrouble, TakesNoMoreMemoryThanEstimatedForArrays)
{
  SampledCase given({ { 0, 0 }, { 1, 0 }, { 0, 1 } });
  const std::vector<Point> where{ { 0.2, 0.2 } };
  const SamplePlaces places(viewOf(where));
  const std::size_t taken = bytesTaken(given, SampleMethod::Linear, places, { 1, 2, 3 }, 10000);
  EXPECT_LE(taken, sampleMemoryEstimate(3, places, 10000));
  EXPECT_GE(2 * taken, sampleMemoryEstimate(3, places, 10000));
}

/// Memory that the estimate does not count.
TEST(SampleTrouble, TakesNoMoreMemoryThanSaidForEachNeighbor)
{
  const std::size_t n = 70000; // a bit more than a power of two: vectors have just grown
  SampledCase given(makePoints(Distribution::OnCircle, n, 1));
  const std::vector<Point> where = placeAmidst(given.points);
  const SamplePlaces places(viewOf(where));
  for (const SampleMethod method : { SampleMethod::NaturalNeighbor, SampleMethod::Laplace })
  {
    const std::size_t taken = bytesTaken(given, method, places, valuesFor(given.points));
    const std::size_t estimate = sampleMemoryEstimate(n, places, 1);
    EXPECT_LE(taken, estimate + 450 * n) << int(method);
    EXPECT_GE(taken, estimate + 100 * n) << int(method);
  }
}

/// Compared with places that doubles of 106 bits are enough for.
TEST(SampleTrouble, TakesNoMoreMemoryThanSaidForEachThread)
{
  for (const SampleMethod method : { SampleMethod::NaturalNeighbor, SampleMethod::Laplace })
  {
    std::size_t taken[2];
    for (const bool isWide : { false, true })
    {
      SampledCase given(pointsOfUnlikeUnits(isWide ? 0x1p900 : 0x1p10));
      const std::vector<Point> few = placesAmong(given.points, 50, 1);
      taken[isWide] = bytesTaken(given, method, SamplePlaces(viewOf(few)), valuesFor(given.points));
    }
    EXPECT_LE(taken[1], taken[0] + 65536) << int(method);
    EXPECT_GE(taken[1], taken[0] + 32768) << int(method) << ": they were good before";
  }
}

} // namespace
} // namespace test
} // namespace ahd
