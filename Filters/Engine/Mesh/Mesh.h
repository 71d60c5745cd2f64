// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Mesh_h
#define ahd_Mesh_h

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Triangles and their neighbours: topology only, no coordinates.
///
/// The plane is closed by one vertex at infinity, the ghost. Every hull edge has a ghost triangle
/// on its outer side, so that every triangle has three neighbours and a point outside the hull is
/// inserted like any other. n vertices and the ghost make 2n - 2 triangles.
///
/// A triangle fills one slot of eight numbers, 32 bytes, half a cache line:
///
///     v0 v1 v2 -   n0 n1 n2 -
///
/// The dashes have no meaning in the mesh: an insertion keeps notes there.
///
/// A half-edge is named by 8 * slot + e, e in {0, 1, 2}: the edge of that triangle opposite to
/// corner e. Its apex (that corner) stands at its own name, its twin (the same edge seen from the
/// neighbour) four places on, so both are one load away. Corners are counterclockwise:
///
///              v[e]                 half-edge e runs from v[e+1] to v[e+2]
///              /  \                 (indices modulo 3), its triangle on its left
///             /    \                .
///       v[e+1] ---> v[e+2]
///
/// A slot is named by its first half-edge, a multiple of 8.
class Mesh
{
public:
  using Halfedge = std::uint32_t;
  using Slot = std::uint32_t;
  using Vertex = std::uint32_t;

  static constexpr std::uint32_t kSlotSize = 8;
  static constexpr std::uint32_t kTwin = 4; ///< from a half-edge to the place of its twin

  /// The slot a half-edge belongs to.
  static constexpr Slot slotOf(Halfedge h) { return h & ~7u; }
  /// The half-edges after and before h in its triangle. By table: a branch on the edge's number
  /// would be unpredictable, and cost more than all else in the kernel.
  static Halfedge next(Halfedge h) { return h + kToNext[h & 3u]; }
  static Halfedge previous(Halfedge h) { return h + kToPrevious[h & 3u]; }

  /// Bytes that the triangulation of so many points needs.
  static constexpr std::size_t bytesFor(std::size_t vertexCount)
  {
    return vertexCount < 2 ? 0 : (2 * vertexCount - 2) * kSlotSize * sizeof(std::uint32_t);
  }

  /// Empties the mesh, for `vertexCount` points; vertex `vertexCount` is the ghost. The triangles
  /// will lie in `memory`, which stays the caller's.
  /// @pre 3 <= vertexCount <= kMaximumPoints; bytesFor(vertexCount) bytes, aligned to 64.
  void begin(std::uint32_t vertexCount, void* memory);

  /// Only so many of the vertices will be inserted. @pre no more than there are.
  void limitTo(std::uint32_t insertions) { insertions_ = insertions; }

  /// Fills the first four slots: triangle a, b, c (counterclockwise) and its three ghosts.
  void makeFirstTriangle(Vertex a, Vertex b, Vertex c);

  /// The raw slots, for the kernel.
  std::uint32_t* data() { return data_; }
  const std::uint32_t* data() const { return data_; }

  Vertex ghost() const { return ghost_; }

  /// The slot of the k-th triangle. An insertion reuses the slots of the triangles it removes and
  /// takes two more: vertex after vertex, the i-th one inserted (from 0; the first three make four
  /// triangles) those of triangles 2 i - 2 and 2 i - 1.
  static constexpr Slot slotOfTriangle(std::size_t k) { return static_cast<Slot>(k * kSlotSize); }
  static constexpr Slot freshSlots(std::size_t i) { return slotOfTriangle(2 * i - 2); }

  /// One past the last slot in use, once all vertices (up to the limit) are inserted.
  Slot end() const { return freshSlots(insertions_); }

private:
  // Modulo 2^32: -2 and -1 wrap round.
  static constexpr std::uint32_t kToNext[4] = { 1u, 1u, 0u - 2u, 0u };
  static constexpr std::uint32_t kToPrevious[4] = { 2u, 0u - 1u, 0u - 1u, 0u };

  void link(Halfedge a, Halfedge b)
  {
    data_[a + kTwin] = b;
    data_[b + kTwin] = a;
  }

  std::uint32_t* data_ = nullptr;
  Vertex ghost_ = 0;
  std::uint32_t insertions_ = 0;
};

} // namespace ahd

#endif
