// SPDX-License-Identifier: BSD-3-Clause
//
// The threads that the filter lends to the engine: each task once, the calling thread among the
// workers and never held up by the others, with every backend of vtkSMPTools.
#include "Pipeline/vtkAHDExecutor.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <fstream>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace
{
const auto kNothing = [] {};

/// The backends that can be chosen here.
std::vector<std::string> backends()
{
  const std::string before = vtkSMPTools::GetBackend();
  std::vector<std::string> found;
  for (const char* name : { "Sequential", "STDThread", "TBB", "OpenMP" })
  {
    testing::internal::CaptureStderr(); // VTK complains of those it has not
    if (vtkSMPTools::SetBackend(name))
    {
      found.push_back(name);
    }
    testing::internal::GetCapturedStderr();
  }
  vtkSMPTools::SetBackend(before.c_str());
  return found;
}

/// Chooses a backend while it lives.
class Backend
{
public:
  explicit Backend(const std::string& name)
    : Before(vtkSMPTools::GetBackend())
  {
    vtkSMPTools::SetBackend(name.c_str());
  }
  ~Backend()
  {
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(this->Before.c_str());
  }

private:
  const std::string Before;
};

/// Runs `count` tasks and expects each to be called once.
void expectEachTaskOnce(vtkAHDExecutor& executor, std::size_t count)
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
}

TEST(Executor, CallsEachTaskOnceWithAnyNumberOfThreads)
{
  for (const std::string& name : backends())
  {
    SCOPED_TRACE(name);
    Backend backend(name);
    for (unsigned threads : { 0u, 1u, 2u, 3u, 8u, 40u })
    {
      vtkAHDExecutor executor(threads);
      EXPECT_EQ(executor.threads(), threads == 0 ? 1 : threads);
      for (std::size_t count : { 0, 1, 2, 3, 7, 1000, 1, 100 })
      {
        expectEachTaskOnce(executor, count);
      }
    }
  }
}

TEST(Executor, ManyShortJobsInARow)
{
  for (const std::string& name : backends())
  {
    SCOPED_TRACE(name);
    Backend backend(name);
    vtkAHDExecutor executor(3);
    for (int job = 0; job < 3000; ++job)
    {
      expectEachTaskOnce(executor, 4);
    }
  }
}

TEST(Executor, UsesMoreThanOneThreadWithTheSequentialBackendToo)
{
  for (const std::string& name : backends())
  {
    SCOPED_TRACE(name);
    Backend backend(name);
    vtkAHDExecutor executor(2);
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
    EXPECT_EQ(executor.GetThreadsUsed(), 2u);
    EXPECT_EQ(vtkSMPTools::GetBackend(), name);
  }
}

TEST(Executor, AsksOnTheCallingThreadWhileOthersWork)
{
  for (const std::string& name : backends())
  {
    SCOPED_TRACE(name);
    Backend backend(name);
    vtkAHDExecutor executor(2);
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
}

TEST(Executor, OneTaskAndOneThreadStartNothing)
{
  vtkAHDExecutor one(1);
  expectEachTaskOnce(one, 100);
  EXPECT_EQ(one.GetThreadsUsed(), 1u);
  vtkAHDExecutor many(8);
  expectEachTaskOnce(many, 1);
  EXPECT_EQ(many.GetThreadsUsed(), 1u);
}

TEST(Executor, WorksInsideALoopOfVtkSMPTools)
{
  for (const std::string& name : backends())
  {
    SCOPED_TRACE(name);
    Backend backend(name);
    std::atomic<int> tasks{ 0 };
    const auto inner = [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        vtkAHDExecutor executor(3);
        executor.run(
          50, [&](std::size_t) { ++tasks; }, kNothing);
      }
    };
    vtkSMPTools::For(0, 20, 1, inner);
    EXPECT_EQ(tasks, 1000);
  }
}

TEST(Executor, SeveralAtATime)
{
  for (const std::string& name : backends())
  {
    SCOPED_TRACE(name);
    Backend backend(name);
    std::vector<std::thread> users;
    for (int user = 0; user < 4; ++user)
    {
      users.emplace_back(
        []
        {
          vtkAHDExecutor executor(3);
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
}

TEST(Executor, NumberOfThreadsAsWished)
{
  EXPECT_EQ(vtkAHDThreadsToUse(1), 1u);
  EXPECT_EQ(vtkAHDThreadsToUse(5), 5u);
  EXPECT_EQ(vtkAHDThreadsToUse(1000000), 1024u);
}

TEST(Executor, NumberOfThreadsKeepsToWhatVtkSMPToolsWasTold)
{
  for (const std::string& name : backends())
  {
    SCOPED_TRACE(name);
    Backend backend(name);
    const unsigned all = vtkAHDThreadsToUse(0);
    EXPECT_LE(all, std::thread::hardware_concurrency());
    vtkSMPTools::Initialize(1);
    EXPECT_EQ(vtkAHDThreadsToUse(0), 1u);
    EXPECT_EQ(vtkAHDThreadsToUse(3), 3u) << "what the user asks for counts more";
    vtkSMPTools::Initialize(2);
    EXPECT_EQ(vtkAHDThreadsToUse(0), std::min(all, 2u));
  }
}

#if defined(__linux__)
TEST(Executor, NumberOfThreadsKeepsToTheEnvironment)
{
  Backend backend("Sequential"); // others read it once, when they start
  const char* set = std::getenv("VTK_SMP_MAX_THREADS");
  const std::string before = set ? set : "";
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  EXPECT_EQ(vtkAHDThreadsToUse(0), 1u);
  setenv("VTK_SMP_MAX_THREADS", "nonsense", 1);
  EXPECT_GE(vtkAHDThreadsToUse(0), 1u);
  setenv("VTK_SMP_MAX_THREADS", "-4", 1);
  EXPECT_GE(vtkAHDThreadsToUse(0), 1u);
  set ? setenv("VTK_SMP_MAX_THREADS", before.c_str(), 1) : unsetenv("VTK_SMP_MAX_THREADS");
}

TEST(Executor, NumberOfThreadsKeepsToTheProcessorsOfTheProcess)
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
  for (const std::string& name : backends())
  {
    Backend backend(name);
    ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
    EXPECT_EQ(vtkAHDThreadsToUse(0), 1u) << name;
    ASSERT_EQ(sched_setaffinity(0, sizeof(before), &before), 0);
  }
}

TEST(Executor, ThreadsThatCannotBeHadAreDoneWithout)
{
  // Each thread wants address space for its stack, and there is room for a few only.
  Backend backend("Sequential");
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit few = before;
  few.rlim_cur = pages * std::size_t(sysconf(_SC_PAGESIZE)) + (std::size_t(40) << 20);
  ASSERT_EQ(setrlimit(RLIMIT_AS, &few), 0);
  {
    vtkAHDExecutor executor(1024);
    expectEachTaskOnce(executor, 5000);
    EXPECT_LT(executor.GetThreadsUsed(), 1024u);
  }
  setrlimit(RLIMIT_AS, &before);
}
#endif
