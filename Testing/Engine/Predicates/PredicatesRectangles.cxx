// SPDX-License-Identifier: BSD-3-Clause
//
// Rectangles with sides along the axes, which are known by their coordinates.
#include "Predicates/Filters.h"

#include "PredicatesCases.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

namespace ahd::test
{
namespace
{

#ifdef AHD_REDUCED_TESTS
constexpr int kCases = 2000;
#else
constexpr int kCases = 20000;
#endif

/// Rectangles of rounded coordinates, each corner as P, and what is nearly one.
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

} // namespace
} // namespace ahd::test
