// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDExecutor_h
#define vtkAHDExecutor_h

#include "Engine/Core/Executor.h"

#include <cstddef>
#include <functional>
#include <memory>

/**
 * How many threads to take when the user wished for `wished`.
 *
 * More than 0: exactly so many, 1024 at most. 0: one for each processor that this process may run
 * on (on Linux its CPU affinity is respected), but not more than vtkSMPTools would take, or would
 * take if its backend were not Sequential: vtkSMPTools::Initialize(n) limits them, else the
 * environment variable VTK_SMP_MAX_THREADS does. One only, where vtkSMPTools is at work already and
 * was told not to nest.
 */
unsigned vtkAHDThreadsToUse(int wished);

/**
 * Lends threads to the engine for one execution of a filter.
 *
 * The calling thread takes tasks like the others, one by one from a common counter. The others are
 * started when there is something to share for the first time, and wait for more until this is
 * destroyed. They are vtkSMPTools' own where it has threads that are not at work; where its backend
 * is Sequential, as in Debian's ParaView, they are started here, since a vtkSMPTools::LocalScope
 * would change the backend for the whole process. A thread that cannot be had is done without.
 *
 * Not to be used by two threads at a time, and not from a task.
 */
class vtkAHDExecutor : public ahd::Executor
{
public:
  explicit vtkAHDExecutor(unsigned threads);
  ~vtkAHDExecutor() override;
  vtkAHDExecutor(const vtkAHDExecutor&) = delete;
  vtkAHDExecutor& operator=(const vtkAHDExecutor&) = delete;

  unsigned threads() const override { return this->Threads; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;

  /// How many threads there were to share the work so far: 1 if nothing was worth sharing.
  unsigned GetThreadsUsed() const;

private:
  class Crew; // the other threads
  const unsigned Threads;
  std::unique_ptr<Crew> Others;
};

#endif
