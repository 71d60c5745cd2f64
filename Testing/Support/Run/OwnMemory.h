// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_OwnMemory_h
#define ahd_OwnMemory_h

// Gives a program an operator new that keeps account of what is held, and fails when told to. To be
// included by one of its sources.
#include "OwnNew.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace ahd
{
namespace test
{

/// What was asked of operator new.
struct Account
{
  std::atomic<std::size_t> held{ 0 }; ///< bytes
  std::atomic<std::size_t> peak{ 0 }; ///< most bytes held at once
  std::atomic<std::size_t> allocations{ 0 };
  std::atomic<std::size_t> failAt{ 0 }; ///< this allocation and all later ones fail; 0: none
};

inline Account account;

/// Every block is preceded by its size and by the pointer to be freed.
struct BlockHeader
{
  std::size_t size;
  void* block;
};

} // namespace test
} // namespace ahd

void* ahd::test::ownAllocate(std::size_t size, std::size_t alignment)
{
  const std::size_t number = ++account.allocations;
  const std::size_t failAt = account.failAt;
  const std::size_t room = std::max(alignment, alignof(BlockHeader)) + sizeof(BlockHeader);
  void* block = failAt != 0 && number >= failAt ? nullptr : std::malloc(size + room);
  if (!block)
  {
    throw std::bad_alloc();
  }
  const std::size_t start = reinterpret_cast<std::size_t>(block) + room;
  BlockHeader* header = reinterpret_cast<BlockHeader*>(start / alignment * alignment) - 1;
  *header = { size, block };
  account.held += size;
  account.peak = std::max<std::size_t>(account.peak, account.held);
  return header + 1;
}

void ahd::test::ownRelease(void* p)
{
  if (p)
  {
    BlockHeader* header = static_cast<BlockHeader*>(p) - 1;
    account.held -= header->size;
    std::free(header->block);
  }
}

#endif
