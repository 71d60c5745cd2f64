// SPDX-License-Identifier: BSD-3-Clause
//
// Counts the memory that malloc and its relatives give a process, by LD_PRELOAD: usable bytes, held
// now and at most. For glibc.
#include <atomic>
#include <cerrno>
#include <cstddef>

#include <malloc.h>

extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* block, std::size_t size);
  void* __libc_memalign(std::size_t alignment, std::size_t size);
  void __libc_free(void* block);

  void* memalign(std::size_t alignment, std::size_t size);
  long counted_held();
  long counted_most();
  void counted_begin();
}

namespace
{

std::atomic<long> held{ 0 }, most{ 0 };

long sizeOf(void* block)
{
  return block ? static_cast<long>(malloc_usable_size(block)) : 0;
}

void* took(void* block)
{
  const long now = held += sizeOf(block);
  long before = most;
  while (before < now && !most.compare_exchange_weak(before, now))
  {
  }
  return block;
}

} // namespace

extern "C"
{
  void* malloc(std::size_t size) noexcept
  {
    return took(__libc_malloc(size));
  }

  void* calloc(std::size_t count, std::size_t size) noexcept
  {
    return took(__libc_calloc(count, size));
  }

  /// The old block and the new one exist at the same time where it moves, except large ones, whose
  /// pages move.
  void* realloc(void* block, std::size_t size) noexcept
  {
    const long before = sizeOf(block);
    void* const moved = __libc_realloc(block, size);
    if (moved || size == 0)
    {
      held -= before;
      took(moved);
    }
    return moved;
  }

  void* memalign(std::size_t alignment, std::size_t size)
  {
    return took(__libc_memalign(alignment, size));
  }

  void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
  {
    return memalign(alignment, size);
  }

  int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept
  {
    void* const given = memalign(alignment, size);
    *block = given ? given : *block;
    return given ? 0 : ENOMEM;
  }

  void free(void* block) noexcept
  {
    const int error = errno;
    held -= sizeOf(block);
    __libc_free(block);
    errno = error;
  }

  /// Bytes that are held.
  long counted_held()
  {
    return held;
  }

  /// The most that were held at a time since counted_begin().
  long counted_most()
  {
    return most;
  }

  void counted_begin()
  {
    most = held.load();
  }
}
