// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TileVisits_h
#define ahd_TileVisits_h

#include "../Core/Context.h"
#include "../Options.h"
#include "../Points/Points.h"
#include "TileBytes.h"
#include "TilePlan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// All points of a leaf, borrowed: places, and ids that ascend. Without ids, these are the numbers
/// of the points in the order of all leaves.
struct TilePoints
{
  std::size_t leaf;
  PointView points;
  const std::int64_t* ids = nullptr;
};

/// What was kept of first visits, for the second one of a leaf.
struct TileKept
{
  const TileView* own = nullptr;                      ///< of the leaf
  const std::vector<TileSection>* sections = nullptr; ///< of the nodes above
};

/// What a visit gives. Each fills what it says.
struct TileOutput
{
  BlockBytes border, own, share;
  std::vector<std::int64_t> triangles; ///< three ids each
  std::vector<std::uint8_t> edges;     ///< of each triangle: bit e is set if e is a constraint
  std::vector<double> listPoints;      ///< x and y each
  std::vector<std::int64_t> listIds;
  std::vector<std::int64_t> surface; ///< triangles: places among the leaf's points, then the list
  std::vector<std::uint8_t> surfaceEdges;
};

/// Visits of leaves and nodes of one plan. What they give depends on arguments and plan alone.
/// Functions that return a Status return Ok, Cancelled or OutOfMemory.
class TileVisits
{
public:
  /// Throws std::bad_alloc.
  explicit TileVisits(TileFacts facts);

  const TilePlan& plan() const { return plan_; }

  /// What is wrong with the points or ids, and with what was kept of a visit of these; null:
  /// nothing.
  Status findFault(const TilePoints& given, const TileKept& kept, const Context& context,
    const char*& fault) const;

  /// Triangulates the points of a leaf: border and own. @pre no fault
  Status visit(const TilePoints& given, Representative representative, const Context& context,
    TileOutput& out) const;

  /// Reads borders of the parts that a node joins; false if these bytes are others.
  bool readBorders(
    std::size_t node, const std::vector<TileView>& given, std::vector<TileBorder>& borders) const;
  /// Merges them, which are consumed: border, but of the root, and share.
  Status merge(std::size_t node, std::vector<TileBorder>& borders, const Context& context,
    TileOutput& out) const;

  /// Reads what the nodes above a leaf have for it, from the one that joins it to the root; false
  /// if these bytes are others.
  bool readSections(std::size_t leaf, const std::vector<TileView>& shares,
    std::vector<TileSection>& sections) const;
  /// The triangles of a leaf in canonical order, and their edges. @pre no fault
  Status makeTriangles(
    const TilePoints& given, const TileKept& kept, const Context& context, TileOutput& out) const;
  /// The points of other leaves among those of the sections.
  Status makeList(std::size_t leaf, const std::vector<TileSection>& sections,
    const Context& context, TileOutput& out) const;

private:
  bool areOf(const TilePoints& given, const TileSection& section) const;

  TilePlan plan_;
  Surroundings around_;
};

/// Writes the share of a node, whose final triangles are known. Returns false if cancelled; throws
/// std::bad_alloc.
bool writeShare(
  const TilePlan& plan, std::size_t node, const Part& part, Ticker& ticker, BlockBytes& share);

} // namespace ahd

#endif
