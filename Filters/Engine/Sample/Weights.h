// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Weights_h
#define ahd_Weights_h

#include "../Points/Points.h"
#include "../Triangulation/Tables.h"

#include <cstddef>
#include <limits>

namespace ahd
{

/// The value of a place that has none.
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// What the value at a place is made of: values at `count` vertices, times their weights. None for
/// a place that has no value.
struct Weights
{
  const Index* vertices = nullptr;
  const double* weights = nullptr;
  std::size_t count = 0;
  HalfEdge at = kNoHalfEdge; ///< of the triangle that it lies in, where there are any; else
  Index ends[2] = { kNoIndex, kNoIndex }; ///< of the piece of the line that it lies on
};

/// Is the triangle so well shaped, and of such a size, that weights by areas in plain double
/// precision are right to some 2^-40?
///
/// A place in it sees the corners as A, B, C, each no longer than the longest edge. Each area is
/// then wrong by at most 4 u of its square L (two products, each with three roundings), and the sum
/// of the areas is at least 2^-9 L / 2. So weights are wrong by less than 2^-53 * 2^2 * 2^10 * 2.
inline bool isEasy(const Point& a, const Point& b, const Point& c)
{
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  const double size = (ux * ux + uy * uy) + (vx * vx + vy * vy); // half of L at least
  return (ux * vy - uy * vx > 0x1p-9 * size) & (size < 0x1p400) & (size > 0x1p-400);
}

/// The weights of the corners at p, for a triangle that isEasy().
inline void easyWeights(
  const Point& a, const Point& b, const Point& c, const Point& p, double (&weights)[3])
{
  const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
  const double cx = c.x - p.x, cy = c.y - p.y;
  const double u = bx * cy - by * cx, v = cx * ay - cy * ax, w = ax * by - ay * bx;
  const double ofA = u > 0.0 ? u : 0.0, ofB = v > 0.0 ? v : 0.0, ofC = w > 0.0 ? w : 0.0;
  const double scale = 1.0 / (ofA + ofB + ofC);
  weights[0] = ofA * scale;
  weights[1] = ofB * scale;
  weights[2] = ofC * scale;
}

/// The same for any other triangle with an area: by doubles of 106 bits, or by integers.
/// @pre p lies inside of the triangle or on its border.
void hardWeights(
  const Point& a, const Point& b, const Point& c, const Point& p, double (&weights)[3]);

/// The weights of the ends of an edge at p, which lies between them. The same numbers if the ends
/// are swapped.
void edgeWeights(const Point& a, const Point& b, const Point& p, double (&weights)[2]);

/// The same at the place between the ends that is nearest to p, wherever p lies.
/// @pre it is no end.
void footWeights(const Point& a, const Point& b, const Point& p, double (&weights)[2]);

/// How much a value rises along x and y in a triangle, where it is `value` at the corners.
/// @pre the triangle has an area.
Point slopeIn(const Point& a, const Point& b, const Point& c, const double (&value)[3]);

/// The same along a line from a to b.
Point slopeAlong(const Point& a, const Point& b, double atA, double atB);

} // namespace ahd

#endif
