// SPDX-License-Identifier: BSD-3-Clause
#include "Representatives.h"

#include "../Core/Chunks.h"

#include <cmath>

namespace ahd
{

namespace
{

/// Which of two points at one place comes first.
class Better
{
public:
  Better(const PointView& points, Representative wanted)
    : points_(points)
    , isHighest_(wanted == Representative::HighestZ)
  {
  }

  /// Is point a better than point b? Any finite z is better than none; ties go to the smaller id.
  bool operator()(Index a, Index b) const
  {
    const double za = z(a), zb = z(b);
    if (!std::isfinite(za) || !std::isfinite(zb))
    {
      return std::isfinite(za) == std::isfinite(zb) ? a < b : std::isfinite(za);
    }
    return za == zb ? a < b : (za > zb) == isHighest_;
  }

private:
  double z(Index i) const { return points_.z(i); }

  const PointView& points_;
  bool isHighest_;
};

} // namespace

bool chooseRepresentatives(
  const PointView& points, Representative wanted, RankedPoints& ranked, Ticker& ticker)
{
  if (wanted == Representative::FirstId || ranked.duplicates.empty())
  {
    return true;
  }
  Buffer<Index> vertexOf; // of the smallest id at each place
  vertexOf.allocate(points.count);
  const Better isBetter(points, wanted);
  const auto number = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t vertex = a; vertex != b; ++vertex)
    {
      vertexOf[ranked.id[vertex]] = static_cast<Index>(vertex);
    }
  };
  const auto choose = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      Index& chosen = ranked.id[vertexOf[ranked.duplicates[i].keptId]];
      chosen = isBetter(ranked.duplicates[i].id, chosen) ? ranked.duplicates[i].id : chosen;
    }
  };
  // The one that is chosen leaves its place in the list to the smallest id.
  const auto pass = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      Duplicate& duplicate = ranked.duplicates[i];
      const Index vertex = vertexOf[duplicate.keptId];
      const Index chosen = ranked.id[vertex];
      duplicate = { duplicate.id == chosen ? duplicate.keptId : duplicate.id, chosen };
      ranked.xy[vertex] = points[chosen];
    }
  };
  return inChunks(0, ranked.count, ticker, number) &&
    inChunks(0, ranked.duplicates.size(), ticker, choose) &&
    inChunks(0, ranked.duplicates.size(), ticker, pass);
}

} // namespace ahd
