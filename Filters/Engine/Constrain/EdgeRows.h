// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_EdgeRows_h
#define ahd_EdgeRows_h

#include "ConstrainedMesh.h"
#include "EdgeTable.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// A part of a segment from one vertex to another without any between them, or along a known row of
/// edges.
struct WalkPiece
{
  Index from, to;
  Mesh::Halfedge edge;    ///< that begins at `from`, where there is one, else kNoIndex
  std::size_t begin, end; ///< else the edges that are crossed, as places in a list of these
};

/// Long permanent rows of edges on one line: a segment along one passes it in a few steps. One edge
/// in kStride of a row is remembered, so a segment along more than these meets one.
class EdgeRows
{
public:
  EdgeRows(const ConstrainedMesh& mesh, Ticker& ticker)
    : mesh_(mesh)
    , ticker_(ticker)
    , rowOf_(ticker)
  {
  }

  /// How far an edge that begins at `from` leads on the way to `end`: to `end` or to the end of the
  /// row, if it is remembered to belong to one; else to its other end.
  Index ahead(Index from, Mesh::Halfedge edge, Index end) const
  {
    return rows_.empty() ? mesh_.destination(edge) : aheadInRow(from, edge, end);
  }

  /// Does the piece pass a row?
  bool isRow(const WalkPiece& piece) const
  {
    return !rows_.empty() && piece.edge != kNoIndex && mesh_.destination(piece.edge) != piece.to;
  }

  /// These pieces of one segment, in this order, are edges from now on. Returns false if cancelled.
  /// Throws std::bad_alloc.
  bool remember(const WalkPiece* begin, const WalkPiece* end)
  {
    const bool isLong = static_cast<std::size_t>(end - begin) > kStride;
    return (!isLong && rows_.empty()) || rememberRow(begin, end, isLong);
  }

private:
  static constexpr std::size_t kStride = 32;

  struct Row
  {
    Index low, high;      ///< its ends; all between them are edges
    std::uint32_t parent; ///< the row that it has become a part of; itself, if none
  };

  bool rememberRow(const WalkPiece* begin, const WalkPiece* end, bool isLong);
  Index aheadInRow(Index from, Mesh::Halfedge edge, Index end) const;
  bool isBefore(Index u, Index v) const { return lexicographicallyLess(mesh_.at(u), mesh_.at(v)); }
  std::uint32_t rootOf(std::uint32_t row) const;
  void reach(std::uint32_t row, Index u, Index v);
  bool addEdges(const WalkPiece* pieces, std::size_t count, std::uint32_t row);

  const ConstrainedMesh& mesh_;
  Ticker& ticker_;
  EdgeTable<std::uint32_t> rowOf_;
  mutable std::vector<Row> rows_;
};

} // namespace ahd

#endif
