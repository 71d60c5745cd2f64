// SPDX-License-Identifier: BSD-3-Clause
//
// The half-edges are listed by the vertex v where they begin. The twin of h is then found at hand:
//
//          w
//         / \         h runs from v to u, its twin from u to v. In its own triangle the twin is
//        /   \        followed by g, which begins at v as h does and so is in the same list:
//       v --h- u      the one whose triangle has u before it.
//        \   /
//        g\ /
//          x
#include "Tables.h"

#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "../Core/Tasks.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace ahd
{

namespace
{

class TwinFinder
{
public:
  explicit TwinFinder(Tables& tables)
    : tables_(tables)
  {
  }

  /// Returns false if cancelled, as all below; throws std::bad_alloc.
  bool list(std::size_t vertices, Ticker& ticker);
  bool match(Ticker& ticker);

private:
  /// The other end of a half-edge that begins or ends at a vertex.
  using Spoke = std::pair<Index, HalfEdge>;

  bool matchShare(const Share& vertices, Ticker& ticker);
  void matchFew(const HalfEdge* list, std::size_t count, HalfEdge& start);
  bool matchMany(const HalfEdge* list, std::size_t count, HalfEdge& start, Ticker& ticker);

  static constexpr std::size_t kFew = 24; ///< half-edges that are compared each with each

  Tables& tables_;
  Buffer<std::uint32_t> ends_; ///< of each vertex, in the list; where the next one begins
  Buffer<HalfEdge> list_;      ///< the half-edges, by origin, ascending
};

bool TwinFinder::list(std::size_t vertices, Ticker& ticker)
{
  const Buffer<Index>& corners = tables_.corners;
  list_.allocate(corners.size());
  ends_.allocate(vertices + 1);
  const auto count = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t h = 3 * a; h != 3 * b; ++h)
    {
      ++ends_[std::size_t(corners[h]) + 1];
    }
  };
  std::uint32_t sum = 0;
  const auto sumUp = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t v = a; v != b; ++v)
    {
      sum += ends_[v];
      ends_[v] = sum;
    }
  };
  const auto put = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t h = 3 * a; h != 3 * b; ++h)
    {
      list_[ends_[corners[h]]++] = static_cast<HalfEdge>(h);
    }
  };
  // Each vertex's entry is first where its list begins, and in the end where it ends.
  return fillAll(ends_, 0u, ticker) && inChunks(0, tables_.triangles(), ticker, count) &&
    inChunks(0, ends_.size(), ticker, sumUp) && inChunks(0, tables_.triangles(), ticker, put);
}

bool TwinFinder::match(Ticker& ticker)
{
  const std::size_t vertices = ends_.size() - 1;
  tables_.twins.allocate(tables_.corners.size());
  tables_.starts.allocate(vertices);
  const std::size_t tasks = tasksFor(threadsOf(ticker), vertices, 8, kChunk);
  return inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own) { return matchShare(Share(vertices, task, tasks), own); });
}

bool TwinFinder::matchShare(const Share& vertices, Ticker& ticker)
{
  for (std::size_t v = vertices.begin; v != vertices.end; ++v)
  {
    const std::size_t begin = v == 0 ? 0 : ends_[v - 1];
    const std::size_t count = ends_[v] - begin;
    HalfEdge& start = tables_.starts[v];
    start = count == 0 ? kNoHalfEdge : list_[begin];
    if (count <= kFew)
    {
      matchFew(list_.data() + begin, count, start);
    }
    else if (!matchMany(list_.data() + begin, count, start, ticker))
    {
      return false;
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  ticker.finished((vertices.end - vertices.begin) * 2);
  return true;
}

void TwinFinder::matchFew(const HalfEdge* list, std::size_t count, HalfEdge& start)
{
  Index from[kFew]; // where the edge before each half-edge begins
  for (std::size_t i = 0; i < count; ++i)
  {
    from[i] = tables_.origin(previousInTriangle(list[i]));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Index to = tables_.target(list[i]);
    const std::size_t k = static_cast<std::size_t>(std::find(from, from + count, to) - from);
    tables_.twins[list[i]] = k == count ? kNoHalfEdge : previousInTriangle(list[k]);
    start = k == count ? list[i] : start;
  }
}

bool TwinFinder::matchMany(const HalfEdge* list, std::size_t count, HalfEdge& start, Ticker& ticker)
{
  std::vector<Spoke> out(count), in(count);
  const auto look = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      out[i] = { tables_.target(list[i]), list[i] };
      in[i] = { tables_.origin(previousInTriangle(list[i])), previousInTriangle(list[i]) };
    }
  };
  if (!inChunks(0, count, ticker, look) || !sortAsking(out, ticker, std::less<>()) ||
    !sortAsking(in, ticker, std::less<>()))
  {
    return false;
  }
  std::size_t k = 0;
  return inChunks(0, count, ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        k += k < count && in[k].first < out[i].first ? 1u : 0u; // one of them may be on the hull
        const bool isOnHull = k == count || in[k].first != out[i].first;
        tables_.twins[out[i].second] = isOnHull ? kNoHalfEdge : in[k].second;
        start = isOnHull ? out[i].second : start;
        k += isOnHull ? 0u : 1u;
      }
    });
}

} // namespace

bool findNeighbors(Tables& tables, std::size_t vertices, Ticker& ticker)
{
  TwinFinder finder(tables);
  return finder.list(vertices, ticker) && finder.match(ticker);
}

} // namespace ahd
