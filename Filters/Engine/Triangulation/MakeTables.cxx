// SPDX-License-Identifier: BSD-3-Clause
#include "State.h"

#include "../Core/Chunks.h"
#include "../Core/Loops.h"
#include "../Core/Tasks.h"
#include "../Extract/Extractor.h"

#include <algorithm>
#include <limits>

namespace ahd
{

namespace
{

/// Finds triangles by the half-edge they begin with: in canonical order they are sorted by it.
class TriangleFinder
{
public:
  /// Returns false if cancelled; throws std::bad_alloc.
  bool begin(const Buffer<Index>& corners, std::size_t vertices, Ticker& ticker)
  {
    corners_ = corners.data();
    const std::size_t triangles = corners.size() / 3;
    first_.allocate(vertices + 1);
    std::size_t vertex = 0;
    const auto note = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t t = a; t != b; ++t)
      {
        for (; vertex <= corners_[3 * t]; ++vertex)
        {
          first_[vertex] = static_cast<Index>(t);
        }
      }
    };
    if (!inChunks(0, triangles, ticker, note))
    {
      return false;
    }
    return inChunks(vertex, vertices + 1, ticker,
      [&](std::size_t a, std::size_t b)
      { std::fill(first_.data() + a, first_.data() + b, static_cast<Index>(triangles)); });
  }

  /// The triangle with the lowest corner `lowest`, followed by `next`. REQUIRES: there is one.
  std::size_t find(Index lowest, Index next) const
  {
    std::size_t low = first_[lowest], high = first_[std::size_t(lowest) + 1];
    while (high - low > 1)
    {
      const std::size_t middle = low + (high - low) / 2;
      (corners_[3 * middle + 1] <= next ? low : high) = middle;
    }
    return low;
  }

private:
  const Index* corners_ = nullptr;
  Buffer<Index> first_; ///< of each vertex: the first triangle that begins there or later
};

/// The flag of a triangle that has these marks, when it begins with corner `lowest` of its slot.
/// The edge opposite to corner e of a slot begins at the corner after it.
std::uint8_t flagOf(std::uint8_t marks, unsigned lowest)
{
  unsigned flag = (marks & kDropped) != 0 ? Tables::kDroppedTriangle : 0u;
  for (unsigned e = 0; e < 3; ++e)
  {
    flag |= (unsigned(marks) >> (lowest + 2 + e) % 3 & 1u) << e;
  }
  return static_cast<std::uint8_t>(flag);
}

} // namespace

bool Triangulation::State::restorePlaces(Ticker& ticker)
{
  if (!arePlacesGone)
  {
    return true;
  }
  const std::size_t tasks = tasksFor(threadsOf(ticker), ranked.count, 1, kChunk);
  const bool done = inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(ranked.count, task, tasks);
      return inChunks(share.begin, share.end, own,
        [&](std::size_t a, std::size_t b)
        {
          for (std::size_t v = a; v != b; ++v)
          {
            ranked.xy[v] = points[ranked.id[v]];
          }
        });
    });
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  ranked.xy[ranked.count] = { kNaN, kNaN };
  arePlacesGone = !done;
  return done;
}

bool Triangulation::State::makeCorners(Ticker& ticker)
{
  if (hasCorners)
  {
    return true;
  }
  if (allTriangles != 0)
  {
    tables.corners.allocate(3 * allTriangles);
    Scratch scratch;
    if (arePlacesGone)
    {
      scratch.view(ranked.xy.data(), ranked.xy.size() * sizeof(Point));
    }
    else
    {
      scratch.allocate(ranked.count * kExtractScratchPerPoint);
    }
    if (!writeCanonical(mesh, nullptr, tables.corners.data(), scratch, ticker))
    {
      return false;
    }
  }
  hasCorners = restorePlaces(ticker) && makeFlags(ticker) && ticker.ask();
  return hasCorners;
}

bool Triangulation::State::makeFlags(Ticker& ticker)
{
  if (!hasMarks || allTriangles == 0)
  {
    return true;
  }
  TriangleFinder finder;
  tables.flags.allocate(allTriangles);
  if (!finder.begin(tables.corners, ranked.count, ticker) ||
    !fillAll(tables.flags, std::uint8_t(0), ticker))
  {
    return false;
  }
  const std::size_t tasks = tasksFor(threadsOf(ticker), constrained.triangles(), 1, kChunk);
  const auto note = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      const Mesh::Slot slot = Mesh::slotOfTriangle(k);
      const std::uint8_t marks = constrained.marks(slot);
      if (marks != 0 && !constrained.isGhost(slot))
      {
        const Index* const v = constrained.data() + slot;
        const unsigned lowest = static_cast<unsigned>(std::min_element(v, v + 3) - v);
        tables.flags[finder.find(v[lowest], v[(lowest + 1) % 3])] = flagOf(marks, lowest);
      }
    }
  };
  return inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(constrained.triangles(), task, tasks);
      return inChunks(share.begin, share.end, own, note);
    });
}

bool Triangulation::State::makeNeighbors(Ticker& ticker)
{
  hasNeighbors = hasNeighbors || (findNeighbors(tables, ranked.count, ticker) && ticker.ask());
  return hasNeighbors;
}

bool Triangulation::State::makePointMap(Ticker& ticker)
{
  Buffer<Index>& vertexOf = tables.vertexOf;
  vertexOf.allocate(points.count);
  const auto number = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t vertex = a; vertex != b; ++vertex)
    {
      vertexOf[ranked.id[vertex]] = static_cast<Index>(vertex);
    }
  };
  const auto leaveOut = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      vertexOf[ranked.id[sequence[i]]] = kNoIndex;
    }
  };
  const auto share = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      vertexOf[ranked.duplicates[i].id] = vertexOf[ranked.duplicates[i].keptId];
    }
  };
  const auto clear = [&](std::size_t a, std::size_t b)
  { std::fill(vertexOf.data() + a, vertexOf.data() + b, kNoIndex); };
  hasPointMap = inChunksOf(vertexOf.size(), ticker, clear) &&
    inChunksOf(ranked.count, ticker, number) &&
    inChunks(report.inserted, report.inserted + report.beyondLimit, ticker, leaveOut) &&
    inChunks(0, ranked.duplicates.size(), ticker, share) && ticker.ask();
  return hasPointMap;
}

} // namespace ahd
