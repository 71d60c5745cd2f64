// SPDX-License-Identifier: BSD-3-Clause
//
// Tuples moved from block to block, against the destination of each.
#include "BlocksRun.h"
#include "Distribute/BlockRoute.h"
#include "ThreadTransport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace ahd
{
namespace test
{
namespace
{

/// The bytes of tuple `id`, unique.
std::vector<unsigned char> tupleOf(std::int64_t id, std::size_t width)
{
  std::vector<unsigned char> bytes(width);
  for (std::size_t k = 0; k < width; ++k)
  {
    bytes[k] = static_cast<unsigned char>(
      std::size_t(id) * (2 * k + 1) + (std::size_t(id) >> 8) + k);
  }
  return bytes;
}

std::vector<unsigned char> tuplesOf(const std::vector<std::int64_t>& ids, std::size_t width)
{
  std::vector<unsigned char> all;
  for (const std::int64_t id : ids)
  {
    const std::vector<unsigned char> one = tupleOf(id, width);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

/// Each block has a range of ids; all blocks know the destination of each.
struct Plan
{
  std::vector<Point> points; ///< of all, by id
  std::vector<std::size_t> firsts;
  BlockCuts cuts;
  std::size_t blocks = 1;

  Plan(std::size_t count, std::size_t someBlocks)
    : points(makePoints(Distribution::Mixed, count, 1))
    , blocks(someBlocks)
  {
    for (std::size_t b = 0; b <= blocks; ++b)
    {
      firsts.push_back(b == 1 && blocks > 1 ? 0 : count * b / blocks); // the first block has none
    }
    std::vector<Point> samples;
    EXPECT_EQ(samplePoints(viewOf(points), 512 * blocks, samples), Status::Ok);
    EXPECT_EQ(cutIntoBlocks(samples, blocks, {}, cuts), Status::Ok);
  }
  std::vector<std::int64_t> idsOf(std::size_t block) const
  {
    std::vector<std::int64_t> ids;
    for (std::size_t i = firsts[block]; i < firsts[block + 1]; ++i)
    {
      ids.push_back(std::int64_t(i));
    }
    return ids;
  }
  PointView pointsOf(std::size_t block) const
  {
    return PointView(&points[0].x + 2 * firsts[block], firsts[block + 1] - firsts[block], 2);
  }
  std::vector<std::int64_t> ownedBy(std::size_t block) const
  {
    std::vector<std::int64_t> ids;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (cuts.ownerOf(points[i]) == block)
      {
        ids.push_back(std::int64_t(i));
      }
    }
    return ids;
  }
};

/// Moves tuples of this width, and expects those of these ids.
void expectMoved(BlockRoute& route, const std::vector<std::int64_t>& from,
  const std::vector<std::int64_t>& to, std::size_t width)
{
  const std::vector<unsigned char> own = tuplesOf(from, width);
  std::vector<unsigned char> moved(to.size() * width);
  ASSERT_EQ(route.count(), to.size());
  EXPECT_EQ(route.move(own.data(), width, moved.data()), Status::Ok);
  EXPECT_TRUE(moved == tuplesOf(to, width)) << width;
}

TEST(BlocksRoute, PointsComeToTheirOwnersInOrder)
{
  for (const std::size_t blocks : { 1, 2, 5 })
  {
    const Plan plan(3000, blocks);
    onBlocks(blocks,
      [&](std::size_t b, PairTransport& transport)
      {
        BlockRoute route(b, blocks, transport, {});
        EXPECT_EQ(route.toOwners(plan.pointsOf(b), plan.cuts), Status::Ok);
        std::vector<std::int64_t> ids = plan.idsOf(b), owned = plan.ownedBy(b);
        for (const std::size_t width : { 1, 2, 4, 7, 8, 12, 16, 24, 25 })
        {
          expectMoved(route, ids, owned, width);
        }
        std::vector<std::int64_t> values(owned.size());
        EXPECT_EQ(route.moveValues([&](Index i) { return ids[i]; }, values.data()), Status::Ok);
        EXPECT_EQ(values, owned);
        std::vector<Index> places;
        for (std::size_t k = owned.size(); k > 0; --k)
        {
          places.push_back(Index(k - 1));
        }
        route.setPlaces(std::move(places));
        std::reverse(owned.begin(), owned.end());
        expectMoved(route, ids, owned, 12);
        std::vector<std::string> texts(owned.size());
        const auto put = [&](std::size_t place, const std::string& text) { texts[place] = text; };
        EXPECT_EQ(
          route.moveItems<std::string>([&](Index i) { return std::to_string(ids[i]); }, put),
          Status::Ok);
        for (std::size_t k = 0; k < owned.size(); ++k)
        {
          EXPECT_EQ(texts[k], std::to_string(owned[k]));
        }
      });
  }
}

/// In several pieces, of which the last ones are of different sizes.
TEST(BlocksRoute, AllToOneInPieces)
{
  const Plan plan(250000, 3);
  onBlocks(3,
    [&](std::size_t b, PairTransport& transport)
    {
      BlockRoute route(b, 3, transport, {});
      const std::vector<std::int64_t> ids = plan.idsOf(b);
      EXPECT_EQ(route.toOne(ids.size(), 1), Status::Ok);
      std::vector<std::int64_t> all;
      for (std::size_t i = 0; i < plan.points.size() && b == 1; ++i)
      {
        all.push_back(std::int64_t(i));
      }
      expectMoved(route, ids, all, 24);
    });
}

TEST(BlocksRoute, WhatIsAskedForComesToItsPlace)
{
  const Plan plan(2000, 4);
  onBlocks(4,
    [&](std::size_t b, PairTransport& transport)
    {
      Random random(b);
      std::vector<BlockPoint> wanted;
      std::vector<std::int64_t> ids;
      for (std::uint64_t n = b == 2 ? 0 : 500; n > 0; --n)
      {
        const auto id = std::int64_t(random.below(plan.points.size()));
        const auto after = std::upper_bound(
          plan.firsts.begin(), plan.firsts.end(), std::size_t(id));
        wanted.push_back({ id, std::uint64_t(after - plan.firsts.begin() - 1) });
        ids.push_back(id);
      }
      const std::vector<std::int64_t> names = plan.idsOf(b);
      BlockRoute route(b, 4, transport, {});
      EXPECT_EQ(route.ask(wanted, names), Status::Ok);
      expectMoved(route, names, ids, 12);
      expectMoved(route, names, ids, 1);
    });
}

TEST(BlocksRoute, OneThatIsToldToCancelEndsAll)
{
  const Plan plan(40000, 3);
  const auto work = [&](std::size_t b, PairTransport& transport, const Context& context)
  {
    BlockRoute route(b, 3, transport, context);
    const std::vector<unsigned char> own = tuplesOf(plan.idsOf(b), 8);
    const Status status = route.toOwners(plan.pointsOf(b), plan.cuts);
    std::vector<unsigned char> moved(8 * route.count());
    return status == Status::Ok ? route.move(own.data(), 8, moved.data()) : status;
  };
  expectThatOneEndsAll(2, 5, [&] { return work; });
}

} // namespace
} // namespace test
} // namespace ahd
