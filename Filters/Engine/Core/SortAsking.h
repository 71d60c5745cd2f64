// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SortAsking_h
#define ahd_SortAsking_h

#include "Chunks.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ahd
{

/// Sorts by `less`, a strict weak order; which of two equal items comes first is not said. Uses as
/// much memory again. Returns false if the work is to be cancelled; then some items are lost.
template <typename T, typename Less>
bool sortAsking(std::vector<T>& items, Ticker& ticker, Less less)
{
  const std::size_t n = items.size();
  const auto sortPiece = [&](std::size_t a, std::size_t b)
  { std::sort(items.data() + a, items.data() + b, less); };
  if (!inChunks(0, n, ticker, sortPiece))
  {
    return false;
  }
  std::vector<T> merged(n > kChunk ? n : 0);
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
          merged[k] = items[fromLow ? low++ : high++];
        }
      };
      if (!inChunks(begin, end, ticker, mergePiece))
      {
        return false;
      }
    }
    items.swap(merged);
  }
  return true;
}

} // namespace ahd

#endif
