// SPDX-License-Identifier: BSD-3-Clause
#include "Cells.h"

#include "../Core/Loops.h"

#include <algorithm>
#include <utility>

namespace ahd
{

namespace
{

/// The corners of one cell after the other, of those that do not touch the border.
class CornersAround
{
public:
  CornersAround(const Diagram& diagram, const CellBorder& border)
    : diagram_(diagram)
    , border_(border)
  {
  }

  /// Finds them; none for any other cell. Returns false if cancelled; throws std::bad_alloc.
  bool find(Index vertex, Ticker& ticker);

  const CornerId* begin() const { return corners_.data(); }
  std::size_t size() const { return corners_.size(); }

private:
  const Diagram& diagram_;
  const CellBorder& border_;
  std::vector<CornerId> corners_;
};

bool CornersAround::find(Index vertex, Ticker& ticker)
{
  corners_.clear();
  const HalfEdge start = diagram_.start(vertex);
  const HalfEdge before = diagram_.twin(start);
  if (before == kNoHalfEdge || !border_.isInside(before / 3))
  {
    return true;
  }
  std::size_t last = diagram_.standIn(before / 3);
  corners_.push_back(static_cast<CornerId>(last));
  for (HalfEdge h = start; h != nextInTriangle(before); h = diagram_.twin(previousInTriangle(h)))
  {
    if (!border_.isInside(h / 3))
    {
      corners_.clear();
      return true;
    }
    if (const std::size_t corner = diagram_.standIn(h / 3); corner != last)
    {
      corners_.push_back(static_cast<CornerId>(corner));
      last = corner;
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  if (corners_.size() > 1 && corners_.back() == corners_.front())
  {
    corners_.pop_back();
  }
  if (corners_.size() < 3)
  {
    corners_.clear();
  }
  return true;
}

} // namespace

bool CellWalk::walk(Ticker& ticker)
{
  const std::size_t vertices = cellOf_.size();
  const std::size_t tasks = tasksFor(threadsOf(ticker), vertices, 8, 1 << 13);
  std::vector<std::vector<Index>> others(tasks);
  const auto measure = [&](std::size_t task, Ticker& own)
  { return measureShare(Share(vertices, task, tasks), own, others[task]); };
  const auto write = [&](std::size_t task, Ticker& own)
  { return writeShare(Share(vertices, task, tasks), own); };
  return numbers_.begin(cellOf_, ticker) && beginExtents(ticker) &&
    inParallel(ticker, tasks, measure) && addBorderCells(others, ticker) &&
    countBorderCells(ticker) && sumUp(ticker) && place(ticker) &&
    inParallel(ticker, tasks, write) && copyBorderCells(ticker);
}

bool CellWalk::beginExtents(Ticker& ticker)
{
  extents_.allocate(cells_.sites.size() + 1);
  extents_[cells_.sites.size()] = Extent();
  return ticker.ask();
}

/// Vertices whose cells may touch the border or have too few corners go to `others`.
bool CellWalk::measureShare(const Share& vertices, Ticker& ticker, std::vector<Index>& others)
{
  CornersAround corners(diagram_, border_);
  for (std::size_t v = vertices.begin; v != vertices.end; ++v)
  {
    if (!ticker.step())
    {
      return false;
    }
    const std::size_t later = std::min(v + kAhead, cellOf_.size() - 1);
    prefetchForWrite(extents_.data() + (cellOf_[later] == kNoIndex ? 0 : cellOf_[later]));
    const Index cell = cellOf_[v];
    if (cell == kNoIndex)
    {
      continue;
    }
    const Index vertex = static_cast<Index>(v);
    if (!corners.find(vertex, ticker))
    {
      return false;
    }
    if (corners.size() == 0)
    {
      others.push_back(vertex);
    }
    extents_[cell] = { static_cast<std::uint32_t>(corners.size()),
      numbers_.count(cell, corners.begin(), corners.size()) };
  }
  ticker.finished(vertices.end - vertices.begin);
  return true;
}

bool CellWalk::addBorderCells(const std::vector<std::vector<Index>>& vertices, Ticker& ticker)
{
  for (const std::vector<Index>& some : vertices)
  {
    for (const Index vertex : some)
    {
      if (!turnAtBorder(vertex, ticker))
      {
        return false;
      }
    }
  }
  return true;
}

/// Each of their corners belongs to several of them: all have to be noted first.
bool CellWalk::countBorderCells(Ticker& ticker)
{
  numbers_.beginBorder();
  for (const BorderCell& cell : borderCells_)
  {
    for (std::size_t i = cell.begin; i != cell.end; ++i)
    {
      numbers_.noteBorder(borderCorners_[i], cellOf_[cell.vertex]);
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  for (const BorderCell& cell : borderCells_)
  {
    const std::size_t size = cell.end - cell.begin;
    const Index number = cellOf_[cell.vertex];
    std::uint32_t points = 0;
    const bool counted = inChunks(cell.begin, cell.end, ticker,
      [&](std::size_t a, std::size_t b)
      { points = numbers_.count(number, borderCorners_.data() + a, b - a, points); });
    if (!counted)
    {
      return false;
    }
    extents_[number] = { static_cast<std::uint32_t>(size), points };
  }
  return true;
}

/// From how much each cell has to where it begins; makes room for all.
bool CellWalk::sumUp(Ticker& ticker)
{
  const std::size_t tasks = tasksForLoop(ticker, extents_.size());
  std::vector<Extent> sums(tasks);
  const auto add = [&](std::size_t task, Ticker& own)
  {
    Extent sum; // on the stack: no thread waits for a line of another
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

/// Numbers the corners and writes where they are.
bool CellWalk::place(Ticker& ticker)
{
  Point* const points = cells_.points.data();
  return numbers_.finish(
    ticker, [this](Index cell) -> const std::uint32_t& { return extents_[cell].points; },
    [points](std::uint32_t number, const Point& place) { points[number] = place; });
}

bool CellWalk::writeShare(const Share& vertices, Ticker& ticker)
{
  CornersAround corners(diagram_, border_);
  const std::size_t last = cellOf_.size() - 1;
  const auto extent = [&](std::size_t v)
  { return extents_.data() + (cellOf_[v] == kNoIndex ? 0 : cellOf_[v]); };
  for (std::size_t v = vertices.begin; v != vertices.end; ++v)
  {
    if (!ticker.step())
    {
      return false;
    }
    prefetchForRead(extent(std::min(v + 2 * kAhead, last)));
    prefetchForWrite(cells_.corners.data() + extent(std::min(v + kAhead, last))->corners);
    if (cellOf_[v] == kNoIndex)
    {
      continue;
    }
    if (!corners.find(static_cast<Index>(v), ticker))
    {
      return false;
    }
    std::int32_t* const to = cells_.corners.data() + extent(v)->corners;
    for (std::size_t i = 0; i != corners.size(); ++i)
    {
      to[i] = static_cast<std::int32_t>(numbers_.ofCentre(corners.begin()[i]));
    }
  }
  ticker.finished(vertices.end - vertices.begin);
  return true;
}

bool CellWalk::copyBorderCells(Ticker& ticker)
{
  for (const BorderCell& cell : borderCells_)
  {
    std::int32_t* const to = cells_.corners.data() + extents_[cellOf_[cell.vertex]].corners;
    const bool copied = inChunks(cell.begin, cell.end, ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i != b; ++i)
        {
          to[i - cell.begin] = static_cast<std::int32_t>(numbers_[borderCorners_[i]]);
        }
      });
    if (!copied)
    {
      return false;
    }
  }
  return true;
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

bool CellWalk::walkStrips(const std::vector<Index>& line, BoxBorder& border, Ticker& ticker)
{
  ClippedEdge before;
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
  return beginExtents(ticker) && numbers_.begin(cellOf_, ticker) && countBorderCells(ticker) &&
    sumUp(ticker) && place(ticker) && copyBorderCells(ticker);
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
  if (cell_.size() < 3)
  {
    pad(vertex);
  }
  const std::size_t begin = borderCorners_.size();
  borderCorners_.insert(borderCorners_.end(), cell_.begin(), cell_.end());
  borderCells_.push_back({ vertex, begin, borderCorners_.size() });
}

/// What is left of the cell is smaller than the coordinates resolve: its vertex stands for the
/// corners that are missing.
void CellWalk::pad(Index vertex)
{
  while (cell_.size() < 3)
  {
    cell_.push_back(border_.add(diagram_.point(vertex)));
  }
}

} // namespace ahd
