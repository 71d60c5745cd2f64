// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Chunks_h
#define ahd_Chunks_h

#include "Progress.h"

#include <algorithm>
#include <cstddef>

namespace ahd
{

constexpr std::size_t kChunk = std::size_t(1) << 12;

/// Calls work(a, b) for consecutive chunks [a, b) of [begin, end), each of at most kChunk steps,
/// and counts the steps. Returns false if the work is to be cancelled.
template <typename Work>
bool inChunks(std::size_t begin, std::size_t end, Ticker& ticker, Work work)
{
  for (std::size_t a = begin; a < end;)
  {
    const std::size_t b = std::min(end, a + kChunk);
    work(a, b);
    if (!ticker.step(b - a))
    {
      return false;
    }
    a = b;
  }
  return true;
}

/// Writes the value all over a Buffer. Returns false if the work is to be cancelled.
template <typename Array, typename Value>
bool fillAll(Array& array, const Value& value, Ticker& ticker)
{
  return inChunks(0, array.size(), ticker,
    [&](std::size_t a, std::size_t b) { std::fill(array.data() + a, array.data() + b, value); });
}

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

/// Number of bits needed to write n; 0 for 0.
inline unsigned bitLength(unsigned long long n)
{
  unsigned length = 0;
  for (; n != 0; n >>= 1)
  {
    ++length;
  }
  return length;
}

} // namespace ahd

#endif
