// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Path_h
#define ahd_Path_h

#include "../Core/AskedMemory.h"
#include "Triangulation.h"

#include <unordered_map>
#include <vector>

namespace ahd
{

/// What segments meet in a triangulation: edges that they cross, vertices that they pass. All
/// decisions are exact. Looks at all triangles, dropped ones included, and ends at the convex hull.
///
/// Features: a segment may begin and end anywhere. The edges around vertices with many neighbours
/// are listed when they are first passed, and searched by halving.
/// Caveat: entering from outside costs the hull edges that face the begin, on one side of the way.
///
/// Example:
///
///     SegmentPath path(surface, ticker);
///     if (path.find(a, b, path.triangle())) for (const SegmentPath::Met& met : path.met()) ...
class SegmentPath
{
public:
  struct Met
  {
    HalfEdge halfEdge; ///< of the crossed edge, the first one met; or it begins at the vertex
    bool isVertex;
  };

  /// @pre makeNeighbors(). Both must outlive this.
  SegmentPath(const Triangulation& surface, Ticker& ticker)
    : surface_(surface)
    , ticker_(ticker)
    , taken_(ticker)
  {
  }

  /// Finds what the segment meets between its ends; edges along it or through its ends are not
  /// crossed. `hint`: a triangle near its begin. Returns false if cancelled. Throws std::bad_alloc.
  /// @pre finite, different ends
  bool find(const Point& from, const Point& to, std::size_t hint);

  /// In the order from one end to the other.
  const std::vector<Met>& met() const { return met_; }
  /// A triangle at the end, or near it.
  std::size_t triangle() const { return hint_; }

private:
  void begin(const Location& at);
  void enter(HalfEdge hull);
  void fromEdge(HalfEdge h);
  void fromTriangle(HalfEdge first);
  void pass(HalfEdge entered);
  void passVertex(HalfEdge first);
  bool turn(HalfEdge out);
  HalfEdge findAround(HalfEdge first);
  void leave(HalfEdge h);
  void reach(Index vertex);
  HalfEdge previousOnHull(HalfEdge h) const;

  int side(Index vertex) const;
  bool isBeyond(HalfEdge h, const Point& place) const;
  bool isAhead(Index vertex) const;

  const Triangulation& surface_;
  Ticker& ticker_;
  std::size_t hint_ = 0; ///< a triangle
  Point from_ = {}, to_ = {};
  std::vector<Met> met_;
  // Where it is; neither: at the end.
  HalfEdge entered_ = kNoHalfEdge; ///< in the triangle to its left
  HalfEdge around_ = kNoHalfEdge;  ///< at the vertex where it begins, looking for the way out
  /// Counterclockwise from start(), of vertices with many neighbours.
  std::unordered_map<Index, std::vector<HalfEdge>> fans_;
  TakenMemory taken_; ///< for these
  std::size_t inFans_ = 0;
};

} // namespace ahd

#endif
