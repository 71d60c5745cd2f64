// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Visits_h
#define ahd_Visits_h

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"
#include "../Order/CurveOrder.h"
#include "Sample.h"
#include "Values.h"

#include <algorithm>
#include <vector>

namespace ahd
{

/// One task: finds the weights at places by a method of its own, and hands them to its own sink.
template <typename Method, typename Sink>
class Visitor
{
public:
  Visitor(const Method& method, const Sink& sink)
    : method_(method)
    , sink_(sink)
  {
  }

  /// Returns false if cancelled; may throw std::bad_alloc.
  bool visit(std::size_t k, const Point& place, Ticker& ticker)
  {
    if (!isFinite(place))
    {
      sink_.putNone(k, false);
      return ticker.step();
    }
    Weights found;
    if (!method_.weightsAt(place, ticker, found))
    {
      return false;
    }
    if (found.count == 0)
    {
      sink_.putNone(k, true);
      return true;
    }
    return sink_.put(k, found, ticker);
  }

  SampleReport report() const { return sink_.report(); }

private:
  Method method_;
  Sink sink_;
};

/// Calls visit() of a visitor for each place, all of them on the threads lent, and adds what
/// became of them to the report. Returns false if cancelled; throws std::bad_alloc.
template <typename Method, typename Sink>
class Visits
{
public:
  Visits(const SamplePlaces& places, const Method& method, const Sink& sink, SampleReport& report)
    : places_(places)
    , first_(method, sink)
    , report_(report)
  {
  }

  bool run(const Bounds& bounds, Ticker& ticker)
  {
    return places_.isRaster() ? inTiles(ticker) : alongCurve(bounds, ticker);
  }

private:
  static constexpr std::size_t kTile = 32; ///< cells along each side

  /// work(visitor, item, ticker) for each item.
  template <typename Work>
  bool inTasks(std::size_t items, std::size_t least, Ticker& ticker, const Work& work)
  {
    const std::size_t tasks = tasksFor(threadsOf(ticker), items, 8, least);
    std::vector<SampleReport> reports(tasks);
    const bool done = inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        Visitor<Method, Sink> visitor(first_);
        const Share share(items, task, tasks);
        for (std::size_t k = share.begin; k != share.end; ++k)
        {
          if (!work(visitor, k, own))
          {
            return false;
          }
        }
        reports[task] = visitor.report();
        return true;
      });
    for (const SampleReport& report : reports)
    {
      addCounts(report, report_);
    }
    return done;
  }

  bool alongCurve(const Bounds& bounds, Ticker& ticker)
  {
    const PointView& points = places_.points();
    for (std::size_t begin = 0; begin < points.count; begin += CurveOrder::kBlock)
    {
      const std::size_t end = std::min(points.count, begin + CurveOrder::kBlock);
      CurveOrder order;
      const auto visit = [&](Visitor<Method, Sink>& visitor, std::size_t k, Ticker& own)
      {
        constexpr std::size_t kAhead = 8;
        points.prefetch(order[std::min(k + kAhead, end - begin - 1)]);
        own.finished(1);
        return visitor.visit(order[k], points[order[k]], own);
      };
      if (!order.build(points, begin, end, bounds, ticker) ||
        !inTasks(end - begin, kChunk, ticker, visit))
      {
        return false;
      }
    }
    return true;
  }

  bool inTiles(Ticker& ticker)
  {
    const SampleRaster& raster = places_.raster();
    const std::size_t across = (raster.columns + kTile - 1) / kTile;
    const std::size_t along = (raster.rows + kTile - 1) / kTile;
    return inTasks(across * along, 4, ticker,
      [&](Visitor<Method, Sink>& visitor, std::size_t tile, Ticker& own)
      {
        const std::size_t row = tile / across, column = tile % across;
        return inTile(
          visitor, row * kTile, (row % 2 == 0 ? column : across - 1 - column) * kTile, own);
      });
  }

  /// Row by row, one this way and the next back.
  bool inTile(Visitor<Method, Sink>& visitor, std::size_t row, std::size_t column, Ticker& ticker)
  {
    const SampleRaster& raster = places_.raster();
    const std::size_t lastRow = std::min(raster.rows, row + kTile);
    const std::size_t columns = std::min(raster.columns, column + kTile) - column;
    for (; row != lastRow; ++row)
    {
      for (std::size_t k = 0; k != columns; ++k)
      {
        const std::size_t c = column + (row % 2 == 0 ? k : columns - 1 - k);
        if (!visitor.visit(row * raster.columns + c, raster.at(c, row), ticker))
        {
          return false;
        }
      }
      ticker.finished(columns);
    }
    return true;
  }

  const SamplePlaces& places_;
  const Visitor<Method, Sink> first_;
  SampleReport& report_;
};

} // namespace ahd

#endif
