// SPDX-License-Identifier: BSD-3-Clause
//
// Memory runs out at any allocation of any entry point, once or for good: the status reports it,
// nothing is thrown or leaked, and the object works like a new one. This program's operator new
// fails on demand.
#include "FaultsSession.h"
#include "Job/Messages.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

/// Lets a call of the engine fail, and nothing else.
Status callFailing(const Session::Call& call)
{
  account.countsNothing = false;
  const Status status = call();
  account.countsNothing = true;
  return status;
}

/// A session whose allocation number `k` fails, from 1; 0: none.
Status runFailing(Session& session, Engine& t, std::size_t k, Executor* executor)
{
  t.reclaim();
  account.countsNothing = true;
  account.allocations = 0;
  account.failures = 0;
  account.failAt = k;
  Helpers helpers;
  helpers.executor = executor;
  const Status status = session.run(t, callFailing, helpers);
  account.failAt = 0;
  account.countsNothing = false;
  return status;
}

/// Fails at so many allocations at most, evenly spread, on one object.
void expectSurvived(
  const ConstraintCase& given, const Options& options, std::size_t most, Executor* executor)
{
  const std::size_t before = account.blocks;
  {
    Engine fresh;
    Session expected(given, options);
    ASSERT_EQ(runFailing(expected, fresh, 0, executor), Status::Ok);
    const std::size_t all = account.allocations;
    ASSERT_GT(all, 50u) << "the engine no longer allocates through operator new";
    const std::size_t step = 1 + all / most;
    Engine reused;
    for (std::size_t k = 1; k <= all; k += step)
    {
      account.failsOnce = k / step % 2 == 0;
      reused.release();
      Session session(given, options);
      const Status status = runFailing(session, reused, k, executor);
      // With threads there may be fewer allocations once; alone there are not.
      const bool hasFailed = account.failures > 0;
      ASSERT_TRUE(hasFailed || executor) << "allocation " << k << " of " << all;
      ASSERT_EQ(status, hasFailed ? Status::OutOfMemory : Status::Ok)
        << "allocation " << k << " of " << all;
      Session again(given, options);
      ASSERT_EQ(runFailing(again, reused, 0, executor), Status::Ok) << "after allocation " << k;
      ASSERT_TRUE(again.bytes() == expected.bytes()) << "after allocation " << k;
    }
  }
  EXPECT_EQ(account.blocks, before) << "something leaked";
}

void expectSurvivedUnderEverySetting(std::size_t most)
{
  ThreadExecutor threads(3);
  std::uint64_t seed = 0;
  for (const Options& options : everyDistinctSetting({ 50 }))
  {
    SCOPED_TRACE(describe(options));
    expectSurvived(
      chainsThrough(Distribution::RepeatedDraws, 100, 6, ++seed), options, most, nullptr);
    expectSurvived(
      chainsThrough(Distribution::Uniform, reduced(5000), 12, ++seed), options, 4, &threads);
  }
}

TEST(FaultsMemory, AnyAllocationOfAnyEntryPoint)
{
  expectSurvived(
    chainsThrough(Distribution::RepeatedDraws, 100, 6, 1), Options(), std::size_t(-1), nullptr);
}

TEST(FaultsMemory, SomeAllocationsUnderEverySetting)
{
  expectSurvivedUnderEverySetting(10);
}

TEST(FaultsMemory, AnyAllocationWhereAllPointsAreCollinear)
{
  expectSurvived(
    chainsThrough(Distribution::Collinear, 100, 3, 1), Options(), std::size_t(-1), nullptr);
}

/// The text, or empty where memory ran out.
std::string sayFailing(const Facts& facts, std::size_t k)
{
  account.allocations = 0;
  account.failAt = k;
  std::string text;
  try
  {
    text = messages(Topic::Refusal, Wording::Class, facts).at(0).text;
  }
  catch (const std::bad_alloc&)
  {
  }
  account.failAt = 0;
  return text;
}

TEST(FaultsMemory, AMessageIsWholeOrNone)
{
  const Facts facts{ { "raster", "bounds" }, { "bounds", 0.1 }, { "bounds", -1.23456789e-300 },
    { "bounds", 2.0 / 3.0 }, { "bounds", 1e300 } };
  const std::string whole = sayFailing(facts, 0);
  const std::size_t all = account.allocations;
  ASSERT_GT(all, 5u);
  account.failsOnce = true;
  for (std::size_t k = 1; k <= all; ++k)
  {
    const std::string said = sayFailing(facts, k);
    EXPECT_TRUE(said.empty() || said == whole) << "allocation " << k << ": " << said;
  }
}

TEST(LongFaultsMemory, AnyAllocationUnderEverySetting)
{
  expectSurvivedUnderEverySetting(std::size_t(-1));
}

TEST(LongFaultsMemory, AThousandAllocationsOfLargeInputs)
{
  ThreadExecutor threads(3);
  for (const Distribution distribution : { Distribution::Uniform, Distribution::Lattice,
         Distribution::NestedClusters, Distribution::OnCircle, Distribution::RepeatedDraws })
  {
    SCOPED_TRACE(nameOf(distribution));
    const ConstraintCase given = chainsThrough(distribution, 100000, 60, 1);
    expectSurvived(given, Options(), 100, nullptr);
    expectSurvived(given, Options(), 100, &threads);
  }
}

} // namespace
} // namespace test
} // namespace ahd
