// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FirstTriangle_h
#define ahd_FirstTriangle_h

#include "Insert.h"

#include "../Predicates/Predicates.h"

namespace ahd
{

/// A sequence begins with a triangle: its first two points and the first that is not on their line.
/// That third one stands at place 2 instead of its own, `third`; places 2 .. third - 1 move up by
/// one.
struct FirstTriangle
{
  InsertionEnd end = InsertionEnd::AllCollinear; ///< Done: the mesh has its first triangle
  std::size_t third = 0;

  /// The place in the sequence of the point that is inserted as the i-th. @pre i >= 3.
  std::size_t place(std::size_t i) const { return i <= third ? i - 1 : i; }
};

/// `at(i)` is the i-th of n >= 3 vertices.
template <typename At>
FirstTriangle makeFirstTriangle(
  const RankedPoints& points, std::size_t n, At at, Mesh& mesh, Ticker& ticker)
{
  const Point* const xy = points.xy.data();
  const Index a = at(0);
  const Index b = at(1);
  FirstTriangle first;
  for (std::size_t i = 2; i < n; ++i)
  {
    const Index c = at(i);
    const int side = orient2d(xy[a], xy[b], xy[c]);
    if (side != 0)
    {
      mesh.makeFirstTriangle(side > 0 ? a : b, side > 0 ? b : a, c);
      ticker.finished(3);
      first.end = InsertionEnd::Done;
      first.third = i;
      return first;
    }
    if (!ticker.step())
    {
      first.end = InsertionEnd::Cancelled;
      return first;
    }
  }
  return first;
}

} // namespace ahd

#endif
