// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Options_h
#define ahd_Options_h

#include <cstddef>

namespace ahd
{

/// The order in which points are inserted. It changes the time, never the result. RG, MG and HG are
/// the names in Su et al., Computers & Graphics 54 (2016).
enum class InsertionOrder
{
  AdaptiveHilbert = 0, ///< HG: multi-grid, boxes along an adaptive Hilbert curve
  MultiGrid = 1,       ///< MG: multi-grid, boxes line by line (S. H. Lo 2013)
  RegularGrid = 2,     ///< RG: one even grid, boxes line by line
  AsGiven = 3          ///< the caller's order
};

/// Points inserted before all others, to prevent long thin triangles. Used by AdaptiveHilbert and
/// MultiGrid; RegularGrid and AsGiven have none.
enum class ControlPoints
{
  Off = 0,
  SingleLevel = 1, ///< the paper's: the first point of every box of the first level
  EveryLevel = 2   ///< a sparse subset of the order, of that subset another, and so on
};

/// Which of several points at one place represents the vertex, in the written triples and wherever
/// a vertex has a point's id. It changes ids only.
enum class Representative
{
  FirstId = 0, ///< the one of smallest id
  LowestZ = 1, ///< the one of lowest finite z, of several the one of smallest id
  HighestZ = 2 ///< the one of highest finite z, of several the one of smallest id
};

/// Bounds that ranks refer to; empty (min > max): those of the points.
struct RankBounds
{
  double xmin = 1.0, xmax = -1.0;
  double ymin = 1.0, ymax = -1.0;
};

/// Settings of a triangulation. Every combination is legal and, without insertionLimit, gives the
/// same triangles; only the representative changes their ids.
struct Options
{
  InsertionOrder order = InsertionOrder::AdaptiveHilbert;
  ControlPoints controlPoints = ControlPoints::EveryLevel;

  /// Turn the curve in each divided box so that it meets its neighbours (AdaptiveHilbert only).
  bool geneRotation = true;

  /// A box with more points than this is divided. At least 1; the paper recommends 50 to 200.
  /// Without effect if the curve goes on inside the boxes: AdaptiveHilbert, EveryLevel and
  /// geneRotation.
  int nmax = 50;

  /// Count NP and NR (see Report). Costs a few percent.
  bool countWork = false;

  /// Stop after this many points of the insertion order: the triangles are then the Delaunay
  /// triangulation of these. 0 means all. With a limit one thread inserts.
  std::size_t insertionLimit = 0;

  /// Keep the insertion order, for Triangulation::writeOrder and writeInsertionRanks. 4 bytes per
  /// point.
  bool keepOrder = false;

  /// Keep the boxes of the grid, for Triangulation::boxes. AsGiven has none.
  bool keepBoxes = false;

  Representative representative = Representative::FirstId;

  /// For some of all points: those of all. Points beyond them enlarge them. The order of vertices,
  /// triangles and sums is then that of all points (but see BoxNeighbors.h on crowds).
  RankBounds rankBounds;

  /// A run with more boxes ends with Status::TooManyBoxes, before it inserts.
  std::size_t mostBoxes = std::size_t(-1);
};

} // namespace ahd

#endif
