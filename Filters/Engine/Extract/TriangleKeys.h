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
///
/// As no two triangles have the same two first corners, the third number may as well be the slot.
class TriangleKeys
{
public:
  using Key = std::uint64_t;

  /// What the third number of a key is.
  enum class Third
  {
    Corner,
    Slot ///< counted from 0, not by its half-edges
  };

  explicit TriangleKeys(const Mesh& mesh, Third third = Third::Corner)
    : ghost_(mesh.ghost())
    , third_(third)
  {
    for (blockBits_ = kBlockBits; true; --blockBits_)
    {
      const std::uint32_t mask = (1u << blockBits_) - 1;
      ghostNumber_ = (ghost_ + mask) & ~mask;
      cornerBits_ = bitLength(ghostNumber_ - 1);
      thirdBits_ = third == Third::Corner ? cornerBits_
                                          : bitLength(mesh.end() / Mesh::kSlotSize - 1);
      if (bits() <= 64)
      {
        return;
      }
    }
  }

  Third third() const { return third_; }

  /// The number of blocks, that of the ghost included.
  std::size_t blocks() const { return (ghostNumber_ >> blockBits_) + 1; }
  std::size_t blockSize() const { return std::size_t(1) << blockBits_; }

  /// Block and key of a triangle. @pre kThird == third(); its slot, if that is included.
  template <Third kThird>
  std::pair<std::size_t, Key> blockAndKey(const std::uint32_t* corners, std::size_t slot) const
  {
    const std::uint32_t a = corners[0] - ghost_, b = corners[1] - ghost_, c = corners[2] - ghost_;
    // The lowest corner and the one after it, without branches: the outcome is unpredictable.
    const Key first = std::min({ Key(a) << 32 | b, Key(b) << 32 | c, Key(c) << 32 | a });
    const std::uint32_t lowest = static_cast<std::uint32_t>(first >> 32);
    const std::uint32_t next = static_cast<std::uint32_t>(first);
    const std::uint32_t v0 = lowest + ghostNumber_;
    const Key v1 = next + ghostNumber_;
    const Key v2 = kThird == Third::Slot ? Key(slot) : (a ^ b ^ c ^ lowest ^ next) + ghostNumber_;
    const Key inBlock = v0 & ((1u << blockBits_) - 1);
    return { v0 >> blockBits_, ((inBlock << cornerBits_ | v1) << thirdBits_) | v2 };
  }

  /// The lowest corner's place in its block.
  std::size_t placeInBlock(Key key) const { return std::size_t(key >> (cornerBits_ + thirdBits_)); }
  /// The numbers of the two other corners: vertices, plus offset(). Of the third, or the slot.
  std::size_t second(Key key) const { return std::size_t(key >> thirdBits_ & maskOf(cornerBits_)); }
  std::size_t third(Key key) const { return std::size_t(key & maskOf(thirdBits_)); }
  std::size_t offset() const { return ghostNumber_ - ghost_; }
  /// How many low bits of a key may be set.
  unsigned bits() const { return blockBits_ + cornerBits_ + thirdBits_; }

private:
  static Key maskOf(unsigned bits) { return (Key(1) << bits) - 1; }

  static constexpr unsigned kBlockBits = 10; ///< at kMaximumPoints there is room for 8, or 7

  std::uint32_t ghost_;
  Third third_;
  std::uint32_t ghostNumber_ = 0;
  unsigned blockBits_ = 0;
  unsigned cornerBits_ = 0;
  unsigned thirdBits_ = 0;
};

} // namespace ahd

#endif
