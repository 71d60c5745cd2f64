// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SortInSteps_h
#define ahd_SortInSteps_h

#include "Progress.h"

#include <algorithm>
#include <iterator>

namespace ahd
{

/// Sorts [first, last) and keeps the promise to ask the caller at least once per kStepsPerAsking
/// bounded steps: small ranges by std::sort, large ones by a heap sort that can be interrupted
/// after each element. For ranges that are short except in freak inputs. Returns false if the
/// caller wants to cancel; the range then holds its elements in any order.
template <typename Iterator, typename Less>
bool sortInSteps(Iterator first, Iterator last, Less less, Ticker& ticker)
{
  constexpr std::ptrdiff_t kAtOnce = kStepsPerAsking / 16; // n log2 n steps stay below the limit
  const std::ptrdiff_t n = std::distance(first, last);
  if (n <= kAtOnce)
  {
    std::sort(first, last, less);
    return ticker.step(std::size_t(n));
  }
  for (Iterator end = first; end != last;)
  {
    std::push_heap(first, ++end, less);
    if (!ticker.step())
    {
      return false;
    }
  }
  for (Iterator end = last; end != first; --end)
  {
    std::pop_heap(first, end, less);
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

} // namespace ahd

#endif
