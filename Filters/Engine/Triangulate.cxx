// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulate.h"

#include "Chunks.h"
#include "Extract/Extractor.h"
#include "FloatingPoint.h"
#include "Insert/Inserter.h"
#include "Mesh/Mesh.h"
#include "Order/Rank.h"
#include "Order/Sequence.h"
#include "Parallel/ByRounds.h"
#include "Tasks.h"

#include <algorithm>
#include <new>
#include <stdexcept>

namespace ahd
{

namespace
{

/// Threads are asked for from so many points on: with 10^4 they cost as much as they gave, with
/// 3 10^4 two were 1.4 times as fast as one.
constexpr std::size_t kLeastForThreads = 15000;

/// The engine's border: what the standard library throws for want of memory becomes a status, and
/// floating-point arithmetic is as the engine assumes it.
template <typename Work>
Status withoutThrowing(Work work)
{
  const ScopedFloatingPoint asAssumed;
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    return Status::OutOfMemory;
  }
  catch (const std::length_error&)
  {
    return Status::OutOfMemory;
  }
}

} // namespace

struct Triangulator::State
{
  PointView points;
  RankedPoints ranked;
  Mesh mesh;
  Report report;

  Executor* worthItsWhile(Executor* lent) const
  {
    return points.count < kLeastForThreads ? nullptr : lent;
  }
  Status sortAndInsert(const Options& options, Progress* progress, Executor* executor);
  Status insert(
    const Buffer<Index>& sequence, const Options& options, Progress* progress, Executor* executor);
  template <typename Id>
  Status write(Id* triples, Progress* progress, Executor* executor);
  bool writeFates(std::int64_t* fates, Progress* progress, Executor* executor) const;
};

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
  Buffer<Index> sequence;
  if (!isRankByRounds(options))
  {
    if (const Status made = makeSequence(ranked, options, sorting, sequence); made != Status::Ok)
    {
      return made;
    }
  }
  return insert(sequence, options, progress, executor);
}

Status Triangulator::State::insert(
  const Buffer<Index>& sequence, const Options& options, Progress* progress, Executor* executor)
{
  report.inserted = ranked.count;
  report.duplicates = ranked.duplicates.size();
  report.notFinite = ranked.notFinite;
  report.skipped = ranked.skipped;
  if (ranked.count < 3)
  {
    return Status::Ok;
  }
  mesh.begin(ranked.count, ranked.scratch.data());
  Ticker ticker(progress, Phase::Insert, ranked.count, executor);
  InsertionWork work;
  SharedWork shared{ ranked.count, 0, ranked.count };
  InsertionWork* const counted = options.countWork ? &work : nullptr;
  const InsertionEnd end = isRankByRounds(options)
    ? insertByRounds(ranked, mesh, ticker, counted, shared)
    : insertSequence(ranked, sequence, mesh, ticker, counted);
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
    report.triangles = 2 * std::size_t(ranked.count) - 2 - hull;
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
  Scratch scratch; // where the locations were
  scratch.view(ranked.xy.data(), ranked.xy.size() * sizeof(Point));
  // Asked at the end as well: the last part of the work may have been another thread's.
  return writeCanonical(mesh, ranked.id.data(), triples, scratch, ticker) && ticker.ask()
    ? Status::Ok
    : Status::Cancelled;
}

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
      fates[ranked.duplicates[i].id] = ranked.duplicates[i].keptId;
    }
  };
  // What the duplicates overwrite has to be written before.
  const std::size_t tasks = tasksFor(threadsOf(ticker), points.count, 1, kChunk);
  const auto inShares = [&](std::size_t items, auto write)
  {
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
  };
  return inShares(points.count, writeOwn) && inShares(ranked.duplicates.size(), writeMerged) &&
    ticker.ask();
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
  return state_
    ? withoutThrowing([&]
        { return state_->writeFates(fates, progress, executor) ? Status::Ok : Status::Cancelled; })
    : Status::Ok;
}

std::size_t Triangulator::memoryHeld() const
{
  return state_
    ? state_->ranked.xy.bytes() + state_->ranked.id.bytes() + state_->ranked.scratch.bytes()
    : 0;
}

void Triangulator::forgetPoints()
{
  if (state_)
  {
    state_->points = PointView();
    state_->report = Report();
  }
}

void Triangulator::release()
{
  state_.reset();
}

std::size_t Triangulator::memoryEstimate(std::size_t pointCount, const Options&)
{
  // Bytes per point (Algorithm.md, "Memory"): a location, an id, a place in the sequence, and a
  // piece of memory that is first for sorting and then holds two triangles.
  constexpr std::size_t kSlots = std::max(
    2 * sizeof(std::uint32_t) * Mesh::kSlotSize, kRankScratchPerPoint);
  constexpr std::size_t kSmall = std::size_t(1) << 20;
  return kSmall + pointCount * (sizeof(Point) + 2 * sizeof(Index) + kSlots);
}

} // namespace ahd
