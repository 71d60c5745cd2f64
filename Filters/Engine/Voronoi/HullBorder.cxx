// SPDX-License-Identifier: BSD-3-Clause
#include "HullBorder.h"

namespace ahd
{

namespace
{
constexpr Stretch kHull = 0;
}

bool HullBorder::build(Ticker& ticker)
{
  beyond_.allocate(diagram_.triangles());
  HalfEdge first = 0;
  const auto inTriangles = [](std::size_t) { return kInside; };
  if (!notePlaces(ticker, inTriangles) || !findHullEdge(first, ticker))
  {
    return false;
  }
  HalfEdge h = first;
  do
  {
    if (!findBeyond(h, ticker) || !ticker.step())
    {
      return false;
    }
    h = diagram_.start(diagram_.target(h)); // the edge of the hull that begins where it ends
  } while (h != first);
  return settleInside(diagram_.bounds(), ticker);
}

/// The first half-edge that lies on the hull.
bool HullBorder::findHullEdge(HalfEdge& found, Ticker& ticker) const
{
  for (found = 0; diagram_.twin(found) != kNoHalfEdge; ++found)
  {
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// Marks the triangles of the hull edge's tree.
bool HullBorder::findBeyond(HalfEdge hullEdge, Ticker& ticker)
{
  const auto visit = [&](std::size_t triangle)
  {
    if (isInside(triangle) && side(triangle, hullEdge) < 0)
    {
      noteOutside(triangle);
      beyond_[triangle] = hullEdge;
      stack_.push_back(static_cast<std::uint32_t>(triangle));
    }
  };
  visit(hullEdge / 3);
  while (!stack_.empty())
  {
    const HalfEdge first = 3 * stack_.back();
    stack_.pop_back();
    for (HalfEdge h = first; h != first + 3; ++h)
    {
      if (diagram_.twin(h) != kNoHalfEdge)
      {
        visit(diagram_.twin(h) / 3);
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

int HullBorder::side(std::size_t triangle, HalfEdge hullEdge) const
{
  return sideOfCircumcentre(diagram_.corners(triangle), diagram_.point(diagram_.origin(hullEdge)),
    diagram_.point(diagram_.target(hullEdge)));
}

ClippedEdge HullBorder::cut(HalfEdge h)
{
  // From the triangle to the right, or infinity beyond the edge itself, to the one to the left.
  const HalfEdge twin = diagram_.twin(h);
  const std::size_t right = twin == kNoHalfEdge ? kNoTriangle : twin / 3;
  const std::size_t left = h / 3;
  const HalfEdge rightEdge = right == kNoTriangle ? h : beyond(right);
  const HalfEdge leftEdge = beyond(left);
  if (rightEdge == leftEdge)
  {
    return {};
  }
  if (rightEdge == kNoHalfEdge)
  {
    return { centre(right), crossing(h, leftEdge, right), kNoStretch, kHull };
  }
  if (leftEdge == kNoHalfEdge)
  {
    return { crossing(h, rightEdge, left), centre(left), kHull, kNoStretch };
  }
  const CornerId from = crossing(h, rightEdge, kNoTriangle);
  const CornerId to = crossing(h, leftEdge, kNoTriangle);
  return { from, corner(from) == corner(to) ? from : to, kHull, kHull };
}

/// Where the dual of h crosses the hull; `insideTriangle`: whose centre is the end that lies
/// inside.
CornerId HullBorder::crossing(HalfEdge h, HalfEdge hullEdge, std::size_t insideTriangle)
{
  const Line line{ diagram_.point(diagram_.origin(hullEdge)),
    diagram_.point(diagram_.target(hullEdge)) };
  const Point where = bisectorOnLine(
    diagram_.point(diagram_.origin(h)), diagram_.point(diagram_.target(h)), line);
  if (insideTriangle != kNoTriangle)
  {
    const CornerId end = centre(insideTriangle);
    if (corner(end) == where || side(insideTriangle, hullEdge) == 0)
    {
      return end;
    }
  }
  return add(where);
}

void HullBorder::follow(Index site, const Gap&, bool isOpen, std::vector<CornerId>& cell)
{
  if (isOpen)
  {
    cell.push_back(add(diagram_.point(site)));
  }
}

} // namespace ahd
