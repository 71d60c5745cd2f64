// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BoxNeighbors_h
#define ahd_BoxNeighbors_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <vector>

namespace ahd
{

class Triangulation;

// For values at places of a triangulation whose points lie in several parts, none of which has all:
// the points that others need of each part. README.md, *Values across blocks*, has the proof.
//
// Let `part` be the triangulation of some of all points, with all constraints, which do not cross.
// The points that findBoxNeighbors() lists of all parts, triangulated together, look around each
// place in the boxes as the triangulation of all points does: the place lies on the same triangle,
// edge or vertex, or outside; the same circles have it inside; the same vertex is nearest. More
// points of all do no harm.
//
// The values are the same bytes, if canonical ranks are in the same order, too. They are if the
// bounds of all points are those of what is triangulated, which takes findExtremes() of all parts,
// and if no more points than crowdLimit() lie in one column and row of these bounds. With loops,
// what they keep is the same if the hull is, too.

/// Lists ids of points of the part, ascending, each once: the corners of triangles whose closed
/// circumdiscs meet a box, and the ends of hull edges with a box beyond their line. All vertices if
/// there is no triangle. Empty boxes (xmin > xmax) have no neighbours. Makes the part's neighbours.
/// Cost: a few steps per vertex of the part, and a test for each box and each triangle listed, hull
/// edge, or triangle beside these.
///
/// @pre finite boxes; no other thread makes tables of the part or writes it
/// @return Ok, Cancelled or OutOfMemory
Status findBoxNeighbors(Triangulation& part, const std::vector<Bounds>& boxes,
  const Context& context, std::vector<Index>& ids);

/// Lists ids of points on the part's bounds: at most four, each once. With `allOfHull`, of all hull
/// vertices. Makes the part's neighbours; returns as above.
Status findExtremes(
  Triangulation& part, bool allOfHull, const Context& context, std::vector<Index>& ids);

/// The bounds of a part's points; empty (xmin > xmax) if there are none.
Bounds boundsOf(const Triangulation& part);

/// The number of distinct points in one column and row of the finest grid (Quantise.h) that are
/// ranked by their places alone.
std::size_t crowdLimit();

/// The largest number of vertices in one column and row of the part's bounds; 0 without vertices.
/// Makes the part's neighbours; returns as above.
Status findCrowd(Triangulation& part, const Context& context, std::size_t& most);

/// Can points of two parts lie in one column and row of the bounds of all? Monotone, so the parts'
/// own bounds decide. False for empty ones.
bool shareBox(const Bounds& all, const Bounds& one, const Bounds& other);

/// Grows boxes so that they have all of a surface that is within rounding of places in them, too.
/// `all`: the bounds of all points.
void growByRounding(const Bounds& all, std::vector<Bounds>& boxes);

/// Boxes around places, at most `most` (1 at least), such that each finite place is in one: halved
/// across the longer side where most places are. Empty if no place is finite.
///
/// @return Ok, Cancelled or OutOfMemory
Status coverByBoxes(
  const PointView& places, std::size_t most, const Context& context, std::vector<Bounds>& boxes);

} // namespace ahd

#endif
