// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Cavity_h
#define ahd_Cavity_h

#include "Spots.h"

#include <vector>

namespace ahd
{

/// The triangles that would go if a place became a vertex: those whose circumcircle has it inside,
/// connected to the one it lies in. The cavity ends at the hull, at constraint edges and at
/// triangles that are not kept.
///
/// Seen from the place, it is a star, and all its vertices are on its border. Proof. Let p be in
/// the open circle of triangle T of the cavity, entered across edge f, beyond which p lies. What is
/// beyond both f and another edge of T is the wedge opposite to T at their common vertex, which is
/// outside of the circle, as T and the wedge are on different sides of the tangent there; and on an
/// edge itself p would be in T. So p is strictly inside of the other two edges, and each border
/// edge is seen from p. If all triangles around a vertex w were in the cavity, so would be the one
/// behind w, seen from p; but then p is in the wedge opposite to it at w. A border edge to which a
/// triangle in conflict is adjacent has no open circle around p's side of it, as edges that are no
/// constraints are locally Delaunay.
class Cavity
{
public:
  /// How to go around the cavity, triangle after triangle.
  struct Step
  {
    enum Kind
    {
      Enter, ///< across halfEdge, into the triangle of its twin
      Leave, ///< back to the triangle it was entered from
      Border ///< past halfEdge, an edge of the border
    };
    Kind kind;
    HalfEdge halfEdge;
  };

  /// Returns false if cancelled; throws std::bad_alloc. @pre the place lies
  /// inside of the triangle, which is kept, or between the ends of an edge of it that
  /// isCrossable().
  bool find(
    const SampledSurface& surface, std::size_t triangle, const Point& place, Ticker& ticker);

  /// May a cavity go on beyond the edge of a kept triangle?
  static bool isCrossable(const SampledSurface& surface, HalfEdge h)
  {
    const HalfEdge twin = surface.tables->twins[h];
    return twin != kNoHalfEdge && !surface.tables->isConstrained(h) && surface.isKept(twin / 3);
  }

  std::size_t triangle() const { return triangle_; }
  const std::vector<Step>& steps() const { return steps_; }
  /// Where the border's edges begin, in the order of the steps, counterclockwise.
  const std::vector<Index>& vertices() const { return vertices_; }

private:
  std::size_t triangle_ = 0;
  std::vector<Step> steps_;
  std::vector<Index> vertices_;
  std::vector<HalfEdge> stack_;
};

} // namespace ahd

#endif
