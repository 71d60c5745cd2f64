// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BoxBorder_h
#define ahd_BoxBorder_h

#include "CellBorder.h"
#include "ClipBox.h"

#include <algorithm>

namespace ahd
{

/// The bounding box of the vertices. REQUIRES: it has an area.
class BoxBorder : public CellBorder
{
public:
  BoxBorder(Diagram& diagram, const ClipBox& box)
    : CellBorder(diagram)
    , box_(box)
  {
    std::fill(corners_, corners_ + 4, kNoCorner);
  }

  bool build(Ticker& ticker) override
  {
    return noteInside(
      ticker, [&](std::size_t t) { return box_.contains(diagram_.centre(diagram_.standIn(t))); });
  }
  void follow(
    Index site, CornerId last, CornerId next, bool isOpen, std::vector<CornerId>& cell) override;

  /// What is left of the bisector of p and q, without ends of its own.
  ClippedEdge chord(const Point& p, const Point& q);

protected:
  ClippedEdge cut(HalfEdge h) override;

private:
  bool mayFollow(Index site, const Point& from, const Point& to) const;
  bool isAhead(HalfEdge h, const Point& p, const Point& q) const;
  CornerId crossing(const Point& p, const Point& q, CornerId end);
  CornerId cornerOfBox(unsigned k);

  const ClipBox box_;
  CornerId corners_[4];
};

} // namespace ahd

#endif
