// SPDX-License-Identifier: BSD-3-Clause
#include "Selection.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Core/SortAsking.h"
#include "../Triangulation/MeshOrder.h"
#include "../Triangulation/State.h"
#include "Circumradius.h"
#include "PlacesInSpace.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace ahd
{
namespace
{

using State = TriangulationAccess::State;

/// One call of selectBySize(), when the triangles have numbers. Functions that return bool return
/// false if cancelled.
class Selecting
{
public:
  Selecting(State& state, const SizeLimits& limits, const PointsToMeasure& points, Selection& out)
    : state_(state)
    , limits_(limits)
    , points_(points)
    , radius_(limits.alpha)
    , length_(limits.maximumEdgeLength)
    , out_(out)
  {
  }

  bool run(Ticker& ticker);

private:
  /// The lines of triangles that are too large: bit k is set if edge k is a line.
  struct Edges
  {
    Buffer<unsigned char> lines;
    Buffer<std::uint32_t> slots; ///< only of triangles that are not kept
  };

  static constexpr std::size_t kSlotsAhead = 8;
  static constexpr std::size_t kTrianglesAhead = 16;
  bool hasAlpha() const { return limits_.alpha > 0.0; }
  bool isDropped(std::size_t slot) const { return (state_.marksOf(slot) & kDropped) != 0; }
  void fetchCornersOf(std::size_t slot) const;
  bool isSelected(Index a, Index b, Index c) const;
  bool isTooLong(Index a, Index b) const;
  bool isLine(Index a, Index b) const;
  void use(Index vertex) { used_[vertex].store(1, std::memory_order_relaxed); }

  bool beginUsed(Ticker& ticker);
  bool markTriangles(Ticker& ticker);
  bool findLines(Ticker& ticker);
  void fetchUnkept(std::size_t triangle) const;
  OrderedTriangle unkept(std::size_t triangle) const;
  unsigned linesOf(std::size_t triangle);
  bool writeLines(Ticker& ticker);
  bool findLinesBetweenCollinear(Ticker& ticker);
  bool findVertices(Ticker& ticker);
  bool markAlone(Buffer<unsigned char>& marks, Ticker& ticker) const;
  bool markAloneBeside(Buffer<unsigned char>& marks, Ticker& ticker) const;
  void hide();
  bool countKept(Ticker& ticker);

  State& state_;
  const SizeLimits& limits_;
  const PointsToMeasure& points_;
  const RadiusLimit radius_;
  const LengthLimit length_;
  Selection& out_;
  PlacesInSpace inSpace_;
  Buffer<std::atomic<unsigned char>> used_; ///< of each vertex: by a triangle or line?
  Edges edges_;
};

bool Selecting::run(Ticker& ticker)
{
  if (!ticker.ask() ||
    !(hasAlpha() ? inSpace_.read(state_, points_.inSpace, ticker) : state_.restorePlaces(ticker)))
  {
    return false;
  }
  if (!beginUsed(ticker) || !markTriangles(ticker))
  {
    return false;
  }
  if (hasAlpha())
  {
    if (!(state_.allTriangles == 0 ? findLinesBetweenCollinear(ticker)
                                   : findLines(ticker) && writeLines(ticker)) ||
      !findVertices(ticker))
    {
      return false;
    }
    hide();
  }
  return countKept(ticker) && ticker.ask();
}

bool Selecting::beginUsed(Ticker& ticker)
{
  used_.allocate(hasAlpha() ? state_.ranked.count : 0);
  return inChunksOf(used_.size(), ticker,
    [this](std::size_t a, std::size_t b)
    {
      for (std::size_t v = a; v != b; ++v)
      {
        used_[v].store(0, std::memory_order_relaxed);
      }
    });
}

bool Selecting::markTriangles(Ticker& ticker)
{
  out_.kept.resize(state_.allTriangles);
  unsigned char* const kept = out_.kept.data();
  if (!hasAlpha()) // no neighbours are needed: the walk by corners is faster
  {
    const Tables& tables = state_.tables;
    const Index* const v = tables.corners.data();
    return inShares(state_.allTriangles, ticker, 4, kChunk,
      [&, v, kept](std::size_t begin, std::size_t end)
      {
        for (std::size_t t = begin; t != end; ++t)
        {
          const bool isIn = tables.isKept(t) && isSelected(v[3 * t], v[3 * t + 1], v[3 * t + 2]);
          kept[t] = isIn ? 1 : 0;
        }
      });
  }
  edges_.slots.allocate(state_.allTriangles);
  return state_.allTriangles == 0 ||
    inMeshOrder(state_.mesh, state_.numbers, TriangleArray(kept, 1), ticker,
      [this, kept](std::size_t t, std::size_t slot, const OrderedTriangle& triangle)
      {
        const Index a = triangle.corner(0), b = triangle.corner(1), c = triangle.corner(2);
        fetchCornersOf(slot + kSlotsAhead);
        kept[t] = !isDropped(slot) && isSelected(a, b, c) ? 1 : 0;
        if (kept[t])
        {
          use(a);
          use(b);
          use(c);
        }
        else
        {
          edges_.slots[t] = static_cast<std::uint32_t>(slot);
        }
      });
}

/// The places of the corners of the triangle in the slot, if there is one, will be read.
void Selecting::fetchCornersOf(std::size_t slot) const
{
  const std::uint32_t* const corners = state_.mesh.data() +
    std::min(slot, state_.numbers.size() - 1) * Mesh::kSlotSize;
  for (unsigned k = 0; k < 3; ++k)
  {
    prefetchForRead(state_.ranked.xy.data() + corners[k]);
    inSpace_.fetch(corners[k]);
  }
}

bool Selecting::isSelected(Index a, Index b, Index c) const
{
  const Point* const at = state_.ranked.xy.data();
  return !(limits_.maximumEdgeLength > 0.0 && length_.isExceeded(at[a], at[b], at[c])) &&
    !(hasAlpha() && radius_.isExceeded(inSpace_(a), inSpace_(b), inSpace_(c)));
}

/// Is the edge between the two vertices, in the plane?
bool Selecting::isTooLong(Index a, Index b) const
{
  if (!(limits_.maximumEdgeLength > 0.0))
  {
    return false;
  }
  return length_.isExceeded(state_.ranked.xy[a], state_.ranked.xy[b]);
}

/// Is an edge a line, if none of its triangles is in the output?
bool Selecting::isLine(Index a, Index b) const
{
  const Vector3 p = inSpace_(a), q = inSpace_(b);
  return 0.5 * lengthOf({ { p[0] - q[0], p[1] - q[1], p[2] - q[2] } }) <= limits_.alpha &&
    !isTooLong(a, b);
}

bool Selecting::findLines(Ticker& ticker)
{
  edges_.lines.allocate(state_.allTriangles);
  return inShares(state_.allTriangles, ticker, 4, kChunk,
    [this](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t != end; ++t)
      {
        fetchUnkept(std::min(t + kTrianglesAhead, end - 1));
        const bool isTooLarge = !out_.kept[t] && !isDropped(edges_.slots[t]);
        edges_.lines[t] = isTooLarge ? static_cast<unsigned char>(linesOf(t)) : 0;
      }
    });
}

/// Unless it is kept, its neighbours will be needed.
void Selecting::fetchUnkept(std::size_t triangle) const
{
  if (!out_.kept[triangle])
  {
    const std::size_t slot = edges_.slots[triangle];
    prefetchForRead(state_.mesh.data() + slot * Mesh::kSlotSize);
    prefetchForRead(state_.numbers.data() + slot);
  }
}

/// A triangle that is not kept.
OrderedTriangle Selecting::unkept(std::size_t triangle) const
{
  const std::uint32_t slot = edges_.slots[triangle];
  return { state_.mesh.data(), slot, state_.numbers[slot] };
}

/// Those edges of a triangle that is too large which are not part of an output triangle. Of two
/// triangles that are too large the first has their edge.
unsigned Selecting::linesOf(std::size_t triangle)
{
  const OrderedTriangle corners = unkept(triangle);
  unsigned lines = 0;
  for (unsigned k = 0; k < 3; ++k)
  {
    const std::size_t slot = corners.twin(k) / Mesh::kSlotSize;
    const std::uint32_t number = state_.numbers[slot];
    const std::size_t other = triangleOf(number);
    const bool isAlone = number == kNotExtracted || isDropped(slot);
    const Index a = corners.corner(k), b = corners.corner((k + 1) % 3);
    if ((isAlone || (other > triangle && !out_.kept[other])) && isLine(a, b))
    {
      use(a);
      use(b);
      lines |= 1u << k;
    }
  }
  return lines;
}

bool Selecting::writeLines(Ticker& ticker)
{
  constexpr unsigned char kCount[8] = { 0, 1, 1, 2, 1, 2, 2, 3 };
  const unsigned char* const lines = edges_.lines.data();
  const auto count = [=](std::size_t a, std::size_t b)
  {
    return std::accumulate(lines + a, lines + b, std::size_t(0),
      [&](std::size_t sum, unsigned char bits) { return sum + kCount[bits]; });
  };
  const auto write = [&](std::size_t a, std::size_t b, std::size_t line)
  {
    for (std::size_t t = a; t != b; ++t)
    {
      for (unsigned k = 0; lines[t] >> k != 0; ++k)
      {
        if ((lines[t] >> k & 1u) != 0)
        {
          const OrderedTriangle triangle = unkept(t);
          const Index from = triangle.corner(k), to = triangle.corner((k + 1) % 3);
          out_.lines[2 * line] = static_cast<std::int32_t>(state_.ranked.id[from]);
          out_.lines[2 * line++ + 1] = static_cast<std::int32_t>(state_.ranked.id[to]);
        }
      }
    }
    return line;
  };
  return countAndWrite(
    edges_.lines.size(), ticker, count, [this](std::size_t n) { out_.lines.resize(2 * n); }, write);
}

/// From each vertex to the next.
bool Selecting::findLinesBetweenCollinear(Ticker& ticker)
{
  if (!state_.hasPointMap && !state_.makePointMap(ticker))
  {
    return false;
  }
  std::vector<Index> vertices;
  const bool all = inChunks(0, state_.ranked.count, ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        if (state_.tables.vertexOf[state_.ranked.id[v]] == v)
        {
          vertices.push_back(static_cast<Index>(v)); // not beyond the limit
        }
      }
    });
  const Point* const at = state_.ranked.xy.data();
  const auto isLess = [at](Index a, Index b) { return lexicographicallyLess(at[a], at[b]); };
  return all && sortAsking(vertices, ticker, isLess) &&
    inChunks(1, vertices.size(), ticker,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Index a = vertices[i - 1], b = vertices[i];
          if (isLine(a, b))
          {
            use(a);
            use(b);
            out_.lines.push_back(static_cast<std::int32_t>(state_.ranked.id[a]));
            out_.lines.push_back(static_cast<std::int32_t>(state_.ranked.id[b]));
          }
        }
      });
}

/// The state of a point: is it output as a vertex?
enum : unsigned char
{
  kIsNotAlone,
  kIsAlone,
  kIsBeyond ///< the limit on insertions: not in the output
};

bool Selecting::findVertices(Ticker& ticker)
{
  Buffer<unsigned char> marks;
  marks.allocate(state_.points.count);
  const bool done = inChunksOf(marks.size(), ticker,
    [&](std::size_t a, std::size_t b)
    { std::fill(marks.data() + a, marks.data() + b, kIsNotAlone); });
  if (!done || !markAlone(marks, ticker) || !markAloneBeside(marks, ticker))
  {
    return false;
  }
  const auto count = [&](std::size_t a, std::size_t b)
  { return std::size_t(std::count(marks.data() + a, marks.data() + b, kIsAlone)); };
  const auto write = [&](std::size_t a, std::size_t b, std::size_t next)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      if (marks[i] == kIsAlone)
      {
        out_.vertices[next++] = static_cast<std::int32_t>(i);
      }
    }
    return next;
  };
  return countAndWrite(
    marks.size(), ticker, count, [this](std::size_t n) { out_.vertices.resize(n); }, write);
}

/// Vertices.
bool Selecting::markAlone(Buffer<unsigned char>& marks, Ticker& ticker) const
{
  const std::uint32_t* const id = state_.ranked.id.data();
  const auto alone = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t v = a; v != b; ++v)
    {
      if (used_[v].load(std::memory_order_relaxed) == 0)
      {
        marks[id[v]] = kIsAlone;
      }
    }
  };
  const auto beyond = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = state_.report.inserted + a; i != state_.report.inserted + b; ++i)
    {
      marks[id[state_.sequence[i]]] = kIsBeyond;
    }
  };
  return inChunksOf(state_.ranked.count, ticker, alone) &&
    inChunksOf(state_.report.beyondLimit, ticker, beyond);
}

/// Points at the places of vertices, or merged into one.
bool Selecting::markAloneBeside(Buffer<unsigned char>& marks, Ticker& ticker) const
{
  static const std::vector<MergedPoint> kNone;
  const std::vector<MergedPoint>& merged = points_.merged ? *points_.merged : kNone;
  const auto beside = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      const auto& duplicate = state_.ranked.duplicates[i];
      marks[duplicate.id] = marks[duplicate.keptId] == kIsBeyond ? kIsBeyond : kIsAlone;
    }
  };
  const auto mergedInto = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      const std::size_t at = merged[i].keptId;
      const bool isIn = isFinite(state_.points[at]) && !state_.points.skipped(at);
      marks[merged[i].id] = isIn && marks[at] != kIsBeyond ? kIsAlone : kIsNotAlone;
    }
  };
  return inChunksOf(state_.ranked.duplicates.size(), ticker, beside) &&
    inChunksOf(merged.size(), ticker, mergedInto);
}

void Selecting::hide()
{
  if (!limits_.triangles)
  {
    std::fill(out_.kept.begin(), out_.kept.end(), static_cast<unsigned char>(0));
  }
  if (!limits_.lines)
  {
    out_.lines.clear();
  }
  if (!limits_.vertices)
  {
    out_.vertices.clear();
  }
}

struct Sum
{
  std::size_t value = 0;
  void merge(const Sum& other) { value += other.value; }
};

bool Selecting::countKept(Ticker& ticker)
{
  Sum sum;
  const unsigned char* const kept = out_.kept.data();
  const bool done = gather(out_.kept.size(), ticker, sum,
    [kept](Sum& part, std::size_t a, std::size_t b)
    { part.value += std::accumulate(kept + a, kept + b, 0u); });
  out_.keptCount = sum.value;
  return done;
}

} // namespace

Status selectBySize(Triangulation& triangulation, const SizeLimits& limits,
  const PointsToMeasure& points, const Context& context, Selection& out)
{
  out = Selection();
  State* const state = TriangulationAccess::stateOf(triangulation).get();
  if (!state)
  {
    return Status::Ok;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, state->allTriangles,
        state->worthItsWhile(context.executor));
      // With alpha all points are read again in any case.
      return (limits.alpha > 0.0 ? state->makeNumbers(ticker, State::PlacesAre::NotNeeded)
                                 : state->makeCorners(ticker)) &&
        Selecting(*state, limits, points, out).run(ticker);
    });
}

std::size_t selectionMemoryEstimate(std::size_t pointCount)
{
  return pointCount * 70;
}

} // namespace ahd
