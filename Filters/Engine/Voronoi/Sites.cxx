// SPDX-License-Identifier: BSD-3-Clause
#include "Sites.h"

#include "../Core/Loops.h"
#include "../Points/JoinedBounds.h"
#include "Circumcentre.h"

#include <algorithm>
#include <vector>

namespace ahd
{

namespace
{

using State = TriangulationAccess::State;

/// The sites among some successive points. Of equal coordinates, which may be zeros of both signs,
/// the first one counts.
struct Part
{
  void extend(const Bounds& b, bool isOtherModest)
  {
    bounds = joined(bounds, b);
    areModest = areModest && isOtherModest;
  }

  std::size_t count = 0;
  Bounds bounds;
  bool areModest = true;
};

/// One call of numberSites().
class SiteNumbering
{
public:
  SiteNumbering(const State& state, Sites& sites, Ticker& ticker)
    : state_(state)
    , sites_(sites)
    , ticker_(ticker)
  {
  }

  /// Returns false if cancelled, as all below; throws std::bad_alloc.
  bool run() { return findFirst() && count() && number(); }

private:
  bool findFirst();
  bool findSmallest();
  bool count();
  bool number();

  static constexpr std::size_t kAhead = 32; ///< points or vertices: fetched

  const State& state_;
  Sites& sites_;
  Ticker& ticker_;
  Buffer<Index> vertexAt_; ///< of each point, if it is the first at its place
  std::vector<Part> parts_;
};

/// Until they have their numbers, vertices have the smallest id at their place in cellOf.
bool SiteNumbering::findFirst()
{
  const RankedPoints& ranked = state_.ranked;
  Index* const first = sites_.cellOf.data();
  vertexAt_.allocate(state_.points.count);
  Index* const vertexAt = vertexAt_.data();
  const auto clear = [&](std::size_t a, std::size_t b)
  { std::fill(vertexAt + a, vertexAt + b, kNoIndex); };
  const auto take = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t v = a; v != b; ++v)
    {
      prefetchForWrite(vertexAt + ranked.id[std::min(v + kAhead, b - 1)]);
      first[v] = ranked.id[v];
      vertexAt[ranked.id[v]] = static_cast<Index>(v);
    }
  };
  const auto leaveOut = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      const Index vertex = state_.sequence[i];
      vertexAt[first[vertex]] = kNoIndex;
      first[vertex] = kNoIndex;
    }
  };
  const std::size_t inserted = state_.report.inserted;
  return inShares(state_.points.count, ticker_, 1, kChunk, clear) &&
    inShares(ranked.count, ticker_, 1, kChunk, take) && findSmallest() &&
    inChunks(inserted, inserted + state_.report.beyondLimit, ticker_, leaveOut);
}

/// Where the point that stands for a vertex is not the one of smallest id there.
bool SiteNumbering::findSmallest()
{
  const Buffer<Duplicate>& duplicates = state_.ranked.duplicates;
  Index* const first = sites_.cellOf.data();
  Index* const vertexAt = vertexAt_.data();
  const auto look = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      Index& smallest = first[vertexAt[duplicates[i].keptId]];
      smallest = std::min(smallest, duplicates[i].id);
    }
  };
  const auto give = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      const Index vertex = vertexAt[duplicates[i].keptId];
      if (duplicates[i].id == first[vertex])
      {
        vertexAt[duplicates[i].id] = vertex;
      }
    }
  };
  const auto takeAway = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      Index& vertex = vertexAt[duplicates[i].keptId];
      vertex = vertex != kNoIndex && first[vertex] != duplicates[i].keptId ? kNoIndex : vertex;
    }
  };
  const std::size_t all = duplicates.size();
  return inChunks(0, all, ticker_, look) && inChunks(0, all, ticker_, give) &&
    inChunks(0, all, ticker_, takeAway);
}

bool SiteNumbering::count()
{
  const std::size_t points = state_.points.count;
  parts_.resize(tasksFor(threadsOf(ticker_), points, 1, kChunk));
  return inParallel(ticker_, parts_.size(),
    [&](std::size_t task, Ticker& own)
    {
      Part part; // on the stack: no false sharing
      const Share share(points, task, parts_.size());
      const bool done = inChunks(share.begin, share.end, own,
        [&](std::size_t a, std::size_t b)
        {
          for (std::size_t i = a; i != b; ++i)
          {
            state_.points.prefetch(i + kAhead);
            if (vertexAt_[i] != kNoIndex)
            {
              const Point p = state_.points[i];
              part.extend({ p.x, p.x, p.y, p.y }, isModest(p));
              ++part.count;
            }
          }
        });
      parts_[task] = part;
      return done;
    });
}

bool SiteNumbering::number()
{
  Part all;
  for (Part& part : parts_)
  {
    if (part.count != 0)
    {
      all.extend(part.bounds, part.areModest);
      all.count += part.count;
    }
    part.count = all.count - part.count; // where it begins
  }
  sites_.bounds = all.bounds;
  sites_.areModest = all.areModest;
  sites_.ids.allocate(all.count);
  const bool areTheirOwn = state_.ranked.duplicates.empty();
  Index* const cellOf = sites_.cellOf.data();
  return inParallel(ticker_, parts_.size(),
    [&](std::size_t task, Ticker& own)
    {
      std::size_t cell = parts_[task].count;
      const Share share(state_.points.count, task, parts_.size());
      return inChunks(share.begin, share.end, own,
        [&](std::size_t a, std::size_t b)
        {
          for (std::size_t i = a; i != b; ++i)
          {
            const Index later = vertexAt_[std::min(i + kAhead, b - 1)];
            prefetchForWrite(cellOf + (later == kNoIndex ? 0 : later));
            const Index vertex = vertexAt_[i];
            if (vertex != kNoIndex)
            {
              sites_.ids[cell] = static_cast<std::int32_t>(
                areTheirOwn ? i : std::size_t(state_.ranked.id[vertex]));
              cellOf[vertex] = static_cast<Index>(cell++);
            }
          }
        });
    });
}

} // namespace

bool numberSites(const State& state, Sites& sites, Ticker& ticker)
{
  sites.cellOf.allocate(state.ranked.count);
  return SiteNumbering(state, sites, ticker).run();
}

} // namespace ahd
