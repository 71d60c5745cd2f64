// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstraintOracle_h
#define ahd_ConstraintOracle_h

#include "ConstraintSets.h"
#include "Constraints.h"
#include "Oracle.h"

#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace ahd
{
namespace test
{

/// An edge by the ids of its ends, the smaller first.
using EdgeIds = std::pair<std::int32_t, std::int32_t>;

/// The correct result for constraints.
struct ConstrainedByDefinition
{
  ConstraintReport report;
  std::set<EdgeIds> edges;       ///< constraint edges, those of the triangles left out included
  std::set<Triple> all;          ///< the constrained triangulation of the whole hull
  std::set<Triple> kept;         ///< the part that the loops keep
  std::map<Triple, int> regions; ///< of the triangles kept: which have the same number, not which
};

/// The engine's contract by brute force, in exact arithmetic:
///  1. one segment after the other is accepted, unless it crosses an accepted one in a point that
///  is
///     no vertex: then it is left out, and the accepted one that it crosses first is named, of
///     several on top of each other the earliest;
///  2. the triangles are those counterclockwise triples of vertices that no accepted segment passes
///     through, and whose circle contains no vertex that can be seen from within the triangle past
///     the accepted segments. Heights with infinitesimals break the ties, as in
///     delaunayByDefinition();
///  3. of these, the rule keeps some (Constraints.h). Only loops of which every segment was
///  accepted
///     or has no length count.
/// Where all vertices are collinear, all segments count as without a vertex.
/// Cost: n^6. @pre n small (up to a dozen).
ConstrainedByDefinition constrainedByDefinition(
  const PointView& points, const ConstraintView& constraints, FillRule rule);

} // namespace test
} // namespace ahd

#endif
