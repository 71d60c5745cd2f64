// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TileVisits_h
#define ahd_TileVisits_h

#include "../Core/Context.h"
#include "../Options.h"
#include "../Points/Points.h"
#include "TileBytes.h"
#include "TilePlan.h"
#include "TileSegments.h"

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
  TileOwn own;
  std::vector<TileSection> sections; ///< of the nodes above, from the one that joins it to the root

  /// Is it kept by loops?
  bool isOwnKept(std::size_t triangle) const
  {
    return flags.empty() || flags[0][own.pieces.empty() ? 0 : own.pieces[triangle]] != 0;
  }
  bool isKept(std::size_t section, std::size_t triangle) const
  {
    return section + 1 >= flags.size() ||
      flags[section + 1][sections[section].pieceOf[triangle]] != 0;
  }

  /// With loops: of the parts below each of these nodes, for each piece 1 if it is kept.
  std::vector<std::vector<std::uint8_t>> flags;
  std::vector<std::int64_t> constraints; ///< with lines or loops: TileConstraints
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
  /// With lines or loops, where the root is known: TileConstraints.
  std::vector<std::int64_t> constraints;
};

/// Visits of leaves and nodes of one plan. What they give depends on arguments and plan alone.
/// Functions that return a Status return Ok, Cancelled or OutOfMemory.
class TileVisits
{
public:
  /// Throws std::bad_alloc.
  explicit TileVisits(TileFacts facts);

  const TilePlan& plan() const { return plan_; }

  /// What is wrong with the points or ids; null: nothing.
  Status findFault(const TilePoints& given, const Context& context, const char*& fault) const;

  /// Triangulates the points of a leaf: border and own. @pre no fault
  Status visit(const TilePoints& given, Representative representative, const Context& context,
    TileOutput& out) const;

  /// Reads borders of the parts that a node joins; false if these bytes are others.
  bool readBorders(
    std::size_t node, const std::vector<TileView>& given, std::vector<TileBorder>& borders) const;
  /// Merges them, which are consumed: border, but of the root, and share.
  Status merge(std::size_t node, std::vector<TileBorder>& borders, const Context& context,
    TileOutput& out) const;

  /// Reads what was kept for a leaf, without its own if that is null. False if these bytes are
  /// others.
  bool readKept(std::size_t leaf, const TileView* own, const std::vector<TileView>& shares,
    TileKept& kept) const;
  /// Are the points that it names among these?
  Status findFits(
    const TilePoints& given, const TileKept& kept, const Context& context, bool& fits) const;

  /// The triangles of a leaf in canonical order, and their edges. @pre no fault, it fits
  Status makeTriangles(
    const TilePoints& given, const TileKept& kept, const Context& context, TileOutput& out) const;
  /// The points of other leaves that it needs.
  Status makeList(
    std::size_t leaf, const TileKept& kept, const Context& context, TileOutput& out) const;
  /// The list, and the triangles that values at the leaf's places need, none with an edge longer
  /// than `longest` (0: no limit). Edges where they end count as constraints. @pre no fault, it
  /// fits
  Status makeSurface(const TilePoints& given, const TileKept& kept, double longest,
    const Context& context, TileOutput& out) const;

private:
  bool readSections(std::size_t leaf, const std::vector<TileView>& shares, TileKept& kept) const;
  std::vector<std::int64_t> tellConstraints(const TileConstraints& counts) const;
  bool followPieces(TileKept& kept) const;
  bool areOf(const TilePoints& given, const TileSection& section) const;
  // Lines and loops (TileLines.cxx).
  void dealCorners();
  bool findEnds(std::size_t leaf, Part& part, Ticker& ticker) const;
  bool joinSegments(
    std::size_t part, std::size_t points, Surroundings& around, Ticker& ticker) const;
  Status constrain(Part& part, const Context& context) const;

  TilePlan plan_;
  TileSegments segments_; ///< of the plan
  BlockBoxes boxes_;
  std::vector<std::vector<Point>> corners_; ///< of lines and loops, by leaves, sorted; empty: none
};

/// Writes the share of a node, whose final triangles are known. `borders`: the pieces of the parts
/// below. Returns false if cancelled; throws std::bad_alloc. Where most leaves need most triangles,
/// as on a circle, it takes their product: it requests its memory (Progress::take()).
bool writeShare(const TilePlan& plan, std::size_t node, const Part& part,
  const std::vector<TileBorder>& borders, Ticker& ticker, BlockBytes& share);

} // namespace ahd

#endif
