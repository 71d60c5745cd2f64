// SPDX-License-Identifier: BSD-3-Clause
#include "OutlineRun.h"

namespace ahd
{

Status outlineWithin(CheckedMemory& checked, const OutlineMemory& memory,
  const OutlineRequest& request, const std::function<OutlineRequest()>& open, RunProgress& progress,
  Outline& out)
{
  checked = CheckedMemory(memory.limit);
  if (checked.need(memory.other + outlineMemoryEstimate(request)) != Status::Ok)
  {
    return Status::OutOfMemory;
  }
  const Status status = checked.request(progress.asked(),
    [&] {
      return outline(open(), Context{ &progress, nullptr }, out);
    });
  progress.finishPhase();
  return status == Status::Ok
    ? checked.need(ringsMemoryEstimate(out, request.points.count, memory.perPoint))
    : status;
}

Facts factsOf(const Outline& made)
{
  return { { "unfit_cells", made.unfitCells }, { "unfit_edges", made.unfitEdges } };
}

} // namespace ahd
