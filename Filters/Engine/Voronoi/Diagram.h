// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Diagram_h
#define ahd_Diagram_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Triangulation/Tables.h"
#include "Circumcentre.h"
#include "ConvexPolygon.h"

#include <vector>

namespace ahd
{

/// The circumcentres of a Delaunay triangulation, and its topology as the Voronoi diagram needs it.
/// Edges of the hull, the duals of which are the rays of the diagram, have one half-edge.
class Diagram
{
public:
  /// Borrows both. `bounds`: of the vertices. `areModest`: isModest() of all of them. @pre
  /// corners and neighbours.
  Diagram(const Tables& tables, const Point* places, const Bounds& bounds, bool areModest)
    : tables_(tables)
    , places_(places)
    , bounds_(bounds)
    , areModest_(areModest)
  {
  }

  /// Computes the centres. Returns false if cancelled; throws std::bad_alloc.
  bool build(Ticker& ticker) { return this->computeCentres(ticker) && this->joinCentres(ticker); }

  const Bounds& bounds() const { return bounds_; }

  std::size_t triangles() const { return tables_.triangles(); }
  Index origin(HalfEdge h) const { return tables_.origin(h); }
  Index target(HalfEdge h) const { return tables_.target(h); }
  HalfEdge twin(HalfEdge h) const { return tables_.twins[h]; }
  HalfEdge start(Index vertex) const { return tables_.starts[vertex]; }
  Point point(Index vertex) const { return places_[vertex]; }

  Point centre(std::size_t triangle) const { return centres_[triangle]; }

  /// The triangle whose centre stands for that of this one: their difference is below what the
  /// coordinates resolve.
  std::size_t standIn(std::size_t triangle) const { return standIns_[triangle]; }

  /// Does any centre stand for another triangle's?
  bool hasJoined() const { return hasJoined_; }

  Corners corners(std::size_t triangle) const
  {
    const HalfEdge h = static_cast<HalfEdge>(3 * triangle);
    return { point(origin(h)), point(origin(h + 1)), point(origin(h + 2)) };
  }

  /// The centre of the triangle stands for one that lies within these bounds: it moves there if it
  /// is outside, which is due to rounding.
  void settle(std::size_t triangle, const Bounds& bounds)
  {
    centres_[triangle] = within(bounds, centres_[triangle]);
  }

  /// standIn() will not be called again.
  void forgetStandIns() { standIns_.reset(); }

private:
  bool computeCentres(Ticker& ticker);
  bool joinCentres(Ticker& ticker);
  bool joinTo(std::uint32_t triangle, Ticker& ticker);
  bool mayJoin(std::size_t triangle, double size) const;
  bool areOne(std::size_t a, std::size_t b) const;

  const Tables& tables_;
  const Point* places_;
  const Bounds bounds_;
  const bool areModest_;
  Buffer<Point> centres_;
  Buffer<std::uint32_t> standIns_;
  bool hasJoined_ = false;
  std::vector<std::uint32_t> stack_;
};

} // namespace ahd

#endif
