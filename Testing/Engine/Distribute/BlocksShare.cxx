// SPDX-License-Identifier: BSD-3-Clause
//
// Messages between blocks: they are read as written; and joined constraints are those of the
// appended input.
#include "ConstraintSets.h"
#include "Distribute/BlockChains.h"
#include "Distribute/Share.h"
#include "Distributions.h"
#include "EngineRun.h"
#include "ThreadTransport.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <tuple>

namespace ahd
{
namespace test
{
namespace
{

struct Inner
{
  std::string name;
  std::vector<std::string> names;

  auto fields() { return std::tie(name, names); }
};

struct Outer
{
  bool isOne = false;
  double number = 0.0;
  std::vector<std::array<int, 2>> pairs;
  std::vector<Inner> inner;

  auto fields() { return std::tie(isOne, number, pairs, inner); }
};

struct Padded
{
  std::int64_t number;
  bool isOne;

  auto fields() { return std::tie(number, isOne); }
};

struct Full
{
  Point at;
  std::int64_t id;

  auto fields() { return std::tie(at, id); }
};

struct Half ///< which lists only a part
{
  double sent, own;

  auto fields() { return std::tie(sent); }
};
static_assert(
  IsSolid<Full>::value && IsSolid<std::array<Full, 2>>::value && IsSolid<Bounds>::value, "");
static_assert(!IsSolid<Padded>::value && !IsSolid<Half>::value && !IsSolid<Outer>::value, "");
static_assert(IsSolid<Report>::value, "Report::fields() lists all of it");

Outer made(int k)
{
  Outer outer;
  outer.isOne = k == 1;
  outer.number = 0.1 * k;
  for (int i = 0; i < k; ++i)
  {
    outer.pairs.push_back({ { i, k } });
    outer.inner.push_back({ std::string(std::size_t(i), 'x'), { "", "y", std::to_string(k) } });
  }
  return outer;
}

BlockBytes bytesOf(const Outer& outer)
{
  BlockBytes bytes;
  BytesWriter{ bytes }(outer);
  return bytes;
}

TEST(BlocksShare, WhatIsWrittenIsRead)
{
  for (int k = 0; k < 4; ++k)
  {
    const BlockBytes bytes = bytesOf(made(k));
    Outer read;
    BytesReader{ bytes }(read);
    EXPECT_EQ(bytesOf(read), bytes) << k;
    EXPECT_EQ(read.isOne, k == 1);
    EXPECT_EQ(read.number, 0.1 * k);
    EXPECT_EQ(read.inner.size(), std::size_t(k));
  }
}

/// The padding between its numbers is not sent: it is uninitialised.
TEST(BlocksShare, PaddingIsNotSent)
{
  BlockBytes sent;
  BytesWriter{ sent }(std::vector<Padded>(3, { 7, true }));
  EXPECT_EQ(sent.size(), sizeof(std::uint64_t) + 3 * (sizeof(std::int64_t) + sizeof(bool)));
  std::vector<Padded> read;
  BytesReader{ sent }(read);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_TRUE(read[2].number == 7 && read[2].isOne);
  BlockBytes full;
  BytesWriter{ full }(std::vector<Full>(3, { { 1.0, 2.0 }, 3 }));
  EXPECT_EQ(full.size(), sizeof(std::uint64_t) + 3 * sizeof(Full));
}

TEST(BlocksShare, WhatIsNotThereIsLeftOut)
{
  const BlockBytes bytes = bytesOf(made(3));
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    const BlockBytes cut(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
    Outer read;
    BytesReader{ cut }(read);
    EXPECT_LE(read.inner.size(), 3u);
    EXPECT_LE(read.pairs.size(), 3u);
  }
}

TEST(BlocksShare, EachHearsAll)
{
  onBlocks(4,
    [](std::size_t b, PairTransport& transport)
    {
      std::vector<Outer> all;
      const auto make = [b](Outer& own)
      {
        own = made(int(b));
        return Status::Ok;
      };
      EXPECT_EQ(share(transport, make, all), Status::Ok);
      std::vector<std::vector<int>> from;
      const auto makeLists = [b](std::vector<std::vector<int>>& to)
      {
        to.resize(4);
        to[(b + 1) % 4] = { int(b), 7 };
        return Status::Ok;
      };
      EXPECT_EQ(exchange(transport, makeLists, from), Status::Ok);
      for (std::size_t k = 0; k < 4; ++k)
      {
        EXPECT_EQ(bytesOf(all.at(k)), bytesOf(made(int(k))));
        const bool isNext = (k + 1) % 4 == b;
        EXPECT_EQ(from.at(k), isNext ? std::vector<int>({ int(k), 7 }) : std::vector<int>());
      }
    });
}

TEST(BlocksShare, OneThatCannotGoOnEndsAll)
{
  for (const Status why : { Status::Cancelled, Status::OutOfMemory })
  {
    onBlocks(3,
      [why](std::size_t b, PairTransport& transport)
      {
        std::vector<int> all;
        const auto make = [&](int& own)
        {
          own = int(b);
          if (b == 2 && why == Status::OutOfMemory)
          {
            throw std::bad_alloc();
          }
          return b == 2 ? why : Status::Ok;
        };
        EXPECT_EQ(share(transport, make, all), why);
        std::vector<std::vector<int>> from;
        EXPECT_EQ(exchange(
                    transport, [&](auto& to) { return make(to.emplace_back(3).front()); }, from),
          why);
      });
  }
}

// ----------------------------------------------------------------------------------------- chains

/// One source's cells.
struct Cells
{
  std::vector<std::int64_t> ids, offsets{ 0 };

  void add(const Chain& chain, std::int64_t shift = 0)
  {
    for (const std::int64_t id : chain)
    {
      ids.push_back(id < 0 ? id : id + shift);
    }
    offsets.push_back(std::int64_t(ids.size()));
  }
  CellsView view() const
  {
    CellsView result;
    result.ids64 = ids.data();
    result.offsets64 = offsets.data();
    result.cells = offsets.size() - 1;
    result.ids = ids.size();
    return result;
  }
};

struct Source
{
  std::vector<Point> points;
  Cells lines, polygons;
  std::int64_t vertices = 0; ///< cells before the lines

  InputRequest request() const
  {
    InputRequest result;
    result.points = viewOf(points);
    result.lines = lines.view();
    result.polygons = polygons.view();
    result.firstCell = vertices;
    result.idsAreOfInput = true;
    result.closedLinesAreLoops = true;
    return result;
  }
};

Chain anyChain(Random& random, std::size_t points)
{
  Chain chain;
  for (std::uint64_t n = 1 + random.below(4); n > 0; --n)
  {
    chain.push_back(random.below(12) == 0 ? -5 : std::int64_t(random.below(points)));
  }
  if (chain.size() > 2 && random.below(3) == 0)
  {
    chain.push_back(chain[0]);
  }
  return chain;
}

/// Sources of some blocks, and the same appended: vertices, lines, polygons.
Source makeSources(std::uint64_t seed, std::vector<Source>& sources)
{
  Random random(seed);
  Source whole;
  for (Source& own : sources)
  {
    const auto first = std::int64_t(whole.points.size());
    // few places, so that lines of several blocks meet
    for (std::uint64_t n = 1 + random.below(9); n > 0; --n)
    {
      own.points.push_back({ double(random.below(4)), double(random.below(3)) });
    }
    own.vertices = std::int64_t(random.below(3));
    for (std::uint64_t n = random.below(6); n > 0; --n)
    {
      own.lines.add(anyChain(random, own.points.size()));
      own.polygons.add(anyChain(random, own.points.size()));
    }
    whole.points.insert(whole.points.end(), own.points.begin(), own.points.end());
    whole.vertices += own.vertices;
    for (auto* const cells : { &own.lines, &own.polygons })
    {
      Cells& to = cells == &own.lines ? whole.lines : whole.polygons;
      for (std::size_t k = 0; k + 1 < cells->offsets.size(); ++k)
      {
        to.add(
          Chain(cells->ids.begin() + cells->offsets[k], cells->ids.begin() + cells->offsets[k + 1]),
          first);
      }
    }
  }
  return whole;
}

void expectEqual(const BlockChains& joined, const PreparedInput& whole, std::uint64_t seed)
{
  const ConstraintView found = joined.view(), expected = whole.constraints();
  ASSERT_EQ(found.chains, expected.chains) << seed;
  EXPECT_EQ(found.lines, expected.lines) << seed;
  EXPECT_EQ(joined.haveLoops(), expected.chains > expected.lines) << seed;
  EXPECT_EQ(joined.areLinesUnclosed(), whole.areLinesUnclosed()) << seed;
  for (std::size_t chain = 0; chain < found.chains; ++chain)
  {
    EXPECT_EQ(Chain(found.ids + found.offsets[chain], found.ids + found.offsets[chain + 1]),
      Chain(expected.ids + expected.offsets[chain], expected.ids + expected.offsets[chain + 1]))
      << seed << ", chain " << chain;
    EXPECT_EQ(joined.cellOf(chain), whole.cellOf(chain)) << seed << ", chain " << chain;
  }
  EXPECT_EQ(joined.unfitIds().count, whole.unfitIds().count) << seed;
  if (whole.unfitIds().count > 0)
  {
    EXPECT_EQ(joined.unfitIds().firstId, whole.unfitIds().firstId) << seed;
    EXPECT_EQ(joined.unfitIds().firstCell, whole.unfitIds().firstCell) << seed;
  }
}

TEST(BlocksShare, ChainsAreThoseOfTheAppendedSource)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    std::vector<Source> sources(1 + seed % 4);
    const Source appended = makeSources(seed, sources);
    PreparedInput whole;
    ASSERT_EQ(prepare(appended.request(), {}, whole), Status::Ok);
    std::vector<BlockIds> ids(sources.size());
    std::int64_t first = 0;
    for (std::size_t b = 0; b < sources.size(); ++b)
    {
      ids[b] = { sources[b].points.size(), first, std::int64_t(appended.points.size()) };
      first += std::int64_t(sources[b].points.size());
    }
    onBlocks(sources.size(),
      [&](std::size_t b, PairTransport& transport)
      {
        const InputRequest request = sources[b].request();
        PreparedInput prepared;
        InputRequest own = request;
        own.closedLinesAreLoops = false;
        EXPECT_EQ(prepare(own, {}, prepared), Status::Ok);
        BlockChains joined;
        EXPECT_EQ(
          joined.join(request, prepared, ids[b], appended.vertices, transport, {}), Status::Ok);
        expectEqual(joined, whole, seed);
      });
  }
}

TEST(BlocksShare, IdsOfAddedPointsAreBehindAllInputs)
{
  const BlockIds ids{ 3, 10, 100 };
  EXPECT_EQ(ids.of(-1), -1);
  EXPECT_EQ(ids.of(0), 10);
  EXPECT_EQ(ids.of(2), 12);
  EXPECT_EQ(ids.of(3), 100);
  EXPECT_EQ(ids.of(5), 102);
}

} // namespace
} // namespace test
} // namespace ahd
