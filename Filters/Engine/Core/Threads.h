// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Threads_h
#define ahd_Threads_h

#include "Executor.h"

#include <memory>

namespace ahd
{

/// An Executor with threads of its own, for callers that have none to lend.
///
/// The calling thread takes tasks like the others, one by one from a common counter. The others are
/// started when there is something to share for the first time, and wait for more until this is
/// destroyed. If a thread cannot be started, the others do its work. Not to be used by two threads
/// at a time, and not from a task.
class Threads : public Executor
{
public:
  /// The number of threads, the calling one included; 0 counts as 1.
  explicit Threads(unsigned count);
  ~Threads() override;
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  unsigned threads() const override { return count_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;

  /// The number of threads that shared the work so far: 1 if nothing was worth sharing.
  unsigned used() const;

private:
  class Crew; // the other threads
  const unsigned count_;
  std::unique_ptr<Crew> others_;
};

} // namespace ahd

#endif
