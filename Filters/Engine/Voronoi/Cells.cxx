// SPDX-License-Identifier: BSD-3-Clause
#include "Cells.h"

#include "../Core/Loops.h"

#include <algorithm>
#include <utility>

namespace ahd
{

bool CellWalk::walk(Ticker& ticker)
{
  const std::size_t vertices = cellOf_.size();
  const std::size_t tasks = tasksFor(threadsOf(ticker), vertices, 8, 1 << 13);
  std::vector<InsideCells> inside;
  inside.reserve(tasks);
  for (std::size_t task = 0; task < tasks; ++task)
  {
    inside.emplace_back(diagram_, border_);
  }
  const auto measure = [&](std::size_t task, Ticker& own)
  { return measureShare(Share(vertices, task, tasks), inside[task], own); };
  const auto write = [&](std::size_t task, Ticker& own)
  { return writeShare(Share(vertices, task, tasks), inside[task], own); };
  return numbers_.begin(cellOf_, ticker) && beginExtents(ticker) &&
    inParallel(ticker, tasks, measure) && addBorderCells(inside, ticker) &&
    countBorderCells(ticker) && sumUp(ticker) && place(ticker) &&
    inParallel(ticker, tasks, write) && copyBorderCells(ticker);
}

bool CellWalk::beginExtents(Ticker& ticker)
{
  extents_.allocate(cells_.sites.size() + 1);
  extents_[cells_.sites.size()] = Extent();
  return ticker.ask();
}

bool CellWalk::measureShare(const Share& vertices, InsideCells& inside, Ticker& ticker)
{
  inside.reserve(vertices.end - vertices.begin);
  for (std::size_t v = vertices.begin; v != vertices.end; ++v)
  {
    if (!ticker.step())
    {
      return false;
    }
    prefetchForWrite(extentOf(v + kAhead));
    const Index cell = cellOf_[v];
    if (cell == kNoIndex)
    {
      continue;
    }
    if (!inside.find(static_cast<Index>(v), ticker))
    {
      return false;
    }
    std::uint32_t points = 0;
    const bool counted = inChunks(0, inside.size(), ticker,
      [&](std::size_t a, std::size_t b)
      { points = numbers_.countCentres(cell, inside.corners() + a, b - a, points); });
    if (!counted)
    {
      return false;
    }
    extents_[cell] = { static_cast<std::uint32_t>(inside.size()), points };
  }
  ticker.finished(vertices.end - vertices.begin);
  inside.fit();
  return true;
}

bool CellWalk::addBorderCells(const std::vector<InsideCells>& inside, Ticker& ticker)
{
  for (const InsideCells& some : inside)
  {
    for (const Index vertex : some.others())
    {
      if (!turnAtBorder(vertex, ticker))
      {
        return false;
      }
    }
  }
  return true;
}

/// Each corner belongs to several of these cells: all must be noted first.
bool CellWalk::countBorderCells(Ticker& ticker)
{
  borderCells_.push_back({ kNoIndex, static_cast<std::uint32_t>(borderCorners_.size()) });
  border_.forget();
  diagram_.forgetStandIns();
  numbers_.beginBorder();
  const auto note = [&](CornerId corner, Index cell, bool) { numbers_.noteBorder(corner, cell); };
  Extent own;
  const auto count = [&](CornerId corner, Index cell, bool isLast)
  {
    own.points = numbers_.count(cell, corner, own.points);
    ++own.corners;
    if (isLast)
    {
      extents_[cell] = std::exchange(own, Extent());
    }
  };
  return forBorderCorners(ticker, note) && forBorderCorners(ticker, count);
}

/// Calls visit(corner, cell, isLast) for each corner of the cells at the border, where cell is its
/// cell's number, and isLast tells whether it is its last corner.
template <typename Visit>
bool CellWalk::forBorderCorners(Ticker& ticker, Visit visit)
{
  auto corner = borderCorners_.begin();
  for (auto k = borderCells_.begin(); k + 1 != borderCells_.end(); ++k)
  {
    const Index cell = cellOf_[k->vertex];
    for (std::uint32_t left = (k + 1)->begin - k->begin; left != 0; --left)
    {
      visit(*corner++, cell, left == 1);
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  return true;
}

/// Turns counts of cells into their first places; makes room for all.
bool CellWalk::sumUp(Ticker& ticker)
{
  const std::size_t tasks = tasksForLoop(ticker, extents_.size());
  std::vector<Extent> sums(tasks);
  const auto add = [&](std::size_t task, Ticker& own)
  {
    Extent sum; // on the stack: no false sharing
    const Share share(extents_.size(), task, tasks);
    const bool done = inChunks(share.begin, share.end, own,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t k = a; k != b; ++k)
        {
          sum.add(extents_[k]);
        }
      });
    sums[task] = sum;
    return done;
  };
  if (!inParallel(ticker, tasks, add))
  {
    return false;
  }
  Extent all;
  for (Extent& sum : sums)
  {
    all.add(std::exchange(sum, all));
  }
  cells_.offsets.allocate(extents_.size());
  cells_.corners.allocate(all.corners);
  cells_.points.allocate(all.points);
  return inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own)
    {
      Extent sum = sums[task];
      const Share share(extents_.size(), task, tasks);
      return inChunks(share.begin, share.end, own,
        [&](std::size_t a, std::size_t b)
        {
          for (std::size_t k = a; k != b; ++k)
          {
            cells_.offsets[k] = static_cast<std::int32_t>(sum.corners);
            sum.add(std::exchange(extents_[k], sum));
          }
        });
    });
}

/// Numbers the corners and writes their coordinates.
bool CellWalk::place(Ticker& ticker)
{
  return numbers_.finish(
    ticker, [this](Index cell) -> const std::uint32_t& { return extents_[cell].points; },
    cells_.points.data());
}

/// The cells that were found come in the order in which they were found.
bool CellWalk::writeShare(const Share& vertices, const InsideCells& inside, Ticker& ticker)
{
  const CornerId* corner = inside.all();
  auto other = inside.others().begin();
  for (std::size_t v = vertices.begin; v != vertices.end; ++v)
  {
    if (!ticker.step())
    {
      return false;
    }
    prefetchForRead(extentOf(v + 2 * kAhead));
    prefetchForWrite(cells_.corners.data() + extentOf(v + kAhead)->corners);
    if (cellOf_[v] == kNoIndex)
    {
      continue;
    }
    if (other != inside.others().end() && *other == v)
    {
      ++other;
      continue;
    }
    const Extent* const extent = extentOf(v);
    std::int32_t* const to = cells_.corners.data() + extent->corners;
    const std::size_t size = extent[1].corners - extent->corners;
    const bool written = inChunks(0, size, ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i != b; ++i)
        {
          to[i] = static_cast<std::int32_t>(numbers_.ofCentre(corner[i]));
        }
      });
    if (!written)
    {
      return false;
    }
    corner += size;
  }
  ticker.finished(vertices.end - vertices.begin);
  return true;
}

bool CellWalk::copyBorderCells(Ticker& ticker)
{
  std::int32_t* to = nullptr;
  return forBorderCorners(ticker,
    [&](CornerId corner, Index cell, bool isLast)
    {
      to = to ? to : cells_.corners.data() + extents_[cell].corners;
      *to = static_cast<std::int32_t>(numbers_[corner]);
      to = isLast ? nullptr : to + 1;
    });
}

bool CellWalk::turnAtBorder(Index vertex, Ticker& ticker)
{
  cell_.clear();
  const HalfEdge start = diagram_.start(vertex);
  const bool isOpen = diagram_.twin(start) == kNoHalfEdge;
  HalfEdge h = start;
  do
  {
    append(vertex, border_.piece(h));
    const HalfEdge back = previousInTriangle(h);
    h = diagram_.twin(back);
    if (h == kNoHalfEdge)
    {
      append(vertex, turned(border_.piece(back)));
    }
    if (!ticker.step())
    {
      return false;
    }
  } while (h != start && h != kNoHalfEdge);
  close(vertex, isOpen);
  keep(vertex);
  return true;
}

bool CellWalk::walkStrips(const std::vector<Index>& line, ConvexBorder& border, Ticker& ticker)
{
  ClippedEdge before;
  if (!beginExtents(ticker))
  {
    return false;
  }
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const ClippedEdge after = i + 1 == line.size()
      ? ClippedEdge{}
      : border.chord(diagram_.point(line[i]), diagram_.point(line[i + 1]));
    addStrip(line[i], after, turned(before));
    before = after;
    if (!ticker.step())
    {
      return false;
    }
  }
  return numbers_.begin(cellOf_, ticker) && countBorderCells(ticker) && sumUp(ticker) &&
    place(ticker) && copyBorderCells(ticker);
}

void CellWalk::addStrip(Index vertex, const ClippedEdge& first, const ClippedEdge& second)
{
  cell_.clear();
  append(vertex, first);
  append(vertex, second);
  close(vertex, false);
  keep(vertex);
}

/// One more edge of the cell.
void CellWalk::append(Index vertex, const ClippedEdge& piece)
{
  if (piece.isEmpty())
  {
    return;
  }
  if (cell_.empty())
  {
    entry_ = piece.entry;
  }
  else if (piece.entry != kNoStretch)
  {
    border_.follow(vertex, { exit_, piece.entry }, false, cell_);
  }
  exit_ = piece.exit;
  addTo(cell_, piece.from);
  addTo(cell_, piece.to);
}

/// From the last corner back to the first.
void CellWalk::close(Index vertex, bool isOpen)
{
  if (!cell_.empty() && entry_ != kNoStretch)
  {
    border_.follow(vertex, { exit_, entry_ }, isOpen, cell_);
  }
  while (cell_.size() > 1 && cell_.back() == cell_.front())
  {
    cell_.pop_back();
  }
}

void CellWalk::keep(Index vertex)
{
  border_.fill(vertex, cell_);
  if (cell_.empty())
  {
    extents_[cellOf_[vertex]] = Extent();
    return;
  }
  borderCells_.push_back({ vertex, static_cast<std::uint32_t>(borderCorners_.size()) });
  borderCorners_.insert(borderCorners_.end(), cell_.begin(), cell_.end());
}

} // namespace ahd
