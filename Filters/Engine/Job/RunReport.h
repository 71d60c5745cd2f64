// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RunReport_h
#define ahd_RunReport_h

#include "../Constraints.h"
#include "../Core/Fields.h"
#include "../Core/Progress.h"
#include "../Prepare/Prepare.h"
#include "../Result.h"
#include "RunMemory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace ahd
{

/// The outcome of a run, successful or not. The sizes are those known in the end; after
/// TooManyCrossings, points and crossings are those of the input with all crossings found until
/// then, and the caller's points are the difference.
struct RunReport : RunSizes
{
  Status status = Status::Cancelled;
  bool isRefused = false;        ///< OutOfMemory: more may be needed than is allowed
  std::size_t estimate = 0;      ///< bytes
  std::size_t allowed = 0;       ///< bytes
  bool isLimited = false;        ///< `allowed` is the caller's limit, not available memory
  std::size_t mostBoxes = 0;     ///< that fit in memory
  std::size_t mostCrossings = 0; ///< the same
  unsigned threadsUsed = 0;      ///< that shared work
  PolygonFault polygonFault = PolygonFault::None; ///< BadPolygon: why
  Conflict conflict = Conflict::None;             ///< BadSettings: which
  bool splits = false;                            ///< segments, where they cross
  bool countsWork = false;
  std::array<double, kPhases> seconds = {}; ///< of each phase, by the wall clock

  // The rest is defined if the status is Ok.
  Report counts;
  ConstraintReport constraints;      ///< but for leftOut, which the triangulation has
  std::size_t delaunayTriangles = 0; ///< before constraints dropped some
  std::size_t keptEstimate = 0;      ///< bytes, of what is kept to interpolate on it later
  std::size_t triangles = 0, lines = 0, vertices = 0; ///< of the output
  std::size_t inputPoints = 0;
  std::size_t sourcePoints = 0;
  std::size_t addedPoints = 0;
  std::size_t mergedPoints = 0;
  std::size_t withinError = 0;                    ///< points left out of a simplified surface
  double largestError = 0.0;                      ///< theirs, but for duplicates
  std::array<std::int64_t, 2> firstCrossing = {}; ///< cells: left out, crossed
  std::size_t bentConstraints = 0;                ///< through a vertex beside them
  std::int64_t firstBentCell = 0;                 ///< of these, if there are any
  UnfitIds unfitIds;
  OddPoints oddPoints;
  std::size_t pointsOffSurface = 0; ///< of a source to be laid on the surface of the input
  SourceBounds sourceBounds;
  bool areLinesUnclosed = false; ///< all, though closed ones would be loops
  bool loopsMissInput = false;   ///< no point of the input is in what they keep, nor at its border
  bool isProjected = false;      ///< the plane is another than x, y
  bool isSteep = false;          ///< it is fitted and steep: Stance::isSteep
  /// In space, if tested: where there is no triangle in x, y.
  bool areOnOneLine = true;
  bool areStacked = false; ///< tested if most points are duplicates
  /// Given triangles that are impossible: others cross them in the plane, or they are clockwise.
  std::size_t foldedTriangles = 0;

  /// Should it be checked whether x and y distinguish the points?
  bool mayBeStacked() const { return !isProjected && counts.beyondLimit == 0; }
  /// Without merged points and those within the error, which the engine counts as skipped.
  std::size_t skipped() const { return counts.skipped - mergedPoints - withinError; }
  /// Of the output.
  std::size_t cells() const { return triangles + lines + vertices; }

  auto fields()
  {
    return std::tuple_cat(RunSizes::fields(),
      std::tie(status, isRefused, estimate, allowed, isLimited, mostBoxes, mostCrossings,
        threadsUsed, polygonFault, conflict, splits, countsWork, seconds, counts, constraints,
        delaunayTriangles, keptEstimate, triangles, lines, vertices, inputPoints, sourcePoints,
        addedPoints, mergedPoints, withinError, largestError, firstCrossing, bentConstraints,
        firstBentCell, unfitIds, oddPoints, pointsOffSurface, sourceBounds, areLinesUnclosed,
        loopsMissInput, isProjected, isSteep, areOnOneLine, areStacked, foldedTriangles));
  }
};
static_assert(listsAll<Report>() && listsAll<ConstraintReport>() && listsAll<UnfitIds>() &&
    listsAll<OddPoints>() && listsAll<SpaceBox>() && listsAll<SourceBounds>() &&
    listsAll<RunSizes>() && listsAllBehind<RunReport, RunSizes>(),
  "what fields() leaves out is not sent to other ranks");

} // namespace ahd

#endif
