// SPDX-License-Identifier: BSD-3-Clause
//
// The part of Triangulator that knows of edges and cells: constraints, and what is written per
// cell.
#include "TriangulatorState.h"

#include "Constrain/Constrainer.h"
#include "Constrain/Regions.h"
#include "Core/Border.h"
#include "Core/Chunks.h"

#include <algorithm>

namespace ahd
{

/// The vertex of each of the caller's ids; kNoIndex for those that have none.
bool Triangulator::State::rankIds(Buffer<Index>& rankOf, Ticker& ticker) const
{
  rankOf.allocate(points.count);
  return fillAll(rankOf, kNoIndex, ticker) &&
    inChunks(0, ranked.count, ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t rank = a; rank != b; ++rank)
        {
          rankOf[ranked.id[rank]] = static_cast<Index>(rank);
        }
      }) &&
    inChunks(0, ranked.duplicates.size(), ticker,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t i = a; i != b; ++i)
        {
          rankOf[ranked.duplicates[i].id] = rankOf[ranked.duplicates[i].keptId];
        }
      });
}

bool Triangulator::State::lookUp(Ticker& ticker)
{
  isLookedUp = isLookedUp || constrained.begin(mesh, ranked.xy.data(), ticker);
  return isLookedUp;
}

bool Triangulator::State::insertConstraints(
  const ConstraintView& given, FillRule rule, Ticker& ticker)
{
  Buffer<Index> rankOf;
  if (!rankIds(rankOf, ticker) || !lookUp(ticker))
  {
    return false;
  }
  Constrainer constrainer(constrained, rankOf, ticker);
  if (!constrainer.insertAll(given, report.inserted))
  {
    return false;
  }
  std::size_t dropped = 0;
  if (constrainer.anyLoop() &&
    !dropOutside(constrained, constrainer.edges(), rule, ticker, dropped))
  {
    return false;
  }
  report.triangles -= dropped;
  constraints = constrainer.takeReport();
  return ticker.ask();
}

/// Without triangles no segment can be had.
bool Triangulator::State::countMissing(const ConstraintView& given, Ticker& ticker)
{
  for (std::size_t chain = 0; chain < given.chains; ++chain)
  {
    const std::size_t segments = segmentsOf(given, chain);
    constraints.segments += segments;
    constraints.withoutVertex += segments;
    constraints.unfilledLoops += chain >= given.lines && segments > 0 ? 1 : 0;
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

Status Triangulator::State::constrain(
  const ConstraintView& given, FillRule rule, Progress* progress)
{
  areCellsAtHand = false;
  const std::size_t ids = given.chains == 0
    ? 0
    : static_cast<std::size_t>(given.offsets[given.chains] - given.offsets[0]);
  Ticker ticker(progress, Phase::Constrain, ids);
  if (report.triangles == 0)
  {
    return countMissing(given, ticker) ? Status::Ok : Status::Cancelled;
  }
  return insertConstraints(given, rule, ticker) ? Status::Ok : Status::Cancelled;
}

bool Triangulator::State::findCells(Ticker& ticker)
{
  areCellsAtHand = areCellsAtHand ||
    (lookUp(ticker) && cells.begin(constrained, report.triangles, ticker));
  return areCellsAtHand;
}

Status Triangulator::constrain(const ConstraintView& constraints, FillRule rule, Progress* progress)
{
  const Status status = !state_
    ? Status::Ok
    : withoutThrowing([&] { return state_->constrain(constraints, rule, progress); });
  if (status != Status::Ok)
  {
    state_.reset();
  }
  return status;
}

const ConstraintReport& Triangulator::constraints() const
{
  static const ConstraintReport kNone;
  return state_ ? state_->constraints : kNone;
}

/// write(cells, mesh, ticker) with the cells at hand, where there are any.
template <typename Write>
Status Triangulator::writeCells(Progress* progress, Write write)
{
  return unlessCancelled(
    [&]
    {
      if (!state_ || state_->report.triangles == 0)
      {
        return true;
      }
      Ticker ticker(progress, Phase::Fates, state_->report.triangles);
      return state_->findCells(ticker) && write(state_->cells, state_->constrained, ticker) &&
        ticker.ask();
    });
}

Status Triangulator::writeNeighbors(std::int64_t* neighbors, Progress* progress)
{
  return writeCells(progress,
    [=](const CellData& cells, const ConstrainedMesh& mesh, Ticker& ticker)
    { return cells.writeNeighbors(mesh, neighbors, ticker); });
}

Status Triangulator::writeConstraintEdges(std::uint8_t* edges, Progress* progress)
{
  return writeCells(progress,
    [=](const CellData& cells, const ConstrainedMesh& mesh, Ticker& ticker)
    { return cells.writeConstraintEdges(mesh, edges, ticker); });
}

Status Triangulator::writeRegions(std::int64_t* regions, Progress* progress)
{
  return writeCells(progress,
    [=](const CellData& cells, const ConstrainedMesh& mesh, Ticker& ticker)
    { return cells.writeRegions(mesh, regions, ticker); });
}

std::size_t Triangulator::constraintMemoryEstimate(std::size_t pointCount, std::size_t segmentCount)
{
  // An array that grows by doubling may hold three times what it needs while it is copied.
  constexpr std::size_t kGrown = 3;
  // Per point: a vertex for each id, a triangle for each vertex, two marks; an edge and a place of
  // two triangles; and a queue of two triangles, or the edges of one vertex while they are sorted.
  constexpr std::size_t kPerPoint = 4 + 4 + 2 + 2 * (4 + 4) + (kGrown + 1) * 8;
  // Per edge: a place in a table that is at least a quarter full, or less while it is copied.
  constexpr std::size_t kPerEdge = 6 * sizeof(EdgeTable::Edge);
  // Per segment: a row of the report, an edge of a loop, the beginning of a chain.
  constexpr std::size_t kPerSegment = kGrown * (sizeof(LeftOut) + 8) + 8;
  return pointCount * kPerPoint +
    (segmentCount == 0 ? 0 : 3 * std::min(segmentCount, pointCount) * kPerEdge) +
    segmentCount * kPerSegment;
}

} // namespace ahd
