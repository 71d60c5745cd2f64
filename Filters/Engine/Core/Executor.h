// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Executor_h
#define ahd_Executor_h

#include <cstddef>
#include <functional>

namespace ahd
{

/// The threads that the caller lends to the engine beyond the one that it is called on. The engine
/// starts none itself.
class Executor
{
public:
  virtual ~Executor() = default;

  /// How many tasks can run at the same time; at least 1. Constant during a run.
  virtual unsigned threads() const = 0;

  /// Calls task(0) to task(count - 1), each once, in any order, on any threads, and returns when
  /// all have returned. Tasks are independent: none waits for another, so one thread may run them
  /// all. They throw nothing.
  /// The calling thread takes part, or else calls idle() every few milliseconds until the last
  /// task has returned: there the caller gets progress and can cancel.
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) = 0;
};

} // namespace ahd

#endif
