// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HilbertKeys_h
#define ahd_HilbertKeys_h

#include "../Core/Dispatch.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Most boxes that hilbertKeys takes at once: their places and keys stay in the first-level cache.
constexpr std::size_t kKeyBlock = 256;

/// keys[i] = hilbertKey(columns[i], rows[i]) (HilbertCurve.h) for i below count <= kKeyBlock, many
/// at a time: compiled for several kinds of processors, the same keys on all.
void hilbertKeys(
  const std::uint32_t* columns, const std::uint32_t* rows, std::uint64_t* keys, std::size_t count);

/// As it is compiled for each instruction set; for tests. Only those that the processor has may be
/// called.
using HilbertKeys = void(
  const std::uint32_t* columns, const std::uint32_t* rows, std::uint64_t* keys, std::size_t count);
extern const DispatchTarget<HilbertKeys> kHilbertKeysTargets[3];

} // namespace ahd

#endif
