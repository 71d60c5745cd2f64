// SPDX-License-Identifier: BSD-3-Clause
//
// Constraints split where they cross: nothing crosses any more, every crossing has its point, and
// the chains are unchanged otherwise.
#include "SplitDrawings.h"

namespace ahd
{
namespace test
{
namespace
{

TEST(Split, NothingToSplit)
{
  SplitConstraints split;
  EXPECT_EQ(splitAtCrossings(PointView(), ConstraintView(), nullptr, split), Status::Ok);
  EXPECT_EQ(split.view().chains, 0u);
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 2, 2 }, { 0, 2 }, { 1, 1 } };
  drawing.lines = { {}, { 0 }, { 0, 1 }, {}, { 2, 3 }, { 3, 3 }, {} };
  drawing.loops = { {}, { 1 }, { 0, 1 }, { 0, 1, 2 }, { 0, 1, 2, 0 }, {} };
  split = splitOf(drawing);
  EXPECT_EQ(split.ids, Chains(drawing).ids);
  EXPECT_EQ(split.offsets, Chains(drawing).offsets);
  EXPECT_EQ(split.lines, 7u);
  EXPECT_EQ(split.rounds, 0);
  EXPECT_EQ(split.crossings, 0u);
  EXPECT_EQ(faultsOf(drawing, split), "");
}

TEST(Split, TwoSegmentsAndTheirFractions)
{
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 4, 4 }, { 0, 2 }, { 8, -2 } };
  drawing.lines = { { 0, 1 } };
  drawing.loops = { { 3, 2 } };
  const SplitConstraints split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 4, 1, 3, 4, 2, 4 })) << "the loop is back and forth";
  EXPECT_EQ(split.offsets, (Ids{ 0, 3, 7 }));
  EXPECT_EQ(split.segments, (Ids{ 0, 0, 0, 0, 0, 1, 1 }));
  ASSERT_EQ(split.points.size(), 1u);
  EXPECT_EQ(split.points[0].at, (Point{ 4.0 / 3, 4.0 / 3 }));
  EXPECT_EQ(split.points[0].chainA, 0u);
  EXPECT_EQ(split.points[0].segmentA, 0u);
  EXPECT_DOUBLE_EQ(split.points[0].alongA, 1.0 / 3);
  EXPECT_EQ(split.points[0].chainB, 1u);
  EXPECT_EQ(split.points[0].segmentB, 0u);
  EXPECT_DOUBLE_EQ(split.points[0].alongB, 5.0 / 6);
  EXPECT_EQ(split.crossings, 2u);
  EXPECT_EQ(split.rounds, 1);
}

TEST(Split, APointAtTheCrossingIsUsed)
{
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 2, 2 }, { 0, 2 }, { 2, 0 }, { 1, 1 }, { 1, 1 }, { 1, 9 } };
  drawing.lines = { { 0, 1 }, { 2, 3 } };
  SplitConstraints split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 4, 1, 2, 4, 3 })) << "the one of smallest id";
  EXPECT_TRUE(split.points.empty());
  EXPECT_EQ(split.crossings, 1u);
  drawing.lines.push_back({ 5, 6 });
  split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 5, 1, 2, 5, 3, 5, 6 })) << "one that is an end";
  drawing.lines.push_back({ 4, 6 });
  split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 4, 1, 2, 4, 3, 5, 6, 4, 6 })) << "of two ends the first";
  drawing.skip = { 0, 0, 0, 0, 1, 1, 0 };
  split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 7, 1, 2, 7, 3, 5, 6, 4, 6 })) << "those left out are no points";
}

TEST(Split, IdsOfNoPointDoNotBecomeThoseOfAddedOnes)
{
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 2, 2 }, { 0, 2 }, { 2, 0 } };
  drawing.lines = { { 0, 1, 4, 1 }, { 2, 3, -7 } };
  EXPECT_EQ(splitOf(drawing).ids, (Ids{ 0, 4, 1, -1, 1, 2, 4, 3, -1 }));
}

TEST(Split, OnePointForAllThatCrossThere)
{
  Drawing drawing;
  for (int i = -5; i <= 5; ++i)
  {
    for (int k = -5; k <= 5; ++k)
    {
      if (i != 0 || k != 0)
      {
        drawing.addSegment({ 0.25 + i, 0.5 + k }, { 0.25 - i, 0.5 - k });
      }
    }
  }
  const SplitConstraints split = splitOf(drawing);
  ASSERT_EQ(split.points.size(), 1u);
  EXPECT_EQ(split.points[0].at, (Point{ 0.25, 0.5 }));
  EXPECT_EQ(faultsOf(drawing, split), "");
}

TEST(Split, RandomChainsOnSmallLattices)
{
  Random random(1);
  std::size_t crossings = 0;
  for (std::size_t round = 0; round < reduced(4000); ++round)
  {
    Drawing drawing;
    const std::size_t width = 3 + random.below(8), height = 2 + random.below(8);
    for (std::size_t i = 0; i < 30; ++i)
    {
      drawing.points.push_back({ double(random.below(width)), double(random.below(height)) });
    }
    drawing.points.push_back({ std::numeric_limits<double>::quiet_NaN(), 1.0 });
    drawing.skip.assign(drawing.points.size(), 0);
    drawing.skip[7] = 1;
    for (std::size_t chain = 1 + random.below(5); chain != 0; --chain)
    {
      Ids ids;
      for (std::size_t i = random.below(7); i != 0; --i)
      {
        ids.push_back(
          std::int64_t(random.below(drawing.points.size() + 2)) - 1); // -1 to one too many
      }
      (random.below(2) == 0 ? drawing.lines : drawing.loops).push_back(ids);
    }
    crossings += expectSplit(drawing, random);
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(crossings, reduced(4000));
}

TEST(Split, RandomSegmentsOfEveryDistribution)
{
  Random random(2);
  for (const Distribution distribution : allDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    for (std::uint64_t seed = 0; seed < 8; ++seed)
    {
      Drawing drawing;
      drawing.points = makePoints(distribution, 30, seed);
      drawing.lines.resize(3);
      drawing.loops.resize(2);
      for (std::size_t i = 0; i < drawing.points.size(); ++i)
      {
        (i % 5 < 3 ? drawing.lines[i % 5] : drawing.loops[i % 5 - 3]).push_back(std::int64_t(i));
      }
      expectSplit(drawing, random);
    }
  }
}

TEST(Split, SegmentsThatAreNearlyOne)
{
  // They cross at angles of a few units in the last place, so that pieces bent by rounding cross
  // others.
  Random random(3);
  std::size_t crossings = 0, inLaterRounds = 0;
  for (std::size_t round = 0; round < reduced(500); ++round)
  {
    Drawing drawing;
    const double unit = std::ldexp(1.0, -int(40 + random.below(13)));
    const auto near = [&](double value) { return value + unit * double(random.below(9)); };
    for (int k = 0; k < 12; ++k)
    {
      drawing.addSegment({ near(1.0), near(1.0) }, { near(1.75), near(1.5) });
    }
    crossings += expectSplit(drawing, random);
    inLaterRounds += splitOf(drawing).rounds > 1;
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(crossings, reduced(2000));
  EXPECT_GT(inLaterRounds, reduced(500) / 20) << "the drawings no longer do what they are made for";
}

/// In a large drawing nothing is left to split.
void expectNothingCrosses(const Drawing& drawing, const SplitConstraints& split)
{
  EXPECT_EQ(split.unresolved, 0u);
  const std::vector<Point> points = allPoints(drawing, split);
  SplitConstraints again;
  EXPECT_EQ(splitAtCrossings(viewOf(points), split.view(), nullptr, again), Status::Ok);
  EXPECT_EQ(again.crossings, 0u);
  EXPECT_EQ(again.ids, split.ids);
  EXPECT_EQ(faultsOfChains(drawing, split), "");
}

TEST(Split, GridOfCrossingLines)
{
  for (const auto& [n, tilt] :
    { std::pair(100, 0.0), std::pair(int(std::sqrt(double(reduced(90000)))), 0.1) })
  {
    Drawing drawing;
    for (int i = 0; i < n; ++i)
    {
      drawing.addSegment({ i - tilt, -1.0 }, { i + tilt, double(n) });
      drawing.addSegment({ -1.5, i + tilt }, { n + 0.5, i - tilt });
    }
    const SplitConstraints split = splitOf(drawing);
    EXPECT_GE(split.points.size(), std::size_t(n * n) * 98 / 100); // some lie beyond an end
    EXPECT_EQ(split.crossings, split.points.size());
    expectNothingCrosses(drawing, split);
  }
}

TEST(Split, StarOfLinesThroughAlmostOnePoint)
{
  const int n = 200;
  Random random(4);
  for (const double blur : { 0.0, 1e-16, 1e-13 })
  {
    Drawing drawing;
    for (int i = 0; i < n; ++i)
    {
      const double angle = 3.14159265358979 * i / n;
      const double x = std::cos(angle), y = std::sin(angle);
      const double dx = blur * random.unit(), dy = blur * random.unit();
      drawing.addSegment({ 0.3 + x + dx, 0.7 + y + dy }, { 0.3 - x + dx, 0.7 - y + dy });
    }
    const SplitConstraints split = splitOf(drawing);
    EXPECT_GT(split.crossings, 15000u);
    expectNothingCrosses(drawing, split);
  }
}

/// Counts the polls, which grow with the work, and cancels at one of them if set.
class Counter : public Progress
{
public:
  explicit Counter(std::size_t cancelAt = 0)
    : cancelAt_(cancelAt)
  {
  }
  void beginPhase(Phase phase) override { EXPECT_EQ(phase, Phase::Split); }
  bool advance(Phase, double fraction) override
  {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    return ++askings_ != cancelAt_;
  }
  std::size_t askings() const { return askings_; }

private:
  std::size_t cancelAt_;
  std::size_t askings_ = 0;
};

/// The steps it takes to split it, at most.
std::size_t stepsFor(const Drawing& drawing, std::size_t crossings)
{
  SplitConstraints split;
  Counter counter;
  EXPECT_EQ(splitAtCrossings(drawing.view(), Chains(drawing).view(), &counter, split), Status::Ok);
  EXPECT_EQ(split.crossings, crossings);
  expectNothingCrosses(drawing, split);
  return counter.askings() * kStepsPerAsking;
}

// A search of all pairs would take the square of 10^5 steps; a small multiple of n log n is
// allowed.

TEST(Split, LongSegmentAmongManyShortOnes)
{
  const std::size_t n = reduced(100000);
  Random random(5);
  Drawing drawing;
  for (std::size_t i = 0; i < n; ++i)
  {
    // In boxes of their own of a lattice; the diagonals cross nothing but the long one.
    const double x = double(i % 300), y = double(i / 300);
    drawing.addSegment({ x, y }, { x + 0.5 * random.unit(), y + 0.5 * random.unit() });
  }
  drawing.addSegment({ -1.0, -0.875 }, { 301.0, -0.75 });
  EXPECT_LE(stepsFor(drawing, 0), 1000 * n);
  // Straight up through a column of horizontal ones.
  Drawing column;
  for (std::size_t i = 0; i < n / 2; ++i)
  {
    column.addSegment({ 400.0, double(i) }, { 401.0, double(i) });
  }
  column.addSegment({ 400.5, -1.0 }, { 400.5, double(n) });
  EXPECT_LE(stepsFor(column, n / 2), 1000 * n);
}

TEST(Split, ManyLongParallelSegments)
{
  for (const auto& [n, slope] : { std::pair(reduced(20000), 0.0), std::pair(reduced(100000), 0.7) })
  {
    Drawing drawing;
    for (std::size_t i = 0; i < n; ++i)
    {
      const double y = double(i) / double(n);
      drawing.addSegment({ 0.0, y }, { 1e3, y + slope * 1e3 });
    }
    drawing.addSegment({ 0.0, 0.5 }, { 1e3, 0.5 + slope * 1e3 - 10.0 / double(n) });
    EXPECT_LE(stepsFor(drawing, 9), 1000 * n);
  }
}

TEST(Split, ManySegmentsWithOneCommonEnd)
{
  const std::size_t n = reduced(50000);
  Random random(6);
  Drawing drawing;
  drawing.points.push_back({ 0, 0 });
  for (std::size_t i = 0; i < n; ++i)
  {
    drawing.points.push_back({ random.unit() - 0.5, random.unit() - 0.5 });
    drawing.lines.push_back({ 0, std::int64_t(i) + 1 });
  }
  EXPECT_LE(stepsFor(drawing, 0), 1000 * n);
}

TEST(Split, CancelledAtAnyAsking)
{
  Random random(7);
  Drawing drawing;
  for (int i = 0; i < 200; ++i)
  {
    drawing.addSegment({ random.unit(), random.unit() }, { random.unit(), random.unit() });
  }
  const Chains chains(drawing);
  SplitConstraints split;
  Counter whole;
  ASSERT_EQ(splitAtCrossings(drawing.view(), chains.view(), &whole, split), Status::Ok);
  ASSERT_GE(whole.askings(), 20u);
  for (std::size_t k = 1; k <= whole.askings(); k += 1 + whole.askings() / 15)
  {
    Counter counter(k);
    EXPECT_EQ(splitAtCrossings(drawing.view(), chains.view(), &counter, split), Status::Cancelled);
    EXPECT_EQ(counter.askings(), k);
  }
}

TEST(Split, TooManyPointsAreRefusedUnread)
{
  const double one[] = { 0, 0 };
  SplitConstraints split;
  EXPECT_EQ(
    splitAtCrossings(PointView(one, kMaximumPoints + 1, 2), ConstraintView(), nullptr, split),
    Status::TooManyPoints);
}

} // namespace
} // namespace test
} // namespace ahd
