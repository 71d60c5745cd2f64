// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstrainedMesh_h
#define ahd_ConstrainedMesh_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Mesh/Mesh.h"
#include "../Points/Points.h"

#include <cstdint>

namespace ahd
{

/// What the marks of a triangle say, one bit each.
enum : std::uint8_t
{
  kConstrainedEdges = 7, ///< bit e: edge e is a constraint; both triangles of an edge say so
  kDropped = 8,          ///< outside of what the loops enclose: not part of the result
  kVisited = 16,         ///< by a search that has not ended
  kInside = 32,          ///< found to lie inside by such a search
  kInCavity = 64         ///< about to be replaced
};

/// A triangulation, its vertices' locations, and flags of its triangles.
class ConstrainedMesh
{
public:
  /// No marks. Returns false if cancelled, as below; throws std::bad_alloc.
  /// @pre a mesh with a triangle; xy outlives this.
  bool begin(Mesh& mesh, const Point* xy, Ticker& ticker);
  /// Looks at every triangle once, so that a triangle of each vertex is known: functions that read
  /// it (isInMesh(), outgoing(), slotOf()) or change it (setCorners()) require this. Throws
  /// std::bad_alloc.
  bool findVertices(Ticker& ticker);

  std::uint32_t* data() { return data_; }
  const std::uint32_t* data() const { return data_; }
  const Point& at(Index vertex) const { return xy_[vertex]; }
  const Point* places() const { return xy_; }
  Index ghost() const { return ghost_; }
  std::size_t triangles() const { return marks_.size(); } ///< ghosts included

  /// Ends of a half-edge, and the corner opposite to it.
  Index origin(Mesh::Halfedge h) const { return data_[Mesh::next(h)]; }
  Index destination(Mesh::Halfedge h) const { return data_[Mesh::previous(h)]; }
  Index apex(Mesh::Halfedge h) const { return data_[h]; }
  Mesh::Halfedge twin(Mesh::Halfedge h) const { return data_[h + Mesh::kTwin]; }
  void link(Mesh::Halfedge a, Mesh::Halfedge b)
  {
    data_[a + Mesh::kTwin] = b;
    data_[b + Mesh::kTwin] = a;
  }

  bool isGhost(Mesh::Slot slot) const
  {
    return data_[slot] == ghost_ || data_[slot + 1] == ghost_ || data_[slot + 2] == ghost_;
  }

  /// Is the vertex a corner of any triangle?
  bool isInMesh(Index vertex) const { return slotOf_[vertex] != kNoIndex; }

  /// A half-edge that runs from the vertex. @pre isInMesh(vertex).
  Mesh::Halfedge outgoing(Index vertex) const { return outgoing(slotOf_[vertex], vertex); }
  /// That of a triangle which has the vertex as a corner.
  Mesh::Halfedge outgoing(Mesh::Slot slot, Index vertex) const
  {
    Mesh::Halfedge h = slot;
    while (data_[h] != vertex)
    {
      ++h;
    }
    return Mesh::previous(h);
  }
  /// The half-edge from the same vertex that follows counterclockwise.
  Mesh::Halfedge nextAround(Mesh::Halfedge h) const { return twin(Mesh::previous(h)); }
  /// And the one that follows clockwise.
  Mesh::Halfedge previousAround(Mesh::Halfedge h) const { return Mesh::next(twin(h)); }

  /// The slot now holds other corners than before.
  void setCorners(Mesh::Slot slot)
  {
    slotOf_[data_[slot]] = slot;
    slotOf_[data_[slot + 1]] = slot;
    slotOf_[data_[slot + 2]] = slot;
  }

  std::uint8_t& marks(Mesh::Halfedge h) { return marks_[h / Mesh::kSlotSize]; }
  std::uint8_t marks(Mesh::Halfedge h) const { return marks_[h / Mesh::kSlotSize]; }
  const std::uint8_t* allMarks() const { return marks_.data(); }

  bool isConstrained(Mesh::Halfedge h) const { return (marks(h) & 1u << (h & 3u)) != 0; }
  void constrain(Mesh::Halfedge h)
  {
    marks(h) = static_cast<std::uint8_t>(marks(h) | 1u << (h & 3u));
  }
  void release(Mesh::Halfedge h)
  {
    marks(h) = static_cast<std::uint8_t>(marks(h) & ~(1u << (h & 3u)));
  }

  /// The address of a vertex's entry, for prefetching.
  const void* placeOfSlot(Index vertex) const { return slotOf_.data() + vertex; }
  Mesh::Slot slotOf(Index vertex) const { return slotOf_[vertex]; }

  std::size_t bytes() const { return slotOf_.bytes() + marks_.bytes(); }

private:
  std::uint32_t* data_ = nullptr;
  const Point* xy_ = nullptr;
  Index ghost_ = 0;
  Buffer<Mesh::Slot> slotOf_; ///< a triangle that has the vertex as a corner; kNoIndex if none has
  Buffer<std::uint8_t> marks_;
};

} // namespace ahd

#endif
