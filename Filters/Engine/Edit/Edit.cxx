// SPDX-License-Identifier: BSD-3-Clause
#include "Edit.h"

#include "../Core/Border.h"
#include "../Order/CurveOrder.h"
#include "../Triangulate.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// So many points are triangulated together rather than inserted one by one.
constexpr std::size_t kLeastForBulk = 256;

/// Bytes of the lists by id and by vertex.
constexpr std::size_t kPerId = sizeof(Point) + 2 * sizeof(Index) + 1;

} // namespace

std::size_t Edit::heldMemory() const
{
  return places_.size() * kPerId + LivingMesh::bytesFor(mesh_.vertexCount());
}

std::size_t Edit::memoryEstimate(std::size_t more) const
{
  const std::size_t count = places_.size() + more;
  const std::size_t kept = count * kPerId + LivingMesh::bytesFor(count) + Hints::bytesFor(count);
  const std::size_t built = triangulationMemoryEstimate(count, Options()) +
    tableMemoryEstimate(count);
  return 2 * kept + (isBulk(more) ? built : CurveOrder::mostBytes(more)); // vectors double
}

/// Is it less work to make all triangles anew?
bool Edit::isBulk(std::size_t more) const
{
  return more >= kLeastForBulk && more >= present_;
}

template <typename Step>
Status Edit::each(std::size_t count, const Context& context, Outcome* outcomes, const Step& step)
{
  std::fill_n(outcomes, count, Outcome::NotTried);
  return withoutThrowing(
    [&]
    {
      for (std::size_t k = 0; k < count;)
      {
        const Status ready = makeReady(context);
        if (ready != Status::Ok)
        {
          return ready;
        }
        Ticker ticker(context.progress, Phase::Insert, count - k, context.executor);
        for (isReady_ = true; k < count && isReady_; ++k)
        {
          isReady_ = isOver_ = false;
          outcomes[k] = step(k);
          isReady_ = !isOver_;
          ticker.finished(1);
          if (!ticker.step())
          {
            return Status::Cancelled;
          }
        }
      }
      return Status::Ok;
    });
}

Status Edit::insert(const PointView& points, const Context& context, std::int64_t& first)
{
  const std::size_t before = places_.size();
  first = static_cast<std::int64_t>(before);
  if (points.count > kMaximumPoints - before)
  {
    return Status::TooManyPoints;
  }
  const bool bulk = isBulk(points.count);
  const Status status = withoutThrowing(
    [&]
    {
      const Status ready = bulk ? Status::Ok : makeReady(context);
      if (ready != Status::Ok || points.count == 0)
      {
        return ready;
      }
      append(points);
      return bulk ? build(context) : insertEach(before, context);
    });
  if (status != Status::Ok && places_.size() > before)
  {
    takeBack(before);
  }
  return status;
}

Status Edit::remove(
  const std::int64_t* ids, std::size_t count, const Context& context, Outcome* outcomes)
{
  return each(count, context, outcomes,
    [&](std::size_t k) { return has(ids[k]) ? detach(Index(ids[k])) : Outcome::NoPoint; });
}

Status Edit::move(
  const std::int64_t* ids, const PointView& to, const Context& context, Outcome* outcomes)
{
  return each(to.count, context, outcomes,
    [&](std::size_t k)
    {
      if (!has(ids[k]))
      {
        return Outcome::NoPoint;
      }
      const Index id = Index(ids[k]);
      const Outcome outcome = detach(id);
      if (outcome != Outcome::Done)
      {
        return outcome;
      }
      places_[id] = to[k];
      gone_[id] = 0;
      ++present_;
      outcomes[k] = outcome; // also if memory runs out below
      attach(id);
      return outcome;
    });
}

Status Edit::constrain(
  const std::int64_t* ends, std::size_t count, const Context& context, Outcome* outcomes)
{
  return each(count, context, outcomes, [&](std::size_t k) { return constrainOne(ends + 2 * k); });
}

Status Edit::release(
  const std::int64_t* ends, std::size_t count, const Context& context, Outcome* outcomes)
{
  return each(count, context, outcomes, [&](std::size_t k) { return releaseOne(ends + 2 * k); });
}

Status Edit::locate(const PointView& places, const Context& context, EditPlace* found)
{
  return withoutThrowing(
    [&]
    {
      const Status ready = makeReady(context);
      Ticker ticker(context.progress, Phase::Outputs, places.count, context.executor);
      bool goesOn = ready == Status::Ok;
      for (std::size_t k = 0; goesOn && k < places.count; ++k)
      {
        found[k] = locateOne(places[k]);
        ticker.finished(1);
        goesOn = ticker.step();
      }
      return ready != Status::Ok ? ready : goesOn ? Status::Ok : Status::Cancelled;
    });
}

Status Edit::write(EditedInput& out, const Context& context) const
{
  return withoutThrowing(
    [&]
    {
      out = EditedInput();
      Ticker ticker(context.progress, Phase::Outputs, places_.size(), context.executor);
      std::vector<Index> position(places_.size());
      out.places.reserve(present_);
      out.ids.reserve(present_);
      for (Index id = 0; id < places_.size(); ++id)
      {
        position[id] = Index(out.ids.size());
        if (gone_[id] == 0)
        {
          out.places.push_back(places_[id]);
          out.ids.push_back(id);
        }
        ticker.finished(1);
        if (!ticker.step())
        {
          return Status::Cancelled;
        }
      }
      for (const Segment& segment : ends_)
      {
        if (segment.first < segment.second)
        {
          out.offsets.push_back(std::int64_t(out.segments.size()));
          out.segments.insert(
            out.segments.end(), { position[segment.first], position[segment.second] });
        }
      }
      out.offsets.push_back(std::int64_t(out.segments.size()));
      return Status::Ok;
    });
}

} // namespace ahd
