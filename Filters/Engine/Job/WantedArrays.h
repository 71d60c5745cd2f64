// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_WantedArrays_h
#define ahd_WantedArrays_h

#include "ArrayRows.h"
#include "Run.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Where numbers are written, and their type.
struct ArrayTarget
{
  std::int32_t type; ///< of ids kInt32 or kInt64
  void* out;
  const Context& context;

  double* doubles() const { return static_cast<double*>(out); }
};

/// Calls work(pointer to ids of the type).
template <typename Work>
Status withIds(const ArrayTarget& to, const Work& work)
{
  return to.type == kInt32 ? work(static_cast<std::int32_t*>(to.out))
                           : work(static_cast<std::int64_t*>(to.out));
}

/// The points of a result, or its cells.
std::size_t rowsOf(WantedArray array, const RunResult& made);

/// Writes an array of the output, for all rows.
///
/// @pre settings before the run that keep what it is made of (needsOrder())
/// @return Ok, Cancelled or OutOfMemory
Status writeArray(WantedArray array, RunResult& made, const ArrayTarget& to);

/// Is it made of the insertion order?
constexpr bool needsOrder(WantedArray array)
{
  return array == WantedArray::InsertionRanks;
}

} // namespace ahd

#endif
