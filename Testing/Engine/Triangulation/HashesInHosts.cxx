// SPDX-License-Identifier: BSD-3-Clause
//
// A host program may have set another rounding, flushing to zero or traps, on any thread, or set it
// in a callback: the results are the same to the byte, and its settings are restored, also after a
// cancel or without memory.
#include "HashedResults.h"
#include "HostModes.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

#include <cfenv>

namespace ahd
{
namespace test
{
namespace
{

PointView viewOf(const NamedPoints& given)
{
  return PointView(&given.points[0].x, given.points.size(), 2);
}

std::vector<NamedCase> fewCases()
{
  std::vector<NamedCase> result = { { "randomSegments", randomSegments(100, 20) },
    { "segmentAcrossCombs", segmentAcrossCombs(100) },
    { "latticeSegments", latticeSegments(12, 60) } };
  for (const Distribution d : allDistributions())
  {
    result.push_back({ std::string("chainsThrough") + nameOf(d), chainsThrough(d, 40, 10, 9) });
  }
  return result;
}

/// Every public function of the engine, with few points.
Hashes fewHashes(const Way& way)
{
  Hashes result;
  for (const NamedPoints& given : pointsOfDistributions(60))
  {
    const PointView points = viewOf(given);
    result.push_back({ "points/" + given.name, hashOfTriangles(points, way) });
    result.push_back({ "order/" + given.name, hashOfOrder(points, Options(), way) });
    result.push_back({ "merged/" + given.name, hashOfMerged(points, way) });
    result.push_back({ "voronoi/" + given.name, hashOfVoronoi(points, way) });
    result.push_back({ "sample/" + given.name, hashOfSamples(points, way) });
  }
  for (const NamedCase& made : fewCases())
  {
    const std::string hash = hashOfConstrained(made.given, FillRule::EvenOdd, way);
    result.push_back({ "constrained/" + made.name, hash });
    result.push_back({ "split/" + made.name, hashOfSplit(made.given, way) });
    result.push_back({ "sample/constrained/" + made.name, hashOfSamples(made.given, way) });
  }
  return result;
}

/// Many enough for threads.
Hashes sharedHashes(const Way& way)
{
  Hashes result;
  for (const NamedPoints& given : manyPoints())
  {
    result.push_back({ given.name, hashOfVoronoi(viewOf(given), way) });
  }
  return result;
}

const HostMode kAsProgramsBegin = { "as programs begin", FE_TONEAREST, 0, 0 };

/// The first, which rounds otherwise, and the last, which has everything.
std::vector<HostMode> twoModes()
{
#ifdef AHD_REDUCED_TESTS
  return { hostModes().back() };
#else
  return { hostModes().front(), hostModes().back() };
#endif
}

/// Calls in a mode, which must be restored afterwards.
Way wayIn(const HostMode& mode)
{
  Way way;
  way.call = [&mode](const std::function<Status()>& work)
  {
    enter(mode);
    const Status status = work();
    const bool isKept = isIn(mode);
    leaveHostMode();
    EXPECT_TRUE(isKept) << mode.name;
    return status;
  };
  return way;
}

/// Changes the mode at each poll; cancels at one poll.
class HostProgress : public Progress
{
public:
  explicit HostProgress(const HostMode& mode, std::size_t cancelAt = 0)
    : mode_(mode)
    , cancelAt_(cancelAt)
  {
  }
  void beginPhase(Phase) override { enter(mode_); }
  bool advance(Phase, double) override
  {
    enter(mode_);
    return ++asked_ != cancelAt_;
  }

private:
  const HostMode& mode_;
  std::size_t cancelAt_;
  std::size_t asked_ = 0;
};

/// Its threads have a mode when they take a task, which must be restored after it.
class HostExecutor : public ThreadExecutor
{
public:
  HostExecutor(unsigned threads, const HostMode& mode)
    : ThreadExecutor(threads)
    , mode_(mode)
  {
  }
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override
  {
    const auto inMode = [&](std::size_t k)
    {
      enter(mode_);
      task(k);
      lost_ = lost_ || !isIn(mode_);
      ++tasks_;
    };
    ThreadExecutor::run(count, inMode, idle);
    enter(mode_);
  }
  bool lost() const { return lost_; }
  std::size_t tasks() const { return tasks_; }

private:
  const HostMode& mode_;
  std::atomic<bool> lost_{ false };
  std::atomic<std::size_t> tasks_{ 0 };
};

TEST(HashesInHosts, NoModeOfTheCallerChangesAByte)
{
  const Hashes expected = fewHashes(Way());
  ASSERT_GE(expected.size(), 150u);
  for (const HostMode& mode : hostModes())
  {
    EXPECT_EQ(differences(expected, fewHashes(wayIn(mode))), "") << mode.name;
  }
}

TEST(HashesInHosts, NorDoesOneThatIsSetWhenTheCallerIsAsked)
{
  const Hashes expected = fewHashes(Way());
  for (const HostMode& mode : twoModes())
  {
    Way way = wayIn(kAsProgramsBegin);
    HostProgress progress(mode);
    way.progress = &progress;
    EXPECT_EQ(differences(expected, fewHashes(way)), "") << mode.name;
  }
}

TEST(HashesInHosts, NorDoesOneOfTheThreads)
{
  const Hashes expected = sharedHashes(Way());
  for (const HostMode& mode : twoModes())
  {
    HostExecutor executor(3, mode);
    Way way = wayIn(mode);
    way.executor = &executor;
    EXPECT_EQ(differences(expected, sharedHashes(way)), "") << mode.name;
    EXPECT_FALSE(executor.lost()) << mode.name;
    EXPECT_GE(executor.tasks(), 100u);
  }
}

TEST(HashesInHosts, ModesArePutBackWhereTheCallerCancels)
{
  const std::vector<NamedPoints> many = manyPoints();
  const ConstraintCase crossing = randomSegments(2000, 300);
  for (const HostMode& mode : twoModes())
  {
    HostExecutor executor(3, mode);
    Way way = wayIn(mode);
    way.executor = &executor;
    std::size_t cancelled = 0;
    const auto call = way.call;
    way.call = [&](const std::function<Status()>& work)
    {
      const Status status = call(work);
      cancelled += status == Status::Cancelled;
      return status;
    };
    for (std::size_t at = 1; at < 40; at += 9)
    {
      HostProgress progress(mode, at);
      way.progress = &progress;
      hashOfVoronoi(viewOf(many[at % many.size()]), way);
      HostProgress another(mode, at);
      way.progress = &another;
      hashOfConstrained(crossing, FillRule::EvenOdd, way);
      HostProgress third(mode, at);
      way.progress = &third;
      hashOfSplit(crossing, way);
    }
    EXPECT_GE(cancelled, 8u);
    EXPECT_FALSE(executor.lost()) << mode.name;
  }
}

TEST(HashesInHosts, ModesArePutBackWhereMemoryRunsOut)
{
  const std::vector<NamedPoints> many = manyPoints();
  const ConstraintCase crossing = randomSegments(500, 100);
  for (const HostMode& mode : twoModes())
  {
    HostExecutor executor(3, mode);
    Way way = wayIn(mode);
    way.executor = &executor;
    const auto call = way.call;
    std::size_t allocations = 0; // before they fail
    std::size_t failed = 0;
    way.call = [&](const std::function<Status()>& work)
    {
      const auto failing = [&]
      {
        account.failAt = account.allocations + allocations + 1;
        const Status result = work();
        account.failAt = 0;
        return result;
      };
      const Status status = call(failing);
      failed += status == Status::OutOfMemory;
      return status;
    };
    for (; allocations < 60; allocations += 12)
    {
      hashOfVoronoi(viewOf(many[0]), way);
      hashOfMerged(viewOf(many[1]), way);
      hashOfConstrained(crossing, FillRule::EvenOdd, way);
      hashOfSplit(crossing, way);
    }
    EXPECT_GE(failed, 10u);
    EXPECT_FALSE(executor.lost()) << mode.name;
  }
}

} // namespace
} // namespace test
} // namespace ahd
