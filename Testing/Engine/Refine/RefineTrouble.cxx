// SPDX-License-Identifier: BSD-3-Clause
//
// refine() where it is cancelled or has no memory. This program's operator new counts, and fails on
// demand.
#include "RefineCase.h"

#include "Listeners.h"
#include "MemoryListener.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

std::vector<double> sizesOf(const ConstraintCase& from)
{
  std::vector<double> sizes;
  for (std::size_t k = 0; k < from.points.size(); ++k)
  {
    sizes.push_back(0.1 + double(k % 7));
  }
  return sizes;
}

TEST(RefineTrouble, AnyAskingCanCancel)
{
  const ConstraintCase from = shortSegments(8000, 2000);
  Listener all;
  RefineCase whole(from);
  ASSERT_EQ(whole.run(&all), Status::Ok);
  EXPECT_GT(all.askings(), 20u);
  for (std::size_t k = 1; k <= all.askings(); ++k)
  {
    Listener listener(k);
    RefineCase given(from);
    ASSERT_EQ(given.run(&listener), Status::Cancelled);
    EXPECT_TRUE(given.made.points.empty());
    EXPECT_LE(listener.askings(), k) << "nobody is asked again";
  }
}

TEST(RefineTrouble, AnyAllocationCanFail)
{
  const ConstraintCase from = starPolygon(20);
  const std::vector<double> sizes = sizesOf(from);
  RefineCase expected(from);
  expected.request.sizes = sizes.data();
  ASSERT_EQ(expected.run(), Status::Ok);
  for (std::size_t failed = 0;; ++failed)
  {
    RefineCase given(from);
    given.request.sizes = sizes.data();
    account.allocations = 0;
    account.failAt = failed + 1;
    const Status status = given.run();
    account.failAt = 0;
    if (status == Status::Ok)
    {
      EXPECT_EQ(given.made.ids, expected.made.ids);
      EXPECT_GT(failed, 30u);
      break;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << failed + 1;
    EXPECT_TRUE(given.made.points.empty());
  }
}

TEST(RefineTrouble, MemoryIsRequested)
{
  for (const ConstraintCase& from :
    { starPolygon(300), shortSegments(3000, 1000), edgesOfOthers(3000, 1000) })
  {
    const std::vector<double> sizes = sizesOf(from);
    RefineCase given(from);
    ASSERT_EQ(given.run(), Status::Ok); // makes the tables
    given.request.sizes = sizes.data();
    given.request.minimumAngle = 30.0;
    given.made = Refinement();
    MemoryListener all;
    const std::size_t before = account.held;
    account.peak = before;
    ASSERT_EQ(given.run(&all), Status::Ok);
    const std::size_t used = account.peak - before, asked = all.memory.most();
    EXPECT_LE(used, asked + 30000);
    EXPECT_GE(3 * used, asked);
    EXPECT_TRUE(all.memory.take(0));
    MemoryListener few(asked - 1);
    EXPECT_EQ(given.run(&few), Status::OutOfMemory);
    EXPECT_TRUE(given.made.points.empty());
  }
}

} // namespace
} // namespace test
} // namespace ahd
