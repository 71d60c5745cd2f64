// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockRim_h
#define ahd_BlockRim_h

#include "BlockStars.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Counts of trimming, over all blocks.
struct BlockRim
{
  std::size_t triangles = 0;
  std::size_t bareVertices = 0; ///< left in no triangle
  double area = 0.0;            ///< of these triangles, as a part of that of all
};

/// Takes the flat triangles at the rim out of both kinds of triangles, as trim() does where there
/// are no constraints (Triangulate.h). `places`: of own points, then of foreign ones. Collective;
/// returns Ok, Cancelled or OutOfMemory, the same on all blocks.
Status trimBlocks(const std::vector<Point>& places, BlockTransport& transport,
  const Context& context, BlockStars& stars, BlockRim& rim);

/// Bytes for each own point, at most: marks; two triangles, which may be flat.
constexpr std::size_t kRimBytesPerPoint = 2 + 2 * 2 + 2 * 48;

} // namespace ahd

#endif
