// SPDX-License-Identifier: BSD-3-Clause
//
// The fraction of the whole in each stage and phase.
#include "Core/Stages.h"
#include "Job/RunProgress.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

TEST(Stages, TakeTheirWeights)
{
  Stages stages;
  stages.set({ 1.0, 0.0, 3.0 });
  EXPECT_EQ(stages.current(), 0u);
  EXPECT_EQ(stages.next(), 0.0);
  stages.beginPhase(Phase::Insert);
  EXPECT_EQ(stages.whole(0.0), 0.0);
  EXPECT_EQ(stages.whole(1.0), 0.25);
  EXPECT_EQ(stages.next(), 0.25);
  EXPECT_EQ(stages.whole(0.5), 0.25) << "a stage of weight 0";
  EXPECT_EQ(stages.next(), 0.25);
  EXPECT_EQ(stages.current(), 3u);
  stages.beginPhase(Phase::Insert);
  EXPECT_EQ(stages.whole(0.5), 0.625);
  EXPECT_EQ(stages.next(), 1.0);
}

TEST(Stages, TheUsualPhasesTakeTheirTimes)
{
  Stages stages;
  stages.set({ 1.0 });
  stages.next();
  stages.beginPhase(Phase::Read);
  EXPECT_EQ(stages.whole(0.0), 0.0);
  EXPECT_EQ(stages.whole(1.0), 0.07);
  stages.beginPhase(Phase::Sort);
  EXPECT_EQ(stages.whole(0.0), 0.07);
  EXPECT_EQ(stages.whole(1.0), 0.2);
  stages.beginPhase(Phase::Insert);
  EXPECT_EQ(stages.whole(0.0), 0.2);
  EXPECT_EQ(stages.whole(1.0), 1.0);
}

TEST(Stages, ALastPhaseTakesAllThatIsLeft)
{
  Stages stages;
  stages.set({ 1.0, 1.0 });
  stages.next();
  stages.beginPhase(Phase::Outputs);
  stages.expectLastPhase();
  stages.beginPhase(Phase::Outputs);
  EXPECT_EQ(stages.whole(0.0), 0.25);
  EXPECT_EQ(stages.whole(1.0), 0.5);
  stages.expectLastPhase();
  stages.next();
  stages.beginPhase(Phase::Outputs); // of a stage that expects nothing
  EXPECT_EQ(stages.whole(1.0), 0.75);
}

TEST(Stages, OtherPhasesTakeHalfOfWhatIsLeft)
{
  Stages stages;
  stages.set({ 1.0 });
  stages.next();
  for (const double begin : { 0.0, 0.5, 0.75 })
  {
    stages.beginPhase(Phase::Outputs);
    EXPECT_EQ(stages.whole(0.0), begin);
    EXPECT_EQ(stages.whole(1.0), 0.5 * (begin + 1.0));
  }
}

TEST(Stages, WithoutWeightsThereIsOne)
{
  Stages stages;
  stages.beginPhase(Phase::Insert);
  EXPECT_EQ(stages.whole(0.5), 0.5);
}

class SilentProgress : public RunProgress
{
  bool isCancelled() const override { return false; }
  void tell(double, Phase) override {}
};

TEST(Stages, WithoutWeightsThereIsNoneToReach)
{
  SilentProgress progress;
  progress.reach(3);
  EXPECT_TRUE(progress.stagesBegun().empty());
  progress.setStages({ 1.0, 1.0 });
  progress.reach(3);
  EXPECT_EQ(progress.stagesBegun().size(), 2u);
}

} // namespace
} // namespace test
} // namespace ahd
