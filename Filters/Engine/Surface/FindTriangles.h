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

/// Triangles of a caller, borrowed: three ids of points each, any at all.
struct GivenTriangles
{
  std::int64_t corner(std::size_t triangle, std::size_t k) const
  {
    const std::size_t i = 3 * triangle + k;
    return ids32 ? ids32[i] : ids64[i];
  }

  const std::int32_t* ids32 = nullptr; ///< of all, or ids64
  const std::int64_t* ids64 = nullptr;
  std::size_t count = 0;
  /// Null, or a byte for each: bit e is set if the edge from corner e to the next is a constraint.
  const unsigned char* edges = nullptr;
};

/// Writes a mark for each of the points: 0 for corners, else this one.
///
/// @return Ok or Cancelled
Status markOthers(const GivenTriangles& given, std::size_t points, unsigned char mark,
  unsigned char* marks, const Context& context);

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
