// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Diagram_h
#define ahd_Diagram_h

#include "../Core/Buffer.h"
#include "Circumcentre.h"
#include "ClipBox.h"
#include "Voronoi.h"

#include <algorithm>

namespace ahd
{

/// A half-edge is named by 3 * triangle + edge; edge e goes from corner e to the next one. Edges at
/// infinity, the duals of which are the rays of the diagram, have one half-edge.
using HalfEdge = std::uint32_t;
constexpr HalfEdge kNoHalfEdge = 0xFFFFFFFFu;

inline HalfEdge nextInTriangle(HalfEdge h)
{
  return h % 3 == 2 ? h - 2 : h + 1;
}

inline HalfEdge previousInTriangle(HalfEdge h)
{
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// The circumcentres of a Delaunay triangulation, and its topology as the Voronoi diagram needs it.
class Diagram
{
public:
  /// Borrows `delaunay`.
  explicit Diagram(const DelaunayView& delaunay)
    : delaunay_(delaunay)
  {
  }

  /// Computes the centres. Returns false if cancelled; throws std::bad_alloc.
  bool build(Ticker& ticker);

  std::size_t triangles() const { return delaunay_.triangles; }
  const DelaunayView& delaunay() const { return delaunay_; }

  std::size_t origin(HalfEdge h) const { return static_cast<std::size_t>(delaunay_.corners[h]); }
  std::size_t target(HalfEdge h) const { return origin(nextInTriangle(h)); }
  Point point(std::size_t id) const { return delaunay_.points[id]; }

  /// The same edge seen from the other side; kNoHalfEdge on the hull.
  HalfEdge twin(HalfEdge h) const
  {
    const std::int64_t other = delaunay_.neighbors[h];
    if (other < 0)
    {
      return kNoHalfEdge;
    }
    const HalfEdge first = 3 * static_cast<HalfEdge>(other);
    const std::int64_t triangle = static_cast<std::int64_t>(h / 3);
    return delaunay_.neighbors[first] == triangle  ? first
      : delaunay_.neighbors[first + 1] == triangle ? first + 1
                                                   : first + 2;
  }

  /// One half-edge that begins at the vertex; the hull's own if it lies on the hull, so that
  /// turning counterclockwise from it passes all triangles. kNoHalfEdge for a point that is no
  /// vertex.
  HalfEdge start(std::size_t id) const { return starts_[id]; }

  /// Counts the vertices that have triangles. Returns false if the caller wants to cancel.
  bool countVertices(Ticker& ticker, std::size_t& count) const;

  Point centre(std::size_t triangle) const { return centres_[triangle]; }

  /// The triangle whose centre stands for that of this one: their difference is below what the
  /// coordinates resolve.
  std::size_t standIn(std::size_t triangle) const { return standIns_[triangle]; }

  Corners corners(std::size_t triangle) const
  {
    const HalfEdge h = static_cast<HalfEdge>(3 * triangle);
    return { point(origin(h)), point(origin(h + 1)), point(origin(h + 2)) };
  }

  /// The centre of a triangle that is known to lie inside the hull, with these bounds: one that is
  /// not finite becomes a corner of the triangle, one that rounding has put outside the bounds goes
  /// back to them.
  void settle(std::size_t triangle, const Bounds& bounds)
  {
    Point& centre = centres_[triangle];
    centre = within(bounds, isFinite(centre) ? centre : corners(triangle).a);
  }

private:
  bool computeCentres(Ticker& ticker);
  bool findStarts(Ticker& ticker);
  bool joinCentres(Ticker& ticker);
  bool joinTo(std::size_t triangle, Ticker& ticker);
  bool areOne(std::size_t a, std::size_t b) const;

  DelaunayView delaunay_;
  Buffer<Point> centres_;
  Buffer<std::uint32_t> standIns_;
  Buffer<HalfEdge> starts_;
  std::vector<std::uint32_t> stack_;
};

} // namespace ahd

#endif
