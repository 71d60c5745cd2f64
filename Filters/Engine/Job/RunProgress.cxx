// SPDX-License-Identifier: BSD-3-Clause
#include "RunProgress.h"

#include <algorithm>

namespace ahd
{
namespace
{

constexpr double kStep = 0.01;          // of the whole
constexpr double kSilence = 1.0 / 12.0; // seconds, at most

} // namespace

void RunProgress::setStages(const std::vector<double>& weights)
{
  stages_.set(weights);
  stagesBegun_.clear();
  stagesBegun_.reserve(weights.size());
}

void RunProgress::move()
{
  if (stagesBegun_.size() < std::min(stages_.count(), stagesBegun_.capacity()))
  {
    stagesBegun_.push_back(now());
  }
  done_ = std::max(done_, stages_.next());
}

void RunProgress::nextStage()
{
  move();
  if (done_ >= told_ + kStep && !isCancelled())
  {
    tellNow();
  }
}

void RunProgress::reach(std::size_t stage)
{
  while (stages_.current() < stage && stages_.current() < stages_.count())
  {
    move();
  }
}

void RunProgress::beginPhase(Phase phase)
{
  finishPhase();
  stages_.beginPhase(phase);
  phase_ = phase;
  begun_ = now();
  inPhase_ = true;
}

bool RunProgress::advance(Phase, double fraction)
{
  done_ = std::max(done_, stages_.whole(fraction));
  return goesOn();
}

bool RunProgress::goesOn()
{
  if ((done_ >= told_ + kStep || now() - toldAt_ >= kSilence) && !isCancelled())
  {
    tellNow();
  }
  return !isCancelled();
}

void RunProgress::finishPhase()
{
  if (inPhase_)
  {
    seconds_[std::size_t(phase_)] += now() - begun_;
    inPhase_ = false;
  }
}

void RunProgress::tellNow()
{
  told_ = done_;
  tell(done_, phase_);
  toldAt_ = now(); // it takes time
}

} // namespace ahd
