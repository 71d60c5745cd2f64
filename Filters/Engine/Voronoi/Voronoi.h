// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Voronoi_h
#define ahd_Voronoi_h

#include "../Core/Buffer.h"
#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

class Triangulation;

/// Where the cells of a Voronoi diagram, the outer of which have no end, are cut off.
enum class VoronoiClip
{
  Hull = 0,  ///< at the convex hull of the vertices
  Bounds = 1 ///< at the smallest axis-parallel box around the vertices
};

/// Where cells meet. It has a z, which is 0, so that the corners can be passed on as points in
/// space.
struct VoronoiCorner
{
  operator Point() const { return { x, y }; }

  double x, y, z;
};

/// The cells of a Voronoi diagram, by ascending smallest id of a point at their vertex's place. The
/// numbers fit (kMaximumPoints).
struct VoronoiCells
{
  Buffer<VoronoiCorner> points; ///< the corners, shared by the cells that meet there
  Buffer<std::int32_t> offsets; ///< cell k has the corners offsets[k] .. offsets[k + 1] - 1
  Buffer<std::int32_t> corners; ///< numbers of `points`; counterclockwise
  Buffer<std::int32_t> sites;   ///< the point that stands for each cell's vertex
};

/// The Voronoi diagram of the vertices: for each the part of the hull (or the bounding box) that is
/// nearer to it than to any other.
///
/// Contract. One cell per vertex. Which cells meet where, which edges cross the border and which
/// corners of it a cell has are those of the exact diagram. Each coordinate of a corner, on the
/// border too, is the exact one rounded once: no more than 0.501 units in the last place away, at
/// any scale, and never across the border of the box. But circumcentres that differ by no more than
/// 4 units in the last place of their own coordinates or those of their triangle are one corner,
/// one of them: so the cells of a lattice have no edges of length zero. Each cell has three corners
/// at least; where vertices are so close that the corners of a cell cannot be told apart in double
/// precision, some coincide.
/// On the hull its vertices are corners of their own cells, those on its straight edges too.
/// Where all vertices are collinear, the hull has no area and there are no cells; the box is cut
/// into strips, unless it has no area either. No cells for fewer than two vertices.
///
/// Time and memory are linear, but for sorting the vertices where all are collinear.
/// REQUIRES: `delaunay` has no constraints. Makes the tables of it that it needs.
/// Returns Ok, Cancelled or OutOfMemory; unless Ok, `cells` is empty. Memory that it had is used.
Status voronoiCells(
  Triangulation& delaunay, VoronoiClip clip, VoronoiCells& cells, const Context& context);

/// Upper estimate of the bytes that voronoiCells() and its result take for so many points, the
/// tables of the triangulation not counted (tableMemoryEstimate).
std::size_t voronoiMemoryEstimate(std::size_t pointCount);

} // namespace ahd

#endif
