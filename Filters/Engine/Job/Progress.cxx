// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include <algorithm>
#include <cstdint>

namespace ahd
{
namespace
{

constexpr double kStep = 0.01;          // of the whole
constexpr double kSilence = 1.0 / 12.0; // seconds, at most

} // namespace

void JobProgress::setCallback(ProgressCallback callback, void* user)
{
  callback_ = callback;
  user_ = user;
}

void JobProgress::beginRun(const std::vector<double>& weights)
{
  stages_.set(weights);
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

void JobProgress::beginCall()
{
  stopped_ = false;
  toldAt_ = now();
}

void JobProgress::endCall(bool isCancelled)
{
  finishPhase();
  if (isCancelled)
  {
    cancelled_ = false;
  }
}

void JobProgress::reach(std::size_t stage)
{
  while (stages_.current() < stage)
  {
    done_ = std::max(done_, stages_.next());
  }
}

bool JobProgress::finish()
{
  done_ = 1.0;
  if (told_ < done_)
  {
    tell();
  }
  return !stopped_ && !cancelled_.load(std::memory_order_relaxed);
}

void JobProgress::finishPhase()
{
  if (inPhase_)
  {
    seconds_[std::size_t(phase_)] += now() - begun_;
    inPhase_ = false;
  }
}

void JobProgress::beginPhase(Phase phase)
{
  finishPhase();
  stages_.beginPhase(phase);
  phase_ = phase;
  begun_ = now();
  inPhase_ = true;
  tell();
}

bool JobProgress::advance(Phase, double fraction)
{
  done_ = std::max(done_, stages_.whole(fraction));
  if (callback_ && (done_ >= told_ + kStep || now() - toldAt_ >= kSilence))
  {
    tell();
  }
  return !stopped_ && !cancelled_.load(std::memory_order_relaxed);
}

/// Once it has said that it is enough, it is not asked again.
void JobProgress::tell()
{
  if (!callback_ || stopped_)
  {
    return;
  }
  told_ = done_;
  try
  {
    stopped_ = callback_(user_, static_cast<std::int32_t>(phase_), done_) != 0;
  }
  catch (...) // it is C's, but who knows
  {
    stopped_ = true;
  }
  toldAt_ = now(); // it takes time
}

} // namespace ahd
