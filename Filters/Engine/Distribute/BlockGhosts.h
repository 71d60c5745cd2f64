// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockGhosts_h
#define ahd_BlockGhosts_h

#include "BlockStars.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

class Ticker;

/// A triangle of another block.
struct GhostTriangle
{
  BlockPoint corners[3]; ///< the lowest first
  std::int64_t id;       ///< of the triangle, on all blocks
  std::uint64_t edges;   ///< those that are constraints

  bool operator<(const GhostTriangle& other) const { return id < other.id; }
  bool operator==(const GhostTriangle& other) const { return id == other.id; }
};

/// Triangles of other blocks around those of this one, in layers. The first: all that share a point
/// with a triangle of this block, or have one that it owns; each further one: all that share a
/// point with the one before.
///
/// The owner of a point has all triangles around it: so a layer is one request to the owners of the
/// points on its inside. Collective functions return Ok, Cancelled or OutOfMemory, the same on all
/// blocks.
class BlockGhosts
{
public:
  /// Borrows all of them; the stars until all is taken.
  BlockGhosts(const BlockStars& stars, BlockTransport& transport, const Context& context)
    : stars_(stars)
    , transport_(transport)
    , context_(context)
  {
  }

  /// Receives the ids of the triangles around. `firstId`: that of this block's first triangle; they
  /// ascend. Collective.
  Status begin(std::size_t firstId);
  /// Requests the next layer, and receives the number of its triangles. Collective. @pre
  /// begin().
  Status ask();
  /// Upper bound of the triangles received, to be received and to be sent.
  std::size_t countAll() const { return cells_.size() + coming_ + going_; }
  /// Receives the layer. Collective. @pre ask().
  Status take();

  /// The triangles received, by ascending id.
  const std::vector<GhostTriangle>& triangles() const { return cells_; }
  /// Adds their corners that others own to points of others; those then ascend, each once. Not
  /// collective.
  Status addForeign(std::vector<BlockPoint>& points) const;

private:
  using Ids = std::vector<std::int64_t>;
  using Corner = std::array<std::size_t, 2>; ///< an own point, and a triangle there

  GhostTriangle triangle(std::size_t place) const;
  bool hasPointOf(std::size_t block, std::size_t place) const;
  bool listIds(std::vector<Ids>& to, Ticker& ticker) const;
  bool takeIds(const std::vector<Ids>& from, Ticker& ticker);
  bool addForeign(std::vector<BlockPoint>& points, Ticker& ticker) const;
  bool listNew(std::vector<BlockPoint>& points, Ticker& ticker) const;
  bool listQuestions(std::vector<Ids>& to, Ticker& ticker);
  std::size_t ownPlace(std::int64_t id) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(stars_.ids, stars_.ids + stars_.points, id) - stars_.ids);
  }
  bool listAround(const std::vector<Ids>& asked, std::vector<Corner>& around, Ticker& ticker) const;
  bool findAnswers(const std::vector<Ids>& asked, Ticker& ticker);

  const BlockStars& stars_;
  BlockTransport& transport_;
  const Context context_;
  std::int64_t firstId_ = 0;
  Ids aroundIds_;
  std::vector<GhostTriangle> cells_;
  std::vector<BlockPoint> known_; ///< points of others whose triangles came, ascending
  bool hasLayer_ = false;
  std::vector<std::vector<std::size_t>> answers_; ///< for each block, triangles by place
  std::size_t coming_ = 0, going_ = 0;
};

} // namespace ahd

#endif
