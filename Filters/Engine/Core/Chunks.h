// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Chunks_h
#define ahd_Chunks_h

#include "Prefetch.h"
#include "Progress.h"

#include <algorithm>
#include <cstddef>

namespace ahd
{

constexpr std::size_t kChunk = std::size_t(1) << 12;

/// Calls work(a, b) for consecutive chunks [a, b) of [begin, end), each of at most kChunk steps,
/// and counts the steps. Returns false if the work is cancelled.
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

/// The same, one by one: calls work(i) for each i of [begin, end).
template <typename Work>
bool inSteps(std::size_t begin, std::size_t end, Ticker& ticker, Work work)
{
  return inChunks(begin, end, ticker,
    [&work](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        work(i);
      }
    });
}

/// Fills a Buffer with the value. Returns false if the work is cancelled.
template <typename Array, typename Value>
bool fillAll(Array& array, const Value& value, Ticker& ticker)
{
  return inChunks(0, array.size(), ticker,
    [&](std::size_t a, std::size_t b) { std::fill(array.data() + a, array.data() + b, value); });
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
