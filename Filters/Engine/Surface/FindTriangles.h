// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FindTriangles_h
#define ahd_FindTriangles_h

#include "../Core/Context.h"
#include "../Result.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

class Triangulation;

/// Triangles of a caller, looked up in a triangulation of their points.
struct FoundTriangles
{
  std::vector<unsigned char> kept; ///< one per triangle of the Triangulation: is it among them?
  std::size_t keptCount = 0;
  std::vector<std::size_t> missing; ///< those that are not among its triangles, ascending
};

/// Finds `count` triangles by the ids of their corners, counterclockwise; any ids are legal. A
/// point counts as the vertex at its place. Dropped triangles count as present.
///
/// Missing triangles of a planar surface can be restored: constrain() with their edges makes all of
/// them triangles. A triangle that is present stays, since no edge of the surface crosses it; the
/// others are bounded by constraints and have no vertex inside.
///
/// Makes the missing tables. Time: for each triangle some steps, at most the least degree of its
/// corners. The phase is Phase::Outputs. Id: 32 or 64 bits.
///
/// @param found undefined unless the result is Ok
/// @return Ok, Cancelled or OutOfMemory
template <typename Id>
Status findTriangles(Triangulation& triangulation, const Id* ids, std::size_t count,
  const Context& context, FoundTriangles& found);

} // namespace ahd

#endif
