// SPDX-License-Identifier: BSD-3-Clause
//
// The engine's own threads: each task once, the calling thread among the workers and never held up
// by the others.
#include "Core/Processors.h"
#include "Core/Threads.h"

#include "HostModes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <fstream>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace ahd
{
namespace test
{
namespace
{

const auto kNothing = [] {};

/// Runs `count` tasks and expects each to be called once.
void expectEachTaskOnce(Threads& executor, std::size_t count)
{
  std::vector<std::atomic<int>> calls(count);
  for (auto& c : calls)
  {
    c = 0;
  }
  executor.run(
    count, [&](std::size_t i) { ++calls[i]; }, kNothing);
  for (std::size_t i = 0; i < count; ++i)
  {
    ASSERT_EQ(calls[i], 1) << "task " << i << " of " << count;
  }
}

/// Waits, but not for ever, until `done`.
template <typename Done>
void waitUntil(const Done& done)
{
  for (int i = 0; i < 20000 && !done(); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// What idle() throws is thrown when all tasks have returned, and not before.
TEST(OwnThreads, ExceptionsOfIdleWaitForTheTasks)
{
  Threads executor(2);
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> isBegun{ false }, isThrown{ false }, isDone{ false };
  const auto task = [&](std::size_t)
  {
    if (std::this_thread::get_id() == caller)
    {
      waitUntil([&] { return isBegun.load(); });
      return;
    }
    isBegun = true;
    waitUntil([&] { return isThrown.load(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    isDone = true;
  };
  const auto idle = [&]
  {
    isThrown = true;
    throw std::runtime_error("enough");
  };
  EXPECT_THROW(executor.run(2, task, idle), std::runtime_error);
  EXPECT_TRUE(isDone);
  expectEachTaskOnce(executor, 10);
}

TEST(OwnThreads, CallEachTaskOnceWithAnyNumberOfThreads)
{
  for (unsigned threads : { 0u, 1u, 2u, 3u, 8u, 40u })
  {
    Threads executor(threads);
    EXPECT_EQ(executor.threads(), threads == 0 ? 1 : threads);
    for (std::size_t count : { 0, 1, 2, 3, 7, 1000, 1, 100 })
    {
      expectEachTaskOnce(executor, count);
    }
  }
}

TEST(OwnThreads, ManyShortJobsInARow)
{
  Threads executor(3);
  for (int job = 0; job < 3000; ++job)
  {
    expectEachTaskOnce(executor, 4);
  }
}

TEST(OwnThreads, UseMoreThanOneThread)
{
  Threads executor(2);
  std::mutex lock;
  std::set<std::thread::id> seen;
  const auto both = [&]
  {
    const std::lock_guard<std::mutex> locked(lock);
    return seen.size() > 1;
  };
  const auto task = [&](std::size_t)
  {
    {
      const std::lock_guard<std::mutex> locked(lock);
      seen.insert(std::this_thread::get_id());
    }
    waitUntil(both);
  };
  executor.run(2, task, kNothing);
  EXPECT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen.count(std::this_thread::get_id()), 1u) << "the calling thread did nothing";
  EXPECT_EQ(executor.used(), 2u);
}

TEST(OwnThreads, AskOnTheCallingThreadWhileOthersWork)
{
  Threads executor(2);
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> otherBegan{ false };
  std::atomic<int> asked{ 0 };
  const auto task = [&](std::size_t)
  {
    if (std::this_thread::get_id() == caller)
    {
      waitUntil([&] { return otherBegan.load(); });
      return;
    }
    otherBegan = true;
    waitUntil([&] { return asked > 3; });
  };
  const auto idle = [&]
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    ++asked;
  };
  executor.run(2, task, idle);
  EXPECT_GT(asked, 3);
}

TEST(OwnThreads, OneTaskAndOneThreadStartNothing)
{
  Threads one(1);
  expectEachTaskOnce(one, 100);
  EXPECT_EQ(one.used(), 1u);
  Threads many(8);
  expectEachTaskOnce(many, 1);
  EXPECT_EQ(many.used(), 1u);
}

TEST(OwnThreads, WorkInsideATaskOfOthers)
{
  std::atomic<int> tasks{ 0 };
  const auto outer = [&](std::size_t)
  {
    Threads executor(3);
    executor.run(
      50, [&](std::size_t) { ++tasks; }, kNothing);
  };
  Threads others(2);
  others.run(20, outer, kNothing);
  EXPECT_EQ(tasks, 1000);
}

TEST(OwnThreads, SeveralAtATime)
{
  std::vector<std::thread> users;
  users.reserve(4);
  for (int user = 0; user < 4; ++user)
  {
    users.emplace_back(
      []
      {
        Threads executor(3);
        for (int job = 0; job < 200; ++job)
        {
          expectEachTaskOnce(executor, 20);
        }
      });
  }
  for (std::thread& user : users)
  {
    user.join();
  }
}

TEST(OwnThreads, ComputeAsTheEngineAssumesWhateverTheHostSet)
{
  for (const HostMode& mode : hostModes())
  {
    std::atomic<int> asTheHost{ 0 };
    enter(mode);
    {
      Threads executor(3); // new threads have the arithmetic of the one that starts them
      for (int job = 0; job < 20; ++job)
      {
        executor.run(
          6, [&](std::size_t) { asTheHost += isIn(mode) ? 1 : 0; }, kNothing);
      }
    }
    const bool isKept = isIn(mode);
    leaveHostMode();
    EXPECT_EQ(asTheHost, 0) << mode.name;
    EXPECT_TRUE(isKept) << mode.name;
  }
}

TEST(OwnThreads, ThereIsAProcessor)
{
  EXPECT_GE(availableProcessors(), 1u);
}

#if defined(__linux__)
TEST(OwnThreads, ProcessorsAreThoseOfTheProcess)
{
  cpu_set_t before;
  ASSERT_EQ(sched_getaffinity(0, sizeof(before), &before), 0);
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int i = 0; CPU_COUNT(&one) == 0; ++i)
  {
    if (CPU_ISSET(i, &before))
    {
      CPU_SET(i, &one);
    }
  }
  EXPECT_EQ(availableProcessors(), unsigned(CPU_COUNT(&before)));
  ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
  EXPECT_EQ(availableProcessors(), 1u);
  ASSERT_EQ(sched_setaffinity(0, sizeof(before), &before), 0);
}

TEST(OwnThreads, ThreadsThatCannotBeHadAreDoneWithout)
{
  // Each thread needs address space for its stack, and there is room for a few only.
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit few = before;
  few.rlim_cur = pages * std::size_t(sysconf(_SC_PAGESIZE)) + (std::size_t(40) << 20);
  ASSERT_EQ(setrlimit(RLIMIT_AS, &few), 0);
  {
    Threads executor(1024);
    expectEachTaskOnce(executor, 5000);
    EXPECT_LT(executor.used(), 1024u);
  }
  setrlimit(RLIMIT_AS, &before);
}
#endif

} // namespace
} // namespace test
} // namespace ahd
