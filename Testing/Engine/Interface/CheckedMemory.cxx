// SPDX-License-Identifier: BSD-3-Clause
//
// The memory of other work than a run, compared with the limit or with what there is.
#include "Job/CheckedMemory.h"

#include <gtest/gtest.h>

#include <limits>

namespace ahd
{
namespace test
{

constexpr std::size_t kHeld = std::size_t(1) << 50; // more than there is

TEST(CheckedMemory, CountsOnceWhatIsHeld)
{
  EXPECT_FALSE(CheckedMemory(0, kHeld).isRefused) << "it is no part of what there is";
  EXPECT_TRUE(CheckedMemory(kHeld - 1, kHeld).isRefused) << "it counts in a limit";
  EXPECT_EQ(CheckedMemory(0, kHeld).need(kHeld), Status::OutOfMemory);
  EXPECT_FALSE(CheckedMemory(0, std::numeric_limits<std::size_t>::max()).isRefused);
  EXPECT_EQ(CheckedMemory(kHeld + 7, kHeld).need(7), Status::Ok);
  EXPECT_EQ(CheckedMemory(kHeld + 7, kHeld).need(8), Status::OutOfMemory);
}

TEST(CheckedMemory, WorkRequestsWhatIsLeft)
{
  for (const std::size_t bytes : { 60u, 61u })
  {
    AskedMemory asked;
    CheckedMemory checked(100, 30);
    EXPECT_EQ(checked.need(10), Status::Ok);
    const Status status = bytes <= 60 ? Status::Ok : Status::OutOfMemory;
    EXPECT_EQ(checked.request(asked,
                [&]
                {
                  EXPECT_EQ(asked.take(bytes), status == Status::Ok);
                  return status;
                }),
      status);
    EXPECT_TRUE(asked.take(1000)); // the limit is that of the work
    EXPECT_EQ(checked.needed, 40 + bytes);
    EXPECT_EQ(checked.isRefused, status != Status::Ok);
    const Facts facts = checked.facts(status, "editing", { "points", 7 });
    EXPECT_EQ(facts["points"], 7);
    EXPECT_EQ(facts["memory_estimate"], std::int64_t(40 + bytes));
    EXPECT_EQ(facts["memory_allowed"], 100);
  }
}

} // namespace test
} // namespace ahd
