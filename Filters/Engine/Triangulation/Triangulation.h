// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Triangulation_h
#define ahd_Triangulation_h

#include "../Constraints.h"
#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ahd
{

/// A half-edge is named by 3 * triangle + e, e in {0, 1, 2}: the edge of that triangle from its
/// corner e to the next one counterclockwise, the triangle on its left.
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

class Ticker;

/// The position of a place in a triangulation.
struct Location
{
  enum Kind
  {
    InTriangle, ///< inside of triangle halfEdge / 3, whose first half-edge it is
    OnEdge,     ///< between the ends of halfEdge, of the edge's two the smaller
    OnVertex,   ///< at the vertex whose start() halfEdge is
    Outside,    ///< outside of the convex hull, to the right of halfEdge, which has no twin
    Nowhere     ///< the place is not finite, or there are no triangles
  };
  Kind kind = Nowhere;
  HalfEdge halfEdge = kNoHalfEdge;
};

/// A (constrained) Delaunay triangulation, made by ahd::triangulate() and ahd::constrain()
/// (Triangulate.h), for queries and output.
///
/// - Immutable and canonical: vertices are numbered by rank along a Hilbert curve, triangles are in
///   canonical order, each from its lowest vertex. All numbers are functions of the point set
///   alone, and neighbours are close in memory.
/// - Triangles dropped by loops or trim() stay, flagged; outputs and report().triangles have the
///   kept ones.
/// - Tables cost memory and are made by make...() on demand. These and write...() may be called by
///   one thread at a time, return Ok, Cancelled or OutOfMemory, and may be called again after any
///   outcome. const functions only read, on any number of threads at once, and name the table they
///   need.
/// - Borrows its points: they must outlive it, unchanged. Movable, not copyable. A default one has
///   no points.
class Triangulation
{
public:
  Triangulation();
  ~Triangulation();
  Triangulation(Triangulation&&) noexcept;
  Triangulation& operator=(Triangulation&&) noexcept;

  // --- Known without a table ---

  const Report& report() const;
  /// The outcome of the constraints; empty without constrain().
  const ConstraintReport& constraints() const;
  /// The points, as they were given.
  const PointView& points() const;
  /// Distinct finite points, those beyond the limit included: vertices are numbered 0 to this - 1.
  std::size_t vertexCount() const;
  /// The id of the point that represents the vertex (see Options::representative).
  Index pointOf(Index vertex) const;
  /// The undivided boxes of the grid in the order in which they are visited, empty ones included.
  /// Empty without Options::keepBoxes, with InsertionOrder::AsGiven and without points.
  const std::vector<GridBox>& boxes() const;

  // --- Written out ---

  /// report().triangles triples of point ids: the kept triangles, in canonical order. Id: 32 or 64
  /// bits; 32 always fit (kMaximumPoints).
  template <typename Id>
  Status writeTriangles(Id* triples, const Context& context);
  /// The status of each point (Result.h): points().count numbers.
  template <typename Id>
  Status writePointStatus(Id* status, const Context& context);
  /// Point ids in the order of insertion by one thread: report().inserted numbers.
  ///
  /// @pre Options::keepOrder
  template <typename Id>
  Status writeOrder(Id* ids, const Context& context);
  /// Each point's position in the insertion order, from 0, points beyond the limit included;
  /// kRankNone for points outside the order. points().count numbers.
  ///
  /// @pre Options::keepOrder
  template <typename Id>
  Status writeInsertionRanks(Id* ranks, const Context& context);

  // --- Tables ---

  /// The place of each triangle in the canonical order: 8 bytes a point. Optional; called before
  /// writeTriangles() by callers that will need neighbours, regions or constraint edges, it sorts
  /// the triangles once, not twice.
  Status makeNumbers(const Context& context);
  /// Corners, constraint edges, which triangles are kept: 24 bytes a point, 10 more with
  /// constraints; 16 more where the vertices' places have to be read again.
  Status makeCorners(const Context& context);
  /// The same before makeNeighbors(): with the numbers, which that needs, so that triangles are
  /// sorted once, not twice.
  Status makeNumbersAndCorners(const Context& context);
  /// Neighbours, and a half-edge from each vertex: 36 bytes a point. Makes the corners too.
  Status makeNeighbors(const Context& context);
  /// The vertex of each point: 4 bytes a point.
  Status makePointMap(const Context& context);

  // --- Queries that need makeCorners() ---

  /// All triangles, dropped ones included.
  std::size_t triangleCount() const;
  /// Is the triangle part of the result? Not if loops or trim() drop it.
  bool isKept(std::size_t triangle) const;
  /// The vertex where the half-edge begins, and where it ends.
  Index origin(HalfEdge h) const;
  Index target(HalfEdge h) const { return origin(nextInTriangle(h)); }
  /// Is the edge a constraint?
  bool isConstrained(HalfEdge h) const;
  /// Where a vertex lies.
  Point at(Index vertex) const;

  // --- Queries that need makeNeighbors() ---

  /// The same edge seen from the other side; kNoHalfEdge on the convex hull.
  HalfEdge twin(HalfEdge h) const;
  /// A half-edge that begins at the vertex: that of the hull if it lies on the hull, so that
  /// turning counterclockwise from it passes all triangles. kNoHalfEdge if it is in none.
  HalfEdge start(Index vertex) const;
  /// The next half-edge from the same vertex counterclockwise; kNoHalfEdge past the hull.
  HalfEdge nextAround(HalfEdge h) const { return twin(previousInTriangle(h)); }
  /// The exact position of a place. `hint`: a triangle to start from, the closer the faster. Cost:
  /// the triangles between the two, about the square root of their number.
  Location locate(const Point& place, std::size_t hint = 0) const;
  /// The same, with its steps counted; Nowhere if cancelled.
  Location locate(const Point& place, std::size_t hint, Ticker& ticker) const;

  // --- Queries that need makePointMap() ---

  /// The vertex at the point's place, which a duplicate shares; kNoIndex if it has none: not
  /// finite, left out, or beyond the limit.
  Index vertexOf(std::size_t point) const;

private:
  friend class TriangulationAccess; // for the functions that make it
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace ahd

#endif
