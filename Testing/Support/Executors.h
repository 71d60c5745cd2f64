// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Executors_h
#define ahd_Executors_h

#include "Executor.h"

#include <cstddef>
#include <functional>

namespace ahd
{
namespace test
{

/// Runs tasks on threads of its own, the calling thread among them.
class ThreadExecutor : public Executor
{
public:
  explicit ThreadExecutor(unsigned threads)
    : threads_(threads)
  {
  }
  unsigned threads() const override { return threads_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;

private:
  unsigned threads_;
};

/// Says it has so many threads and runs all tasks on the calling one, the last first: what comes
/// out wrong then depends on the order of the tasks.
class BackwardExecutor : public Executor
{
public:
  explicit BackwardExecutor(unsigned threads)
    : threads_(threads)
  {
  }
  unsigned threads() const override { return threads_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;

private:
  unsigned threads_;
};

} // namespace test
} // namespace ahd

#endif
