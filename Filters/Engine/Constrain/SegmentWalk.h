// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SegmentWalk_h
#define ahd_SegmentWalk_h

#include "ConstrainedMesh.h"
#include "EdgeRows.h"
#include "Fans.h"

#include <vector>

namespace ahd
{

/// Where a segment runs through the mesh. Vertices on it cut it into pieces; a piece either is an
/// edge already or crosses edges. Changes nothing.
class SegmentWalk
{
public:
  enum class Outcome
  {
    Free,    ///< pieces() and crossed() say where it runs
    Blocked, ///< it crosses the constraint edge blockedBy(), on its way from a before any other
    Beyond,  ///< it may leave the territory
    Long,    ///< it crosses more edges than it may
    Cancelled
  };

  SegmentWalk(const ConstrainedMesh& mesh, Ticker& ticker)
    : mesh_(mesh)
    , ticker_(ticker)
    , fans_(mesh)
  {
  }

  /// From now on only triangles with a vertex in [begin, end) are looked at, links across edges
  /// with one of these, and marks of triangles with two. Others may change meanwhile.
  void limitTo(Index begin, Index end)
  {
    firstOwn_ = begin;
    owns_ = end - begin;
  }
  bool isOwn(Index v) const { return v - firstOwn_ < owns_; }

  /// From now on no more than so many edges are crossed.
  void crossAtMost(std::size_t edges) { mostCrossed_ = edges; }

  /// From now on rows that are remembered there are passed as one piece; null: edge by edge.
  void passRows(const EdgeRows* rows) { rows_ = rows; }

  /// @pre two different vertices of the mesh, both in the territory. Throws std::bad_alloc.
  /// Where one end has very many neighbours, the cost goes with those of the other end. For a
  /// vertex within the segment with very many neighbours some are remembered: m segments through it
  /// cost m log m steps.
  Outcome walk(Index a, Index b);

  /// The same across all constraints: crossed() lists them among the other edges. Returns Free or
  /// Cancelled. @pre no territory.
  Outcome walkAcross(Index a, Index b);

  /// Along the segment, from start(), which is one of its ends. The edges that are crossed are
  /// places in crossed().
  const std::vector<WalkPiece>& pieces() const { return pieces_; }
  Index start() const { return start_; }
  /// Of each crossed edge the half-edge on the near side; it runs from right to left.
  const std::vector<Mesh::Halfedge>& crossed() const { return crossed_; }
  Mesh::Halfedge blockedBy() const { return blockedBy_; }

private:
  /// The way out of a vertex towards another.
  struct WayOut
  {
    Mesh::Halfedge edge = kNoIndex;    ///< along this edge, which begins at the vertex
    Mesh::Halfedge crossed = kNoIndex; ///< or across this one, opposite to it
    bool isFound() const { return (edge & crossed) != kNoIndex; }
  };

  /// On the way around a vertex.
  struct Turn
  {
    Mesh::Halfedge out; ///< an edge from the vertex
    int side;           ///< on which side of the way it is
  };

  bool isLimited() const { return owns_ != kNoIndex; }
  Outcome walkFrom(Index from, Index end, WayOut way);
  Outcome chooseEnd(Index a, Index b, WayOut& way);
  Outcome findWayOut(Index from, Index to, std::size_t mostSteps, WayOut& way);
  bool isFoundNext(Turn& turn, Index from, Index to, WayOut& way) const;
  bool turnFromFans(Index from, Index to, WayOut& way);
  Mesh::Halfedge firstToOneSide(Index from, Index to, int& side) const;
  int sideOf(Index from, Index to, Index v) const;
  Mesh::Halfedge edgeNearby(Index from, Index to) const;
  Outcome cross(Index from, Index to, Mesh::Halfedge first);
  bool isAhead(Index from, Index to, Index v) const;

  const ConstrainedMesh& mesh_;
  Ticker& ticker_;
  Fans fans_;
  std::vector<WalkPiece> pieces_;
  std::vector<Mesh::Halfedge> crossed_;
  Mesh::Halfedge blockedBy_ = kNoIndex;
  bool goesOn_ = false; ///< across the constraint that blocks it
  std::size_t mostCrossed_ = std::size_t(-1);
  const EdgeRows* rows_ = nullptr;
  Index start_ = kNoIndex;
  Index firstOwn_ = 0;
  Index owns_ = kNoIndex; ///< all vertices
};

} // namespace ahd

#endif
