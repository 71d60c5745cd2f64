// SPDX-License-Identifier: BSD-3-Clause
#include "InsertTargets.h"

#include "FirstTriangle.h"
#include "Kernel.h"

namespace ahd
{
inline namespace AHD_TARGET
{

namespace
{

template <bool kCount, bool kExact>
InsertionEnd insertInSequence(const Frame& frame, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork& work)
{
  const std::size_t n = sequence.size();
  const FirstTriangle first = makeFirstTriangle(
    frame.points, n, [&sequence](std::size_t i) { return sequence[i]; }, mesh, ticker);
  if (first.end != InsertionEnd::Done)
  {
    return first.end;
  }
  Kernel<kCount, Access::Alone, kExact> kernel(frame, mesh, ticker);
  Mesh::Slot hint = 0;
  for (std::size_t i = 3; i < n; ++i)
  {
    const Index p = sequence[first.place(i)];
    const Index next = i + 1 < n ? sequence[first.place(i + 1)] : p;
    if (kernel.insert(p, next, Mesh::freshSlots(i), hint) != Insertion::Done)
    {
      return InsertionEnd::Cancelled;
    }
  }
  work = kernel.work();
  return InsertionEnd::Done;
}

} // namespace

InsertionEnd insertSequenceHere(const Frame& frame, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork* work)
{
  InsertionWork ignored;
  const auto insert = !work
    ? frame.isOnGrid() ? insertInSequence<false, true> : insertInSequence<false, false>
    : frame.isOnGrid() ? insertInSequence<true, true>
                       : insertInSequence<true, false>;
  return insert(frame, sequence, mesh, ticker, work ? *work : ignored);
}

} // namespace AHD_TARGET
} // namespace ahd
