// SPDX-License-Identifier: BSD-3-Clause
//
// Reading and sorting poll often enough, stop at once, and take a number of steps that is linear in
// the number of points however the points coincide or crowd.
#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"
#include "Order/Rank.h"
#include "Order/Sequence.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

#ifdef AHD_REDUCED_TESTS
constexpr std::size_t kMany = 40000;
#else
constexpr std::size_t kMany = 140000;
#endif

/// Counts the polls of each phase and cancels at one of them if set.
class Counter : public Progress
{
public:
  explicit Counter(std::size_t noAt = 0)
    : noAt_(noAt)
  {
  }
  bool advance(Phase phase, double fraction) override
  {
    ++(phase == Phase::Read ? read : sort);
    late += said_ ? 1 : 0;
    falls += phase == last_ && fraction < fraction_ ? 1 : 0;
    last_ = phase;
    fraction_ = fraction;
    said_ = read + sort == noAt_;
    return !said_;
  }
  std::size_t read = 0;
  std::size_t sort = 0;
  std::size_t late = 0;  ///< polls after the cancel
  std::size_t falls = 0; ///< polls with a smaller fraction than before
  double lastFraction() const { return fraction_; }

private:
  std::size_t noAt_;
  bool said_ = false;
  Phase last_ = Phase::Read;
  double fraction_ = 0.0;
};

Status order(const std::vector<Point>& points, const Options& options, Counter& counter)
{
  RankedPoints ranked;
  Ticker reading(&counter, Phase::Read, points.size());
  Status status = readPoints(viewOf(points), reading, ranked);
  if (status == Status::Ok)
  {
    Ticker sorting(&counter, Phase::Sort, points.size());
    status = rankPoints(viewOf(points), sorting, ranked);
    if (status == Status::Ok)
    {
      Buffer<Index> sequence;
      status = makeSequence(ranked, options, sorting, sequence);
    }
  }
  return status;
}

Status rank(const std::vector<Point>& points, Executor* executor, Counter& counter)
{
  RankedPoints ranked;
  Ticker reading(&counter, Phase::Read, points.size(), executor);
  const Status status = readPoints(viewOf(points), reading, ranked);
  if (status != Status::Ok)
  {
    return status;
  }
  Ticker sorting(&counter, Phase::Sort, points.size(), executor);
  return rankPoints(viewOf(points), sorting, ranked);
}

std::vector<Distribution> kinds()
{
  return { Distribution::Uniform, Distribution::KuzminDisc, Distribution::CrowdedBox,
    Distribution::Lattice, Distribution::AllEqual, Distribution::RepeatedDraws,
    Distribution::Collinear, Distribution::TinyAndHuge };
}

/// All in one box of the finest grid but for two far corners.
std::vector<Point> crowd(std::size_t n)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, n, 61);
  for (Point& p : points)
  {
    p = { 0.25 + p.x * 0x1p-40, 0.75 + p.y * 0x1p-40 };
  }
  points.front() = { 0.0, 0.0 };
  points.back() = { 1.0, 1.0 };
  return points;
}

/// One setting for every way through the code.
std::vector<Options> settings()
{
  std::vector<Options> result;
  for (const Options& options : everySetting({ 50 }))
  {
    const bool isHilbert = options.order == InsertionOrder::AdaptiveHilbert;
    const bool isGrid = isHilbert || options.order == InsertionOrder::MultiGrid;
    if ((options.geneRotation || isHilbert) &&
      (isGrid || options.controlPoints == ControlPoints::Off))
    {
      result.push_back(options);
    }
  }
  Options undivided;
  undivided.nmax = 1 << 30;
  result.push_back(undivided);
  return result;
}

void expectAsked(const std::vector<Point>& points, const std::string& name, std::size_t mostSteps)
{
  for (const Options& options : settings())
  {
    Counter counter;
    EXPECT_EQ(order(points, options, counter), Status::Ok);
    const std::size_t least = points.size() / kStepsPerAsking;
    EXPECT_GE(counter.read, least) << name << ", " << describe(options);
    EXPECT_GE(counter.sort, 3 * least) << name << ", " << describe(options);
    EXPECT_LE(counter.sort, mostSteps * points.size() / (kStepsPerAsking / 2) + 1)
      << name << ", " << describe(options);
    EXPECT_EQ(counter.falls, 0u) << name << ", " << describe(options);
    EXPECT_LE(counter.lastFraction(), 1.0) << name << ", " << describe(options);
  }
}

TEST(OrderProgress, AsksOftenEnoughAndTakesLinearTime)
{
  // Passes over all points: keys, records, differing bits, counting, scattering, copying back, a
  // bucket's sort, runs, distinct points, duplicates, a crowd's bounds and keys; and for the
  // sequence boxes, ids, radix passes, control points. 40 is twice what the worst case here takes;
  // anything quadratic is thousands.
  for (const Distribution d : kinds())
  {
    expectAsked(makePoints(d, kMany, 62), nameOf(d), 40);
  }
  expectAsked(crowd(kMany), "crowd", 40);
}

TEST(OrderProgress, ManyDrawsOfFewPlacesStayLinear)
{
#ifdef AHD_REDUCED_TESTS
  const std::size_t n = 100000;
#else
  const std::size_t n = 1000000;
#endif
  for (const Distribution d : { Distribution::RepeatedDraws, Distribution::AllEqual })
  {
    Counter counter;
    EXPECT_EQ(order(makePoints(d, n, 63), Options(), counter), Status::Ok);
    EXPECT_LE(counter.sort, 12 * n / (kStepsPerAsking / 2)) << nameOf(d);
  }
}

TEST(OrderProgress, StopsAtEveryAskingWithThreads)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::CrowdedBox,
         Distribution::RepeatedDraws, Distribution::AllEqual })
  {
    const std::vector<Point> points = makePoints(d, kMany, 65);
    // With threads that take turns the number of polls is always the same; with real threads it is
    // not, but they must stop, and none polls again.
    BackwardExecutor backward(3);
    Counter all;
    ASSERT_EQ(rank(points, &backward, all), Status::Ok);
    EXPECT_GE(all.read + all.sort, 3 * points.size() / kStepsPerAsking) << nameOf(d);
    EXPECT_EQ(all.falls, 0u) << nameOf(d);
    for (std::size_t k = 1; k <= all.read + all.sort; ++k)
    {
      Counter counter(k);
      ASSERT_EQ(rank(points, &backward, counter), Status::Cancelled) << "at asking " << k;
      ASSERT_EQ(counter.read + counter.sort, k) << nameOf(d);
      ASSERT_EQ(counter.late, 0u) << nameOf(d);
    }
    // Where other threads take all tasks, too.
    QuickElsewhereExecutor elsewhere(3);
    ThreadExecutor threads(3);
    for (Executor* executor :
      { static_cast<Executor*>(&elsewhere), static_cast<Executor*>(&threads) })
    {
      Counter first(1);
      EXPECT_EQ(rank(points, executor, first), Status::Cancelled) << nameOf(d);
      EXPECT_EQ(first.late, 0u) << nameOf(d);
    }
  }
}

TEST(OrderProgress, StopsAtEveryAsking)
{
  std::vector<std::vector<Point>> inputs{ crowd(12000) };
  for (const Distribution d : kinds())
  {
    inputs.push_back(makePoints(d, 12000, 64));
  }
  for (const std::vector<Point>& points : inputs)
  {
    for (const Options& options : settings())
    {
      Counter all;
      ASSERT_EQ(order(points, options, all), Status::Ok);
      for (std::size_t k = 1; k <= all.read + all.sort; ++k)
      {
        Counter counter(k);
        ASSERT_EQ(order(points, options, counter), Status::Cancelled)
          << "no at asking " << k << ", " << describe(options);
        ASSERT_EQ(counter.read + counter.sort, k) << describe(options);
        ASSERT_EQ(counter.late, 0u) << "no at asking " << k << ", " << describe(options);
      }
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
