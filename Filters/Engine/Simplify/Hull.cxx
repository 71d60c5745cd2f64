// SPDX-License-Identifier: BSD-3-Clause
#include "Hull.h"

#include "../Core/Loops.h"
#include "../Core/SortAsking.h"
#include "../Predicates/Predicates.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ahd
{
namespace
{

/// The outermost points in eight directions; which of equal ones does not matter.
struct Extremes
{
  static constexpr std::size_t kDirections = 4;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, kDirections> low{ { kInfinity, kInfinity, kInfinity, kInfinity } };
  std::array<double, kDirections> high{ { -kInfinity, -kInfinity, -kInfinity, -kInfinity } };
  std::array<Index, kDirections> lowest{}, highest{};

  void add(std::size_t k, double along, Index ofLow, Index ofHigh, double alongHigh)
  {
    lowest[k] = along < low[k] ? ofLow : lowest[k];
    low[k] = std::min(low[k], along);
    highest[k] = alongHigh > high[k] ? ofHigh : highest[k];
    high[k] = std::max(high[k], alongHigh);
  }
  void add(const Point& p, Index i)
  {
    const double along[kDirections] = { p.x, p.y, p.x + p.y, p.x - p.y };
    for (std::size_t k = 0; k < kDirections; ++k)
    {
      add(k, along[k], i, i, along[k]);
    }
  }
  void merge(const Extremes& other)
  {
    for (std::size_t k = 0; k < kDirections; ++k)
    {
      add(k, other.low[k], other.lowest[k], other.highest[k], other.high[k]);
    }
  }
};

struct Outside
{
  std::vector<Index> points;
  void merge(const Outside& other)
  {
    points.insert(points.end(), other.points.begin(), other.points.end());
  }
};

/// Of points in lexicographic order: Andrew's chains, the lower one and then the upper one back.
bool chains(
  const Point* points, const std::vector<Index>& sorted, Ticker& ticker, std::vector<Index>& hull)
{
  hull.clear();
  const auto append = [&](Index i, std::size_t base)
  {
    while (hull.size() > base + 1 &&
      orient2d(points[hull[hull.size() - 2]], points[hull.back()], points[i]) <= 0)
    {
      hull.pop_back();
    }
    hull.push_back(i);
  };
  const std::size_t n = sorted.size();
  bool goesOn = inSteps(0, n, ticker, [&](std::size_t i) { append(sorted[i], 0); });
  const std::size_t base = hull.size() - 1;
  goesOn = goesOn && inSteps(1, n, ticker, [&](std::size_t i) { append(sorted[n - 1 - i], base); });
  hull.pop_back(); // the first again
  return goesOn;
}

bool sortByPlace(const Point* points, Ticker& ticker, std::vector<Index>& items)
{
  std::vector<Index> other(items.size());
  return sortAsking(items.data(), items.size(), other.data(), ticker,
    [&](Index a, Index b) { return lexicographicallyLess(points[a], points[b]); });
}

/// What lies inside of a polygon of hull points is no corner of the hull.
struct Inner
{
  std::vector<Point> polygon;
  Bounds box; ///< inside of it, for most points; left of right if there is none

  bool hasInside(const Point& p) const
  {
    const bool isInBox = p.x > box.xmin && p.x < box.xmax && p.y > box.ymin && p.y < box.ymax;
    bool is = isInBox || polygon.size() > 2;
    for (std::size_t k = 0; !isInBox && is && k < polygon.size(); ++k)
    {
      is = orient2d(polygon[k], polygon[k + 1 < polygon.size() ? k + 1 : 0], p) > 0;
    }
    return is;
  }
};

/// A box among points near the four corners of all. From its left to its right the segment between
/// the lower two is nowhere above it, and that between the upper two nowhere below: it is inside of
/// their hull.
Bounds boxWithin(const Point& sw, const Point& se, const Point& ne, const Point& nw)
{
  return { std::max(sw.x, nw.x), std::min(se.x, ne.x), std::max(sw.y, se.y), std::min(nw.y, ne.y) };
}

bool findInner(const Point* points, std::size_t count, Ticker& ticker, Inner& inner)
{
  Extremes extremes;
  const bool goesOn = gather(count, ticker, extremes,
    [&](Extremes& part, std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        part.add(points[i], static_cast<Index>(i));
      }
    });
  std::vector<Index> ends(extremes.lowest.begin(), extremes.lowest.end()), hull;
  ends.insert(ends.end(), extremes.highest.begin(), extremes.highest.end());
  std::sort(ends.begin(), ends.end(),
    [&](Index a, Index b) { return lexicographicallyLess(points[a], points[b]); });
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  chains(points, ends, ticker, hull);
  for (const Index i : hull)
  {
    inner.polygon.push_back(points[i]);
  }
  inner.box = boxWithin(points[extremes.lowest[2]], points[extremes.highest[3]],
    points[extremes.highest[2]], points[extremes.lowest[3]]);
  return goesOn;
}

} // namespace

bool findHullCorners(
  const Point* points, std::size_t count, Ticker& ticker, std::vector<Index>& corners)
{
  corners.clear();
  Inner inner;
  if (count == 0)
  {
    return true;
  }
  if (!findInner(points, count, ticker, inner))
  {
    return false;
  }
  Outside outside;
  return gather(count, ticker, outside,
           [&](Outside& part, std::size_t a, std::size_t b)
           {
             for (std::size_t i = a; i != b; ++i)
             {
               if (!inner.hasInside(points[i]))
               {
                 part.points.push_back(static_cast<Index>(i));
               }
             }
           }) &&
    sortByPlace(points, ticker, outside.points) && chains(points, outside.points, ticker, corners);
}

} // namespace ahd
