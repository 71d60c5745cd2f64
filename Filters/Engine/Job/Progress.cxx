// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

namespace ahd
{

void JobProgress::setCallback(ProgressCallback callback, void* user)
{
  callback_ = callback;
  user_ = user;
}

void JobProgress::beginRun(const std::vector<double>& weights)
{
  setStages(weights);
  seconds_ = {};
  done_ = told_ = 0.0;
}

void JobProgress::beginApart(const std::vector<double>& weights)
{
  finishPhase();
  stagesOfRun_ = stages_;
  doneOfRun_ = done_;
  stages_.set(weights);
  done_ = told_ = 0.0;
}

void JobProgress::endApart()
{
  finishPhase();
  stages_ = stagesOfRun_;
  done_ = told_ = doneOfRun_;
}

void JobProgress::beginCall(double delay)
{
  stopped_ = false;
  toldAt_ = now();
  silentUntil_ = delay > 0.0 ? toldAt_ + delay : 0.0;
}

void JobProgress::endCall(bool wasCancelled)
{
  finishPhase();
  if (wasCancelled)
  {
    cancelled_ = false;
  }
}

bool JobProgress::finish()
{
  done_ = 1.0;
  if (told_ < done_)
  {
    tellNow();
  }
  return !isCancelled();
}

void JobProgress::beginPhase(Phase phase)
{
  RunProgress::beginPhase(phase);
  tellNow();
}

/// Once it has cancelled, it is not called again.
void JobProgress::tell(double done, Phase phase)
{
  if (!callback_ || stopped_ || (silentUntil_ > 0.0 && now() < silentUntil_))
  {
    return;
  }
  try
  {
    stopped_ = callback_(user_, static_cast<std::int32_t>(phase), done) != 0;
  }
  catch (...) // it should not throw, but it may
  {
    stopped_ = true;
  }
}

} // namespace ahd
