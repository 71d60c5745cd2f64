// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Listeners_h
#define ahd_Listeners_h

#include "Core/Progress.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace ahd
{
namespace test
{

/// Cancels at one poll, the first being 1 (0: never). Counts all polls, records the phases, and
/// expects no fraction to fall within a phase.
class Listener : public Progress
{
public:
  explicit Listener(std::size_t cancelAt = 0)
    : cancelAt_(cancelAt)
  {
  }

  void beginPhase(Phase phase) override
  {
    phases_.push_back(phase);
    fraction_ = 0.0;
  }

  bool advance(Phase phase, double fraction) override
  {
    EXPECT_FALSE(phases_.empty());
    EXPECT_TRUE(phases_.empty() || phases_.back() == phase) << "phase " << int(phase);
    EXPECT_GE(fraction, fraction_) << "phase " << int(phase);
    EXPECT_LE(fraction, 1.0) << "phase " << int(phase);
    fraction_ = fraction;
    return ++askings_ != cancelAt_;
  }

  std::size_t askings() const { return askings_; }
  const std::vector<Phase>& phases() const { return phases_; }

private:
  std::size_t cancelAt_;
  std::size_t askings_ = 0;
  std::vector<Phase> phases_;
  double fraction_ = 0.0;
};

/// Counts the polls of each phase, at least one per 2^14 steps.
class StepCounter : public Progress
{
public:
  bool advance(Phase phase, double) override
  {
    ++askings_[std::size_t(phase)];
    return true;
  }
  /// Upper limit of the steps taken.
  double steps(Phase phase) const
  {
    return double(askings_[std::size_t(phase)] + 1) * double(kStepsPerAsking);
  }

private:
  std::size_t askings_[kPhases] = {};
};

} // namespace test
} // namespace ahd

#endif
