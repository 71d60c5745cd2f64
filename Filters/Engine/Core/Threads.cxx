// SPDX-License-Identifier: BSD-3-Clause
#include "Threads.h"

#include "FloatingPoint.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace ahd
{
namespace
{

/// Between two calls of idle(): short for a user, long for a processor.
constexpr std::chrono::milliseconds kIdle(3);

} // namespace

/// Threads that wait for jobs. A job is a number of tasks; the calling thread posts it, works on it
/// as well, and waits only for threads that took a task of it: a thread that comes late, or never,
/// delays nothing.
class Threads::Crew
{
public:
  /// Starts `size` threads, or as many as the system grants.
  explicit Crew(unsigned size);
  ~Crew();

  /// The threads that were started.
  unsigned size() const { return static_cast<unsigned>(started_.size()); }

  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle);

private:
  void serve();
  void takeTasks(std::size_t count, const std::function<void(std::size_t)>& task);

  std::vector<std::thread> started_;
  std::mutex mutex_; ///< guards all members below but next_
  std::condition_variable called_;
  std::condition_variable finished_;
  bool over_ = false;
  std::uint64_t job_ = 0;                                  ///< counts the jobs
  const std::function<void(std::size_t)>* task_ = nullptr; ///< of the job; null if there is none
  std::size_t count_ = 0;                                  ///< of its tasks
  unsigned atWork_ = 0;                ///< threads of the crew that are in the job
  std::atomic<std::size_t> next_{ 0 }; ///< task of the job
};

Threads::Crew::Crew(unsigned size)
{
  try
  {
    started_.reserve(size);
    while (started_.size() < size)
    {
      started_.emplace_back([this] { serve(); });
    }
  }
  catch (const std::exception&)
  {
    // std::system_error or std::bad_alloc: go on with those there are
  }
}

Threads::Crew::~Crew()
{
  {
    const std::lock_guard<std::mutex> locked(mutex_);
    over_ = true;
  }
  called_.notify_all();
  for (std::thread& thread : started_)
  {
    thread.join();
  }
}

void Threads::Crew::serve()
{
  std::uint64_t seen = 0;
  std::unique_lock<std::mutex> locked(mutex_);
  for (;;)
  {
    called_.wait(locked, [&] { return over_ || (task_ && job_ != seen); });
    if (over_)
    {
      return;
    }
    seen = job_;
    const auto& task = *task_;
    const std::size_t count = count_;
    ++atWork_;
    locked.unlock();
    takeTasks(count, task);
    locked.lock();
    if (--atWork_ == 0)
    {
      finished_.notify_one();
    }
  }
}

void Threads::Crew::takeTasks(std::size_t count, const std::function<void(std::size_t)>& task)
{
  const ScopedFloatingPoint asAssumed; // new threads inherit that of the thread that started them
  for (std::size_t i = next_++; i < count; i = next_++)
  {
    task(i);
  }
}

void Threads::Crew::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  {
    const std::lock_guard<std::mutex> locked(mutex_);
    ++job_;
    task_ = &task;
    count_ = count;
    next_ = 0;
  }
  called_.notify_all();
  takeTasks(count, task);
  std::unique_lock<std::mutex> locked(mutex_);
  task_ = nullptr;           // threads that come now are too late
  std::exception_ptr thrown; // by idle(): only after the others have finished with the task
  while (!finished_.wait_for(locked, kIdle, [this] { return atWork_ == 0; }))
  {
    locked.unlock();
    try
    {
      thrown ? void() : idle();
    }
    catch (...)
    {
      thrown = std::current_exception();
    }
    locked.lock();
  }
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
}

Threads::Threads(unsigned count)
  : count_(std::max(1u, count))
{
}

Threads::~Threads() = default;

unsigned Threads::used() const
{
  return others_ ? 1 + others_->size() : 1;
}

void Threads::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  if (count > 1 && count_ > 1 && !others_)
  {
    try
    {
      others_.reset(new Crew(count_ - 1));
    }
    catch (const std::exception&)
    {
      // std::bad_alloc or std::system_error: this thread does it alone
    }
  }
  if (count > 1 && others_)
  {
    others_->run(count, task, idle);
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    task(i);
  }
}

} // namespace ahd
