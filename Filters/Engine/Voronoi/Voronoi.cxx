// SPDX-License-Identifier: BSD-3-Clause
#include "Voronoi.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "../Predicates/Circles.h"
#include "../Triangulation/State.h"
#include "Cells.h"
#include "ConvexBorder.h"
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
  /// `polygon`: of the caller's own, or null.
  Voronoi(const State& state, VoronoiClip clip, const ConvexPolygon* polygon, VoronoiCells& cells,
    Ticker& ticker)
    : state_(state)
    , clip_(clip)
    , polygon_(polygon)
    , cells_(cells)
    , ticker_(ticker)
  {
  }

  /// Returns false if cancelled; throws std::bad_alloc.
  bool make();

private:
  bool makeAll();
  bool makeStrips(const ConvexPolygon& polygon);
  bool giveAllToOne();
  bool makeCells(Diagram& diagram, CellBorder& border);

  const State& state_;
  const VoronoiClip clip_;
  const ConvexPolygon* const polygon_;
  VoronoiCells& cells_;
  Ticker& ticker_;
  Sites sites_;
};

bool Voronoi::makeStrips(const ConvexPolygon& polygon)
{
  const Point* const places = state_.ranked.xy.data();
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
  ConvexBorder border(diagram, polygon);
  CellWalk walk(diagram, border, sites_.cellOf, cells_);
  return inChunks(0, sites_.cellOf.size(), ticker_, collect) &&
    sortAsking(line, ticker_, isBefore) && walk.walkStrips(line, border, ticker_) && ticker_.ask();
}

bool Voronoi::makeCells(Diagram& diagram, CellBorder& border)
{
  CellWalk walk(diagram, border, sites_.cellOf, cells_);
  return border.build(ticker_) && walk.walk(ticker_) && ticker_.ask();
}

/// No edge crosses the polygon: all of it is in the cell whose vertex is nearest to its corners, of
/// which three tell it from any other.
bool Voronoi::giveAllToOne()
{
  const auto at = [this](std::size_t cell)
  { return state_.points[static_cast<std::size_t>(cells_.sites[cell])]; };
  const auto isNearer = [this](const Point& p, const Point& q)
  {
    int sign = 0;
    for (std::size_t k = 0; k < 3 && sign == 0; ++k)
    {
      sign = nearerOf(p, q, polygon_->corner(k));
    }
    return sign > 0;
  };
  std::size_t nearest = 0;
  const auto find = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t cell = a; cell != b; ++cell)
    {
      nearest = isNearer(at(cell), at(nearest)) ? cell : nearest;
    }
  };
  if (!inChunks(0, cells_.sites.size(), ticker_, find))
  {
    return false;
  }
  const auto corners = static_cast<std::int32_t>(polygon_->size());
  cells_.points.allocate(polygon_->size());
  cells_.corners.allocate(polygon_->size());
  for (std::int32_t k = 0; k < corners; ++k)
  {
    const Point& p = polygon_->corner(static_cast<std::size_t>(k));
    cells_.points[static_cast<std::size_t>(k)] = { p.x, p.y, 0.0 };
    cells_.corners[static_cast<std::size_t>(k)] = k;
  }
  std::fill(cells_.offsets.begin() + nearest + 1, cells_.offsets.end(), corners);
  return ticker_.ask();
}

bool Voronoi::make()
{
  const bool isMade = numberSites(state_, sites_, ticker_) && makeAll();
  const bool isUncut = polygon_ && cells_.corners.empty() && !cells_.sites.empty();
  return isMade && (!isUncut || giveAllToOne());
}

bool Voronoi::makeAll()
{
  std::vector<Point> corners; // of the bounds
  if (!polygon_ && clip_ == VoronoiClip::Bounds && !sites_.ids.empty())
  {
    const Bounds& b = sites_.bounds;
    corners = { { b.xmin, b.ymin }, { b.xmax, b.ymax } };
  }
  const ConvexPolygon bounds(std::move(corners));
  const ConvexPolygon& polygon = polygon_ ? *polygon_ : bounds;
  if (state_.allTriangles == 0)
  {
    const bool hasStrips = polygon.fault() == PolygonFault::None && !sites_.ids.empty();
    return hasStrips ? makeStrips(polygon) : ticker_.ask();
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
  ConvexBorder border(diagram, polygon);
  return makeCells(diagram, border);
}

Status makeCells(Triangulation& delaunay, VoronoiClip clip, const ConvexPolygon* polygon,
  VoronoiCells& cells, const Context& context)
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
      const bool isDone = Voronoi(*state, clip, polygon, cells, ticker).make();
      finish(cells);
      return isDone;
    });
  if (status != Status::Ok)
  {
    cells = VoronoiCells();
  }
  return status;
}

} // namespace

Status voronoiCells(
  Triangulation& delaunay, VoronoiClip clip, VoronoiCells& cells, const Context& context)
{
  return makeCells(delaunay, clip, nullptr, cells, context);
}

Status voronoiCells(Triangulation& delaunay, const ConvexPolygon& polygon, VoronoiCells& cells,
  const Context& context)
{
  return makeCells(delaunay, VoronoiClip::Polygon, &polygon, cells, context);
}

void leaveOutEmpty(VoronoiCells& cells)
{
  const auto isEmpty = [&](std::size_t k) { return cells.offsets[k] == cells.offsets[k + 1]; };
  std::size_t count = 0;
  for (std::size_t k = 0; k < cells.sites.size(); ++k)
  {
    count += isEmpty(k) ? 0u : 1u;
  }
  if (count == cells.sites.size())
  {
    return;
  }
  Buffer<std::int32_t> offsets, sites;
  offsets.allocate(count + 1);
  sites.allocate(count);
  offsets[0] = 0;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < cells.sites.size(); ++k)
  {
    if (!isEmpty(k))
    {
      sites[kept] = cells.sites[k];
      offsets[++kept] = cells.offsets[k + 1];
    }
  }
  cells.offsets = std::move(offsets);
  cells.sites = std::move(sites);
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
