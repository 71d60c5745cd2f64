// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HullBorder_h
#define ahd_HullBorder_h

#include "CellBorder.h"

namespace ahd
{

/// The convex hull of the vertices.
///
/// Beyond the line through an edge of the hull, the diagram is a forest. The tree that has the
/// edge's own ray crosses the edge itself, between its ends, and nothing else does; and the trees
/// of different edges have no triangle in common, as the cell of each hull vertex lies between
/// those of the edges at either side. So each centre outside belongs to one edge of the hull, all
/// of them are found from the hull inwards, and the work is linear however far away the centres
/// lie. All of the border is one stretch: a cell has nothing of it but its own vertex.
class HullBorder : public CellBorder
{
public:
  using CellBorder::CellBorder;

  bool build(Ticker& ticker) override;
  void follow(Index site, const Gap& gap, bool isOpen, std::vector<CornerId>& cell) override;

protected:
  ClippedEdge cut(HalfEdge h) override;
  void forgetOwn() override { beyond_.reset(); }

private:
  /// The edge of the hull that the triangle's centre lies beyond; kNoHalfEdge if it is inside.
  HalfEdge beyond(std::size_t triangle) const
  {
    return isInside(triangle) ? kNoHalfEdge : beyond_[triangle];
  }
  bool findHullEdge(HalfEdge& found, Ticker& ticker) const;
  bool findBeyond(HalfEdge hullEdge, Ticker& ticker);
  int side(std::size_t triangle, HalfEdge hullEdge) const;
  CornerId crossing(HalfEdge h, HalfEdge hullEdge, std::size_t insideTriangle);

  Buffer<HalfEdge> beyond_; ///< of each triangle whose centre is outside
  std::vector<std::uint32_t> stack_;
};

} // namespace ahd

#endif
