// SPDX-License-Identifier: BSD-3-Clause
//
// distribute() over a transport, a thread for each block: a failure of one block ends all of them
// with the same status, and none waits for ever.
#include "BlocksRun.h"
#include "Listeners.h"
#include "ThreadTransport.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ahd
{
namespace test
{
namespace
{

struct Ended
{
  std::vector<Status> statuses;
  std::size_t triangles = 0;   ///< of all blocks
  std::size_t reported = 0;    ///< by the last block
  std::size_t mostAskings = 0; ///< of block 1
};

/// Each thread takes every third point, in order of x; block 1 is cancelled.
Ended run(std::size_t cancelAt)
{
  constexpr std::size_t kBlocks = 5;
  std::vector<Point> points = makePoints(Distribution::Uniform, 3000, 1);
  std::sort(points.begin(), points.end(), lexicographicallyLess);
  std::vector<std::int64_t> ids(points.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = std::int64_t(i);
  }
  Ended ended;
  ended.statuses.resize(kBlocks);
  std::vector<std::size_t> triangles(kBlocks);
  Listener listener(cancelAt);
  onBlocks(kBlocks,
    [&](std::size_t b, BlockTransport& transport)
    {
      const std::size_t begin = points.size() * b / kBlocks;
      const std::size_t end = points.size() * (b + 1) / kBlocks;
      BlockInput input;
      input.block = b;
      input.blocks = kBlocks;
      input.points = PointView(&points[begin].x, end - begin, 2);
      input.ids = ids.data() + begin;
      input.blocksPerNode = 2;
      BlockTriangulation made;
      Context context;
      context.progress = b == 1 ? &listener : nullptr;
      ended.statuses[b] = distribute(input, transport, context, made);
      if (ended.statuses[b] == Status::Ok)
      {
        triangles[b] = made.triangles();
        if (b == kBlocks - 1)
        {
          ended.reported = made.report().counts.triangles;
        }
      }
    });
  for (const std::size_t count : triangles)
  {
    ended.triangles += count;
  }
  ended.mostAskings = listener.askings();
  return ended;
}

TEST(BlocksTransport, ThreadsMakeOneTriangulation)
{
  const Ended ended = run(0);
  EXPECT_EQ(ended.statuses, std::vector<Status>(5, Status::Ok));
  const std::vector<Point> points = makePoints(Distribution::Uniform, 3000, 1);
  EXPECT_EQ(ended.triangles, triangulate(points).report.triangles);
  EXPECT_EQ(ended.reported, ended.triangles);
}

TEST(BlocksTransport, OneThreadThatIsToldToCancelEndsAll)
{
  const std::size_t askings = run(0).mostAskings;
  ASSERT_GE(askings, 10u);
  for (std::size_t at = 1; at <= askings; ++at)
  {
    EXPECT_EQ(run(at).statuses, std::vector<Status>(5, Status::Cancelled)) << at;
  }
}

} // namespace
} // namespace test
} // namespace ahd
