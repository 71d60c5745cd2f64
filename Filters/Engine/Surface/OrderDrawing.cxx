// SPDX-License-Identifier: BSD-3-Clause
#include "OrderDrawing.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Triangulation/Triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace ahd
{

namespace
{

struct Lowest
{
  double z = std::numeric_limits<double>::infinity();

  void merge(const Lowest& other) { z = std::min(z, other.z); }
};

/// 0 if no point has a z.
bool findLowestZ(const PointView& points, Ticker& ticker, double& z)
{
  Lowest lowest;
  const bool all = gather(points.count, ticker, lowest,
    [&](Lowest& part, std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        const std::array<double, 3> p = points.place(i);
        const bool counts = !points.skipped(i) && std::isfinite(p[0]) && std::isfinite(p[1]) &&
          std::isfinite(p[2]);
        part.z = counts ? std::min(part.z, p[2]) : part.z;
      }
    });
  z = std::isfinite(lowest.z) ? lowest.z : 0.0;
  return all;
}

template <typename Id>
bool drawInserted(
  const Triangulation& triangulation, std::size_t count, const OrderDrawing<Id>& to, Ticker& ticker)
{
  const PointView& points = triangulation.points();
  return inChunksOf(count, ticker,
    [&](std::size_t a, std::size_t b)
    {
      constexpr std::size_t kAhead = 32; // points: they lie anywhere, and memory is far
      for (std::size_t i = a; i != b; ++i)
      {
        const auto next = static_cast<std::size_t>(to.ids[std::min(b - 1, i + kAhead)]);
        points.prefetch(next);
        const std::array<double, 3> p = points.place(static_cast<std::size_t>(to.ids[i]));
        std::copy(p.begin(), p.end(), to.xyz + 3 * i);
        to.ranks[i] = static_cast<Id>(i);
      }
    });
}

/// `to` begins with the corners of the first box, and its cell.
template <typename Id>
bool drawBoxes(
  const std::vector<GridBox>& boxes, double z, const OrderDrawing<Id>& to, Ticker& ticker)
{
  return inShares(boxes.size(), ticker, 4, kChunk, // 300 bytes each
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        const GridBox& box = boxes[i];
        const double corners[] = { box.xmin, box.ymin, z, box.xmax, box.ymin, z, //
          box.xmax, box.ymax, z, box.xmin, box.ymax, z };
        std::copy(std::begin(corners), std::end(corners), to.xyz + 3 * kBoxCorners * i);
        std::fill_n(to.ranks + kBoxCorners * i, kBoxCorners, Id(-1));
        std::fill_n(to.ids + kBoxCorners * i, kBoxCorners, Id(-1));
        to.levels[i] = box.level;
        to.counts[i] = static_cast<Id>(box.count);
      }
    });
}

} // namespace

DrawnOrder drawnOrder(const Triangulation& triangulation, bool withCurve)
{
  const std::size_t passed = withCurve ? triangulation.report().inserted : 0;
  return { passed, passed >= 2 ? std::size_t(1) : 0, triangulation.boxes().size() };
}

template <typename Id>
Status drawOrder(Triangulation& triangulation, bool withCurve, const OrderDrawing<Id>& drawing,
  const Context& context)
{
  if (withCurve)
  {
    const Status status = triangulation.writeOrder(drawing.ids, context);
    if (status != Status::Ok)
    {
      return status;
    }
  }
  const DrawnOrder drawn = drawnOrder(triangulation, withCurve);
  if (drawn.curves != 0)
  {
    drawing.levels[0] = -1;
    drawing.counts[0] = static_cast<Id>(drawn.passed);
  }
  const OrderDrawing<Id> boxes = { drawing.xyz + 3 * drawn.passed, drawing.ranks + drawn.passed,
    drawing.ids + drawn.passed, drawing.levels + drawn.curves, drawing.counts + drawn.curves };
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, drawn.passed, context.executor);
      double z = 0.0;
      return drawInserted(triangulation, drawn.passed, drawing, ticker) &&
        (triangulation.boxes().empty() || findLowestZ(triangulation.points(), ticker, z)) &&
        drawBoxes(triangulation.boxes(), z, boxes, ticker) && ticker.ask();
    });
}

template Status drawOrder(Triangulation&, bool, const OrderDrawing<int>&, const Context&);
template Status drawOrder(Triangulation&, bool, const OrderDrawing<long>&, const Context&);
template Status drawOrder(Triangulation&, bool, const OrderDrawing<long long>&, const Context&);

} // namespace ahd
