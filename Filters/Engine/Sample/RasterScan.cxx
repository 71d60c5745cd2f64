// SPDX-License-Identifier: BSD-3-Clause
#include "RasterScan.h"

#include "../Core/Loops.h"
#include "RasterTask.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

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
  if (!scanTriangles(report, ticker))
  {
    return false;
  }
  report.outside = raster_.columns * raster_.rows - report.valued;
  return report.outside == 0 || scanRim(report, ticker);
}

/// work(task, report, ticker) for each; adds up the reports.
template <typename Work>
bool RasterScan::inTasks(std::size_t tasks, SampleReport& report, Ticker& ticker, const Work& work)
{
  std::vector<SampleReport> reports(tasks);
  const bool done = inParallel(
    ticker, tasks, [&](std::size_t task, Ticker& own) { return work(task, reports[task], own); });
  for (const SampleReport& some : reports)
  {
    addCounts(some, report);
  }
  return done;
}

bool RasterScan::scanTriangles(SampleReport& report, Ticker& ticker)
{
  const std::size_t triangles = surface_.tables->triangles();
  const std::size_t cells = raster_.columns * raster_.rows;
  const std::size_t tasks = tasksFor(threadsOf(ticker), triangles, 8, kChunk);
  const RasterGrid grid{ x_.data() + 1, y_.data() + 1, raster_.columns, raster_.rows,
    raster_.at(0, 0), { 1.0 / raster_.spacing.x, 1.0 / raster_.spacing.y }, error_ };
  return inTasks(tasks, report, ticker,
    [&](std::size_t number, SampleReport& found, Ticker& own)
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
      found = task.report();
      return true;
    });
}

/// Finds the cells next to the rim that are outside by no more than rounding.
class RasterScan::RimTask
{
public:
  explicit RimTask(const RasterScan& scan)
    : scan_(scan)
    , finder_(scan.surface_)
    , rim_(scan.surface_)
    , sink_(scan.columns_, scan.surface_, scan.mask_, false)
  {
  }

  /// The tiles of a row of them. Returns false if cancelled.
  bool run(std::size_t row, Ticker& ticker)
  {
    const SampleRaster& raster = scan_.raster_;
    const std::size_t first = row * kTile, last = std::min(raster.rows, first + kTile);
    for (std::size_t column = 0; column < raster.columns; column += kTile)
    {
      const std::size_t end = std::min(raster.columns, column + kTile);
      bool isNear = false;
      if (!scan_.rim_.mayBeNear(
            Box::around(raster.at(column, first), raster.at(end - 1, last - 1)), ticker, isNear) ||
        (isNear && !look(column, end, first, last, ticker)))
      {
        return false;
      }
    }
    return true;
  }

  const SampleReport& report() const { return sink_.report(); }

  static constexpr std::size_t kTile = 16; ///< cells along each side

private:
  bool look(std::size_t column, std::size_t end, std::size_t row, std::size_t last, Ticker& ticker)
  {
    for (; row != last; ++row)
    {
      for (std::size_t k = column; k != end; ++k)
      {
        if (!lookAt(k, row, ticker))
        {
          return false;
        }
      }
    }
    return true;
  }

  bool lookAt(std::size_t column, std::size_t row, Ticker& ticker)
  {
    const Point place = scan_.raster_.at(column, row);
    RimPlace nearest;
    Spot spot;
    Weights found;
    if (!scan_.rim_.findWithinRounding(place, ticker, nearest))
    {
      return false;
    }
    if (!nearest.is)
    {
      return true;
    }
    if (!finder_.find(place, ticker, spot))
    {
      return false;
    }
    return spot.kind != Spot::Outside ||
      (rim_.nearestTo(place, nearest, ticker, found) &&
        sink_.put(row * scan_.raster_.columns + column, found, ticker));
  }

  const RasterScan& scan_;
  SpotFinder finder_;
  RimWeights rim_;
  ValueSink sink_;
};

bool RasterScan::scanRim(SampleReport& report, Ticker& ticker)
{
  const std::size_t rows = (raster_.rows + RimTask::kTile - 1) / RimTask::kTile;
  const std::size_t tasks = tasksFor(threadsOf(ticker), rows, 8, 1);
  SampleReport atRim;
  const bool done = inTasks(tasks, atRim, ticker,
    [&](std::size_t number, SampleReport& found, Ticker& own)
    {
      RimTask task(*this);
      const Share share(rows, number, tasks);
      for (std::size_t row = share.begin; row != share.end; ++row)
      {
        if (!task.run(row, own))
        {
          return false;
        }
      }
      found = task.report();
      return true;
    });
  addCounts(atRim, report);
  report.outside -= atRim.valued;
  return done;
}

} // namespace ahd
