// SPDX-License-Identifier: BSD-3-Clause
//
// Several threads and a failure: the caller cancels, or memory runs out in a task. This program's
// operator new fails on demand.
#include "Core/Border.h"
#include "Core/Progress.h"
#include "Core/Tasks.h"

#include "EngineRun.h"
#include "Executors.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <initializer_list>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

namespace ahd
{
namespace test
{
namespace
{

std::vector<Point> somePoints(Distribution distribution)
{
  return makePoints(distribution, reduced(100000) == 100000 ? 100000 : 34000, 1);
}

/// Records violations of the rules of Progress.h, and cancels at one poll if set.
class Listener : public Progress
{
public:
  explicit Listener(std::size_t cancelAt = 0)
    : cancelAt_(cancelAt)
  {
  }

  void beginPhase(Phase phase) override
  {
    check(true, 0.0);
    phase_ = phase;
    fraction_ = 0.0;
  }

  bool advance(Phase phase, double fraction) override
  {
    check(phase == phase_, fraction);
    fraction_ = fraction;
    cancelled_ = ++askings_ == cancelAt_;
    return !cancelled_;
  }

  std::size_t askings() const { return askings_; }
  const std::string& faults() const { return faults_; }

private:
  void check(bool isPhase, double fraction)
  {
    faults_ += isPhase ? "" : "asked in another phase\n";
    faults_ += fraction == 0.0 || fraction >= fraction_ ? "" : "the fraction falls\n";
    faults_ += fraction <= 1.0 ? "" : "the fraction passes 1\n";
    faults_ += cancelled_ ? "heard of after cancelling\n" : "";
    faults_ += thread_ == std::this_thread::get_id() ? "" : "asked from another thread\n";
  }

  std::size_t cancelAt_;
  std::size_t askings_ = 0;
  Phase phase_ = Phase::Outputs;
  double fraction_ = 0.0;
  bool cancelled_ = false;
  std::thread::id thread_ = std::this_thread::get_id();
  std::string faults_;
};

/// run(), writeTriangles() and writePointStatus() until one is not Ok.
Status attempt(Engine& engine, const std::vector<Point>& points, Outcome& outcome,
  Progress* progress, Executor* executor)
{
  const PointView view = viewOf(points);
  Status status = engine.run(view, Options(), progress, executor);
  if (status != Status::Ok)
  {
    EXPECT_EQ(engine.report().triangles, 0u);
    return status;
  }
  EXPECT_EQ(3 * engine.report().triangles, outcome.triples.size());
  status = engine.writeTriangles(outcome.triples.data(), progress, executor);
  return status != Status::Ok
    ? status
    : engine.writePointStatus(outcome.pointStatus.data(), progress, executor);
}

/// Moments at which a run is cancelled: fewer under sanitizers.
std::size_t someOf(std::size_t moments)
{
  return reduced(2000) == 2000 ? moments : moments / 5;
}

void expectCancelledAnywhere(Distribution distribution, Executor& executor, std::size_t moments)
{
  const std::vector<Point> points = somePoints(distribution);
  const Outcome expected = triangulate(points);
  Outcome outcome = expected;
  Engine engine;
  Listener whole;
  ASSERT_EQ(attempt(engine, points, outcome, &whole, &executor), Status::Ok);
  EXPECT_EQ(whole.faults(), "");
  const std::size_t step = 1 + whole.askings() / moments;
  for (std::size_t k = 1; k <= whole.askings(); k += step)
  {
    Listener listener(k);
    const Status status = attempt(engine, points, outcome, &listener, &executor);
    // The number of polls depends on the threads' speeds: the k-th may not come.
    ASSERT_EQ(status, listener.askings() < k ? Status::Ok : Status::Cancelled) << "asking " << k;
    ASSERT_EQ(listener.faults(), "") << "cancelled at asking " << k;
    ASSERT_LE(listener.askings(), k);
  }
  ASSERT_EQ(attempt(engine, points, outcome, nullptr, &executor), Status::Ok);
  EXPECT_TRUE(outcome.triples == expected.triples) << "after being cancelled";
  EXPECT_TRUE(outcome.pointStatus == expected.pointStatus) << "after being cancelled";
}

TEST(ThreadsTrouble, CancelledAtManyMoments)
{
  ThreadExecutor together(3);
  BackwardExecutor backward(4);
  ElsewhereExecutor elsewhere(2);
  expectCancelledAnywhere(Distribution::Uniform, together, someOf(100));
  if (!kOnlyThreadsMatter)
  {
    expectCancelledAnywhere(Distribution::Uniform, backward, someOf(100));
  }
  expectCancelledAnywhere(Distribution::Uniform, elsewhere, someOf(40));
}

TEST(ThreadsTrouble, CancelledAtManyMomentsOfAwkwardInput)
{
  ThreadExecutor executor(3);
  for (const Distribution distribution : { Distribution::NestedClusters, Distribution::Lattice,
         Distribution::OnCircle, Distribution::OnParabola, Distribution::Collinear,
         Distribution::RepeatedDraws, Distribution::AllEqual })
  {
    SCOPED_TRACE(nameOf(distribution));
    expectCancelledAnywhere(distribution, executor, someOf(20));
  }
}

/// Fails the k-th allocation and all that follow, for every k, until a run succeeds.
void expectOutOfMemoryIsSurvived(Distribution distribution, Executor& executor)
{
  const std::vector<Point> points = somePoints(distribution);
  const Outcome expected = triangulate(points);
  Outcome outcome = expected;
  Engine engine;
  for (std::size_t k = 1; k < 10000; ++k)
  {
    account.failAt = account.allocations + k;
    const Status status = attempt(engine, points, outcome, nullptr, &executor);
    account.failAt = 0;
    if (status == Status::Ok)
    {
      EXPECT_GT(k, 5u) << "the engine no longer allocates through operator new";
      EXPECT_TRUE(outcome.triples == expected.triples) << "after " << k << " failures";
      EXPECT_TRUE(outcome.pointStatus == expected.pointStatus) << "after " << k << " failures";
      return;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "at allocation " << k;
  }
  FAIL() << "no run got through";
}

/// inParallel() throws what its tasks throw, of any type and on any thread.
template <typename Exception>
void expectThrown(Executor& executor, const Exception& thrown)
{
  for (std::size_t from = 0; from < 40; from += 13)
  {
    Listener listener;
    std::atomic<std::size_t> begun{ 0 };
    bool isCaught = false;
    try
    {
      Ticker ticker(&listener, Phase::Merge, 0, &executor);
      inParallel(ticker, 40,
        [&](std::size_t task, Ticker&)
        {
          ++begun;
          if (task >= from)
          {
            throw thrown;
          }
          return true;
        });
    }
    catch (const Exception& caught)
    {
      isCaught = true;
      EXPECT_STREQ(caught.what(), thrown.what());
    }
    EXPECT_TRUE(isCaught);
    EXPECT_LE(begun, 40u);
  }
}

TEST(ThreadsTrouble, ExceptionsOfTasksReachTheCaller)
{
  BackwardExecutor backward(3);
  ThreadExecutor together(3);
  ElsewhereExecutor elsewhere(2);
  for (Executor* executor : std::initializer_list<Executor*>{ &backward, &together, &elsewhere })
  {
    expectThrown(*executor, std::bad_alloc());
    expectThrown(*executor, std::length_error("too long"));
    expectThrown(*executor, std::runtime_error("something else"));
    const Status status = unlessCancelled(
      [&]
      {
        Ticker ticker(nullptr, Phase::Merge, 0, executor);
        return inParallel(
          ticker, 8, [](std::size_t, Ticker&) -> bool { throw std::length_error("too long"); });
      });
    EXPECT_EQ(status, Status::OutOfMemory);
  }
}

TEST(ThreadsTrouble, OutOfMemoryAtAnyAllocation)
{
  BackwardExecutor backward(3);
  ThreadExecutor together(3);
  if (!kOnlyThreadsMatter)
  {
    expectOutOfMemoryIsSurvived(Distribution::Uniform, backward);
  }
  expectOutOfMemoryIsSurvived(Distribution::RepeatedDraws, together);
  if (someOf(2) == 2)
  {
    expectOutOfMemoryIsSurvived(Distribution::Uniform, together);
    expectOutOfMemoryIsSurvived(Distribution::NestedClusters, backward);
  }
}

} // namespace
} // namespace test
} // namespace ahd
