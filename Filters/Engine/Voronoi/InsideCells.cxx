// SPDX-License-Identifier: BSD-3-Clause
#include "InsideCells.h"

#include <algorithm>
#include <utility>

namespace ahd
{

void InsideCells::resize(std::size_t room)
{
  Buffer<CornerId> other;
  other.allocate(room);
  std::copy(corners_.begin(), corners_.begin() + end_, other.begin());
  corners_ = std::move(other);
}

bool InsideCells::find(Index vertex, Ticker& ticker)
{
  begin_ = end_;
  bool isInside = false;
  if (!turn(vertex, ticker, isInside))
  {
    return false;
  }
  if (size() > 1 && corners_[begin_] == corners_[end_ - 1])
  {
    --end_;
  }
  if (!isInside || size() < 3)
  {
    end_ = begin_;
    if (isInside || !isBeyond(vertex))
    {
      others_.push_back(vertex);
    }
  }
  return true;
}

/// Do all corners of the vertex's cell lie beyond one side of the border's bounds?
bool InsideCells::isBeyond(Index vertex) const
{
  const HalfEdge start = diagram_.start(vertex);
  unsigned sides = diagram_.twin(start) == kNoHalfEdge ? 0 : border_.sidesBeyond(start / 3);
  for (HalfEdge h = start; sides != 0;)
  {
    h = diagram_.twin(previousInTriangle(h));
    if (h == start)
    {
      return true;
    }
    sides &= border_.sidesBeyond(h / 3);
  }
  return false;
}

/// Turns around the vertex, from the triangle to the right of its first half-edge, and lists the
/// centres; successive equal ones once.
bool InsideCells::turn(Index vertex, Ticker& ticker, bool& isInside)
{
  const HalfEdge start = diagram_.start(vertex);
  const HalfEdge before = diagram_.twin(start);
  if (before == kNoHalfEdge || !border_.isInside(before / 3))
  {
    return true;
  }
  std::size_t last = diagram_.standIn(before / 3);
  push(last);
  for (HalfEdge h = start; h != nextInTriangle(before); h = diagram_.twin(previousInTriangle(h)))
  {
    if (!border_.isInside(h / 3))
    {
      return true;
    }
    if (const std::size_t corner = diagram_.standIn(h / 3); corner != last)
    {
      push(corner);
      last = corner;
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  isInside = true;
  return true;
}

} // namespace ahd
