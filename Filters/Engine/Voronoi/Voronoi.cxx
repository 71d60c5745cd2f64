// SPDX-License-Identifier: BSD-3-Clause
#include "Voronoi.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "BoxBorder.h"
#include "Cells.h"
#include "ClipBox.h"
#include "Diagram.h"
#include "HullBorder.h"

#include <algorithm>

namespace ahd
{

namespace
{

bool isVertex(const DelaunayView& delaunay, std::size_t i)
{
  return delaunay.fates[i] == static_cast<std::int64_t>(i);
}

/// The vertices from one end of their line to the other. Returns false if cancelled.
bool verticesInLine(const DelaunayView& delaunay, std::vector<std::int64_t>& line, Ticker& ticker)
{
  const bool all = inChunks(0, delaunay.points.count, ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (isVertex(delaunay, i))
        {
          line.push_back(static_cast<std::int64_t>(i));
        }
      }
    });
  return all &&
    sortAsking(line, ticker,
      [&](std::int64_t a, std::int64_t b)
      {
        return lexicographicallyLess(delaunay.points[static_cast<std::size_t>(a)],
          delaunay.points[static_cast<std::size_t>(b)]);
      });
}

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

/// Of the vertices. Returns false if cancelled.
bool findBounds(const DelaunayView& delaunay, Bounds& bounds, Ticker& ticker)
{
  return inChunks(0, delaunay.points.count, ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (isVertex(delaunay, i))
        {
          extend(bounds, delaunay.points[i]);
        }
      }
    });
}

bool makeStrips(const DelaunayView& delaunay, VoronoiClip clip, VoronoiCells& cells, Ticker& ticker)
{
  std::vector<std::int64_t> line;
  Bounds bounds;
  if (!verticesInLine(delaunay, line, ticker) || !findBounds(delaunay, bounds, ticker))
  {
    return false;
  }
  const ClipBox box(bounds);
  if (clip == VoronoiClip::Hull || line.size() < 2 || !box.hasArea())
  {
    return ticker.ask();
  }
  Diagram diagram(delaunay);
  BoxBorder border(diagram, box);
  CellWalk walk(diagram, border, cells);
  return walk.walkStrips(line, border, ticker) && walk.number(ticker) && ticker.ask();
}

bool makeCells(const Diagram& diagram, CellBorder& border, VoronoiCells& cells, Ticker& ticker)
{
  // Vertices that have triangles; each has six corners on average at most.
  std::size_t vertices = 0;
  if (!diagram.countVertices(ticker, vertices))
  {
    return false;
  }
  cells.offsets.reserve(vertices + 1);
  cells.sites.reserve(vertices);
  cells.corners.reserve(6 * vertices);
  CellWalk walk(diagram, border, cells);
  return border.build(ticker) && walk.walk(ticker) && walk.number(ticker) && ticker.ask();
}

bool make(const DelaunayView& delaunay, VoronoiClip clip, VoronoiCells& cells, Ticker& ticker)
{
  cells.offsets.assign(1, 0);
  if (delaunay.triangles == 0)
  {
    return makeStrips(delaunay, clip, cells, ticker);
  }
  Diagram diagram(delaunay);
  if (!diagram.build(ticker))
  {
    return false;
  }
  Bounds bounds;
  if (!findBounds(delaunay, bounds, ticker))
  {
    return false;
  }
  if (clip == VoronoiClip::Hull)
  {
    HullBorder border(diagram, bounds);
    return makeCells(diagram, border, cells, ticker);
  }
  BoxBorder border(diagram, ClipBox(bounds));
  return makeCells(diagram, border, cells, ticker);
}

} // namespace

Status voronoiCells(const DelaunayView& delaunay, VoronoiClip clip, VoronoiCells& cells,
  Progress* progress, Executor* executor)
{
  cells = VoronoiCells();
  const Status status = unlessCancelled(
    [&]
    {
      const std::size_t steps = delaunay.points.count + delaunay.triangles;
      Ticker ticker(progress, Phase::Outputs, steps, executor);
      return make(delaunay, clip, cells, ticker);
    });
  if (status != Status::Ok)
  {
    cells = VoronoiCells();
  }
  return status;
}

std::size_t voronoiMemoryEstimate(std::size_t pointCount)
{
  // Per triangle: the centre (16), what stands for it (4), the edge of the hull it is beyond (4),
  // its number as a corner (8) and as a corner its place (16, in an array that is copied when it
  // grows: three times). Per point: where to start (4), offset and site (16), six corners of cells
  // (48). Per edge of the hull, two corners on the border, with numbers, and two edges that are
  // cut: the table's nodes and buckets. There are two triangles per point, or two edges of the hull
  // for each triangle less.
  constexpr std::size_t kPerTriangle = 16 + 4 + 4 + 8 + 3 * 16;
  constexpr std::size_t kPerPoint = 4 + 16 + 48;
  constexpr std::size_t kPerHullEdge = 2 * (3 * 16 + 8 + 3 * 16) + 2 * (48 + 3 * 8);
  return pointCount * (2 * kPerTriangle + kPerPoint + kPerHullEdge / 2) + 4096;
}

} // namespace ahd
