// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PartJudges_h
#define ahd_PartJudges_h

// What is done before and after the triangulation, and what is wrong with it, in words; empty if
// nothing is.
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

/// Merges within a distance, given as a fraction of the larger side of the bounds. What is kept is
/// farther from each other, what is merged is not. Up to some hundred points; else it only merges.
std::string mergeAndJudge(const PointView& points, double fraction, MergedPoints& merged);

/// Points, marks of those left out (or none), and chains.
struct ToSplit
{
  const std::vector<Point>& points;
  const std::vector<unsigned char>& skip;
  const test::ConstraintSet& chains;
};

/// Splits, and holds the result against brute force, unless it is large or something was left
/// unresolved.
std::string splitAndJudge(const ToSplit& given, SplitConstraints& split);

/// The cells of the Voronoi diagram, clipped either way: one for each vertex, of three corners at
/// least, within the bounds. Up to 12 of them, each corner where it has to be (VoronoiOracle.h).
/// Where coordinates are small integers, also convex, around their vertices, and together as large
/// as they have to be. `plain`: what was written of `delaunay`,
/// which has no constraints.
std::string faultsOfDiagram(
  Triangulation& delaunay, const test::ConstrainedOutcome& plain, Executor* executor);

} // namespace fuzz
} // namespace ahd

#endif
