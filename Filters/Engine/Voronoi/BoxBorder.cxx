// SPDX-License-Identifier: BSD-3-Clause
#include "BoxBorder.h"

#include <algorithm>

namespace ahd
{

namespace
{

Point middle(const Point& p, const Point& q)
{
  return { 0.5 * p.x + 0.5 * q.x, 0.5 * p.y + 0.5 * q.y };
}

/// Is the angle at r less than a right one?
bool isAcute(const Point& p, const Point& r, const Point& q)
{
  const Point toP = directionOf(r, p), toQ = directionOf(r, q);
  return toP.x * toQ.x + toP.y * toQ.y > 0.0;
}

} // namespace

/// Does the centre of h's triangle, which is not in the box, lie to the left of h, as seen from the
/// middle between p and q, the ends of h?
bool BoxBorder::isAhead(HalfEdge h, const Point& p, const Point& q) const
{
  const Point m = middle(p, q);
  const Point c = diagram_.centre(diagram_.standIn(h / 3));
  const Point way = directionOf(m, c), edge = directionOf(p, q);
  const double left = edge.x * way.y - edge.y * way.x;
  if (isFinite(c) && (left > 0.0 || left < 0.0))
  {
    return left > 0.0;
  }
  return isAcute(p, diagram_.point(diagram_.origin(previousInTriangle(h))), q);
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
    return { from, crossing(p, q, from) };
  }
  if (isInside(h / 3))
  {
    const CornerId to = centre(h / 3);
    return { crossing(q, p, to), to };
  }
  // Both ends outside: the middle, which is inside, lies between them, or the edge is outside.
  const bool comesFromBehind = twin == kNoHalfEdge || isAhead(twin, q, p);
  return comesFromBehind && isAhead(h, p, q) ? chord(p, q) : ClippedEdge{};
}

ClippedEdge BoxBorder::chord(const Point& p, const Point& q)
{
  const CornerId from = crossing(q, p, kNoCorner);
  return { from, crossing(p, q, from) };
}

/// Where the bisector of p and q, followed counterclockwise around p, leaves the box. `end`: the
/// other end of what is left of it, or none.
CornerId BoxBorder::crossing(const Point& p, const Point& q, CornerId end)
{
  const Point where = box_.leave(middle(p, q), p, q);
  for (unsigned k = 0; k < 4; ++k)
  {
    if (where == box_.corner(k))
    {
      return cornerOfBox(k);
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

/// A cell that has both ends of a side has all of the side, and with it the vertices there: so its
/// own vertex lies there, as it is the only one.
bool BoxBorder::mayFollow(Index site, const Point& from, const Point& to) const
{
  for (unsigned side = 0; side < 4; ++side)
  {
    if (from == box_.corner(side) && to == box_.corner((side + 1) % 4))
    {
      return box_.isOnSide(diagram_.point(site), side);
    }
  }
  return true;
}

void BoxBorder::follow(Index site, CornerId last, CornerId next, bool, std::vector<CornerId>& cell)
{
  // Where more is passed than the cell can have, its two corners are one up to rounding, but the
  // wrong way round: then nothing is passed.
  const std::vector<unsigned> passed = box_.between(corner(last), corner(next));
  Point before = corner(last);
  bool isRight = true;
  for (const unsigned k : passed)
  {
    isRight = isRight && mayFollow(site, before, box_.corner(k));
    before = box_.corner(k);
  }
  if (isRight && mayFollow(site, before, corner(next)))
  {
    for (const unsigned k : passed)
    {
      cell.push_back(cornerOfBox(k));
    }
  }
}

} // namespace ahd
