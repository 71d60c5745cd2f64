// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockNeeds_h
#define ahd_BlockNeeds_h

#include "../Sample/BoxNeighbors.h"
#include "../Triangulate.h"
#include "../Triangulation/Triangulation.h"
#include "BlockStars.h"

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace ahd
{

class Ticker;

/// Finds the points of all blocks that one block needs to interpolate at its own places as if it
/// had all points (Sample/BoxNeighbors.h). Each block triangulates its own points and a few that
/// all blocks share: so it can find which of its points others need.
///
/// Of constraints, loops may hide the nearest vertex, others do not: with loops it takes all
/// points.
///
/// Collective functions return Ok, Cancelled, TooManyPoints or OutOfMemory, the same on all blocks.
class BlockNeeds
{
public:
  /// What is wanted beside the surface around a place.
  enum class Also
  {
    Nothing,
    Nearest, ///< the nearest vertices, which constraints may hide
    All      ///< whatever there is: the nearest place of the rim, say
  };

  /// Borrows all of them. The options of `input` are ignored.
  BlockNeeds(const BlockInput& input, Also also, BlockTransport& transport, const Context& context)
    : input_(input)
    , also_(also)
    , transport_(transport)
    , context_(context)
  {
  }

  /// Triangulates. Collective.
  Status begin();
  /// Of the points of all blocks. @pre begin().
  Bounds bounds() const { return boundsOf(made_); }
  /// Lists what this block needs for places in these boxes, all that coincide with one of them
  /// included, ascending; none without boxes. Collective. @pre begin().
  Status find(const std::vector<Bounds>& boxes, std::vector<BlockPoint>& needed);

private:
  using Pair = std::pair<Index, Index>;
  struct Shared ///< a point shared by all blocks
  {
    std::int64_t id;
    Point at;

    bool operator<(const Shared& other) const { return id < other.id; }
    auto fields() { return std::tie(id, at); }
  };
  struct Facts
  {
    std::uint64_t crowd = 0;
    bool crosses = false;
    Bounds bounds; ///< of own points

    auto fields() { return std::tie(crowd, crosses, bounds); }
  };

  Status listShared(std::vector<Shared>& shared, Ticker& ticker);
  bool readOwn(Ticker& ticker);
  std::int64_t numberOf(std::int64_t id) const;
  bool addShared(const std::vector<std::vector<Shared>>& all, Ticker& ticker);
  Status make(const std::vector<std::vector<Shared>>& all, Ticker& ticker);
  Status constrain(Ticker& ticker);
  bool listCoincident(Ticker& ticker);
  bool addCoincident(std::vector<Index>& numbers, Ticker& ticker) const;
  bool mustTakeAll(const std::vector<Facts>& all) const;
  Status list(const std::vector<Bounds>& boxes, std::vector<std::int64_t>& ids, Ticker& ticker);

  const BlockInput input_;
  const Also also_;
  BlockTransport& transport_;
  const Context context_;
  std::vector<double> places_;    ///< x, y: of own points, then of shared ones of others
  std::vector<std::int64_t> ids_; ///< of all: own ones ascend, and so do the others behind
  std::size_t own_ = 0;           ///< that are triangulated
  Bounds ownBounds_;
  std::vector<Index> shared_;    ///< own ones, as numbers
  std::vector<Pair> coincident_; ///< representative, another at its place; ascending
  bool listsAll_ = false;
  Workspace workspace_;
  Triangulation plain_, made_; ///< without constraints, if needed; with them
};

/// Upper estimate of the bytes that this takes for so many own and shared points.
std::size_t needsMemoryEstimate(std::size_t points, std::size_t constraintIds, bool nearest);

} // namespace ahd

#endif
