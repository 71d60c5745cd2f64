// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TriangleKeys_h
#define ahd_TriangleKeys_h

#include "../Core/Chunks.h"
#include "../Core/Progress.h"
#include "../Mesh/Mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace ahd
{

/// A triangle in 64 bits. Vertices lie in blocks; within the block of its lowest corner, the key
/// holds that corner's place in the block and then the two corners that follow counterclockwise, so
/// that ascending keys are the canonical order.
///
/// Vertices are renumbered for this: by their distance from the end, such that the ghost begins a
/// block of its own, the last, and still counts as lower than any other when the lowest corner is
/// looked for. So the ghost triangles come last, and no loop has to branch on them.
class TriangleKeys
{
public:
  using Key = std::uint64_t;

  explicit TriangleKeys(const Mesh& mesh)
    : ghost_(mesh.ghost())
  {
    for (blockBits_ = kBlockBits; true; blockBits_ = kFewBlockBits)
    {
      const std::uint32_t mask = (1u << blockBits_) - 1;
      ghostNumber_ = (ghost_ + mask) & ~mask;
      cornerBits_ = bitLength(ghostNumber_ - 1);
      if (blockBits_ + 2 * cornerBits_ <= 64)
      {
        return;
      }
    }
  }

  /// The number of blocks, that of the ghost included.
  std::size_t blocks() const { return (ghostNumber_ >> blockBits_) + 1; }
  std::size_t blockSize() const { return std::size_t(1) << blockBits_; }

  /// The block of the triangle's lowest corner.
  std::size_t blockOf(const std::uint32_t* corners) const
  {
    const std::uint32_t lowest = std::min(
      { corners[0] - ghost_, corners[1] - ghost_, corners[2] - ghost_ });
    return (lowest + ghostNumber_) >> blockBits_;
  }

  /// Block and key.
  std::pair<std::size_t, Key> operator()(const std::uint32_t* corners) const
  {
    const std::uint32_t a = corners[0] - ghost_, b = corners[1] - ghost_, c = corners[2] - ghost_;
    // The lowest corner and the one after it, without branches: which it is, is as good as random.
    const Key first = std::min({ Key(a) << 32 | b, Key(b) << 32 | c, Key(c) << 32 | a });
    const std::uint32_t lowest = static_cast<std::uint32_t>(first >> 32);
    const std::uint32_t next = static_cast<std::uint32_t>(first);
    const std::uint32_t v0 = lowest + ghostNumber_;
    const Key v1 = next + ghostNumber_;
    const Key v2 = (a ^ b ^ c ^ lowest ^ next) + ghostNumber_;
    const Key inBlock = v0 & ((1u << blockBits_) - 1);
    return { v0 >> blockBits_, ((inBlock << cornerBits_ | v1) << cornerBits_) | v2 };
  }

  /// The lowest corner's place in its block.
  std::size_t placeInBlock(Key key) const { return std::size_t(key >> (2 * cornerBits_)); }
  /// The numbers of the two other corners: vertices, plus offset().
  std::size_t second(Key key) const { return std::size_t(key >> cornerBits_ & cornerMask()); }
  std::size_t third(Key key) const { return std::size_t(key & cornerMask()); }
  std::size_t offset() const { return ghostNumber_ - ghost_; }
  /// How many low bits of a key may be set.
  unsigned bits() const { return blockBits_ + 2 * cornerBits_; }

private:
  Key cornerMask() const { return (Key(1) << cornerBits_) - 1; }

  static constexpr unsigned kBlockBits = 10;
  static constexpr unsigned kFewBlockBits = 8; ///< for which there is room up to kMaximumPoints

  std::uint32_t ghost_;
  std::uint32_t ghostNumber_ = 0;
  unsigned blockBits_ = 0;
  unsigned cornerBits_ = 0;
};

} // namespace ahd

#endif
