// SPDX-License-Identifier: BSD-3-Clause
#include "Preparation.h"

#include "../Arithmetic/Length.h"
#include "../Core/FloatingPoint.h"
#include "../Core/Loops.h"
#include "Bounding.h"

#include <cmath>
#include <limits>
#include <utility>

namespace ahd
{
namespace
{

/// The bounds of the points that are not left out, of their z the finite ones. Returns false if the
/// work is cancelled.
bool findBox(const PointView& points, Ticker& ticker, SpaceBox& box)
{
  return gather(points.count, ticker, box,
    [&points](SpaceBox& part, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vector3 p = points.place(i);
        if (std::isfinite(p[0]) && std::isfinite(p[1]) && !points.skipped(i))
        {
          part.add(0, p[0], p[0]);
          part.add(1, p[1], p[1]);
          if (std::isfinite(p[2]))
          {
            part.add(2, p[2], p[2]);
          }
        }
      }
    });
}

/// The length of the box's diagonal; the largest double if it is longer.
double diagonalOf(const SpaceBox& box)
{
  const double length = lengthOf(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  return std::min(length, std::numeric_limits<double>::max());
}

/// Writes the points' places relative to the plane, three numbers each. Returns false if cancelled.
bool projectAll(const PointView& points, const Plane& plane, double* to, Ticker& ticker)
{
  constexpr std::size_t kAhead = 64; // points: fetched
  return inChunksOf(points.count, ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        points.prefetch(i + kAhead);
        const Vector3 from = points.place(i);
        const bool finite = from[0] * 0 + from[1] * 0 + from[2] * 0 == 0;
        const Vector3 place = plane.project(from);
        for (std::size_t k = 0; k < 3; ++k)
        {
          to[3 * i + k] = finite ? place[k] : std::numeric_limits<double>::quiet_NaN();
        }
      }
    });
}

} // namespace

Status Preparation::run()
{
  if (expectedPoints(request_) > kMaximumPoints)
  {
    return Status::TooManyPoints;
  }
  Status status = open();
  status = status == Status::Ok ? project() : status;
  status = status == Status::Ok ? findSourceBounds() : status;
  status = status == Status::Ok ? takeHeights() : status;
  status = status == Status::Ok ? merge() : status;
  status = status == Status::Ok ? readConstraints() : status;
  status = status == Status::Ok ? layLines() : status;
  surface_.reset();
  status = status == Status::Ok ? addBounding() : status;
  return status == Status::Ok ? split() : status;
}

Status Preparation::open()
{
  out_.points_ = request_.points;
  out_.inputCount_ = request_.points.count;
  out_.sourceCount_ = request_.sourcePoints.count;
  const std::size_t count = out_.sourceCount_;
  if (count == 0)
  {
    return Status::Ok;
  }
  if (!copy(Phase::Merge))
  {
    return Status::Cancelled;
  }
  double* to = add(count);
  const bool moves = request_.fitPlane || request_.projection;
  Ticker ticker(&phases_, Phase::Merge, 0, context_.executor);
  const bool all = inChunksOf(count, ticker,
    [this, to, moves](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        Vector3 p = request_.sourcePoints.place(i);
        p[2] = moves && isMissing(i) ? 0.0 : p[2]; // so that there is a place in the plane
        std::copy(p.begin(), p.end(), to + 3 * i);
      }
    });
  return all ? Status::Ok : Status::Cancelled;
}

/// Makes a copy of the places, unless there is one already; in the current phase. Returns
/// false if the work is cancelled.
bool Preparation::copy(Phase phase)
{
  PointView& points = out_.points_;
  if (!out_.places_.empty() || points.count == 0)
  {
    return true;
  }
  double* const to = makeRoom();
  Ticker ticker(&phases_, phase, 0, context_.executor);
  const bool all = inChunksOf(points.count, ticker,
    [&points, to](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vector3 p = points.place(i);
        std::copy(p.begin(), p.end(), to + 3 * i);
      }
    });
  look(to);
  return all;
}

/// A new copy of the points' positions to write to; the existing copy if there is one.
double* Preparation::makeRoom()
{
  const std::size_t count = out_.points_.count;
  out_.places_.reserve(3 * std::max(count, expectedPoints(request_)));
  out_.places_.resize(3 * count);
  return out_.places_.data();
}

/// Replaces the points by the copy.
void Preparation::look(const double* places)
{
  PointView& points = out_.points_;
  points.floats = nullptr;
  points.doubles = places;
  points.stride = 3;
  points.isFlat = false;
}

/// Adds points, none of them skipped, and returns the destination of their positions.
/// @pre copy().
double* Preparation::add(std::size_t count)
{
  PointView& points = out_.points_;
  std::vector<unsigned char>& skip = out_.skip_;
  const std::size_t before = points.count;
  const std::size_t after = before + count;
  if (points.skip && skip.empty())
  {
    skip.reserve(std::max(after, expectedPoints(request_)));
    for (std::size_t i = 0; i < before; ++i)
    {
      skip.push_back(points.skipped(i));
    }
  }
  if (points.skip)
  {
    skip.reserve(after);
    skip.resize(after, 0);
    points.skip = skip.data();
    points.skipMask = 0xFF;
  }
  out_.places_.reserve(3 * after);
  out_.places_.resize(3 * after);
  points.count = after;
  look(out_.places_.data());
  return out_.places_.data() + 3 * before;
}

/// Leaves out the points whose byte is not 0, and no others.
void Preparation::setSkipped(std::vector<unsigned char>&& skip)
{
  out_.skip_ = std::move(skip);
  out_.points_.skip = out_.skip_.data();
  out_.points_.skipMask = 0xFF;
}

Status Preparation::project()
{
  if (!request_.fitPlane && !request_.projection)
  {
    return Status::Ok;
  }
  out_.isProjected_ = true;
  if (request_.fitPlane && request_.plane)
  {
    out_.plane_ = *request_.plane;
  }
  else if (request_.fitPlane)
  {
    const Status status = fitPlaneOf(request_, context_, out_.plane_);
    if (status != Status::Ok)
    {
      return status;
    }
  }
  double* const to = makeRoom();
  Ticker ticker(&phases_, Phase::Merge, 0, context_.executor);
  bool all = false;
  if (request_.fitPlane)
  {
    all = projectAll(out_.points_, out_.plane_, to, ticker);
  }
  else
  {
    const ScopedFloatingPoint whateverItSets;
    all = request_.projection->project(out_.points_, to, context_);
  }
  look(to);
  return all ? Status::Ok : Status::Cancelled;
}

Status Preparation::findSourceBounds()
{
  const bool hasSource = out_.sourceCount_ > 0;
  if (!hasSource && !request_.isSourceElsewhere)
  {
    return Status::Ok;
  }
  PointView input = out_.points_, source = input;
  input.count = out_.inputCount_;
  source.count = out_.sourceCount_;
  source.skip = nullptr;
  source.doubles += hasSource ? 3 * out_.inputCount_ : 0;
  Ticker ticker(&phases_, Phase::Merge, 0, context_.executor);
  const bool all = findBox(input, ticker, out_.sourceBounds_.input) &&
    findBox(source, ticker, out_.sourceBounds_.source);
  return all ? Status::Ok : Status::Cancelled;
}

Status Preparation::merge()
{
  if (request_.tolerance == 0.0)
  {
    return Status::Ok;
  }
  SpaceBox box;
  {
    Ticker ticker(&phases_, Phase::Merge, 0, context_.executor);
    if (!findBox(out_.points_, ticker, box))
    {
      return Status::Cancelled;
    }
  }
  MergedPoints merged;
  const Status status = mergeWithin(
    out_.points_, request_.tolerance * diagonalOf(box), context_, merged);
  if (status == Status::Ok && !merged.pairs.empty())
  {
    setSkipped(std::move(merged.skip));
    out_.merged_ = std::move(merged.pairs);
  }
  return status;
}

Status Preparation::addBounding()
{
  if (!request_.bounding || out_.isProjected_)
  {
    return Status::Ok;
  }
  SpaceBox box;
  const Phase phase = out_.hasConstraints() ? Phase::Split : Phase::Merge;
  Ticker ticker(&phases_, phase, 0, context_.executor);
  if (request_.bounds)
  {
    box.low = (*request_.bounds)[0];
    box.high = (*request_.bounds)[1];
  }
  else if (!findBox(out_.points_, ticker, box))
  {
    return Status::Cancelled;
  }
  if (box.low[0] > box.high[0])
  {
    return Status::Ok; // no points to bound
  }
  if (box.low[2] > box.high[2])
  {
    box.low[2] = box.high[2] = 0.0;
  }
  if (!copy(phase))
  {
    return Status::Cancelled;
  }
  const auto eight = boundingPoints(box.low, box.high, request_.offset);
  double* places = add(eight.size());
  for (const Vector3& p : eight)
  {
    places = std::copy(p.begin(), p.end(), places);
  }
  return Status::Ok;
}

} // namespace ahd
