// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PolygonFiller_h
#define ahd_PolygonFiller_h

#include "../Core/Progress.h"
#include "../Mesh/Mesh.h"
#include "../Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// The Delaunay triangulation of the inside of a polygon: no vertex is added, and only what can be
/// seen inside the polygon counts. Few corners: ears are cut off, one corner after the other. Many:
/// they are inserted in random order, in expected time nearly linear (J. R. Shewchuk, B. C. Brown,
/// "Fast segment insertion and incremental construction of constrained Delaunay triangulations",
/// 2015). Either gives some triangulation, which edge flips make Delaunay.
///
/// Why either is right however the corners lie: all triangles are counterclockwise and fill a disk
/// whose border runs once along the polygon, so they cover each place inside exactly once.
class PolygonFiller
{
public:
  PolygonFiller(std::uint32_t* meshData, const Point* xy, Ticker& ticker)
    : data_(meshData)
    , xy_(xy)
    , ticker_(ticker)
  {
  }

  /// Fills the polygon with corners[0], corners[1], ... counterclockwise, in the slots given: two
  /// fewer than corners. The half-edge along the polygon's edge p, from corner p to the next, is
  /// then inner(p); it has no twin yet. Returns false if cancelled. Throws
  /// std::bad_alloc.
  ///
  /// @pre three corners or more. The polygon lies on the left of its base, the edge from the
  /// last corner to the first; each corner can be seen from a place on the base, and these places
  /// follow each other. A vertex may be several corners, where edges hang into the polygon.
  bool fill(const std::vector<Index>& corners, const Mesh::Slot* slots);

  Mesh::Halfedge inner(std::size_t p) const { return inner_[p]; }

private:
  /// The other side of an edge: a half-edge, or the border of the polygon. No half-edge
  /// ends in seven.
  using Side = std::uint32_t;
  static constexpr Side border(std::size_t p) { return static_cast<Side>(p * 8 + 7); }
  static constexpr bool isBorder(Side side) { return (side & 7u) == 7u; }

  /// An edge of the hole around a corner that is being inserted, and what lies behind it.
  struct HoleEdge
  {
    Index from, to;
    Side side;
  };

  void attach(Mesh::Halfedge h, Side side);
  Mesh::Slot place(Index a, Index b, Index c);
  bool cutEars();
  bool insertAll();
  bool makeRing();
  bool chooseOrder();
  bool insert(std::uint32_t corner);
  bool belongsToHole(const HoleEdge& edge, Index vertex) const;
  bool makeDelaunay();
  void flip(Mesh::Halfedge h);
  int orientation(Index a, Index b, Index c) const;
  std::uint32_t random(std::uint32_t below);

  std::uint32_t* data_;
  const Point* xy_;
  Ticker& ticker_;
  const std::vector<Index>* corners_ = nullptr;
  bool cancelled_ = false;
  std::uint64_t random_ = 1;
  std::vector<Mesh::Halfedge> inner_;
  std::vector<Mesh::Slot> free_;
  std::vector<std::uint32_t> stack_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t> next_, previous_, order_;
  std::vector<double> distance_;
  std::vector<HoleEdge> hole_;
  std::vector<Mesh::Halfedge> suspects_;
};

} // namespace ahd

#endif
