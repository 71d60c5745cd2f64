// SPDX-License-Identifier: BSD-3-Clause
//
// When a job calls its progress function, by a clock that the tests turn on.
#include "Job/Progress.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

double now = 0.0;
double clockOfTests()
{
  return now;
}

std::int32_t keep(void* user, std::int32_t, double fraction)
{
  static_cast<std::vector<double>*>(user)->push_back(fraction);
  return 0;
}

/// Callbacks may be slow.
TEST(JobProgress, ACallbackHearsOfEachHundredthOnce)
{
  std::vector<double> heard;
  JobProgress progress(clockOfTests);
  progress.setCallback(keep, &heard);
  progress.beginRun({ 1.0 });
  progress.beginCall(0.0);
  progress.reach(1);
  progress.expectLastPhase();
  progress.beginPhase(Phase::Insert);
  for (int i = 1; i <= 10000; ++i)
  {
    EXPECT_TRUE(progress.advance(Phase::Insert, i / 10000.0));
  }
  EXPECT_GE(heard.size(), 98u);
  EXPECT_LE(heard.size(), 102u);
  const std::size_t before = heard.size();
  for (int i = 0; i < 12; ++i) // nothing is done for a second
  {
    now += 0.09;
    EXPECT_TRUE(progress.goesOn());
    EXPECT_TRUE(progress.goesOn());
  }
  EXPECT_EQ(heard.size(), before + 12);
  EXPECT_TRUE(progress.finish());
  EXPECT_TRUE(progress.finish());
  EXPECT_EQ(heard.back(), 1.0);
  EXPECT_LE(heard.size(), before + 13);
}

} // namespace
} // namespace test
} // namespace ahd
