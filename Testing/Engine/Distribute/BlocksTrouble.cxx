// SPDX-License-Identifier: BSD-3-Clause
//
// Blocks whose memory runs out at any allocation, or that are cancelled at any poll: the status
// reports it, nothing is thrown or leaked. And they take no more than was estimated. This program's
// operator new fails on demand.
#include "BlocksRun.h"
#include "ConstraintMakers.h"
#include "Distribute/BlockRim.h"
#include "Listeners.h"
#include "OwnMemory.h"
#include "ThreadTransport.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ahd
{
namespace test
{
namespace
{

constexpr std::size_t kBlocks = 5;

/// All blocks step by step. The messages are the caller's: their memory neither fails nor counts.
class CarefulRun
{
public:
  CarefulRun(const ConstraintCase& given, Progress* progress)
    : given_(given)
    , constraints_(given.constraints.view())
  {
    context_.progress = progress;
    std::vector<std::size_t> order(given.points.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      order[i] = i;
    }
    std::vector<Point> sorted = given.points;
    std::sort(sorted.begin(), sorted.end(), lexicographicallyLess);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const Point& p = given.points[i];
      std::size_t b = 0;
      while (b + 1 < kBlocks && !(p.x < sorted[sorted.size() * (b + 1) / kBlocks].x))
      {
        ++b;
      }
      points_[b].push_back(p);
      ids_[b].push_back(std::int64_t(i));
    }
  }

  Status run()
  {
    using Waiting = BlockTriangulation::Waiting;
    Status status = each([&](std::size_t b) { return begin(b); });
    while (status == Status::Ok && blocks_[0].waiting() != Waiting::ForNothing)
    {
      status = blocks_[0].waiting() == Waiting::ForAll ? stepAll() : stepSome();
    }
    for (std::size_t b = 0; status == Status::Ok && b < kBlocks; ++b)
    {
      writeTo_[b] = triples_.size();
      triples_.resize(triples_.size() + 3 * blocks_[b].triangles());
    }
    return status == Status::Ok ? each([&](std::size_t b) { return write(b); }) : status;
  }

  const std::vector<std::int64_t>& triples() const { return triples_; }
  /// The excess of a step's peak over its estimate, or 0.
  std::size_t excess() const { return excess_; }
  /// Most bytes that a block held at once, for each of its points.
  double mostPerPoint() const { return mostPerPoint_; }

private:
  template <typename Step>
  Status each(Step step)
  {
    for (std::size_t b = 0; b < kBlocks; ++b)
    {
      account.countsNothing = false;
      account.peak = account.held.load();
      const std::size_t before = account.held;
      const Status status = step(b);
      account.countsNothing = true;
      held_[b] += account.held - before;
      const std::size_t most = held_[b] + (account.peak - account.held);
      mostPerPoint_ = std::max(mostPerPoint_, double(most) / double(ids_[b].size() + 1));
      excess_ = std::max(excess_, most > estimate_[b] ? most - estimate_[b] : 0);
      if (status != Status::Ok)
      {
        return status;
      }
    }
    return Status::Ok;
  }

  Status begin(std::size_t b)
  {
    BlockInput input;
    input.block = b;
    input.blocks = kBlocks;
    input.points = PointView(points_[b].empty() ? nullptr : &points_[b][0].x, points_[b].size(), 2);
    input.ids = ids_[b].data();
    input.constraints = constraints_;
    input.blocksPerNode = 2;
    const std::size_t ids = constraints_.chains == 0
      ? 0
      : std::size_t(constraints_.offsets[constraints_.chains]);
    estimate_[b] = blockMemoryEstimate(points_[b].size(), ids, input.options);
    return blocks_[b].begin(input, context_);
  }

  Status stepAll()
  {
    std::vector<BlockBytes> all;
    for (const BlockTriangulation& block : blocks_)
    {
      all.push_back(block.toAll());
    }
    return each([&](std::size_t b) { return blocks_[b].takeAll(all, context_); });
  }

  Status stepSome()
  {
    addEstimates();
    std::array<std::vector<BlockMessage>, kBlocks> out, in;
    Status status = each([&](std::size_t b) { return blocks_[b].giveSome(out[b], context_); });
    for (std::size_t b = 0; b < kBlocks; ++b)
    {
      for (BlockMessage& message : out[b])
      {
        held_[b] -= message.bytes.capacity();
        in[message.block].push_back({ b, std::move(message.bytes) });
      }
      held_[b] -= out[b].capacity() * sizeof(BlockMessage);
    }
    return status != Status::Ok
      ? status
      : each([&](std::size_t b) { return blocks_[b].takeSome(in[b], context_); });
  }

  void addEstimates()
  {
    std::array<std::size_t, kBlocks> points = {}, edges = {};
    for (const BorderCount& count : blocks_[0].borders())
    {
      for (const std::size_t b : { count.host, count.to })
      {
        points[b] += count.points;
        edges[b] += count.edges;
      }
    }
    const std::size_t ids = constraints_.chains == 0
      ? 0
      : std::size_t(constraints_.offsets[constraints_.chains]);
    for (std::size_t b = 0; b < kBlocks; ++b)
    {
      estimate_[b] += points[b] == 0 ? 0 : borderMemoryEstimate(points[b], edges[b], ids);
    }
  }

  Status write(std::size_t b)
  {
    return blocks_[b].writeTriangles(triples_.data() + writeTo_[b], context_);
  }

  const ConstraintCase& given_;
  ConstraintView constraints_;
  Context context_;
  std::array<std::vector<Point>, kBlocks> points_;
  std::array<std::vector<std::int64_t>, kBlocks> ids_;
  std::array<BlockTriangulation, kBlocks> blocks_;
  std::array<std::size_t, kBlocks> held_ = {}, estimate_ = {};
  std::array<std::size_t, kBlocks> writeTo_ = {};
  std::size_t excess_ = 0;
  double mostPerPoint_ = 0.0;
  std::vector<std::int64_t> triples_;
};

std::vector<ConstraintCase> cases()
{
  ConstraintCase plain;
  plain.points = makePoints(Distribution::RepeatedDraws, 200, 1);
  ConstraintCase collinear;
  collinear.points = makePoints(Distribution::Collinear, 50, 1);
  return { plain, collinear, nestedLoops(4), chainsThrough(Distribution::RepeatedDraws, 200, 6, 1),
    randomSegments(150, 40) };
}

TEST(BlocksTrouble, AnyAllocationCanFail)
{
  account.countsNothing = true;
  for (const ConstraintCase& given : cases())
  {
    const std::size_t before = account.blocks;
    {
      account.allocations = 0;
      CarefulRun expected(given, nullptr);
      ASSERT_EQ(expected.run(), Status::Ok);
      const std::size_t all = account.allocations;
      ASSERT_GT(all, 50u);
      const std::size_t step = 1 + all / reduced(2000);
      for (std::size_t k = 1; k <= all; k += step)
      {
        CarefulRun run(given, nullptr);
        account.allocations = 0;
        account.failsOnce = k % 2 == 0;
        account.failAt = k;
        const Status status = run.run();
        account.failAt = 0;
        ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << k << " of " << all;
      }
      CarefulRun again(given, nullptr);
      ASSERT_EQ(again.run(), Status::Ok);
      ASSERT_EQ(again.triples(), expected.triples());
    }
    EXPECT_EQ(account.blocks, before) << "something leaked";
  }
  account.countsNothing = false;
}

TEST(BlocksTrouble, AnyAskingCanCancel)
{
  for (const ConstraintCase& given : cases())
  {
    Listener listener;
    CarefulRun expected(given, &listener);
    ASSERT_EQ(expected.run(), Status::Ok);
    ASSERT_GT(listener.askings(), 50u);
    for (std::size_t at = 1; at <= listener.askings(); ++at)
    {
      Listener cancelling(at);
      CarefulRun run(given, &cancelling);
      ASSERT_EQ(run.run(), Status::Cancelled) << at;
    }
  }
}

TEST(BlocksTrouble, NoMoreMemoryThanEstimated)
{
  std::vector<ConstraintCase> all = cases();
  for (const Distribution d : { Distribution::Uniform, Distribution::OnCircle,
         Distribution::OnParabola, Distribution::Slivers, Distribution::RepeatedDraws })
  {
    ConstraintCase given;
    given.points = makePoints(d, reduced(30000), 1);
    all.push_back(given);
  }
  all.push_back(shortSegments(20000, 5000));
  all.push_back(nestedLoops(60));
  for (const ConstraintCase& given : all)
  {
    CarefulRun run(given, nullptr);
    ASSERT_EQ(run.run(), Status::Ok);
    EXPECT_EQ(run.excess(), 0u) << given.points.size() << " points";
  }
}

TEST(BlocksTrouble, TwoHundredBytesForEachOwnPoint)
{
  ConstraintCase given;
  given.points = makePoints(Distribution::Uniform, reduced(200000), 1);
  CarefulRun run(given, nullptr);
  ASSERT_EQ(run.run(), Status::Ok);
  EXPECT_LE(run.mostPerPoint(), 200.0);
  RecordProperty("bytes_per_point", std::to_string(run.mostPerPoint()));
}

/// In a band as narrow as this, nearly all triangles are flat: two for each point.
TEST(BlocksTrouble, TrimmingTakesNoMoreThanEstimated)
{
  const std::size_t count = reduced(20000);
  std::vector<Point> points = makePoints(Distribution::Uniform, count, 1);
  std::vector<std::int64_t> ids(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    points[i].y *= 1e-9;
    ids[i] = std::int64_t(i);
  }
  onBlocks(1,
    [&](std::size_t, BlockTransport& transport)
    {
      BlockInput input;
      input.points = viewOf(points);
      input.ids = ids.data();
      BlockTriangulation made;
      ASSERT_EQ(distribute(input, transport, {}, made), Status::Ok);
      std::vector<std::int32_t> corners(3 * made.triangles());
      ASSERT_EQ(made.writeTriangles(corners.data(), {}), Status::Ok);
      BlockStars stars;
      stars.ids = ids.data();
      stars.points = count;
      stars.foreign = &made.foreignPoints();
      stars.own = { corners.data(), nullptr, made.triangles(), made.triangles() };
      ASSERT_GT(stars.own.count, count + count / 2);
      BlockRim rim;
      account.peak = account.held.load();
      const std::size_t before = account.held;
      ASSERT_EQ(trimBlocks(points, transport, {}, stars, rim), Status::Ok);
      EXPECT_LE(account.peak - before, kRimBytesPerPoint * count);
      EXPECT_GT(2 * rim.triangles, stars.own.count);
    });
}

} // namespace
} // namespace test
} // namespace ahd
