// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Prepare_h
#define ahd_Prepare_h

#include "../Constraints.h"
#include "../Core/Context.h"
#include "../Core/Uninitialised.h"
#include "../Merge/Merge.h"
#include "../Options.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "../Surface/FindTriangles.h"
#include "../Surface/Plane.h"
#include "ClosedLines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace ahd
{

class Triangulation;

/// Cells of a source, borrowed from the caller: cell k has the ids offsets[k] to offsets[k + 1] -
/// 1. Both arrays have 32 bits, or both 64.
///
/// @pre findBadCell() finds none
struct CellsView
{
  const std::int32_t* offsets32 = nullptr;
  const std::int32_t* ids32 = nullptr;
  const std::int64_t* offsets64 = nullptr;
  const std::int64_t* ids64 = nullptr;
  std::size_t cells = 0;
  std::size_t ids = 0; ///< of all cells
};

/// The places of points relative to a plane that the caller chose.
class Projection
{
public:
  virtual ~Projection() = default;

  /// Writes three numbers for each point: its place in the plane, and its height above it; three
  /// NaN for a point with a coordinate that is not finite. `to` may be the points' own memory.
  /// Throws at most std::bad_alloc.
  ///
  /// @return false if cancelled
  virtual bool project(const PointView& points, double* to, const Context& context) const = 0;
};

/// Where points of a source have their heights from.
enum class SourceHeights
{
  Own,
  FromSurface, ///< the triangulation of the input alone; those outside of it keep their own
  /// Those without a height: the triangulation of the input and of the source's other points,
  /// constrained by the segments between these; outside of it they have none.
  Mixed
};

/// The input of a triangulation, and the steps to take before it.
struct InputRequest
{
  PointView points;       ///< of the input, those to be left out marked
  PointView sourcePoints; ///< become points as well, after the input's; none if its count is 0

  CellsView lines;            ///< of the source: open chains
  CellsView polygons;         ///< of the source: loops
  std::int64_t firstCell = 0; ///< the number of the first line in reports; polygons follow lines
  bool idsAreOfInput = false; ///< the ids in cells name points of the input, not of the source
  /// Lines whose ends are one point, or have the same x and y in the plane, are loops, as lines
  /// that join to such a line (ClosedLines.h). They follow the open lines and precede the polygons.
  bool closedLinesAreLoops = false;
  /// Where the source's own points are added, and it has no line and no polygon: they are a line.
  bool pointsAreLine = false;

  SourceHeights heights = SourceHeights::Own; ///< those of a surface by linear interpolation
  bool zeroIsMissing = false; ///< a height of 0 is none, as NaN is: for SourceHeights::Mixed
  /// Points are added where segments of the source cross edges of the surface that heights come
  /// from, but for those between two points with heights of their own (LineLayer.h).
  bool linesOnSurface = false;
  /// Points are added to divide longer segments, or pieces of them, in the plane; 0: none is.
  double maximumSegmentLength = 0.0;
  /// Of input points at one place: the one whose height that surface has.
  Representative representative = Representative::FirstId;
  bool meanHeights = false; ///< it has the mean of all instead

  bool fitPlane = false;          ///< triangulate in the plane that fits the input best
  std::size_t unfittedPoints = 0; ///< but for so many of its points, the last ones
  const Plane* plane = nullptr;   ///< that plane, if it was fitted before, perhaps to other points
  const Projection* projection = nullptr; ///< or in this one; null: in x, y
  double tolerance = 0.0;                 ///< merge within this part of the diagonal of the points
  bool bounding = false; ///< add VTK's eight bounding points; only where the plane is x, y
  double offset = 1.0;   ///< how far out they lie
  /// Their box, if it is more than that of these points: the lowest and the highest coordinates of
  /// those with finite x, y; of z the finite ones. None: low is above high.
  const std::array<Vector3, 2>* bounds = nullptr;
  bool split = false; ///< split constraints where they cross
  /// Another block has points of a source, so that the bounds of this one's are wanted.
  bool isSourceElsewhere = false;
  /// A run that must split, or divide, segments in more places ends with Status::TooManyCrossings
  /// before it does.
  std::size_t mostCrossings = std::size_t(-1);

  /// For Run, which finds them in the triangulation; prepare() ignores it. None: count
  /// is 0.
  GivenTriangles surface;
};

/// The neighbours of a point added at the crossing of two segments. Segments and their ends are in
/// the order of their places, whatever the order and directions of the constraints; of more than
/// two segments, the first two that cross there.
struct CrossingOrigin
{
  std::array<Index, 4> ends;   ///< of either segment the smaller end, by x, then y, and the other
  std::array<double, 2> along; ///< the fraction of the way from the first end to the second
};

/// The linear interpolation at a crossing, as a mean over both segments; `value(id)` is the value
/// at a point.
template <typename Value>
double interpolate(const CrossingOrigin& crossing, const Value& value)
{
  const auto along = [&](std::size_t k)
  {
    const double t = crossing.along[k];
    return (1.0 - t) * value(crossing.ends[2 * k]) + t * value(crossing.ends[2 * k + 1]);
  };
  return 0.5 * along(0) + 0.5 * along(1);
}

/// The origin of a point that was laid on a surface, or added to a line: the points that it lies
/// between, and their weights.
struct SurfacePlace
{
  std::array<Index, 3> corners = {};
  std::array<double, 3> weights = {}; ///< from 0, with the sum 1; all 0: it keeps its own

  bool isInside() const { return weights[0] + weights[1] + weights[2] > 0.0; }
};

/// The linear interpolation there.
/// @pre isInside()
template <typename Value>
double interpolate(const SurfacePlace& place, const Value& value)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    // a corner without weight may be NaN
    sum += place.weights[k] > 0.0 ? place.weights[k] * value(place.corners[k]) : 0.0;
  }
  return sum;
}

/// Ids in cells of the source that are no point's.
struct UnfitIds
{
  std::size_t count = 0;
  std::int64_t firstId = 0;
  std::int64_t firstCell = 0;

  auto fields() { return std::tie(count, firstId, firstCell); }
};

/// Bounds of places; empty (low > high) around none.
struct SpaceBox
{
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vector3 low = { { kInfinity, kInfinity, kInfinity } };
  Vector3 high = { { -kInfinity, -kInfinity, -kInfinity } };

  void add(std::size_t k, double lowest, double highest)
  {
    low[k] = std::min(low[k], lowest);
    high[k] = std::max(high[k], highest);
  }
  void merge(const SpaceBox& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      add(k, other.low[k], other.high[k]);
    }
  }
  auto fields() { return std::tie(low, high); }
};

/// Where the points that a source adds lie, and those of the input, in the plane and above it; of z
/// the finite ones.
struct SourceBounds
{
  SpaceBox input, source; ///< empty without such a source
  /// Lines and polygons of the source with their own heights that are 0 throughout; none in a plane
  /// other than x, y, above which heights are not z.
  std::size_t flatChains = 0;

  /// Do they not overlap, nor touch, in the plane, though there are points of both?
  bool areApart() const
  {
    const auto isBelow = [](const SpaceBox& a, const SpaceBox& b)
    { return a.high[0] < b.low[0] || a.high[1] < b.low[1]; };
    return input.low[0] <= input.high[0] && source.low[0] <= source.high[0] &&
      (isBelow(input, source) || isBelow(source, input));
  }
  /// Chains at height 0, if the input has points, and 0 is further from their range than a quarter
  /// of it: a shore at 0 beside soundings from -40 to -2 is as it should be.
  std::size_t chainsOffTerrain() const
  {
    const double apart = std::max(input.low[2], -input.high[2]);
    const bool isOff = apart > 0.25 * input.high[2] - 0.25 * input.low[2];
    return isOff && input.low[2] <= input.high[2] ? flatChains : 0;
  }
  void merge(const SourceBounds& other)
  {
    input.merge(other.input);
    source.merge(other.source);
    flatChains += other.flatChains;
  }
  auto fields() { return std::tie(input, source, flatChains); }
};

/// Points and constraints, ready to be triangulated, each with its id in the output: the input's,
/// then the source's, those added to lines, the eight bounding points, the crossings.
///
/// Borrows the input's places while they are triangulated in x, y and nothing is added; otherwise
/// has a copy in double precision.
class PreparedInput
{
public:
  PreparedInput() = default;
  PreparedInput(PreparedInput&&) = default; // views of vectors, whose memory moves along
  PreparedInput& operator=(PreparedInput&&) = default;
  PreparedInput(const PreparedInput&) = delete;
  PreparedInput& operator=(const PreparedInput&) = delete;

  /// All points: x and y in the plane of the triangulation, and the height above it.
  const PointView& points() const { return points_; }
  std::size_t inputCount() const { return inputCount_; }
  std::size_t sourceCount() const { return sourceCount_; }
  std::size_t addedCount() const { return points_.count - inputCount_; }
  std::size_t firstCrossing() const { return points_.count - crossings_.size(); }
  std::array<double, 3> place(std::size_t id) const;

  /// Is the plane not x, y?
  bool isProjected() const { return isProjected_; }
  /// The plane that was fitted, with InputRequest::fitPlane.
  const Plane& plane() const { return plane_; }

  /// Points that tolerance merged into others, by ascending id. They are left out of points().
  const std::vector<MergedPoint>& merged() const { return merged_; }

  /// One for each point of the source, then for each that was added to lines: to be interpolated in
  /// this order, as one may lie between others. Empty if there are none of either.
  const std::vector<SurfacePlace>& surfacePlaces() const { return surfacePlaces_; }
  /// The number of points added to lines; they follow those of the source.
  std::size_t addedToLines() const { return addedToLines_; }
  /// How many points of the source have no height because they lie outside the surface.
  std::size_t outsideCount() const { return outside_; }

  /// The constraints, lines before polygons; merged points replaced by those they were merged into.
  ConstraintView constraints() const;
  bool hasConstraints() const { return !ids_.empty(); }
  /// The source cell of a chain.
  std::int64_t cellOf(std::size_t chain) const;
  const UnfitIds& unfitIds() const { return unfit_; }
  /// Are there lines, and none is closed, though closed ones would be loops?
  bool areLinesUnclosed() const { return areLinesUnclosed_; }
  /// The ends of a chain.
  LineEnds endsOf(std::size_t chain) const;
  const SourceBounds& sourceBounds() const { return sourceBounds_; }

  /// One for each crossing that was added.
  const std::vector<CrossingOrigin>& crossings() const { return crossings_; }
  /// The cells of the first thousand of them: the later one, the earlier one.
  const std::vector<std::array<std::int64_t, 2>>& crossingCells() const { return crossingCells_; }

  /// Segments that bend because they were led through a vertex not exactly on them; and the cell of
  /// the first of these, if there is one.
  std::size_t bentCount() const { return bentCount_; }
  std::int64_t firstBentCell() const { return firstBentCell_; }

  /// Refers crossings and points added to lines to the points that represent the vertices that
  /// they lie between, which give them their heights.
  ///
  /// @pre a triangulation of these points
  Status endCrossingsAtVertices(Triangulation& triangulation, const Context& context);

private:
  friend class Preparation; // one call of prepare()
  void findAddedHeights();
  void findCrossingHeights();

  PointView points_;
  UninitialisedVector<double> places_; ///< the copy; empty without
  std::vector<unsigned char> skip_;    ///< a byte per point, if they are not the input's own marks
  std::size_t inputCount_ = 0;
  std::size_t sourceCount_ = 0;
  bool isProjected_ = false;
  Plane plane_;
  std::vector<MergedPoint> merged_;
  std::vector<SurfacePlace> surfacePlaces_;
  std::size_t addedToLines_ = 0;
  std::size_t outside_ = 0;
  std::vector<std::int64_t> ids_;     ///< of the chains
  std::vector<std::int64_t> offsets_; ///< empty without chains
  std::size_t lines_ = 0;
  std::vector<std::int64_t> cells_; ///< of the chains, from 0; empty if chain k is of cell k
  std::int64_t firstCell_ = 0;
  UnfitIds unfit_;
  bool areLinesUnclosed_ = false;
  SourceBounds sourceBounds_;
  std::vector<CrossingOrigin> crossings_;
  std::vector<std::array<std::int64_t, 2>> crossingCells_;
  std::size_t bentCount_ = 0;
  std::int64_t firstBentCell_ = 0;
};

/// Prepares the input: reads it, moves it into the plane, compares its places with those of the
/// source, takes heights from the surface, merges near points, reads the constraints, adds points
/// to them, adds bounding points and splits the constraints, in this order. The phases are
/// Phase::Merge and, from the constraints on, Phase::Split.
///
/// @pre `out` is new
/// @param out undefined unless the result is Ok
/// @return Ok, Cancelled, OutOfMemory, TooManyPoints or TooManyCrossings
Status prepare(const InputRequest& request, const Context& context, PreparedInput& out);

/// The height of each point of the surface above the plane: as prepared; with `means`, at a place
/// of several points the mean of all with a finite z (Means.h), as the height of the representing
/// point, and at crossings the values between those.
///
/// @param triangulation of these points; its missing tables are made
/// @param heights one number for each
/// @return Ok, Cancelled or OutOfMemory
Status findHeights(const PreparedInput& points, Triangulation& triangulation, bool means,
  const Context& context, double* heights);

/// The plane that fits the points of the input best, but for InputRequest::unfittedPoints.
///
/// @return Ok, Cancelled or OutOfMemory
Status fitPlaneOf(const InputRequest& request, const Context& context, Plane& plane);

/// A cell whose offsets do not ascend, or lie outside the ids.
struct BadCell
{
  std::size_t cell = 0;
  std::int64_t begin = 0, end = 0; ///< its offsets
  std::size_t ids = 0;             ///< that there are, of all cells
};

/// Checks the offsets of cells from elsewhere. Ids in no cell are no fault. The phase is
/// Phase::Merge.
///
/// @return Ok, Cancelled, OutOfMemory, or BadCells with the first such cell
Status findBadCell(const CellsView& cells, const Context& context, BadCell& bad);

/// The number of points for prepare(), crossings excepted.
std::size_t expectedPoints(const InputRequest& request);

/// Are the points of the source a line? See InputRequest::pointsAreLine.
bool arePointsLine(const InputRequest& request);

/// The number of segments of the source, at most.
std::size_t segmentsOf(const InputRequest& request);

/// Upper bound of the bytes that prepare() takes, except for crossings, unknown before
/// (splitMemoryEstimate() has their share, most of which is returned), points added to lines, and
/// the surface that heights come from, which it returns.
std::size_t preparationMemoryEstimate(const InputRequest& request);

/// The part of it that remains during the triangulation.
std::size_t preparedMemoryEstimate(const InputRequest& request);

/// Points that deserve a warning.
struct OddPoints
{
  std::size_t firstNotFinite = 0; ///< smallest id of a point with an x or y that is not finite; 0
                                  ///< if there is none
  std::size_t oddZ = 0;           ///< points with finite x, y and a z that is not finite

  auto fields() { return std::tie(firstNotFinite, oddZ); }
};

/// One pass over points, without those left out. The phase is Phase::Extract.
///
/// @return Ok, Cancelled or OutOfMemory
Status findOddPoints(const PointView& points, const Context& context, OddPoints& odd);

} // namespace ahd

#endif
