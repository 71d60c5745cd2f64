// SPDX-License-Identifier: BSD-3-Clause
#include "RadixSort.h"

#include "../Core/Chunks.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ahd
{

namespace
{

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t(1) << kDigitBits;
constexpr std::size_t kFew = kChunk;

/// One stable pass by the digit at `shift`.
bool sortByDigit(
  const std::uint64_t* from, std::uint64_t* to, std::size_t n, unsigned shift, Ticker& ticker)
{
  std::array<std::size_t, kDigits> place{};
  const bool counted = inChunks(0, n, ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        ++place[from[i] >> shift & (kDigits - 1)];
      }
    });
  std::size_t sum = 0;
  for (std::size_t& p : place)
  {
    sum += std::exchange(p, sum);
  }
  return counted &&
    inChunks(0, n, ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i < b; ++i)
        {
          to[place[from[i] >> shift & (kDigits - 1)]++] = from[i];
        }
      });
}

} // namespace

bool sortPacked(Buffer<std::uint64_t>& items, std::size_t n, Ticker& ticker)
{
  if (n <= kFew)
  {
    std::sort(items.data(), items.data() + n);
    return ticker.step(n);
  }
  std::uint64_t all = 0;
  const bool looked = inChunks(0, n, ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i < b; ++i)
      {
        all |= items[i];
      }
    });
  if (!looked)
  {
    return false;
  }
  Buffer<std::uint64_t> other;
  other.allocate(items.size());
  for (unsigned shift = 32; shift < bitLength(all); shift += kDigitBits)
  {
    if (!sortByDigit(items.data(), other.data(), n, shift, ticker))
    {
      return false;
    }
    std::swap(items, other);
  }
  return true;
}

} // namespace ahd
