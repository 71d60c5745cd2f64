// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TriangleJudge_h
#define ahd_TriangleJudge_h

#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// The verdict on triangles of points, from any program. All counts are exact. "Place":
/// the x, y of one or more points; points at one place are one vertex, whichever of them is named.
struct Verdict
{
  std::size_t points = 0;
  std::size_t places = 0;    ///< distinct points
  std::size_t triangles = 0; ///< as given, the faulty ones too
  std::size_t expected = 0;  ///< 2 v - 2 - h for v places, h of them on the boundary of the hull

  std::size_t lost = 0;       ///< places that are the corner of no triangle
  std::size_t invented = 0;   ///< triangles with a corner that is no input point
  std::size_t degenerate = 0; ///< triangles without area
  std::size_t clockwise = 0;  ///< triangles; judged further as if they were turned round
  std::size_t overlaps = 0;   ///< uses of an edge from one side, beyond the first
  std::size_t notDelaunay =
    0;                       ///< inner edges with the opposite corner strictly in the circumcircle
  std::size_t border = 0;    ///< edges with a triangle on one side only
  bool hullComplete = false; ///< the areas of all triangles add up to that of the hull, exactly
  double areaShare = 0.0;    ///< the sum of the areas, over the area of the hull; 1 if that is 0

  /// The Delaunay triangulation, whole. Cocircular points may be joined either way, and either
  /// orientation is accepted if it is that of all triangles.
  bool isRight() const;

  std::string json() const;
};

/// Judges, in exact arithmetic (ExactSigns.h). Takes time linear in the numbers of points and
/// triangles, but for sorting the points and the edges about each vertex.
/// `triples`: three ids of points per triangle; any number is legal, that of no point is a fault.
/// @pre the points are finite.
Verdict judge(const std::vector<Point>& points, const std::vector<std::int32_t>& triples);

/// The same where triangles name corners of a table of their own: each entry of `vertices` is
/// looked up among the points by its coordinates, every bit of them.
Verdict judge(const std::vector<Point>& points, const std::vector<Point>& vertices,
  const std::vector<std::int32_t>& triples);

} // namespace test
} // namespace ahd

#endif
