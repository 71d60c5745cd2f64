// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Selection_h
#define ahd_Selection_h

#include "../Core/Context.h"
#include "../Merge/Merge.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

class Triangulation;

/// The triangles of a triangulation to write, and the edges and vertices to write as cells of their
/// own. A default one has all triangles that loops keep.
struct Selection
{
  std::vector<unsigned char> kept; ///< one per triangle of the Triangulation; empty: see isKept()
  std::size_t keptCount = 0;       ///< only where `kept` is not empty
  std::vector<std::int32_t> lines; ///< two points each, in the order of the triangles
  std::vector<std::int32_t> vertices; ///< points, ascending
};

/// Limits on the size of triangles; 0 means none. Triangles at a limit are kept.
struct SizeLimits
{
  double alpha = 0.0;             ///< largest radius of a circumcircle in space
  double maximumEdgeLength = 0.0; ///< in the plane of the triangulation
  bool triangles = true;          ///< with alpha: write triangles? They still bound the others
  bool lines = true;
  bool vertices = true;

  bool any() const { return alpha > 0.0 || maximumEdgeLength > 0.0; }
};

/// The points that limits are measured on.
struct PointsToMeasure
{
  PointView inSpace;                                ///< the points as the user sees them
  const std::vector<MergedPoint>* merged = nullptr; ///< left out of the triangulation; may be null
};
/// Selects triangles within limits, as vtkDelaunay2D's Alpha does.
///
/// A triangle is selected if loops keep it, none of its edges is longer than maximumEdgeLength in
/// the plane, and the radius of its circumcircle in space is not greater than alpha. With alpha: an
/// edge whose kept triangles are all too large is a line if it is not longer than maximumEdgeLength
/// and half its length in space is not greater than alpha; a vertex or duplicate (or merged point)
/// that is a corner of neither is a vertex. Collinear vertices have edges from one to the next. A
/// length that is NaN, because the third coordinate of a point is, drops no triangle and makes no
/// line.
///
/// Makes the missing tables.
///
/// @param out undefined unless the result is Ok
/// @return Ok, Cancelled or OutOfMemory
Status selectBySize(Triangulation& triangulation, const SizeLimits& limits,
  const PointsToMeasure& points, const Context& context, Selection& out);

/// The same for triangles in memory, and maximumEdgeLength alone: a byte for each of `triangles`
/// triples, 1 if no edge is too long.
///
/// @pre length > 0
/// @param places of each corner
/// @return Ok, Cancelled or OutOfMemory
Status findShort(const std::int32_t* triples, std::size_t triangles, const PointView& places,
  double length, const Context& context, std::vector<unsigned char>& kept);

/// Upper bound of the bytes that selectBySize() takes, without the tables of the triangulation.
std::size_t selectionMemoryEstimate(std::size_t pointCount);

} // namespace ahd

#endif
