// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Regions_h
#define ahd_Regions_h

#include "../Constraints.h"
#include "ConstrainedMesh.h"
#include "EdgeTable.h"

#include <cstddef>

namespace ahd
{

/// Marks the triangles that the loops do not keep as dropped, and adds their number to `dropped`.
/// `edges` tells how often, and which way, loops use each constraint edge. Returns false if the
/// caller wants to cancel. Throws std::bad_alloc. REQUIRES: there is a loop.
bool dropOutside(ConstrainedMesh& mesh, const EdgeTable& edges, FillRule rule, Ticker& ticker,
  std::size_t& dropped);

} // namespace ahd

#endif
