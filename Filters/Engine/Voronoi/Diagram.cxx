// SPDX-License-Identifier: BSD-3-Clause
#include "Diagram.h"

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{
constexpr std::uint32_t kNobody = 0xFFFFFFFFu;
}

bool Diagram::build(Ticker& ticker)
{
  return this->computeCentres(ticker) && this->findStarts(ticker) && this->joinCentres(ticker);
}

bool Diagram::computeCentres(Ticker& ticker)
{
  centres_.allocate(delaunay_.triangles);
  const std::size_t tasks = tasksFor(threadsOf(ticker), delaunay_.triangles, 8, 1 << 14);
  return inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(delaunay_.triangles, task, tasks);
      return inChunks(share.begin, share.end, own,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t t = begin; t < end; ++t)
          {
            centres_[t] = circumcentre(corners(t));
          }
          own.finished(end - begin);
        });
    });
}

bool Diagram::findStarts(Ticker& ticker)
{
  starts_.allocate(delaunay_.points.count);
  return fillAll(starts_, kNoHalfEdge, ticker) &&
    inChunks(0, delaunay_.triangles, ticker,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = 3 * begin; i < 3 * end; ++i)
        {
          HalfEdge& start = starts_[origin(static_cast<HalfEdge>(i))];
          if (start == kNoHalfEdge || delaunay_.neighbors[i] < 0)
          {
            start = static_cast<HalfEdge>(i);
          }
        }
      });
}

bool Diagram::countVertices(Ticker& ticker, std::size_t& count) const
{
  count = starts_.size();
  return inChunks(0, starts_.size(), ticker,
    [&](std::size_t a, std::size_t b)
    {
      count -= static_cast<std::size_t>(
        std::count(starts_.data() + a, starts_.data() + b, kNoHalfEdge));
    });
}

/// Centres are joined to one they are near to, never to one that is itself joined: so they do not
/// drift away in steps.
bool Diagram::joinCentres(Ticker& ticker)
{
  standIns_.allocate(delaunay_.triangles);
  if (!fillAll(standIns_, kNobody, ticker))
  {
    return false;
  }
  for (std::size_t t = 0; t < delaunay_.triangles; ++t)
  {
    if (standIns_[t] == kNobody && !joinTo(t, ticker))
    {
      return false;
    }
  }
  return true;
}

bool Diagram::joinTo(std::size_t triangle, Ticker& ticker)
{
  standIns_[triangle] = static_cast<std::uint32_t>(triangle);
  stack_.assign(1, static_cast<std::uint32_t>(triangle));
  while (!stack_.empty())
  {
    const std::size_t t = stack_.back();
    stack_.pop_back();
    for (std::size_t h = 3 * t; h < 3 * t + 3; ++h)
    {
      const std::int64_t other = delaunay_.neighbors[h];
      if (other >= 0 && standIns_[static_cast<std::size_t>(other)] == kNobody &&
        areOne(triangle, static_cast<std::size_t>(other)))
      {
        standIns_[static_cast<std::size_t>(other)] = static_cast<std::uint32_t>(triangle);
        stack_.push_back(static_cast<std::uint32_t>(other));
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
  const Point corner = corners(a).a;
  const double size = std::max(
    std::max(std::fabs(p.x), std::fabs(p.y)), std::max(std::fabs(corner.x), std::fabs(corner.y)));
  return isFinite(p) && isFinite(q) && std::fabs(p.x - q.x) <= kUnits * size &&
    std::fabs(p.y - q.y) <= kUnits * size;
}

} // namespace ahd
