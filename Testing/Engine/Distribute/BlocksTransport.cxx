// SPDX-License-Identifier: BSD-3-Clause
//
// distribute() over a transport, a thread for each block: what one block cannot do ends all of them
// with the same status, and none waits for ever.
#include "BlocksRun.h"
#include "Listeners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace ahd
{
namespace test
{
namespace
{

/// Where all blocks meet.
class Hall
{
public:
  explicit Hall(std::size_t blocks)
    : statuses(blocks)
    , bytes(blocks)
    , messages(blocks)
  {
  }

  /// Waits for all; they meet twice for each step, so that none writes while another one reads.
  void meet()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const std::size_t round = round_;
    if (++waiting_ == statuses.size())
    {
      waiting_ = 0;
      ++round_;
      all_.notify_all();
      return;
    }
    all_.wait(lock, [&] { return round_ != round; });
  }

  std::vector<Status> statuses;
  std::vector<BlockBytes> bytes;
  std::vector<std::vector<BlockMessage>> messages;

private:
  std::mutex mutex_;
  std::condition_variable all_;
  std::size_t waiting_ = 0, round_ = 0;
};

class ThreadTransport : public BlockTransport
{
public:
  ThreadTransport(Hall& hall, std::size_t own)
    : hall_(hall)
    , own_(own)
  {
  }
  Status agree(Status own) override
  {
    hall_.statuses[own_] = own;
    hall_.meet();
    const Status worst = *std::max_element(hall_.statuses.begin(), hall_.statuses.end());
    hall_.meet();
    return worst;
  }
  Status gather(const BlockBytes& own, std::vector<BlockBytes>& all) override
  {
    hall_.bytes[own_] = own;
    hall_.meet();
    all = hall_.bytes;
    hall_.meet();
    return Status::Ok;
  }
  Status exchange(std::vector<BlockMessage>& out, std::vector<BlockMessage>& in) override
  {
    hall_.messages[own_] = std::move(out);
    hall_.meet();
    for (std::size_t from = 0; from < hall_.messages.size(); ++from)
    {
      for (const BlockMessage& message : hall_.messages[from])
      {
        if (message.block == own_)
        {
          in.push_back({ from, message.bytes });
        }
      }
    }
    hall_.meet();
    return Status::Ok;
  }

private:
  Hall& hall_;
  std::size_t own_;
};

struct Ended
{
  std::vector<Status> statuses;
  std::size_t triangles = 0;   ///< of all blocks
  std::size_t reported = 0;    ///< by the last block
  std::size_t mostAskings = 0; ///< of block 1
};

/// Each thread takes every third point, in order of x; block 1 is told to cancel.
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
  Hall hall(kBlocks);
  Ended ended;
  ended.statuses.resize(kBlocks);
  std::vector<std::size_t> triangles(kBlocks);
  std::vector<std::thread> threads;
  Listener listener(cancelAt);
  for (std::size_t b = 0; b < kBlocks; ++b)
  {
    threads.emplace_back(
      [&, b]
      {
        const std::size_t begin = points.size() * b / kBlocks;
        const std::size_t end = points.size() * (b + 1) / kBlocks;
        BlockInput input;
        input.block = b;
        input.blocks = kBlocks;
        input.points = PointView(&points[begin].x, end - begin, 2);
        input.ids = ids.data() + begin;
        input.blocksPerNode = 2;
        ThreadTransport transport(hall, b);
        BlockTriangulation made;
        Context context;
        context.progress = b == 1 ? &listener : nullptr;
        ended.statuses[b] = distribute(input, transport, context, made);
        if (ended.statuses[b] == Status::Ok)
        {
          triangles[b] = made.triangles();
          if (b == kBlocks - 1)
          {
            ended.reported = made.report().triangles;
          }
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
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
