// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulate.h"

#include "Core/Border.h"
#include "Core/Tasks.h"
#include "Extract/Extractor.h"
#include "Insert/Insert.h"
#include "Order/GridBoxes.h"
#include "Order/Rank.h"
#include "Order/Representatives.h"
#include "Order/Sequence.h"
#include "Triangulation/State.h"

#include <algorithm>
#include <utility>

namespace ahd
{

/// The largest parts of a triangulation.
struct Workspace::Memory
{
  Buffer<Point> xy;
  Buffer<Index> id;
  Scratch scratch;
  Buffer<Index> sequence;
  ConstrainedMesh constrained;
  Buffer<std::uint32_t> numbers;

  std::size_t bytes() const
  {
    return xy.bytes() + id.bytes() + scratch.bytes() + sequence.bytes() + constrained.bytes() +
      numbers.bytes();
  }
};

namespace
{

using State = TriangulationAccess::State;

/// Is the order stored point by point, rather than computed by its formula?
bool needsSequence(const Options& options)
{
  return !isRankByRounds(options) || options.insertionLimit > 0;
}

/// One call of triangulate().
class Run
{
public:
  Run(const Options& options, const Context& context, State& state)
    : options_(options)
    , progress_(context.progress)
    , state_(state)
    , executor_(state.worthItsWhile(context.executor))
  {
  }

  Status all();

private:
  Status rank(Ticker& sorting);
  Status order(Ticker& sorting);
  void count();
  Status insert();
  InsertionEnd insertInOrder(Ticker& ticker, InsertionWork& work, SharedWork& shared);

  const Options& options_;
  Progress* progress_;
  State& state_;
  Executor* executor_;
};

Status Run::all()
{
  RankedPoints& ranked = state_.ranked;
  const std::size_t points = state_.points.count;
  if (points > kMaximumPoints)
  {
    return Status::TooManyPoints;
  }
  Ticker reading(progress_, Phase::Read, points, executor_);
  if (const Status read = readPoints(state_.points, reading, ranked, options_.rankBounds);
      read != Status::Ok)
  {
    return read;
  }
  Ticker sorting(progress_, Phase::Sort, points, executor_);
  if (const Status ranking = rank(sorting); ranking != Status::Ok)
  {
    return ranking;
  }
  count();
  return state_.report.inserted < 3 ? Status::Ok : insert();
}

/// Ranks, orders, and then chooses among duplicates: orders use the smallest ids.
Status Run::rank(Ticker& sorting)
{
  RankedPoints& ranked = state_.ranked;
  // First for sorting, then for the triangles.
  ranked.scratch.allocate(std::max(Mesh::bytesFor(ranked.count), rankScratchBytes(ranked.count)));
  if (const Status sorted = rankPoints(state_.points, sorting, ranked); sorted != Status::Ok)
  {
    return sorted;
  }
  if (const Status ordered = order(sorting); ordered != Status::Ok)
  {
    return ordered;
  }
  return chooseRepresentatives(state_.points, options_.representative, ranked, sorting)
    ? Status::Ok
    : Status::Cancelled;
}

/// The boxes and the sequence, if requested: the keys are overwritten later.
Status Run::order(Ticker& sorting)
{
  if (options_.keepBoxes)
  {
    const Status listed = listBoxes(state_.ranked, options_, sorting, state_.boxes);
    if (listed != Status::Ok)
    {
      return listed;
    }
  }
  if (needsSequence(options_) || options_.keepOrder)
  {
    return makeSequence(state_.ranked, options_, sorting, state_.sequence);
  }
  state_.sequence.reset();
  return Status::Ok;
}

void Run::count()
{
  const RankedPoints& ranked = state_.ranked;
  Report& report = state_.report;
  report.inserted = options_.insertionLimit == 0
    ? ranked.count
    : std::min<std::size_t>(ranked.count, options_.insertionLimit);
  report.beyondLimit = ranked.count - report.inserted;
  report.duplicates = ranked.duplicates.size();
  report.notFinite = ranked.notFinite;
  report.skipped = ranked.skipped;
}

/// @pre there are three points or more to insert.
Status Run::insert()
{
  RankedPoints& ranked = state_.ranked;
  Report& report = state_.report;
  state_.mesh.begin(ranked.count, ranked.scratch.data());
  state_.mesh.limitTo(static_cast<std::uint32_t>(report.inserted));
  Ticker ticker(progress_, Phase::Insert, report.inserted, executor_);
  InsertionWork work;
  SharedWork shared{ report.inserted, 0, report.inserted };
  const InsertionEnd end = insertInOrder(ticker, work, shared);
  report.insertionAttempts = shared.attempts;
  report.deferredPoints = shared.deferred;
  report.criticalPath = shared.criticalPath;
  report.trianglesWalked = work.trianglesWalked;
  report.trianglesRemoved = work.trianglesRemoved;
  report.exactInCircle = work.exactInCircle;
  report.exactOrient = work.exactOrient;
  if (end == InsertionEnd::Done)
  {
    const std::size_t hull = countHullVertices(state_.mesh, ticker);
    report.triangles = state_.allTriangles = 2 * report.inserted - 2 - hull;
    return hull == 0 ? Status::Cancelled : Status::Ok;
  }
  return end == InsertionEnd::AllCollinear ? Status::Ok : Status::Cancelled;
}

InsertionEnd Run::insertInOrder(Ticker& ticker, InsertionWork& work, SharedWork& shared)
{
  InsertionWork* const counted = options_.countWork ? &work : nullptr;
  if (!needsSequence(options_))
  {
    return insertByRounds(state_.ranked, state_.mesh, ticker, counted, shared);
  }
  Buffer<Index> first;
  first.view(state_.sequence.data(), state_.report.inserted);
  return insertSequence(state_.ranked, first, state_.mesh, ticker, counted);
}

} // namespace

void TriangulationAccess::takeMemory(Workspace& from, State& to)
{
  if (Workspace::Memory* const memory = from.memory_.get())
  {
    to.ranked.xy = std::move(memory->xy);
    to.ranked.id = std::move(memory->id);
    to.ranked.scratch = std::move(memory->scratch);
    to.sequence = std::move(memory->sequence);
    to.constrained = std::move(memory->constrained);
    to.numbers = std::move(memory->numbers);
  }
}

void TriangulationAccess::giveMemory(State& from, Workspace& to)
{
  withoutThrowing(
    [&]
    {
      to.memory_.reset(to.memory_ ? to.memory_.release() : new Workspace::Memory);
      return Status::Ok;
    });
  if (Workspace::Memory* const memory = to.memory_.get())
  {
    memory->xy = std::move(from.ranked.xy);
    memory->id = std::move(from.ranked.id);
    memory->scratch = std::move(from.ranked.scratch);
    memory->sequence = std::move(from.sequence);
    memory->constrained = std::move(from.constrained);
    memory->numbers = std::move(from.numbers);
  }
}

Workspace::Workspace() = default;
Workspace::~Workspace() = default;

void Workspace::reclaim(Triangulation&& done)
{
  const TriangulationAccess::StatePointer state = std::move(TriangulationAccess::stateOf(done));
  if (state)
  {
    TriangulationAccess::giveMemory(*state, *this);
  }
}

std::size_t Workspace::bytes() const
{
  return memory_ ? memory_->bytes() : 0;
}

void Workspace::release()
{
  memory_.reset();
}

Status triangulate(const PointView& points, const Options& options, Workspace& workspace,
  const Context& context, Triangulation& out)
{
  workspace.reclaim(std::move(out));
  TriangulationAccess::StatePointer& state = TriangulationAccess::stateOf(out);
  const Status status = withoutThrowing(
    [&]
    {
      state.reset(new State);
      TriangulationAccess::takeMemory(workspace, *state);
      state->points = points;
      return Run(options, context, *state).all();
    });
  if (status != Status::Ok)
  {
    state.reset();
  }
  return status;
}

std::size_t triangulatedMemoryEstimate(std::size_t pointCount, const Options& options)
{
  if (pointCount > kMaximumPoints)
  {
    return std::size_t(-1);
  }
  // Bytes per point (Algorithm.md, "Memory"): a location, an id, a place in the sequence, another
  // where threads insert while an order is kept, a piece of memory that is first for sorting and
  // then holds two triangles, and what the extraction takes.
  constexpr std::size_t kSlots = std::max(
    2 * sizeof(std::uint32_t) * Mesh::kSlotSize, kRankScratchPerPoint);
  constexpr std::size_t kSmall = std::size_t(1) << 20;
  const std::size_t kept = options.keepOrder && !needsSequence(options) ? sizeof(Index) : 0;
  return kSmall +
    pointCount * (sizeof(Point) + 2 * sizeof(Index) + kept + kSlots + kExtractBytesPerPoint);
}

std::size_t triangulationMemoryEstimate(std::size_t pointCount, const Options& options)
{
  if (pointCount > kMaximumPoints)
  {
    return std::size_t(-1);
  }
  // Bytes to make an order that has no formula, or to choose among duplicates.
  const std::size_t made = isRankByRounds(options) ? 0 : kSequenceScratchPerPoint;
  const std::size_t chosen = options.representative == Representative::FirstId ? 0 : sizeof(Index);
  return triangulatedMemoryEstimate(pointCount, options) + pointCount * std::max(made, chosen);
}

} // namespace ahd
