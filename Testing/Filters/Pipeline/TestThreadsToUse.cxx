// SPDX-License-Identifier: BSD-3-Clause
//
// The number of threads that the filter uses, with every backend of vtkSMPTools. The threads
// themselves are the engine's (Testing/Engine/Core).
#include "Pipeline/vtkAHDThreads.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif

namespace
{
/// The backends that can be chosen here.
std::vector<std::string> backends()
{
  const std::string before = vtkSMPTools::GetBackend();
  std::vector<std::string> found;
  for (const char* name : { "Sequential", "STDThread", "TBB", "OpenMP" })
  {
    testing::internal::CaptureStderr(); // VTK reports those that it lacks
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
}

TEST(ThreadsToUse, NumberOfThreadsAsWished)
{
  EXPECT_EQ(vtkAHDThreadsToUse(1), 1u);
  EXPECT_EQ(vtkAHDThreadsToUse(5), 5u);
  EXPECT_EQ(vtkAHDThreadsToUse(1000000), 1024u);
}

TEST(ThreadsToUse, NumberOfThreadsKeepsToWhatVtkSMPToolsWasTold)
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
TEST(ThreadsToUse, NumberOfThreadsKeepsToTheEnvironment)
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

TEST(ThreadsToUse, NumberOfThreadsKeepsToTheProcessorsOfTheProcess)
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
#endif
