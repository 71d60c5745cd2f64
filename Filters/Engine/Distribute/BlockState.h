// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockState_h
#define ahd_BlockState_h

#include "BlockFronts.h"
#include "BlockTriangulation.h"
#include "Part.h"

#include <array>
#include <map>
#include <tuple>

namespace ahd
{

/// Data of an id of the constraints: the location of its point, and the vertex there.
struct ChainEnd
{
  std::uint64_t place; ///< among the ids of the constraints
  Point at;
  std::int64_t vertex; ///< the id of the point that stands for it

  auto fields() { return std::tie(place, at, vertex); }
};

/// The number of ids in the constraints.
inline std::size_t constraintIds(const ConstraintView& given)
{
  return given.chains == 0
    ? 0
    : static_cast<std::size_t>(given.offsets[given.chains] - given.offsets[0]);
}

/// The first message of a block to all.
struct BlockFacts
{
  Bounds bounds;
  Report counts;

  auto fields() { return std::tie(bounds, counts); }
};

/// The last message of a block to all.
struct BlockTotals
{
  std::size_t own = 0, shared = 0; ///< triangles
  bool isHostOfAll = false;
  ConstraintReport constraints; ///< of the host of all

  auto fields() { return std::tie(own, shared, isHostOfAll, constraints); }
};

/// A triangle that other blocks took part in: its corners by number.
struct SharedTriangle
{
  std::array<Index, 3> corners;
  std::uint8_t flags;
};

struct BlockTriangulation::State
{
  /// The next exchange.
  enum class Step
  {
    Facts,  ///< all: of the blocks, and where segments end
    Counts, ///< all: of the borders of one level
    Up,     ///< some: borders to the level above
    Down,   ///< some: which edges are kept, and triangles, to the level below
    Totals, ///< all: counts of the result
    Done
  };

  BlockInput input;
  Step step = Step::Facts;
  BlockBytes toAll;
  std::vector<BorderCount> borders;
  BlocksReport report;

  Surroundings around;
  std::vector<ChainEnd> ends;                ///< by place
  std::vector<BlockFront> fronts;            ///< by level; the last is the current one
  std::map<std::size_t, Part> parts;         ///< by level: those that this block hosts
  std::map<std::size_t, PartBorder> pending; ///< by level: not sent yet
  std::size_t level = 0;                     ///< of the current parts

  bool isHostOfAll = false;              ///< was the part of all blocks made here?
  std::vector<BorderPoint> sharedPoints; ///< the corners of shared triangles
  std::vector<SharedTriangle> shared;    ///< first this block's, then ghosts
  std::size_t sharedOwn = 0;             ///< this block's
  std::vector<ForeignPoint> foreign;

  Part& own() { return parts[0]; }

  bool beginFacts(Ticker& ticker);
  bool takeFacts(const std::vector<BlockBytes>& all, Ticker& ticker);
  bool joinSegments(const BlockRow& row, std::size_t points, Ticker& ticker);
  bool findOwnEnds(std::vector<Index>& vertices, std::vector<ChainEnd>& found, Ticker& ticker);
  bool settle(std::size_t atLevel, Ticker& ticker);
  void takeCounts(const std::vector<BlockBytes>& all);
  void takeTotals(const std::vector<BlockBytes>& all);

  void giveBorder(std::vector<BlockMessage>& out);
  Status takeBorders(const std::vector<BlockMessage>& in, const Context& context);
  bool placeEnds(std::vector<std::int64_t>& placeOf, Ticker& ticker);
  bool placeConstraints(
    std::vector<std::int64_t>& ids, std::vector<std::int64_t>& offsets, Ticker& ticker);
  Status constrainAll(const Context& context);
  bool giveDown(std::vector<BlockMessage>& out, Ticker& ticker);
  bool takeDown(const std::vector<BlockMessage>& in, Ticker& ticker);
  bool numberShared(Ticker& ticker);
  void sayTotals();

  template <typename Id>
  bool writeShared(std::size_t begin, std::size_t end, Id* triples, Ticker& ticker) const;
};

} // namespace ahd

#endif
