// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConvexBorder_h
#define ahd_ConvexBorder_h

#include "CellBorder.h"
#include "ConvexPolygon.h"

#include <unordered_map>
#include <vector>

namespace ahd
{

/// A convex polygon: the bounding box of the vertices, or one of the caller's own, which vertices
/// may lie inside of, on or beyond.
///
/// What counts is the part of the diagram within the inside of the polygon: a centre on the border
/// is the end of each edge that leads inside from there, as a crossing is. So edges along a side or
/// through a corner alone are none, and a cell has corners only if it has an area inside. Stretches
/// of the border are those of ConvexPolygon.
class ConvexBorder : public CellBorder
{
public:
  /// Borrows both. @pre the polygon has no fault.
  ConvexBorder(Diagram& diagram, const ConvexPolygon& polygon)
    : CellBorder(diagram)
    , polygon_(polygon)
    , corners_(polygon.size(), kNoCorner)
  {
  }

  bool build(Ticker& ticker) override;
  void follow(Index site, const Gap& gap, bool isOpen, std::vector<CornerId>& cell) override;
  void fill(Index site, std::vector<CornerId>& cell) override;

  /// The part inside of the bisector of p and q, without ends of its own.
  ClippedEdge chord(const Point& p, const Point& q);

protected:
  ClippedEdge cut(HalfEdge h) override;
  void forgetOwn() override { std::unordered_map<std::size_t, CornerId>().swap(onBorder_); }

private:
  int sideOf(std::size_t k, std::size_t triangle) const
  {
    return polygon_.sideOf(k, diagram_.corners(triangle), diagram_.centre(triangle));
  }
  bool areBeyondOneSide(std::size_t a, std::size_t b) const;
  CornerId cornerAt(Stretch at, std::size_t triangle, const Line& ends, CornerId other);
  CornerId cornerOfPolygon(std::size_t k);

  const ConvexPolygon& polygon_;
  std::vector<CornerId> corners_;                      ///< those of the polygon
  std::unordered_map<std::size_t, CornerId> onBorder_; ///< centres, by what stands for them
};

} // namespace ahd

#endif
