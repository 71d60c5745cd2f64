// SPDX-License-Identifier: BSD-3-Clause
#include "Cells.h"

#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"

#include <functional>
#include <utility>

namespace ahd
{

bool CellWalk::walk(Ticker& ticker)
{
  const DelaunayView& delaunay = diagram_.delaunay();
  for (std::size_t site = 0; site < delaunay.points.count; ++site)
  {
    if (!ticker.step() || (diagram_.start(site) != kNoHalfEdge && !addCell(site, ticker)))
    {
      return false;
    }
    ticker.finished(1);
  }
  return true;
}

bool CellWalk::addCell(std::size_t site, Ticker& ticker)
{
  cell_.clear();
  const HalfEdge start = diagram_.start(site);
  const bool isOpen = diagram_.twin(start) == kNoHalfEdge;
  HalfEdge h = start;
  do
  {
    append(site, border_.piece(h));
    const HalfEdge back = previousInTriangle(h);
    h = diagram_.twin(back);
    if (h == kNoHalfEdge)
    {
      append(site, turned(border_.piece(back)));
    }
    if (!ticker.step())
    {
      return false;
    }
  } while (h != start && h != kNoHalfEdge);
  close(site, isOpen);
  end(site);
  return true;
}

bool CellWalk::walkStrips(const std::vector<std::int64_t>& line, BoxBorder& border, Ticker& ticker)
{
  std::vector<Piece> between(line.size() + 1);
  for (std::size_t i = 0; i + 1 < line.size() && ticker.step(); ++i)
  {
    between[i + 1] = border.chord(diagram_.point(static_cast<std::size_t>(line[i])),
      diagram_.point(static_cast<std::size_t>(line[i + 1])));
  }
  std::vector<std::pair<std::int64_t, std::size_t>> byId(line.size());
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    byId[i] = { line[i], i };
  }
  if (!sortAsking(byId, ticker, std::less<>()))
  {
    return false;
  }
  for (const auto& [id, place] : byId)
  {
    addStrip(static_cast<std::size_t>(id), between[place + 1], turned(between[place]));
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

void CellWalk::addStrip(std::size_t site, const Piece& first, const Piece& second)
{
  cell_.clear();
  append(site, first);
  append(site, second);
  close(site, false);
  end(site);
}

/// One more edge of the cell.
void CellWalk::append(std::size_t site, const Piece& piece)
{
  if (piece.isEmpty())
  {
    return;
  }
  if (cell_.empty())
  {
    cell_.push_back(piece.from);
  }
  else if (cell_.back() != piece.from)
  {
    border_.follow(site, cell_.back(), piece.from, false, cell_);
    cell_.push_back(piece.from);
  }
  if (cell_.back() != piece.to)
  {
    cell_.push_back(piece.to);
  }
}

/// From the last corner back to the first.
void CellWalk::close(std::size_t site, bool isOpen)
{
  if (!cell_.empty() && (isOpen || cell_.back() != cell_.front()))
  {
    border_.follow(site, cell_.back(), cell_.front(), isOpen, cell_);
  }
  while (cell_.size() > 1 && cell_.back() == cell_.front())
  {
    cell_.pop_back();
  }
}

void CellWalk::end(std::size_t site)
{
  if (cell_.size() < 3)
  {
    pad(site);
  }
  cells_.sites.push_back(static_cast<std::int64_t>(site));
  cells_.corners.insert(cells_.corners.end(), cell_.begin(), cell_.end());
  cells_.offsets.push_back(static_cast<std::int64_t>(cells_.corners.size()));
}

/// What is left of the cell is smaller than the coordinates resolve: its vertex stands for the
/// corners that are missing.
void CellWalk::pad(std::size_t site)
{
  while (cell_.size() < 3)
  {
    cell_.push_back(border_.add(diagram_.point(site)));
  }
}

bool CellWalk::number(Ticker& ticker)
{
  std::vector<std::int64_t> numbers(border_.corners(), -1);
  return inChunks(0, cells_.corners.size(), ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const CornerId id = static_cast<CornerId>(cells_.corners[i]);
        if (numbers[id] < 0)
        {
          numbers[id] = static_cast<std::int64_t>(cells_.points.size());
          cells_.points.push_back(border_.corner(id));
        }
        cells_.corners[i] = numbers[id];
      }
    });
}

} // namespace ahd
