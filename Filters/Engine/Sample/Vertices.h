// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Vertices_h
#define ahd_Vertices_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Triangulation/State.h"

namespace ahd
{

/// Lists the vertices that were inserted, by rank. Returns false if cancelled; throws
/// std::bad_alloc.
bool listInserted(const TriangulationAccess::State& state, Buffer<Index>& vertices, Ticker& ticker);

} // namespace ahd

#endif
