// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Prefetch_h
#define ahd_Prefetch_h

namespace ahd
{

// Useful for sequential reads, too: the prefetchers of some processors do not reach far enough for
// loops that do more than add up (README.md, Tried).

/// Tells the processor that a cache line is about to be written. Changes no result.
inline void prefetchForWrite(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address, 1);
  asm volatile(""); // no instruction; else GCC drops calls of functions that do nothing but fetch
#else
  (void)address;
#endif
}

/// Tells the processor that a cache line is about to be read. Changes no result.
inline void prefetchForRead(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address, 0);
  asm volatile(""); // as above
#else
  (void)address;
#endif
}

} // namespace ahd

#endif
