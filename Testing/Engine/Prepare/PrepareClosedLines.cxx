// SPDX-License-Identifier: BSD-3-Clause
//
// Lines that end where they begin, as loops on request.
#include "PrepareCase.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

using Ids = std::vector<std::int64_t>;

/// A square; its first corner again, at another height; a place nearby; one that is not finite.
const std::vector<Xyz> kPoints = { { { 0, 0, 1 } }, { { 4, 0, 2 } }, { { 4, 4, 3 } },
  { { 0, 4, 4 } }, { { 0, 0, 9 } }, { { 0.1, 0, 1 } },
  { { std::numeric_limits<double>::quiet_NaN(), 0, 0 } } };

struct Chains
{
  std::vector<Ids> open, loops;
  std::vector<std::int64_t> cells;
  bool operator==(const Chains& other) const
  {
    return open == other.open && loops == other.loops && cells == other.cells;
  }
};

Chains chainsOf(PrepareCase& given)
{
  PreparedInput out;
  EXPECT_EQ(prepare(given.request, Context(), out), Status::Ok);
  const ConstraintView view = out.constraints();
  Chains result;
  for (std::size_t k = 0; k < view.chains; ++k)
  {
    const Ids ids(view.ids + view.offsets[k], view.ids + view.offsets[k + 1]);
    (k < view.lines ? result.open : result.loops).push_back(ids);
    result.cells.push_back(out.cellOf(k));
  }
  return result;
}

const Cells kLines = { { 0, 1, 2, 0 }, { 0, 1, 2 }, { 0, 1, 2, 3, 4 }, { 2, 3 }, { 0, 1, 2, 5 } };

TEST(PrepareClosedLines, AreLinesUnlessAskedFor)
{
  PrepareCase given({}, kPoints, kLines, { { 1, 2, 3 } });
  given.request.firstCell = 10;
  const Chains found = chainsOf(given);
  EXPECT_EQ(found.open, kLines);
  EXPECT_EQ(found.loops, (Cells{ { 1, 2, 3 } }));
  EXPECT_EQ(found.cells, (Ids{ 10, 11, 12, 13, 14, 15 }));
}

TEST(PrepareClosedLines, AreLoopsWhereTheirEndsCoincide)
{
  for (const bool wide : { false, true })
  {
    PrepareCase given({}, kPoints, kLines, { { 1, 2, 3 } });
    given.setWide(wide);
    given.request.firstCell = 10;
    given.request.closedLinesAreLoops = true;
    const Chains found = chainsOf(given);
    EXPECT_EQ(found.open, (Cells{ { 0, 1, 2 }, { 2, 3 }, { 0, 1, 2, 5 } }));
    EXPECT_EQ(found.loops, (Cells{ { 0, 1, 2, 0 }, { 0, 1, 2, 3, 4 }, { 1, 2, 3 } }));
    EXPECT_EQ(found.cells, (Ids{ 11, 13, 14, 10, 12, 15 })) << "each keeps its number";
  }
}

TEST(PrepareClosedLines, WithoutOneNothingMoves)
{
  const Cells lines = { { 0, 1 }, { 1, 2, 3 }, { 0, 1, 0 }, { 4, 0 }, { 6, 1, 2, 6 },
    { -1, 1, 2, -1 }, { 0, 1, 2, 9 } };
  PrepareCase given({}, kPoints, lines, { { 1, 2, 3 } });
  const Chains expected = chainsOf(given);
  given.request.closedLinesAreLoops = true;
  Chains found = chainsOf(given);
  // one id, of a rejected point: closed by its numbers
  EXPECT_EQ(found.loops, (Cells{ { 6, 1, 2, 6 }, { 1, 2, 3 } }));
  found.loops.erase(found.loops.begin());
  EXPECT_EQ(found.open.size() + 1, expected.open.size());
}

TEST(PrepareClosedLines, EndsThatAreMergedAreOnePoint)
{
  PrepareCase given({}, kPoints, kLines);
  given.request.closedLinesAreLoops = true;
  given.request.tolerance = 0.05; // of a diagonal of 5.7
  EXPECT_EQ(chainsOf(given).loops.size(), 3u);
}

TEST(PrepareClosedLines, TheirPlacesAreThoseInThePlane)
{
  // a wall: ends with the same place in the plane x, z lie apart in x, y
  class XZ : public Projection
  {
  public:
    bool project(const PointView& points, double* to, const Context&) const override
    {
      for (std::size_t i = 0; i < points.count; ++i)
      {
        std::swap(to[3 * i + 1], to[3 * i + 2]);
      }
      return true;
    }
  } projection;
  const std::vector<Xyz> wall = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 0, 1 } },
    { { 0, 7, 0 } } };
  PrepareCase given({}, wall, { { 0, 1, 2, 3 } });
  given.request.closedLinesAreLoops = true;
  EXPECT_EQ(chainsOf(given).loops.size(), 0u);
  given.request.projection = &projection;
  EXPECT_EQ(chainsOf(given).loops.size(), 1u);
}

TEST(PrepareClosedLines, CrossingsNameTheCells)
{
  const std::vector<Xyz> points = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 4, 4, 0 } },
    { { 0, 4, 0 } }, { { 2, 2, 0 } }, { { 2, 9, 0 } } };
  PrepareCase given({}, points, { { 0, 1, 2, 3, 0 }, { 4, 5 } });
  given.request.closedLinesAreLoops = given.request.split = true;
  PreparedInput out;
  ASSERT_EQ(prepare(given.request, Context(), out), Status::Ok);
  ASSERT_EQ(out.crossingCells().size(), 1u);
  EXPECT_EQ(out.crossingCells()[0], (std::array<std::int64_t, 2>{ { 0, 1 } }))
    << "the loop comes after the line";
}

} // namespace
} // namespace test
} // namespace ahd
