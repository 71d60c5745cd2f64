// SPDX-License-Identifier: BSD-3-Clause
#include "CornerNumbers.h"

#include "../Core/Loops.h"

#include <algorithm>

namespace ahd
{

bool CornerNumbers::begin(const Buffer<Index>& cellOf, Ticker& ticker)
{
  centres_ = diagram_.triangles();
  first_.allocate(centres_);
  number_.allocate(centres_);
  const auto find = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t t = a; t != b; ++t)
    {
      const HalfEdge h = static_cast<HalfEdge>(3 * t);
      first_[t] = std::min(std::min(cellOf[diagram_.origin(h)], cellOf[diagram_.origin(h + 1)]),
        cellOf[diagram_.origin(h + 2)]);
      number_[t] = kNoCorner;
    }
  };
  return inShares(centres_, ticker, 8, 1 << 14, find) &&
    (!diagram_.hasJoined() || joinFirst(ticker));
}

/// Of the triangles for which a centre stands, those inside have it as a corner of their cells; the
/// triangle itself may be outside.
bool CornerNumbers::joinFirst(Ticker& ticker)
{
  const auto leaveOut = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t t = a; t != b; ++t)
    {
      if (!border_.isInside(t) && diagram_.standIn(t) == t)
      {
        first_[t] = kNoIndex;
      }
    }
  };
  const auto join = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t t = a; t != b; ++t)
    {
      const std::size_t by = diagram_.standIn(t);
      if (by != t && border_.isInside(t))
      {
        first_[by] = std::min(first_[by], first_[t]);
      }
    }
  };
  return inChunks(0, centres_, ticker, leaveOut) && inChunks(0, centres_, ticker, join);
}

void CornerNumbers::beginBorder()
{
  const std::size_t count = border_.corners() - centres_;
  borderFirst_.assign(count, kNoIndex);
  borderNumber_.assign(count, kNoCorner);
}

} // namespace ahd
