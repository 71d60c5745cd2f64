// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Triangulate_h
#define ahd_Triangulate_h

#include "Constraints.h"
#include "Core/Executor.h"
#include "Core/Progress.h"
#include "Options.h"
#include "Points/Points.h"
#include "Result.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace ahd
{

/// The Delaunay triangulation of points in the plane: the engine's door.
///
/// Contract. The triangles are the exact Delaunay triangulation of the distinct finite points,
/// counterclockwise, the hull convex with collinear hull points kept as vertices. Cocircular ties
/// are broken by the coordinates alone, and triangles and their corners come in a canonical order,
/// so the result is a function of the point set: the same for every Options, any number of threads
/// and, up to the ids, for every order of the input. Nothing is thrown across this border, printed,
/// or read from the environment.
///
/// One object is for one thread at a time; several may look at the same points. Nobody may change
/// the points from the beginning of run() until the last write.
class Triangulator
{
public:
  Triangulator();
  ~Triangulator();
  Triangulator(const Triangulator&) = delete;
  Triangulator& operator=(const Triangulator&) = delete;

  /// Triangulates. `progress` may be null, and so may `executor`: then the calling thread does all
  /// the work. The points are borrowed until the last write below.
  /// Anything but Status::Ok leaves no triangles; run() may be called again after any outcome, and
  /// uses the memory of the run before as far as it goes.
  Status run(const PointView& points, const Options& options, Progress* progress,
    Executor* executor = nullptr);

  /// What the last run did.
  const Report& report() const;

  /// Makes the constraints edges, as far as they do not cross, and leaves out what the loops do not
  /// keep: report().triangles then counts the kept triangles. The result is the constrained
  /// Delaunay triangulation: no vertex that can be seen from inside a triangle lies in its
  /// circumcircle, where constraint edges block the view. Ties are broken as without constraints,
  /// so it depends on the points and on which segments are accepted, not on the order of these.
  ///
  /// Segments are taken in the order of the chains. A segment that passes through vertices becomes
  /// edges from one to the next. One that crosses an edge of a segment before it is left out whole,
  /// and a loop with a segment left out, or with one whose end is no vertex, bounds no region: its
  /// other segments are edges as those of lines are. Without a triangle there are no edges to be
  /// had: then all segments count as withoutVertex.
  ///
  /// At most once after run(), before the triangles are written (but see Options::keepLocations).
  /// Returns Ok, Cancelled or OutOfMemory; unless Ok, the triangulation is gone, as after a run
  /// that ended so. REQUIRES: the points of run() are still there; offsets ascend.
  Status constrain(const ConstraintView& constraints, FillRule rule, Progress* progress);

  /// What the last constrain() did; empty before.
  const ConstraintReport& constraints() const;

  /// Writes report().triangles triples of the caller's ids. 32-bit ids always fit (kMaximumPoints).
  /// Returns Ok, Cancelled or OutOfMemory; unless Ok, the triples are not to be used.
  Status writeTriangles(
    std::int32_t* triples, Progress* progress, Executor* executor = nullptr) const;
  Status writeTriangles(
    std::int64_t* triples, Progress* progress, Executor* executor = nullptr) const;

  /// Writes what became of each point (see Result.h): points.count numbers.
  /// Returns Ok or Cancelled.
  Status writeFates(std::int64_t* fates, Progress* progress, Executor* executor = nullptr) const;

  /// Writes the caller's ids in the order of insertion: report().inserted of them. Needs
  /// Options::keepOrder. The order is that of one thread, by whichever number of threads the points
  /// were inserted. Returns Ok or Cancelled.
  Status writeOrder(std::int64_t* ids, Progress* progress, Executor* executor = nullptr) const;

  /// Writes each point's place in the insertion order, from 0, those beyond the limit included;
  /// kRankNone for points that are not in it: duplicates and points left out. points.count numbers.
  /// Needs Options::keepOrder. Returns Ok or Cancelled.
  Status writeInsertionRanks(
    std::int64_t* ranks, Progress* progress, Executor* executor = nullptr) const;

  /// Cell data, in the order of the triangles as they are written. A triangle's edge 0 runs from
  /// its first corner to its second, edge 1 from there to its third, edge 2 back to the first. All
  /// return Ok, Cancelled or OutOfMemory.
  ///
  /// Neighbours: three numbers per triangle, the triangle on the other side of each edge; -1 where
  /// there is none, or none that was kept.
  Status writeNeighbors(std::int64_t* neighbors, Progress* progress);
  /// One number per triangle: bit e (1, 2, 4) is set if edge e is a constraint.
  Status writeConstraintEdges(std::uint8_t* edges, Progress* progress);
  /// One number per triangle: the region it is in. Regions are what constraint edges, those of
  /// lines included, separate; numbered from 0 in the order of their first triangle.
  Status writeRegions(std::int64_t* regions, Progress* progress);

  /// The undivided boxes of the grid in the order in which they are visited, empty ones included.
  /// Empty without Options::keepBoxes, with InsertionOrder::AsGiven and without points. What they
  /// take is not part of memoryEstimate.
  const std::vector<GridBox>& boxes() const;

  /// Bytes that are kept for the next run.
  std::size_t memoryHeld() const;

  /// Forgets where the points of the last run were; there is nothing to write any more.
  void forgetPoints();

  /// Gives the kept memory back, and with it what the last run found.
  void release();

  /// Upper estimate of the bytes that run() and writeTriangles() allocate for this many points,
  /// input and output not counted. The largest number for more than kMaximumPoints.
  static std::size_t memoryEstimate(std::size_t pointCount, const Options& options);

  /// Upper estimate of what constrain() takes on top of it for so many segments (0 for none), and
  /// the cell data. Not counted, as nobody knows before: up to 300 bytes for each triangle that one
  /// segment crosses, and up to 350 for each vertex that one passes; a few, mostly.
  static std::size_t constraintMemoryEstimate(std::size_t pointCount, std::size_t segmentCount);

private:
  struct State;
  template <typename Write>
  Status writeCells(Progress* progress, Write write);
  std::unique_ptr<State> state_;
};

} // namespace ahd

#endif
