// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FailingJob_h
#define ahd_FailingJob_h

#include "JobRun.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace ahd
{
namespace test
{

/// Runs a job again and again, each time with another allocation that fails, and all later ones:
/// it has run out of memory, and holds nothing. Then it runs with memory, and look(run) finds the
/// same as without a failure. Must be called within ASSERT_NO_FATAL_FAILURE.
template <typename Look>
void expectAnyAllocationCanFail(JobRun& run, const Look& look)
{
  ASSERT_EQ(run.run(), AHD_OK) << ahd_message(run.job());
  ahd_release(run.job(), 0);
  account.allocations = 0;
  ASSERT_EQ(run.run(), AHD_OK) << ahd_message(run.job());
  const std::size_t all = account.allocations;
  const auto expected = look(run);
  for (std::size_t k = 1; k <= all; ++k)
  {
    ahd_release(run.job(), 0);
    const std::size_t before = account.held;
    account.allocations = 0;
    account.failAt = k;
    const ahd_status status = run.run();
    account.failAt = 0;
    if (account.allocations < k) // where the reading of the memory that is available was kept
    {
      ASSERT_EQ(status, AHD_OK) << ahd_message(run.job());
      continue;
    }
    ASSERT_EQ(status, AHD_OUT_OF_MEMORY) << "allocation " << k << " of " << all;
    ASSERT_LE(account.held, before + 200) << "allocation " << k; // the message
    ASSERT_STRNE(ahd_message(run.job()), "");
    ASSERT_EQ(run.count("folded_triangles"), 0);
  }
  ASSERT_EQ(run.run(), AHD_OK);
  EXPECT_EQ(look(run), expected);
}

} // namespace test
} // namespace ahd

#endif
