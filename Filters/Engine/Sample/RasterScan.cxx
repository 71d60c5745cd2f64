// SPDX-License-Identifier: BSD-3-Clause
#include "RasterScan.h"

#include "../Core/Loops.h"
#include "RasterTask.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

} // namespace

bool RasterScan::isApplicable(const Bounds& bounds)
{
  constexpr std::size_t kTrianglesPerCell = 2; // fewer cells are found by walking
  const std::size_t cells = raster_.columns * raster_.rows;
  if (cells < surface_.tables->triangles() / kTrianglesPerCell || cells == 0)
  {
    return false;
  }
  const Point first = raster_.at(0, 0), last = raster_.at(raster_.columns - 1, raster_.rows - 1);
  const double x = std::max({ std::fabs(bounds.xmin), std::fabs(bounds.xmax),
    std::fabs(raster_.origin.x), std::fabs(first.x), std::fabs(last.x) });
  const double y = std::max({ std::fabs(bounds.ymin), std::fabs(bounds.ymax),
    std::fabs(raster_.origin.y), std::fabs(first.y), std::fabs(last.y) });
  error_ = RasterTask::kCrossingError * x;
  // Columns and rows are to be where they are looked for, give or take a few.
  constexpr double kLeastSpacing = 0x1p-48;
  return isFinite(first) && isFinite(last) && raster_.spacing.x > kLeastSpacing * x &&
    x > 0x1p-300 && x < 0x1p300 && raster_.spacing.y > kLeastSpacing * y && y > 0x1p-300 &&
    y < 0x1p300;
}

/// No cell has a value yet.
bool RasterScan::clear(Ticker& ticker)
{
  return inChunksOf(raster_.columns * raster_.rows, ticker,
    [this](std::size_t a, std::size_t b)
    {
      if (mask_)
      {
        std::fill(mask_ + a, mask_ + b, static_cast<unsigned char>(0));
      }
      for (const SampledColumn& column : columns_)
      {
        const std::size_t n = column.components;
        std::fill(column.out + a * n, column.out + b * n, kNaN);
        if (column.gradients)
        {
          std::fill(column.gradients + 2 * a * n, column.gradients + 2 * b * n, kNaN);
        }
      }
    });
}

bool RasterScan::run(SampleReport& report, Ticker& ticker)
{
  constexpr double kFar = std::numeric_limits<double>::infinity();
  x_.allocate(raster_.columns + 2);
  y_.allocate(raster_.rows + 2);
  x_[0] = y_[0] = -kFar;
  x_[raster_.columns + 1] = y_[raster_.rows + 1] = kFar;
  const auto setX = [this](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      x_[k + 1] = raster_.at(k, 0).x;
    }
  };
  const auto setY = [this](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      y_[k + 1] = raster_.at(0, k).y;
    }
  };
  if (!inChunks(0, raster_.columns, ticker, setX) || !inChunks(0, raster_.rows, ticker, setY) ||
    !clear(ticker))
  {
    return false;
  }
  const std::size_t triangles = surface_.tables->triangles();
  const std::size_t cells = raster_.columns * raster_.rows;
  const std::size_t tasks = tasksFor(threadsOf(ticker), triangles, 8, kChunk);
  const RasterGrid grid{ x_.data() + 1, y_.data() + 1, raster_.columns, raster_.rows,
    raster_.at(0, 0), { 1.0 / raster_.spacing.x, 1.0 / raster_.spacing.y }, error_ };
  std::vector<SampleReport> reports(tasks);
  const bool done = inParallel(ticker, tasks,
    [&](std::size_t number, Ticker& own)
    {
      RasterTask task(surface_, grid, columns_, mask_);
      const Share share(triangles, number, tasks);
      for (std::size_t t = share.begin; t != share.end; ++t)
      {
        if (!task.scan(t, own))
        {
          return false;
        }
      }
      own.finished(cells / tasks);
      reports[number] = task.report();
      return true;
    });
  for (const SampleReport& some : reports)
  {
    addTo(report, some);
  }
  report.outside = cells - report.valued;
  return done;
}

} // namespace ahd
