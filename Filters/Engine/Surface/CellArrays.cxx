// SPDX-License-Identifier: BSD-3-Clause
#include "CellArrays.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "../Triangulation/State.h"

#include <algorithm>
#include <vector>

namespace ahd
{

namespace
{

/// Cells that are put out before the triangles.
std::size_t cellsBefore(const Selection& selection)
{
  return selection.vertices.size() + selection.lines.size() / 2;
}

std::size_t selectedCount(const Triangulation& triangulation, const Selection& selection)
{
  return selection.kept.empty() ? triangulation.report().triangles : selection.keptCount;
}

/// The triangles that are put out, and their places among these.
class Selected
{
public:
  Selected(const Tables& tables, const Selection& selection)
    : tables_(tables)
    , kept_(selection.kept.empty() ? nullptr : selection.kept.data())
  {
  }

  /// Returns false if cancelled; throws std::bad_alloc. `count`: of the triangles put out.
  bool number(std::size_t count, Ticker& ticker)
  {
    if (count == tables_.triangles())
    {
      return true;
    }
    numbers_.allocate(tables_.triangles());
    std::uint32_t next = 0;
    return inChunks(0, tables_.triangles(), ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t t = a; t != b; ++t)
        {
          numbers_[t] = contains(t) ? next++ : kNoIndex;
        }
      });
  }

  /// kNoIndex for one that is not put out. REQUIRES: number().
  std::uint32_t numberOf(std::size_t triangle) const
  {
    return numbers_.empty() ? static_cast<std::uint32_t>(triangle) : numbers_[triangle];
  }

  /// Calls visit(triangle, its place) for each, on all threads lent. Returns false if cancelled.
  /// REQUIRES: number().
  template <typename Visit>
  bool each(Ticker& ticker, Visit visit) const
  {
    const std::size_t tasks = tasksFor(threadsOf(ticker), tables_.triangles(), 4, kChunk);
    return inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(tables_.triangles(), task, tasks);
        return inChunks(share.begin, share.end, own,
          [&](std::size_t a, std::size_t b)
          {
            for (std::size_t t = a; t != b; ++t)
            {
              if (const std::uint32_t place = numberOf(t); place != kNoIndex)
              {
                visit(t, std::size_t(place));
              }
            }
            own.finished(b - a);
          });
      });
  }

private:
  bool contains(std::size_t triangle) const
  {
    return kept_ ? kept_[triangle] != 0 : tables_.isKept(triangle);
  }

  const Tables& tables_;
  const unsigned char* kept_;
  Buffer<std::uint32_t> numbers_; ///< empty if all are put out
};

/// Calls write(tables, the selected triangles, ticker) with the tables that make(context) makes.
/// `write` returns false if it is to be cancelled.
template <typename Make, typename Write>
Status withSelected(Triangulation& triangulation, const Selection& selection,
  const Context& context, Make make, Write write)
{
  const std::size_t count = selectedCount(triangulation, selection);
  if (count == 0)
  {
    return Status::Ok;
  }
  if (const Status made = make(context); made != Status::Ok)
  {
    return made;
  }
  return unlessCancelled(
    [&]
    {
      const TriangulationAccess::State& state = *TriangulationAccess::stateOf(triangulation);
      Ticker ticker(context.progress, Phase::Outputs, state.allTriangles,
        state.worthItsWhile(context.executor));
      Selected selected(state.tables, selection);
      return selected.number(count, ticker) && write(state, selected, ticker) && ticker.ask();
    });
}

/// Visits the triangles that loops keep, region by region.
class RegionFlood
{
public:
  explicit RegionFlood(const Tables& tables)
    : tables_(tables)
  {
  }

  /// Returns false if cancelled, as flood does; throws std::bad_alloc, as it does.
  bool begin(Ticker& ticker)
  {
    regions_.allocate(tables_.triangles());
    return fillAll(regions_, kNoIndex, ticker);
  }

  /// kNoIndex if flood() has not come there.
  std::uint32_t regionOf(std::size_t triangle) const { return regions_[triangle]; }

  bool flood(std::size_t start, std::uint32_t region, Ticker& ticker)
  {
    visit(start, region);
    while (!waiting_.empty())
    {
      const HalfEdge first = 3 * waiting_.back();
      waiting_.pop_back();
      for (HalfEdge h = first; h != first + 3; ++h)
      {
        const HalfEdge twin = tables_.twins[h];
        if (twin != kNoHalfEdge && !tables_.isConstrained(h) && tables_.isKept(twin / 3) &&
          regions_[twin / 3] == kNoIndex)
        {
          visit(twin / 3, region);
        }
      }
      if (!ticker.step())
      {
        return false;
      }
    }
    return true;
  }

private:
  void visit(std::size_t triangle, std::uint32_t region)
  {
    regions_[triangle] = region;
    waiting_.push_back(static_cast<std::uint32_t>(triangle));
  }

  const Tables& tables_;
  Buffer<std::uint32_t> regions_;
  std::vector<std::uint32_t> waiting_;
};

/// In ascending order, on this thread: regions are numbered as they appear.
template <typename Id>
bool numberRegions(const Tables& tables, const Selected& selected, Id* out, Ticker& ticker)
{
  RegionFlood flood(tables);
  if (!flood.begin(ticker))
  {
    return false;
  }
  std::uint32_t regions = 0;
  for (std::size_t t = 0; t < tables.triangles(); ++t)
  {
    const std::uint32_t place = selected.numberOf(t);
    if (!ticker.step())
    {
      return false;
    }
    if (place == kNoIndex)
    {
      continue;
    }
    if (flood.regionOf(t) == kNoIndex && !flood.flood(t, regions++, ticker))
    {
      return false;
    }
    out[place] = static_cast<Id>(flood.regionOf(t));
    ticker.finished(1);
  }
  return true;
}

} // namespace

std::size_t cellCount(const Triangulation& triangulation, const Selection& selection)
{
  return cellsBefore(selection) + selectedCount(triangulation, selection);
}

template <typename Id>
Status writeSelected(
  Triangulation& triangulation, const Selection& selection, Id* triples, const Context& context)
{
  return withSelected(
    triangulation, selection, context,
    [&](const Context& c) { return triangulation.makeCorners(c); },
    [&](const TriangulationAccess::State& state, const Selected& selected, Ticker& ticker)
    {
      return selected.each(ticker,
        [&](std::size_t t, std::size_t place)
        {
          for (std::size_t e = 0; e < 3; ++e)
          {
            triples[3 * place + e] = static_cast<Id>(
              state.ranked.id[state.tables.corners[3 * t + e]]);
          }
        });
    });
}

template <typename Id>
Status writeNeighbors(
  Triangulation& triangulation, const Selection& selection, Id* neighbors, const Context& context)
{
  const std::size_t before = cellsBefore(selection);
  std::fill(neighbors, neighbors + 3 * before, Id(-1));
  return withSelected(
    triangulation, selection, context,
    [&](const Context& c) { return triangulation.makeNeighbors(c); },
    [&](const TriangulationAccess::State& state, const Selected& selected, Ticker& ticker)
    {
      return selected.each(ticker,
        [&](std::size_t t, std::size_t place)
        {
          for (std::size_t e = 0; e < 3; ++e)
          {
            const HalfEdge twin = state.tables.twins[3 * t + e];
            const std::uint32_t other = twin == kNoHalfEdge ? kNoIndex
                                                            : selected.numberOf(twin / 3);
            neighbors[3 * (before + place) + e] = other == kNoIndex
              ? Id(-1)
              : static_cast<Id>(before + other);
          }
        });
    });
}

Status writeConstraintEdges(Triangulation& triangulation, const Selection& selection,
  std::uint8_t* edges, const Context& context)
{
  const std::size_t before = cellsBefore(selection);
  std::fill(edges, edges + before, std::uint8_t(0));
  return withSelected(
    triangulation, selection, context,
    [&](const Context& c) { return triangulation.makeCorners(c); },
    [&](const TriangulationAccess::State& state, const Selected& selected, Ticker& ticker)
    {
      const Buffer<std::uint8_t>& flags = state.tables.flags;
      return selected.each(ticker,
        [&](std::size_t t, std::size_t place)
        { edges[before + place] = static_cast<std::uint8_t>(flags.empty() ? 0u : flags[t] & 7u); });
    });
}

template <typename Id>
Status writeRegions(
  Triangulation& triangulation, const Selection& selection, Id* regions, const Context& context)
{
  const std::size_t before = cellsBefore(selection);
  std::fill(regions, regions + before, Id(-1));
  return withSelected(
    triangulation, selection, context,
    [&](const Context& c) { return triangulation.makeNeighbors(c); },
    [&](const TriangulationAccess::State& state, const Selected& selected, Ticker& ticker)
    { return numberRegions(state.tables, selected, regions + before, ticker); });
}

#define AHD_WRITES(Id)                                                                             \
  template Status writeSelected(Triangulation&, const Selection&, Id*, const Context&);            \
  template Status writeNeighbors(Triangulation&, const Selection&, Id*, const Context&);           \
  template Status writeRegions(Triangulation&, const Selection&, Id*, const Context&)

AHD_WRITES(int);
AHD_WRITES(long);
AHD_WRITES(long long);

#undef AHD_WRITES

} // namespace ahd
