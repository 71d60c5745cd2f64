// SPDX-License-Identifier: BSD-3-Clause
//
// Segments out of vertices with hundreds of neighbours: they are walked from their other end, and
// their outcome must not depend on it.
#include "ConstrainedRun.h"
#include "ConstraintMakers.h"
#include "Distributions.h"

#include <gtest/gtest.h>

#include <vector>

namespace ahd::test
{
namespace
{

TEST(ConstrainHubs, LoopsKeepTheirDirection)
{
  constexpr std::size_t kRing = 300;
  ConstraintCase given;
  given.points.push_back({ 0.0, 0.0 });
  const std::vector<Point> ring = makePoints(Distribution::OnCircle, kRing, 1);
  given.points.insert(given.points.end(), ring.begin(), ring.end());
  const std::vector<Point> far = { { 3, 0 }, { 2, 2 }, { 0, 3 }, { -2, 2 }, { -3, 0 }, { -2, -2 },
    { 0, -3 }, { 2, -2 } };
  given.points.insert(given.points.end(), far.begin(), far.end());
  const auto first = static_cast<std::int64_t>(given.points.size() - far.size());
  for (std::int64_t k = 0; k < 8; ++k)
  {
    ConstraintCase loop = given;
    loop.constraints.addLoop({ 0, first + k, first + (k + 2) % 8 });
    EXPECT_EQ(faultsOfConstraining(loop, FillRule::Orientation), "") << k;
    EXPECT_GT(constrain(loop, FillRule::Orientation).report.triangles, 0u) << k;
  }
}

} // namespace
} // namespace ahd::test
