// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Sites_h
#define ahd_Sites_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Triangulation/State.h"

#include <cstdint>

namespace ahd
{

/// The vertices that have cells, and which: numbered by the smallest id of a point at their place.
struct Sites
{
  Buffer<Index> cellOf;     ///< of each vertex; kNoIndex if it is beyond the limit
  Buffer<std::int32_t> ids; ///< of each cell: the point that stands for its vertex
  Bounds bounds;            ///< of the sites
  bool areModest = true;    ///< isModest() of all of them
};

/// Finds them, on all threads lent. Takes 4 bytes for each point while it works. Returns false if
/// cancelled; throws std::bad_alloc.
bool numberSites(const TriangulationAccess::State& state, Sites& sites, Ticker& ticker);

} // namespace ahd

#endif
