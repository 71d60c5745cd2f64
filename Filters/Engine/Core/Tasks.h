// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Tasks_h
#define ahd_Tasks_h

#include "Executor.h"
#include "FloatingPoint.h"
#include "Progress.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>

namespace ahd
{

/// How many threads a phase can have.
inline std::size_t threadsOf(const Ticker& ticker)
{
  return ticker.executor() ? std::max(1u, ticker.executor()->threads()) : 1;
}

/// The number of tasks for the work on so many items: several per thread where they may take
/// unequal time, but none for less than `least` items; one if there is one thread.
inline std::size_t tasksFor(
  std::size_t threads, std::size_t items, std::size_t perThread, std::size_t least)
{
  return threads == 1 ? 1 : std::min(threads * perThread, items / least + 1);
}

/// Calls work(task, ticker of the task) for each task in [0, count) on the threads lent to the
/// phase; in ascending order on this thread if none are. The tasks must be independent, and what
/// they write must not depend on which runs first. `work` returns false if it is cancelled; then so
/// does this. If one throws the others are stopped and this throws it, of several the first. With
/// threads lent it polls at its end: the others may have taken all tasks, or tasks too short to
/// ask.
template <typename Work>
bool inParallel(Ticker& ticker, std::size_t count, Work work)
{
  if (threadsOf(ticker) == 1 || count == 1)
  {
    for (std::size_t task = 0; task < count; ++task)
    {
      if (!work(task, ticker))
      {
        return false;
      }
    }
    return true;
  }
  std::atomic<bool> cancelled{ false };
  std::atomic<bool> hasThrown{ false };
  std::exception_ptr thrown; // written by the task that sets hasThrown, read when all are done
  const auto run = [&](std::size_t task)
  {
    const ScopedFloatingPoint asAssumed;
    Ticker own(&ticker);
    try
    {
      if (cancelled.load(std::memory_order_relaxed) || !work(task, own))
      {
        cancelled = true;
      }
    }
    catch (...)
    {
      if (!hasThrown.exchange(true))
      {
        thrown = std::current_exception();
      }
      cancelled = true;
      ticker.cancel();
    }
  };
  {
    const ScopedFloatingPoint whateverItSets;
    ticker.executor()->run(count, run, [&] { ticker.ask(); });
  }
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
  return !cancelled && ticker.ask();
}

/// [begin, end) of the items that task `task` of `tasks` takes, when they share `items` evenly.
struct Share
{
  Share(std::size_t items, std::size_t task, std::size_t tasks)
    : begin(part(items, task, tasks))
    , end(part(items, task + 1, tasks))
  {
  }
  std::size_t begin;
  std::size_t end;

private:
  static std::size_t part(std::size_t items, std::size_t task, std::size_t tasks)
  {
    return items / tasks * task + std::min(task, items % tasks);
  }
};

} // namespace ahd

#endif
