// SPDX-License-Identifier: BSD-3-Clause
//
// Heights: the step of a preparation that moves the points of the source to the surface of the
// input, and the heights of the surface itself.
#include "Preparation.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Order/CurveOrder.h"
#include "../Surface/Means.h"
#include "../Triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ahd
{
namespace
{

/// Reports a triangulation as a part of the phase Merge: all of its phases count alike.
class WithinMerge : public Progress
{
public:
  explicit WithinMerge(Progress& caller)
    : caller_(caller)
  {
  }
  bool advance(Phase phase, double fraction) override
  {
    return caller_.advance(Phase::Merge, (double(phase) + fraction) / double(kPhases));
  }
  bool take(std::size_t bytes) override { return caller_.take(bytes); }
  void giveBack(std::size_t bytes) override { caller_.giveBack(bytes); }

private:
  Progress& caller_;
};

/// The weights of the corners of a triangle at a place in it: barycentric coordinates.
std::array<double, 3> weightsAt(const std::array<Point, 3>& corners, const Point& place)
{
  std::array<double, 3> x, y, weights;
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    x[k] = corners[k].x / 2 - place.x / 2; // halves: the difference may be too large
    y[k] = corners[k].y / 2 - place.y / 2;
    largest = std::max({ largest, std::abs(x[k]), std::abs(y[k]) });
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (std::size_t k = 0; k < 3; ++k)
  {
    x[k] = std::ldexp(x[k], -exponent);
    y[k] = std::ldexp(y[k], -exponent);
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    weights[k] = std::max(0.0, x[a] * y[b] - x[b] * y[a]);
    sum += weights[k];
  }
  for (double& weight : weights)
  {
    weight = sum > 0.0 ? weight / sum : 1.0 / 3; // 0: too flat a triangle for doubles
  }
  return weights;
}

/// The fraction of the way from `a` to `b`, along the axis on which they are farther apart.
double fractionAt(const Point& a, const Point& b, const Point& place)
{
  const double x = b.x / 2 - a.x / 2, y = b.y / 2 - a.y / 2;
  const double fraction = std::abs(x) > std::abs(y) ? (place.x / 2 - a.x / 2) / x
                                                    : (place.y / 2 - a.y / 2) / y;
  return fraction > 0.0 ? std::min(fraction, 1.0) : 0.0; // NaN: denormal numbers
}

/// Finds places on a surface.
class SurfacePlacer
{
public:
  SurfacePlacer(const Triangulation& surface, Ticker& ticker)
    : surface_(surface)
    , ticker_(ticker)
  {
  }

  /// Polls for cancellation.
  SurfacePlace operator()(const Point& place)
  {
    const Location at = surface_.locate(place, hint_, ticker_);
    const HalfEdge h = at.halfEdge;
    hint_ = h == kNoHalfEdge ? hint_ : h / 3;
    switch (at.kind)
    {
      case Location::OnVertex:
        return { { { pointAt(h), 0, 0 } }, { { 1.0, 0.0, 0.0 } } };
      case Location::OnEdge:
        return onEdge(h, place);
      case Location::InTriangle:
        return inTriangle(h, place);
      default:
        return {};
    }
  }

private:
  Index pointAt(HalfEdge h) const { return surface_.pointOf(surface_.origin(h)); }
  Point originOf(HalfEdge h) const { return surface_.at(surface_.origin(h)); }

  SurfacePlace onEdge(HalfEdge h, const Point& place) const
  {
    const HalfEdge next = nextInTriangle(h);
    const double t = fractionAt(originOf(h), originOf(next), place);
    return { { { pointAt(h), pointAt(next), 0 } }, { { 1.0 - t, t, 0.0 } } };
  }

  SurfacePlace inTriangle(HalfEdge h, const Point& place) const
  {
    const HalfEdge second = nextInTriangle(h), third = nextInTriangle(second);
    return { { { pointAt(h), pointAt(second), pointAt(third) } },
      weightsAt({ { originOf(h), originOf(second), originOf(third) } }, place) };
  }

  const Triangulation& surface_;
  Ticker& ticker_;
  std::size_t hint_ = 0; ///< points of the source follow each other along lines
};

/// The heights of the surface's vertices, by the ids of the points that stand for them.
class Heights
{
public:
  Heights(const PointView& points, const std::vector<Mean>& means)
    : points_(points)
    , means_(means)
  {
  }

  double operator()(Index id) const
  {
    const auto mean = std::lower_bound(
      means_.begin(), means_.end(), id, [](const Mean& m, Index i) { return m.id < i; });
    return mean != means_.end() && mean->id == id ? mean->position[2] : points_.doubles[3 * id + 2];
  }

private:
  PointView points_;
  const std::vector<Mean>& means_;
};

} // namespace

Status Preparation::takeHeights()
{
  if (!request_.heightsFromSurface || out_.sourceCount_ == 0)
  {
    return Status::Ok;
  }
  phases_.beginPhase(Phase::Merge);
  WithinMerge progress(phases_);
  const Context context = { &progress, context_.executor };
  PointView own = out_.points_;
  own.count = out_.inputCount_;
  Options options;
  options.representative = request_.representative;
  Workspace workspace;
  Triangulation surface;
  std::vector<Mean> means;
  Status status = triangulate(own, options, workspace, context, surface);
  status = status == Status::Ok ? surface.makeNeighbors(context) : status;
  if (status == Status::Ok && request_.meanHeights)
  {
    status = findMeans(surface, own.count, own, context, means);
  }
  return status == Status::Ok ? layOn(surface, means) : status;
}

/// Finds the points of the source on the surface, and moves them there.
Status Preparation::layOn(const Triangulation& surface, const std::vector<Mean>& means)
{
  std::vector<SurfacePlace>& places = out_.surfacePlaces_;
  places.resize(out_.sourceCount_);
  double* const to = out_.places_.data() + 3 * out_.inputCount_;
  const Heights heights(out_.points_, means);
  Ticker ticker(&phases_, Phase::Merge, 0, context_.executor);
  const PointView ofSource(to, places.size(), 3);
  // Each search starts at the result of the one before.
  CurveOrder order;
  const auto lay = [&](std::size_t count)
  {
    const std::size_t tasks = tasksForLoop(ticker, count);
    return inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(count, task, tasks);
        SurfacePlacer placer(surface, own);
        for (std::size_t k = share.begin; k < share.end && own.step(); ++k)
        {
          const std::size_t i = order[k];
          places[i] = placer(ofSource[i]);
          to[3 * i + 2] = places[i].isInside() ? interpolate(places[i], heights) : to[3 * i + 2];
        }
        return own.ask();
      });
  };
  bool all = true;
  for (std::size_t begin = 0; begin < places.size() && all; begin += CurveOrder::kBlock)
  {
    const std::size_t end = std::min(places.size(), begin + CurveOrder::kBlock);
    all = order.build(ofSource, begin, end, ticker) && lay(end - begin);
  }
  out_.outside_ = static_cast<std::size_t>(std::count_if(
    places.begin(), places.end(), [](const SurfacePlace& place) { return !place.isInside(); }));
  return all ? Status::Ok : Status::Cancelled;
}

Status findHeights(const PreparedInput& points, Triangulation& triangulation, bool means,
  const Context& context, double* heights)
{
  const PointView& places = points.points();
  std::vector<Mean> found;
  const Status status = means
    ? findMeans(triangulation, points.firstCrossing(), places, context, found)
    : Status::Ok;
  if (status != Status::Ok)
  {
    return status;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      const bool all = inChunksOf(places.count, ticker,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            heights[i] = places.z(i);
          }
        });
      if (!all || found.empty())
      {
        return all;
      }
      for (const Mean& mean : found)
      {
        heights[mean.id] = mean.position[2];
      }
      std::size_t crossing = points.firstCrossing();
      for (const CrossingOrigin& origin : points.crossings())
      {
        heights[crossing++] = interpolate(origin, [&](Index end) { return heights[end]; });
      }
      return true;
    });
}

} // namespace ahd
