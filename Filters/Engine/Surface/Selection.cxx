// SPDX-License-Identifier: BSD-3-Clause
#include "Selection.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Core/SortAsking.h"
#include "../Triangulation/Triangulation.h"
#include "Circumradius.h"
#include "Vectors.h"

#include <algorithm>

namespace ahd
{
namespace
{

/// One call of selectBySize(), when the tables are made. What returns a bool returns false if the
/// work is to be cancelled.
class Selecting
{
public:
  Selecting(const Triangulation& triangulation, const SizeLimits& limits,
    const PointsToMeasure& points, Selection& out)
    : triangulation_(triangulation)
    , limits_(limits)
    , points_(points)
    , out_(out)
  {
  }

  bool run(Ticker& ticker);

private:
  bool markTriangles(Ticker& ticker);
  bool markUsed(Ticker& ticker);
  bool findLines(Ticker& ticker);
  void findLinesOf(std::size_t triangle);
  bool findLinesBetweenCollinear(Ticker& ticker);
  bool findVertices(Ticker& ticker);
  bool countKept(Ticker& ticker);
  void hide();
  bool isSelected(std::size_t triangle) const;
  bool isTooLong(Index a, Index b) const;
  void addLine(Index a, Index b);
  Vector3 placeOf(Index vertex) const;
  Index cornerOf(HalfEdge h) const { return triangulation_.pointOf(triangulation_.origin(h)); }

  const Triangulation& triangulation_;
  const SizeLimits& limits_;
  const PointsToMeasure& points_;
  Selection& out_;
  std::vector<unsigned char> used_; ///< of each point: is it a corner of a triangle or line?
};

/// Are the two points farther from each other?
bool isLonger(const Point& p, const Point& q, double length)
{
  return lengthOf({ { p.x - q.x, p.y - q.y, 0.0 } }) > length;
}

HalfEdge halfEdge(std::size_t triangle, std::size_t e)
{
  return static_cast<HalfEdge>(3 * triangle + e);
}

bool Selecting::run(Ticker& ticker)
{
  if (!ticker.ask() || !markTriangles(ticker))
  {
    return false;
  }
  if (limits_.alpha > 0.0)
  {
    used_.assign(triangulation_.points().count, 0);
    const bool areCollinear = triangulation_.triangleCount() == 0;
    const bool isDone = markUsed(ticker) &&
      (areCollinear ? findLinesBetweenCollinear(ticker) : findLines(ticker)) &&
      findVertices(ticker);
    if (!isDone)
    {
      return false;
    }
    hide();
  }
  return countKept(ticker) && ticker.ask();
}

bool Selecting::markTriangles(Ticker& ticker)
{
  const std::size_t count = triangulation_.triangleCount();
  out_.kept.resize(count);
  return inChunksOf(count, ticker,
    [this](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        out_.kept[t] = isSelected(t) ? 1 : 0;
      }
    });
}

bool Selecting::isSelected(std::size_t triangle) const
{
  if (!triangulation_.isKept(triangle))
  {
    return false;
  }
  const HalfEdge h = halfEdge(triangle, 0);
  const Index a = triangulation_.origin(h);
  const Index b = triangulation_.origin(h + 1);
  const Index c = triangulation_.origin(h + 2);
  if (isTooLong(a, b) || isTooLong(b, c) || isTooLong(c, a))
  {
    return false;
  }
  // Not the same as <= where it is NaN.
  return !(limits_.alpha > 0.0 && circumradius(placeOf(a), placeOf(b), placeOf(c)) > limits_.alpha);
}

/// Is the edge between the two vertices?
bool Selecting::isTooLong(Index a, Index b) const
{
  if (!(limits_.maximumEdgeLength > 0.0))
  {
    return false;
  }
  return isLonger(triangulation_.at(a), triangulation_.at(b), limits_.maximumEdgeLength);
}

/// Where the user sees it.
Vector3 Selecting::placeOf(Index vertex) const
{
  return points_.inSpace.place(triangulation_.pointOf(vertex));
}

bool Selecting::markUsed(Ticker& ticker)
{
  return inChunks(0, triangulation_.triangleCount(), ticker,
    [this](std::size_t begin, std::size_t end)
    {
      for (std::size_t h = 3 * begin; h < 3 * end; ++h)
      {
        used_[cornerOf(static_cast<HalfEdge>(h))] |= out_.kept[h / 3];
      }
    });
}

bool Selecting::findLines(Ticker& ticker)
{
  return inChunks(0, triangulation_.triangleCount(), ticker,
    [this](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        if (triangulation_.isKept(t) && !out_.kept[t])
        {
          findLinesOf(t);
        }
      }
    });
}

/// Those edges of a triangle that is too large which are not part of one that is put out. Of two
/// triangles that are too large the first has their edge.
void Selecting::findLinesOf(std::size_t triangle)
{
  for (std::size_t e = 0; e < 3; ++e)
  {
    const HalfEdge h = halfEdge(triangle, e);
    const HalfEdge twin = triangulation_.twin(h);
    const std::size_t other = twin / 3;
    if (twin == kNoHalfEdge || !triangulation_.isKept(other) ||
      (other > triangle && !out_.kept[other]))
    {
      addLine(triangulation_.origin(h), triangulation_.target(h));
    }
  }
}

bool Selecting::findLinesBetweenCollinear(Ticker& ticker)
{
  std::vector<Index> vertices;
  const bool all = inChunks(0, triangulation_.vertexCount(), ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        const Index vertex = static_cast<Index>(v);
        if (triangulation_.vertexOf(triangulation_.pointOf(vertex)) == vertex)
        {
          vertices.push_back(vertex); // not beyond the limit
        }
      }
    });
  const auto isLess = [this](Index a, Index b)
  { return lexicographicallyLess(triangulation_.at(a), triangulation_.at(b)); };
  return all && sortAsking(vertices, ticker, isLess) &&
    inChunks(1, vertices.size(), ticker,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          addLine(vertices[i - 1], vertices[i]);
        }
      });
}

/// Adds the edge between two vertices, unless it is too long.
void Selecting::addLine(Index a, Index b)
{
  const Index first = triangulation_.pointOf(a);
  const Index second = triangulation_.pointOf(b);
  const Vector3 p = placeOf(a), q = placeOf(b);
  if (0.5 * lengthOf({ { p[0] - q[0], p[1] - q[1], p[2] - q[2] } }) <= limits_.alpha &&
    !isTooLong(a, b))
  {
    used_[first] = 1;
    used_[second] = 1;
    out_.lines.push_back(static_cast<std::int32_t>(first));
    out_.lines.push_back(static_cast<std::int32_t>(second));
  }
}

/// A merged point is taken for what it was merged into.
bool Selecting::findVertices(Ticker& ticker)
{
  static const std::vector<MergedPoint> kNone;
  const std::vector<MergedPoint>& merged = points_.merged ? *points_.merged : kNone;
  std::size_t next = 0; // of merged
  return inChunks(0, used_.size(), ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const bool isMerged = next < merged.size() && merged[next].id == i;
        const std::size_t at = isMerged ? merged[next++].keptId : i;
        if (!used_[i] && triangulation_.vertexOf(at) != kNoIndex)
        {
          out_.vertices.push_back(static_cast<std::int32_t>(i));
        }
      }
    });
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

bool Selecting::countKept(Ticker& ticker)
{
  out_.keptCount = 0;
  return inChunks(0, out_.kept.size(), ticker,
    [this](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        out_.keptCount += out_.kept[t];
      }
    });
}

} // namespace

Status selectBySize(Triangulation& triangulation, const SizeLimits& limits,
  const PointsToMeasure& points, const Context& context, Selection& out)
{
  out = Selection();
  const bool isAlpha = limits.alpha > 0.0;
  Status status = isAlpha ? triangulation.makeNeighbors(context)
                          : triangulation.makeCorners(context);
  if (status == Status::Ok && isAlpha)
  {
    status = triangulation.makePointMap(context);
  }
  if (status != Status::Ok)
  {
    return status;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      return Selecting(triangulation, limits, points, out).run(ticker);
    });
}

Status findShort(const std::int32_t* triples, std::size_t triangles, const PointView& places,
  double length, const Context& context, std::vector<unsigned char>& kept)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      kept.assign(triangles, 0);
      const auto find = [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t t = begin; t < end; ++t)
        {
          const auto corner = [&](std::size_t k)
          { return places[static_cast<std::size_t>(triples[3 * t + k])]; };
          const Point a = corner(0), b = corner(1), c = corner(2);
          kept[t] = !isLonger(a, b, length) && !isLonger(b, c, length) && !isLonger(c, a, length);
        }
      };
      return inChunks(0, triangles, ticker, find) && ticker.ask();
    });
}

std::size_t selectionMemoryEstimate(std::size_t pointCount)
{
  return pointCount * 70;
}

} // namespace ahd
