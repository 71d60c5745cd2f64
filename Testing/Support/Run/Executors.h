// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Executors_h
#define ahd_Executors_h

#include "Core/Executor.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ahd
{
namespace test
{

/// Runs tasks on threads of its own, the calling thread among them. The threads are started once
/// and sleep between runs. Not to be used by two threads at once.
class ThreadExecutor : public Executor
{
public:
  /// `said`: the number of threads it reports; 0: the actual one.
  explicit ThreadExecutor(unsigned threads, unsigned said = 0);
  ~ThreadExecutor() override;

  unsigned threads() const override { return said_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;

protected:
  /// Called by each thread before it takes its first task of a run; `thread` 0 is the caller's.
  virtual void beforeTasks(unsigned /*thread*/) {}

private:
  void takeTasks();
  void serve(unsigned thread);

  unsigned said_;
  std::mutex mutex_;
  std::condition_variable begun_;
  std::condition_variable ended_;
  std::size_t runs_ = 0;  ///< how many have begun; changes under the mutex, as all below
  unsigned working_ = 0;  ///< threads that have not finished the run
  bool leaving_ = false;  ///< no further run comes
  std::size_t count_ = 0; ///< of tasks of the run
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::atomic<std::size_t> next_{ 0 };
  std::vector<std::thread> others_;
};

/// Its threads start late: the tasks are then shared in another way, or the caller has done them
/// all.
class LateExecutor : public ThreadExecutor
{
public:
  using ThreadExecutor::ThreadExecutor;

protected:
  void beforeTasks(unsigned thread) override;
};

/// Reports so many threads, whatever runs the tasks.
class NominalExecutor : public Executor
{
public:
  explicit NominalExecutor(unsigned threads)
    : threads_(threads)
  {
  }
  unsigned threads() const override { return threads_; }

private:
  unsigned threads_;
};

/// Is this compiled by g++ under the thread sanitizer? There tasks that all run on one thread show
/// nothing.
#ifdef __SANITIZE_THREAD__
constexpr bool kOnlyThreadsMatter = true;
#else
constexpr bool kOnlyThreadsMatter = false;
#endif

/// Runs all tasks on the calling thread, the last first: results that are wrong then depend on the
/// order of the tasks.
class BackwardExecutor : public NominalExecutor
{
public:
  using NominalExecutor::NominalExecutor;
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;
};

/// Runs all tasks on one thread that is not the caller's, which only waits and polls.
class ElsewhereExecutor : public NominalExecutor
{
public:
  using NominalExecutor::NominalExecutor;
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;
};

/// Runs all tasks on one thread that is not the caller's, and is done before the caller polls.
class QuickElsewhereExecutor : public NominalExecutor
{
public:
  using NominalExecutor::NominalExecutor;
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;
};

} // namespace test
} // namespace ahd

#endif
