// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Triangulate_h
#define ahd_Triangulate_h

#include "Core/Context.h"
#include "Core/Executor.h"
#include "Core/Progress.h"
#include "Options.h"
#include "Triangulation/Triangulation.h"

namespace ahd
{

/// Memory that one triangulation leaves to the next, which then allocates less. Use it from one
/// thread at a time.
class Workspace
{
public:
  Workspace();
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// Takes over the memory of a triangulation that is no longer needed.
  void reclaim(Triangulation&& done);

  /// Bytes kept.
  std::size_t bytes() const;

  /// Returns them to the system.
  void release();

private:
  friend class TriangulationAccess;
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// Computes the Delaunay triangulation of points in the plane.
///
/// - Exact: the Delaunay triangulation of the distinct finite points, for all finite coordinates.
/// - Canonical: ties between cocircular points are broken by coordinates, and triangles and corners
///   have a canonical order. The result is a function of the point set: the same for every Options,
///   any number of threads and, up to ids, every order of the input.
/// - Triangles are counterclockwise; the hull is convex, and collinear hull points are vertices.
/// - Nothing is thrown, printed or read from the environment.
///
/// Example:
///
///     ahd::Workspace workspace;
///     ahd::Triangulation made;
///     ahd::Status s = ahd::triangulate(points, {}, workspace, {}, made);
///     std::vector<std::int32_t> ids(3 * made.report().triangles);
///     if (s == ahd::Status::Ok) s = made.writeTriangles(ids.data(), ahd::Context());
///
/// @param points borrowed; must outlive `out` unchanged
/// @param options change the time, not the triangles (except insertionLimit)
/// @param workspace receives the memory that `out` held before
/// @param context threads and progress; may be empty
/// @param out the triangulation; empty unless the result is Ok
/// @return Ok, Cancelled, TooManyPoints, TooManyBoxes or OutOfMemory
Status triangulate(const PointView& points, const Options& options, Workspace& workspace,
  const Context& context, Triangulation& out);

/// Inserts constraints as edges and drops the triangles that loops exclude:
/// `out`.report().triangles counts the kept ones.
///
/// The result is the constrained Delaunay triangulation: no vertex visible from inside a triangle
/// lies in its circumcircle; constraint edges block the view. Ties are broken as without
/// constraints, so the result depends on the points and the accepted segments, not on their order.
///
/// Segments are taken in the order of the chains. A segment through vertices becomes edges from one
/// to the next. A segment that crosses an edge of an earlier one is left out as a whole. A loop
/// with a segment left out, or with an end that is not a vertex, bounds no region; its other
/// segments are edges like those of lines. With FillRule::EvenOdd loops along the same edges, in
/// whatever direction and from whatever vertex, count as one. Without a triangle all segments count
/// as withoutVertex.
///
/// @pre `delaunay` has no constraints; offsets ascend
/// @param delaunay consumed; `out` may be the same object
/// @param out empty unless the result is Ok
/// @return Ok, Cancelled or OutOfMemory
Status constrain(Triangulation&& delaunay, const ConstraintView& constraints, FillRule rule,
  const Context& context, Triangulation& out);

/// Is one of the first `count` points a corner of a kept triangle, or at the place of one? Soon
/// known where many are. The phase is Phase::Outputs.
///
/// @pre constrain(); not yet trim()
/// @return Ok, Cancelled or OutOfMemory
Status keepsAnyOf(
  const Triangulation& made, std::size_t count, const Context& context, bool& found);

/// Removes flat triangles at the rim, for points on a surface in space that were projected into a
/// plane, where a straight rim is only nearly straight. The convex hull then has slivers along it
/// that are walls in space.
///
/// A triangle is flat if one of its angles is wider than isFlat() allows (Predicates.h: 158.2
/// degrees). A flat triangle is removed if its longest edge lies on the convex hull or borders a
/// removed one, and no constraint is lost: its longest edge is not a constraint, and beyond each
/// other edge that is one lies a triangle that stays in any case (not flat, or flat over that same
/// edge). The result is a function of points and constraints; regions bounded by loops or lines are
/// not entered.
///
/// report() counts the removed triangles, which are treated like those dropped by loops. Vertices
/// stay vertices. The phase is Phase::Outputs.
///
/// @param whole consumed; `out` may be the same object
/// @param out empty unless the result is Ok
/// @return Ok, Cancelled or OutOfMemory
Status trim(Triangulation&& whole, const Context& context, Triangulation& out);

/// Upper bound of the bytes that triangulate() and writeTriangles() allocate, without input and
/// output. The largest number for more than kMaximumPoints.
std::size_t triangulationMemoryEstimate(std::size_t pointCount, const Options& options);

/// The same for the finished triangulation and writeTriangles().
std::size_t triangulatedMemoryEstimate(std::size_t pointCount, const Options& options);

/// Upper bound of the bytes that constrain() takes in addition. Not counted, since unknown before:
/// up to 300 bytes for each triangle that one segment crosses, and up to 350 for each vertex that
/// one passes; usually a few.
std::size_t constraintMemoryEstimate(std::size_t pointCount, std::size_t segmentCount);

/// The part of it that constrain() takes without a request by Progress::take(): that of segments
/// which cross nothing and belong to no loop.
std::size_t knownConstraintMemory(std::size_t pointCount, std::size_t segmentCount);

/// Upper bound of the bytes that trim() takes in addition.
std::size_t trimMemoryEstimate(std::size_t pointCount);

/// Upper bound of the bytes that all tables of a Triangulation take in addition.
std::size_t tableMemoryEstimate(std::size_t pointCount);

} // namespace ahd

#endif
