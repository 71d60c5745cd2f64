// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Outline_h
#define ahd_Outline_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Prepare/Prepare.h"
#include "../Result.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// A surface of polygons, borrowed from the caller.
struct OutlineRequest
{
  PointView points; ///< in space; z matters as OutlinePlane says
  CellsView cells;  ///< polygons of three corners or more, in either direction
  /// A number for each cell: polygons of the outline are of cells with equal numbers. NaN: the cell
  /// is left out. Null: all cells are alike.
  const double* groups = nullptr;
  /// Cells are joined by the ids of their corners, not by places: points may lie at one place. All
  /// are counterclockwise in x, y, but for rounding of places, which turns nothing over.
  bool isDirected = false;
};

/// The plane in which a ring is outer or a hole, and in which it turns.
enum class OutlinePlane
{
  Yz = 0, ///< y to the right, z up
  Zx = 1,
  Xy = 2 ///< unless the surface folds over itself there: then the plane it is most parallel to
};

/// The outline as polygons with holes. Two cells are joined where they share an edge, and a polygon
/// is a largest set of joined cells with equal numbers.
///
/// - Rings are simple: each passes a vertex once. The first ring of a polygon is the outer one,
///   counterclockwise; the others are its holes, clockwise, so the polygon is on the left of all.
///   Rings touch at vertices only: polygons that share no edge stay apart, and a ring that would
///   touch itself is several.
/// - A ring begins at its smallest vertex, by x, then y (of the plane). Polygons are in ascending
///   order of their numbers, then of their first corners, and so are the holes of a polygon. The
///   outline depends neither on the order of cells and points nor on the directions of cells.
/// - Which ring is outer is exact. All else is a matter of ids. Of directed cells an outer ring
///   turns to the left, by its area if that is more than rounding.
struct Outline
{
  std::vector<Index> corners;  ///< ids of points, ring after ring; the first is not repeated
  std::vector<Index> rings;    ///< ring i has the corners from rings[i] to rings[i + 1]
  std::vector<Index> polygons; ///< polygon k has the rings from polygons[k] to polygons[k + 1]
  std::vector<Index> cells;    ///< of each polygon: its first cell

  OutlinePlane plane = OutlinePlane::Xy;
  /// Cells left out: with an id of no point, a corner that is not finite, or fewer than three
  /// distinct corners.
  std::size_t unfitCells = 0;
  /// Edges that cannot join: of three cells or more with equal numbers, or where a one-sided
  /// surface closes. They are in the outline.
  std::size_t unfitEdges = 0;
};

/// Upper estimate of the bytes that outline() takes, but for those that depend on the number of
/// edges in the outline: 32 for each, which it requests by Progress::take().
std::size_t outlineMemoryEstimate(const OutlineRequest& request);

/// Upper estimate of the bytes of what is written of an outline of a surface of so many points:
/// closed rings of ids with 64 bits, whether each is a hole, its polygon, and a number of it;
/// `perPoint` for each point that rings pass. 0 if that is 0: nothing is written.
std::size_t ringsMemoryEstimate(const Outline& made, std::size_t points, std::size_t perPoint);

/// Makes the outline. Points at one place, in space, count as the one of smallest id: cells are
/// joined by places. Time: O(c + p log p) for c corners of cells and p points. The phase is
/// Phase::Outputs.
///
/// @return Ok, Cancelled, OutOfMemory, or TooManyPoints: 2^32 - 4 points or corners of cells
Status outline(const OutlineRequest& request, const Context& context, Outline& out);

} // namespace ahd

#endif
