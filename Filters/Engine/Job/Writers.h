// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobWriters_h
#define ahd_JobWriters_h

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "Job.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ahd
{

/// Where an array is to be written, and as what.
struct Target
{
  std::int32_t type;
  void* out;
  const Context& context;

  double* doubles() const { return static_cast<double*>(out); }
};

/// Calls work(pointer to ids of the type).
template <typename Work>
Status withIds(const Target& to, const Work& work)
{
  return to.type == kInt32 ? work(static_cast<std::int32_t*>(to.out))
                           : work(static_cast<std::int64_t*>(to.out));
}

/// Calls write(i) for all i in [0, count), on the threads there are.
template <typename Write>
Status forEach(std::size_t count, const Context& context, const Write& write)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      return inChunksOf(count, ticker,
        [&write](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            write(i);
          }
        });
    });
}

/// Writes value(i) to place i, for all i in [0, count).
template <typename Value>
Status fillIds(std::size_t count, const Target& to, const Value& value)
{
  return withIds(to,
    [&](auto* ids)
    {
      using Id = std::remove_pointer_t<decltype(ids)>;
      return forEach(count, to.context, [&](std::size_t i) { ids[i] = static_cast<Id>(value(i)); });
    });
}

template <typename Value>
Status fillDoubles(std::size_t count, const Target& to, const Value& value)
{
  return forEach(count, to.context, [&](std::size_t i) { to.doubles()[i] = value(i); });
}

// Output arrays by their names; see ahd.h. All return Ok, Cancelled or OutOfMemory.

Status writeBoxBounds(JobResult& made, const Target& to);
Status writeBoxLevels(JobResult& made, const Target& to);
Status writeBoxCounts(JobResult& made, const Target& to);
Status writeVoronoiPoints(JobResult& made, const Target& to);
Status writeMerged(JobResult& made, const Target& to);
Status writeSurfaceCorners(JobResult& made, const Target& to);
Status writeSurfaceWeights(JobResult& made, const Target& to);
Status writeCrossingEnds(JobResult& made, const Target& to);
Status writeCrossingFractions(JobResult& made, const Target& to);
Status writeCrossingCells(JobResult& made, const Target& to);
Status writeLeftOut(JobResult& made, const Target& to);
Status writeVoronoiOffsets(JobResult& made, const Target& to);
Status writeVoronoiCorners(JobResult& made, const Target& to);
Status writeVoronoiSites(JobResult& made, const Target& to);

} // namespace ahd

#endif
