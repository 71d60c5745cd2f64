// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation.h"

#include "../Core/Border.h"
#include "State.h"

namespace ahd
{

Triangulation::Triangulation() = default;
Triangulation::~Triangulation() = default;
Triangulation::Triangulation(Triangulation&&) noexcept = default;
Triangulation& Triangulation::operator=(Triangulation&&) noexcept = default;

const Report& Triangulation::report() const
{
  static const Report kNothing;
  return state_ ? state_->report : kNothing;
}

const ConstraintReport& Triangulation::constraints() const
{
  static const ConstraintReport kNone;
  return state_ ? state_->constraints : kNone;
}

const PointView& Triangulation::points() const
{
  static const PointView kNone;
  return state_ ? state_->points : kNone;
}

const std::vector<GridBox>& Triangulation::boxes() const
{
  static const std::vector<GridBox> kNone;
  return state_ ? state_->boxes : kNone;
}

std::size_t Triangulation::vertexCount() const
{
  return state_ ? state_->ranked.count : 0;
}

Index Triangulation::pointOf(Index vertex) const
{
  return state_->ranked.id[vertex];
}

Status Triangulation::makeNumbers(const Context& context)
{
  if (!state_)
  {
    return Status::Ok;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, state_->allTriangles,
        state_->worthItsWhile(context.executor));
      return state_->makeNumbers(ticker, State::PlacesAre::NotNeeded) && ticker.ask();
    });
}

Status Triangulation::makeCorners(const Context& context)
{
  if (!state_ || (state_->hasCorners && !state_->arePlacesGone))
  {
    return Status::Ok;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, state_->allTriangles,
        state_->worthItsWhile(context.executor));
      return state_->makeCorners(ticker) && state_->restorePlaces(ticker) && ticker.ask();
    });
}

Status Triangulation::makeNumbersAndCorners(const Context& context)
{
  if (!state_)
  {
    return Status::Ok;
  }
  const Status status = unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, state_->allTriangles,
        state_->worthItsWhile(context.executor));
      return state_->hasCorners || state_->makeNumbers(ticker);
    });
  return status == Status::Ok ? makeCorners(context) : status;
}

Status Triangulation::makeNeighbors(const Context& context)
{
  if (!state_ || (state_->hasNeighbors && !state_->arePlacesGone))
  {
    return Status::Ok;
  }
  return unlessCancelled(
    [&]
    {
      const std::size_t work = 3 * state_->allTriangles;
      Ticker ticker(
        context.progress, Phase::Outputs, work, state_->worthItsWhile(context.executor));
      return state_->makeNeighbors(ticker) && state_->restorePlaces(ticker) && ticker.ask();
    });
}

Status Triangulation::makePointMap(const Context& context)
{
  if (!state_ || state_->hasPointMap)
  {
    return Status::Ok;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, state_->points.count,
        state_->worthItsWhile(context.executor));
      return state_->makePointMap(ticker);
    });
}

std::size_t Triangulation::triangleCount() const
{
  return state_ ? state_->allTriangles : 0;
}

bool Triangulation::isKept(std::size_t triangle) const
{
  return state_->tables.isKept(triangle);
}

Index Triangulation::origin(HalfEdge h) const
{
  return state_->tables.origin(h);
}

bool Triangulation::isConstrained(HalfEdge h) const
{
  return state_->tables.isConstrained(h);
}

Point Triangulation::at(Index vertex) const
{
  return state_->ranked.xy[vertex];
}

HalfEdge Triangulation::twin(HalfEdge h) const
{
  return state_->tables.twins[h];
}

HalfEdge Triangulation::start(Index vertex) const
{
  return state_->tables.starts[vertex];
}

Index Triangulation::vertexOf(std::size_t point) const
{
  return state_->tables.vertexOf[point];
}

} // namespace ahd
