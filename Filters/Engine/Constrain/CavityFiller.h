// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CavityFiller_h
#define ahd_CavityFiller_h

#include "ConstrainedMesh.h"
#include "PolygonFiller.h"

#include <vector>

namespace ahd
{

/// Makes a segment an edge: the triangles it crosses are replaced by those of the two polygons on
/// its sides (M. V. Anglada, "An improved incremental algorithm for constructing restricted
/// Delaunay triangulations", 1997). Constraints stay.
class CavityFiller
{
public:
  CavityFiller(ConstrainedMesh& mesh, Ticker& ticker)
    : mesh_(mesh)
    , ticker_(ticker)
    , filler_(mesh.data(), mesh.places(), ticker)
  {
  }

  /// `crossed` are the edges that the segment crosses, as SegmentWalk gives them. Returns false if
  /// cancelled: the mesh is then unusable. Throws std::bad_alloc.
  bool fill(Index from, Index to, const Mesh::Halfedge* crossed, std::size_t count);

  /// The half-edge from -> to that was made. @pre fill() returned true.
  Mesh::Halfedge made() const { return made_; }

  /// The other edge of the two triangles takes the place of this one, in the same two slots.
  /// @pre it is no constraint, and they make a convex quadrilateral.
  void flip(Mesh::Halfedge h);

private:
  /// The polygon on one side, counterclockwise, its last edge along the segment; and for each of
  /// the other edges the half-edge of the triangle to remove, and where to link the new one.
  struct Side
  {
    std::vector<Index> corners;
    std::vector<Mesh::Halfedge> old;   ///< later: the new one
    std::vector<std::uint32_t> beyond; ///< the twin, or its place in `old` if removed as well
    std::vector<std::uint8_t> flags;

    void clear();
    void add(Index corner, Mesh::Halfedge edge);
  };
  enum : std::uint8_t
  {
    kConstrained = 1,
    kHanging = 2 ///< both triangles of the edge are removed: it hangs into the polygon
  };

  template <typename Visit>
  bool eachEdge(const Side& side, Visit visit);
  template <typename Visit>
  bool eachSlot(Visit visit);
  bool collect(Index from, Index to, const Mesh::Halfedge* crossed, std::size_t count);
  bool lookBeyond(Side& side);
  bool fillSide(Side& side, const Mesh::Slot* slots);
  bool join(Side& side);

  ConstrainedMesh& mesh_;
  Ticker& ticker_;
  PolygonFiller filler_;
  Side right_, left_;
  std::vector<Mesh::Slot> slots_;
  Mesh::Halfedge made_ = kNoIndex;
};

} // namespace ahd

#endif
