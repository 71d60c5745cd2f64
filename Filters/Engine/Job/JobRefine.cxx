// SPDX-License-Identifier: BSD-3-Clause
//
// The refinement of a job's result.
#include "Job.h"

#include "Refusal.h"

#include <string>

namespace ahd
{
namespace
{

void refuseFault(const RefineRequest& request, RefineFault fault, std::size_t at)
{
  const std::string ofPoint = "point " + std::to_string(at);
  switch (fault)
  {
    case RefineFault::None:
      return;
    case RefineFault::Angle:
      refuse(Reason::BadValue,
        "The minimum angle is " + std::to_string(request.minimumAngle) +
          " degrees: it must be 0 to 34.");
    case RefineFault::Area:
      refuse(Reason::BadValue, "The maximum area is NaN, negative or infinite.");
    case RefineFault::Length:
      refuse(Reason::BadValue, "The maximum length is NaN, negative or infinite.");
    case RefineFault::Size:
      refuse(Reason::BadValue,
        "The size at " + ofPoint + " is " + std::to_string(request.sizes[at]) +
          ": sizes must be finite and above 0.");
    case RefineFault::Range:
      refuse(Reason::BadValue, "A coordinate of " + ofPoint + " is 2^900 or more in magnitude.");
  }
}

} // namespace

const Refinement& Job::refined()
{
  const JobResult& made = result();
  if (!made.refined)
  {
    refuse(Reason::NotAvailable, "Nothing is refined: ahd_refine() has not been called.");
  }
  return *made.refined;
}

const Refinement& Job::refine(const RefineRequest& request)
{
  JobResult& made = result();
  made.refined.reset();
  if (made.asked.options.insertionLimit > 0)
  {
    refuse(Reason::BadValue, "A result of insertion_limit cannot be refined.");
  }
  std::size_t at = 0;
  const RefineFault fault = findRefineFault(made.triangulation, request, at);
  refuseFault(request, fault, at);
  const std::size_t points = made.points.points().count;
  CheckedMemory checked(memoryLimit(), triangulatedMemoryEstimate(points, made.asked.options));
  Status status = checked.need(callersMemory().bytes + tableMemoryEstimate(points));
  const Apart apart(progress);
  auto found = std::make_unique<Refinement>();
  progress.expectLastPhase();
  const auto refineIt = [&](const Context& context)
  { status = ahd::refine(made.triangulation, request, context, *found); };
  if (status == Status::Ok)
  {
    checked.request(progress.asked(),
      [&]
      {
        withThreads(refineIt);
        return status;
      });
  }
  if (checked.isRefused)
  {
    refuse(Reason::MemoryLimit, checked.facts(status, "refining", { "points", points }));
  }
  ahd::check(status);
  ahd::check(progress.finish() ? Status::Ok : Status::Cancelled);
  made.refined = std::move(found);
  return *made.refined;
}

} // namespace ahd
