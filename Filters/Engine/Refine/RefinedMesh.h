// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RefinedMesh_h
#define ahd_RefinedMesh_h

#include "Refine.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ahd
{

/// A piece of a segment: an edge of a triangle that was refined.
struct MeshPiece
{
  std::array<Index, 2> ids;
  std::array<Index, 2> edge; ///< before, that it lies on, in its direction
  std::int64_t cell;         ///< the first of the source that it lies on; -1: none
};

/// A refinement, and its pieces: those between triangles, then those that bound them, which have
/// the triangles on the left.
struct RefinedMesh
{
  Refinement found;
  std::vector<MeshPiece> pieces;
  std::size_t innerPieces = 0;
};

/// The constraints of the triangulation that was refined.
struct MeshConstraints
{
  ConstraintView chains;
  std::function<std::int64_t(std::size_t)> cellOf; ///< the cell of the source of a chain
};

/// Fills in the pieces. Returns Ok, Cancelled or OutOfMemory.
/// @pre `mesh.found` is of refine(made)
Status findPieces(Triangulation& made, const MeshConstraints& constraints, const Context& context,
  RefinedMesh& mesh);

/// The kept triangles of the triangulation that was refined, in any order.
struct TrianglesBefore
{
  const std::int32_t* corners = nullptr; ///< three ids each
  const std::int64_t* regions = nullptr;
  std::size_t count = 0;
};

/// The triangles of a run of the points and the added ones, with Refinement::constraints().
struct MeshTriangles
{
  const std::int32_t* corners = nullptr; ///< three ids each
  std::size_t count = 0;
  /// Of each triangle: the region in that run; becomes that of the triangulation before. May be
  /// null.
  std::int64_t* regions = nullptr;
  std::int64_t* bad = nullptr; ///< of each of Refinement::bad its number among these; may be null
  double leastAngle = 0.0;     ///< in degrees, to rounding; 0 without a triangle

  /// Can they be those, of so many points?
  bool fit(std::size_t points) const;
};

/// Fills in regions, bad and leastAngle. Returns Ok, Cancelled or OutOfMemory. `points`: those that
/// were given. @pre fit()
Status describeTriangles(const PointView& points, const TrianglesBefore& before,
  const RefinedMesh& mesh, const Context& context, MeshTriangles& triangles);

} // namespace ahd

#endif
