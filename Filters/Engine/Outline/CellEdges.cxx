// SPDX-License-Identifier: BSD-3-Clause
#include "CellEdges.h"

#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "../Order/RadixSort.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ahd
{
namespace
{

constexpr Index kUnseen = kNoIndex - 1; ///< the state of a cell that is to be turned yet

/// Equal places have equal hashes.
std::uint32_t hashOf(const std::array<double, 3>& place)
{
  std::uint64_t hash = 0;
  for (const double number : place)
  {
    const double withOneZero = number + 0.0;
    std::uint64_t bits;
    std::memcpy(&bits, &withOneZero, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return static_cast<std::uint32_t>(hash * 0x9E3779B97F4A7C15u >> 32);
}

} // namespace

bool CellEdges::make(Ticker& ticker)
{
  return mergePlaces(ticker) && read(ticker) && join(ticker) && spread(ticker);
}

/// Points that are not finite stay as they are, and so do those of directed cells.
bool CellEdges::mergePlaces(Ticker& ticker)
{
  const PointView& points = request_.points;
  Buffer<std::uint64_t> items, other;
  points_.allocate(points.count);
  items.allocate(points.count);
  std::size_t count = 0, end = 0;
  const auto take = [&](std::size_t i)
  {
    const auto id = static_cast<Index>(i);
    points_[i] = id;
    if (!request_.isDirected && isFinite(points[i]) && std::isfinite(points.z(i)))
    {
      items[count++] = packed(hashOf(points.place(i)), id);
    }
  };
  if (!inSteps(0, points.count, ticker, take) || !sortPacked(items, count, ticker))
  {
    return false;
  }
  for (std::size_t begin = 0; begin < count; begin = end)
  {
    for (end = begin + 1; end < count && items[end] >> 32 == items[begin] >> 32; ++end)
    {
      if (!ticker.step())
      {
        return false;
      }
    }
    if (!ticker.step() ||
      (end - begin > 1 && !mergeAlike(items.data() + begin, end - begin, other, ticker)))
    {
      return false;
    }
  }
  return true;
}

/// Of points with one hash.
bool CellEdges::mergeAlike(
  std::uint64_t* items, std::size_t count, Buffer<std::uint64_t>& other, Ticker& ticker)
{
  const PointView& points = request_.points;
  const auto placeOf = [&points](std::uint64_t item)
  { return points.place(static_cast<Index>(item)); };
  const auto isLess = [&placeOf](std::uint64_t a, std::uint64_t b)
  {
    const auto p = placeOf(a), q = placeOf(b);
    return p != q ? p < q : a < b;
  };
  const auto merge = [&](std::size_t k)
  {
    if (placeOf(items[k]) == placeOf(items[k - 1]))
    {
      points_[static_cast<Index>(items[k])] = points_[static_cast<Index>(items[k - 1])];
    }
  };
  other.allocate(std::max(other.size(), count > kChunk ? count : 0));
  return sortAsking(items, count, other.data(), ticker, isLess) && inSteps(1, count, ticker, merge);
}

bool CellEdges::read(Ticker& ticker)
{
  const CellsView& cells = request_.cells;
  corners_.allocate(cells.ids);
  twins_.allocate(cells.ids);
  states_.allocate(cells.cells);
  bool areTriangles = cells.ids == 3 * cells.cells;
  for (std::size_t c = 0; areTriangles && c < cells.cells; ++c)
  {
    areTriangles = offset(c) == 3 * c;
    if (!ticker.step())
    {
      return false;
    }
  }
  cells_.allocate(areTriangles ? 0 : cells.ids);
  if (!fillAll(twins_, kNull, ticker)) // offsets need not begin at 0, nor end at the last id
  {
    return false;
  }
  for (std::size_t c = 0; c < cells.cells; ++c)
  {
    if (!ticker.step() || !readCell(static_cast<Index>(c), ticker))
    {
      return false;
    }
  }
  ticker.finished(cells.ids);
  return ticker.ask();
}

/// Its corners, and whether there are three distinct ones or more.
bool CellEdges::readCell(Index cell, Ticker& ticker)
{
  const std::size_t begin = offset(cell), end = offset(cell + 1);
  bool arePoints = true, isFit = false;
  Index first = kNoIndex, second = kNoIndex;
  for (std::size_t h = begin; h < end; ++h)
  {
    const Index corner = cornerAt(h);
    corners_[h] = corner;
    if (!cells_.empty())
    {
      cells_[h] = cell;
    }
    arePoints = arePoints && corner != kNoIndex;
    first = h == begin ? corner : first;
    isFit = isFit || (second != kNoIndex && corner != first && corner != second);
    second = corner != first ? corner : second;
    if (!ticker.step())
    {
      return false;
    }
  }
  const bool isWanted = !request_.groups || !std::isnan(request_.groups[cell]);
  isFit = isFit && arePoints;
  states_[cell] = isWanted && isFit ? kUnseen : kNoIndex;
  unfitCells_ += isWanted && !isFit ? 1 : 0;
  for (std::size_t h = begin; h < end; ++h)
  {
    const Index next = corners_[h + 1 == end ? begin : h + 1];
    twins_[h] = isWanted && isFit && corners_[h] != next ? kBoundary : kNull;
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// kNoIndex if it is no point, or not finite.
Index CellEdges::cornerAt(std::size_t k) const
{
  const std::int64_t id = request_.cells.ids32 ? request_.cells.ids32[k] : request_.cells.ids64[k];
  const bool isPoint = id >= 0 && static_cast<std::uint64_t>(id) < request_.points.count &&
    isFinite(request_.points[static_cast<std::size_t>(id)]);
  return isPoint ? points_[static_cast<std::size_t>(id)] : kNoIndex;
}

/// Lists all edges by their smaller ends: that of vertex v begins at heads[v].
bool CellEdges::list(Buffer<Index>& heads, Buffer<Entry>& entries, Ticker& ticker)
{
  const auto forAll = [&](const auto& work)
  {
    return inSteps(0, count(), ticker,
      [&](std::size_t k)
      {
        const auto h = static_cast<CellEdge>(k);
        if (!isNull(h))
        {
          const Index a = corners_[h], b = corners_[nextGiven(h)];
          work(h, std::min(a, b), std::max(a, b));
        }
      });
  };
  const std::size_t points = request_.points.count;
  heads.allocate(points + 2);
  // counted two places on, so that writing leaves them one place on
  if (!fillAll(heads, 0u, ticker) ||
    !forAll([&](CellEdge, Index low, Index) { ++heads[low + 2]; }) ||
    !inSteps(2, points + 2, ticker, [&](std::size_t v) { heads[v] += heads[v - 1]; }))
  {
    return false;
  }
  entries.allocate(heads[points + 1]);
  return forAll(
    [&](CellEdge h, Index low, Index high) {
      entries[heads[low + 1]++] = { high, h };
    });
}

bool CellEdges::join(Ticker& ticker)
{
  Buffer<Index> heads;
  Buffer<Entry> entries;
  ListScratch scratch(ticker);
  if (!list(heads, entries, ticker))
  {
    return false;
  }
  boundary_ = entries.size();
  for (std::size_t v = 0; v < request_.points.count; ++v)
  {
    Entry* const begin = entries.data() + heads[v];
    if (!ticker.step() || !joinAt(begin, entries.data() + heads[v + 1], scratch, ticker))
    {
      return false;
    }
  }
  ticker.finished(count());
  return ticker.ask();
}

/// Joins the edges of one smaller end.
bool CellEdges::joinAt(Entry* first, Entry* last, ListScratch& scratch, Ticker& ticker)
{
  const double* const groups = request_.groups;
  const auto groupOf = [&](const Entry& entry)
  { return groups ? groups[cellOf(entry.edge)] : 0.0; };
  const auto isLess = [&](const Entry& a, const Entry& b)
  {
    const double g = groupOf(a), h = groupOf(b);
    return a.other != b.other ? a.other < b.other : g != h ? g < h : a.edge < b.edge;
  };
  const auto size = static_cast<std::size_t>(last - first);
  if (size > kChunk && scratch.entries.size() < size)
  {
    scratch.taken.atLeast(size * sizeof(Entry));
    scratch.entries.allocate(size);
  }
  if (!sortAsking(first, size, scratch.entries.data(), ticker, isLess))
  {
    return false;
  }
  while (first != last)
  {
    Entry* end = first;
    const double group = groupOf(*first);
    while (end != last && end->other == first->other && groupOf(*end) == group)
    {
      ++end;
      if (!ticker.step())
      {
        return false;
      }
    }
    joinRun(first, end);
    first = end;
  }
  return true;
}

/// Joins edges with the same ends, of cells alike, if two are left after those that a cell passes
/// both ways.
void CellEdges::joinRun(Entry* first, Entry* last)
{
  const auto joinTwo = [this](CellEdge a, CellEdge b)
  {
    twins_[a] = b;
    twins_[b] = a;
    boundary_ -= 2;
  };
  Entry* left = first;
  for (Entry* entry = first; entry != last; ++entry)
  {
    const bool isBothWays = left != first && cellOf(left[-1].edge) == cellOf(entry->edge) &&
      corners_[left[-1].edge] != corners_[entry->edge];
    if (isBothWays)
    {
      joinTwo((--left)->edge, entry->edge);
    }
    else
    {
      *left++ = *entry;
    }
  }
  if (left - first == 2)
  {
    joinTwo(first[0].edge, first[1].edge);
  }
  unfitEdges_ += left - first > 2 ? 1 : 0;
}

bool CellEdges::spread(Ticker& ticker)
{
  Buffer<Index> stack;
  stack.allocate(request_.cells.cells);
  for (std::size_t c = 0; c < request_.cells.cells; ++c)
  {
    if (!ticker.step() ||
      (states_[c] == kUnseen && !spreadFrom(static_cast<Index>(c), stack, ticker)))
    {
      return false;
    }
  }
  ticker.finished(count());
  return ticker.ask();
}

/// A component: turns its cells like this one.
bool CellEdges::spreadFrom(Index cell, Buffer<Index>& stack, Ticker& ticker)
{
  std::array<double, 3> sums = {};
  std::size_t size = 1;
  stack[0] = cell;
  states_[cell] = static_cast<Index>(2 * components_);
  while (size > 0)
  {
    const Index now = stack[--size];
    std::array<double, 3> areas = {};
    for (std::size_t k = offset(now); k < offset(now + 1); ++k)
    {
      const auto h = static_cast<CellEdge>(k);
      if (k > offset(now) && k + 1 < offset(now + 1))
      {
        addArea(h, areas);
      }
      if (isJoined(h))
      {
        cross(h, stack, size);
      }
      if (!ticker.step())
      {
        return false;
      }
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      sums[k] += isTurned(now) ? -areas[k] : areas[k];
    }
    areaOfCells_ += std::abs(areas[2]);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    areas_[k] += std::abs(sums[k]);
  }
  ++components_;
  return true;
}

/// Turns the cell across the edge, or checks how it is turned.
void CellEdges::cross(CellEdge h, Buffer<Index>& stack, std::size_t& size)
{
  const CellEdge twin = twins_[h];
  const Index cell = cellOf(h), other = cellOf(twin);
  const bool areAlike = corners_[h] == corners_[twin]; // both begin there, so one must turn
  const Index wanted = states_[cell] ^ (areAlike ? 1u : 0u);
  if (states_[other] == kUnseen)
  {
    states_[other] = wanted;
    stack[size++] = other;
  }
  else if (states_[other] != wanted)
  {
    twins_[h] = twins_[twin] = kBoundary;
    boundary_ += 2;
    ++unfitEdges_;
  }
}

/// Adds twice the area of the edge and its cell's first corner, seen along x, y and z;
/// counterclockwise it is positive. Of edges at that corner it is 0.
void CellEdges::addArea(CellEdge h, std::array<double, 3>& areas) const
{
  const std::array<double, 3> o = request_.points.place(corners_[offset(cellOf(h))]);
  const std::array<double, 3> p = request_.points.place(corners_[h]);
  const std::array<double, 3> q = request_.points.place(corners_[nextGiven(h)]);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    areas[k] += (p[a] - o[a]) * (q[b] - o[b]) - (p[b] - o[b]) * (q[a] - o[a]);
  }
}

/// x, y, if nine tenths of the area there turn one way; also where an area is no number, and of
/// directed cells.
OutlinePlane CellEdges::plane() const
{
  const auto widest = std::max_element(areas_.begin(), areas_.end()) - areas_.begin();
  // nine tenths less one tenth
  const bool isFolded = areas_[2] < 0.8 * areaOfCells_ || areaOfCells_ == 0.0;
  const bool isNumber = std::isfinite(areas_[0] + areas_[1] + areas_[2]);
  return !request_.isDirected && isFolded && isNumber && areas_[std::size_t(widest)] > areas_[2]
    ? static_cast<OutlinePlane>(widest)
    : OutlinePlane::Xy;
}

CellEdge CellEdges::follow(CellEdge h, Ticker& ticker) const
{
  const auto next = [this](CellEdge edge)
  { return isTurned(cellOf(edge)) ? previousGiven(edge) : nextGiven(edge); };
  CellEdge edge = next(h);
  while (isJoined(edge) || isNull(edge))
  {
    edge = next(isNull(edge) ? edge : twins_[edge]);
    if (!ticker.step())
    {
      return kNull;
    }
  }
  return edge;
}

} // namespace ahd
