// SPDX-License-Identifier: BSD-3-Clause
//
// A job with an existing surface, where memory runs out; memory taken and estimated. This program's
// operator new counts, and fails on demand.
#include "ConstraintMakers.h"
#include "FailingJob.h"

#include <gtest/gtest.h>

#include <vector>

namespace ahd
{
namespace test
{
namespace
{

/// Triangles made by constraints, with the edges of one named: not enough to restore all of them.
struct Surface
{
  explicit Surface(std::size_t count)
    : given(randomSegments(count, 20))
  {
    JobRun run;
    run.setPoints(given.view());
    run.setConstraints(given.constraints.view());
    EXPECT_EQ(run.run(), AHD_OK) << ahd_message(run.job());
    corners = run.ids("triangles");
    edges.assign(corners.size() / 3, 0);
    edges[edges.size() / 2] = 7;
  }

  void giveTo(JobRun& run) const
  {
    const auto rows = std::int64_t(edges.size());
    const ahd_array triangles = { corners.data(), AHD_INT64, 3, rows, 24, 8 };
    const ahd_array marks = { edges.data(), AHD_UINT8, 1, rows, 1, 1 };
    run.setPoints(given.view());
    ahd_set_array(run.job(), "surface", &triangles);
    ahd_set_array(run.job(), "surface_edges", &marks);
    run.set("threads", std::int64_t(1));
  }

  ConstraintCase given;
  std::vector<std::int64_t> corners;
  std::vector<std::uint8_t> edges;
};

TEST(JobSurface, AnyAllocationCanFail)
{
  const Surface surface(60);
  JobRun run;
  surface.giveTo(run);
  ASSERT_NO_FATAL_FAILURE(
    expectAnyAllocationCanFail(run, [](JobRun& made) { return made.ids("triangles"); }));
  EXPECT_EQ(run.ids("triangles"), surface.corners);
}

/// Tables are made to find the triangles, and stay. So many points that the megabyte of each
/// estimate is a small part.
TEST(JobSurface, ItTakesNoMoreMemoryThanEstimated)
{
  const Surface surface(60000);
  for (const bool wantsAll : { false, true })
  {
    SCOPED_TRACE(wantsAll);
    JobRun run;
    surface.giveTo(run);
    for (const char* name : { "want_constraint_edges", "want_regions", "want_neighbors" })
    {
      run.set(name, std::int64_t(wantsAll));
    }
    const std::size_t before = account.held;
    account.peak = before;
    ASSERT_EQ(run.run(), AHD_OK) << ahd_message(run.job());
    const std::vector<std::int32_t> triangles = run.shortIds("triangles");
    EXPECT_EQ(triangles.size(), surface.corners.size());
    EXPECT_TRUE(!wantsAll || run.ids("neighbors").size() == surface.corners.size());
    const std::size_t taken = account.peak - before;
    const auto estimate = std::size_t(run.count("memory_estimate"));
    EXPECT_LE(taken, estimate);
    EXPECT_LE(estimate, 2 * taken);
  }
}

} // namespace
} // namespace test
} // namespace ahd
