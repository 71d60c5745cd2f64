// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_OrderDrawing_h
#define ahd_OrderDrawing_h

#include "../Core/Context.h"
#include "../Result.h"

#include <cstddef>

namespace ahd
{

class Triangulation;

/// Corners of a box.
constexpr std::size_t kBoxCorners = 4;

/// Memory for the drawing of the insertion order. Id: a signed integer of 32 or 64 bits.
template <typename Id>
struct OrderDrawing
{
  double* xyz; ///< three per point: of the inserted ones, if there is a curve; then boxes' corners
  Id* ranks;   ///< per point: its place in the order; -1 for corners
  Id* ids;     ///< per point: its id; -1 for corners
  int* levels; ///< per cell: -1 for the curve, if there is one; then the level of each box
  Id* counts;  ///< per cell: the points that the curve passes; the distinct points in each box
};

/// The size of a drawing.
struct DrawnOrder
{
  std::size_t points() const { return passed + kBoxCorners * boxes; }
  std::size_t cells() const { return curves + boxes; }

  std::size_t passed; ///< points: with a curve, report().inserted
  std::size_t curves; ///< 1, or 0 where it would pass fewer than two
  std::size_t boxes;
};
DrawnOrder drawnOrder(const Triangulation& triangulation, bool withCurve);

/// Writes the drawing. Corners are counterclockwise from the lower left; their z is the lowest
/// finite one of all points with a place, 0 if there is none, so that it stays while the limit
/// changes.
///
/// @pre with a curve Options::keepOrder
/// @return Ok or Cancelled
template <typename Id>
Status drawOrder(Triangulation& triangulation, bool withCurve, const OrderDrawing<Id>& drawing,
  const Context& context);

} // namespace ahd

#endif
