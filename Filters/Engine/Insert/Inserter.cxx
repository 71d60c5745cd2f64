// SPDX-License-Identifier: BSD-3-Clause
#include "Inserter.h"

#include "Kernel.h"

#include "../Predicates/Predicates.h"

namespace ahd
{

namespace
{

/// The first triangle: the first two points of the sequence and the first that is not on their
/// line.
struct FirstTriangle
{
  std::size_t third = 0; ///< place in the sequence; 0: all collinear
  bool counterclockwise = true;
  bool cancelled = false;
};

FirstTriangle findFirstTriangle(
  const RankedPoints& points, const Buffer<Index>& sequence, Ticker& ticker)
{
  const Point* const xy = points.xy.data();
  FirstTriangle first;
  for (std::size_t i = 2; i < sequence.size(); ++i)
  {
    const int side = orient2d(xy[sequence[0]], xy[sequence[1]], xy[sequence[i]]);
    if (side != 0)
    {
      first.third = i;
      first.counterclockwise = side > 0;
      return first;
    }
    if (!ticker.step())
    {
      first.cancelled = true;
      return first;
    }
  }
  return first;
}

template <bool kCount>
InsertionEnd insertRest(Kernel<kCount>& kernel, const Buffer<Index>& sequence, std::size_t third)
{
  const std::size_t n = sequence.size();
  const auto at = [&sequence, third](std::size_t i)
  {
    // The third corner stands at place 2 instead of its own: places 2..third move up by one.
    return sequence[i <= third ? i - 1 : i];
  };
  Mesh::Slot hint = 0;
  for (std::size_t i = 3; i < n; ++i)
  {
    const Index next = i + 1 < n ? at(i + 1) : at(i);
    if (!kernel.insert(at(i), next, hint))
    {
      return InsertionEnd::Cancelled;
    }
  }
  return InsertionEnd::Done;
}

template <bool kCount>
InsertionEnd insertAll(const RankedPoints& points, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork& work)
{
  const FirstTriangle first = findFirstTriangle(points, sequence, ticker);
  if (first.cancelled)
  {
    return InsertionEnd::Cancelled;
  }
  if (first.third == 0)
  {
    return InsertionEnd::AllCollinear;
  }
  const Index a = sequence[first.counterclockwise ? 0 : 1];
  const Index b = sequence[first.counterclockwise ? 1 : 0];
  mesh.makeFirstTriangle(a, b, sequence[first.third]);
  ticker.finished(3);

  Kernel<kCount> kernel(points, mesh, ticker);
  const InsertionEnd end = insertRest(kernel, sequence, first.third);
  work = kernel.work();
  return end;
}

} // namespace

InsertionEnd insertSequence(const RankedPoints& points, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork* work)
{
  InsertionWork ignored;
  return work ? insertAll<true>(points, sequence, mesh, ticker, *work)
              : insertAll<false>(points, sequence, mesh, ticker, ignored);
}

} // namespace ahd
