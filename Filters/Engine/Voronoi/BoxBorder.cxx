// SPDX-License-Identifier: BSD-3-Clause
#include "BoxBorder.h"

namespace ahd
{

bool BoxBorder::build(Ticker& ticker)
{
  const auto isIt = [&](std::size_t t)
  {
    const Point centre = diagram_.centre(t);
    return box_.hasInside(centre) || box_.hasCentre(diagram_.corners(t), centre);
  };
  return noteInside(ticker, isIt) && settleInside(ticker);
}

/// Does the centre of h's triangle, which is not in the box, lie to the left of h, as seen from the
/// middle between p and q, the ends of h?
bool BoxBorder::isAhead(HalfEdge h, const Point& p, const Point& q) const
{
  return acuteness(p, diagram_.point(diagram_.origin(previousInTriangle(h))), q) > 0;
}

ClippedEdge BoxBorder::cut(HalfEdge h)
{
  const HalfEdge twin = diagram_.twin(h);
  const Point p = diagram_.point(diagram_.origin(h));
  const Point q = diagram_.point(diagram_.target(h));
  const bool comesFromInside = twin != kNoHalfEdge && isInside(twin / 3);
  if (comesFromInside)
  {
    const CornerId from = centre(twin / 3);
    const unsigned exit = box_.exitOf(p, q);
    return { from, cornerAt(exit, p, q, from), kNoStretch, stretch(exit) };
  }
  if (isInside(h / 3))
  {
    const CornerId to = centre(h / 3);
    const unsigned entry = box_.exitOf(q, p);
    return { cornerAt(entry, p, q, to), to, stretch(entry), kNoStretch };
  }
  // Both ends outside: the middle, which is inside, lies between them, or the edge is outside.
  const bool comesFromBehind = twin == kNoHalfEdge || isAhead(twin, q, p);
  return comesFromBehind && isAhead(h, p, q) ? chord(p, q) : ClippedEdge{};
}

ClippedEdge BoxBorder::chord(const Point& p, const Point& q)
{
  const unsigned entry = box_.exitOf(q, p), exit = box_.exitOf(p, q);
  const CornerId from = cornerAt(entry, p, q, kNoCorner);
  return { from, cornerAt(exit, p, q, from), stretch(entry), stretch(exit) };
}

/// The corner where the bisector of p and q meets that stretch. `end`: the other end of what is
/// left of it, or none.
CornerId BoxBorder::cornerAt(unsigned at, const Point& p, const Point& q, CornerId end)
{
  const unsigned k = at / 2;
  if (at % 2 == 0)
  {
    return cornerOfBox(k);
  }
  const Point where = bisectorOnLine(p, q, box_.side(k));
  for (const unsigned near : { k, (k + 1) % 4 })
  {
    if (where == box_.corner(near))
    {
      return cornerOfBox(near);
    }
  }
  return end != kNoCorner && corner(end) == where ? end : add(where);
}

CornerId BoxBorder::cornerOfBox(unsigned k)
{
  if (corners_[k] == kNoCorner)
  {
    corners_[k] = add(box_.corner(k));
  }
  return corners_[k];
}

/// No cell has the whole border, as every vertex has a part of the box: so on one side nothing is
/// passed, whichever end comes first once they are rounded.
void BoxBorder::follow(Index, const Gap& gap, bool, std::vector<CornerId>& cell)
{
  if (gap.exit == gap.entry)
  {
    return;
  }
  for (unsigned at = (gap.exit + 1u) % 8; at != gap.entry; at = (at + 1) % 8)
  {
    if (at % 2 == 0)
    {
      addTo(cell, cornerOfBox(at / 2));
    }
  }
}

} // namespace ahd
