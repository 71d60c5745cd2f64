// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDExecutor.h"

#include "Engine/Core/FloatingPoint.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif

namespace
{
constexpr int kMostThreads = 1024;

/// Between two calls of idle(): short for a hand on a button, long for a processor.
constexpr std::chrono::milliseconds kIdle(3);

bool IsSequential()
{
  return std::strcmp(vtkSMPTools::GetBackend(), "Sequential") == 0;
}

/// Processors that this process may run on; at least 1.
int CountProcessors()
{
#if defined(__linux__)
  cpu_set_t allowed; // of 1024 processors: where there are more, the call fails
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0)
  {
    return std::max(1, CPU_COUNT(&allowed));
  }
#endif
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// The most threads that vtkSMPTools was told to take. The Sequential backend answers 1 whatever it
/// was told, so there the wishes are looked up, with vtkSMPTools' own precedence.
int GetLimit()
{
  if (!IsSequential())
  {
    return std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  }
  const int told =
    vtk::detail::smp::vtkSMPToolsAPI::GetInstance().GetInternalDesiredNumberOfThread();
  const char* environment = std::getenv("VTK_SMP_MAX_THREADS");
  const int limit = told > 0 ? told : environment ? std::atoi(environment) : 0;
  return limit > 0 ? limit : kMostThreads;
}
}

unsigned vtkAHDThreadsToUse(int wished)
{
  if (wished > 0)
  {
    return static_cast<unsigned>(std::min(wished, kMostThreads));
  }
  if (vtkSMPTools::IsParallelScope() && !vtkSMPTools::GetNestedParallelism())
  {
    return 1;
  }
  return static_cast<unsigned>(std::min({ CountProcessors(), GetLimit(), kMostThreads }));
}

/// Threads that wait for jobs. A job is a number of tasks; the calling thread brings it, works on
/// it as well, and waits only for those who took a task of it: a thread that comes late, or never,
/// holds nobody up.
class vtkAHDExecutor::Crew
{
public:
  explicit Crew(unsigned size);
  ~Crew();

  /// The threads that were started, or asked for from vtkSMPTools.
  unsigned GetSize() const { return this->Size; }

  void Run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle);

private:
  void Start(unsigned count, const std::function<void()>& work);
  void Serve();
  void TakeTasks(std::size_t count, const std::function<void(std::size_t)>& task);

  unsigned Size = 0;
  std::vector<std::thread> Started;
  std::mutex Lock; // of all that follows but Next
  std::condition_variable Called;
  std::condition_variable Finished;
  bool Over = false;
  std::uint64_t Job = 0;                                  // counts the jobs
  const std::function<void(std::size_t)>* Task = nullptr; // of the job; null if there is none
  std::size_t Count = 0;                                  // of its tasks
  unsigned AtWork = 0;                                    // threads of the crew that are in the job
  std::atomic<std::size_t> Next{ 0 };                     // task of the job
};

vtkAHDExecutor::Crew::Crew(unsigned size)
{
  if (IsSequential() || vtkSMPTools::IsParallelScope())
  {
    this->Start(size, [this] { this->Serve(); });
    this->Size = static_cast<unsigned>(this->Started.size());
    return;
  }
  // vtkSMPTools::For returns only when the crew is dismissed, so it has a thread of its own, which
  // some backends make use of. One that has fewer threads calls Serve() for the rest afterwards.
  const auto lend = [this, size]
  {
    const auto serve = [this](vtkIdType, vtkIdType) { this->Serve(); };
    try
    {
      vtkSMPTools::For(0, static_cast<vtkIdType>(size), 1, serve);
    }
    catch (const std::exception&)
    {
      // no threads to be had: the caller does it alone
    }
  };
  this->Start(1, lend);
  this->Size = this->Started.empty() ? 0 : size;
}

vtkAHDExecutor::Crew::~Crew()
{
  {
    const std::lock_guard<std::mutex> locked(this->Lock);
    this->Over = true;
  }
  this->Called.notify_all();
  for (std::thread& thread : this->Started)
  {
    thread.join();
  }
}

/// Starts as many of `count` threads as can be had.
void vtkAHDExecutor::Crew::Start(unsigned count, const std::function<void()>& work)
{
  try
  {
    this->Started.reserve(count);
    while (this->Started.size() < count)
    {
      this->Started.emplace_back(work);
    }
  }
  catch (const std::exception&)
  {
    // std::system_error or std::bad_alloc: go on with those there are
  }
}

void vtkAHDExecutor::Crew::Serve()
{
  std::uint64_t seen = 0;
  std::unique_lock<std::mutex> locked(this->Lock);
  for (;;)
  {
    this->Called.wait(locked, [&] { return this->Over || (this->Task && this->Job != seen); });
    if (this->Over)
    {
      return;
    }
    seen = this->Job;
    const auto& task = *this->Task;
    const std::size_t count = this->Count;
    ++this->AtWork;
    locked.unlock();
    this->TakeTasks(count, task);
    locked.lock();
    if (--this->AtWork == 0)
    {
      this->Finished.notify_one();
    }
  }
}

void vtkAHDExecutor::Crew::TakeTasks(
  std::size_t count, const std::function<void(std::size_t)>& task)
{
  const ahd::ScopedFloatingPoint asTheEngine; // whatever threads that are lent were left with
  for (std::size_t i = this->Next++; i < count; i = this->Next++)
  {
    task(i);
  }
}

void vtkAHDExecutor::Crew::Run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  {
    const std::lock_guard<std::mutex> locked(this->Lock);
    ++this->Job;
    this->Task = &task;
    this->Count = count;
    this->Next = 0;
  }
  this->Called.notify_all();
  this->TakeTasks(count, task);
  std::unique_lock<std::mutex> locked(this->Lock);
  this->Task = nullptr; // who comes now comes too late
  while (!this->Finished.wait_for(locked, kIdle, [this] { return this->AtWork == 0; }))
  {
    locked.unlock();
    idle();
    locked.lock();
  }
}

vtkAHDExecutor::vtkAHDExecutor(unsigned threads)
  : Threads(std::max(1u, threads))
{
}

vtkAHDExecutor::~vtkAHDExecutor() = default;

unsigned vtkAHDExecutor::GetThreadsUsed() const
{
  return this->Others ? 1 + this->Others->GetSize() : 1;
}

void vtkAHDExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  if (count > 1 && this->Threads > 1 && !this->Others)
  {
    this->Others.reset(new Crew(this->Threads - 1));
  }
  if (count > 1 && this->Others)
  {
    this->Others->Run(count, task, idle);
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    task(i);
  }
}
