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
#include "Sites.h"

#include <algorithm>
#include <utility>

namespace ahd
{

namespace
{

using State = TriangulationAccess::State;

/// No cells, but the memory for them.
void clear(VoronoiCells& cells)
{
  cells.points.clear();
  cells.offsets.clear();
  cells.corners.clear();
  cells.sites.clear();
}

/// Without cells there is still one offset, 0.
void finish(VoronoiCells& cells)
{
  if (cells.offsets.empty())
  {
    cells.offsets.allocate(1);
    cells.offsets[0] = 0;
  }
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
  bool makeStrips();
  bool makeCells(Diagram& diagram, CellBorder& border);

  const State& state_;
  const VoronoiClip clip_;
  VoronoiCells& cells_;
  Ticker& ticker_;
  Sites sites_;
};

bool Voronoi::makeStrips()
{
  const Point* const places = state_.ranked.xy.data();
  const ClipBox box(sites_.bounds);
  if (clip_ == VoronoiClip::Hull || sites_.ids.size() < 2 || !box.hasArea())
  {
    return ticker_.ask();
  }
  cells_.sites = std::move(sites_.ids);
  std::vector<Index> line;
  line.reserve(cells_.sites.size());
  const auto collect = [&](std::size_t begin, std::size_t end)
  {
    for (std::size_t v = begin; v < end; ++v)
    {
      if (sites_.cellOf[v] != kNoIndex)
      {
        line.push_back(static_cast<Index>(v));
      }
    }
  };
  const auto isBefore = [&](Index a, Index b)
  { return lexicographicallyLess(places[a], places[b]); };
  Diagram diagram(state_.tables, places, sites_.bounds, sites_.areModest);
  BoxBorder border(diagram, box);
  CellWalk walk(diagram, border, sites_.cellOf, cells_);
  return inChunks(0, sites_.cellOf.size(), ticker_, collect) &&
    sortAsking(line, ticker_, isBefore) && walk.walkStrips(line, border, ticker_) && ticker_.ask();
}

bool Voronoi::makeCells(Diagram& diagram, CellBorder& border)
{
  CellWalk walk(diagram, border, sites_.cellOf, cells_);
  return border.build(ticker_) && walk.walk(ticker_) && ticker_.ask();
}

bool Voronoi::make()
{
  if (!numberSites(state_, sites_, ticker_))
  {
    return false;
  }
  if (state_.allTriangles == 0)
  {
    return makeStrips();
  }
  cells_.sites = std::move(sites_.ids);
  Diagram diagram(state_.tables, state_.ranked.xy.data(), sites_.bounds, sites_.areModest);
  if (!diagram.build(ticker_))
  {
    return false;
  }
  if (clip_ == VoronoiClip::Hull)
  {
    HullBorder border(diagram);
    return makeCells(diagram, border);
  }
  BoxBorder border(diagram, ClipBox(sites_.bounds));
  return makeCells(diagram, border);
}

} // namespace

Status voronoiCells(
  Triangulation& delaunay, VoronoiClip clip, VoronoiCells& cells, const Context& context)
{
  clear(cells);
  Status status = delaunay.makeNeighbors(context);
  if (status != Status::Ok)
  {
    cells = VoronoiCells();
    return status;
  }
  status = unlessCancelled(
    [&]
    {
      const State* const state = TriangulationAccess::stateOf(std::as_const(delaunay));
      if (!state)
      {
        finish(cells);
        return true;
      }
      // Vertices for sites and, twice, for cells; triangles for their centres, for the centres
      // these are joined to, whether they are inside, and the first cells and the numbers of
      // corners.
      const std::size_t steps = state->points.count + 3 * state->ranked.count +
        5 * state->allTriangles;
      Ticker ticker(
        context.progress, Phase::Outputs, steps, state->worthItsWhile(context.executor));
      const bool isDone = Voronoi(*state, clip, cells, ticker).make();
      finish(cells);
      return isDone;
    });
  if (status != Status::Ok)
  {
    cells = VoronoiCells();
  }
  return status;
}

std::size_t voronoiMemoryEstimate(std::size_t pointCount)
{
  // Memory held at the end; before there is less. Per triangle: the centre (16), the first
  // cell that has it (4) and its number (4), and where it is as a corner (24). Per point: the
  // number of its cell (4), what this has (8), site (4) and offset (4), and six corners, twice,
  // with some room (49). With two triangles per point that makes 169 (166 measured). There is a
  // triangle less for each edge of the hull, and three or four corners in the cell of its end in
  // place of six, which are not found as those inside: 81 less. But two corners are on the border,
  // with their places twice (80) and numbers (16), and the cell is listed with its vertex (12) and
  // its corners (16), and some more where cells have more (231 measured).
  constexpr std::size_t kPerPoint = 236;
  return pointCount * kPerPoint + 16384;
}

} // namespace ahd
