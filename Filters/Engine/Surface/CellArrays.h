// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CellArrays_h
#define ahd_CellArrays_h

#include "Selection.h"

namespace ahd
{

// Arrays of the written cells: first Selection::vertices, then Selection::lines, then the selected
// triangles in canonical order; numbered in this order from 0. A triangle's edge 0 runs from its
// first corner to its second, edge 1 from there to its third, edge 2 back. All functions make the
// missing tables, and return Ok, Cancelled or OutOfMemory. Id: a signed integer of 32 or 64 bits.

/// The number of cells.
std::size_t cellCount(const Triangulation& triangulation, const Selection& selection);

/// The selected triangles: three point ids each.
/// @pre Selection::kept is not empty
template <typename Id>
Status writeSelected(
  Triangulation& triangulation, const Selection& selection, Id* triples, const Context& context);

/// Three numbers per cell: the cell on the other side of each edge; -1 where there is none, and for
/// vertices and lines.
template <typename Id>
Status writeNeighbors(
  Triangulation& triangulation, const Selection& selection, Id* neighbors, const Context& context);

/// Memory for triangles and neighbours: three point ids for each selected triangle, and the output
/// of writeNeighbors().
template <typename Id>
struct CellsWithNeighbors
{
  std::int32_t* triples;
  Id* neighbors;
};

/// Both in one pass, faster than one after the other.
template <typename Id>
Status writeWithNeighbors(Triangulation& triangulation, const Selection& selection,
  const CellsWithNeighbors<Id>& to, const Context& context);

/// One number per cell: bit e (1, 2, 4) is set if edge e is a constraint; 0 for vertices and lines.
Status writeConstraintEdges(Triangulation& triangulation, const Selection& selection,
  std::uint8_t* edges, const Context& context);

/// One number per cell: its region. Constraint edges, those of lines included, separate regions
/// among the triangles that loops keep; numbered from 0 in order of appearance among the cells; -1
/// for vertices and lines.
template <typename Id>
Status writeRegions(
  Triangulation& triangulation, const Selection& selection, Id* regions, const Context& context);

} // namespace ahd

#endif
