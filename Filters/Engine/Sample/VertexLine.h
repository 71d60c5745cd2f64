// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_VertexLine_h
#define ahd_VertexLine_h

#include "Vertices.h"
#include "Weights.h"

namespace ahd
{

/// The vertices of a triangulation that has no triangles, as all are collinear, along their line.
class VertexLine
{
public:
  /// Returns false if cancelled; throws std::bad_alloc. Borrows the places of the vertices.
  bool build(const TriangulationAccess::State& state, Ticker& ticker);

  /// The vertex at a finite place, or those on either side of it on the line. Returns how many: 1
  /// at a vertex, 2 between two, 0 elsewhere.
  std::size_t neighborsOf(const Point& place, Index (&neighbors)[2]) const;

  /// The ends of the piece that begins at the vertex; for the last one, of that which ends there.
  /// None if there is one vertex alone.
  void pieceAt(Index vertex, Index (&ends)[2]) const;

  const Point& at(Index vertex) const { return places_[vertex]; }

  /// Pieces between vertices that follow each other; of one vertex alone a piece without a length.
  std::size_t pieces() const
  {
    return vertices_.size() < 2 ? vertices_.size() : vertices_.size() - 1;
  }
  Index beginOf(std::size_t piece) const { return vertices_[piece]; }
  Index endOf(std::size_t piece) const
  {
    return vertices_[vertices_.size() < 2 ? piece : piece + 1];
  }

private:
  const Index* lowerBound(const Point& place) const;

  const Point* places_ = nullptr;
  Buffer<Index> vertices_; ///< lexicographically ascending
};

} // namespace ahd

#endif
