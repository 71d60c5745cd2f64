// SPDX-License-Identifier: BSD-3-Clause
#include "ConvexPolygon.h"

#include "../Points/JoinedBounds.h"
#include "../Predicates/Predicates.h"

#include <utility>

namespace ahd
{

ConvexPolygon::ConvexPolygon(std::vector<Point> corners)
  : corners_(std::move(corners))
  , fault_(arrange())
{
}

PolygonFault ConvexPolygon::arrange()
{
  if (!std::all_of(corners_.begin(), corners_.end(), isFinite))
  {
    return PolygonFault::NotFinite;
  }
  for (const Point& p : corners_)
  {
    bounds_ = joined(bounds_, { p.x, p.x, p.y, p.y });
  }
  if (size() == 2)
  {
    corners_ = { { bounds_.xmin, bounds_.ymin }, { bounds_.xmax, bounds_.ymin },
      { bounds_.xmax, bounds_.ymax }, { bounds_.xmin, bounds_.ymax } };
  }
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  while (size() > 1 && corners_.front() == corners_.back())
  {
    corners_.pop_back();
  }
  const PolygonFault fault = takeStrict();
  if (fault == PolygonFault::None)
  {
    std::rotate(corners_.begin(),
      std::min_element(corners_.begin(), corners_.end(), lexicographicallyLess), corners_.end());
    last_ = static_cast<std::size_t>(
      std::max_element(corners_.begin(), corners_.end(), lexicographicallyLess) - corners_.begin());
    isBox_ = size() == 4 && corner(0).y == corner(1).y && corner(1).x == corner(2).x &&
      corner(2).y == corner(3).y && corner(3).x == corner(0).x;
  }
  return fault;
}

/// It is convex if all turns are to one side, and if it turns around once: then the lexicographic
/// order of successive corners is reversed twice. A straight angle changes neither.
PolygonFault ConvexPolygon::takeStrict()
{
  std::vector<Point> strict;
  std::size_t reversals = 0;
  bool turns[3] = {}; // right, straight back, left
  for (std::size_t k = 0; k < size(); ++k)
  {
    const Point &a = corner(k == 0 ? size() - 1 : k - 1), &b = corner(k), &c = corner(k + 1);
    const int turn = orient2d(a, b, c);
    const bool isReversed = lexicographicallyLess(a, b) != lexicographicallyLess(b, c);
    reversals += isReversed ? 1 : 0;
    if (turn != 0 || isReversed)
    {
      turns[turn + 1] = true;
      strict.push_back(b);
    }
  }
  if (!turns[0] && !turns[2])
  {
    return PolygonFault::NoArea;
  }
  if (turns[1] || turns[0] == turns[2] || reversals != 2)
  {
    return PolygonFault::NotConvex;
  }
  if (turns[0])
  {
    std::reverse(strict.begin(), strict.end());
  }
  corners_ = std::move(strict);
  return PolygonFault::None;
}

/// The sides above and below the circumcentre decide. Where its x is that of a corner, rounded or
/// not, they are those on either side of it, and where it is left or right of all, those at that
/// end: it is beyond one of these, as both lead away from there.
std::size_t ConvexPolygon::sideBeyond(const Corners& triangle, const Point& centre) const
{
  const double x = within(bounds_, centre).x;
  const auto first = corners_.begin() + 1, middle = first + std::ptrdiff_t(last_);
  const auto below = std::partition_point(
    first, middle - 1, [x](const Point& p) { return p.x < x; });
  for (auto k = static_cast<std::size_t>(below - first); k < last_ && corner(k).x <= x; ++k)
  {
    if (sideOf(k, triangle, centre) <= 0)
    {
      return k;
    }
  }
  const auto above = std::partition_point(
    middle, corners_.end(), [x](const Point& p) { return p.x > x; });
  for (auto k = static_cast<std::size_t>(above - first); k < size() && corner(k).x >= x; ++k)
  {
    if (sideOf(k, triangle, centre) <= 0)
    {
      return k;
    }
  }
  return kNoSide;
}

int ConvexPolygon::sideOf(std::size_t k, const Corners& triangle, const Point& centre) const
{
  const Line line = side(k);
  if (line.from.y == line.to.y && centre.y != line.from.y)
  {
    return (centre.y > line.from.y) == (line.to.x > line.from.x) ? 1 : -1;
  }
  if (line.from.x == line.to.x && centre.x != line.from.x)
  {
    return (centre.x < line.from.x) == (line.to.y > line.from.y) ? 1 : -1;
  }
  return sideOfCircumcentre(triangle, line.from, line.to);
}

/// Corners that are nearer to p lie to the left of the bisector, and come in a row between the exit
/// and the entry.
bool ConvexPolygon::isCrossed(const Point& p, const Point& q, Crossing& crossing) const
{
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  crossing = { kNone, kNone };
  const int first = nearerOf(p, q, corner(0));
  int from = first;
  for (std::size_t k = 0; k < size(); ++k)
  {
    const int to = k + 1 == size() ? first : nearerOf(p, q, corner(k + 1));
    const std::uint32_t at = static_cast<std::uint32_t>(2 * k) + (from == 0 ? 0 : 1);
    crossing.exit = from <= 0 && to > 0 ? at : crossing.exit;
    crossing.entry = from >= 0 && to < 0 ? at : crossing.entry;
    from = to;
  }
  return crossing.exit != kNone && crossing.entry != kNone;
}

bool ConvexPolygon::contains(const Point& p) const
{
  bool isInside = true;
  for (std::size_t k = 0; k < size() && isInside; ++k)
  {
    isInside = orient2d(corner(k), corner(k + 1), p) >= 0;
  }
  return isInside;
}

} // namespace ahd
