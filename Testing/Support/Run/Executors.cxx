// SPDX-License-Identifier: BSD-3-Clause
#include "Executors.h"

#include <chrono>

namespace ahd
{
namespace test
{

ThreadExecutor::ThreadExecutor(unsigned threads, unsigned said)
  : said_(said == 0 ? threads : said)
{
  for (unsigned t = 1; t < threads; ++t)
  {
    others_.emplace_back([this, t] { serve(t); });
  }
}

ThreadExecutor::~ThreadExecutor()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    leaving_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : others_)
  {
    thread.join();
  }
}

void ThreadExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    count_ = count;
    task_ = &task;
    next_ = 0;
    working_ = unsigned(others_.size());
    ++runs_;
  }
  begun_.notify_all();
  beforeTasks(0);
  takeTasks();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ended_.wait_for(lock, std::chrono::milliseconds(2), [this] { return working_ == 0; }))
  {
    lock.unlock();
    idle();
    lock.lock();
  }
}

void ThreadExecutor::takeTasks()
{
  for (std::size_t i = next_++; i < count_; i = next_++)
  {
    (*task_)(i);
  }
}

void ThreadExecutor::serve(unsigned thread)
{
  std::unique_lock<std::mutex> lock(mutex_);
  for (std::size_t served = 0;; ++served)
  {
    begun_.wait(lock, [&] { return runs_ != served || leaving_; });
    if (leaving_)
    {
      return;
    }
    lock.unlock();
    beforeTasks(thread);
    takeTasks();
    lock.lock();
    if (--working_ == 0)
    {
      ended_.notify_one();
    }
  }
}

void LateExecutor::beforeTasks(unsigned thread)
{
  std::this_thread::sleep_for(std::chrono::microseconds(300 * thread));
}

void BackwardExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  for (std::size_t i = count; i-- > 0;)
  {
    task(i);
  }
  idle();
}

void ElsewhereExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  std::atomic<bool> working{ true };
  std::thread other(
    [&]
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        task(i);
      }
      working = false;
    });
  while (working)
  {
    idle();
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  other.join();
}

void QuickElsewhereExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& /*idle*/)
{
  std::thread other(
    [&]
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        task(i);
      }
    });
  other.join();
}

} // namespace test
} // namespace ahd
