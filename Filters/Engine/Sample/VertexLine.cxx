// SPDX-License-Identifier: BSD-3-Clause
#include "VertexLine.h"

#include "../Core/SortAsking.h"
#include "../Predicates/Predicates.h"

#include <algorithm>

namespace ahd
{

bool VertexLine::build(const TriangulationAccess::State& state, Ticker& ticker)
{
  places_ = state.ranked.xy.data();
  Buffer<Index> other;
  other.allocate(state.ranked.count);
  const auto isBefore = [this](Index a, Index b)
  { return lexicographicallyLess(places_[a], places_[b]); };
  return listInserted(state, vertices_, ticker) &&
    sortAsking(vertices_.data(), vertices_.size(), other.data(), ticker, isBefore);
}

const Index* VertexLine::lowerBound(const Point& place) const
{
  return std::lower_bound(vertices_.begin(), vertices_.end(), place,
    [this](Index v, const Point& p) { return lexicographicallyLess(places_[v], p); });
}

void VertexLine::pieceAt(Index vertex, Index (&ends)[2]) const
{
  if (vertices_.size() < 2)
  {
    return;
  }
  const Index* const found = lowerBound(places_[vertex]);
  const Index* const begin = found + 1 == vertices_.end() ? found - 1 : found;
  ends[0] = begin[0];
  ends[1] = begin[1];
}

std::size_t VertexLine::neighborsOf(const Point& place, Index (&neighbors)[2]) const
{
  // The line is exactly that of any two of them.
  const Index* const after = lowerBound(place);
  if (after == vertices_.end())
  {
    return 0;
  }
  neighbors[0] = *after;
  if (places_[*after] == place)
  {
    return 1;
  }
  if (after == vertices_.begin() || orient2d(places_[after[-1]], places_[*after], place) != 0)
  {
    return 0;
  }
  neighbors[0] = after[-1];
  neighbors[1] = *after;
  return 2;
}

} // namespace ahd
