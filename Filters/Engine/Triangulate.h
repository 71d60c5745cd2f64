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

/// Memory that one triangulation leaves to the next, so that this does not ask
/// the system for it anew. For one thread at a time.
class Workspace
{
public:
  Workspace();
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// Takes the memory of a triangulation that is not needed any more.
  void reclaim(Triangulation&& done);

  /// Bytes that are kept.
  std::size_t bytes() const;

  /// Gives them back to the system.
  void release();

private:
  friend class TriangulationAccess;
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// The Delaunay triangulation of points in the plane.
///
/// Contract. The triangles are the exact Delaunay triangulation of the distinct
/// finite points, counterclockwise, the hull convex with collinear hull points
/// kept as vertices. Cocircular ties are broken by the coordinates alone, and
/// triangles and their corners come in a canonical order, so the result is a
/// function of the point set: the same for every Options, any number of threads
/// and, up to the ids, for every order of the input. Nothing is thrown across
/// this border, printed, or read from the environment.
///
/// What `out` held before goes to the workspace. Anything but Status::Ok leaves an empty `out`.
Status triangulate(const PointView& points, const Options& options, Workspace& workspace,
  const Context& context, Triangulation& out);

/// Makes the constraints edges, as far as they do not cross, and drops what the
/// loops do not keep: `out`.report().triangles counts the kept triangles. The
/// result is the constrained Delaunay triangulation: no vertex that can be seen
/// from inside a triangle lies in its circumcircle, where constraint edges
/// block the view. Ties are broken as without constraints, so it depends on the
/// points and on which segments are accepted, not on the order of these.
///
/// Segments are taken in the order of the chains. A segment that passes through
/// vertices becomes edges from one to the next. One that crosses an edge of a
/// segment before it is left out whole, and a loop with a segment left out, or
/// with one whose end is no vertex, bounds no region: its other segments are
/// edges as those of lines are. Without a triangle there are no edges to be
/// had: then all segments count as withoutVertex.
///
/// `delaunay` is used up; `out` may be the same object. Returns Ok, Cancelled
/// or OutOfMemory; unless Ok, `out` is empty. REQUIRES: `delaunay` has no
/// constraints; offsets ascend.
Status constrain(Triangulation&& delaunay, const ConstraintView& constraints, FillRule rule,
  const Context& context, Triangulation& out);

/// Takes the flat triangles at the rim away: for points on a surface in space that were projected
/// into a plane, where a straight rim is only nearly straight. The convex hull then has slivers
/// along it that are walls in space.
///
/// A triangle is flat if an angle of it is wider than isFlat() allows (Predicates.h: 153.4
/// degrees). A flat triangle goes if its longest edge lies on the convex hull or borders on one
/// that goes, and no constraint is lost: its longest edge is none, and behind each other edge of it
/// that is one lies a triangle that is kept whatever goes (not flat, or flat over that same edge).
/// So the result is a function of points and constraints; what loops or lines bound is not entered.
///
/// report() counts what went; triangles that went are like those that loops drop. Vertices stay
/// vertices. `whole` is used up; `out` may be the same object. The phase is Phase::Outputs. Returns
/// Ok, Cancelled or OutOfMemory; unless Ok, `out` is empty.
Status trim(Triangulation&& whole, const Context& context, Triangulation& out);

/// Upper estimate of the bytes that triangulate() and writeTriangles() allocate
/// for this many points, input and output not counted. The largest number for
/// more than kMaximumPoints.
std::size_t triangulationMemoryEstimate(std::size_t pointCount, const Options& options);

/// The same of what is held when the triangulation is there, and of what
/// writeTriangles() takes besides.
std::size_t triangulatedMemoryEstimate(std::size_t pointCount, const Options& options);

/// Upper estimate of what constrain() takes on top of it for so many segments.
/// Not counted, as nobody knows before: up to 300 bytes for each triangle that
/// one segment crosses, and up to 350 for each vertex that one passes; a few,
/// mostly.
std::size_t constraintMemoryEstimate(std::size_t pointCount, std::size_t segmentCount);

/// The part of it that constrain() does not ask for (Progress::take()) before it takes
/// it: what segments take that cross nothing and are no loops'.
std::size_t knownConstraintMemory(std::size_t pointCount, std::size_t segmentCount);

/// Upper estimate of what trim() takes on top of it.
std::size_t trimMemoryEstimate(std::size_t pointCount);

/// Upper estimate of what all tables of a Triangulation take on top of it.
std::size_t tableMemoryEstimate(std::size_t pointCount);

} // namespace ahd

#endif
