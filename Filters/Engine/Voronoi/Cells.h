// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Cells_h
#define ahd_Cells_h

#include "BoxBorder.h"
#include "CellBorder.h"

namespace ahd
{

/// Walks around each vertex and along the border where its cell has a gap.
class CellWalk
{
public:
  CellWalk(const Diagram& diagram, CellBorder& border, VoronoiCells& cells)
    : diagram_(diagram)
    , border_(border)
    , cells_(cells)
  {
  }

  /// One cell per vertex that has triangles. Corners are numbers of the border's. Returns false if
  /// cancelled; throws std::bad_alloc.
  bool walk(Ticker& ticker);

  /// One cell per vertex where there are no triangles. REQUIRES: two vertices at least, in their
  /// order along the line; `border` is this walk's.
  bool walkStrips(const std::vector<std::int64_t>& line, BoxBorder& border, Ticker& ticker);

  /// Renumbers the corners by their first use, and takes over where they are.
  bool number(Ticker& ticker);

private:
  bool addCell(std::size_t site, Ticker& ticker);
  void addStrip(std::size_t site, const Piece& first, const Piece& second);
  void append(std::size_t site, const Piece& piece);
  void close(std::size_t site, bool isOpen);
  void end(std::size_t site);
  void pad(std::size_t site);

  const Diagram& diagram_;
  CellBorder& border_;
  VoronoiCells& cells_;
  std::vector<CornerId> cell_;
};

} // namespace ahd

#endif
