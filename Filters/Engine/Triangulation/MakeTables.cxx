// SPDX-License-Identifier: BSD-3-Clause
#include "State.h"

#include "../Core/Chunks.h"
#include "../Core/Loops.h"
#include "../Core/Tasks.h"
#include "../Extract/Extractor.h"
#include "MeshOrder.h"

#include <algorithm>
#include <limits>

namespace ahd
{

bool Triangulation::State::restorePlaces(Ticker& ticker)
{
  if (!arePlacesGone)
  {
    return true;
  }
  const auto read = [this](std::size_t a, std::size_t b)
  {
    for (std::size_t v = a; v != b; ++v)
    {
      ranked.xy[v] = points[ranked.id[v]];
    }
  };
  return inShares(ranked.count, ticker, 1, kChunk, read) && havePlaces();
}

bool Triangulation::State::havePlaces()
{
  if (arePlacesGone)
  {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    ranked.xy[ranked.count] = { kNaN, kNaN }; // the ghost's
    arePlacesGone = false;
  }
  return true;
}

/// Room for the extraction: where the places were, if these are gone.
void Triangulation::State::makeScratch(Scratch& scratch)
{
  if (arePlacesGone)
  {
    scratch.view(ranked.xy.data(), ranked.xy.size() * sizeof(Point));
  }
  else
  {
    scratch.allocate(ranked.count * kExtractScratchPerPoint);
  }
}

bool Triangulation::State::makeNumbers(Ticker& ticker, PlacesAre places)
{
  if (hasNumbers || allTriangles == 0)
  {
    return true;
  }
  arePlacesGone = arePlacesGone || places == PlacesAre::NotNeeded;
  numbers.allocate(mesh.end() / Mesh::kSlotSize);
  Scratch scratch;
  makeScratch(scratch);
  hasNumbers = numberCanonical(mesh, numbers.data(), scratch, ticker);
  return hasNumbers;
}

bool Triangulation::State::makeCorners(Ticker& ticker)
{
  if (hasCorners)
  {
    return true;
  }
  const bool needsNumbers = hasMarks; // the flags do
  hasCorners = (!needsNumbers || makeNumbers(ticker)) && listCorners(ticker) && makeFlags(ticker);
  return hasCorners;
}

bool Triangulation::State::listCorners(Ticker& ticker)
{
  if (allTriangles == 0)
  {
    return true;
  }
  tables.corners.allocate(3 * allTriangles);
  Index* const corners = tables.corners.data();
  if (!hasNumbers)
  {
    Scratch scratch;
    makeScratch(scratch);
    return writeCanonical(mesh, nullptr, corners, scratch, ticker);
  }
  return inMeshOrder(mesh, numbers, TriangleArray(corners, 3), ticker,
    [=](std::size_t t, std::size_t, const OrderedTriangle& triangle)
    {
      for (unsigned k = 0; k < 3; ++k)
      {
        corners[3 * t + k] = triangle.corner(k);
      }
    });
}

bool Triangulation::State::makeFlags(Ticker& ticker)
{
  if (!hasMarks || allTriangles == 0)
  {
    return true;
  }
  tables.flags.allocate(allTriangles);
  return makeNumbers(ticker) &&
    inMeshOrder(mesh, numbers, TriangleArray(tables.flags.data(), 1), ticker,
      [this](std::size_t t, std::size_t slot, const OrderedTriangle& triangle)
      { tables.flags[t] = Tables::flagOf(marksOf(slot), triangle.lowest()); });
}

bool Triangulation::State::makeTwins(Ticker& ticker)
{
  if (hasTwins || allTriangles == 0)
  {
    return true;
  }
  if (!makeNumbers(ticker) || !makeCorners(ticker))
  {
    return false;
  }
  tables.twins.allocate(3 * allTriangles);
  HalfEdge* const twins = tables.twins.data();
  hasTwins = inMeshOrder(mesh, numbers, TriangleArray(twins, 3), ticker,
    [this, twins](std::size_t t, std::size_t, const OrderedTriangle& triangle)
    {
      for (unsigned k = 0; k < 3; ++k)
      {
        const Mesh::Halfedge twin = triangle.twin(k);
        const std::uint32_t number = numbers[twin / Mesh::kSlotSize];
        twins[3 * t + k] = number == kNotExtracted ? kNoHalfEdge : halfEdgeOf(number, twin);
      }
    });
  return hasTwins;
}

/// Of each vertex the first half-edge, but that of the hull if it has one.
bool Triangulation::State::makeStarts(Ticker& ticker)
{
  Buffer<HalfEdge>& starts = tables.starts;
  starts.allocate(ranked.count);
  const std::size_t halfEdges = 3 * allTriangles;
  const auto note = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      const std::size_t h = halfEdges - 1 - i; // so the first is the last that is noted
      starts[tables.corners[h]] = static_cast<HalfEdge>(h);
    }
  };
  const auto noteHull = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t h = a; h != b; ++h)
    {
      if (tables.twins[h] == kNoHalfEdge)
      {
        starts[tables.corners[h]] = static_cast<HalfEdge>(h);
      }
    }
  };
  return fillAll(starts, kNoHalfEdge, ticker) && inChunks(0, halfEdges, ticker, note) &&
    inChunks(0, halfEdges, ticker, noteHull);
}

bool Triangulation::State::makeNeighbors(Ticker& ticker)
{
  hasNeighbors = hasNeighbors || (makeTwins(ticker) && makeStarts(ticker) && ticker.ask());
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
