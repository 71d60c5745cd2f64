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

/// Triangles that somebody else has, looked up in a triangulation of their points.
struct FoundTriangles
{
  std::vector<unsigned char> kept; ///< one per triangle of the Triangulation: is it among them?
  std::size_t keptCount = 0;
  std::vector<std::size_t> missing; ///< which of them are none of its triangles, ascending
};

/// Finds `count` triangles by the ids of their corners, counterclockwise; any ids are legal. A
/// point counts as the vertex at its place. Dropped triangles count as there.
///
/// What is missing of a planar surface can be had: constrain() with the edges of the missing
/// triangles makes all of them triangles. For a triangle that is there stays, as no edge of the
/// surface crosses it; and the others are bounded by constraints and have no vertex inside.
///
/// Makes the tables it needs. Time: for each triangle some steps, at most the least degree of its
/// corners. The phase is Phase::Outputs. Returns Ok, Cancelled or OutOfMemory; unless Ok, `found`
/// is not to be used. Id: 32 or 64 bits.
template <typename Id>
Status findTriangles(Triangulation& triangulation, const Id* ids, std::size_t count,
  const Context& context, FoundTriangles& found);

} // namespace ahd

#endif
