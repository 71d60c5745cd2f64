// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Domain_h
#define ahd_Domain_h

#include "../Core/AskedMemory.h"
#include "../Living/LivingMesh.h"
#include "Refine.h"

#include <vector>

namespace ahd
{

/// The mesh under refinement: vertices in a frame of four far ones, segments, what is inside.
///
/// Vertex v of the triangulation is vertex v + kFirst; Steiner points follow. All numbers are
/// functions of the set of points and the segments, as those of the triangulation are.
class Domain
{
public:
  using Vertex = LivingMesh::Vertex;
  using Halfedge = LivingMesh::Halfedge;
  using Slot = LivingMesh::Slot;

  static constexpr Vertex kFirst = 1; ///< after the ghost
  static constexpr Vertex kFrame = 4;

  /// An edge of the input.
  struct Segment
  {
    Vertex a, b;                      ///< its ends, in lexicographic order of their places
    HalfEdge at;                      ///< in the triangulation, from a to b or from b to a
    bool isLeftInside, isRightInside; ///< seen from a

    bool isBorder() const { return isLeftInside != isRightInside; }
  };
  /// What a Steiner point lies on.
  struct Origin
  {
    Index segment;        ///< kNoIndex for none
    double fraction;      ///< of it
    std::size_t triangle; ///< of the triangulation
  };

  /// @pre makeNeighbors(); the triangulation has a triangle
  Domain(const Triangulation& made, const double* sizes, Ticker& ticker);

  /// Returns false if cancelled. Throws std::bad_alloc.
  bool load();

  const Triangulation& made() const { return made_; }
  const LivingMesh& mesh() const { return mesh_; }
  double width() const { return width_; }
  bool isInside(Slot s) const { return inside_[s / Mesh::kSlotSize] != 0; }
  const Point& place(Vertex v) const { return mesh_.place(v); }
  bool isLess(Vertex a, Vertex b) const { return lexicographicallyLess(place(a), place(b)); }

  const std::vector<Segment>& segments() const { return segments_; }
  Vertex firstSteiner() const { return firstSteiner_; }
  bool isSteiner(Vertex v) const { return v >= firstSteiner_; }
  const std::vector<Origin>& origins() const { return origins_; }
  const Origin& originOf(Vertex steiner) const { return origins_[steiner - firstSteiner_]; }
  /// The segment that a constraint edge is a piece of.
  Index segmentOf(Vertex p, Vertex q) const;
  double fractionOf(Vertex v, Index segment) const;
  /// What is wished at the vertex; 0 for any.
  double sizeOf(Vertex v) const { return sizes_.empty() ? 0.0 : sizes_[v]; }
  bool hasSizes() const { return !sizes_.empty(); }
  /// Three corners and their weights at a place of the triangle.
  SteinerPoint weighted(const Point& place, std::size_t triangle) const;

  /// Splits a piece at this place, which is at this fraction of its segment.
  /// @return the new vertex; the changed triangles are mesh().star()
  Vertex split(Halfedge h, const Point& place, double fraction);
  void look(const Point& place, const LivingMesh::Spot& spot) { mesh_.look(place, spot); }
  /// Inserts a vertex inside, where look() was called; `near`: a vertex close to it.
  Vertex insertSeen(const Point& place, const LivingMesh::Spot& spot, Vertex near);

private:
  void makeRoom();
  bool addVertices();
  bool findSegments();
  bool constrainAll();
  bool fill();
  void addFrame();
  Vertex endOf(HalfEdge h, bool isTarget) const;
  std::size_t triangleNear(Vertex v) const;
  void setSize(Vertex v, const SteinerPoint& weights);
  static std::size_t bytesFor(std::size_t vertices);

  const Triangulation& made_;
  const double* given_; ///< sizes by point
  Ticker& ticker_;
  TakenMemory memory_;
  std::size_t room_ = 0; ///< for vertices
  double width_ = 0.0;
  LivingMesh mesh_;
  std::vector<unsigned char> inside_; ///< by slot
  std::vector<Segment> segments_;     ///< in order of (a, b)
  Vertex firstSteiner_ = 0;
  std::vector<Origin> origins_;
  std::vector<double> sizes_; ///< by vertex
};

} // namespace ahd

#endif
