// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Voronoi_h
#define ahd_Voronoi_h

#include "../Core/Executor.h"
#include "../Core/Progress.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Where the cells of a Voronoi diagram, the outer of which have no end, are cut off.
enum class VoronoiClip
{
  Hull = 0,  ///< at the convex hull of the vertices
  Bounds = 1 ///< at the smallest axis-parallel box around the vertices
};

/// A whole Delaunay triangulation as Triangulator writes it, without constraints.
struct DelaunayView
{
  PointView points;
  const std::int64_t* fates = nullptr;     ///< one per point: vertices have their own id
  const std::int32_t* corners = nullptr;   ///< three ids per triangle, counterclockwise
  const std::int64_t* neighbors = nullptr; ///< three per triangle: across corners 0-1, 1-2, 2-0
  std::size_t triangles = 0;
};

/// The cells of a Voronoi diagram.
struct VoronoiCells
{
  std::vector<Point> points;         ///< the corners, shared by the cells that meet there
  std::vector<std::int64_t> offsets; ///< cell k has the corners offsets[k] .. offsets[k + 1] - 1
  std::vector<std::int64_t> corners; ///< numbers of `points`; counterclockwise
  std::vector<std::int64_t> sites;   ///< the id of each cell's vertex, ascending
};

/// The Voronoi diagram of the vertices: for each the part of the hull (or the bounding box) that is
/// nearer to it than to any other.
///
/// Contract. One cell per vertex. Which cells meet where follows from the triangles, so it is as
/// exact as they are; the coordinates of the corners are computed with about 100 bits and rounded
/// once (so where numbers of 1e-300 meet numbers of 1e300 a corner may be anywhere within the
/// bounds). Circumcentres that differ by no more than a few units in the last place of their own
/// coordinates or those of their triangle are one corner: so the cells of a lattice have no edges
/// of length zero. Each cell has three corners at least; where vertices are so close that the
/// corners of a cell cannot be told apart in double precision, some coincide.
/// On the hull its vertices are corners of their own cells, those on its straight edges too.
/// Where all vertices are collinear, the hull has no area and there are no cells; the box is cut
/// into strips, unless it has no area either. No cells for fewer than two vertices.
///
/// Time and memory are linear, but for sorting the vertices where all are collinear.
/// Returns Ok, Cancelled or OutOfMemory; unless Ok, `cells` is empty.
Status voronoiCells(const DelaunayView& delaunay, VoronoiClip clip, VoronoiCells& cells,
  Progress* progress, Executor* executor = nullptr);

/// Upper estimate of the bytes that voronoiCells() and its result take for so many points.
std::size_t voronoiMemoryEstimate(std::size_t pointCount);

} // namespace ahd

#endif
