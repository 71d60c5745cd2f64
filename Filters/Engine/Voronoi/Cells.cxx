// SPDX-License-Identifier: BSD-3-Clause
#include "Cells.h"

#include "../Core/Chunks.h"

#include <algorithm>

namespace ahd
{

bool CellWalk::walk(Ticker& ticker)
{
  const std::size_t vertices = cellOf_.size();
  const std::size_t tasks = tasksFor(threadsOf(ticker), vertices, 8, 1 << 13);
  std::vector<std::vector<Index>> others(tasks);
  cells_.offsets.assign(cells_.sites.size() + 1, 0);
  const auto measure = [&](std::size_t task, Ticker& own)
  { return measureShare(Share(vertices, task, tasks), own, others[task]); };
  const auto write = [&](std::size_t task, Ticker& own)
  { return writeShare(Share(vertices, task, tasks), own); };
  return inParallel(ticker, tasks, measure) && addBorderCells(others, ticker) &&
    toOffsets(ticker) && inParallel(ticker, tasks, write) && copyBorderCells(ticker);
}

/// Calls visit(k, corner) for the k-th corner of a cell that does not touch the border; for a last
/// one too many where it is the first again. `size`: how many there are, 0 for any other cell.
template <typename Visit>
bool CellWalk::turnInside(Index vertex, Ticker& ticker, std::size_t& size, Visit visit) const
{
  size = 0;
  const HalfEdge start = diagram_.start(vertex);
  const HalfEdge before = diagram_.twin(start);
  if (before == kNoHalfEdge || !border_.isInside(before / 3))
  {
    return true;
  }
  const std::size_t first = diagram_.standIn(before / 3);
  std::size_t last = first;
  std::size_t count = 1;
  visit(0, static_cast<CornerId>(first));
  for (HalfEdge h = start; h != nextInTriangle(before); h = diagram_.twin(previousInTriangle(h)))
  {
    if (!border_.isInside(h / 3))
    {
      return true;
    }
    if (const std::size_t corner = diagram_.standIn(h / 3); corner != last)
    {
      visit(count++, static_cast<CornerId>(corner));
      last = corner;
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  count -= count > 1 && last == first ? 1 : 0;
  size = count < 3 ? 0 : count;
  return true;
}

/// The sizes of the cells, in the places where their offsets will stand; vertices whose cells may
/// touch the border or have too few corners go to `others`.
bool CellWalk::measureShare(const Share& vertices, Ticker& ticker, std::vector<Index>& others)
{
  for (std::size_t v = vertices.begin; v != vertices.end; ++v)
  {
    const Index vertex = static_cast<Index>(v);
    std::size_t size = 0;
    if (!ticker.step())
    {
      return false;
    }
    if (cellOf_[v] == kNoIndex)
    {
      continue;
    }
    if (!turnInside(vertex, ticker, size, [](std::size_t, CornerId) {}))
    {
      return false;
    }
    if (size == 0)
    {
      others.push_back(vertex);
    }
    cells_.offsets[cellOf_[v] + std::size_t(1)] = static_cast<std::int32_t>(size);
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

/// Sums the sizes up, and makes room for the corners.
bool CellWalk::toOffsets(Ticker& ticker)
{
  for (const BorderCell& cell : borderCells_)
  {
    cells_.offsets[cellOf_[cell.vertex] + std::size_t(1)] = static_cast<std::int32_t>(
      cell.end - cell.begin);
  }
  std::int32_t sum = 0;
  const auto sumUp = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      sum += cells_.offsets[k];
      cells_.offsets[k] = sum;
    }
  };
  if (!inChunks(0, cells_.offsets.size(), ticker, sumUp))
  {
    return false;
  }
  cells_.corners.resize(static_cast<std::size_t>(sum));
  return true;
}

bool CellWalk::writeShare(const Share& vertices, Ticker& ticker)
{
  for (std::size_t v = vertices.begin; v != vertices.end; ++v)
  {
    if (!ticker.step())
    {
      return false;
    }
    if (cellOf_[v] == kNoIndex)
    {
      continue;
    }
    const std::int32_t* const offset = cells_.offsets.data() + cellOf_[v];
    std::int32_t* const corners = cells_.corners.data() + offset[0];
    const std::size_t room = static_cast<std::size_t>(offset[1] - offset[0]);
    std::size_t size = 0;
    const auto put = [&](std::size_t k, CornerId corner)
    {
      if (k < room) // of a border cell whatever fits: it is written again
      {
        corners[k] = static_cast<std::int32_t>(corner);
      }
    };
    if (!turnInside(static_cast<Index>(v), ticker, size, put))
    {
      return false;
    }
  }
  ticker.finished(vertices.end - vertices.begin);
  return true;
}

bool CellWalk::copyBorderCells(Ticker& ticker)
{
  for (const BorderCell& cell : borderCells_)
  {
    const std::int32_t to = cells_.offsets[cellOf_[cell.vertex]];
    const bool copied = inChunks(cell.begin, cell.end, ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i != b; ++i)
        {
          cells_.corners[static_cast<std::size_t>(to) + (i - cell.begin)] =
            static_cast<std::int32_t>(borderCorners_[i]);
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
  cells_.offsets.assign(cells_.sites.size() + 1, 0);
  return toOffsets(ticker) && copyBorderCells(ticker);
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

bool CellWalk::number(Ticker& ticker)
{
  constexpr std::size_t kAhead = 32; // what is looked at that many corners later is fetched
  std::vector<BorderCell>().swap(borderCells_);
  std::vector<CornerId>().swap(borderCorners_);
  diagram_.forgetStandIns();
  Buffer<std::uint32_t> numbers;
  numbers.allocate(border_.corners());
  cells_.points.reserve(border_.corners());
  std::int32_t* const corners = cells_.corners.data();
  const std::size_t count = cells_.corners.size();
  return fillAll(numbers, kNoCorner, ticker) &&
    inChunks(0, count, ticker,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const CornerId later = static_cast<CornerId>(corners[std::min(i + kAhead, count - 1)]);
          prefetchForWrite(numbers.data() + later);
          const CornerId id = static_cast<CornerId>(corners[i]);
          if (numbers[id] == kNoCorner)
          {
            numbers[id] = static_cast<std::uint32_t>(cells_.points.size());
            cells_.points.push_back(border_.corner(id));
          }
          corners[i] = static_cast<std::int32_t>(numbers[id]);
        }
      });
}

} // namespace ahd
