// SPDX-License-Identifier: BSD-3-Clause
//
// Arrays of cells, for some of the triangles and other cells besides: against the arrays for all.
#include "ConstrainedRun.h"
#include "EngineRun.h"
#include "Executors.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <map>

namespace ahd
{
namespace test
{
namespace
{

/// Some of the kept triangles, and cells before them.
Selection someOf(const Triangulation& made, std::uint64_t seed)
{
  Random random(seed);
  Selection result;
  for (std::size_t t = 0; t < made.triangleCount(); ++t)
  {
    result.kept.push_back(made.isKept(t) && random.below(4) != 0 ? 1 : 0);
    result.keptCount += result.kept.back();
  }
  result.vertices = { 3, 5, 8 };
  result.lines = { 1, 2, 2, 5 };
  return result;
}

/// The same regions, numbered as they appear.
std::vector<std::int64_t> renumbered(const std::vector<std::int64_t>& regions)
{
  std::map<std::int64_t, std::int64_t> numbers;
  std::vector<std::int64_t> result;
  for (const std::int64_t region : regions)
  {
    result.push_back(numbers.emplace(region, std::int64_t(numbers.size())).first->second);
  }
  return result;
}

/// Triangles and neighbours in one pass are those of two.
void expectBoth(Triangulation& made, const Selection& selection, const Context& context)
{
  const std::size_t cells = cellCount(made, selection);
  const std::size_t before = selection.vertices.size() + selection.lines.size() / 2;
  std::vector<std::int32_t> apart(3 * (cells - before), -7), triples(3 * (cells - before), -8);
  std::vector<std::int64_t> neighborsApart(3 * cells, -7), neighbors(3 * cells, -8);
  ASSERT_EQ(selection.kept.empty() ? made.writeTriangles(apart.data(), context)
                                   : writeSelected(made, selection, apart.data(), context),
    Status::Ok);
  ASSERT_EQ(writeNeighbors(made, selection, neighborsApart.data(), context), Status::Ok);
  const CellsWithNeighbors<std::int64_t> both = { triples.data(), neighbors.data() };
  ASSERT_EQ(writeWithNeighbors(made, selection, both, context), Status::Ok);
  EXPECT_EQ(triples, apart);
  EXPECT_EQ(neighbors, neighborsApart);
}

void expectSelected(const ConstraintCase& given, std::uint64_t seed, Executor* executor)
{
  const FillRule rule = kFillRules[seed % 2];
  const ConstrainedOutcome all = constrain(given, rule);
  Engine engine;
  ASSERT_EQ(engine.run(given.view(), Options(), nullptr, executor), Status::Ok);
  ASSERT_EQ(engine.constrain(given.constraints.view(), rule), Status::Ok);
  ASSERT_EQ(engine.made.makeCorners({}), Status::Ok);
  const Selection some = someOf(engine.made, seed);
  ASSERT_EQ(cellCount(engine.made, some), 5 + some.keptCount);
  if (some.keptCount == 0)
  {
    return;
  }
  const Context context{ nullptr, executor };
  std::vector<std::int32_t> triples(3 * some.keptCount, -7);
  std::vector<std::int64_t> neighbors(3 * (5 + some.keptCount), -7);
  std::vector<std::int32_t> regions(5 + some.keptCount, -7);
  std::vector<std::uint8_t> edges(5 + some.keptCount, 77);
  ASSERT_EQ(writeSelected(engine.made, some, triples.data(), context), Status::Ok);
  ASSERT_EQ(writeNeighbors(engine.made, some, neighbors.data(), context), Status::Ok);
  ASSERT_EQ(writeRegions(engine.made, some, regions.data(), context), Status::Ok);
  ASSERT_EQ(writeConstraintEdges(engine.made, some, edges.data(), context), Status::Ok);
  expectBoth(engine.made, some, context);
  expectBoth(engine.made, Selection(), context);

  std::vector<std::int64_t> cellOf; // of each triangle that loops keep
  std::vector<std::int32_t> expectedTriples;
  std::vector<std::uint8_t> expectedEdges(5);
  std::vector<std::int64_t> expectedNeighbors(15, -1), expectedRegions;
  for (std::size_t t = 0, kept = 0; t < engine.made.triangleCount(); ++t)
  {
    if (!engine.made.isKept(t))
    {
      continue;
    }
    const bool isSelected = some.kept[t] != 0;
    cellOf.push_back(isSelected ? std::int64_t(5 + expectedTriples.size() / 3) : -1);
    if (isSelected)
    {
      const auto* const triple = all.triples.data() + 3 * kept;
      expectedTriples.insert(expectedTriples.end(), triple, triple + 3);
      expectedEdges.push_back(all.constraintEdges[kept]);
      expectedRegions.push_back(all.regions[kept]);
    }
    ++kept;
  }
  for (std::size_t kept = 0; kept < cellOf.size(); ++kept)
  {
    for (std::size_t e = 3 * kept; cellOf[kept] >= 0 && e < 3 * kept + 3; ++e)
    {
      const std::int64_t other = all.neighbors[e];
      expectedNeighbors.push_back(other < 0 ? -1 : cellOf[std::size_t(other)]);
    }
  }
  EXPECT_EQ(triples, expectedTriples);
  EXPECT_EQ(neighbors, expectedNeighbors);
  EXPECT_EQ(edges, expectedEdges);
  for (std::size_t k = 0; k < 5; ++k)
  {
    EXPECT_EQ(regions[k], -1);
  }
  EXPECT_EQ(
    std::vector<std::int64_t>(regions.begin() + 5, regions.end()), renumbered(expectedRegions));
}

TEST(CellArrays, OfASelectionAreThoseOfAll)
{
  for (std::uint64_t seed = 1; seed <= reduced(300); ++seed)
  {
    ASSERT_NO_FATAL_FAILURE(expectSelected(smallConstraintCase(seed), seed, nullptr));
  }
  ASSERT_NO_FATAL_FAILURE(expectSelected(nestedLoops(20), 1, nullptr));
  ASSERT_NO_FATAL_FAILURE(expectSelected(starPolygon(300), 2, nullptr));
}

TEST(CellArrays, OnThreads)
{
  ThreadExecutor threads(3);
  ASSERT_NO_FATAL_FAILURE(expectSelected(edgesOfOthers(20000, 2000), 1, &threads));
}

TEST(CellArrays, WithoutTrianglesThereAreTheCellsBefore)
{
  Engine engine;
  const std::vector<Point> line = { { 0, 0 }, { 1, 1 }, { 2, 2 } };
  ASSERT_EQ(engine.run(viewOf(line)), Status::Ok);
  Selection some;
  some.lines = { 0, 1, 1, 2 };
  std::vector<std::int32_t> numbers(6, -7);
  std::vector<std::uint8_t> edges(2, 77);
  EXPECT_EQ(cellCount(engine.made, some), 2u);
  EXPECT_EQ(writeNeighbors(engine.made, some, numbers.data(), {}), Status::Ok);
  expectBoth(engine.made, some, {});
  EXPECT_EQ(numbers, std::vector<std::int32_t>(6, -1));
  numbers.assign(2, -7);
  EXPECT_EQ(writeRegions(engine.made, some, numbers.data(), {}), Status::Ok);
  EXPECT_EQ(numbers, std::vector<std::int32_t>(2, -1));
  EXPECT_EQ(writeConstraintEdges(engine.made, some, edges.data(), {}), Status::Ok);
  EXPECT_EQ(edges, std::vector<std::uint8_t>(2, 0));
}

} // namespace
} // namespace test
} // namespace ahd
