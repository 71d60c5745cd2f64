// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Simplify_h
#define ahd_Simplify_h

#include "../Constraints.h"
#include "../Core/Buffer.h"
#include "../Core/Context.h"
#include "../Options.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>

namespace ahd
{

/// One number for each point, read in place: that of point i is at data + i * stride.
struct NumbersView
{
  const double* doubles = nullptr;
  const float* floats = nullptr; ///< in place of doubles
  std::size_t stride = 1;

  bool isGiven() const { return doubles || floats; }
  double operator[](std::size_t i) const
  {
    return doubles ? doubles[i * stride] : double(floats[i * stride]);
  }
};

/// What became of a point. All but Kept is left out of the simplified surface.
enum class PointLot : unsigned char
{
  Kept = 0,        ///< or at the place of one that is, or without finite x, y
  WithinError = 1, ///< the surface without it is near enough; or at the place of such a point
  Skipped = 2      ///< left out by the caller (PointView::skip)
};

/// The input of simplify(); all views are borrowed.
struct SimplifyRequest
{
  PointView points;
  NumbersView values;  ///< of the surface; none: z of the points
  NumbersView weights; ///< times which errors count; none: 1
  const unsigned char* mustStay =
    nullptr;                  ///< a byte for each point, 0 for those that may go; or null
  ConstraintView constraints; ///< as for constrain(); their ends stay

  double maximumError = 0.0; ///< finite, from 0
  /// The best surface within so many vertices, if the bound needs more; 0: no limit. Those that
  /// must stay are never too many.
  std::size_t maximumNumberOfVertices = 0;
  /// Then takes vertices out again, as long as the bound holds; or, if the limit came first, the
  /// error that it left.
  bool secondPass = false;
  /// Of several points at one place: whose value counts.
  Representative representative = Representative::FirstId;
};

/// The outcome of simplify().
struct SimplifyResult
{
  /// Of each point. The bytes are marks for PointView::skip with skipMask 0xFF.
  Buffer<PointLot> lots;
  double largestError = 0.0;   ///< of all points left out; weighted
  double measuredWithin = 0.0; ///< the bound of Interpolant::measure() for that of each
  bool isWithinBound = true;   ///< false: the limit of vertices came first
  std::size_t kept = 0;        ///< places
  std::size_t withinError = 0; ///< places
  std::size_t leftOut = 0;     ///< points: those, and others at their places
  std::size_t rounds = 0;

  /// The points without those left out. The view borrows this object.
  PointView without(PointView points) const
  {
    points.skip = reinterpret_cast<const unsigned char*>(lots.data());
    points.skipMask = 0xFF;
    return points;
  }
};

/// Is the bound one that simplify() takes: finite, and not negative?
bool isErrorBound(double maximumError);

/// Chooses points whose surface, triangulate() and constrain() of them alone, differs at no point
/// by more than a bound: |value - linear interpolation| * weight <= maximumError.
///
/// - The bound holds at all points given, in arithmetic of some 100 bits, along the axis of the
///   values (vertical for heights). Of points at one place it holds for the representative. Between
///   the points nothing is promised.
/// - Kept are the corners of the convex hull, the ends of constraints, points that must stay, and
///   points whose value or weight is not finite, or whose weight is negative; in triangles with a
///   corner whose value is not finite, all points. With maximumError 0 all that is not exactly on
///   the surface, as far as that arithmetic tells. Without a triangle all are kept.
/// - Canonical: a function of the points, their values and the settings; the same for any order of
///   the points, numbers of threads and platforms.
/// - Constraints that cross an earlier one are left out, as by constrain(). Loops drop no triangles
///   here: the bound holds on both sides of them.
///
/// The phases are Read, Sort and Insert.
///
/// @pre isErrorBound(maximumError)
/// @param out undefined unless the result is Ok
/// @return Ok, Cancelled, TooManyPoints or OutOfMemory
Status simplify(const SimplifyRequest& request, const Context& context, SimplifyResult& out);

/// Upper bound of the bytes that simplify() takes, the result included, except for the vertices
/// it keeps: it requests theirs by Progress::take(), at most 3 * 88 bytes for each.
std::size_t simplifyMemoryEstimate(const SimplifyRequest& request);

} // namespace ahd

#endif
