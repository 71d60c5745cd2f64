// SPDX-License-Identifier: BSD-3-Clause
#include "CellArrays.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Core/SortAsking.h"
#include "Selected.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace ahd
{

namespace
{

/// Output cells before the triangles.
std::size_t cellsBefore(const Selection& selection)
{
  return selection.vertices.size() + selection.lines.size() / 2;
}

std::size_t selectedCount(const Triangulation& triangulation, const Selection& selection)
{
  return selection.kept.empty() ? triangulation.report().triangles : selection.keptCount;
}

using State = TriangulationAccess::State;

/// Writes neighbours; -1 for cells before the triangles.
template <typename Id>
class NeighborWriter
{
public:
  NeighborWriter(const Selection& selection, Id* neighbors)
    : before_(cellsBefore(selection))
    , ofTriangles_(neighbors + 3 * before_)
  {
    std::fill(neighbors, ofTriangles_, Id(-1));
  }

  TriangleArray array() const { return { ofTriangles_, 3 }; }

  void write(const Selected& selected, std::size_t place, const OrderedTriangle& triangle) const
  {
    for (unsigned k = 0; k < 3; ++k)
    {
      const std::uint32_t other = selected.placeOfSlot(triangle.twin(k) / Mesh::kSlotSize);
      ofTriangles_[3 * place + k] = other == kNoIndex ? Id(-1) : static_cast<Id>(before_ + other);
    }
  }

private:
  std::size_t before_;
  Id* ofTriangles_;
};

/// Prefetches for eight slots ahead: ids of a triangle's corners, numbers of its neighbours.
void fetchAround(const State& state, std::size_t slot)
{
  const std::size_t next = std::min(slot + 8, state.numbers.size() - 1);
  const std::uint32_t* const data = state.mesh.data() + next * Mesh::kSlotSize;
  for (unsigned k = 0; k < 3; ++k)
  {
    prefetchForRead(state.ranked.id.data() + data[k]);
    prefetchForRead(state.numbers.data() + data[Mesh::kTwin + k] / Mesh::kSlotSize);
  }
}

/// Calls write(state, ticker), a part of the outputs in so many steps; it returns false if
/// cancelled. @pre there is a state.
template <typename Write>
Status withTicker(
  Triangulation& triangulation, std::size_t steps, const Context& context, Write write)
{
  return unlessCancelled(
    [&]
    {
      State& state = *TriangulationAccess::stateOf(triangulation);
      Ticker ticker(context.progress, Phase::Outputs, steps, state.worthItsWhile(context.executor));
      return write(state, ticker) && ticker.ask();
    });
}

/// Calls write(state, the selected triangles, ticker) when there are numbers; it returns false if
/// it is cancelled.
template <typename Write>
Status withSelected(
  Triangulation& triangulation, const Selection& selection, const Context& context, Write write)
{
  const std::size_t count = selectedCount(triangulation, selection);
  if (count == 0)
  {
    return Status::Ok;
  }
  return withTicker(triangulation, TriangulationAccess::stateOf(triangulation)->allTriangles,
    context,
    [&](State& state, Ticker& ticker)
    {
      Selected selected(state, selection);
      return state.makeNumbers(ticker, State::PlacesAre::NotNeeded) &&
        selected.number(count, ticker) && write(state, selected, ticker);
    });
}

/// Are there constraint edges, or triangles dropped?
bool hasMarks(const Triangulation& triangulation)
{
  const State* const state = TriangulationAccess::stateOf(triangulation);
  return state && state->hasMarks;
}

/// Is there a selection, and are there corners without numbers, so that these need not be made?
bool hasCornersOnly(const Triangulation& triangulation, const Selection& selection)
{
  const State* const state = TriangulationAccess::stateOf(triangulation);
  return state && !selection.kept.empty() && state->hasCorners && !state->hasNumbers;
}

/// The selected triangles of a Triangulation that hasCornersOnly(). Returns false if cancelled.
template <typename Id>
bool writeByCorners(const State& state, const Selection& selection, Id* triples, Ticker& ticker)
{
  const unsigned char* const kept = selection.kept.data();
  const Index* const corners = state.tables.corners.data();
  const std::uint32_t* const id = state.ranked.id.data();
  const auto count = [=](std::size_t a, std::size_t b)
  { return std::accumulate(kept + a, kept + b, std::size_t(0)); };
  const auto write = [=](std::size_t a, std::size_t b, std::size_t place)
  {
    for (std::size_t t = a; t != b; ++t)
    {
      if (kept[t])
      {
        for (unsigned k = 0; k < 3; ++k)
        {
          triples[3 * place + k] = static_cast<Id>(id[corners[3 * t + k]]);
        }
        ++place;
      }
    }
    return place;
  };
  return countAndWrite(
    selection.kept.size(), ticker, count, [](std::size_t) {}, write);
}

/// Zeros.
template <typename Number>
Status writeAll(
  Triangulation& triangulation, Number* numbers, std::size_t count, const Context& context)
{
  if (count == 0)
  {
    return Status::Ok;
  }
  return withTicker(triangulation, count, context,
    [=](const State&, Ticker& ticker)
    {
      return inShares(count, ticker, 4, kChunk,
        [=](std::size_t a, std::size_t b) { std::fill(numbers + a, numbers + b, Number(0)); });
    });
}

/// Finds out which triangles no constraint edge separates, by joining sets of slots. In the end
/// each slot has the number of its set, and sets are numbered as they appear among the cells.
class RegionFinder
{
public:
  /// Borrows both.
  RegionFinder(const State& state, const Selected& selected)
    : state_(state)
    , selected_(selected)
  {
  }

  /// Writes the region of each selected triangle. Returns false if the work is cancelled, as
  /// all below; throws std::bad_alloc.
  template <typename Id>
  bool write(Id* out, Ticker& ticker)
  {
    return join(ticker) && nameSets(ticker) && numberSets(ticker) &&
      selected_.each(TriangleArray(out, 1), ticker,
        [&](std::size_t place, std::size_t slot, const OrderedTriangle&)
        { out[place] = static_cast<Id>(regionOf_[setOf_[slot]]); });
  }

private:
  bool isKept(std::size_t slot) const
  {
    return state_.numbers[slot] != kNotExtracted && (state_.marksOf(slot) & kDropped) == 0;
  }

  bool join(Ticker& ticker);
  bool joinTo(std::uint32_t slot, std::uint32_t other, Ticker& ticker);
  bool findRoot(std::uint32_t& slot, Ticker& ticker);
  bool nameSets(Ticker& ticker);
  bool numberSets(Ticker& ticker);

  const State& state_;
  const Selected& selected_;
  Buffer<std::uint32_t> setOf_; ///< of each slot; first one of its set before it, or itself
  std::uint32_t sets_ = 0;
  std::vector<std::uint32_t> regionOf_; ///< of each set
};

bool RegionFinder::join(Ticker& ticker)
{
  const std::uint32_t* const data = state_.mesh.data();
  setOf_.allocate(state_.numbers.size());
  for (std::uint32_t slot = 0; slot != setOf_.size(); ++slot)
  {
    setOf_[slot] = isKept(slot) ? slot : kNoIndex;
    const unsigned marks = state_.marksOf(slot);
    for (unsigned e = 0; e < 3 && setOf_[slot] != kNoIndex; ++e)
    {
      const std::uint32_t other = data[slot * Mesh::kSlotSize + Mesh::kTwin + e] / Mesh::kSlotSize;
      if (other < slot && (marks >> e & 1u) == 0 && setOf_[other] != kNoIndex &&
        !joinTo(slot, other, ticker))
      {
        return false;
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// Of two sets the root is the first slot of both.
bool RegionFinder::joinTo(std::uint32_t slot, std::uint32_t other, Ticker& ticker)
{
  if (!findRoot(slot, ticker) || !findRoot(other, ticker))
  {
    return false;
  }
  setOf_[std::max(slot, other)] = std::min(slot, other);
  return true;
}

/// Finds the root; on the way, each slot is linked to its grandparent.
bool RegionFinder::findRoot(std::uint32_t& slot, Ticker& ticker)
{
  while (setOf_[slot] != slot)
  {
    setOf_[slot] = setOf_[setOf_[slot]];
    slot = setOf_[slot];
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// A slot before it in the same set has its name already.
bool RegionFinder::nameSets(Ticker& ticker)
{
  return inChunks(0, setOf_.size(), ticker,
    [this](std::size_t a, std::size_t b)
    {
      for (std::size_t slot = a; slot != b; ++slot)
      {
        if (setOf_[slot] != kNoIndex)
        {
          setOf_[slot] = setOf_[slot] == slot ? sets_++ : setOf_[setOf_[slot]];
        }
      }
    });
}

bool RegionFinder::numberSets(Ticker& ticker)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> firsts(sets_); // place of a cell, set
  const auto begin = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t set = a; set != b; ++set)
    {
      firsts[set] = { kNoIndex, static_cast<std::uint32_t>(set) };
    }
  };
  const auto look = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t slot = a; slot != b; ++slot)
    {
      if (setOf_[slot] != kNoIndex)
      {
        std::uint32_t& first = firsts[setOf_[slot]].first;
        first = std::min(first, selected_.placeOfSlot(slot));
      }
    }
  };
  regionOf_.resize(sets_);
  const auto number = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      regionOf_[firsts[i].second] = static_cast<std::uint32_t>(i);
    }
  };
  return inChunks(0, sets_, ticker, begin) && inChunks(0, setOf_.size(), ticker, look) &&
    sortAsking(firsts, ticker, std::less<>()) && inChunks(0, sets_, ticker, number);
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
  if (hasCornersOnly(triangulation, selection))
  {
    return withTicker(triangulation, selection.kept.size(), context,
      [&](const State& state, Ticker& ticker)
      { return writeByCorners(state, selection, triples, ticker); });
  }
  return withSelected(triangulation, selection, context,
    [&](const State& state, const Selected& selected, Ticker& ticker)
    {
      return selected.each(TriangleArray(triples, 3), ticker,
        [&](std::size_t place, std::size_t, const OrderedTriangle& triangle)
        {
          for (unsigned k = 0; k < 3; ++k)
          {
            triples[3 * place + k] = static_cast<Id>(state.ranked.id[triangle.corner(k)]);
          }
        });
    });
}

template <typename Id>
Status writeNeighbors(
  Triangulation& triangulation, const Selection& selection, Id* neighbors, const Context& context)
{
  const NeighborWriter<Id> writer(selection, neighbors);
  return withSelected(triangulation, selection, context,
    [&](const State&, const Selected& selected, Ticker& ticker)
    {
      return selected.each(writer.array(), ticker,
        [&](std::size_t place, std::size_t, const OrderedTriangle& triangle)
        { writer.write(selected, place, triangle); });
    });
}

template <typename Id>
Status writeWithNeighbors(Triangulation& triangulation, const Selection& selection,
  const CellsWithNeighbors<Id>& to, const Context& context)
{
  const NeighborWriter<Id> writer(selection, to.neighbors);
  return withSelected(triangulation, selection, context,
    [&](const State& state, const Selected& selected, Ticker& ticker)
    {
      const TwoTriangleArrays arrays{ TriangleArray(to.triples, 3), writer.array() };
      return selected.each(arrays, ticker,
        [&, triples = to.triples, ids = state.ranked.id.data()](
          std::size_t place, std::size_t slot, const OrderedTriangle& triangle)
        {
          fetchAround(state, slot);
          for (unsigned k = 0; k < 3; ++k)
          {
            triples[3 * place + k] = static_cast<std::int32_t>(ids[triangle.corner(k)]);
          }
          writer.write(selected, place, triangle);
        });
    });
}

Status writeConstraintEdges(Triangulation& triangulation, const Selection& selection,
  std::uint8_t* edges, const Context& context)
{
  const std::size_t before = cellsBefore(selection);
  if (!hasMarks(triangulation))
  {
    return writeAll(triangulation, edges, cellCount(triangulation, selection), context);
  }
  std::fill(edges, edges + before, std::uint8_t(0));
  return withSelected(triangulation, selection, context,
    [&](const State& state, const Selected& selected, Ticker& ticker)
    {
      return selected.each(TriangleArray(edges + before, 1), ticker,
        [&](std::size_t place, std::size_t slot, const OrderedTriangle& triangle)
        {
          edges[before + place] = Tables::flagOf(
            state.marksOf(slot) & kConstrainedEdges, triangle.lowest());
        });
    });
}

template <typename Id>
Status writeRegions(
  Triangulation& triangulation, const Selection& selection, Id* regions, const Context& context)
{
  const std::size_t before = cellsBefore(selection);
  std::fill(regions, regions + before, Id(-1));
  if (!hasMarks(triangulation)) // a convex polygon is one region
  {
    return writeAll(
      triangulation, regions + before, selectedCount(triangulation, selection), context);
  }
  return withSelected(triangulation, selection, context,
    [&](const State& state, const Selected& selected, Ticker& ticker)
    { return RegionFinder(state, selected).write(regions + before, ticker); });
}

#define AHD_WRITES(Id)                                                                             \
  template Status writeSelected(Triangulation&, const Selection&, Id*, const Context&);            \
  template Status writeNeighbors(Triangulation&, const Selection&, Id*, const Context&);           \
  template Status writeWithNeighbors(                                                              \
    Triangulation&, const Selection&, const CellsWithNeighbors<Id>&, const Context&);              \
  template Status writeRegions(Triangulation&, const Selection&, Id*, const Context&)

AHD_WRITES(int);
AHD_WRITES(long);
AHD_WRITES(long long);

#undef AHD_WRITES

} // namespace ahd
