// SPDX-License-Identifier: BSD-3-Clause
//
// The part of Triangulator that knows of edges and cells: constraints, and what is written per
// cell.
#include "TriangulatorState.h"

#include "Border.h"
#include "Chunks.h"
#include "Constrain/Constrainer.h"
#include "Constrain/Regions.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// Segments of a chain, as Constrainer counts them.
std::size_t segmentsOf(const ConstraintView& given, std::size_t chain)
{
  const std::int64_t begin = given.offsets[chain], end = given.offsets[chain + 1];
  if (end - begin < 2)
  {
    return 0;
  }
  const bool isClosed = chain >= given.lines && given.ids[begin] != given.ids[end - 1];
  return static_cast<std::size_t>(end - begin) - (isClosed ? 0 : 1);
}

std::size_t segmentsOf(const ConstraintView& given)
{
  std::size_t segments = 0;
  for (std::size_t chain = 0; chain < given.chains; ++chain)
  {
    segments += segmentsOf(given, chain);
  }
  return segments;
}

} // namespace

/// The vertex of each of the caller's ids; kNoIndex for those that have none.
bool Triangulator::State::rankIds(Buffer<Index>& rankOf, Ticker& ticker) const
{
  rankOf.allocate(points.count);
  return inChunks(0, points.count, ticker,
           [&](std::size_t a, std::size_t b)
           { std::fill(rankOf.data() + a, rankOf.data() + b, kNoIndex); }) &&
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
  const std::size_t segments = segmentsOf(given);
  Buffer<Index> rankOf;
  if (!rankIds(rankOf, ticker) || !lookUp(ticker))
  {
    return false;
  }
  Constrainer constrainer(constrained, rankOf, std::min(segments, report.inserted), ticker);
  if (!constrainer.insertAll(given))
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

Status Triangulator::State::constrain(
  const ConstraintView& given, FillRule rule, Progress* progress)
{
  areCellsAtHand = false;
  const std::size_t segments = segmentsOf(given);
  if (report.triangles == 0)
  {
    constraints.segments = segments;
    constraints.withoutVertex = segments;
    for (std::size_t loop = given.lines; loop < given.chains; ++loop)
    {
      constraints.unfilledLoops += segmentsOf(given, loop) > 0 ? 1 : 0;
    }
    return Status::Ok;
  }
  Ticker ticker(progress, Phase::Constrain, segments);
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
