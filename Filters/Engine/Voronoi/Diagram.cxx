// SPDX-License-Identifier: BSD-3-Clause
#include "Diagram.h"

#include "../Core/Chunks.h"
#include "../Core/Loops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

// What a stand-in is before it is known: none yet; and none yet, of a triangle that has a neighbour
// whose centre is one with its own.
constexpr std::uint32_t kNobody = 0xFFFFFFFFu;
constexpr std::uint32_t kMayJoin = 0xFFFFFFFEu;

/// Calls work(begin, end) for pieces of the triangles, on all threads lent. Returns false if
/// cancelled.
template <typename Work>
bool inTriangles(std::size_t triangles, Ticker& ticker, Work work)
{
  return inShares(triangles, ticker, 8, 1 << 14, work);
}

} // namespace

bool Diagram::computeCentres(Ticker& ticker)
{
  centres_.allocate(triangles());
  return inTriangles(triangles(), ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        centres_[t] = circumcentre(corners(t));
      }
    });
}

/// Centres are joined to one they are near to, never to one that is itself joined: so they do not
/// drift away in steps.
bool Diagram::joinCentres(Ticker& ticker)
{
  standIns_.allocate(triangles());
  const auto look = [&](std::size_t begin, std::size_t end)
  {
    for (std::size_t t = begin; t < end; ++t)
    {
      standIns_[t] = mayJoin(t) ? kMayJoin : kNobody;
    }
  };
  if (!inTriangles(triangles(), ticker, look))
  {
    return false;
  }
  for (std::size_t t = 0; t < triangles(); ++t)
  {
    const std::uint32_t known = standIns_[t];
    if (known == kNobody)
    {
      standIns_[t] = static_cast<std::uint32_t>(t);
    }
    if ((known == kMayJoin && !joinTo(t, ticker)) || !ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// Is its centre one with that of a neighbour?
bool Diagram::mayJoin(std::size_t triangle) const
{
  const HalfEdge first = static_cast<HalfEdge>(3 * triangle);
  for (HalfEdge h = first; h != first + 3; ++h)
  {
    if (twin(h) != kNoHalfEdge && areOne(triangle, twin(h) / 3))
    {
      return true;
    }
  }
  return false;
}

bool Diagram::joinTo(std::size_t triangle, Ticker& ticker)
{
  standIns_[triangle] = static_cast<std::uint32_t>(triangle);
  stack_.assign(1, static_cast<std::uint32_t>(triangle));
  while (!stack_.empty())
  {
    const HalfEdge first = 3 * stack_.back();
    stack_.pop_back();
    for (HalfEdge h = first; h != first + 3; ++h)
    {
      const std::uint32_t other = twin(h) / 3;
      if (twin(h) != kNoHalfEdge && standIns_[other] >= kMayJoin && areOne(triangle, other))
      {
        standIns_[other] = static_cast<std::uint32_t>(triangle);
        stack_.push_back(other);
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// Is the difference of the centres a matter of rounding: of theirs, or of the points' coordinates?
bool Diagram::areOne(std::size_t a, std::size_t b) const
{
  constexpr double kUnits = 2.0 * std::numeric_limits<double>::epsilon();
  const Point p = centres_[a];
  const Point q = centres_[b];
  const Point corner = point(origin(static_cast<HalfEdge>(3 * a)));
  const double size = std::max(
    std::max(std::fabs(p.x), std::fabs(p.y)), std::max(std::fabs(corner.x), std::fabs(corner.y)));
  return isFinite(p) && isFinite(q) && std::fabs(p.x - q.x) <= kUnits * size &&
    std::fabs(p.y - q.y) <= kUnits * size;
}

} // namespace ahd
