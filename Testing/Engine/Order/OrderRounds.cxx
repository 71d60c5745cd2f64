// SPDX-License-Identifier: BSD-3-Clause
//
// The places of an order in rounds: each once, and the same as a list as one by one.
#include "Order/Rounds.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

const std::size_t kSizes[] = { 13, 14, 23, 24, 25, 143, 144, 145, 156, 1000, 1728, 1729, 30000 };

TEST(OrderRounds, EachPlaceOnce)
{
  for (const std::size_t n : kSizes)
  {
    const Rounds rounds(n);
    std::vector<int> met(n, 0);
    for (std::size_t stride = rounds.firstStride(); stride > 0; stride /= kControlStride)
    {
      for (std::size_t k = 0; k < rounds.size(stride); ++k)
      {
        ++met.at(rounds.place(stride, k));
      }
    }
    ASSERT_EQ(met, std::vector<int>(n, 1)) << n;
  }
}

TEST(OrderRounds, TheLastListedFromAnyPlaceOn)
{
  for (const std::size_t n : kSizes)
  {
    const Rounds rounds(n);
    const std::size_t size = rounds.size(1);
    for (const std::size_t some : { std::size_t(1), std::size_t(10), std::size_t(11), size })
    {
      for (std::size_t k = 0; k < size; k += some)
      {
        std::vector<std::uint32_t> listed(std::min(some, size - k));
        rounds.lastPlaces(k, listed.size(), listed.data());
        for (std::size_t i = 0; i < listed.size(); ++i)
        {
          ASSERT_EQ(listed[i], rounds.place(1, k + i)) << n << ", " << k << ", " << i;
        }
      }
    }
  }
}

TEST(OrderRounds, ListedInPieces)
{
  for (const std::size_t n : kSizes)
  {
    const Rounds rounds(n);
    for (std::size_t stride = rounds.firstStride(); stride > 0; stride /= kControlStride)
    {
      for (const std::size_t end : { rounds.size(stride), rounds.size(stride) / 2 })
      {
        std::uint32_t listed[Rounds::kListed + 1];
        for (std::size_t k = 0, some = 0; k < end; k += some)
        {
          some = rounds.list(stride, k, end, listed);
          ASSERT_EQ(some, std::min(Rounds::kListed, end - k));
          for (std::size_t i = 0; i <= some; ++i)
          {
            ASSERT_EQ(listed[i], rounds.place(stride, std::min(k + i, end - 1))) << n << ", " << k;
          }
        }
      }
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
