// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Certifier_h
#define ahd_Certifier_h

#include "Points/Points.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// One sentence per fault, with the ids and the exact coordinates of the points concerned.
using Complaints = std::vector<std::string>;

/// All complaints in one text; empty if there are none.
std::string joined(const Complaints& complaints);

/// Checks in exact arithmetic, in time linear in the number of points, that `triples` and
/// `pointStatus` are the correct result for `points`:
///  1. every point status is correct: the smallest id at the point's place, or not finite, or left
///  out;
///  2. every triangle has three different vertices and is strictly counterclockwise;
///  3. every directed edge is used once; the edges used one way only form one convex loop around
///  all,
///     which goes straight on at collinear vertices but never back;
///  4. every vertex is used, the triangles are connected, and triangles = 2 v - 2 - h;
///  5. every inner edge is locally Delaunay, cocircular ties broken by the coordinates;
///  6. without triangles, all vertices are collinear.
/// By 2 to 4 the triangles tile the convex hull, by 5 they are then the one perturbed Delaunay
/// triangulation. The order of the triangles is not checked. Empty means certified; faults of
/// one kind are named up to a limit and then counted.
Complaints certify(const PointView& points, const std::vector<std::int32_t>& triples,
  const std::vector<std::int64_t>& pointStatus);

} // namespace test
} // namespace ahd

#endif
