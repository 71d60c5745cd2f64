// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Refine_h
#define ahd_Refine_h

#include "../Constraints.h"
#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "../Triangulation/Triangulation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// What the triangles of a mesh must be like.
struct RefineRequest
{
  static constexpr double kLargestAngle = 34.0;

  double minimumAngle = 20.0; ///< in degrees, 0 to kLargestAngle; 0: any
  double maximumArea = 0.0;   ///< of a triangle; 0: any
  double maximumLength = 0.0; ///< of an edge; 0: any
  /// For each point the longest edge wished there, or null: linear in each triangle that is
  /// refined; an edge may be as long as the mean of what is wished at its ends.
  const double* sizes = nullptr;
  std::size_t mostSteinerPoints = kMaximumPoints; ///< then it stops
};

/// Why a request is refused.
enum class RefineFault
{
  None,
  Angle,  ///< the minimum angle is NaN, negative or above kLargestAngle
  Area,   ///< the maximum area is NaN, negative or infinite
  Length, ///< the same of the maximum length
  Size,   ///< a size is NaN, 0, negative or infinite
  Range   ///< a coordinate is 2^900 or more in magnitude
};

/// Why a triangle does not meet the request.
enum class RefineReason : unsigned char
{
  InputAngle, ///< it lies in an angle below 60 degrees between two segments, which stays as it is
  Budget,     ///< RefineRequest::mostSteinerPoints was reached
  Resolution  ///< an edge is shorter than 1024 units in the last place, or no place is left
};

/// A new point, and where its data come from: sum the data of `corners`, times the weights.
struct SteinerPoint
{
  double x, y;
  /// Ids of points: the ends of the segment that it lies on, then kNoIndex; or the corners of the
  /// triangle of the input that it lies in.
  std::array<Index, 3> corners;
  std::array<double, 3> weights; ///< from 0 to 1, their sum 1; on a segment [1] is the fraction

  bool isOnSegment() const { return corners[2] == kNoIndex; }
};

/// The linear interpolation there; `value(id)` is the value at a point.
template <typename Value>
double interpolate(const SteinerPoint& point, const Value& value)
{
  const Index last = point.isOnSegment() ? point.corners[0] : point.corners[2];
  return point.weights[0] * value(point.corners[0]) + point.weights[1] * value(point.corners[1]) +
    point.weights[2] * value(last);
}

/// A triangle that does not meet the request: counterclockwise, from the smallest corner by x, y.
struct BadTriangle
{
  std::array<Index, 3> corners;
  RefineReason reason;
};

/// Points that refine() adds, and the segments split at them. Steiner point k has the id n + k,
/// where n points were given. triangulate() the points and those, and constrain() by constraints()
/// with FillRule::EvenOdd: the kept triangles are the refined ones.
struct Refinement
{
  RefineFault fault = RefineFault::None; ///< if there is one, all else is empty
  std::size_t faultAt = 0;               ///< the point (Size, Range)

  std::vector<SteinerPoint> points;

  /// Lines: a segment each, from one end to the other through the points that split it. Loops: all
  /// edges between what is inside and what is not, through their points.
  std::vector<std::int64_t> ids, offsets;
  std::size_t lines = 0;
  ConstraintView constraints() const
  {
    return { ids.data(), offsets.data(), offsets.empty() ? 0 : offsets.size() - 1, lines };
  }

  std::vector<BadTriangle> bad;     ///< in ascending order of their corners' places
  std::size_t triangles = 0;        ///< inside
  std::size_t onSegments = 0;       ///< Steiner points
  std::size_t encroachedPieces = 0; ///< of segments, that could not be split
};

/// Is there anything in the request, or with the points, that refine() refuses?
/// `at`: the first point with it.
RefineFault findRefineFault(
  const Triangulation& made, const RefineRequest& request, std::size_t& at);

/// Finds points with which the kept triangles of a (constrained) triangulation meet the request.
///
/// - Segments are its constraint edges, and the edges between kept triangles and others: split
///   crossings before. Angles between segments stay as they are, and so do bad triangles in them.
/// - Ends: by theorem up to 20.7 degrees if no segments meet in less than 60; in practice up to
///   kLargestAngle, as no edge below 1024 units in the last place is split. What does not meet the
///   request is in `bad`.
/// - A Steiner point lies on its segment but for rounding, half a unit in the last place.
/// - Canonical: a function of the set of points, of the segments and the request; up to ids the
///   same for any order of the input, on any system.
///
/// Memory: all that it takes is requested by Progress::take(), but for the tables of `made`. The
/// phase is Phase::Outputs.
///
/// @param made its tables are made. @pre made without Options::insertionLimit
/// @return Ok, with Refinement::fault set for what findRefineFault() finds; Cancelled,
///     TooManyPoints or OutOfMemory
Status refine(
  Triangulation& made, const RefineRequest& request, const Context& context, Refinement& out);

} // namespace ahd

#endif
