// SPDX-License-Identifier: BSD-3-Clause
//
// Constraints under adverse circumstances: cancelled at any poll, out of memory at any allocation.
// Progress meanwhile, and memory held.
#include "ConstrainedRun.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace ahd
{
namespace test
{
namespace
{

/// Counts the polls of constrain() and of the cell data, notes fractions that fall, and cancels at
/// one poll if set.
class Listener : public Progress
{
public:
  explicit Listener(std::size_t cancelAt = 0)
    : cancelAt_(cancelAt)
  {
  }
  void beginPhase(Phase phase) override
  {
    phase_ = phase;
    fraction_ = 0.0;
    constrained_ = constrained_ || phase == Phase::Constrain;
  }
  bool advance(Phase phase, double fraction) override
  {
    ++askings_;
    const bool isRight = phase == phase_ && fraction >= fraction_ && fraction <= 1.0;
    faults_ += isRight && !cancelled_ ? 0 : 1;
    fraction_ = fraction;
    cancelled_ = askings_ == cancelAt_;
    return !cancelled_;
  }
  std::size_t askings() const { return askings_; }
  int faults() const { return faults_; }
  bool constrained() const { return constrained_; }

private:
  std::size_t cancelAt_;
  std::size_t askings_ = 0;
  Phase phase_ = Phase::Read;
  double fraction_ = 0.0;
  int faults_ = 0;
  bool cancelled_ = false;
  bool constrained_ = false;
};

/// Cases in which each part of the work polls more than once.
std::vector<ConstraintCase> longCases()
{
  return { segmentAcrossParabolas(10000), nestedLoops(30), starPolygon(5000),
    edgesOfOthers(30000, 15000), randomSegments(10000, 300) };
}

TEST(ConstrainTrouble, CancelledAtAnyAsking)
{
  Engine engine;
  for (const ConstraintCase& given : longCases())
  {
    const PointView points = given.view();
    const ConstraintView constraints = given.constraints.view();
    ASSERT_EQ(engine.run(points, Options(), nullptr), Status::Ok);
    Listener whole;
    ASSERT_EQ(engine.constrain(constraints, FillRule::EvenOdd, &whole), Status::Ok);
    EXPECT_TRUE(whole.constrained());
    EXPECT_EQ(whole.faults(), 0);
    EXPECT_GE(whole.askings(), engine.report().inserted / kStepsPerAsking);
    const std::size_t step = 1 + whole.askings() / 20;
    for (std::size_t k = 1; k <= whole.askings(); k += step)
    {
      ASSERT_EQ(engine.run(points, Options(), nullptr), Status::Ok);
      Listener listener(k);
      ASSERT_EQ(engine.constrain(constraints, FillRule::EvenOdd, &listener), Status::Cancelled);
      ASSERT_EQ(listener.askings(), k);
      ASSERT_EQ(listener.faults(), 0);
      ASSERT_EQ(engine.report().triangles, 0u);
    }
    Helpers none;
    EXPECT_EQ(difference(constrain(given, FillRule::EvenOdd),
                constrain(engine, points, constraints, FillRule::EvenOdd, Options(), none)),
      "")
      << "after being cancelled";
  }
}

TEST(ConstrainTrouble, AskedWithinOneSegment)
{
  // All else is the same with and without the segment, so the additional polls were within it.
  const ConstraintCase given = segmentAcrossParabolas(reduced(200000));
  const ConstraintSet none;
  std::size_t askings[2];
  for (const bool with : { false, true })
  {
    Engine engine;
    ASSERT_EQ(engine.run(given.view(), Options(), nullptr), Status::Ok);
    Listener listener;
    ASSERT_EQ(
      engine.constrain((with ? given.constraints : none).view(), FillRule::Orientation, &listener),
      Status::Ok);
    askings[with ? 1 : 0] = listener.askings();
  }
  EXPECT_GE(askings[1] - askings[0], given.points.size() / kStepsPerAsking); // edges it crosses
}

TEST(ConstrainTrouble, CellDataAreCancelledAtAnyAsking)
{
  const ConstraintCase given = edgesOfOthers(40000, 20000);
  const ConstrainedOutcome expected = constrain(given, FillRule::Orientation);
  Engine engine;
  ConstrainedOutcome found = constrain(
    engine, given.view(), given.constraints.view(), FillRule::Orientation);
  const std::function<Status(Progress*)> writers[] = {
    [&](Progress* p) { return engine.writeNeighbors(found.neighbors.data(), p); },
    [&](Progress* p) { return engine.writeConstraintEdges(found.constraintEdges.data(), p); },
    [&](Progress* p) { return engine.writeRegions(found.regions.data(), p); },
  };
  for (const auto& write : writers)
  {
    Listener whole;
    ASSERT_EQ(write(&whole), Status::Ok);
    EXPECT_GE(whole.askings(), engine.report().triangles / kStepsPerAsking);
    EXPECT_EQ(whole.faults(), 0);
    for (std::size_t k = 1; k <= whole.askings(); ++k)
    {
      Listener listener(k);
      ASSERT_EQ(write(&listener), Status::Cancelled);
      ASSERT_EQ(listener.askings(), k);
    }
    ASSERT_EQ(write(nullptr), Status::Ok);
  }
  EXPECT_EQ(difference(expected, found), "");
}

/// Fails the k-th allocation after run() and all that follow, for every k, until all succeeds.
void expectOutOfMemoryIsSurvived(const ConstraintCase& given)
{
  const ConstrainedOutcome expected = constrain(given, FillRule::EvenOdd);
  ConstrainedOutcome found = expected;
  Engine engine;
  for (std::size_t k = 1; k < 2000; ++k)
  {
    ASSERT_EQ(engine.run(given.view(), Options(), nullptr), Status::Ok);
    account.failAt = account.allocations + k;
    Status status = engine.constrain(given.constraints.view(), FillRule::EvenOdd, nullptr);
    const bool constrained = status == Status::Ok;
    status = constrained ? engine.writeTriangles(found.triples.data(), nullptr) : status;
    status = status != Status::Ok ? status : engine.writeNeighbors(found.neighbors.data(), nullptr);
    status = status != Status::Ok ? status : engine.writeRegions(found.regions.data(), nullptr);
    account.failAt = 0;
    if (status == Status::Ok)
    {
      EXPECT_GT(k, 1u) << "the engine no longer allocates through operator new";
      EXPECT_EQ(difference(expected, found), "");
      return;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "at allocation " << k;
    if (!constrained)
    {
      ASSERT_EQ(engine.report().triangles, 0u) << "at allocation " << k;
    }
    engine.release();
  }
  FAIL() << "nothing got through";
}

TEST(ConstrainTrouble, OutOfMemoryAtAnyAllocationIsReportedAndSurvived)
{
  for (const ConstraintCase& given : { segmentAcrossBulges(3000), nestedLoops(6),
         randomSegments(1000, 200), edgesOfOthers(2000, 500) })
  {
    expectOutOfMemoryIsSurvived(given);
  }
}

TEST(ConstrainTrouble, NothingIsHeldOnceWorkspaceAndTriangulationAreGone)
{
  const ConstraintCase given = nestedLoops(10);
  const std::size_t before = account.held;
  constrain(given, FillRule::EvenOdd);
  EXPECT_EQ(account.held, before);
}

/// The most bytes held at once from run() to the last write, output and leftOut not counted.
std::size_t peakOf(const ConstraintCase& given)
{
  const std::size_t count = given.points.size();
  std::vector<std::int64_t> room(6 * count);
  std::vector<std::uint8_t> bits(2 * count);
  const std::size_t before = account.held;
  account.peak = before;
  Engine t;
  EXPECT_EQ(t.run(given.view(), Options(), nullptr), Status::Ok);
  EXPECT_EQ(t.constrain(given.constraints.view(), FillRule::EvenOdd, nullptr), Status::Ok);
  EXPECT_EQ(t.writeTriangles(room.data(), nullptr), Status::Ok);
  EXPECT_EQ(t.writeNeighbors(room.data(), nullptr), Status::Ok);
  EXPECT_EQ(t.writeConstraintEdges(bits.data(), nullptr), Status::Ok);
  EXPECT_EQ(t.writeRegions(room.data(), nullptr), Status::Ok);
  return account.peak - before;
}

TEST(ConstrainTrouble, NoMoreMemoryThanEstimated)
{
  for (const ConstraintCase& given : longCases())
  {
    const std::size_t points = given.points.size();
    const std::size_t segments = segmentsOf(given.constraints.view()).size();
    EXPECT_LE(peakOf(given),
      triangulationMemoryEstimate(points, Options()) + constraintMemoryEstimate(points, segments))
      << points << " points, " << segments << " segments";
  }
}

} // namespace
} // namespace test
} // namespace ahd
