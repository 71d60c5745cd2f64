// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TilePlan_h
#define ahd_TilePlan_h

#include "../Constraints.h"
#include "../Core/Context.h"
#include "../Core/Fingerprint.h"
#include "../Distribute/BlockBoxes.h"
#include "../Distribute/BlockBytes.h"
#include "../Result.h"
#include "../Sample/Sample.h"
#include "TileGrid.h"

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace ahd
{

/// Bytes of the caller's.
struct TileView
{
  const unsigned char* data;
  std::size_t size;
};
/// `kind`: distinguishes equal bytes.
Fingerprint fingerprintOf(const TileView& bytes, std::uint64_t kind);

/// A leaf: a box of the grid of ranks, and the points in it, duplicates included.
struct TileLeaf
{
  std::uint64_t key;
  std::uint64_t level;
  std::uint64_t count;

  TileBox box() const { return { key, static_cast<std::uint32_t>(level) }; }
  auto fields() { return std::tie(key, level, count); }
};

/// Lines and loops: the places of the corners of chains.
struct TileLines
{
  std::vector<Point> corners;
  std::vector<std::int64_t> offsets; ///< chain i has the corners from offset i to i + 1
  std::uint64_t lines = 0;           ///< the chains that are not closed, which come first
  std::uint64_t rule = 0;            ///< FillRule

  std::size_t chains() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  auto fields() { return std::tie(corners, offsets, lines, rule); }
};

/// What a plan is made of.
struct TileFacts
{
  Bounds bounds;               ///< of all points; empty without any
  Bounds extent;               ///< that places belong to leaves in: holds the bounds
  std::uint64_t hasPlaces = 0; ///< 0: there are no places but those of points
  std::uint64_t points = 0, notFinite = 0;
  std::vector<TileLeaf> leaves; ///< along the curve; at least one
  TileLines lines;

  auto fields() { return std::tie(bounds, extent, hasPlaces, points, notFinite, leaves, lines); }
};

/// How points are divided into leaves, and the tree above these. Immutable; all of it follows from
/// its facts.
///
/// Parts are the leaves, then the nodes, each behind the parts that it joins; the last one is the
/// root.
class TilePlan
{
public:
  /// Throws std::bad_alloc, as all below.
  explicit TilePlan(TileFacts facts);

  const TileFacts& facts() const { return facts_; }
  /// That ranks points within the bounds.
  const TileGrid& grid() const { return grid_; }
  const TileLeaf& leaf(std::size_t k) const { return facts_.leaves[k]; }
  std::size_t leaves() const { return facts_.leaves.size(); }
  std::size_t parts() const { return parents_.size(); }
  std::size_t root() const { return parts() - 1; }
  /// Of each part, parts() for the root.
  const std::vector<std::size_t>& parents() const { return parents_; }
  /// The parts that a node joins, ascending; none of a leaf.
  const std::vector<std::size_t>& joinedBy(std::size_t part) const { return joined_[part]; }
  /// The leaves of a part.
  const BlockRow& rowOf(std::size_t part) const { return rows_[part]; }
  /// The number of the leaf's first point in the order of all leaves.
  std::uint64_t firstPoint(std::size_t k) const { return firstPoints_[k]; }

  /// The places of a leaf, sides included. They are apart from those of other leaves.
  const Bounds& box(std::size_t k) const { return boxes_[k]; }
  /// Of a part: a box with all of the surface that is within rounding of its places; empty where
  /// there is neither a point nor a place to have a value.
  const Bounds& reach(std::size_t part) const { return reaches_[part]; }
  /// By how much, at most, reaches of leaves overlap.
  double overlap() const { return overlap_; }

  /// Are there lines or loops? Loops?
  bool hasLines() const { return facts_.lines.chains() != 0; }
  bool hasLoops() const { return facts_.lines.chains() > facts_.lines.lines; }

  /// The leaves of the points from `begin` to `end`; -1 for one that is not finite.
  void findLeaves(
    const PointView& points, std::size_t begin, std::size_t end, std::int32_t* leaves) const;
  /// The same of one point.
  std::int32_t leafOf(const Point& p) const;
  /// The places of the raster that belong to the leaf.
  SampleRaster pieceOf(const SampleRaster& whole, std::size_t k) const;
  /// Do all places of the raster belong to leaves?
  bool holds(const SampleRaster& raster) const;

  /// Bytes that read() takes. They say whether they are whole.
  BlockBytes write() const;
  /// False for other bytes.
  static bool read(const unsigned char* bytes, std::size_t size, TileFacts& facts);
  /// Differs for different plans.
  const Fingerprint& fingerprint() const { return fingerprint_; }

private:
  void arrange();
  std::size_t joinParts(const TileBox& box, std::size_t& leaf);
  void measure();
  void indexKeys();
  std::int32_t leafOf(std::uint64_t key) const;

  TileFacts facts_;
  TileGrid grid_;
  std::vector<std::uint32_t> before_; ///< k: the leaves whose keys are below k times 2^48
  std::vector<Bounds> boxes_, reaches_;
  std::vector<std::uint64_t> firstPoints_;
  std::vector<std::size_t> parents_;
  std::vector<std::vector<std::size_t>> joined_;
  std::vector<BlockRow> rows_;
  double overlap_ = 0.0;
  Fingerprint fingerprint_ = {};
};

} // namespace ahd

#endif
