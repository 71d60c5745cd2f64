// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HeightSurface_h
#define ahd_HeightSurface_h

#include "../Surface/Means.h"
#include "../Triangulation/Triangulation.h"
#include "Prepare.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// The surface that heights come from.
struct HeightSurface
{
  Triangulation triangulation;
  std::vector<Mean> means;      ///< where they are its heights
  std::vector<Index> triangles; ///< at or near each point of the source

  /// At the vertex that a point stands for. `points`: those triangulated, with z.
  double heightAt(Index id, const PointView& points) const;
};

/// Finds places on a surface.
class SurfacePlacer
{
public:
  SurfacePlacer(const Triangulation& surface, Ticker& ticker)
    : surface_(surface)
    , ticker_(ticker)
  {
  }

  /// Polls for cancellation. A function of the place alone.
  SurfacePlace operator()(const Point& place);
  /// The triangle of the last one; the search for the next starts there.
  std::size_t triangle() const { return hint_; }
  void startAt(std::size_t triangle) { hint_ = triangle; }
  /// On one of its edges, or beside it by rounding.
  SurfacePlace onEdge(HalfEdge h, const Point& place) const;

private:
  Index pointAt(HalfEdge h) const { return surface_.pointOf(surface_.origin(h)); }
  Point originOf(HalfEdge h) const { return surface_.at(surface_.origin(h)); }
  SurfacePlace inTriangle(HalfEdge h, const Point& place) const;

  const Triangulation& surface_;
  Ticker& ticker_;
  std::size_t hint_ = 0; ///< points of the source follow each other along lines
};

} // namespace ahd

#endif
