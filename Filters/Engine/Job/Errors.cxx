// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Order/CurveOrder.h"
#include "../Sample/Spots.h"
#include "../Simplify/Measure.h"
#include "../Triangulation/State.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace ahd
{
namespace
{

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct LargestValue
{
  double magnitude = 0.0;
  void merge(const LargestValue& other) { magnitude = std::max(magnitude, other.magnitude); }
};

/// One call of writeErrors(). Its functions return false if cancelled, and throw std::bad_alloc.
class Errors
{
public:
  /// @pre all tables, and a triangle
  Errors(const RunResult& made, double* to)
    : made_(made)
    , points_(made.points.points())
    , state_(*TriangulationAccess::stateOf(made.triangulation))
    , surface_{ &state_.tables, state_.ranked.xy.data(),
      made.isSelected() ? made.selection.kept.data() : nullptr }
    , to_(to)
  {
  }

  bool write(Ticker& ticker)
  {
    if (!findScale(ticker))
    {
      return false;
    }
    for (std::size_t begin = 0; begin < points_.count; begin += CurveOrder::kBlock)
    {
      const std::size_t end = std::min(points_.count, begin + CurveOrder::kBlock);
      CurveOrder order;
      if (!order.build(points_, begin, end, state_.ranked.bounds, ticker) ||
        !writeAll(order, end - begin, ticker))
      {
        return false;
      }
    }
    SpotFinder finder(surface_);
    return std::all_of(made_.points.merged().begin(), made_.points.merged().end(),
      [&](const MergedPoint& merged) { return writeAt(merged.id, finder, ticker); });
  }

private:
  /// A power of two that makes all finite values at most 1.
  bool findScale(Ticker& ticker)
  {
    LargestValue largest;
    const bool all = gather(points_.count, ticker, largest,
      [&](LargestValue& part, std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i != b; ++i)
        {
          const double value = made_.valueOf(i);
          part.magnitude = std::isfinite(value) ? std::max(part.magnitude, std::fabs(value))
                                                : part.magnitude;
        }
      });
    scale_ = powerOfTwoBelow(largest.magnitude);
    return all;
  }

  bool writeAll(const CurveOrder& order, std::size_t count, Ticker& ticker) const
  {
    const std::size_t tasks = tasksFor(threadsOf(ticker), count, 8, kChunk);
    return inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        SpotFinder finder(surface_);
        const Share share(count, task, tasks);
        for (std::size_t k = share.begin; k != share.end; ++k)
        {
          const std::size_t i = order[k];
          own.finished(1);
          to_[i] = kNone;
          if (points_.skipped(i) ? !own.step() : !writeAt(i, finder, own))
          {
            return false;
          }
        }
        return true;
      });
  }

  bool writeAt(std::size_t i, SpotFinder& finder, Ticker& ticker) const
  {
    const Sample point = { points_[i], made_.valueOf(i) };
    to_[i] = kNone;
    Spot spot;
    if (!isFinite(point.at))
    {
      return ticker.step();
    }
    if (!finder.find(point.at, ticker, spot))
    {
      return false;
    }
    if (spot.kind == Spot::OnVertex)
    {
      const std::size_t own = made_.triangulation.pointOf(state_.tables.origin(spot.halfEdge));
      to_[i] = own == i ? 0.0 : std::fabs(made_.valueOf(own) - point.value);
    }
    else if (spot.kind != Spot::Outside)
    {
      to_[i] = errorIn(spot.halfEdge - spot.halfEdge % 3, { point.at, point.value * scale_ });
    }
    return true;
  }

  /// `h`: the first half-edge of its triangle.
  double errorIn(HalfEdge h, const Sample& point) const
  {
    const auto corner = [&](HalfEdge at) -> Sample
    {
      const Index vertex = state_.tables.origin(at);
      return { surface_.at(vertex), made_.valueOf(made_.triangulation.pointOf(vertex)) * scale_ };
    };
    const double bound = std::min(
      made_.simplified.measuredWithin * scale_, std::numeric_limits<double>::max());
    const std::array<Sample, 3> corners = { { corner(h), corner(h + 1), corner(h + 2) } };
    const double error = Interpolant(corners).measure(point, 1.0, bound);
    return std::isfinite(error) ? error / scale_ : kNone;
  }

  const RunResult& made_;
  const PointView& points_;
  const TriangulationAccess::State& state_;
  const SampledSurface surface_;
  double* const to_;
  double scale_ = 1.0;
};

} // namespace

Status writeErrors(RunResult& made, double* errors, const Context& context)
{
  const Status status = made.triangulation.makeNeighbors(context);
  if (status != Status::Ok)
  {
    return status;
  }
  return unlessCancelled(
    [&]
    {
      const std::size_t count = made.points.points().count;
      Ticker ticker(context.progress, Phase::Outputs, count, context.executor);
      if (!TriangulationAccess::stateOf(std::as_const(made.triangulation)) ||
        made.triangulation.triangleCount() == 0)
      {
        std::fill_n(errors, count, kNone);
        return ticker.ask();
      }
      return ticker.ask() && Errors(made, errors).write(ticker) && ticker.ask();
    });
}

std::size_t errorMemoryEstimate(std::size_t pointCount)
{
  return CurveOrder::mostBytes(pointCount);
}

} // namespace ahd
