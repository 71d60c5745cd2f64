// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Loops_h
#define ahd_Loops_h

#include "Chunks.h"
#include "Tasks.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace ahd
{

/// The fewest steps of a task of a loop of a few operations a step.
constexpr std::size_t kLeastLoopTask = std::size_t(1) << 14;

/// The number of tasks for such a loop. Short loops are one: sharing them takes longer.
inline std::size_t tasksForLoop(const Ticker& ticker, std::size_t count)
{
  constexpr std::size_t kLeastShared = std::size_t(1) << 18;
  return count < kLeastShared ? 1 : tasksFor(threadsOf(ticker), count, 8, kLeastLoopTask);
}

/// Calls work(a, b) for chunks [a, b) of [0, count), each at most kChunk long, on the threads lent
/// to the phase where it pays. Polls for cancellation first, so at least once. Returns false if
/// cancelled; then some chunks are missing.
template <typename Work>
bool inChunksOf(std::size_t count, Ticker& ticker, const Work& work)
{
  const std::size_t tasks = tasksForLoop(ticker, count);
  return ticker.ask() &&
    inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(count, task, tasks);
        return inChunks(share.begin, share.end, own, work);
      });
}

/// Calls work(a, b) for chunks [a, b) of [0, count), which take their time, in several tasks a
/// thread, none for less than `least` items; what is done moves the fraction. Returns false if the
/// work is cancelled.
template <typename Work>
bool inShares(
  std::size_t count, Ticker& ticker, std::size_t perThread, std::size_t least, const Work& work)
{
  const std::size_t tasks = tasksFor(threadsOf(ticker), count, perThread, least);
  return inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(count, task, tasks);
      return inChunks(share.begin, share.end, own,
        [&](std::size_t a, std::size_t b)
        {
          work(a, b);
          own.finished(b - a);
        });
    });
}

/// The same as inChunksOf for work(part, a, b) with a result: each task has its own
/// default-constructed Part, and part.merge(other) adds the result of later items to that of
/// earlier ones. `total` is a new Part. Throws std::bad_alloc.
template <typename Part, typename Work>
bool gather(std::size_t count, Ticker& ticker, Part& total, const Work& work)
{
  const std::size_t tasks = tasksForLoop(ticker, count);
  std::vector<Part> parts(tasks);
  const bool all = ticker.ask() &&
    inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(count, task, tasks);
        Part part; // on the stack: no false sharing
        const bool done = inChunks(
          share.begin, share.end, own, [&](std::size_t a, std::size_t b) { work(part, a, b); });
        parts[task] = part;
        return done;
      });
  for (const Part& part : parts)
  {
    total.merge(part);
  }
  return all;
}

/// Writes the items found in [0, items), in order, by all threads lent where it pays: each share is
/// first counted, then written from where those before it end. count(a, b) returns how many [a, b)
/// has; begin(all) makes room; write(a, b, first) writes them from place `first` on and returns the
/// place behind. Returns false if the work is cancelled. Throws std::bad_alloc.
template <typename Count, typename Begin, typename Write>
bool countAndWrite(
  std::size_t items, Ticker& ticker, const Count& count, const Begin& begin, const Write& write)
{
  const std::size_t tasks = tasksForLoop(ticker, items);
  std::vector<std::size_t> places(tasks + 1);
  const auto inTasks = [&](const auto& work)
  {
    return inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(items, task, tasks);
        std::size_t place = places[task];
        const bool done = inChunks(share.begin, share.end, own,
          [&](std::size_t a, std::size_t b) { place = work(a, b, place); });
        places[task] = place;
        return done;
      });
  };
  if (!inTasks([&](std::size_t a, std::size_t b, std::size_t n) { return n + count(a, b); }))
  {
    return false;
  }
  std::size_t sum = 0;
  for (std::size_t& place : places)
  {
    sum += std::exchange(place, sum);
  }
  begin(sum);
  return inTasks(write);
}

} // namespace ahd

#endif
