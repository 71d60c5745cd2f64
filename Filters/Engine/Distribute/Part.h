// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Part_h
#define ahd_Part_h

#include "../Constraints.h"
#include "../Core/Buffer.h"
#include "../Core/Chunks.h"
#include "../Mesh/Mesh.h"
#include "../Triangulate.h"
#include "../Triangulation/State.h"
#include "BlockBoxes.h"
#include "SegmentTree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace ahd
{

/// A vertex as sent to other blocks.
struct BorderPoint
{
  Point at;
  std::int64_t id;     ///< the caller's
  std::uint32_t block; ///< that owns it
  std::uint32_t marks; ///< those of one that goes up to the part of all, whatever is final around

  enum : std::uint32_t
  {
    kEndOfSegment = 1,
    kOfCrowd = 2 ///< more points than crowdLimit() (BoxNeighbors.h) lie in one cell
  };

  auto fields() { return std::tie(at, id, block, marks); }
};
static_assert(sizeof(BorderPoint) == 4 * sizeof(double), "a PointView looks at it");

/// An edge of the border of the final region, which lies on its left. Places among the points.
struct BorderEdge
{
  Index from, to;
};

/// The data that a part sends up.
struct PartBorder
{
  std::vector<BorderPoint> points;
  std::vector<BorderEdge> edges;

  auto fields() { return std::tie(points, edges); }
};

/// Triangles for a block that owns a corner of each.
struct OwnedTriangles
{
  /// A flag of a triangle whose lowest corner another block owns. Bits 0 to 2: constraint edges,
  /// from the lowest corner on.
  static constexpr std::uint8_t kGhost = 8;

  std::vector<BorderPoint> points; ///< their corners
  std::vector<Index> corners;      ///< three places each, the lowest corner first
  std::vector<std::uint8_t> flags; ///< of each triangle

  auto fields() { return std::tie(points, corners, flags); }
};

/// What triangles are tested against: the others' boxes and the segments.
struct Surroundings
{
  BlockBoxes boxes;
  SegmentTree segments;
};

/// The triangulation of the points of a row of blocks, as far as it was not final in parts of it:
/// at the bottom one block's own, above that of the points that the parts below handed up.
///
/// A triangle is *final* if it is known to be in the triangulation of all blocks' points and all
/// constraints: no point of another block lies in its closed circumdisc, and no segment touches it;
/// or the row has all blocks. What was final below is the region on the left of the edges that were
/// handed up; of this the part knows the border, not the triangles.
///
/// Functions that return bool return false if the work is cancelled, and throw
/// std::bad_alloc.
class Part
{
public:
  /// Of a block's own points, with their global ids.
  Status makeOwn(const PointView& points, const std::int64_t* ids, std::uint32_t block,
    const Options& options, const Context& context);
  /// Of the data sent up, which is consumed.
  Status makeOf(std::vector<PartBorder>& below, const Context& context);
  /// Inserts the constraints; their ids are places among given(). @pre makeOf(), all blocks.
  Status constrain(const ConstraintView& constraints, FillRule rule, const Context& context);

  /// The vertices where segments end, ascending. @pre makeOwn().
  void setEnds(std::vector<Index> ends) { ends_ = std::move(ends); }
  /// All points of a crowd shall go up if one does. @pre makeOwn().
  void keepCrowds() { keepsCrowds_ = true; }

  /// Finds the region that was final below. @pre makeOf().
  bool findBelow(Ticker& ticker);
  /// Finds the final triangles, in a row that has not all blocks.
  bool findFinal(const BlockRow& row, const Surroundings& around, Ticker& ticker);
  /// All that was not final below is; what loops dropped is known.
  bool finishAll(Ticker& ticker);

  /// The data that the part above needs: the corners of triangles that are not final, the vertices
  /// of the hull, the ends of segments; all, where there is no triangle.
  bool makeBorder(PartBorder& border, Ticker& ticker);

  /// For each edge sent up: is the region on its left kept? One answer for all, or one for each.
  struct Kept
  {
    bool isAll = true;
    std::vector<std::uint8_t> edges;

    auto fields() { return std::tie(isAll, edges); }
  };
  /// Receives it from the part above. @pre makeBorder().
  bool takeKept(const Kept& kept, Ticker& ticker);
  /// Makes it for a part below, by its place among those of makeOf(). After takeKept(), or in the
  /// part of all blocks finishAll().
  void tellKept(std::size_t child, Kept& kept) const;

  /// Numbers the connected pieces of the region that is final, here or below: each is kept, or not,
  /// as a whole. @pre makeBorder()
  bool findPieces(Ticker& ticker);
  /// The piece on the left of each edge that was sent up; in all pieceCount().
  std::vector<Index> piecesOfBorder() const;
  std::size_t pieceCount() const { return pieceCount_; }
  /// That on the left of each edge of a part below. @pre makeOf()
  std::vector<Index> piecesBelow(std::size_t child) const;

  /// Lists the triangles that have become final here and are kept, by the blocks that own corners,
  /// from the row's first one.
  bool listOwned(const BlockRow& row, std::vector<OwnedTriangles>& owned, Ticker& ticker) const;

  /// Calls visit(corners, flags, piece) for those: the ids of points, numbers in the view that was
  /// triangulated, counterclockwise; bit e if the edge from corner e is a constraint; 0 where
  /// pieces are not numbered.
  template <typename Visit>
  bool eachFinal(Ticker& ticker, Visit visit) const;
  /// Calls visit(a, b) for each edge of the hull, which lies on its left: places among given().
  template <typename Visit>
  void eachHullEdge(Visit visit) const;

  /// How many triangles have become final here and are kept.
  std::size_t finalTriangles() const { return finalTriangles_; }
  /// Writes these as triples of vertices' points, in canonical order. @pre makeOwn(). The locations
  /// are lost then.
  template <typename Id>
  bool writeFinal(Id* triples, Ticker& ticker);
  /// The pieces of these, in the same order. @pre findPieces()
  bool listPieces(std::vector<Index>& pieces, Ticker& ticker) const;

  bool hasTriangles() const { return slots_ != 0; }
  Triangulation& triangulation() { return made_; }
  const Triangulation& triangulation() const { return made_; }
  const std::vector<BorderPoint>& given() const { return given_; }

private:
  enum : std::uint8_t
  {
    kBelow = 1,  ///< in the region that was final below
    kOpen = 2,   ///< a ghost, or not final
    kGone = 4,   ///< dropped by loops
    kSeen = 8,   ///< by the search that takes kept regions
    kTested = 16 ///< by the search for what is final
  };

  /// The obstacles that a triangle is tested against.
  struct Neighborhood
  {
    const BlockRow& row;
    const Surroundings& around;
    Bounds freeBox;
  };

  TriangulationAccess::State& state() { return *TriangulationAccess::stateOf(made_); }
  const TriangulationAccess::State& state() const { return *TriangulationAccess::stateOf(made_); }
  bool begin(Ticker& ticker);
  BorderPoint describe(Index vertex) const;

  std::uint8_t label(Mesh::Halfedge h) const { return labels_[h / Mesh::kSlotSize]; }
  bool isGhost(Mesh::Slot slot) const
  {
    return data_[slot] == ghost_ || data_[slot + 1] == ghost_ || data_[slot + 2] == ghost_;
  }
  /// Is it final, here or below?
  bool isSettled(Mesh::Halfedge h) const { return (label(h) & kOpen) == 0; }
  static constexpr std::uint8_t kNotHere = kBelow | kOpen | kGone;
  bool isFinalAndKept(Mesh::Slot slot) const { return (label(slot) & kNotHere) == 0; }
  Index origin(Mesh::Halfedge h) const { return data_[Mesh::next(h)]; }
  Index destination(Mesh::Halfedge h) const { return data_[Mesh::previous(h)]; }
  Mesh::Halfedge twin(Mesh::Halfedge h) const { return data_[h + Mesh::kTwin]; }
  Corners cornersOf(Mesh::Slot slot) const;

  template <typename Visit>
  bool eachSlot(Ticker& ticker, Visit visit) const;
  template <typename MayEnter>
  bool flood(Mesh::Slot from, std::uint8_t label, MayEnter mayEnter, Ticker& ticker);
  bool findEdgesBelow(Ticker& ticker);
  SegmentTree::Answer test(Mesh::Slot slot, const Neighborhood& near, Ticker& ticker) const;
  bool spread(Mesh::Slot from, const Neighborhood& near, Ticker& ticker);
  bool listVertices(std::vector<Index>& vertices, Ticker& ticker) const;
  bool addCrowds(std::vector<Index>& vertices, Ticker& ticker);
  bool listEdges(PartBorder& border, const std::vector<Index>& vertices, Ticker& ticker);
  bool countFinal(Ticker& ticker);
  void giveOut(Mesh::Slot slot, const BlockRow& row, std::vector<OwnedTriangles>& owned) const;
  bool listCorners(OwnedTriangles& some, Ticker& ticker) const;

  Triangulation made_;
  const std::int64_t* ids_ = nullptr; ///< of the own points; null above the bottom
  std::uint32_t block_ = 0;
  std::vector<Index> ends_;
  std::vector<Index> crowd_; ///< vertices of crowds that go up, ascending
  bool keepsCrowds_ = false;
  std::vector<BorderPoint> given_;
  std::vector<BorderEdge> edgesBelow_;
  std::vector<std::size_t> firstEdge_;         ///< of each part below, and their number
  std::vector<Mesh::Halfedge> halfEdgesBelow_; ///< where the edges from below are

  const std::uint32_t* data_ = nullptr; ///< the mesh
  Index ghost_ = 0;
  std::size_t slots_ = 0;
  std::vector<Mesh::Slot> ghosts_, open_;   ///< open_: finite triangles that are not final
  Buffer<std::uint8_t> labels_;             ///< of each triangle of the mesh
  std::vector<Mesh::Halfedge> borderEdges_; ///< as they were sent up
  std::size_t finalTriangles_ = 0;
  bool isAnyDropped_ = false;
  std::vector<Index> pieces_; ///< of each triangle of the mesh; empty before findPieces()
  std::size_t pieceCount_ = 0;
};

/// Calls visit(slot) for all finite triangles.
template <typename Visit>
bool Part::eachSlot(Ticker& ticker, Visit visit) const
{
  return inChunks(0, slots_, ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        const Mesh::Slot slot = Mesh::slotOfTriangle(k);
        if (!isGhost(slot))
        {
          visit(slot);
        }
      }
    });
}

template <typename Visit>
bool Part::eachFinal(Ticker& ticker, Visit visit) const
{
  const TriangulationAccess::State& all = state();
  return eachSlot(ticker,
    [&](Mesh::Slot slot)
    {
      std::array<Index, 3> corners;
      unsigned flags = 0;
      for (unsigned e = 0; e != 3 && isFinalAndKept(slot); ++e)
      {
        corners[e] = all.ranked.id[data_[slot + e]];
        const Mesh::Halfedge edge = slot + (e + 2) % 3; // opposite to the corner before it
        flags |= (all.hasMarks && all.constrained.isConstrained(edge) ? 1u : 0u) << e;
      }
      if (isFinalAndKept(slot))
      {
        const Index piece = pieces_.empty() ? 0 : pieces_[slot / Mesh::kSlotSize];
        visit(corners, static_cast<std::uint8_t>(flags), piece);
      }
    });
}

template <typename Visit>
void Part::eachHullEdge(Visit visit) const
{
  const Buffer<Index>& id = state().ranked.id;
  for (const Mesh::Slot ghost : ghosts_)
  {
    for (Mesh::Halfedge h = ghost; h != ghost + 3; ++h)
    {
      if (data_[h] == ghost_)
      {
        visit(id[destination(h)], id[origin(h)]); // the ghost has it on its left the other way
      }
    }
  }
}

/// Labels the triangle and whatever can be reached from it across half-edges that may be entered.
template <typename MayEnter>
bool Part::flood(Mesh::Slot from, std::uint8_t label, MayEnter mayEnter, Ticker& ticker)
{
  std::vector<Mesh::Slot> open{ from };
  labels_[from / Mesh::kSlotSize] |= label;
  while (!open.empty())
  {
    const Mesh::Slot slot = open.back();
    open.pop_back();
    for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
    {
      const Mesh::Slot next = Mesh::slotOf(twin(h));
      if (mayEnter(h, next))
      {
        labels_[next / Mesh::kSlotSize] |= label;
        open.push_back(next);
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

} // namespace ahd

#endif
