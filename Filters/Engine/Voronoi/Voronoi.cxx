// SPDX-License-Identifier: BSD-3-Clause
#include "Voronoi.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "../Triangulation/State.h"
#include "BoxBorder.h"
#include "Cells.h"
#include "ClipBox.h"
#include "Diagram.h"
#include "HullBorder.h"

#include <algorithm>
#include <utility>

namespace ahd
{

namespace
{

using State = TriangulationAccess::State;

void extend(Bounds& bounds, const Point& p)
{
  if (bounds.xmin > bounds.xmax)
  {
    bounds = { p.x, p.x, p.y, p.y };
    return;
  }
  bounds.xmin = std::min(bounds.xmin, p.x);
  bounds.xmax = std::max(bounds.xmax, p.x);
  bounds.ymin = std::min(bounds.ymin, p.y);
  bounds.ymax = std::max(bounds.ymax, p.y);
}

/// One call of voronoiCells().
class Voronoi
{
public:
  Voronoi(const State& state, VoronoiClip clip, VoronoiCells& cells, Ticker& ticker)
    : state_(state)
    , clip_(clip)
    , cells_(cells)
    , ticker_(ticker)
  {
  }

  /// Returns false if cancelled; throws std::bad_alloc.
  bool make();

private:
  bool numberSites();
  bool makeStrips();
  bool makeCells(Diagram& diagram, CellBorder& border);

  const State& state_;
  const VoronoiClip clip_;
  VoronoiCells& cells_;
  Ticker& ticker_;
  Buffer<Index> cellOf_; ///< of each vertex; kNoIndex if it is beyond the limit
  Bounds bounds_;        ///< of the sites
};

/// Point after point, so that cells come in the order of the smallest id at each place.
bool Voronoi::numberSites()
{
  const Buffer<Index>& vertexOf = state_.tables.vertexOf;
  cellOf_.allocate(state_.ranked.count);
  cells_.sites.reserve(state_.report.inserted);
  return fillAll(cellOf_, kNoIndex, ticker_) &&
    inChunks(0, vertexOf.size(), ticker_,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Index vertex = vertexOf[i];
          if (vertex != kNoIndex && cellOf_[vertex] == kNoIndex)
          {
            cellOf_[vertex] = static_cast<Index>(cells_.sites.size());
            cells_.sites.push_back(static_cast<std::int32_t>(state_.ranked.id[vertex]));
            extend(bounds_, state_.points[i]);
          }
        }
      });
}

bool Voronoi::makeStrips()
{
  const Point* const places = state_.ranked.xy.data();
  const ClipBox box(bounds_);
  if (clip_ == VoronoiClip::Hull || cells_.sites.size() < 2 || !box.hasArea())
  {
    cells_.sites.clear();
    return ticker_.ask();
  }
  std::vector<Index> line;
  line.reserve(cells_.sites.size());
  const auto collect = [&](std::size_t begin, std::size_t end)
  {
    for (std::size_t v = begin; v < end; ++v)
    {
      if (cellOf_[v] != kNoIndex)
      {
        line.push_back(static_cast<Index>(v));
      }
    }
  };
  const auto isBefore = [&](Index a, Index b)
  { return lexicographicallyLess(places[a], places[b]); };
  Diagram diagram(state_.tables, places);
  BoxBorder border(diagram, box);
  CellWalk walk(diagram, border, cellOf_, cells_);
  return inChunks(0, cellOf_.size(), ticker_, collect) && sortAsking(line, ticker_, isBefore) &&
    walk.walkStrips(line, border, ticker_) && walk.number(ticker_) && ticker_.ask();
}

bool Voronoi::makeCells(Diagram& diagram, CellBorder& border)
{
  CellWalk walk(diagram, border, cellOf_, cells_);
  return border.build(ticker_) && walk.walk(ticker_) && walk.number(ticker_) && ticker_.ask();
}

bool Voronoi::make()
{
  cells_.offsets.assign(1, 0);
  if (!numberSites())
  {
    return false;
  }
  if (state_.allTriangles == 0)
  {
    return makeStrips();
  }
  Diagram diagram(state_.tables, state_.ranked.xy.data());
  if (!diagram.build(ticker_))
  {
    return false;
  }
  if (clip_ == VoronoiClip::Hull)
  {
    HullBorder border(diagram, bounds_);
    return makeCells(diagram, border);
  }
  BoxBorder border(diagram, ClipBox(bounds_));
  return makeCells(diagram, border);
}

} // namespace

Status voronoiCells(
  Triangulation& delaunay, VoronoiClip clip, VoronoiCells& cells, const Context& context)
{
  cells = VoronoiCells();
  Status status = delaunay.makeNeighbors(context);
  status = status != Status::Ok ? status : delaunay.makePointMap(context);
  if (status != Status::Ok)
  {
    return status;
  }
  status = unlessCancelled(
    [&]
    {
      const State* const state = TriangulationAccess::stateOf(std::as_const(delaunay));
      if (!state)
      {
        cells.offsets.assign(1, 0);
        return true;
      }
      // Points twice, triangles for their centres and for what these are joined to.
      const std::size_t steps = 2 * (state->ranked.count + state->allTriangles);
      Ticker ticker(
        context.progress, Phase::Outputs, steps, state->worthItsWhile(context.executor));
      return Voronoi(*state, clip, cells, ticker).make();
    });
  if (status != Status::Ok)
  {
    cells = VoronoiCells();
  }
  return status;
}

std::size_t voronoiMemoryEstimate(std::size_t pointCount)
{
  // Per triangle: the centre (16), what stands for it (4) or its number as a corner, the edge of
  // the hull it is beyond (4), whether it is inside (1), and as a corner its place (16). Per point:
  // the number of its cell (4), offset and site (8), six corners of cells (24). Per edge of the
  // hull, two corners on the border, with numbers, two edges that are cut (the table's nodes and
  // buckets), and a cell at the border with eight corners, in arrays that are copied when they grow
  // (three times). There are two triangles per point, or two edges of the hull for each triangle
  // less.
  constexpr std::size_t kPerTriangle = 16 + 4 + 4 + 1 + 16;
  constexpr std::size_t kPerPoint = 4 + 8 + 24;
  constexpr std::size_t kPerHullEdge = 2 * (3 * 16 + 4 + 16) + 2 * (48 + 3 * 8) + 3 * (24 + 8 * 4);
  return pointCount * (2 * kPerTriangle + kPerPoint + kPerHullEdge / 2) + 4096;
}

} // namespace ahd
