// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SortTaking_h
#define ahd_SortTaking_h

#include "../Core/AskedMemory.h"
#include "../Core/SortAsking.h"

namespace ahd
{

/// sortAsking() that requests its memory.
template <typename T, typename Less>
bool sortTaking(std::vector<T>& items, Ticker& ticker, Less less)
{
  TakenMemory scratch(ticker);
  scratch.atLeast(items.size() * sizeof(T));
  return sortAsking(items, ticker, less);
}

} // namespace ahd

#endif
