// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CellEdges_h
#define ahd_CellEdges_h

#include "../Core/AskedMemory.h"
#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Points/Points.h"
#include "Outline.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Number of an edge of a cell: of the id, among those of all cells, at which it begins in the
/// direction of the cell as given.
using CellEdge = std::uint32_t;

/// The cells of a surface, joined at edges, and turned so that joined ones agree in direction.
class CellEdges
{
public:
  /// Borrows the request.
  explicit CellEdges(const OutlineRequest& request)
    : request_(request)
  {
  }

  /// Reads and joins all. Returns false if cancelled; throws std::bad_alloc.
  bool make(Ticker& ticker);

  // --- After that ---

  std::size_t count() const { return corners_.size(); }
  std::size_t boundaryCount() const { return boundary_; }
  /// Components are numbered in the order of their first cells.
  std::size_t componentCount() const { return components_; }
  std::size_t unfitCells() const { return unfitCells_; }
  std::size_t unfitEdges() const { return unfitEdges_; }
  OutlinePlane plane() const;

  bool isBoundary(CellEdge h) const { return twins_[h] == kBoundary; }
  /// The component of a cell; kNoIndex if the cell is left out.
  Index componentOf(std::size_t cell) const
  {
    return states_[cell] == kNoIndex ? kNoIndex : states_[cell] >> 1;
  }
  Index cellOf(CellEdge h) const { return cells_.empty() ? h / 3 : cells_[h]; }
  /// Where the edge begins, after turning.
  Index origin(CellEdge h) const { return corners_[isTurned(cellOf(h)) ? nextGiven(h) : h]; }
  /// The boundary edge after this one: it begins where this one ends, and the cells between the two
  /// are joined. kNull if cancelled.
  CellEdge follow(CellEdge h, Ticker& ticker) const;

  static constexpr CellEdge kBoundary = 0xFFFFFFFFu;
  static constexpr CellEdge kNull = 0xFFFFFFFEu; ///< of no length, or of a cell left out

private:
  struct Entry ///< an edge, in the list of its smaller end
  {
    Index other; ///< end
    CellEdge edge;
  };

  struct ListScratch ///< to sort long lists
  {
    explicit ListScratch(Ticker& ticker)
      : taken(ticker)
    {
    }
    TakenMemory taken;
    Buffer<Entry> entries;
  };

  /// Where the edges of cell k begin, behind those of cell k - 1.
  std::size_t offset(std::size_t k) const
  {
    const CellsView& cells = request_.cells;
    return static_cast<std::size_t>(cells.offsets32 ? cells.offsets32[k] : cells.offsets64[k]);
  }
  /// The edge after it, and before it, in the direction given.
  CellEdge nextGiven(CellEdge h) const
  {
    const Index cell = cellOf(h);
    return static_cast<CellEdge>(h + 1 == offset(cell + 1) ? offset(cell) : h + 1);
  }
  CellEdge previousGiven(CellEdge h) const
  {
    const Index cell = cellOf(h);
    return static_cast<CellEdge>(h == offset(cell) ? offset(cell + 1) - 1 : h - 1);
  }
  bool isTurned(Index cell) const { return (states_[cell] & 1) != 0; }
  bool isNull(CellEdge h) const { return twins_[h] == kNull; }
  bool isJoined(CellEdge h) const { return twins_[h] < kNull; }
  Index cornerAt(std::size_t k) const;

  bool mergePlaces(Ticker& ticker);
  bool mergeAlike(
    std::uint64_t* items, std::size_t count, Buffer<std::uint64_t>& other, Ticker& ticker);
  bool read(Ticker& ticker);
  bool readCell(Index cell, Ticker& ticker);
  bool list(Buffer<Index>& heads, Buffer<Entry>& entries, Ticker& ticker);
  bool join(Ticker& ticker);
  bool joinAt(Entry* first, Entry* last, ListScratch& scratch, Ticker& ticker);
  void joinRun(Entry* first, Entry* last);
  bool spread(Ticker& ticker);
  bool spreadFrom(Index cell, Buffer<Index>& stack, Ticker& ticker);
  void cross(CellEdge h, Buffer<Index>& stack, std::size_t& size);
  void addArea(CellEdge h, std::array<double, 3>& areas) const;

  const OutlineRequest& request_;
  Buffer<Index> points_;  ///< of each point: the one that it counts as
  Buffer<Index> corners_; ///< of the cells, one after the other
  Buffer<Index> cells_;   ///< of each edge; empty if all have three corners
  Buffer<CellEdge> twins_;
  Buffer<Index> states_; ///< of each cell: twice its component, and whether it is turned
  std::size_t boundary_ = 0;
  std::size_t components_ = 0;
  std::size_t unfitCells_ = 0;
  std::size_t unfitEdges_ = 0;
  std::array<double, 3> areas_ = {}; ///< seen along each axis: of components, without signs
  double areaOfCells_ = 0.0;         ///< of cells along z, without signs
};

} // namespace ahd

#endif
