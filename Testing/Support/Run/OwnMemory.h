// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_OwnMemory_h
#define ahd_OwnMemory_h

// Gives a program an operator new that counts the bytes held, and fails on demand. Include it in
// one source.
#include "OwnNew.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__SANITIZE_ADDRESS__)
#define AHD_POISONS_HEADERS 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define AHD_POISONS_HEADERS 1
#endif
#endif
#ifdef AHD_POISONS_HEADERS
#include <sanitizer/asan_interface.h>
#endif

namespace ahd
{
namespace test
{

/// Counts of operator new, over all threads.
struct Account
{
  std::atomic<std::size_t> held{ 0 }; ///< bytes
  std::atomic<std::size_t> peak{ 0 }; ///< most bytes held at once
  std::atomic<std::size_t> blocks{ 0 };
  std::atomic<std::size_t> allocations{ 0 };
  std::atomic<std::size_t> failures{ 0 };   ///< of these, since it was set to 0
  std::atomic<std::size_t> failAt{ 0 };     ///< this allocation and all later ones fail; 0: none
  std::atomic<bool> failsOnce{ false };     ///< ... and none of the later ones
  std::atomic<bool> countsNothing{ false }; ///< allocations are not numbered now, and do not fail
};

inline Account account;

/// Every block is preceded by its size, by the pointer to be freed, and by nothing else that may be
/// touched.
struct BlockHeader
{
  std::size_t size;
  void* block;
};

/// Makes the sanitizer, if there is one, detect accesses to the header.
inline void guard(BlockHeader* header, bool isOn)
{
#ifdef AHD_POISONS_HEADERS
  isOn ? __asan_poison_memory_region(header, sizeof(*header))
       : __asan_unpoison_memory_region(header, sizeof(*header));
#else
  (void)header;
  (void)isOn;
#endif
}

/// Must the next allocation fail?
inline bool failsNow()
{
  if (account.countsNothing)
  {
    return false;
  }
  const std::size_t number = ++account.allocations;
  const std::size_t failAt = account.failAt;
  const bool fails = failAt != 0 && (account.failsOnce ? number == failAt : number >= failAt);
  account.failures += fails;
  return fails;
}

/// By a pointer: compilers warn of free() in an operator delete whose operator new they do not see.
inline void (*volatile freeBlock)(void*) = std::free;

} // namespace test
} // namespace ahd

void* ahd::test::ownAllocate(std::size_t size, std::size_t alignment)
{
  const std::size_t room = (sizeof(BlockHeader) + alignment - 1) / alignment * alignment;
  const std::size_t whole = (std::max<std::size_t>(size, 1) + alignment - 1) / alignment *
    alignment;
  const bool fails = failsNow() || whole < size || whole + room < whole;
  char* const block = fails ? nullptr
                            : static_cast<char*>(std::aligned_alloc(alignment, whole + room));
  if (!block)
  {
    throw std::bad_alloc();
  }
  BlockHeader* const header = reinterpret_cast<BlockHeader*>(block + room) - 1;
  *header = { size, block };
  guard(header, true);
  ++account.blocks;
  const std::size_t now = account.held += size;
  std::size_t peak = account.peak;
  while (peak < now && !account.peak.compare_exchange_weak(peak, now))
  {
  }
  return header + 1;
}

void ahd::test::ownRelease(void* p)
{
  if (p)
  {
    BlockHeader* const header = static_cast<BlockHeader*>(p) - 1;
    guard(header, false);
    account.held -= header->size;
    --account.blocks;
    freeBlock(header->block);
  }
}

#endif
