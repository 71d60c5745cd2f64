// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TileBytes_h
#define ahd_TileBytes_h

#include "../Constraints.h"
#include "../Distribute/Part.h"
#include "TilePlan.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <vector>

namespace ahd
{

// What visits leave for later ones, as bytes that a caller keeps. They begin with what they are,
// and of which plan and part. Numbers are written as they lie in memory. Fingerprints show whether
// any have changed: what is read is as it was written, so it is not checked further.

enum class TileKind : std::uint64_t
{
  Border = 1, ///< of a part: for the node that joins it
  Own = 2,    ///< of a leaf: triangles that are final there
  Share = 3   ///< of a node: for each leaf that it joins
};

/// What follows is of this kind, and of this part. @pre `bytes` is empty
void beginBytes(TileKind kind, const TilePlan& plan, std::size_t part, BlockBytes& bytes);
/// All of it is written.
void endBytes(BlockBytes& bytes);
/// What follows; null data unless the bytes are whole, as is said, and unchanged. Of a share it
/// reads a few bytes: sections have fingerprints of their own.
TileView contentOf(TileKind kind, const TilePlan& plan, std::size_t part, const TileView& bytes);

/// What goes from a part to the node that joins it.
struct TileBorder
{
  PartBorder border;
  /// Of each edge, the piece of the final region on its left; empty if there are no loops.
  std::vector<Index> pieces;

  auto fields() { return std::tie(border, pieces); }
};

/// What a leaf keeps for its second visit: triangles that are final there, in canonical order.
struct TileOwn
{
  const unsigned char* triples = nullptr; ///< numbers of points, three each; not aligned
  std::size_t count = 0;
  /// Of each the piece of the final region; empty if there is one, or there are no loops.
  std::vector<Index> pieces;

  std::array<Index, 3> operator[](std::size_t triangle) const
  {
    std::array<Index, 3> corners;
    std::memcpy(corners.data(), triples + triangle * sizeof corners, sizeof corners);
    return corners;
  }
};

/// False if these bytes are not the own of the leaf.
bool readOwn(const TilePlan& plan, std::size_t leaf, const TileView& bytes, TileOwn& own);

/// What a leaf needs of a node above: the triangles that have become final there whose closed
/// circumdiscs meet its box, so all that have a corner in it; their corners, and more points.
struct TileSection
{
  /// The lowest corner is the leaf's. Bits 0 to 2: constraint edges, from the first corner on.
  static constexpr std::uint8_t kOwned = 8;

  std::vector<BorderPoint> points;
  std::vector<std::array<Index, 3>> corners; ///< places among the points, counterclockwise
  std::vector<std::uint8_t> flags;           ///< of each triangle

  // With loops:
  /// Of each triangle the piece of the final region; in the root none, as they are kept.
  std::vector<Index> pieceOf;
  /// Of each piece of the part below that has the leaf, the piece here; in the root 1 if it is
  /// kept, else 0.
  std::vector<Index> pieces;

  auto fields() { return std::tie(points, corners, flags, pieceOf, pieces); }
};

/// What became of lines and loops, as tiles_constraints has it (ahd_tiles.h).
using TileConstraints = std::array<std::int64_t, 6>;
TileConstraints constraintsOf(const ConstraintReport& report);

/// Writes the share of a node, with a section for each leaf that it joins, ascending.
class ShareWriter
{
public:
  /// `constraints`: of the root; elsewhere they say nothing.
  ShareWriter(
    const TilePlan& plan, std::size_t node, const TileConstraints& constraints, BlockBytes& bytes);
  /// That of the next leaf.
  void add(const TileSection& section);
  void end() { endBytes(bytes_); }

private:
  BlockBytes& bytes_;
  std::size_t leaf_;  ///< the next one
  std::size_t index_; ///< where the end of its section is written
};

/// Reads the section of a leaf. False if these bytes are not the share of the node, or the section
/// has changed. @pre the node joins the leaf
bool readSection(const TilePlan& plan, std::size_t node, std::size_t leaf, const TileView& share,
  TileSection& section);
/// What its writer was given. False if these bytes are not the share of the node.
bool readConstraints(
  const TilePlan& plan, std::size_t node, const TileView& share, TileConstraints& constraints);

} // namespace ahd

#endif
