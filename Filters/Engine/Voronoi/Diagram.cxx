// SPDX-License-Identifier: BSD-3-Clause
#include "Diagram.h"

#include "../Core/Chunks.h"
#include "../Core/Loops.h"
#include "CentreBlocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

/// Differences up to so many times the size of coordinates are due to rounding.
constexpr double kUnits = 2.0 * std::numeric_limits<double>::epsilon();

double sizeOf(const Point& p)
{
  return std::max(std::fabs(p.x), std::fabs(p.y));
}

} // namespace

bool Diagram::computeCentres(Ticker& ticker)
{
  centres_.allocate(triangles());
  standIns_.allocate(triangles());
  return inShares(triangles(), ticker, 8, 1 << 14,
    [&](std::size_t begin, std::size_t end)
    {
      if (areModest_)
      {
        circumcentres()(
          tables_.corners.data() + 3 * begin, places_, end - begin, centres_.data() + begin);
      }
      for (std::size_t t = begin; t < end; ++t)
      {
        centres_[t] = areModest_ ? centres_[t] : circumcentre(corners(t));
        standIns_[t] = static_cast<std::uint32_t>(t);
      }
    });
}

/// Centres are joined to one they are near to, never to one that is itself joined: so they do not
/// drift away in steps.
bool Diagram::joinCentres(Ticker& ticker)
{
  const std::size_t tasks = tasksFor(threadsOf(ticker), triangles(), 8, 1 << 14);
  const double size = std::max(
    sizeOf({ bounds_.xmin, bounds_.ymin }), sizeOf({ bounds_.xmax, bounds_.ymax }));
  constexpr std::size_t kAhead = 64; // triangles: fetched
  std::vector<std::vector<std::uint32_t>> found(tasks);
  const auto look = [&](std::size_t task, Ticker& own)
  {
    std::vector<std::uint32_t> some;
    const Share share(triangles(), task, tasks);
    const bool done = inChunks(share.begin, share.end, own,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t t = begin; t < end; ++t)
        {
          prefetchForRead(centres_.data() + t + kAhead);
          prefetchForRead(tables_.twins.data() + 3 * (t + kAhead));
          if (mayJoin(t, size))
          {
            some.push_back(static_cast<std::uint32_t>(t));
          }
        }
        own.finished(end - begin);
      });
    found[task].swap(some);
    return done;
  };
  if (!inParallel(ticker, tasks, look))
  {
    return false;
  }
  for (const std::vector<std::uint32_t>& some : found)
  {
    for (const std::uint32_t triangle : some)
    {
      if (!joinTo(triangle, ticker))
      {
        return false;
      }
    }
  }
  return true;
}

/// May a later neighbour's centre coincide with its own? `size`: no vertex has a larger coordinate.
bool Diagram::mayJoin(std::size_t triangle, double size) const
{
  const HalfEdge first = static_cast<HalfEdge>(3 * triangle);
  const Point p = centres_[triangle];
  const double near = kUnits * std::max(sizeOf(p), size);
  // Hardly any is near: so all three are compared, without an unpredictable branch.
  bool isNear[3];
  for (HalfEdge e = 0; e != 3; ++e)
  {
    const HalfEdge across = twin(first + e);
    const std::size_t other = across == kNoHalfEdge ? triangle : across / 3;
    isNear[e] = std::fabs(centres_[other].x - p.x) <= near;
  }
  if (!(isNear[0] | isNear[1] | isNear[2]))
  {
    return false;
  }
  for (HalfEdge h = first; h != first + 3; ++h)
  {
    const HalfEdge across = twin(h);
    if (across > h && across != kNoHalfEdge && areOne(triangle, across / 3))
    {
      return true;
    }
  }
  return false;
}

/// Joins to it the later ones that coincide with it, unless it is joined itself.
bool Diagram::joinTo(std::uint32_t triangle, Ticker& ticker)
{
  if (standIns_[triangle] != triangle)
  {
    return ticker.step();
  }
  stack_.assign(1, triangle);
  while (!stack_.empty())
  {
    const HalfEdge first = 3 * stack_.back();
    stack_.pop_back();
    for (HalfEdge h = first; h != first + 3; ++h)
    {
      const std::uint32_t other = twin(h) / 3;
      if (twin(h) != kNoHalfEdge && other > triangle && standIns_[other] == other &&
        areOne(triangle, other))
      {
        standIns_[other] = triangle;
        hasJoined_ = true;
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

/// Is the difference of the centres due to rounding: of theirs, or of the points' coordinates?
bool Diagram::areOne(std::size_t a, std::size_t b) const
{
  const Point p = centres_[a];
  const Point q = centres_[b];
  const double size = std::max(sizeOf(p), sizeOf(point(origin(static_cast<HalfEdge>(3 * a)))));
  return isFinite(p) && isFinite(q) && std::fabs(p.x - q.x) <= kUnits * size &&
    std::fabs(p.y - q.y) <= kUnits * size;
}

} // namespace ahd
