// SPDX-License-Identifier: BSD-3-Clause
#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "../Points/JoinedBounds.h"
#include "Rank.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace ahd
{

namespace
{

constexpr std::size_t kReadersPerThread = 4;
constexpr std::size_t kFewToRead = 4 * kChunk; // no task for less
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Bounds of the points seen; the signs of zeros are unspecified.
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

  void add(const Extremes& other)
  {
    xmin = std::min(xmin, other.xmin);
    xmax = std::max(xmax, other.xmax);
    ymin = std::min(ymin, other.ymin);
    ymax = std::max(ymax, other.ymax);
  }

  /// The zero of a coordinate is +0.0.
  Bounds bounds() const
  {
    return xmin <= xmax ? Bounds{ xmin + 0.0, xmax + 0.0, ymin + 0.0, ymax + 0.0 } : Bounds{};
  }
};

/// The result of a task.
struct Seen
{
  Extremes extremes;
  std::size_t notFinite = 0;
  std::size_t skipped = 0;

  void add(const Seen& other)
  {
    extremes.add(other.extremes);
    notFinite += other.notFinite;
    skipped += other.skipped;
  }
};

/// The common case: all points of the chunk are finite and none is skipped. Returns false, with
/// `seen` unchanged, if it is not one.
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

void readChunk(const PointView& points, std::size_t a, std::size_t b, Seen& seen)
{
  for (std::size_t i = a; i < b; ++i)
  {
    if (points.skipped(i))
    {
      ++seen.skipped;
    }
    else if (!isFinite(points[i]))
    {
      ++seen.notFinite;
    }
    else
    {
      seen.extremes.add(points[i]);
    }
  }
}

bool readShare(const PointView& points, const Share& share, Ticker& ticker, Seen& result)
{
  Seen seen; // not directly in the result: it shares a cache line with those of other tasks
  const bool done = inChunks(share.begin, share.end, ticker,
    [&](std::size_t a, std::size_t b)
    {
      if (!readPlainChunk(points, a, b, seen.extremes))
      {
        readChunk(points, a, b, seen);
      }
      ticker.finished(b - a);
    });
  result = seen;
  return done;
}

} // namespace

Status readPoints(
  const PointView& points, Ticker& ticker, RankedPoints& out, const RankBounds& least)
{
  const std::size_t tasks = tasksFor(
    threadsOf(ticker), points.count, kReadersPerThread, kFewToRead);
  std::vector<Seen> seen(tasks);
  const bool done = inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own) {
      return readShare(points, { points.count, task, tasks }, own, seen[task]);
    });
  if (!done)
  {
    return Status::Cancelled;
  }
  Seen all;
  for (const Seen& part : seen)
  {
    all.add(part);
  }
  out.notFinite = all.notFinite;
  out.skipped = all.skipped;
  out.bounds = all.extremes.bounds();
  out.whole = joined(out.bounds, Bounds{ least.xmin, least.xmax, least.ymin, least.ymax });
  out.count = static_cast<Index>(points.count - out.notFinite - out.skipped);
  return Status::Ok;
}

} // namespace ahd
