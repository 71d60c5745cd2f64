// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Locate_h
#define ahd_Locate_h

#include "Tables.h"

#include "../Core/Progress.h"

namespace ahd
{

/// Finds places in a triangulation.
///
/// It walks from triangle to triangle, across an edge that the place lies beyond. Where that are
/// two, a hash of the number of steps says across which one: in a constrained triangulation a walk
/// by a fixed rule may go round in circles. One that has taken more than `mostSteps` steps is given
/// up, and all triangles are looked at; so it ends whatever happens.
class Locator
{
public:
  Locator(const Tables& tables, const Point* places)
    : tables_(tables)
    , places_(places)
  {
  }

  /// Nowhere if cancelled: the ticker has the steps.
  /// @pre corners and neighbours; a finite place; from < triangles.
  Location locate(
    const Point& place, std::size_t from, std::size_t mostSteps, Ticker& ticker) const;

private:
  /// One to the left of the half-edge, zero on its line, minus one to the right.
  int side(HalfEdge h, const Point& place) const;
  HalfEdge edgeToCross(HalfEdge entered, const Point& place, std::size_t step) const;
  Location inTriangle(std::size_t triangle, const Point& place) const;
  Location lookEverywhere(const Point& place, Ticker& ticker) const;

  const Tables& tables_;
  const Point* places_;
};

} // namespace ahd

#endif
