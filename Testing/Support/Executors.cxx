// SPDX-License-Identifier: BSD-3-Clause
#include "Executors.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace ahd
{
namespace test
{

void ThreadExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  std::atomic<std::size_t> next{ 0 };
  std::atomic<unsigned> working{ threads_ - 1 };
  const auto work = [&]
  {
    for (std::size_t i = next++; i < count; i = next++)
    {
      task(i);
    }
  };
  std::vector<std::thread> others;
  for (unsigned t = 1; t < threads_; ++t)
  {
    others.emplace_back(
      [&]
      {
        work();
        --working;
      });
  }
  work();
  while (working != 0)
  {
    idle();
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  for (std::thread& thread : others)
  {
    thread.join();
  }
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

} // namespace test
} // namespace ahd
