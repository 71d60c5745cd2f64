// SPDX-License-Identifier: BSD-3-Clause
//
// The refinement of a job's result.
#include "Job.h"

#include "Refusal.h"

namespace ahd
{

const RefinedMesh& Job::refined()
{
  const JobResult& made = result();
  if (!made.refined)
  {
    refuse(Reason::NotAvailable, "Nothing is refined: ahd_refine() has not been called.");
  }
  return *made.refined;
}

const RefinedMesh& Job::refine(CheckedMemory& checked, const RefineRequest& request)
{
  JobResult& made = result();
  made.refined.reset();
  if (made.asked.options.insertionLimit > 0)
  {
    refuse(Reason::BadValue, "A result of insertion_limit cannot be refined.");
  }
  std::size_t at = 0;
  const RefineFault fault = findRefineFault(made.triangulation, request, at);
  if (fault != RefineFault::None)
  {
    refuse(Reason::BadValue, refineFaultText(request, fault, at));
  }
  const Apart apart(progress);
  auto found = std::make_unique<RefinedMesh>();
  Status status = Status::Ok;
  progress.expectLastPhase();
  withThreads(
    [&](const Context& context)
    {
      const RefineInput input = made.toRefine(progress, context);
      status = refineWithin(
        checked, { memoryLimit(), callersMemory().bytes }, input, request, *found);
      if (status == Status::OutOfMemory)
      {
        refuse(reasonOf(status, checked.isRefused), factsOf(checked, status, input));
      }
    });
  ahd::check(status);
  ahd::check(progress.finish() ? Status::Ok : Status::Cancelled);
  made.refined = std::move(found);
  return *made.refined;
}

void Job::describeRefined(MeshTriangles& triangles)
{
  const RefinedMesh& mesh = refined();
  JobResult& made = result();
  if (!triangles.fit(made.points.points().count + mesh.found.points.size()))
  {
    refuse(Reason::BadArray, "The triangles, or their regions, have numbers that there are not.");
  }
  apart([&](const Context& context)
    { ahd::check(ahd::describeRefined(made.toRefine(progress, context), mesh, triangles)); });
}

} // namespace ahd
