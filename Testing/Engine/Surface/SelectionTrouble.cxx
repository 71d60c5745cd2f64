// SPDX-License-Identifier: BSD-3-Clause
//
// selectBySize() where it is cancelled, has no memory, or several threads. This program's operator
// new counts, and fails on demand.
#include "SelectionCase.h"

#include "Executors.h"
#include "Listeners.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

bool areSame(const Selection& a, const Selection& b)
{
  return a.kept == b.kept && a.keptCount == b.keptCount && a.lines == b.lines &&
    a.vertices == b.vertices;
}

TEST(SelectionTrouble, ThreadsHaveNoSay)
{
  const Surface surface = makeSurface(140000, 10); // enough triangles to be shared
  ThreadExecutor threads(3);
  SizeLimits limits;
  limits.alpha = 0.02;
  limits.maximumEdgeLength = 0.004;
  Triangulation triangulation;
  surface.triangulateInto(triangulation);
  Listener listener;
  Selection alone, together;
  ASSERT_EQ(selectBySize(triangulation, limits, surface.measured(), Context(), alone), Status::Ok);
  ASSERT_EQ(selectBySize(
              triangulation, limits, surface.measured(), Context{ &listener, &threads }, together),
    Status::Ok);
  EXPECT_TRUE(areSame(alone, together));
  EXPECT_GT(alone.keptCount, 1000u);
  EXPECT_GT(alone.lines.size(), 1000u);
  EXPECT_GT(alone.vertices.size(), 100u);
}

/// Selects from a new triangulation.
Status selectAnew(
  const Surface& surface, const SizeLimits& limits, const Context& context, Selection& out)
{
  Triangulation triangulation;
  surface.triangulateInto(triangulation);
  account.allocations = 0;
  const Status status = selectBySize(triangulation, limits, surface.measured(), context, out);
  account.failAt = 0;
  return status;
}

TEST(SelectionTrouble, AnyAskingCanCancelAlsoWithThreads)
{
  ThreadExecutor threads(3);
  for (const unsigned seed : { 4u, 35u })
  {
    Surface surface = makeSurface(20000, seed);
    for (std::size_t i = 0; seed == 4 && i < surface.points.size(); ++i)
    {
      surface.points[i][1] = 0.0; // collinear
      surface.merged = MergedPoints();
    }
    SizeLimits limits;
    limits.alpha = 0.004;
    Listener all;
    Selection selection;
    ASSERT_EQ(selectAnew(surface, limits, Context{ &all, nullptr }, selection), Status::Ok);
    for (std::size_t k = 1; k <= all.askings(); ++k)
    {
      Listener listener(k);
      ASSERT_EQ(
        selectAnew(surface, limits, Context{ &listener, nullptr }, selection), Status::Cancelled)
        << "asking " << k;
      EXPECT_EQ(listener.askings(), k) << "nobody is asked again";
    }
    Listener early(2);
    EXPECT_EQ(
      selectAnew(surface, limits, Context{ &early, &threads }, selection), Status::Cancelled);
  }
}

TEST(SelectionTrouble, AnyAllocationCanFail)
{
  const Surface surface = makeSurface(500, 35);
  SizeLimits limits;
  limits.alpha = 0.02;
  Selection expected;
  ASSERT_EQ(selectAnew(surface, limits, Context(), expected), Status::Ok);
  const std::size_t before = account.held;
  std::size_t failed = 0;
  for (;; ++failed)
  {
    Selection selection;
    Triangulation triangulation;
    surface.triangulateInto(triangulation);
    account.allocations = 0;
    account.failAt = failed + 1;
    const Status status = selectBySize(
      triangulation, limits, surface.measured(), Context(), selection);
    account.failAt = 0;
    if (status == Status::Ok)
    {
      break;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << failed + 1;
    ASSERT_EQ(
      selectBySize(triangulation, limits, surface.measured(), Context(), selection), Status::Ok);
    EXPECT_TRUE(areSame(selection, expected)) << "after allocation " << failed + 1;
  }
  EXPECT_GT(failed, 5u);
  EXPECT_EQ(account.held, before) << "something leaked";
}

TEST(SelectionTrouble, TakesNoMoreMemoryThanEstimated)
{
  const Surface surface = makeSurface(100000, 2);
  Triangulation triangulation;
  surface.triangulateInto(triangulation);
  ASSERT_EQ(triangulation.makeNeighbors(Context()), Status::Ok);
  ASSERT_EQ(triangulation.makePointMap(Context()), Status::Ok);
  SizeLimits limits;
  for (const double factor : { 0.3, 0.6, 0.8, 1.0, 3.0 })
  {
    limits.alpha = factor * std::sqrt(1.0 / 100000);
    const std::size_t before = account.held;
    account.peak = before;
    Selection selection;
    ASSERT_EQ(
      selectBySize(triangulation, limits, surface.measured(), Context(), selection), Status::Ok);
    EXPECT_LE(account.peak - before, selectionMemoryEstimate(100000));
  }
}

} // namespace
} // namespace test
} // namespace ahd
