// SPDX-License-Identifier: BSD-3-Clause
#include "PartJudges.h"

#include "Voronoi/ConvexPolygon.h"
#include "VoronoiOracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostToCompare = 300;
constexpr std::size_t kMostExactCells = 12;

Bounds boundsOf(const PointView& points)
{
  Bounds b{ kInfinity, -kInfinity, kInfinity, -kInfinity };
  for (std::size_t i = 0; i < points.count; ++i)
  {
    const Point p = points[i];
    if (isFinite(p) && !points.skipped(i))
    {
      b = { std::min(b.xmin, p.x), std::max(b.xmax, p.x), std::min(b.ymin, p.y),
        std::max(b.ymax, p.y) };
    }
  }
  return b;
}

/// As defined in Merge.h.
bool isWithin(const Point& a, const Point& b, double distance)
{
  const double s = distance == kInfinity ? 1.0
                                         : std::ldexp(1.0, std::min(1023, -std::ilogb(distance)));
  const double dx = (a.x - b.x) * s, dy = (a.y - b.y) * s;
  return dx * dx + dy * dy <= (distance * s) * (distance * s);
}

double cross(const Point& a, const Point& b, const Point& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

using Cell = std::vector<Point>;

Cell cellOf(const VoronoiCells& cells, std::size_t k)
{
  const auto at = [](const auto& values, std::size_t i)
  { return i < values.size() ? values[i] : throw std::out_of_range("a corner that is none"); };
  Cell result;
  for (std::int64_t i = cells.offsets[k]; i < cells.offsets[k + 1]; ++i)
  {
    result.push_back(at(cells.points, std::size_t(at(cells.corners, std::size_t(i)))));
  }
  return result;
}

double areaOf(const Cell& cell)
{
  double twice = 0.0;
  for (std::size_t i = 2; i < cell.size(); ++i)
  {
    twice += cross(cell[0], cell[i - 1], cell[i]);
  }
  return 0.5 * twice;
}

bool isConvexAround(const Cell& cell, const Point& site, double slack)
{
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    const Point &a = cell[i], &b = cell[(i + 1) % cell.size()], &c = cell[(i + 2) % cell.size()];
    if (cross(a, b, c) < -slack || cross(a, b, site) < -slack)
    {
      return false;
    }
  }
  return true;
}

/// Points, their triangulation and their diagram.
struct Diagram
{
  const PointView& points;
  const test::ConstrainedOutcome& plain;
  VoronoiClip clip;
  VoronoiCells cells;
  Bounds bounds;
};

/// If all coordinates of vertices are small integers times one power of two: that. Else 0. With
/// them rounding is easily distinguished from a fault.
double unitOf(const Diagram& diagram)
{
  const Bounds& b = diagram.bounds;
  const double largest = std::max(
    { std::fabs(b.xmin), std::fabs(b.xmax), std::fabs(b.ymin), std::fabs(b.ymax) });
  if (!(largest > 0.0))
  {
    return 0.0;
  }
  const double unit = std::ldexp(1.0, std::max(-1074, std::ilogb(largest) - 9));
  const auto isWhole = [unit](double value)
  {
    const double times = value / unit; // may underflow
    return times == std::floor(times) && times * unit == value;
  };
  for (std::size_t i = 0; i < diagram.points.count; ++i)
  {
    const Point p = diagram.points[i];
    if (diagram.plain.pointStatus[i] == std::int64_t(i) && !(isWhole(p.x) && isWhole(p.y)))
    {
      return 0.0;
    }
  }
  return unit;
}

Cell inUnits(Cell cell, double unit)
{
  for (Point& p : cell)
  {
    p = { p.x / unit, p.y / unit };
  }
  return cell;
}

double areaToFill(const Diagram& diagram, double unit)
{
  const Bounds& b = diagram.bounds;
  double area = 0.0;
  const std::vector<std::int32_t>& triples = diagram.plain.triples;
  for (std::size_t t = 0; t + 2 < triples.size(); t += 3)
  {
    const auto at = [&](std::size_t k) { return diagram.points[std::size_t(triples[t + k])]; };
    area += areaOf(inUnits({ at(0), at(1), at(2) }, unit));
  }
  const double box = (b.xmax / unit - b.xmin / unit) * (b.ymax / unit - b.ymin / unit);
  return diagram.clip == VoronoiClip::Hull ? area : box;
}

std::string faultsOfShapes(const Diagram& diagram)
{
  const double unit = unitOf(diagram);
  // Near the smallest double, corners between its multiples are rounded.
  if (unit < 0x1p-1000)
  {
    return "";
  }
  // A corner is within a few last places of its own, and areas change by that times the size.
  const double slack = 1e-13 * 1024.0 * 1024.0;
  double area = 0.0;
  for (std::size_t k = 0; k < diagram.cells.sites.size(); ++k)
  {
    const Cell cell = inUnits(cellOf(diagram.cells, k), unit);
    const Point at = diagram.points[std::size_t(diagram.cells.sites[k])];
    const Point site{ at.x / unit, at.y / unit };
    if (!isConvexAround(cell, site, slack))
    {
      return "the cell of point " + std::to_string(diagram.cells.sites[k]) +
        " is not convex, counterclockwise and around it";
    }
    area += areaOf(cell);
  }
  const double missing = areaToFill(diagram, unit) - area;
  const double allowed = slack * double(diagram.cells.corners.size() + 1);
  return diagram.cells.sites.empty() || std::fabs(missing) <= allowed
    ? ""
    : "the cells leave out an area of " + std::to_string(missing);
}

std::string faultsOfAll(const Diagram& diagram)
{
  const VoronoiCells& cells = diagram.cells;
  const Bounds& b = diagram.bounds;
  const bool hasArea = diagram.clip == VoronoiClip::Hull
    ? !diagram.plain.triples.empty()
    : diagram.plain.report.inserted > 1 && b.xmax > b.xmin && b.ymax > b.ymin;
  if (cells.sites.size() != (hasArea ? diagram.plain.report.inserted : 0) ||
    cells.offsets.size() != cells.sites.size() + 1)
  {
    return std::to_string(cells.sites.size()) + " cells";
  }
  for (std::size_t k = 0; k < cells.sites.size(); ++k)
  {
    const std::int64_t site = cells.sites[k];
    if (diagram.plain.pointStatus.at(std::size_t(site)) != site ||
      (k > 0 && cells.sites[k - 1] >= site))
    {
      return "sites are not the vertices in their order";
    }
    const Cell cell = cellOf(cells, k);
    const double slack = 1e-15 *
      std::max({ std::fabs(b.xmin), std::fabs(b.xmax), std::fabs(b.ymin), std::fabs(b.ymax) });
    const bool isInside = std::all_of(cell.begin(), cell.end(),
      [&](const Point& p)
      {
        return p.x >= b.xmin - slack && p.x <= b.xmax + slack && p.y >= b.ymin - slack &&
          p.y <= b.ymax + slack;
      });
    if (cell.size() < 3 || !isInside)
    {
      return "the cell of point " + std::to_string(site) + " has " + std::to_string(cell.size()) +
        " corners, or one outside the bounds";
    }
  }
  const std::string fault = cells.sites.size() <= kMostExactCells
    ? test::faultsOfCells(diagram.points, diagram.clip, cells)
    : "";
  return fault.empty() ? faultsOfShapes(diagram) : fault;
}

/// Of the cells in a triangle of points.
std::string faultsInTriangle(Triangulation& delaunay, std::size_t vertices, Executor* executor)
{
  const PointView& points = delaunay.points();
  if (points.count < 3)
  {
    return "";
  }
  const ConvexPolygon triangle({ points[0], points[points.count / 2], points[points.count - 1] });
  if (triangle.fault() != PolygonFault::None)
  {
    return "";
  }
  VoronoiCells cells;
  const Status status = voronoiCells(delaunay, triangle, cells, { nullptr, executor });
  if (status != Status::Ok || cells.sites.size() != vertices)
  {
    return "status " + std::to_string(int(status)) + ", or not a cell for each vertex";
  }
  const std::vector<Point> corners{ triangle.corner(0), triangle.corner(1), triangle.corner(2) };
  return vertices <= kMostExactCells ? test::faultsOfCells(points, corners, cells) : "";
}

} // namespace

std::string mergeAndJudge(const PointView& points, double fraction, MergedPoints& merged)
{
  const Bounds b = boundsOf(points);
  const double side = b.xmin <= b.xmax ? std::max(b.xmax - b.xmin, b.ymax - b.ymin) : 1.0;
  const double distance = fraction * side;
  const Status status = mergeWithin(points, distance, nullptr, merged);
  if (status != Status::Ok)
  {
    return "merging: status " + std::to_string(int(status));
  }
  if (points.count > kMostToCompare || !(distance > 0.0))
  {
    return merged.pairs.empty() || distance > 0.0 ? "" : "merged within no distance";
  }
  for (const MergedPoint& pair : merged.pairs)
  {
    if (merged.skip[pair.id] != 1 || merged.skip[pair.keptId] != 0 ||
      !isWithin(points[pair.id], points[pair.keptId], distance))
    {
      return "point " + std::to_string(pair.id) + " should not be merged";
    }
  }
  for (std::size_t i = 0; i < points.count; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const bool areKept = merged.skip[i] == 0 && merged.skip[j] == 0 && isFinite(points[i]) &&
        isFinite(points[j]) && !(points[i] == points[j]);
      if (areKept && isWithin(points[i], points[j], distance))
      {
        return "points " + std::to_string(j) + " and " + std::to_string(i) + " should be merged";
      }
    }
  }
  return "";
}

std::string faultsOfDiagram(
  Triangulation& delaunay, const test::ConstrainedOutcome& plain, Executor* executor)
{
  const PointView& points = delaunay.points();
  for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
  {
    Diagram diagram{ points, plain, clip, {}, boundsOf(points) };
    const Status status = voronoiCells(delaunay, clip, diagram.cells, { nullptr, executor });
    const std::string fault = status == Status::Ok
      ? faultsOfAll(diagram)
      : "diagram: status " + std::to_string(int(status));
    if (!fault.empty())
    {
      return (clip == VoronoiClip::Hull ? "clipped at the hull: " : "clipped at the box: ") + fault;
    }
  }
  const std::string fault = faultsInTriangle(delaunay, plain.report.inserted, executor);
  return fault.empty() ? "" : "clipped at a triangle: " + fault;
}

} // namespace fuzz
} // namespace ahd
