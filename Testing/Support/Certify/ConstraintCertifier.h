// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstraintCertifier_h
#define ahd_ConstraintCertifier_h

#include "Certifier.h"
#include "Constraints.h"
#include "Result.h"

#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{

/// All results of one run of the engine with constraints.
struct ConstrainedOutcome
{
  Status status = Status::Ok;
  Report report;
  ConstraintReport constraints;
  std::vector<std::int32_t> triples;         ///< three ids per triangle
  std::vector<std::int64_t> pointStatus;     ///< one per point
  std::vector<std::int64_t> neighbors;       ///< three per triangle
  std::vector<std::uint8_t> constraintEdges; ///< one per triangle, a bit per edge
  std::vector<std::int64_t> regions;         ///< one per triangle
};

/// Checks in exact arithmetic, in time nearly linear in the points, the edges of the constraints
/// and the triangles that left-out segments pass through, that the outcomes are what the engine
/// promises. `whole`: of the same constraints with all loops as closed lines, so that no triangle
/// is dropped.
///  1. `whole` tiles the hull (points 1 to 4 and 6 of certify());
///  2. each segment is in one of these states: an end is no vertex, or there is no triangle; both
///  ends are one; it is a chain
///     of edges through exactly the vertices on it; or it is named as left out. One that is left
///     out crosses the one that it reports, in no vertex; that one comes before it, is
///     accepted, and the first it meets on its way, of several on top of each other the earliest;
///  3. every inner edge that is on no accepted segment is locally Delaunay, ties broken by the
///     coordinates;
///  4. the triangles of `filled` are those of `whole` that the rule keeps, in the same order;
///  5. neighbours, constraint edges and regions are those of the triangles, counted anew;
///  6. the counts of the reports are correct.
/// By 1 to 3 `whole` is the one perturbed constrained triangulation, and its segments are correct:
/// induction over their order. Empty means certified.
Complaints certifyConstrained(const PointView& points, const ConstraintView& constraints,
  FillRule rule, const ConstrainedOutcome& whole, const ConstrainedOutcome& filled);

} // namespace test
} // namespace ahd

#endif
