// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RadixSort_h
#define ahd_RadixSort_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// A number to sort by in the high 32 bits, what belongs to it in the low 32.
inline std::uint64_t packed(std::uint32_t number, std::uint32_t value)
{
  return std::uint64_t(number) << 32 | value;
}

/// Sorts items[0, n) by their high 32 bits; equal ones keep their order or are in ascending order
/// of the low bits. Few items: std::sort. Many: radix sort, least significant digit first, with
/// scratch of the same size. Returns false if cancelled. Throws std::bad_alloc.
bool sortPacked(Buffer<std::uint64_t>& items, std::size_t n, Ticker& ticker);

} // namespace ahd

#endif
