// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_VertexTree_h
#define ahd_VertexTree_h

#include "../Points/BoxLevels.h"
#include "Vertices.h"

namespace ahd
{

/// Finds the vertex that is nearest to a place, in whatever triangulation: constraints would lead a
/// walk along edges astray, collinear vertices have no edges.
///
/// Vertices follow each other along a Hilbert curve: boxes are around some of them in a row.
class VertexTree
{
public:
  /// Returns false if cancelled; throws std::bad_alloc. Borrows the places of the vertices.
  bool build(const TriangulationAccess::State& state, Ticker& ticker);

  bool empty() const { return vertices_.empty(); }
  std::size_t size() const { return vertices_.size(); }

  /// Which one, by its number in the list, is nearest to a finite place; of several the
  /// lexicographically smallest. `hint`: one to begin with. Returns false if cancelled.
  /// @pre not empty.
  bool findNearest(const Point& place, std::size_t hint, Ticker& ticker, std::size_t& found) const;

  Index vertex(std::size_t k) const { return vertices_[k]; }

private:
  class Search;
  using Levels = BoxLevels<8, 8>;

  const Point* places_ = nullptr;
  Buffer<Index> vertices_;
  Levels levels_;        ///< of vertices
  double largest_ = 0.0; ///< coordinate
};

} // namespace ahd

#endif
