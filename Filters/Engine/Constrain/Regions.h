// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Regions_h
#define ahd_Regions_h

#include "../Constraints.h"
#include "ConstrainedMesh.h"
#include "EdgeTable.h"

#include <cstddef>

namespace ahd
{

/// Of each edge that loops use: how many run from the smaller to the larger vertex, less those that
/// run the other way. It is odd if as many loops as use the edge are an odd number.
using LoopEdges = EdgeTable<std::int64_t>;

/// Marks the triangles that the loops do not keep as dropped, and adds their number to `dropped`.
/// Returns false if cancelled. Throws std::bad_alloc. @pre there is a loop;
/// the edges of loops are constraints.
bool dropOutside(ConstrainedMesh& mesh, const LoopEdges& edges, FillRule rule, Ticker& ticker,
  std::size_t& dropped);

} // namespace ahd

#endif
