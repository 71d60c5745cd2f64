// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SegmentWalk_h
#define ahd_SegmentWalk_h

#include "ConstrainedMesh.h"

#include <vector>

namespace ahd
{

/// Where a segment runs through the mesh. Vertices on it cut it into pieces; a piece either is an
/// edge already or crosses edges. Changes nothing.
class SegmentWalk
{
public:
  struct Piece
  {
    Index from, to;
    Mesh::Halfedge edge;    ///< from -> to where that is an edge, else kNoIndex
    std::size_t begin, end; ///< else the edges it crosses, as places in crossed()
  };

  enum class Outcome
  {
    Free,    ///< pieces() and crossed() say where it runs
    Blocked, ///< it crosses the constraint edge blockedBy()
    Cancelled
  };

  SegmentWalk(const ConstrainedMesh& mesh, Ticker& ticker)
    : mesh_(mesh)
    , ticker_(ticker)
  {
  }

  /// REQUIRES: two different vertices of the mesh. Throws std::bad_alloc.
  /// Costs no more than the smaller of the degrees of a and b where a-b is an edge.
  Outcome walk(Index a, Index b);

  /// Along the segment, from start(): the end whose neighbours are fewer, mostly.
  const std::vector<Piece>& pieces() const { return pieces_; }
  Index start() const { return start_; }
  /// Of each crossed edge the half-edge on the side one comes from; it runs from right to left.
  const std::vector<Mesh::Halfedge>& crossed() const { return crossed_; }
  Mesh::Halfedge blockedBy() const { return blockedBy_; }

private:
  bool findEdge(Index a, Index b);
  bool findWayOut(Index from, Index to);
  Outcome cross(Index from, Index to, Mesh::Halfedge first);
  bool isAhead(Index from, Index to, Index v) const;

  const ConstrainedMesh& mesh_;
  Ticker& ticker_;
  std::vector<Piece> pieces_;
  std::vector<Mesh::Halfedge> crossed_;
  Mesh::Halfedge blockedBy_ = kNoIndex;
  Index start_ = kNoIndex;
  // What findEdge() and findWayOut() find.
  Mesh::Halfedge edge_ = kNoIndex;
  Mesh::Halfedge wayOut_ = kNoIndex;
};

} // namespace ahd

#endif
