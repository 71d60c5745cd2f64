// SPDX-License-Identifier: BSD-3-Clause
//
// Crossings between segments that end where several points lie: their heights follow the points
// that stand for the vertices.
#include "PrepareCase.h"

#include "Listeners.h"
#include "Triangulate.h"

#include <gtest/gtest.h>

#include <limits>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Two lines that cross in the middle, 1 high where they begin and 3 where they end; at the end of
/// the first the input has points of other heights.
struct Cross : PrepareCase
{
  Cross()
    : PrepareCase({ { { 4, 4, 7 } }, { { 9, 0, 0 } }, { { 4, 4, kNaN } }, { { 4, 4, -5 } } },
        { { { 0, 0, 1 } }, { { 4, 4, 3 } }, { { 0, 4, 1 } }, { { 4, 0, 3 } } },
        { { 0, 1 }, { 2, 3 } })
  {
    request.split = true;
  }
};

void expectHeight(Representative representative, Index end, double height)
{
  const Cross given;
  PreparedInput input;
  ASSERT_EQ(prepare(given.request, Context(), input), Status::Ok);
  ASSERT_EQ(input.crossings().size(), 1u);
  EXPECT_EQ(input.place(input.firstCrossing())[2], 2.0);
  EXPECT_EQ(input.crossings()[0].ends[1], 5u);
  Options options;
  options.representative = representative;
  Workspace workspace;
  Triangulation triangulation;
  ASSERT_EQ(triangulate(input.points(), options, workspace, Context(), triangulation), Status::Ok);
  Listener refusal(1);
  EXPECT_EQ(
    input.endCrossingsAtVertices(triangulation, Context{ &refusal, nullptr }), Status::Cancelled);
  ASSERT_EQ(input.endCrossingsAtVertices(triangulation, Context()), Status::Ok);
  EXPECT_EQ(input.crossings()[0].ends, (std::array<Index, 4>{ { 4, end, 6, 7 } }));
  EXPECT_EQ(input.place(input.firstCrossing()), (Xyz{ { 2, 2, height } }));
}

TEST(CrossingHeights, FollowTheRepresentatives)
{
  expectHeight(Representative::FirstId, 0, 0.5 * (0.5 * 1 + 0.5 * 7) + 0.5 * 2);
  expectHeight(Representative::LowestZ, 3, 0.5 * (0.5 * 1 - 0.5 * 5) + 0.5 * 2);
  expectHeight(Representative::HighestZ, 0, 0.5 * (0.5 * 1 + 0.5 * 7) + 0.5 * 2);
}

TEST(CrossingHeights, StayWhereThereIsNoVertex)
{
  const Cross given;
  PreparedInput input;
  ASSERT_EQ(prepare(given.request, Context(), input), Status::Ok);
  Options options;
  options.insertionLimit = 1;
  options.order = InsertionOrder::AsGiven;
  Workspace workspace;
  Triangulation triangulation;
  ASSERT_EQ(triangulate(input.points(), options, workspace, Context(), triangulation), Status::Ok);
  ASSERT_EQ(input.endCrossingsAtVertices(triangulation, Context()), Status::Ok);
  // of the ends only that at (4, 4) is a vertex
  EXPECT_EQ(input.crossings()[0].ends, (std::array<Index, 4>{ { 4, 0, 6, 7 } }));
}

TEST(CrossingHeights, WithoutCrossingsNothingIsMade)
{
  Cross given;
  given.request.split = false;
  PreparedInput input;
  ASSERT_EQ(prepare(given.request, Context(), input), Status::Ok);
  Triangulation triangulation;
  Listener refusal(1);
  EXPECT_EQ(input.endCrossingsAtVertices(triangulation, Context{ &refusal, nullptr }), Status::Ok);
  EXPECT_EQ(refusal.askings(), 0u);
}

} // namespace
} // namespace test
} // namespace ahd
