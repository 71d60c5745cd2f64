// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SortAsking_h
#define ahd_SortAsking_h

#include "Chunks.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace ahd
{

/// Sorts items[0, n) by `less`, a strict weak order; the order of equal items is unspecified.
/// `other` is scratch for as many. Returns false if the work is cancelled; then some items are
/// lost.
template <typename T, typename Less>
bool sortAsking(T* items, std::size_t n, T* other, Ticker& ticker, Less less)
{
  T* const home = items;
  const auto sortPiece = [&](std::size_t a, std::size_t b)
  { std::sort(items + a, items + b, less); };
  if (!inChunks(0, n, ticker, sortPiece))
  {
    return false;
  }
  for (std::size_t width = kChunk; width < n; width *= 2)
  {
    for (std::size_t begin = 0; begin < n; begin += 2 * width)
    {
      const std::size_t middle = std::min(n, begin + width), end = std::min(n, middle + width);
      std::size_t low = begin, high = middle;
      const auto mergePiece = [&](std::size_t a, std::size_t b)
      {
        for (std::size_t k = a; k != b; ++k)
        {
          const bool fromLow = high == end || (low != middle && !less(items[high], items[low]));
          other[k] = items[fromLow ? low++ : high++];
        }
      };
      if (!inChunks(begin, end, ticker, mergePiece))
      {
        return false;
      }
    }
    std::swap(items, other);
  }
  return items == home ||
    inChunks(0, n, ticker,
      [&](std::size_t a, std::size_t b) { std::copy(items + a, items + b, home + a); });
}

/// The same for a vector. Uses as much memory again.
template <typename T, typename Less>
bool sortAsking(std::vector<T>& items, Ticker& ticker, Less less)
{
  std::vector<T> other(items.size() > kChunk ? items.size() : 0);
  return sortAsking(items.data(), items.size(), other.data(), ticker, less);
}

/// The same, ascending, without duplicates.
template <typename T>
bool sortOnce(std::vector<T>& items, Ticker& ticker)
{
  if (!sortAsking(items, ticker, std::less<T>()))
  {
    return false;
  }
  items.erase(std::unique(items.begin(), items.end()), items.end());
  return true;
}

} // namespace ahd

#endif
