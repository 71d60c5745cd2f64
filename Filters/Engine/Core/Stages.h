// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Stages_h
#define ahd_Stages_h

#include "Progress.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// The progress of work that consists of stages, in each of which the engine begins phases.
///
/// A stage takes a part of the whole by its weight, which is about its time. Reading, sorting and
/// inserting take a part of their stage by their time. The number of other phases in a stage is not
/// known: each takes half of the rest.
class Stages
{
public:
  /// Sets the stages to come, by their weights; stages of weight 0 are skipped. Without this call
  /// there is one.
  void set(const std::vector<double>& weights)
  {
    double all = 0.0;
    for (const double weight : weights)
    {
      all += weight;
    }
    double sum = 0.0;
    ends_.assign(1, 0.0); // before the first
    for (const double weight : weights)
    {
      sum += weight;
      ends_.push_back(all > 0.0 ? sum / all : 1.0);
    }
    stage_ = 0;
    isLastPhase_ = false;
  }

  /// The next stage begins; after the last one, all is done. Returns the fraction that is done.
  double next()
  {
    const double done = endOf(stage_);
    stage_ = stage_ + 1 < ends_.size() ? stage_ + 1 : stage_;
    phaseBegin_ = phaseEnd_ = 0.0;
    isLastPhase_ = false;
    return done;
  }

  /// How many stages were set.
  std::size_t count() const { return ends_.empty() ? 0 : ends_.size() - 1; }
  /// The number of the stage, from 1; 0 before the first.
  std::size_t current() const { return stage_; }

  /// The next phase is the last of its stage: it takes all that is left.
  void expectLastPhase() { isLastPhase_ = true; }

  void beginPhase(Phase phase)
  {
    constexpr double kReadEnd = 0.07; // of a stage that triangulates
    constexpr double kSortEnd = 0.20;
    phaseBegin_ = phaseEnd_;
    phaseEnd_ = phase == Phase::Read           ? kReadEnd
      : phase == Phase::Sort                   ? kSortEnd
      : phase == Phase::Insert || isLastPhase_ ? 1.0
                                               : 0.5 * (phaseBegin_ + 1.0);
    isLastPhase_ = false;
  }

  /// The fraction of the whole that is done when this fraction of the phase is.
  double whole(double fraction) const
  {
    const double inStage = phaseBegin_ + fraction * (phaseEnd_ - phaseBegin_);
    const double begin = stage_ == 0 ? 0.0 : endOf(stage_ - 1);
    return begin + inStage * (endOf(stage_) - begin);
  }

private:
  double endOf(std::size_t stage) const { return ends_.empty() ? 1.0 : ends_[stage]; }

  std::vector<double> ends_; ///< as parts of the whole; empty: there is one stage
  std::size_t stage_ = 0;
  double phaseBegin_ = 0.0; ///< as parts of the stage
  double phaseEnd_ = 0.0;
  bool isLastPhase_ = false; ///< the next one
};

} // namespace ahd

#endif
