// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "FloatingPoint.h"

namespace ahd
{

Ticker::Ticker(Progress* progress, Phase phase, std::size_t total, Executor* executor)
  : progress_(progress)
  , phase_(phase)
  , total_(total)
  , executor_(executor)
{
  if (progress_)
  {
    const ScopedFloatingPoint whateverItSets;
    progress_->beginPhase(phase_);
  }
}

bool Ticker::ask()
{
  pending_ = 0;
  if (!parent_)
  {
    return !cancelled() && (!progress_ || askCaller());
  }
  flush();
  return parent_->onThisThread() ? parent_->ask() : !parent_->cancelled();
}

bool Ticker::askCaller()
{
  const ScopedFloatingPoint whateverItSets;
  if (!progress_->advance(phase_, fraction()))
  {
    cancel();
    return false;
  }
  return true;
}

} // namespace ahd
