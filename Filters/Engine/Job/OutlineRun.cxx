// SPDX-License-Identifier: BSD-3-Clause
#include "OutlineRun.h"

#include "../Core/Memory.h"

namespace ahd
{

Status OutlineMemory::need(std::size_t bytes)
{
  needed += bytes;
  isRefused = needed > allowed;
  return isRefused ? Status::OutOfMemory : Status::Ok;
}

Facts OutlineMemory::facts(Status status, const OutlineRequest& request) const
{
  return { { "reason", reasonOf(status, isRefused) }, { "doing", "outlining" },
    { "polygons", request.cells.cells }, { "memory_limit", limit }, { "memory_estimate", needed },
    { "memory_allowed", allowed } };
}

Status outlineWithin(OutlineMemory& memory, const OutlineRequest& request,
  const std::function<OutlineRequest()>& open, RunProgress& progress, Outline& out)
{
  memory.allowed = memory.limit > 0 ? memory.limit : availableMemory();
  memory.needed = memory.other;
  if (memory.need(outlineMemoryEstimate(request)) != Status::Ok)
  {
    return Status::OutOfMemory;
  }
  AskedMemory& asked = progress.asked();
  asked.limitTo(memory.allowed - memory.needed);
  const Status status = outline(open(), Context{ &progress, nullptr }, out);
  progress.finishPhase();
  memory.needed += asked.most();
  memory.isRefused = status == Status::OutOfMemory && asked.wasRefused();
  return status;
}

Facts factsOf(const Outline& made)
{
  return { { "unfit_cells", made.unfitCells }, { "unfit_edges", made.unfitEdges } };
}

} // namespace ahd
