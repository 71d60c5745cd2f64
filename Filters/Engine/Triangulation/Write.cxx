// SPDX-License-Identifier: BSD-3-Clause
#include "State.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/Loops.h"
#include "../Extract/Extractor.h"
#include "MeshOrder.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// Calls write(begin, end) for pieces of [0, items), on the threads lent to the phase. Returns
/// false if the work is cancelled.
template <typename Write>
bool writeInShares(std::size_t items, Ticker& ticker, Write write)
{
  return inShares(items, ticker, 1, kChunk, write);
}

} // namespace

/// By what there is: numbers, corners (then the places of the vertices are not to be lost), or the
/// mesh alone.
template <typename Id>
bool Triangulation::State::writeTriangles(Id* triples, Ticker& ticker)
{
  if (hasNumbers && report.triangles == allTriangles)
  {
    const auto write = [&](std::size_t t, std::size_t, const OrderedTriangle& triangle)
    {
      for (unsigned k = 0; k < 3; ++k)
      {
        triples[3 * t + k] = static_cast<Id>(ranked.id[triangle.corner(k)]);
      }
    };
    return inMeshOrder(mesh, numbers, TriangleArray(triples, 3), ticker, write) && ticker.ask();
  }
  if (hasCorners)
  {
    return writeKept(triples, ticker) && ticker.ask();
  }
  arePlacesGone = true;
  Scratch scratch;
  scratch.view(ranked.xy.data(), ranked.xy.size() * sizeof(Point));
  const ExtractedMesh kept = hasMarks ? ExtractedMesh(mesh, constrained.allMarks(), kDropped)
                                      : mesh;
  // Polls at the end as well: the last part of the work may have been another thread's.
  return writeCanonical(kept, ranked.id.data(), triples, scratch, ticker) && ticker.ask();
}

template <typename Id>
bool Triangulation::State::writeKept(Id* triples, Ticker& ticker) const
{
  const auto write = [&](std::size_t triangle, std::size_t to)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      triples[3 * to + e] = static_cast<Id>(ranked.id[tables.corners[3 * triangle + e]]);
    }
  };
  if (report.triangles == allTriangles)
  {
    return writeInShares(allTriangles, ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t t = a; t != b; ++t)
        {
          write(t, t);
        }
      });
  }
  std::size_t to = 0;
  return inChunks(0, allTriangles, ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t t = a; t != b; ++t)
      {
        if (tables.isKept(t))
        {
          write(t, to++);
        }
      }
      ticker.finished(b - a);
    });
}

template <typename Id>
bool Triangulation::State::writePointStatus(Id* status, Ticker& ticker) const
{
  const auto writeOwn = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      status[i] = points.skipped(i) ? Id(kStatusNotInserted)
        : isFinite(points[i])       ? static_cast<Id>(i)
                                    : Id(kStatusNotFinite);
    }
  };
  const auto writeDuplicates = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      status[ranked.duplicates[i].id] = status[ranked.duplicates[i].keptId];
    }
  };
  const auto writeBeyond = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = report.inserted + a; i != report.inserted + b; ++i)
    {
      status[ranked.id[sequence[i]]] = Id(kStatusNotInserted);
    }
  };
  // Data that the others overwrite or read must be written before.
  return writeInShares(points.count, ticker, writeOwn) &&
    writeInShares(report.beyondLimit, ticker, writeBeyond) &&
    writeInShares(ranked.duplicates.size(), ticker, writeDuplicates) && ticker.ask();
}

template <typename Id>
bool Triangulation::State::writeOrder(Id* ids, Ticker& ticker) const
{
  const auto write = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      ids[i] = static_cast<Id>(ranked.id[sequence[i]]);
    }
  };
  return writeInShares(report.inserted, ticker, write) && ticker.ask();
}

template <typename Id>
bool Triangulation::State::writeInsertionRanks(Id* ranks, Ticker& ticker) const
{
  const auto writeNone = [&](std::size_t a, std::size_t b)
  { std::fill(ranks + a, ranks + b, Id(kRankNone)); };
  const auto writePlaces = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      ranks[ranked.id[sequence[i]]] = static_cast<Id>(i);
    }
  };
  const std::size_t inOrder = report.inserted + report.beyondLimit;
  return writeInShares(points.count, ticker, writeNone) &&
    writeInShares(inOrder, ticker, writePlaces) && ticker.ask();
}

template <typename Id>
Status Triangulation::writeTriangles(Id* triples, const Context& context)
{
  if (!state_ || state_->report.triangles == 0)
  {
    return Status::Ok;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Extract, state_->report.triangles,
        state_->worthItsWhile(context.executor));
      return state_->writeTriangles(triples, ticker);
    });
}

template <typename Id>
Status Triangulation::writePointStatus(Id* status, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, points().count,
        state_ ? state_->worthItsWhile(context.executor) : nullptr);
      return !state_ || state_->writePointStatus(status, ticker);
    });
}

template <typename Id>
Status Triangulation::writeOrder(Id* ids, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, report().inserted,
        state_ ? state_->worthItsWhile(context.executor) : nullptr);
      return !state_ || state_->writeOrder(ids, ticker);
    });
}

template <typename Id>
Status Triangulation::writeInsertionRanks(Id* ranks, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, points().count,
        state_ ? state_->worthItsWhile(context.executor) : nullptr);
      return !state_ || state_->writeInsertionRanks(ranks, ticker);
    });
}

#define AHD_WRITES(Id)                                                                             \
  template Status Triangulation::writeTriangles(Id*, const Context&);                              \
  template Status Triangulation::writePointStatus(Id*, const Context&);                            \
  template Status Triangulation::writeOrder(Id*, const Context&);                                  \
  template Status Triangulation::writeInsertionRanks(Id*, const Context&)

AHD_WRITES(int);
AHD_WRITES(long);
AHD_WRITES(long long);

#undef AHD_WRITES

} // namespace ahd
