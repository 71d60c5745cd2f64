// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_LivingMesh_h
#define ahd_LivingMesh_h

#include "../Mesh/Mesh.h"
#include "../Points/Points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ahd
{

/// A constrained Delaunay triangulation that changes: vertices come and go, segments become edges.
///
/// - Exact and canonical: after any history it is the triangulation that triangulate() and
///   constrain() make of its vertices and constraints, ties included.
/// - Half-edges are named as in Mesh, and a ghost closes the plane; its number is 0.
/// - It chooses points; it is not put out. triangulate() makes the output from the points chosen.
///
/// Memory is that of reserve(). Slots and numbers of removed vertices are used again, the last one
/// first.
class LivingMesh
{
public:
  using Halfedge = Mesh::Halfedge;
  using Slot = Mesh::Slot;
  using Vertex = Mesh::Vertex;
  using Edge = std::pair<Vertex, Vertex>;

  static constexpr Vertex kGhost = 0;

  /// Where a place lies.
  enum class Kind
  {
    Inside,   ///< in the triangle of `at`
    OnEdge,   ///< on the half-edge `at` of a triangle that is no ghost
    AtVertex, ///< at the apex of `at`
    Outside   ///< beyond the hull; `at` is a ghost triangle in conflict with it
  };
  struct Spot
  {
    Kind kind;
    Halfedge at;
  };

  LivingMesh() { clear(); }

  void clear();
  /// Makes room for so many vertices, the ghost excepted. Throws std::bad_alloc.
  void reserve(std::size_t vertexCount);
  /// The bytes that takes.
  static constexpr std::size_t bytesFor(std::size_t vertexCount)
  {
    return (vertexCount + 1) * (sizeof(Point) + 2 * sizeof(Index)) +
      Mesh::bytesFor(vertexCount + 2);
  }

  /// Begins with one triangle. The vertices are 1, 2, 3.
  /// @pre empty; the places are not collinear
  void begin(const Point& a, const Point& b, const Point& c);
  /// Begins with a Triangulation, or what answers like one: its vertex v is v + 1, constraints are
  /// not read. Throws std::bad_alloc. Returns false where goesOn() does, which it asks once for
  /// each vertex and triangle. @pre empty; it has triangles, none dropped, and neighbors; those of
  /// a constrained one need their constraints before anything else changes
  template <typename Made, typename GoesOn>
  bool begin(const Made& made, const GoesOn& goesOn);

  std::size_t vertexCount() const { return places_.size() - 1; }
  const Point& place(Vertex v) const { return places_[v]; }

  /// One past the last slot.
  Slot end() const { return static_cast<Slot>(data_.size()); }
  bool isUsed(Slot s) const { return data_[s] != kNoIndex; }
  bool isGhost(Slot s) const
  {
    return data_[s] == kGhost || data_[s + 1] == kGhost || data_[s + 2] == kGhost;
  }
  Vertex apex(Halfedge h) const { return data_[h]; }
  Halfedge twin(Halfedge h) const { return data_[h + Mesh::kTwin]; }
  Vertex origin(Halfedge h) const { return data_[Mesh::next(h)]; }
  Vertex target(Halfedge h) const { return data_[Mesh::previous(h)]; }
  bool isConstraint(Halfedge h) const
  {
    return (data_[Mesh::slotOf(h) + kFlags] >> (h & 3) & 1) != 0;
  }
  /// A half-edge that leaves the vertex; kNoIndex for one in no triangle.
  Halfedge leaving(Vertex v) const;
  /// The next one around its origin, counterclockwise.
  Halfedge around(Halfedge h) const { return twin(Mesh::previous(h)); }
  /// The half-edge from a to b, or kNoIndex.
  Halfedge edge(Vertex a, Vertex b) const;

  /// Finds the place by a walk from a triangle in use. Several threads may, at the same time.
  Spot locate(const Point& p, Slot hint) const;

  /// Inserts a vertex; a constraint that it lies on is split.
  /// @pre the spot is that of the place, and no vertex
  /// @return its number
  Vertex insert(const Point& p, const Spot& spot);
  /// The slots whose triangles the last insertion replaced, which are in use again;
  const std::vector<Slot>& replaced() const { return cavity_; }
  /// and those of the triangles that it made, all around the new vertex. After split(): of those
  /// that it changed, some of them twice.
  const std::vector<Slot>& star() const { return star_; }

  /// insert() in two steps. The first finds what the vertex would replace, and changes nothing;
  void look(const Point& p, const Spot& spot);
  /// then this calls f(half-edge) for each edge of its border, as seen from outside;
  template <typename F>
  void eachOfRim(F f) const
  {
    for (const RimEdge& edge : rim_)
    {
      f(edge.outside);
    }
  }
  /// and this inserts it. @pre nothing has changed since look() of the same place
  Vertex insertSeen(const Point& p, const Spot& spot);

  /// Splits an edge at a place that may lie beside it, as rounding has it; both halves are
  /// constraints if the edge was one. The slots of the two triangles stay on their sides of it, and
  /// each side gets one of the next two slots after the last: end() for that of h, end() +
  /// kSlotSize for that of its twin. @pre nothing was removed; the two triangles are no ghosts, and
  /// the four that the vertex makes of them counterclockwise
  /// @return its number
  Vertex split(Halfedge h, const Point& p);

  /// Makes the segment a row of edges from vertex to vertex on it. Returns false, with nothing
  /// changed, if it crosses a constraint. @pre a and b are different vertices
  bool constrain(Vertex a, Vertex b);
  /// The edges from vertex to vertex on the segment. @pre constrain(a, b)
  void findPieces(Vertex a, Vertex b, std::vector<Edge>& pieces) const;
  /// The edge is no constraint any more. @pre it is one
  void release(Vertex a, Vertex b);

  /// Is the vertex inside, and at no constraint edge? @pre it is in a triangle
  bool isRemovable(Vertex v) const;
  /// Removes a vertex. Returns false if the others are collinear: the triangles are as before,
  /// though not their slots. @pre it is at no constraint edge
  bool remove(Vertex v);

private:
  static constexpr std::uint32_t kFlags = 3;  ///< of a slot: a bit for each constraint edge,
  static constexpr std::uint32_t kMarked = 8; ///< and one for triangles of the cavity
  static constexpr std::uint32_t kEdges = 7;
  using Ring = std::vector<Vertex>;

  /// An edge of the cavity's rim.
  struct RimEdge
  {
    Vertex from, to;
    Halfedge outside;
    bool isConstraint;
  };
  /// A piece of a segment, and the edges that it crosses.
  struct Way
  {
    Vertex from, to;
    std::vector<Edge> crossed;
  };

  // LivingMesh.cxx
  class Sides;
  Slot newSlot();
  Vertex newVertex(const Point& p);
  void set(Slot s, Vertex a, Vertex b, Vertex c);
  void free(Slot s);
  void link(Halfedge a, Halfedge b)
  {
    data_[a + Mesh::kTwin] = b;
    data_[b + Mesh::kTwin] = a;
  }
  void setConstraint(Halfedge h, bool is);
  void join(Halfedge h, Halfedge outside, bool isConstraint)
  {
    link(h, outside);
    setConstraint(h, isConstraint);
  }
  int side(Vertex a, Vertex b, const Point& p) const;
  Halfedge flip(Halfedge h);
  bool canFlip(Halfedge h) const;
  void makeDelaunay(std::vector<Edge>& suspects, std::vector<Slot>* flipped = nullptr);

  // LivingInsert.cxx
  bool conflicts(Slot s, const Point& p) const;
  void mark(Slot s);
  void findCavity(const Point& p, const Spot& spot);
  void findRim(const Spot& spot);
  void makeStar(Vertex v, const Edge& split);

  // LivingSegments.cxx
  Way firstStep(Vertex from, Vertex to, Halfedge& crossed) const;
  bool findWay(Vertex from, Vertex to, std::vector<Way>& ways) const;
  bool isAhead(Vertex from, Vertex to, Vertex v) const;
  void makeEdge(const Way& way);

  // LivingRemove.cxx
  void findRing(Vertex v);
  bool canCutOff(Halfedge h) const;
  void flipAway(Vertex v, std::vector<Edge>& made);
  void joinThree(Vertex v, const Ring& ring);
  bool joinFour(Vertex v, const Ring& ring, std::vector<Edge>& made);
  void freeStar(Vertex v, const Ring& ring);
  std::size_t degreeOf(Vertex v) const;

  template <typename Made>
  void linkAs(const Made& made);

  // LivingHull.cxx
  void linkGhosts();
  bool removeFromHull(Vertex v, const Ring& ring);
  void bendHullIn(Vertex v, const Ring& ring);
  void joinOnHull(Vertex v, const Ring& ring);

  std::vector<Point> places_;       ///< by vertex; the ghost's is not used
  std::vector<Slot> slotOfVertex_;  ///< a slot with it as a corner, or kNoIndex
  std::vector<std::uint32_t> data_; ///< the slots
  std::vector<Slot> freeSlots_;
  std::vector<Vertex> freeVertices_;

  std::vector<Edge> suspects_; ///< scratch; empty between calls
  Ring ring_;                  ///< of the vertex that is removed
  // of the last insertion
  std::vector<Slot> cavity_, star_;
  std::vector<RimEdge> rim_;
  std::vector<Slot> starAt_; ///< by vertex: the triangle of the star whose rim edge leaves it
};

template <typename Made, typename GoesOn>
bool LivingMesh::begin(const Made& made, const GoesOn& goesOn)
{
  const std::size_t triangles = made.triangleCount();
  bool isOn = true;
  reserve(made.vertexCount());
  for (std::size_t v = 0; isOn && v < made.vertexCount(); ++v)
  {
    const Point p = made.at(static_cast<Index>(v));
    newVertex({ p.x + 0.0, p.y + 0.0 }); // 0.0 for -0.0
    isOn = goesOn();
  }
  for (std::size_t t = 0; isOn && t < triangles; ++t)
  {
    const Index h = static_cast<Index>(3 * t);
    set(newSlot(), made.origin(h) + 1, made.origin(h + 1) + 1, made.origin(h + 2) + 1);
    isOn = goesOn();
  }
  if (isOn)
  {
    linkAs(made);
  }
  return isOn;
}

template <typename Made>
void LivingMesh::linkAs(const Made& made)
{
  // its half-edge e of a triangle leaves corner e; here it is opposite to corner e + 2
  const auto named = [](Index h) { return h / 3 * Mesh::kSlotSize + (h + 2) % 3; };
  for (Index h = 0; h < 3 * made.triangleCount(); ++h)
  {
    const Index twin = made.twin(h);
    if (twin != kNoIndex && h < twin)
    {
      link(named(h), named(twin));
    }
    else if (twin == kNoIndex)
    {
      const Slot ghost = newSlot();
      const Vertex from = origin(named(h)), to = target(named(h));
      set(ghost, kGhost, to, from);
      link(ghost, named(h));
    }
  }
  linkGhosts();
}

} // namespace ahd

#endif
