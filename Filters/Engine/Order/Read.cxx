// SPDX-License-Identifier: BSD-3-Clause
#include "../Chunks.h"
#include "Rank.h"

#include <limits>

namespace ahd
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Bounds of the points seen; the signs of zeros are left to chance.
struct Extremes
{
  double xmin = kInfinity, xmax = -kInfinity;
  double ymin = kInfinity, ymax = -kInfinity;

  void add(const Point& p)
  {
    xmin = p.x < xmin ? p.x : xmin;
    xmax = p.x > xmax ? p.x : xmax;
    ymin = p.y < ymin ? p.y : ymin;
    ymax = p.y > ymax ? p.y : ymax;
  }

  /// The zero of a coordinate is +0.0.
  Bounds bounds() const
  {
    return xmin <= xmax ? Bounds{ xmin + 0.0, xmax + 0.0, ymin + 0.0, ymax + 0.0 } : Bounds{};
  }
};

/// The usual chunk, of finite points none of which is skipped. Returns false, with `seen`
/// unchanged, if it is not one.
bool readPlainChunk(const PointView& points, std::size_t a, std::size_t b, Extremes& seen)
{
  if (points.skip)
  {
    return false;
  }
  Extremes all = seen;
  double sum = 0.0; // of zeros; NaN as soon as a coordinate is not finite
  for (std::size_t i = a; i < b; ++i)
  {
    const Point p = points[i];
    sum += p.x * 0.0 + p.y * 0.0;
    all.add(p);
  }
  if (!(sum == 0.0))
  {
    return false;
  }
  seen = all;
  return true;
}

} // namespace

Status readPoints(const PointView& points, Ticker& ticker, RankedPoints& out)
{
  Extremes seen;
  out.notFinite = 0;
  out.skipped = 0;
  const auto readChunk = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i < b; ++i)
    {
      if (points.skipped(i))
      {
        ++out.skipped;
      }
      else if (!isFinite(points[i]))
      {
        ++out.notFinite;
      }
      else
      {
        seen.add(points[i]);
      }
    }
  };
  const bool done = inChunks(0, points.count, ticker,
    [&](std::size_t a, std::size_t b)
    {
      if (!readPlainChunk(points, a, b, seen))
      {
        readChunk(a, b);
      }
      ticker.finished(b - a);
    });
  if (!done)
  {
    return Status::Cancelled;
  }
  out.bounds = seen.bounds();
  out.count = static_cast<Index>(points.count - out.notFinite - out.skipped);
  return Status::Ok;
}

} // namespace ahd
