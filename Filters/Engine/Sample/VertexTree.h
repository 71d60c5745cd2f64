// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_VertexTree_h
#define ahd_VertexTree_h

#include "Vertices.h"

#include <vector>

namespace ahd
{

/// Finds the vertex that is nearest to a place, in whatever triangulation: constraints would lead a
/// walk along edges astray, collinear vertices have no edges.
///
/// Vertices follow each other along a Hilbert curve. So a node of the tree is the bounds of eight
/// of them in a row, the one above those of eight nodes, and so on.
class VertexTree
{
public:
  /// Returns false if cancelled; throws std::bad_alloc. Borrows the places of the vertices.
  bool build(const TriangulationAccess::State& state, Ticker& ticker);

  bool empty() const { return vertices_.empty(); }
  std::size_t size() const { return vertices_.size(); }

  /// Which one, by its number in the list, is nearest to a finite place; of several the
  /// lexicographically smallest. `hint`: one to begin with. Returns false if cancelled.
  /// REQUIRES: not empty.
  bool findNearest(const Point& place, std::size_t hint, Ticker& ticker, std::size_t& found) const;

  Index vertex(std::size_t k) const { return vertices_[k]; }

private:
  class Search;
  std::size_t itemsOn(std::size_t level) const;

  static constexpr std::size_t kFanout = 8;

  const Point* places_ = nullptr;
  Buffer<Index> vertices_;
  Buffer<Bounds> nodes_;            ///< level after level, the lowest first
  std::vector<std::size_t> levels_; ///< where each begins; where the last one ends
  double largest_ = 0.0;            ///< coordinate
};

} // namespace ahd

#endif
