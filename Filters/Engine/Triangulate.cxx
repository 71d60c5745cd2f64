// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulate.h"

#include "TriangulatorState.h"

#include "Core/Border.h"
#include "Core/Chunks.h"
#include "Core/Tasks.h"
#include "Extract/Extractor.h"
#include "Order/GridBoxes.h"
#include "Order/Rank.h"
#include "Order/Sequence.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// Is the order made point by point, rather than followed by its formula?
bool needsSequence(const Options& options)
{
  return !isRankByRounds(options) || options.insertionLimit > 0;
}

} // namespace

Status Triangulator::State::sortAndInsert(
  const Options& options, Progress* progress, Executor* lent)
{
  if (points.count > kMaximumPoints)
  {
    return Status::TooManyPoints;
  }
  Executor* const executor = worthItsWhile(lent);
  Ticker reading(progress, Phase::Read, points.count, executor);
  if (const Status read = readPoints(points, reading, ranked); read != Status::Ok)
  {
    return read;
  }
  // First for sorting, then for the triangles.
  ranked.scratch.allocate(std::max(Mesh::bytesFor(ranked.count), rankScratchBytes(ranked.count)));
  Ticker sorting(progress, Phase::Sort, points.count, executor);
  if (const Status sorted = rankPoints(points, sorting, ranked); sorted != Status::Ok)
  {
    return sorted;
  }
  if (const Status made = order(options, sorting); made != Status::Ok)
  {
    return made;
  }
  count(options);
  return report.inserted < 3 ? Status::Ok : insert(options, progress, executor);
}

/// The boxes and the sequence, as far as they are wanted: later the keys are gone.
Status Triangulator::State::order(const Options& options, Ticker& sorting)
{
  std::vector<GridBox>().swap(boxes);
  if (options.keepBoxes)
  {
    if (const Status listed = listBoxes(ranked, options, sorting, boxes); listed != Status::Ok)
    {
      return listed;
    }
  }
  if (needsSequence(options) || options.keepOrder)
  {
    return makeSequence(ranked, options, sorting, sequence);
  }
  sequence.reset();
  return Status::Ok;
}

void Triangulator::State::count(const Options& options)
{
  report.inserted = options.insertionLimit == 0
    ? ranked.count
    : std::min<std::size_t>(ranked.count, options.insertionLimit);
  report.beyondLimit = ranked.count - report.inserted;
  report.duplicates = ranked.duplicates.size();
  report.notFinite = ranked.notFinite;
  report.skipped = ranked.skipped;
}

InsertionEnd Triangulator::State::insertInOrder(
  const Options& options, Ticker& ticker, InsertionWork* work, SharedWork& shared)
{
  if (!needsSequence(options))
  {
    return insertByRounds(ranked, mesh, ticker, work, shared);
  }
  Buffer<Index> first;
  first.view(sequence.data(), report.inserted);
  return insertSequence(ranked, first, mesh, ticker, work);
}

/// REQUIRES: there are three points or more to insert.
Status Triangulator::State::insert(const Options& options, Progress* progress, Executor* executor)
{
  mesh.begin(ranked.count, ranked.scratch.data());
  mesh.limitTo(static_cast<std::uint32_t>(report.inserted));
  Ticker ticker(progress, Phase::Insert, report.inserted, executor);
  InsertionWork work;
  SharedWork shared{ report.inserted, 0, report.inserted };
  const InsertionEnd end = insertInOrder(
    options, ticker, options.countWork ? &work : nullptr, shared);
  report.insertionAttempts = shared.attempts;
  report.deferredPoints = shared.deferred;
  report.criticalPath = shared.criticalPath;
  report.trianglesWalked = work.trianglesWalked;
  report.trianglesRemoved = work.trianglesRemoved;
  report.exactInCircle = work.exactInCircle;
  report.exactOrient = work.exactOrient;
  if (end == InsertionEnd::Done)
  {
    const std::size_t hull = countHullVertices(mesh, ticker);
    report.triangles = 2 * report.inserted - 2 - hull;
    return hull == 0 ? Status::Cancelled : Status::Ok;
  }
  return end == InsertionEnd::AllCollinear ? Status::Ok : Status::Cancelled;
}

template <typename Id>
Status Triangulator::State::write(Id* triples, Progress* progress, Executor* executor)
{
  if (report.triangles == 0)
  {
    return Status::Ok;
  }
  Ticker ticker(progress, Phase::Extract, report.triangles, worthItsWhile(executor));
  Scratch scratch;
  if (keepLocations)
  {
    scratch.allocate(ranked.count * kExtractScratchPerPoint);
  }
  else
  {
    scratch.view(ranked.xy.data(), ranked.xy.size() * sizeof(Point));
  }
  const ExtractedMesh kept = isLookedUp ? ExtractedMesh(mesh, constrained.allMarks(), kDropped)
                                        : mesh;
  // Asked at the end as well: the last part of the work may have been another thread's.
  return writeCanonical(kept, ranked.id.data(), triples, scratch, ticker) && ticker.ask()
    ? Status::Ok
    : Status::Cancelled;
}

namespace
{

/// Calls write(begin, end) for pieces of [0, items), on the threads lent to the phase. Returns
/// false if the work is to be cancelled.
template <typename Write>
bool writeInShares(std::size_t items, Ticker& ticker, Write write)
{
  const std::size_t tasks = tasksFor(threadsOf(ticker), items, 1, kChunk);
  return inParallel(ticker, tasks,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(items, task, tasks);
      return inChunks(share.begin, share.end, own,
        [&](std::size_t a, std::size_t b)
        {
          write(a, b);
          own.finished(b - a);
        });
    });
}

} // namespace

bool Triangulator::State::writeFates(
  std::int64_t* fates, Progress* progress, Executor* executor) const
{
  Ticker ticker(progress, Phase::Fates, points.count, worthItsWhile(executor));
  const auto writeOwn = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      fates[i] = points.skipped(i) ? std::int64_t(kFateNotInserted)
        : isFinite(points[i])      ? std::int64_t(i)
                                   : std::int64_t(kFateNotFinite);
    }
  };
  const auto writeMerged = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      fates[ranked.duplicates[i].id] = fates[ranked.duplicates[i].keptId];
    }
  };
  const auto writeBeyond = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = report.inserted + a; i != report.inserted + b; ++i)
    {
      fates[ranked.id[sequence[i]]] = kFateNotInserted;
    }
  };
  // What the others overwrite or read has to be written before.
  return writeInShares(points.count, ticker, writeOwn) &&
    writeInShares(report.beyondLimit, ticker, writeBeyond) &&
    writeInShares(ranked.duplicates.size(), ticker, writeMerged) && ticker.ask();
}

bool Triangulator::State::writeOrder(
  std::int64_t* ids, Progress* progress, Executor* executor) const
{
  Ticker ticker(progress, Phase::Fates, report.inserted, worthItsWhile(executor));
  const auto write = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      ids[i] = ranked.id[sequence[i]];
    }
  };
  return writeInShares(report.inserted, ticker, write) && ticker.ask();
}

bool Triangulator::State::writeInsertionRanks(
  std::int64_t* ranks, Progress* progress, Executor* executor) const
{
  Ticker ticker(progress, Phase::Fates, points.count, worthItsWhile(executor));
  const auto writeNone = [&](std::size_t a, std::size_t b)
  { std::fill(ranks + a, ranks + b, std::int64_t(kRankNone)); };
  const auto writePlaces = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      ranks[ranked.id[sequence[i]]] = static_cast<std::int64_t>(i);
    }
  };
  const std::size_t inOrder = report.inserted + report.beyondLimit;
  return writeInShares(points.count, ticker, writeNone) &&
    writeInShares(inOrder, ticker, writePlaces) && ticker.ask();
}

Triangulator::Triangulator() = default;
Triangulator::~Triangulator() = default;

Status Triangulator::run(
  const PointView& points, const Options& options, Progress* progress, Executor* executor)
{
  const Status status = withoutThrowing(
    [&]
    {
      if (!state_)
      {
        state_.reset(new State);
      }
      state_->points = points;
      state_->report = Report();
      state_->constraints = ConstraintReport();
      state_->isLookedUp = false;
      state_->areCellsAtHand = false;
      state_->keepLocations = options.keepLocations;
      return state_->sortAndInsert(options, progress, executor);
    });
  if (status != Status::Ok)
  {
    state_.reset();
  }
  return status;
}

const Report& Triangulator::report() const
{
  static const Report kNothing;
  return state_ ? state_->report : kNothing;
}

Status Triangulator::writeTriangles(
  std::int32_t* triples, Progress* progress, Executor* executor) const
{
  return state_ ? withoutThrowing([&] { return state_->write(triples, progress, executor); })
                : Status::Ok;
}

Status Triangulator::writeTriangles(
  std::int64_t* triples, Progress* progress, Executor* executor) const
{
  return state_ ? withoutThrowing([&] { return state_->write(triples, progress, executor); })
                : Status::Ok;
}

Status Triangulator::writeFates(std::int64_t* fates, Progress* progress, Executor* executor) const
{
  return unlessCancelled([&] { return !state_ || state_->writeFates(fates, progress, executor); });
}

Status Triangulator::writeOrder(std::int64_t* ids, Progress* progress, Executor* executor) const
{
  return unlessCancelled([&] { return !state_ || state_->writeOrder(ids, progress, executor); });
}

Status Triangulator::writeInsertionRanks(
  std::int64_t* ranks, Progress* progress, Executor* executor) const
{
  return unlessCancelled(
    [&] { return !state_ || state_->writeInsertionRanks(ranks, progress, executor); });
}

const std::vector<GridBox>& Triangulator::boxes() const
{
  static const std::vector<GridBox> kNone;
  return state_ ? state_->boxes : kNone;
}

std::size_t Triangulator::memoryHeld() const
{
  return state_
    ? state_->ranked.xy.bytes() + state_->ranked.id.bytes() + state_->ranked.scratch.bytes() +
      state_->sequence.bytes() + state_->boxes.capacity() * sizeof(GridBox) +
      state_->constrained.bytes() + state_->cells.bytes()
    : 0;
}

void Triangulator::forgetPoints()
{
  if (state_)
  {
    state_->points = PointView();
    state_->ranked.duplicates.reset();
    std::vector<GridBox>().swap(state_->boxes);
    state_->report = Report();
    state_->constraints = ConstraintReport();
  }
}

void Triangulator::release()
{
  state_.reset();
}

std::size_t Triangulator::memoryEstimate(std::size_t pointCount, const Options& options)
{
  if (pointCount > kMaximumPoints)
  {
    return std::size_t(-1);
  }
  // Bytes per point (Algorithm.md, "Memory"): a location, an id, a place in the sequence, another
  // where threads insert while an order is kept, what it takes to make an order that has no
  // formula, and a piece of memory that is first for sorting and then holds two triangles.
  constexpr std::size_t kSlots = std::max(
    2 * sizeof(std::uint32_t) * Mesh::kSlotSize, kRankScratchPerPoint);
  constexpr std::size_t kSmall = std::size_t(1) << 20;
  const std::size_t kept = options.keepOrder && !needsSequence(options) ? sizeof(Index) : 0;
  const std::size_t made = isRankByRounds(options) ? 0 : kSequenceScratchPerPoint;
  const std::size_t written = options.keepLocations ? kExtractScratchPerPoint : 0;
  return kSmall + pointCount * (sizeof(Point) + 2 * sizeof(Index) + kept + made + written + kSlots);
}

} // namespace ahd
