// SPDX-License-Identifier: BSD-3-Clause
//
// Queries of a result besides its arrays: the drawing of the order, values at points between
// others, locations of places.
#include "Arrays.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Order/CurveOrder.h"
#include "../Surface/OrderDrawing.h"
#include "Refusal.h"

#include <algorithm>
#include <string>

namespace ahd
{
namespace
{

template <typename Id>
Status draw(JobResult& made, const GivenDrawing& drawing, const Context& context)
{
  OrderDrawing<Id> to;
  to.xyz = drawing.xyz;
  to.ranks = static_cast<Id*>(drawing.ranks);
  to.ids = static_cast<Id*>(drawing.ids);
  to.levels = drawing.levels;
  to.counts = static_cast<Id*>(drawing.counts);
  const bool withCurve = made.asked.curve;
  return ahd::drawOrder(made.triangulation, withCurve, to, context);
}

/// The numbers of the output cells of triangles.
Status numberCells(JobResult& made, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      const std::size_t count = made.triangulation.triangleCount();
      std::vector<std::int32_t> cellOf(count, -1);
      auto cell = static_cast<std::int32_t>(made.cellCount() - made.triangleCount());
      Ticker ticker(context.progress, Phase::Outputs, 0);
      const bool all = inChunks(0, count, ticker,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            const bool isOut = made.isSelected() ? made.selection.kept[i] != 0
                                                 : made.triangulation.isKept(i);
            cellOf[i] = isOut ? cell++ : -1;
          }
        });
      made.cellOf = all ? std::move(cellOf) : std::vector<std::int32_t>();
      return all;
    });
}

/// One call of locate().
class Locating
{
public:
  explicit Locating(const JobResult& made)
    : made_(made)
    , triangulation_(made.triangulation)
  {
  }

  /// Returns false if cancelled.
  bool operator()(const Point& place, std::size_t i, const Places& out, Ticker& ticker)
  {
    const Location found = triangulation_.locate(place, hint_, ticker);
    out.kinds[i] = static_cast<std::int32_t>(kindOf(found.kind));
    std::int64_t* const ids = out.ids + 3 * i;
    std::fill_n(ids, 3, std::int64_t(-1));
    std::int64_t cell = -1;
    switch (found.kind)
    {
      case Location::InTriangle:
        writeCorners(found.halfEdge, 3, ids);
        cell = cellOf(found.halfEdge);
        break;
      case Location::OnEdge:
        writeCorners(found.halfEdge, 2, ids);
        cell = cellOf(found.halfEdge);
        cell = cell < 0 ? cellOf(triangulation_.twin(found.halfEdge)) : cell;
        break;
      case Location::OnVertex:
        writeCorners(found.halfEdge, 1, ids);
        cell = cellAround(found.halfEdge);
        break;
      default:
        break;
    }
    hint_ = found.halfEdge == kNoHalfEdge ? hint_ : found.halfEdge / 3;
    if (out.cells)
    {
      out.cells[i] = cell;
    }
    return ticker.step() && !ticker.cancelled();
  }

private:
  void writeCorners(HalfEdge h, int count, std::int64_t* ids) const
  {
    for (int k = 0; k < count; ++k, h = nextInTriangle(h))
    {
      ids[k] = triangulation_.pointOf(triangulation_.origin(h));
    }
  }

  std::int64_t cellOf(HalfEdge h) const
  {
    return h == kNoHalfEdge ? -1 : std::int64_t(made_.cellOf[h / 3]);
  }

  /// Of a triangle around the vertex where the half-edge, its first, begins.
  std::int64_t cellAround(HalfEdge first) const
  {
    HalfEdge h = first;
    std::int64_t cell = -1;
    do
    {
      cell = cellOf(h);
      h = triangulation_.nextAround(h);
    } while (cell < 0 && h != kNoHalfEdge && h != first);
    return cell;
  }

  const JobResult& made_;
  const Triangulation& triangulation_;
  std::size_t hint_ = 0;
};

/// Each search starts at the result of the one before. Returns false if cancelled; throws
/// std::bad_alloc.
bool locateAll(const JobResult& made, const PointView& places, const Places& out, Ticker& ticker)
{
  Locating locating(made);
  CurveOrder order;
  for (std::size_t begin = 0; begin < places.count; begin += CurveOrder::kBlock)
  {
    const std::size_t end = std::min(places.count, begin + CurveOrder::kBlock);
    if (!order.build(places, begin, end, ticker))
    {
      return false;
    }
    for (std::size_t k = 0; k != end - begin; ++k)
    {
      ticker.finished(1);
      if (!locating(places[order[k]], order[k], out, ticker))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

PlaceKind kindOf(Location::Kind kind)
{
  return kind == Location::InTriangle ? PlaceKind::InTriangle
    : kind == Location::OnEdge        ? PlaceKind::OnEdge
    : kind == Location::OnVertex      ? PlaceKind::OnVertex
    : kind == Location::Outside       ? PlaceKind::Outside
                                      : PlaceKind::Nowhere;
}

void drawOrder(Job& job, std::int32_t type, const GivenDrawing& drawing)
{
  JobResult& made = job.result();
  if (!made.asked.drawsOrder())
  {
    refuse(Reason::NotAvailable,
      "Drawing the order requires \"want_curve\" or \"want_boxes\" before the run.");
  }
  if ((type != kInt32 && type != kInt64) || !drawing.xyz || !drawing.ranks || !drawing.ids ||
    !drawing.levels || !drawing.counts)
  {
    refuse(Reason::BadArray,
      "The order is drawn with ids of type AHD_INT32 or AHD_INT64, into arrays that are not null.");
  }
  made.sampling.forget();
  job.progress.reach(kDrawingOrder);
  job.withThreads(
    [&](const Context& context)
    {
      check(type == kInt32 ? draw<std::int32_t>(made, drawing, context)
                           : draw<std::int64_t>(made, drawing, context));
    });
}

void interpolate(Job& job, std::int32_t where, double* values, std::int32_t columns)
{
  const JobResult& made = job.result();
  if (where < kAtSurface || where > (kAtSurface | kAtCrossings))
  {
    refuse(Reason::BadValue,
      "Values are interpolated at AHD_AT_SURFACE, AHD_AT_CROSSINGS or both, not " +
        std::to_string(where) + ".");
  }
  if (columns < 0)
  {
    refuse(Reason::BadArray, "The values have " + std::to_string(columns) + " columns.");
  }
  if (columns > 0 && !values)
  {
    refuse(Reason::BadArray, "The pointer to the values is null.");
  }
  checkColumns(static_cast<std::uint64_t>(columns), "columns");
  const ScopedFloatingPoint asAssumed;
  if ((where & kAtSurface) != 0)
  {
    interpolateAtSurface(made.points, values, static_cast<std::size_t>(columns));
  }
  if ((where & kAtCrossings) != 0)
  {
    interpolateAtCrossings(made.points, values, static_cast<std::size_t>(columns), 0);
  }
}

void locate(Job& job, const double* xy, std::uint64_t given, const Places& out)
{
  JobResult& made = job.result();
  if (given > 0 && (!xy || !out.kinds || !out.ids))
  {
    const char* const which = !xy ? "places" : !out.kinds ? "kinds" : "ids";
    refuse(Reason::BadArray, "The pointer to the " + std::string(which) + " is null.");
  }
  checkCount(given, "places");
  const auto count = static_cast<std::size_t>(given);
  job.withThreads(
    [&](const Context& context)
    {
      check(made.triangulation.makeNeighbors(context));
      if (made.cellOf.empty())
      {
        check(numberCells(made, context));
      }
      check(unlessCancelled(
        [&]
        {
          Ticker ticker(context.progress, Phase::Outputs, count, context.executor);
          return ticker.ask() && locateAll(made, PointView(xy, count, 2), out, ticker);
        }));
    });
}

} // namespace ahd
