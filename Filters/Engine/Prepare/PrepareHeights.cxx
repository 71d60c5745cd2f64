// SPDX-License-Identifier: BSD-3-Clause
//
// Heights: the step of a preparation that moves points of the source to a surface, and the heights
// of the result.
#include "Preparation.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Order/CurveOrder.h"
#include "../Triangulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// The places of a cell's ids.
std::pair<std::size_t, std::size_t> rangeOf(const CellsView& cells, std::size_t cell)
{
  const auto offset = [&cells](std::size_t k)
  {
    return static_cast<std::size_t>(
      cells.offsets64 ? cells.offsets64[k] : std::int64_t(cells.offsets32[k]));
  };
  return { offset(cell), offset(cell + 1) };
}

std::int64_t idIn(const CellsView& cells, std::size_t k)
{
  return cells.offsets64 ? cells.ids64[k] : std::int64_t(cells.ids32[k]);
}

} // namespace

bool Preparation::isMissing(std::size_t sourcePoint) const
{
  const double z = request_.sourcePoints.z(sourcePoint);
  return request_.heights == SourceHeights::Mixed &&
    (std::isnan(z) || (request_.zeroIsMissing && z == 0.0));
}

/// Is it a point of the source with a height of its own, where others have none?
bool Preparation::keepsHeight(std::size_t id) const
{
  return request_.heights == SourceHeights::Mixed && id >= out_.inputCount_ &&
    id < out_.inputCount_ + out_.sourceCount_ && !isMissing(id - out_.inputCount_);
}

/// Does the segment between two points have its heights from a surface?
bool Preparation::isOnSurface(Index from, Index to) const
{
  return request_.heights != SourceHeights::Own && !(keepsHeight(from) && keepsHeight(to));
}

Status Preparation::takeHeights()
{
  if (request_.heights == SourceHeights::Own || out_.sourceCount_ == 0)
  {
    return Status::Ok;
  }
  phases_.beginPhase(Phase::Merge);
  surface_ = std::make_unique<HeightSurface>();
  const Status status = triangulateSurface();
  return status == Status::Ok ? layOn() : status;
}

/// Of the points that have heights.
Status Preparation::triangulateSurface()
{
  WithinMerge progress(phases_);
  const Context context = { &progress, context_.executor };
  PointView own = out_.points_;
  if (request_.heights == SourceHeights::Mixed)
  {
    withoutHeight_.reserve(own.count);
    for (std::size_t i = 0; i < own.count; ++i)
    {
      withoutHeight_.push_back(i < out_.inputCount_ ? own.skipped(i) : !keepsHeight(i));
    }
    own.skip = withoutHeight_.data();
    own.skipMask = 0xFF;
  }
  else
  {
    own.count = out_.inputCount_;
  }
  Options options;
  options.representative = request_.representative;
  Workspace workspace;
  Triangulation& surface = surface_->triangulation;
  Status status = triangulate(own, options, workspace, context, surface);
  status = status == Status::Ok ? constrainSurface(context) : status;
  status = status == Status::Ok ? surface.makeNeighbors(context) : status;
  return status == Status::Ok && request_.meanHeights
    ? findMeans(surface, own.count, own, context, surface_->means)
    : status;
}

/// By the segments between points of the source that keep their heights; of two that cross, the
/// later one is left out.
Status Preparation::constrainSurface(const Context& context)
{
  if (request_.heights != SourceHeights::Mixed || segmentsOf(request_) == 0)
  {
    return Status::Ok;
  }
  Ticker ticker(context.progress, Phase::Constrain, 0);
  std::vector<std::int64_t> ids, offsets = { 0 };
  ids.reserve(segmentsOf(request_) + request_.polygons.cells);
  offsets.reserve(request_.lines.cells + request_.polygons.cells + 1);
  const auto idOf = [this](std::int64_t id)
  {
    const auto point = out_.inputCount_ + static_cast<std::size_t>(id);
    return id >= 0 && keepsHeight(point) ? static_cast<std::int64_t>(point) : -1;
  };
  for (std::size_t i = 0; arePointsLine(request_) && i < out_.sourceCount_; ++i)
  {
    ids.push_back(idOf(static_cast<std::int64_t>(i)));
  }
  if (arePointsLine(request_))
  {
    offsets.push_back(static_cast<std::int64_t>(ids.size()));
  }
  for (const CellsView* cells : { &request_.lines, &request_.polygons })
  {
    for (std::size_t cell = 0; cell < cells->cells; ++cell)
    {
      const auto [begin, end] = rangeOf(*cells, cell);
      for (std::size_t k = begin; k < end; ++k)
      {
        ids.push_back(idOf(idIn(*cells, k)));
        if (!ticker.step())
        {
          return Status::Cancelled;
        }
      }
      if (cells == &request_.polygons && begin < end)
      {
        ids.push_back(ids[ids.size() - (end - begin)]);
      }
      offsets.push_back(static_cast<std::int64_t>(ids.size()));
    }
  }
  ConstraintView lines;
  lines.ids = ids.data();
  lines.offsets = offsets.data();
  lines.chains = lines.lines = offsets.size() - 1;
  Triangulation& surface = surface_->triangulation;
  return constrain(std::move(surface), lines, FillRule::Orientation, context, surface);
}

/// Finds the points of the source on the surface, and moves there those that have no height.
Status Preparation::layOn()
{
  std::vector<SurfacePlace>& places = out_.surfacePlaces_;
  places.resize(out_.sourceCount_);
  surface_->triangles.resize(places.size());
  double* const to = out_.places_.data() + 3 * out_.inputCount_;
  Ticker ticker(&phases_, Phase::Merge, 0, context_.executor);
  const PointView ofSource(to, places.size(), 3);
  const auto heightAt = [this](Index id) { return surface_->heightAt(id, out_.points_); };
  // Each search starts at the result of the one before.
  CurveOrder order;
  const auto lay = [&](std::size_t count)
  {
    const std::size_t tasks = tasksForLoop(ticker, count);
    return inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(count, task, tasks);
        SurfacePlacer placer(surface_->triangulation, own);
        for (std::size_t k = share.begin; k < share.end && own.step(); ++k)
        {
          const std::size_t i = order[k];
          const SurfacePlace place = placer(ofSource[i]);
          surface_->triangles[i] = static_cast<Index>(placer.triangle());
          if (!keepsHeight(out_.inputCount_ + i))
          {
            places[i] = place;
            to[3 * i + 2] = places[i].isInside() ? interpolate(places[i], heightAt) : to[3 * i + 2];
          }
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
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    out_.outside_ += std::size_t(!places[i].isInside() && !keepsHeight(out_.inputCount_ + i));
  }
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
      std::size_t added = points.inputCount() + points.sourceCount();
      for (std::size_t k = points.sourceCount(); k < points.surfacePlaces().size(); ++k)
      {
        heights[added++] = interpolate(
          points.surfacePlaces()[k], [&](Index origin) { return heights[origin]; });
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
