// SPDX-License-Identifier: BSD-3-Clause
#include "VoronoiOracle.h"

#include "ExactSigns.h"
#include "ExactVectors.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

using Polygon = std::vector<Vector>;

Vector exactly(const Point& p)
{
  return { mpq_class(p.x), mpq_class(p.y) };
}

mpq_class dot(const Vector& a, const Vector& b)
{
  return a.x * b.x + a.y * b.y;
}

Vector minus(const Vector& a, const Vector& b)
{
  return { a.x - b.x, a.y - b.y };
}

/// Places where something * x + something * y + something else is not negative.
struct HalfPlane
{
  mpq_class x, y, rest;

  mpq_class at(const Vector& p) const { return x * p.x + y * p.y + rest; }
};

HalfPlane nearerTo(const Point& site, const Point& other)
{
  const Vector p = exactly(site), q = exactly(other);
  return { 2 * (p.x - q.x), 2 * (p.y - q.y), dot(q, q) - dot(p, p) };
}

HalfPlane leftOf(const Point& from, const Point& to)
{
  const Vector a = exactly(from), way = between(from, to);
  return { -way.y, way.x, -cross(way, a) };
}

Polygon cut(const Polygon& polygon, const HalfPlane& plane)
{
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const mpq_class atA = plane.at(a), atB = plane.at(b);
    if (sgn(atA) >= 0)
    {
      result.push_back(a);
    }
    if (sgn(atA) * sgn(atB) < 0)
    {
      const mpq_class part = atA / (atA - atB);
      result.push_back({ a.x + part * (b.x - a.x), a.y + part * (b.y - a.y) });
    }
  }
  return result;
}

mpq_class twiceArea(const Polygon& polygon)
{
  mpq_class result = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    result += cross(minus(polygon[i - 1], polygon[0]), minus(polygon[i], polygon[0]));
  }
  return result;
}

Polygon boxOf(const std::vector<Point>& vertices)
{
  const auto byY = [](const Point& a, const Point& b) { return a.y < b.y; };
  const auto x = std::minmax_element(vertices.begin(), vertices.end(), lexicographicallyLess);
  const auto y = std::minmax_element(vertices.begin(), vertices.end(), byY);
  const double left = x.first->x, right = x.second->x, low = y.first->y, high = y.second->y;
  return { exactly({ left, low }), exactly({ right, low }), exactly({ right, high }),
    exactly({ left, high }) };
}

class Judge
{
public:
  /// `polygon`: where cells are clipped, if neither at the hull nor at the box.
  Judge(const PointView& points, VoronoiClip clip, const std::vector<Point>& polygon,
    const VoronoiCells& cells)
    : cells_(cells)
    , clip_(clip)
  {
    for (const Point& p : polygon)
    {
      polygon_.push_back(exactly(p));
    }
    for (const std::int32_t site : cells.sites)
    {
      vertices_.push_back(points[static_cast<std::size_t>(site)]);
    }
  }

  std::string faults() const
  {
    for (std::size_t k = 0; k < vertices_.size(); ++k)
    {
      const std::string fault = faultOf(k);
      if (!fault.empty())
      {
        return "the cell of point " + std::to_string(cells_.sites[k]) + " at " +
          hexText(vertices_[k]) + " " + fault;
      }
    }
    mpq_class whole = 0;
    for (std::size_t k = 0; k < vertices_.size() && !polygon_.empty(); ++k)
    {
      whole += twiceArea(exactCell(k));
    }
    const bool isFull = vertices_.empty() || whole == twiceArea(polygon_);
    return isFull ? "" : "the exact cells do not fill the polygon";
  }

private:
  Polygon exactCell(std::size_t k) const
  {
    Polygon cell = polygon_.empty() ? boxOf(vertices_) : polygon_;
    for (std::size_t i = 0; clip_ == VoronoiClip::Hull && i < vertices_.size(); ++i)
    {
      for (std::size_t j = 0; j < vertices_.size(); ++j)
      {
        if (isHullEdge(i, j))
        {
          cell = cut(cell, leftOf(vertices_[i], vertices_[j]));
        }
      }
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
      if (i != k)
      {
        cell = cut(cell, nearerTo(vertices_[k], vertices_[i]));
      }
    }
    return cell;
  }

  bool isHullEdge(std::size_t i, std::size_t j) const
  {
    return i != j &&
      std::all_of(vertices_.begin(), vertices_.end(),
        [&](const Point& p) { return orientSign(vertices_[i], vertices_[j], p) >= 0; });
  }

  /// The error allowed in each coordinate of a corner.
  static mpq_class slackAt(const Vector& corner, const Vector& site)
  {
    const mpq_class far = abs(corner.x - site.x) + abs(corner.y - site.y);
    const mpq_class size = std::max(mpq_class(abs(corner.x)), mpq_class(abs(corner.y)));
    return (size + far) * mpq_class(0x1p-50) + mpq_class(0x1p-1073);
  }

  static bool isAt(const Vector& a, const Vector& b, const mpq_class& slack)
  {
    return abs(a.x - b.x) <= slack && abs(a.y - b.y) <= slack;
  }

  std::string faultOf(std::size_t k) const
  {
    const Polygon exact = exactCell(k);
    const bool isEmpty = cells_.offsets[k] == cells_.offsets[k + 1];
    if (!polygon_.empty() && (isEmpty || twiceArea(exact) == 0))
    {
      return isEmpty != (twiceArea(exact) == 0) ? "is empty, or should be" : "";
    }
    const Vector site = exactly(vertices_[k]);
    Polygon found;
    mpq_class slack = 0, length = 0;
    std::vector<mpq_class> slacks;
    for (const Vector& corner : exact)
    {
      slacks.push_back(slackAt(corner, site));
      slack = std::max(slack, slacks.back());
      length += 2 * (abs(corner.x - site.x) + abs(corner.y - site.y) + slack);
    }
    for (std::int32_t i = cells_.offsets[k]; i < cells_.offsets[k + 1]; ++i)
    {
      const std::int32_t number = cells_.corners[static_cast<std::size_t>(i)];
      const Point corner = cells_.points[static_cast<std::size_t>(number)];
      found.push_back(exactly(corner));
      bool isRight = corner == vertices_[k]; // on a straight side of the hull, or of a tiny cell
      for (std::size_t e = 0; e < exact.size(); ++e)
      {
        isRight = isRight || isAt(found.back(), exact[e], slacks[e]);
      }
      if (!isRight)
      {
        return "has a corner of its own at " + hexText(corner);
      }
    }
    for (std::size_t e = 0; e < exact.size(); ++e)
    {
      const auto isThere = [&](const Vector& p) { return isAt(p, exact[e], slacks[e]); };
      if (std::none_of(found.begin(), found.end(), isThere))
      {
        return "lacks a corner at " + hexText({ exact[e].x.get_d(), exact[e].y.get_d() });
      }
    }
    const bool isAsLarge = abs(twiceArea(found) - twiceArea(exact)) <= 4 * slack * length;
    return isAsLarge ? "" : "has another area";
  }

  const VoronoiCells& cells_;
  const VoronoiClip clip_;
  std::vector<Point> vertices_;
  Polygon polygon_;
};

} // namespace

std::string faultsOfCells(const PointView& points, VoronoiClip clip, const VoronoiCells& cells)
{
  return Judge(points, clip, {}, cells).faults();
}

std::string faultsOfCells(
  const PointView& points, const std::vector<Point>& polygon, const VoronoiCells& cells)
{
  return Judge(points, VoronoiClip::Polygon, polygon, cells).faults();
}

} // namespace test
} // namespace ahd
