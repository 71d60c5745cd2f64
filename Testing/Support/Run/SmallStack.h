// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SmallStack_h
#define ahd_SmallStack_h

#include "Core/Executor.h"

#include <cstddef>
#include <functional>

namespace ahd
{
namespace test
{

/// The size of a small stack in bytes. The thread library takes part of it.
constexpr std::size_t kSmallStack = std::size_t(64) << 10;

/// Runs `work` on a thread of its own whose stack is kSmallStack bytes. Below it is an inaccessible
/// page, so that an overflow crashes. Returns how many bytes of the stack were written to, those of
/// the thread library included. `work` throws nothing.
std::size_t onSmallStack(const std::function<void()>& work);

/// Runs tasks on the calling thread and on others whose stacks are small, new ones for each run.
class SmallStackExecutor : public Executor
{
public:
  /// `threads`: the calling one included.
  explicit SmallStackExecutor(unsigned threads)
    : threads_(threads)
  {
  }

  unsigned threads() const override { return threads_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task,
    const std::function<void()>& idle) override;

  /// Of the stack of any of the other threads, in any run.
  std::size_t mostBytes() const { return mostBytes_; }

private:
  unsigned threads_;
  std::size_t mostBytes_ = 0;
};

} // namespace test
} // namespace ahd

#endif
