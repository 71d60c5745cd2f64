// SPDX-License-Identifier: BSD-3-Clause
//
// Merging points and splitting constraints where there is no memory: it is said, nothing is thrown,
// nothing is lost. This program's operator new fails when told to.
#include "Crossings/Crossings.h"
#include "Merge/Merge.h"

#include "Distributions.h"
#include "EngineRun.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

/// Fails the k-th allocation of `work` and all that follow, for every k, until it gets through.
template <typename Work>
void expectOutOfMemoryIsSaid(Work work)
{
  for (std::size_t k = 1; k < 100000; ++k)
  {
    const std::size_t before = account.held;
    account.failAt = account.allocations + k;
    const Status status = work();
    account.failAt = 0;
    EXPECT_EQ(account.held, before) << "at allocation " << k;
    if (status == Status::Ok)
    {
      EXPECT_GT(k, 3u) << "it no longer allocates through operator new";
      return;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "at allocation " << k;
  }
  FAIL() << "it never got through";
}

TEST(SplitMemory, MergingSaysSo)
{
  const std::vector<Point> points = makePoints(Distribution::Utm, 5000, 1);
  expectOutOfMemoryIsSaid(
    [&]
    {
      MergedPoints merged;
      const Status status = mergeWithin(viewOf(points), 500.0, nullptr, merged);
      EXPECT_TRUE(status != Status::Ok || !merged.pairs.empty());
      return status;
    });
}

TEST(SplitMemory, SplittingSaysSo)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 20, 1);
  std::vector<std::int64_t> ids, offsets{ 0, 10, 20 };
  for (std::int64_t id = 0; id < 20; ++id)
  {
    ids.push_back(id);
  }
  ConstraintView chains;
  chains.ids = ids.data();
  chains.offsets = offsets.data();
  chains.chains = 2;
  chains.lines = 1;
  expectOutOfMemoryIsSaid(
    [&]
    {
      SplitConstraints split;
      const Status status = splitAtCrossings(viewOf(points), chains, nullptr, split);
      EXPECT_TRUE(status != Status::Ok || split.points.size() > 10);
      return status;
    });
}

} // namespace
} // namespace test
} // namespace ahd
