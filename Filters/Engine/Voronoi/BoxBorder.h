// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BoxBorder_h
#define ahd_BoxBorder_h

#include "CellBorder.h"
#include "ClipBox.h"

#include <algorithm>

namespace ahd
{

/// The bounding box of the vertices. @pre it has an area.
///
/// A stretch of the border (CellBorder.h) is a corner of the box, 2 k, or what lies between the
/// ends of a side, 2 k + 1.
class BoxBorder : public CellBorder
{
public:
  BoxBorder(Diagram& diagram, const ClipBox& box)
    : CellBorder(diagram)
    , box_(box)
  {
    std::fill(corners_, corners_ + 4, kNoCorner);
  }

  bool build(Ticker& ticker) override;
  void follow(Index site, const Gap& gap, bool isOpen, std::vector<CornerId>& cell) override;

  /// The part inside of the bisector of p and q, without ends of its own.
  ClippedEdge chord(const Point& p, const Point& q);

protected:
  ClippedEdge cut(HalfEdge h) override;

private:
  bool isAhead(HalfEdge h, const Point& p, const Point& q) const;
  CornerId cornerAt(unsigned at, const Point& p, const Point& q, CornerId end);
  CornerId cornerOfBox(unsigned k);

  const ClipBox box_;
  CornerId corners_[4];
};

} // namespace ahd

#endif
