// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RankedPoints_h
#define ahd_RankedPoints_h

#include "../Core/Buffer.h"
#include "../Points/Points.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// A point that coincides with one of smaller id.
struct Duplicate
{
  Index id;     ///< the point, in the caller's numbering
  Index keptId; ///< the smallest id of a point at the same place
};

/// The distinct finite points in canonical order. The rank of a point is its place on a Hilbert
/// curve through the bounding box, ties broken by (x, y): a function of the point set alone. It
/// numbers the vertices of the mesh and sorts the output. The arrays have room for all finite
/// points, duplicates included; the other entries are undefined.
struct RankedPoints
{
  Index count = 0;           ///< distinct points
  Buffer<Point> xy;          ///< count + 1 entries; the last is (NaN, NaN), the vertex at infinity
  Buffer<Index> id;          ///< rank -> the caller's id (the smallest among coincident points)
  Buffer<std::uint64_t> key; ///< rank -> Hilbert key, ascending
  /// The memory of the keys and, at its very end, of the duplicates. The rest is free for other
  /// uses once the keys are no longer needed.
  Scratch scratch;
  Bounds bounds;                ///< of the distinct points
  Bounds whole;                 ///< that ranks refer to: larger, if the points are some of others
  Buffer<Duplicate> duplicates; ///< in no particular order, but the same for any number of threads
  std::size_t notFinite = 0;
  std::size_t skipped = 0;
};

} // namespace ahd

#endif
