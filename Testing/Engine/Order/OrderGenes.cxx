// SPDX-License-Identifier: BSD-3-Clause
//
// The curve: the twenty rows of the gene table, and that the state machine made from them is the
// Hilbert curve at every depth.
#include "Distributions.h"
#include "Order/HilbertCurve.h"
#include "Order/HilbertKeys.h"
#include "PaperOrder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

Side sideBefore(Step step)
{
  switch (step)
  {
    case Step::LeftToRight:
      return Side::Left;
    case Step::RightToLeft:
      return Side::Right;
    case Step::BottomToTop:
      return Side::Below;
    case Step::TopToBottom:
      return Side::Above;
    default:
      return Side::None;
  }
}

Side sideAfter(Step step)
{
  return opposite(sideBefore(step));
}

/// The four quarters in the order in which the state machine visits them.
Curve cellOf(unsigned gene)
{
  Curve cell(4);
  for (Column x = 0; x < 2; ++x)
  {
    for (Row y = 0; y < 2; ++y)
    {
      cell[digitOf(gene, x, y)] = { x, y };
    }
  }
  return cell;
}

/// The first `levels` levels of a key, as a place among the 4^levels boxes.
std::uint64_t placeOn(Column column, Row row, unsigned levels)
{
  const unsigned rest = 32 - levels;
  return hilbertKey(column << rest, row << rest) >> (2 * rest);
}

class GeneTable : public ::testing::TestWithParam<std::size_t>
{
};

TEST_P(GeneTable, RowIsTheMachinesGene)
{
  const GeneRow& row = geneTable().at(GetParam());
  const Curve expected = transformed(hilbertCurve(1), row.turn, row.reverse);
  const Gene gene = geneOf(sideBefore(row.fromPrevious), sideAfter(row.toNext));
  EXPECT_EQ(cellOf(gene), expected) << "row " << GetParam() + 1 << ", gene " << gene;
}

TEST_P(GeneTable, RowEntersAndLeavesByTheRule)
{
  const GeneRow& row = geneTable().at(GetParam());
  const Step from = row.fromPrevious == Step::None ? row.toNext : row.fromPrevious;
  const Step to = row.toNext == Step::None ? row.fromPrevious : row.toNext;
  const bool fromLeftOrBelow = from == Step::LeftToRight || from == Step::BottomToTop;
  const bool toRightOrBelow = to == Step::LeftToRight || to == Step::TopToBottom;
  const Curve cell = transformed(hilbertCurve(1), row.turn, row.reverse);
  const std::pair<Column, Row> bottomLeft{ 0, 0 }, topRight{ 1, 1 }, bottomRight{ 1, 0 },
    topLeft{ 0, 1 };
  EXPECT_EQ(cell.front(), fromLeftOrBelow ? bottomLeft : topRight) << "row " << GetParam() + 1;
  EXPECT_EQ(cell.back(), toRightOrBelow ? bottomRight : topLeft) << "row " << GetParam() + 1;
}

INSTANTIATE_TEST_SUITE_P(Rows, GeneTable, ::testing::Range(std::size_t(0), std::size_t(20)),
  [](const ::testing::TestParamInfo<std::size_t>& row)
  { return "Row" + std::to_string(row.param + 1); });

TEST(GeneTable, HasTwentyDifferentRows)
{
  const std::vector<GeneRow>& table = geneTable();
  ASSERT_EQ(table.size(), 20u);
  for (std::size_t a = 0; a < table.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      EXPECT_FALSE(
        table[a].fromPrevious == table[b].fromPrevious && table[a].toNext == table[b].toNext)
        << "rows " << b + 1 << " and " << a + 1;
    }
  }
}

TEST(HilbertCurve, TextbookCurveHasNoJump)
{
  for (unsigned order = 1; order <= 7; ++order)
  {
    const Curve curve = hilbertCurve(order);
    ASSERT_EQ(curve.size(), std::size_t(1) << (2 * order));
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      const int dx = int(curve[i].first) - int(curve[i - 1].first);
      const int dy = int(curve[i].second) - int(curve[i - 1].second);
      ASSERT_EQ(std::abs(dx) + std::abs(dy), 1) << "order " << order << ", box " << i;
    }
  }
}

TEST(HilbertCurve, KeysOfEveryDepthFollowTheTextbookCurveTurnedByTheGenesAbove)
{
  // The machine starts untransposed whatever the depth; the textbook curve, which always runs from
  // bottom-left to bottom-right, is the same at every order.
  for (unsigned order = 1; order <= 7; ++order)
  {
    const Curve curve = hilbertCurve(order);
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      ASSERT_EQ(placeOn(curve[i].first, curve[i].second, order), i)
        << "order " << order << ", box (" << curve[i].first << ", " << curve[i].second << ")";
    }
  }
}

/// The paper's rule for a divided box of a curve of several levels: a curve of `below` levels
/// turned by the row of the table for its neighbours. It must continue the key.
TEST(HilbertCurve, TableDividesBoxesAsTheKeysDo)
{
  for (unsigned above = 1; above <= 4; ++above)
  {
    for (unsigned below = 1; below <= 4; ++below)
    {
      const Curve outer = hilbertCurve(above);
      for (std::size_t i = 0; i < outer.size(); ++i)
      {
        const GeneRow& gene = geneOfBox(outer, i);
        const Curve inner = transformed(hilbertCurve(below), gene.turn, gene.reverse);
        for (std::size_t j = 0; j < inner.size(); ++j)
        {
          const Column column = outer[i].first << below | inner[j].first;
          const Row row = outer[i].second << below | inner[j].second;
          ASSERT_EQ(placeOn(column, row, above + below), i * inner.size() + j)
            << above << " levels and " << below << ", box " << i << ", box " << j << " in it";
        }
      }
    }
  }
}

TEST(HilbertCurve, PlaceOfKeyIsTheInverse)
{
  Random random(1);
  for (int i = 0; i < 10000; ++i)
  {
    const std::uint64_t key = random.bits();
    const GridPlace place = placeOfKey(key);
    ASSERT_EQ(hilbertKey(place.column, place.row), key) << std::hex << key;
  }
}

TEST(HilbertCurve, FinestGridHasNoJump)
{
  Random random(2);
  for (int i = 0; i < 10000; ++i)
  {
    // Also where many digits carry at once.
    const std::uint64_t key = (random.bits() | ((std::uint64_t(1) << random.below(63)) - 1));
    if (key == ~std::uint64_t(0))
    {
      continue;
    }
    const GridPlace a = placeOfKey(key);
    const GridPlace b = placeOfKey(key + 1);
    const std::int64_t dx = std::int64_t(a.column) - std::int64_t(b.column);
    const std::int64_t dy = std::int64_t(a.row) - std::int64_t(b.row);
    ASSERT_EQ(std::abs(dx) + std::abs(dy), 1) << std::hex << key;
  }
}

/// The places of one block: corners and edges of the grid, then places of ever more bits.
std::vector<GridPlace> placesToTry(std::size_t count, std::mt19937& random)
{
  static constexpr std::uint32_t kEdges[] = { 0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF,
    0x55555555, 0xAAAAAAAA };
  std::vector<GridPlace> places;
  for (const std::uint32_t x : kEdges)
  {
    for (const std::uint32_t y : kEdges)
    {
      places.push_back({ x, y });
    }
  }
  while (places.size() < count)
  {
    const unsigned shift = static_cast<unsigned>(places.size() % 32);
    places.push_back({ std::uint32_t(random()) >> shift, std::uint32_t(random()) >> shift });
  }
  places.resize(count);
  return places;
}

TEST(HilbertKeys, AllDispatchTargetsAreTheStateMachine)
{
  std::mt19937 random(3);
  for (const DispatchTarget<HilbertKeys>& target : kHilbertKeysTargets)
  {
    for (std::size_t round = 0; processorHas(target.needs) && round < 4000; ++round)
    {
      const std::size_t count = round < 2 * kKeyBlock ? round / 2 : kKeyBlock;
      std::uint32_t columns[kKeyBlock], rows[kKeyBlock];
      std::uint64_t keys[kKeyBlock];
      const std::vector<GridPlace> places = placesToTry(count, random);
      for (std::size_t i = 0; i < count; ++i)
      {
        columns[i] = places[i].column;
        rows[i] = places[i].row;
      }
      target.run(columns, rows, keys, count);
      for (std::size_t i = 0; i < count; ++i)
      {
        ASSERT_EQ(keys[i], hilbertKey(columns[i], rows[i]))
          << "target " << int(target.needs) << ": column " << columns[i] << ", row " << rows[i];
      }
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
