// SPDX-License-Identifier: BSD-3-Clause
//
// outline() where it is cancelled or has no memory. This program's operator new counts, and fails
// on demand.
#include "OutlineCase.h"

#include "Listeners.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

OutlineCase manyRings(std::size_t side)
{
  Random random(7);
  OutlineCase given = gridOf(side, side, random);
  given.dropSome(2, random);
  given.groupThem(2, random);
  return given;
}

bool areSame(const Outline& a, const Outline& b)
{
  return a.corners == b.corners && a.rings == b.rings && a.polygons == b.polygons &&
    a.cells == b.cells;
}

TEST(OutlineTrouble, AnyAskingCanCancel)
{
  const OutlineCase given = manyRings(120);
  for (const bool isDirected : { false, true })
  {
    OutlineRequest request = given.request();
    request.isDirected = isDirected;
    Listener all;
    Outline made;
    ASSERT_EQ(outline(request, Context{ &all, nullptr }, made), Status::Ok);
    EXPECT_GT(all.askings(), 20u);
    for (std::size_t k = 1; k <= all.askings(); ++k)
    {
      Listener listener(k);
      ASSERT_EQ(outline(request, Context{ &listener, nullptr }, made), Status::Cancelled);
      EXPECT_EQ(listener.askings(), k) << "nobody is asked again";
    }
  }
}

TEST(OutlineTrouble, AnyAllocationCanFail)
{
  const OutlineCase given = manyRings(90);
  const Outline expected = given.outline();
  for (std::size_t failed = 0;; ++failed)
  {
    const std::size_t before = account.held;
    Status status = Status::Ok;
    {
      Outline made;
      account.allocations = 0;
      account.failAt = failed + 1;
      status = outline(given.request(), Context(), made);
      account.failAt = 0;
      EXPECT_TRUE(status != Status::Ok || areSame(made, expected));
    }
    EXPECT_EQ(account.held, before) << "something leaked";
    if (status == Status::Ok)
    {
      EXPECT_GT(failed, 10u);
      break;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << failed + 1;
  }
}

/// Sums what is requested beyond the estimate.
struct Requests : Progress
{
  bool advance(Phase, double) override { return true; }
  bool take(std::size_t bytes) override
  {
    most += bytes;
    return !refuses;
  }
  std::size_t most = 0;
  bool refuses = false;
};

TEST(OutlineTrouble, MemoryIsEstimatedAndRequested)
{
  Random random(9);
  OutlineCase apart = gridOf(60, 60, random);
  apart.groupThem(999, random);
  OutlineCase points = gridOf(1, 1, random);
  points.points.resize(40000);
  for (const OutlineCase& given : { manyRings(150), gridOf(150, 150, random), apart, points })
  {
    Requests requests;
    Outline made;
    const std::size_t before = account.held;
    account.peak = before;
    ASSERT_EQ(outline(given.request(), Context{ &requests, nullptr }, made), Status::Ok);
    const std::size_t used = account.peak - before;
    const std::size_t allowed = outlineMemoryEstimate(given.request()) + requests.most;
    EXPECT_LE(used, allowed + 10000);
    EXPECT_GE(2 * used, allowed);
    requests.refuses = true;
    EXPECT_EQ(outline(given.request(), Context{ &requests, nullptr }, made), Status::OutOfMemory);
  }
}

TEST(OutlineTrouble, TooManyAreRefusedAtOnce)
{
  OutlineRequest request;
  request.points.count = std::size_t(1) << 33;
  Outline made;
  EXPECT_EQ(outline(request, Context(), made), Status::TooManyPoints);
}

} // namespace
} // namespace test
} // namespace ahd
