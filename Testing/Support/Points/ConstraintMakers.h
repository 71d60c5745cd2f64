// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstraintMakers_h
#define ahd_ConstraintMakers_h

#include "ConstraintSets.h"
#include "Distributions.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// Points with constraints.
struct ConstraintCase
{
  std::vector<Point> points;
  std::vector<unsigned char> skip; ///< empty, or one byte per point
  ConstraintSet constraints;

  PointView view() const;
  /// All of it as text, to make a test of.
  std::string text() const;
};

/// A dozen points at most, with lines and loops that overlap, cross, share edges either way, touch,
/// repeat each other, have no length, pass through points, name duplicates, points left out and ids
/// that are none. The points lie on a small lattice of any scale, or anywhere.
ConstraintCase smallConstraintCase(std::uint64_t seed);

/// The same points and constraints with other ids. The smallest of coincident points may change.
ConstraintCase shuffledCase(const ConstraintCase& original, std::uint64_t seed);

// Large ones. The same on every platform.

/// A closed star with so many spikes, counterclockwise, and as many points again anywhere.
ConstraintCase starPolygon(std::size_t spikes);

/// n uniform points and `segments` short segments, none of which touches another.
ConstraintCase shortSegments(std::size_t n, std::size_t segments);

/// n uniform points and as constraints the first `segments` edges of the Delaunay triangulation of
/// every third of them, that of all points being another one.
ConstraintCase edgesOfOthers(std::size_t n, std::size_t segments);

/// n uniform points and segments between any two of them: nearly all cross others.
ConstraintCase randomSegments(std::size_t n, std::size_t segments);

/// The result of crossingSegments().
struct CrossingSegments
{
  const char* name;
  std::size_t segments; ///< two points of its own each
  double length;        ///< of each, in a unit square; any direction
  std::size_t others;   ///< points that are no ends
};

/// Seven of them, for the comparison of splitting; the names give segments and crossings.
const std::vector<CrossingSegments>& crossingCases();

/// Segments anywhere in the unit square. `scale` multiplies the numbers of segments and points: the
/// lengths follow, so that as many cross per segment.
ConstraintCase crossingSegments(const CrossingSegments& shape, double scale = 1.0);

/// A segment from the left to the right through all of n uniform points, in no vertex.
ConstraintCase segmentAcross(std::size_t n);

/// A segment between two rows of n / 2 points each. Both rows bend away from it as a parabola...
ConstraintCase segmentAcrossParabolas(std::size_t n);
/// ... towards it, so that each point sees few others ...
ConstraintCase segmentAcrossBulges(std::size_t n);
/// ... or have teeth of two lengths.
ConstraintCase segmentAcrossCombs(std::size_t n);

/// A line through n points along a spiral of `turns` turns, whose turns are nearer to each other
/// than successive points are.
ConstraintCase spiralLine(std::size_t n, std::size_t turns);

/// Lines that leap along n points which are collinear up to rounding.
ConstraintCase nearlyCollinearLines(std::size_t n);

/// A lattice of side x side points and `segments` segments along its rows, columns and diagonals:
/// they overlap, and pass through points.
ConstraintCase latticeSegments(std::size_t side, std::size_t segments);

/// Squares within squares on a lattice, each the other way round than the one about it.
ConstraintCase nestedLoops(std::size_t depth);

/// Points of a distribution and chains of any of them.
ConstraintCase chainsThrough(
  Distribution distribution, std::size_t n, std::size_t chains, std::uint64_t seed);

} // namespace test
} // namespace ahd

#endif
