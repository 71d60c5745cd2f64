// SPDX-License-Identifier: BSD-3-Clause
//
// The points and segments of a job that are edited.
#include "Job.h"

#include "Refusal.h"

namespace ahd
{

namespace
{

/// Fewer need no threads, and no look at the memory that there is: both cost more than a point.
constexpr std::size_t kMany = std::size_t(1) << 14;

} // namespace

const Edit& Job::edited()
{
  if (!edit_)
  {
    edit_ = std::make_unique<Edit>();
  }
  return *edit_;
}

void Job::checkEditMemory(std::size_t more)
{
  const std::size_t limit = memoryLimit();
  if (more == 0 || (limit == 0 && more < kMany))
  {
    return;
  }
  const std::size_t held = edited().heldMemory();
  CheckedMemory checked(limit, held);
  const Status status = checked.need(callersMemory().bytes + edited().memoryEstimate(more) - held);
  if (status != Status::Ok)
  {
    refuse(Reason::MemoryLimit,
      checked.facts(status, "editing", { "points", edited().pointCount() + more }));
  }
}

void Job::editWith(std::uint64_t more, const std::function<Status(Edit&, const Context&)>& work)
{
  checkCount(more, "points");
  if (more > kMaximumPoints - edited().idCount())
  {
    refuse(Reason::TooManyPoints,
      "Ids are not used again, and these points would need more than " +
        std::to_string(kMaximumPoints) + ". Edit what is left anew.");
  }
  checkEditMemory(static_cast<std::size_t>(more));
  const Apart apart(progress);
  const auto checked = [&](const Context& context)
  { ahd::check(progress.goesOn() ? work(*edit_, context) : Status::Cancelled); };
  more < kMany ? checked({ &progress, nullptr }) : withThreads(checked);
}

} // namespace ahd
