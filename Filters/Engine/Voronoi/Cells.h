// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Cells_h
#define ahd_Cells_h

#include "../Core/Tasks.h"
#include "CellBorder.h"
#include "ConvexBorder.h"
#include "CornerNumbers.h"
#include "InsideCells.h"
#include "Voronoi.h"

#include <deque>
#include <vector>

namespace ahd
{

/// Walks around each vertex and along the border where its cell has a gap.
class CellWalk
{
public:
  /// `cellOf`: the number of each vertex's cell. `cells` has its sites already.
  CellWalk(Diagram& diagram, CellBorder& border, const Buffer<Index>& cellOf, VoronoiCells& cells)
    : diagram_(diagram)
    , border_(border)
    , cellOf_(cellOf)
    , cells_(cells)
    , numbers_(diagram, border)
  {
  }

  /// One cell per vertex that has triangles. Vertex after vertex, as neighbours are close in memory
  /// then, each cell and each corner to its place; in parallel but for those at the border. Returns
  /// false if cancelled; throws std::bad_alloc.
  bool walk(Ticker& ticker);

  /// One cell per vertex where there are no triangles. @pre the vertices, in their order along the
  /// line; `border` is this walk's.
  bool walkStrips(const std::vector<Index>& line, ConvexBorder& border, Ticker& ticker);

private:
  /// A cell at the border, which is not found by many threads.
  struct BorderCell
  {
    Index vertex;
    std::uint32_t begin; ///< of its corners in borderCorners_, up to those of the next cell
  };

  /// The number of corners of a cell, and of those that no cell before it has; then the first
  /// places of both.
  struct Extent
  {
    void add(const Extent& more)
    {
      corners += more.corners;
      points += more.points;
    }

    std::uint32_t corners = 0;
    std::uint32_t points = 0;
  };

  static constexpr std::size_t kAhead = 16; ///< vertices: prefetched for writing

  /// That of the vertex's cell; any for a vertex without one.
  const Extent* extentOf(std::size_t vertex) const
  {
    const Index cell = vertex < cellOf_.size() ? cellOf_[vertex] : kNoIndex;
    return extents_.data() + (cell == kNoIndex ? 0 : cell);
  }

  bool beginExtents(Ticker& ticker);
  bool measureShare(const Share& vertices, InsideCells& inside, Ticker& ticker);
  bool addBorderCells(const std::vector<InsideCells>& inside, Ticker& ticker);
  bool countBorderCells(Ticker& ticker);
  template <typename Visit>
  bool forBorderCorners(Ticker& ticker, Visit visit);
  bool sumUp(Ticker& ticker);
  bool place(Ticker& ticker);
  bool writeShare(const Share& vertices, const InsideCells& inside, Ticker& ticker);
  bool copyBorderCells(Ticker& ticker);

  bool turnAtBorder(Index vertex, Ticker& ticker);
  void addStrip(Index vertex, const ClippedEdge& first, const ClippedEdge& second);
  void append(Index vertex, const ClippedEdge& piece);
  void close(Index vertex, bool isOpen);
  void keep(Index vertex);

  Diagram& diagram_;
  CellBorder& border_;
  const Buffer<Index>& cellOf_;
  VoronoiCells& cells_;
  CornerNumbers numbers_;
  Buffer<Extent> extents_;             ///< of each cell, and one more
  std::vector<CornerId> cell_;         ///< at work on
  Stretch entry_ = kNoStretch;         ///< of its first edge
  Stretch exit_ = kNoStretch;          ///< of its last one
  std::deque<BorderCell> borderCells_; ///< and an end
  std::deque<CornerId> borderCorners_;
};

} // namespace ahd

#endif
