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

/// Which triangles of a triangulation are put out, and which edges and vertices as cells of their
/// own. Made by default: all triangles that loops keep.
struct Selection
{
  std::vector<unsigned char> kept; ///< one per triangle of the Triangulation; empty: see isKept()
  std::size_t keptCount = 0;       ///< only where `kept` is not empty
  std::vector<std::int32_t> lines; ///< two points each, in the order of the triangles
  std::vector<std::int32_t> vertices; ///< points, ascending
};

/// Limits on the size of triangles; 0 stands for none. All are closed.
struct SizeLimits
{
  double alpha = 0.0;             ///< largest radius of a circumcircle in space
  double maximumEdgeLength = 0.0; ///< in the plane of the triangulation
  bool triangles = true;          ///< with alpha: put out triangles? They still bound the others
  bool lines = true;
  bool vertices = true;
};

/// What the limits leave of a triangulation, as vtkDelaunay2D's Alpha does.
///
/// A triangle is selected if loops keep it, none of its edges is longer than maximumEdgeLength in
/// the plane, and the radius of its circumcircle in space is not greater than alpha. With alpha: an
/// edge all kept triangles of which are too large is a line if it is not longer than
/// maximumEdgeLength either and half its length in space is not greater than alpha; a vertex or
/// duplicate (or merged point) that is a corner of neither is a vertex. Where all vertices are
/// collinear, the edges are those from one to the next. A length that is NaN, because the third
/// coordinate of a point is, drops no triangle and makes no line.
///
/// `inSpace`: the same points where the user sees them. Makes the tables it needs.
/// Returns Ok, Cancelled or OutOfMemory; unless Ok, `out` is not to be used.
struct PointsToMeasure
{
  PointView inSpace;
  const std::vector<MergedPoint>* merged = nullptr; ///< left out of the triangulation; may be null
};
Status selectBySize(Triangulation& triangulation, const SizeLimits& limits,
  const PointsToMeasure& points, const Context& context, Selection& out);

/// The same for triangles that lie in memory, and maximumEdgeLength alone: a byte for each of
/// `triangles` triples, 1 for those that no edge is too long of. `places`: of each corner.
/// Returns Ok, Cancelled or OutOfMemory. REQUIRES: length > 0.
Status findShort(const std::int32_t* triples, std::size_t triangles, const PointView& places,
  double length, const Context& context, std::vector<unsigned char>& kept);

/// Upper estimate of the bytes that selectBySize() takes, the tables of the triangulation not
/// counted.
std::size_t selectionMemoryEstimate(std::size_t pointCount);

} // namespace ahd

#endif
