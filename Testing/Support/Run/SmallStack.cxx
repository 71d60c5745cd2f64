// SPDX-License-Identifier: BSD-3-Clause
#include "SmallStack.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

namespace ahd
{
namespace test
{
namespace
{

void require(bool ok, const char* what)
{
  if (!ok)
  {
    throw std::system_error(errno, std::generic_category(), what);
  }
}

/// A thread on a stack of its own, all of which held one value before.
class Thread
{
public:
  explicit Thread(std::function<void()> work)
    : work_(std::move(work))
    , page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE)))
    , memory_(mmap(nullptr, page_ + kSmallStack, PROT_READ | PROT_WRITE,
        MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0))
  {
    require(memory_ != MAP_FAILED, "mmap");
    require(mprotect(memory_, page_, PROT_NONE) == 0, "mprotect");
    std::fill_n(stack(), kSmallStack, kPaint);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    require(pthread_attr_setstack(&attributes, stack(), kSmallStack) == 0, "pthread_attr_setstack");
    const auto start = [](void* self) -> void*
    {
      static_cast<Thread*>(self)->work_();
      return nullptr;
    };
    require(pthread_create(&thread_, &attributes, start, this) == 0, "pthread_create");
    pthread_attr_destroy(&attributes);
  }
  ~Thread() { munmap(memory_, page_ + kSmallStack); }
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  /// Waits for its end. Returns how many bytes of the stack have been overwritten.
  std::size_t join()
  {
    pthread_join(thread_, nullptr);
    const auto* const end = stack() + kSmallStack;
    return static_cast<std::size_t>(
      end - std::find_if(stack(), stack() + kSmallStack, [](auto byte) { return byte != kPaint; }));
  }

private:
  static constexpr unsigned char kPaint = 0xA5;

  unsigned char* stack() const { return static_cast<unsigned char*>(memory_) + page_; }

  std::function<void()> work_;
  std::size_t page_;
  void* memory_;
  pthread_t thread_{};
};

} // namespace

std::size_t onSmallStack(const std::function<void()>& work)
{
  return Thread(work).join();
}

void SmallStackExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task,
  const std::function<void()>& idle)
{
  std::atomic<std::size_t> next{ 0 };
  const auto takeTasks = [&]
  {
    for (std::size_t i = next++; i < count; i = next++)
    {
      task(i);
    }
  };
  std::vector<std::unique_ptr<Thread>> others;
  for (unsigned t = 1; t < threads_; ++t)
  {
    others.push_back(std::make_unique<Thread>(takeTasks));
  }
  takeTasks();
  idle();
  for (const auto& other : others)
  {
    mostBytes_ = std::max(mostBytes_, other->join());
  }
}

} // namespace test
} // namespace ahd
