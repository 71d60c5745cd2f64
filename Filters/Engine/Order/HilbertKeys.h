// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HilbertKeys_h
#define ahd_HilbertKeys_h

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

/// The flavours, for tests; only those that the processor has may be called.
namespace flavours
{
struct KeyFlavour
{
  const char* name;
  bool available;
  void (*keys)(const std::uint32_t*, const std::uint32_t*, std::uint64_t*, std::size_t);
};
/// The best one that is available is the last such.
extern const KeyFlavour kKeyFlavours[3];
}

} // namespace ahd

#endif
