// SPDX-License-Identifier: BSD-3-Clause
#include "RefineRun.h"

#include "../Core/AskedMemory.h"
#include "../Core/Border.h"
#include "../Surface/CellArrays.h"
#include "../Triangulate.h"

namespace ahd
{

Status refineWithin(CheckedMemory& checked, const RefineMemory& memory, const RefineInput& input,
  const RefineRequest& request, RefinedMesh& out)
{
  const std::size_t points = input.points.points().count;
  checked = CheckedMemory(memory.limit, triangulatedMemoryEstimate(points, input.options));
  if (checked.need(memory.other + tableMemoryEstimate(points)) != Status::Ok)
  {
    return Status::OutOfMemory;
  }
  const auto work = [&]
  {
    const Context context = input.context();
    const auto cellOf = [&input](std::size_t chain) { return input.points.cellOf(chain); };
    const Status status = refine(input.made, request, context, out.found);
    return status == Status::Ok
      ? findPieces(input.made, { input.points.constraints(), cellOf }, context, out)
      : status;
  };
  return checked.request(input.progress.asked(), work);
}

std::string refineFaultText(const RefineRequest& request, RefineFault fault, std::size_t at)
{
  const std::string ofPoint = "point " + std::to_string(at);
  switch (fault)
  {
    case RefineFault::Angle:
      return "The minimum angle is " + std::to_string(request.minimumAngle) +
        " degrees: it must be 0 to 34.";
    case RefineFault::Area:
      return "The maximum area is NaN, negative or infinite.";
    case RefineFault::Length:
      return "The maximum length is NaN, negative or infinite.";
    case RefineFault::Size:
      return "The size at " + ofPoint + " is " + std::to_string(request.sizes[at]) +
        ": sizes must be finite and above 0.";
    case RefineFault::Range:
      return "A coordinate of " + ofPoint + " is 2^900 or more in magnitude.";
    case RefineFault::None:
      break;
  }
  return {};
}

Status describeRefined(const RefineInput& input, const RefinedMesh& mesh, MeshTriangles& triangles)
{
  const Context context = input.context();
  return withoutThrowing(
    [&]
    {
      const std::size_t count = triangles.regions ? input.made.report().triangles : 0;
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      TakenMemory memory(ticker);
      memory.atLeast(count * (3 * sizeof(std::int32_t) + sizeof(std::int64_t)));
      std::vector<std::int32_t> corners(3 * count);
      std::vector<std::int64_t> regions(count);
      Status status = Status::Ok;
      if (count > 0)
      {
        status = input.made.writeTriangles(corners.data(), context);
      }
      if (count > 0 && status == Status::Ok)
      {
        status = writeRegions(input.made, Selection(), regions.data(), context);
      }
      return status == Status::Ok
        ? describeTriangles(input.points.points(), { corners.data(), regions.data(), count }, mesh,
            context, triangles)
        : status;
    });
}

} // namespace ahd
