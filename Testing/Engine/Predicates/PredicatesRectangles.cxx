// SPDX-License-Identifier: BSD-3-Clause
//
// Rectangles with sides along the axes, which are recognised by their coordinates.
#include "Predicates/Filters.h"
#include "Predicates/TighterFilterPairs.h"

#include "PredicatesCases.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <utility>

namespace ahd::test
{
namespace
{

#ifdef AHD_REDUCED_TESTS
constexpr int kCases = 2000;
#else
constexpr int kCases = 20000;
#endif

/// Rectangles of rounded coordinates, each corner as P, and near rectangles.
TEST(PredicatesRectangles, AreKnownInEveryOrder)
{
  Cases source(Family::Uniform);
  for (int i = 0; i < kCases / 10; ++i)
  {
    const Quadruple r = source.draw();
    const double left = 0.1 * r[0].x, right = left + 0.1 + r[1].x, low = -r[2].x,
                 high = low + r[3].x + 1e-9;
    const Point corners[4] = { { left, low }, { right, low }, { right, high }, { left, high } };
    for (std::size_t k = 0; k < 4; ++k)
    {
      Point p = corners[k];
      for (std::size_t turn = 1; turn < 4; ++turn)
      {
        const Point abc[3] = { corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4] };
        const Point &a = abc[turn % 3], &b = abc[(turn + 1) % 3], &c = abc[(turn + 2) % 3];
        ASSERT_EQ(conflictInRectangle(a, b, c, p), oracleInConflict(a, b, c, p) ? 1 : -1);
        for (const Point& moved : { Point{ std::nextafter(p.x, 9.0), p.y },
               Point{ p.x, std::nextafter(p.y, 9.0) }, Point{ p.y, p.x } })
        {
          ASSERT_EQ(conflictInRectangle(a, b, c, moved), 0);
        }
      }
    }
  }
  EXPECT_EQ(conflictInRectangle({ 0, 0 }, { 2, 0 }, { 1, 2 }, { 1, 1 }), 0);
  EXPECT_EQ(conflictInRectangle({ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 2 }), 0);
}

/// Of two edges, the requested ones.
TEST(PredicatesRectangles, AreKnownOfPairs)
{
  const Point p{ 0, 0 }, right{ 1, 0 }, far{ 1, 1 }, above{ 0, 1 }, other{ 5, 7 };
  const Point below{ 0, -1 }, farBelow{ 1, -1 };
  ASSERT_EQ(conflictInRectangle(right, far, above, p), -1); // the largest is opposite
  ASSERT_EQ(conflictInRectangle(below, farBelow, right, p), 1);
  const auto seen = [&](unsigned open, const TwoEdges& edges)
  {
    const InCirclePair pair = inRectangles(open, p, edges);
    return std::pair<unsigned, unsigned>(pair.certain, pair.inside & pair.certain);
  };
  using Answer = std::pair<unsigned, unsigned>;
  // the first is of c, a and beyondFirst, the second of b, c and beyondSecond
  const TwoEdges both{ far, right, below, above, farBelow };
  EXPECT_EQ(seen(3, both), Answer(3, 2));
  EXPECT_EQ(seen(1, both), Answer(1, 0));
  EXPECT_EQ(seen(2, both), Answer(2, 2));
  EXPECT_EQ(seen(0, both), Answer(0, 0));
  EXPECT_EQ(seen(3, { far, right, below, other, farBelow }), Answer(2, 2));
  EXPECT_EQ(seen(3, { far, right, below, above, other }), Answer(1, 0));
}

} // namespace
} // namespace ahd::test
