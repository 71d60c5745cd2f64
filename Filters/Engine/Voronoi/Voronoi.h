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

class ConvexPolygon;
class Triangulation;

/// Where the unbounded cells of a Voronoi diagram are clipped.
enum class VoronoiClip
{
  Hull = 0,   ///< at the convex hull of the vertices
  Bounds = 1, ///< at the smallest axis-parallel box around the vertices
  Polygon = 2 ///< at a convex polygon of the caller's own; bounded cells, too
};

/// Why a list of corners is no convex polygon (ConvexPolygon.h).
enum class PolygonFault
{
  None,
  NotFinite, ///< a coordinate is NaN or infinite
  NoArea,    ///< fewer than three corners are not on one line
  NotConvex
};

/// A corner of cells. z is 0, so that corners can be passed on as points in space.
struct VoronoiCorner
{
  operator Point() const { return { x, y }; }

  double x, y, z;
};

/// The cells of a Voronoi diagram, by ascending smallest id at their vertex's place: empty ones
/// too, which have no corners. The numbers fit (kMaximumPoints).
struct VoronoiCells
{
  Buffer<VoronoiCorner> points; ///< the corners, shared by the cells that meet there
  Buffer<std::int32_t> offsets; ///< cell k has the corners offsets[k] .. offsets[k + 1] - 1
  Buffer<std::int32_t> corners; ///< numbers of `points`; counterclockwise
  Buffer<std::int32_t> sites;   ///< the point that stands for each cell's vertex
};

/// Computes the Voronoi diagram of the vertices: for each vertex the part of the hull (or bounding
/// box) that is nearer to it than to any other.
///
/// - One cell per vertex. Adjacency of cells, edges that cross the border, and corners of the
///   border in each cell are those of the exact diagram.
/// - Each coordinate of a corner, on the border too, is the exact one rounded once: at most 0.501
///   units in the last place off, at any scale, and never beyond the box.
/// - Circumcentres that differ by at most 4 units in the last place of their own coordinates or
///   those of their triangle are one corner: cells of a lattice have no edges of length zero. Each
///   cell has at least three corners; some coincide where vertices are too close for double
///   precision.
/// - Hull vertices, those on straight edges too, are corners of their own cells.
/// - Collinear vertices have no cells in the hull, which has no area; the box is cut into strips,
///   unless it has no area either. Fewer than two vertices have no cells.
///
/// Time and memory are linear, except for sorting collinear vertices.
///
/// In a polygon of the caller's own each vertex has a cell, however few or collinear they are: the
/// part of the polygon that is nearer to it than to any other vertex. It is empty if that has no
/// area. For edges that are neither inside nor beyond one side, time is linear in the corners of
/// the polygon. On its slanted sides corners may be beyond them by rounding, but never beyond its
/// bounds.
///
/// @pre `delaunay` has no constraints
/// @param delaunay its missing tables are made
/// @param cells its memory is reused; empty unless the result is Ok
/// @return Ok, Cancelled or OutOfMemory
Status voronoiCells(
  Triangulation& delaunay, VoronoiClip clip, VoronoiCells& cells, const Context& context);
/// The same in a polygon. @pre it has no fault.
Status voronoiCells(Triangulation& delaunay, const ConvexPolygon& polygon, VoronoiCells& cells,
  const Context& context);

/// Leaves out the cells without corners, with their sites. Throws std::bad_alloc.
void leaveOutEmpty(VoronoiCells& cells);

/// Upper bound of the bytes that voronoiCells() and its result take, without the tables of the
/// triangulation (tableMemoryEstimate). Corners of a polygon count as points.
std::size_t voronoiMemoryEstimate(std::size_t pointCount);

} // namespace ahd

#endif
