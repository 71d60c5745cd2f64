// SPDX-License-Identifier: BSD-3-Clause
#include "InsertTargets.h"

#include "Parts.h"

#include "../Core/Tasks.h"
#include "../Order/Rounds.h"
#include "FirstTriangle.h"
#include "Kernel.h"

#include <algorithm>

namespace ahd
{
inline namespace AHD_TARGET
{

namespace
{

template <bool kCount, bool kExact>
class ByRounds
{
public:
  ByRounds(const Frame& frame, Mesh& mesh, Ticker& ticker, SharedWork& shared)
    : frame_(frame)
    , points_(frame.points)
    , mesh_(mesh)
    , ticker_(ticker)
    , rounds_(frame.points.count)
    , kernel_(frame, mesh, ticker)
    , shared_(shared)
  {
  }

  InsertionEnd insertAll()
  {
    const std::size_t n = points_.count;
    const FirstTriangle first = makeFirstTriangle(
      points_, n, [this](std::size_t i) { return at(i); }, mesh_, ticker_);
    if (first.end != InsertionEnd::Done)
    {
      return first.end;
    }
    if (!kernel_.beginToNote())
    {
      return InsertionEnd::Cancelled;
    }
    shared_ = { 3, 0, 3 };
    const std::size_t moved = std::max<std::size_t>(3, first.third + 1);
    if (!insertPlaces(3, moved, [&](std::size_t i) { return at(first.place(i)); }))
    {
      return InsertionEnd::Cancelled;
    }
    for (std::size_t stride = rounds_.firstStride(); stride > 0; stride /= kControlStride)
    {
      if (!insertRound(stride, moved))
      {
        return InsertionEnd::Cancelled;
      }
    }
    return InsertionEnd::Done;
  }

  const InsertionWork& work() const { return kernel_.work(); }

private:
  /// The i-th vertex of the order.
  Index at(std::size_t i) const
  {
    std::size_t stride = rounds_.firstStride();
    while (i >= rounds_.before(stride) + rounds_.size(stride))
    {
      stride /= kControlStride;
    }
    return static_cast<Index>(rounds_.place(stride, i - rounds_.before(stride)));
  }

  /// The points of this round that stand at place `from` of the order or after it.
  bool insertRound(std::size_t stride, std::size_t from)
  {
    const std::size_t before = rounds_.before(stride);
    const std::size_t size = rounds_.size(stride);
    if (before + size <= from)
    {
      return true;
    }
    if (before >= from && partsFor(size) > 1)
    {
      return insertInParts(stride, partsFor(size));
    }
    const std::size_t begin = std::max(before, from);
    if (stride == 1 && before != 0)
    {
      return insertLastRound(before, begin);
    }
    return insertPlaces(begin, before + size,
      [=](std::size_t i) { return static_cast<Index>(rounds_.place(stride, i - before)); });
  }

  /// The last round, which has most of the points, from place `begin` of the order on: listed many
  /// points at a time.
  bool insertLastRound(std::size_t before, std::size_t begin)
  {
    Index list[Rounds::kListed + 1]; // and the one after them
    const std::size_t size = points_.count - before;
    while (begin < points_.count)
    {
      const std::size_t some = rounds_.list(1, begin - before, size, list);
      if (!insertListed(list, begin, some))
      {
        return false;
      }
      begin += some;
    }
    return true;
  }

  /// Vertices that are at place `begin` of the order and after it.
  bool insertListed(const Index* list, std::size_t begin, std::size_t count)
  {
    shared_.attempts += count;
    shared_.criticalPath += count;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Mesh::Slot fresh = Mesh::freshSlots(begin + i);
      if (kernel_.insert(list[i], list[i + 1], fresh, hint_) != Insertion::Done)
      {
        return false;
      }
    }
    return true;
  }

  template <typename VertexAt>
  bool insertPlaces(std::size_t begin, std::size_t end, VertexAt vertexAt)
  {
    shared_.attempts += end - begin;
    shared_.criticalPath += end - begin;
    Index next = begin < end ? vertexAt(begin) : 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      const Index p = next;
      next = i + 1 < end ? vertexAt(i + 1) : p;
      if (kernel_.insert(p, next, Mesh::freshSlots(i), hint_) != Insertion::Done)
      {
        return false;
      }
      kernel_.note(p, hint_);
    }
    return true;
  }

  /// In how many parts to insert a round of so many points.
  std::size_t partsFor(std::size_t size) const
  {
    const bool alone = kCount || points_.count < kLeastShared || isBetterAlone_;
    return alone ? 1 : std::min(threadsOf(ticker_), size / kLeastPart);
  }

  bool insertInParts(std::size_t stride, std::size_t count)
  {
    Parts parts(frame_, mesh_, ticker_, { rounds_, stride }, count);
    return parts.insert(kernel_, shared_, isBetterAlone_);
  }

  static constexpr std::size_t kLeastPart = 512; ///< points of the round

  const Frame& frame_;
  const RankedPoints& points_;
  Mesh& mesh_;
  Ticker& ticker_;
  Rounds rounds_;
  Kernel<kCount, Access::Alone, kExact> kernel_;
  Mesh::Slot hint_ = 0;
  bool isBetterAlone_ = false; ///< in the round before
  SharedWork& shared_;
};

template <bool kCount, bool kExact>
InsertionEnd insertRounds(
  const Frame& frame, Mesh& mesh, Ticker& ticker, InsertionWork& work, SharedWork& shared)
{
  ByRounds<kCount, kExact> inserter(frame, mesh, ticker, shared);
  const InsertionEnd end = inserter.insertAll();
  work = inserter.work();
  return end;
}

} // namespace

InsertionEnd insertByRoundsHere(
  const Frame& frame, Mesh& mesh, Ticker& ticker, InsertionWork* work, SharedWork& shared)
{
  InsertionWork ignored;
  const auto insert = !work
    ? frame.isOnGrid() ? insertRounds<false, true> : insertRounds<false, false>
    : frame.isOnGrid() ? insertRounds<true, true>
                       : insertRounds<true, false>;
  return insert(frame, mesh, ticker, work ? *work : ignored, shared);
}

} // namespace AHD_TARGET
} // namespace ahd
