// SPDX-License-Identifier: BSD-3-Clause
#include "Parts.h"

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"

#include <algorithm>

namespace ahd
{
inline namespace AHD_TARGET
{

namespace
{

/// Stores the larger one, so that the result does not depend on the order of threads.
void storeLarger(std::atomic<Mesh::Slot>& place, Mesh::Slot slot)
{
  Mesh::Slot known = place.load(std::memory_order_relaxed);
  while (known < slot && !place.compare_exchange_weak(known, slot, std::memory_order_relaxed))
  {
  }
}

} // namespace

Parts::Parts(const Frame& frame, Mesh& mesh, Ticker& ticker, const Round& round, std::size_t count)
  : frame_(frame)
  , points_(frame.points)
  , mesh_(mesh)
  , ticker_(ticker)
  , rounds_(round.rounds)
  , stride_(round.stride)
  , known_(round.stride * kControlStride)
  , block_(known_ *
      std::clamp<std::size_t>(points_.count / count / known_ / kLeastBlocks, 1, kMostKnown))
  , parts_(count)
  , starts_(new std::atomic<Mesh::Slot>[points_.count / block_ + 1]())
{
  waiting_.allocate(rounds_.size(stride_));
  const std::size_t blocks = points_.count / block_;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Share share(blocks, k, count);
    const std::size_t begin = share.begin * block_;
    const std::size_t end = k + 1 < count ? share.end * block_ : points_.count;
    parts_[k].territory = { static_cast<Index>(begin), static_cast<Index>(end - begin) };
    parts_[k].begin = rounds_.index(stride_, begin);
  }
}

bool Parts::findStarts()
{
  return noteStarts(2 * (block_ / known_) - 1) && (fillStarts() || (noteStarts(1) && fillStarts()));
}

/// Notes one of every so many triangles.
bool Parts::noteStarts(std::size_t every)
{
  const std::size_t noted = (2 * rounds_.before(stride_) - 2) / every;
  const std::size_t tasks = tasksFor(threadsOf(ticker_), noted, 1, kLeastNoted);
  return inParallel(ticker_, tasks,
    [&](std::size_t task, Ticker& ticker)
    {
      const Share share(noted, task, tasks);
      return inChunks(share.begin, share.end, ticker,
        [&](std::size_t a, std::size_t b)
        {
          for (std::size_t i = a; i < b; ++i)
          {
            noteStart(Mesh::slotOfTriangle(i * every));
          }
        });
    });
}

void Parts::noteStart(Mesh::Slot slot)
{
  const double toBlock = 1.0 / double(block_); // v + 0.5 is not nearer to a border than it rounds
  for (unsigned corner = 0; corner < 3; ++corner)
  {
    const Index v = mesh_.data()[slot + corner];
    if (v != mesh_.ghost())
    {
      storeLarger(starts_[static_cast<std::size_t>((v + 0.5) * toBlock)], slot);
    }
  }
}

/// Blocks without a start get that of the one before or, at the beginning of a territory, of the
/// first one after them. False: a territory has none.
bool Parts::fillStarts()
{
  const auto hasStart = [](const std::atomic<Mesh::Slot>& start)
  { return start.load(std::memory_order_relaxed) != 0; };
  for (const Part& part : parts_)
  {
    const std::size_t size = part.territory.size;
    std::atomic<Mesh::Slot>* const begin = starts_.get() + part.territory.begin / block_;
    std::atomic<Mesh::Slot>* const end = begin + (size + block_ - 1) / block_;
    const auto* const first = std::find_if(begin, end, hasStart);
    if (first == end)
    {
      return false;
    }
    Mesh::Slot last = first->load(std::memory_order_relaxed);
    for (std::atomic<Mesh::Slot>* start = begin; start != end; ++start)
    {
      last = hasStart(*start) ? start->load(std::memory_order_relaxed) : last;
      start->store(last, std::memory_order_relaxed);
    }
  }
  return true;
}

bool Parts::insertOwn(SharedWork& work)
{
  const bool done = inParallel(ticker_, parts_.size(),
    [&](std::size_t k, Ticker& ticker)
    {
      return frame_.isOnGrid() ? insertOwnOf<true>(parts_[k], ticker)
                               : insertOwnOf<false>(parts_[k], ticker);
    });
  account(work);
  return done;
}

template <bool kExact>
bool Parts::insertOwnOf(Part& part, Ticker& ticker)
{
  SharedKernel<kExact> kernel(frame_, mesh_, ticker, part.territory);
  const std::size_t end = rounds_.index(
    stride_, std::size_t(part.territory.begin) + part.territory.size);
  Index list[Rounds::kListed + 1]; // and the one after them
  Mesh::Slot hint = startFor(part.territory.begin);
  Mesh::Slot fresh = Mesh::freshSlots(rounds_.before(stride_) + part.begin);
  std::size_t waiting = part.begin;
  std::uint64_t strayed = 0;
  for (std::size_t k = part.begin; k < end;)
  {
    const std::size_t some = rounds_.list(stride_, k, end, list);
    for (std::size_t i = 0; i < some; ++i, fresh += 2 * Mesh::kSlotSize)
    {
      Insertion result = kernel.insert(list[i], list[i + 1], fresh, hint);
      if (result == Insertion::Strayed)
      {
        Mesh::Slot start = startFor(list[i]);
        result = kernel.insert(list[i], list[i + 1], fresh, start);
        hint = result == Insertion::Strayed ? hint : start;
        ++strayed;
      }
      if (result == Insertion::Cancelled)
      {
        return false;
      }
      if (result != Insertion::Done)
      {
        wait(list[i], fresh, waiting++, hint);
      }
    }
    k += some;
  }
  part.waiting = waiting - part.begin;
  part.attempts = end - part.begin + strayed;
  return true;
}

bool Parts::insertWaiting(SharedWork& work)
{
  const bool done = inParallel(ticker_, parts_.size(),
    [&](std::size_t k, Ticker& ticker)
    {
      return frame_.isOnGrid() ? insertWaitingOf<true>(parts_[k], ticker)
                               : insertWaitingOf<false>(parts_[k], ticker);
    });
  account(work);
  return done;
}

template <bool kExact>
bool Parts::insertWaitingOf(Part& part, Ticker& ticker)
{
  SharedKernel<kExact> kernel(frame_, mesh_, ticker, part.territory);
  const std::size_t end = part.begin + part.waiting;
  std::size_t waiting = part.begin;
  for (std::size_t i = part.begin; i < end; ++i)
  {
    const Index p = waiting_[i];
    const Mesh::Slot fresh = freshSlots(p);
    Mesh::Slot hint = startOf(p);
    const Insertion result = kernel.insert(p, p, fresh, hint);
    if (result == Insertion::Cancelled)
    {
      return false;
    }
    if (result != Insertion::Done)
    {
      wait(p, fresh, waiting++, hint);
    }
  }
  part.steps = kernel.steps();
  part.attempts = part.waiting;
  part.waiting = waiting - part.begin;
  return true;
}

/// Each part takes in the three after it, and the points that wait there.
void Parts::join()
{
  std::size_t joined = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k)
  {
    const Part part = parts_[k];
    if (k % kJoined == 0)
    {
      parts_[joined++] = part;
      continue;
    }
    Part& into = parts_[joined - 1];
    into.territory.size += part.territory.size;
    std::copy_n(
      waiting_.data() + part.begin, part.waiting, waiting_.data() + into.begin + into.waiting);
    into.waiting += part.waiting;
  }
  parts_.resize(joined);
}

std::size_t Parts::waiting() const
{
  std::size_t sum = 0;
  for (const Part& part : parts_)
  {
    sum += part.waiting;
  }
  return sum;
}

/// Adds what the parts did in this pass, as if each task went to the first free thread.
void Parts::account(SharedWork& work)
{
  std::vector<std::uint64_t> busy(threadsOf(ticker_), 0);
  for (Part& part : parts_)
  {
    *std::min_element(busy.begin(), busy.end()) += part.attempts;
    work.attempts += part.attempts;
    part.attempts = 0;
    waitingSteps_ += part.steps;
    part.steps = 0;
  }
  work.criticalPath += *std::max_element(busy.begin(), busy.end());
  work.deferred += waiting();
}

} // namespace AHD_TARGET
} // namespace ahd
