// SPDX-License-Identifier: BSD-3-Clause
#include "ConvexBorder.h"

namespace ahd
{

bool ConvexBorder::build(Ticker& ticker)
{
  const Bounds& bounds = polygon_.bounds();
  const auto placeOf = [&](std::size_t t)
  {
    const Point p = diagram_.centre(t);
    if (polygon_.isBoxAround(p))
    {
      return kInside;
    }
    const int beyond = (p.x < bounds.xmin ? 2 : 0) | (p.x > bounds.xmax ? 4 : 0) |
      (p.y < bounds.ymin ? 8 : 0) | (p.y > bounds.ymax ? 16 : 0);
    const bool isInside = beyond == 0 &&
      polygon_.sideBeyond(diagram_.corners(t), p) == ConvexPolygon::kNoSide;
    return static_cast<std::uint8_t>(isInside ? kInside : beyond);
  };
  return notePlaces(ticker, placeOf) && settleInside(bounds, ticker);
}

/// Is the edge from one centre to the other outside because both lie beyond one side, or on it?
/// @pre neither is inside.
bool ConvexBorder::areBeyondOneSide(std::size_t a, std::size_t b) const
{
  if ((sidesBeyond(a) & sidesBeyond(b)) != 0)
  {
    return true;
  }
  const auto isBeyondThatOf = [this](std::size_t other, std::size_t own)
  { return sideOf(polygon_.sideBeyond(diagram_.corners(own), diagram_.centre(own)), other) <= 0; };
  return isBeyondThatOf(b, a) || isBeyondThatOf(a, b);
}

/// A centre on the bisector, but not inside, lies at the entry or before it, or else at the exit or
/// behind it: the entry's side tells which.
ClippedEdge ConvexBorder::cut(HalfEdge h)
{
  const HalfEdge twin = diagram_.twin(h);
  const std::size_t right = twin == kNoHalfEdge ? kNoTriangle : twin / 3, left = h / 3;
  const Line ends{ diagram_.point(diagram_.origin(h)), diagram_.point(diagram_.target(h)) };
  ConvexPolygon::Crossing crossing;
  const bool comesFromInside = right != kNoTriangle && isInside(right), endsInside = isInside(left);
  const bool isOutside = right != kNoTriangle && !comesFromInside && !endsInside &&
    areBeyondOneSide(right, left);
  if (isOutside || !polygon_.isCrossed(ends.from, ends.to, crossing))
  {
    return {};
  }
  const auto isBefore = [&](std::size_t t) { return sideOf(crossing.entry / 2, t) <= 0; };
  const bool comesFromBefore = right == kNoTriangle || (!comesFromInside && isBefore(right));
  if (!(comesFromInside || comesFromBefore) || (!endsInside && isBefore(left)))
  {
    return {};
  }
  ClippedEdge piece;
  piece.from = comesFromInside ? centre(right) : kNoCorner;
  piece.to = endsInside ? centre(left) : kNoCorner;
  if (!comesFromInside)
  {
    piece.entry = crossing.entry;
    piece.from = cornerAt(crossing.entry, right, ends, piece.to);
  }
  if (!endsInside)
  {
    piece.exit = crossing.exit;
    piece.to = cornerAt(crossing.exit, left, ends, piece.from);
  }
  return piece;
}

ClippedEdge ConvexBorder::chord(const Point& p, const Point& q)
{
  ConvexPolygon::Crossing crossing;
  if (!polygon_.isCrossed(p, q, crossing))
  {
    return {};
  }
  const CornerId from = cornerAt(crossing.entry, kNoTriangle, { p, q }, kNoCorner);
  return { from, cornerAt(crossing.exit, kNoTriangle, { p, q }, from), crossing.entry,
    crossing.exit };
}

/// The corner where the bisector of two points meets that stretch. `triangle`: whose centre is the
/// edge's end there or beyond. `other`: the other end of what is left of it, or none.
CornerId ConvexBorder::cornerAt(Stretch at, std::size_t triangle, const Line& ends, CornerId other)
{
  const std::size_t k = at / 2;
  if (at % 2 == 0)
  {
    return cornerOfPolygon(k);
  }
  const bool isCentre = triangle != kNoTriangle && sideOf(k, triangle) == 0;
  const Point where = isCentre
    ? within(polygon_.bounds(), diagram_.centre(diagram_.standIn(triangle)))
    : bisectorOnLine(ends.from, ends.to, polygon_.side(k));
  for (const std::size_t near : { k, k + 1 })
  {
    if (where == polygon_.corner(near))
    {
      return cornerOfPolygon(near);
    }
  }
  CornerId found = kNoCorner;
  CornerId& id = isCentre ? onBorder_.try_emplace(diagram_.standIn(triangle), found).first->second
                          : found;
  if (id == kNoCorner)
  {
    id = other != kNoCorner && corner(other) == where ? other : add(where);
  }
  return id;
}

CornerId ConvexBorder::cornerOfPolygon(std::size_t k)
{
  CornerId& id = corners_[k % corners_.size()];
  id = id == kNoCorner ? add(polygon_.corner(k)) : id;
  return id;
}

/// A cell that has all corners has all of the polygon, and no edge inside: so on one side nothing
/// is passed, whichever end comes first once they are rounded.
void ConvexBorder::follow(Index, const Gap& gap, bool, std::vector<CornerId>& cell)
{
  if (gap.exit == gap.entry)
  {
    return;
  }
  const auto end = static_cast<Stretch>(2 * polygon_.size());
  for (Stretch at = (gap.exit + 1) % end; at != gap.entry; at = (at + 1) % end)
  {
    if (at % 2 == 0)
    {
      addTo(cell, cornerOfPolygon(at / 2));
    }
  }
}

/// A cell without corners has no area inside.
void ConvexBorder::fill(Index site, std::vector<CornerId>& cell)
{
  if (!cell.empty() && cell.size() < 3)
  {
    const Point vertex = diagram_.point(site);
    fillWith(polygon_.contains(vertex) ? vertex : corner(cell[0]), cell);
  }
}

} // namespace ahd
