// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PartJudges_h
#define ahd_PartJudges_h

// Steps before and after the triangulation, and their faults, in words; empty if none.
#include "ConstrainedRun.h"
#include "Crossings/Crossings.h"
#include "Merge/Merge.h"
#include "Voronoi/Voronoi.h"

#include <string>
#include <vector>

namespace ahd
{
namespace fuzz
{

/// Merges within a distance, given as a fraction of the larger side of the bounds. Kept points are
/// farther from each other, merged ones are not. Up to some hundred points; else it only merges.
std::string mergeAndJudge(const PointView& points, double fraction, MergedPoints& merged);

/// Points, marks of those left out (or none), and chains.
struct ToSplit
{
  const std::vector<Point>& points;
  const std::vector<unsigned char>& skip;
  const test::ConstraintSet& chains;
};

/// Splits, and compares the result with brute force, unless it is large or crossings were left
/// unresolved.
std::string splitAndJudge(const ToSplit& given, SplitConstraints& split);

/// The cells of the Voronoi diagram, clipped at hull, box and a triangle of points: one for each
/// vertex, of three corners at least, within the bounds. Up to 12 of them, with each corner correct
/// (VoronoiOracle.h). Where coordinates are small integers, also convex, around their vertices, and
/// with the correct total area. `plain`: the outputs of `delaunay`, which has no constraints.
std::string faultsOfDiagram(
  Triangulation& delaunay, const test::ConstrainedOutcome& plain, Executor* executor);

} // namespace fuzz
} // namespace ahd

#endif
