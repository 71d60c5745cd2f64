// SPDX-License-Identifier: BSD-3-Clause
//
// How much memory there is, as the machine and the limits on the process have it.
#include "Core/Memory.h"

#include <gtest/gtest.h>

#include <cstddef>

#if defined(__linux__)
#include <sys/resource.h>
#endif

namespace ahd
{
namespace test
{
namespace
{

TEST(AvailableMemory, IsSome)
{
  EXPECT_GT(availableMemory(), std::size_t(1) << 20);
}

#if defined(__linux__)
TEST(AvailableMemory, KeepsToTheAddressSpace)
{
  constexpr std::size_t kRoom = std::size_t(200) << 20;
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  // The least limit that is above what is taken: no more is left under it than it was raised by.
  rlimit limit = before;
  limit.rlim_cur = kRoom;
  while (setrlimit(RLIMIT_AS, &limit) == 0 && availableMemory() == 0)
  {
    limit.rlim_cur += kRoom;
  }
  const std::size_t left = availableMemory();
  setrlimit(RLIMIT_AS, &before);
  EXPECT_GT(left, 0u);
  EXPECT_LE(left, kRoom);
  EXPECT_GT(availableMemory(), kRoom) << "the limit is gone";
}
#endif

} // namespace
} // namespace test
} // namespace ahd
