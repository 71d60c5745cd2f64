// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_VertexTree_h
#define ahd_VertexTree_h

#include "../Points/BoxLevels.h"
#include "RimTree.h"
#include "Vertices.h"

namespace ahd
{

/// Finds the vertex that is nearest to a place, in whatever triangulation: constraints would lead a
/// walk along edges astray, collinear vertices have no edges.
///
/// Vertices follow each other along a Hilbert curve: boxes are around some of them in a row. Those
/// in dropped triangles alone are left out.
class VertexTree
{
public:
  /// Returns false if cancelled; throws std::bad_alloc. Borrows the places of the vertices.
  bool build(const TriangulationAccess::State& state, Ticker& ticker);

  bool empty() const { return vertices_.empty(); }
  std::size_t size() const { return vertices_.size(); }

  /// Which one, by its number in the list, is nearest to a finite place, and behind no wall; of
  /// several the lexicographically smallest. `hint`: one to begin with. Returns false if cancelled.
  ///
  /// There is one. Proof. Let q be the place of the kept triangles nearest to p, and T one of them
  /// that has q, with a corner v. Of the vertices in the triangle p q v let w be the first that a
  /// ray meets that turns around p from q to v. A wall that p w crosses does not end in front of w,
  /// nor crosses the inside of T, nor p q, but in q; and if it goes on beyond q, then p lies on its
  /// other side, or is q and w a corner of T.
  /// @pre not empty.
  bool findNearest(const Point& place, const RimTree& walls, std::size_t hint, Ticker& ticker,
    std::size_t& found) const;

  Index vertex(std::size_t k) const { return vertices_[k]; }

private:
  template <bool hasWalls>
  class Search;
  using Levels = BoxLevels<8, 8>;

  const Point& at(std::size_t k) const { return places_[vertices_[k]]; }
  bool leaveOutDropped(const TriangulationAccess::State& state, Ticker& ticker);
  template <bool hasWalls>
  bool run(Search<hasWalls>& search, Ticker& ticker) const;

  const Point* places_ = nullptr;
  Buffer<Index> vertices_;
  Levels levels_;        ///< of vertices
  double largest_ = 0.0; ///< coordinate
};

} // namespace ahd

#endif
