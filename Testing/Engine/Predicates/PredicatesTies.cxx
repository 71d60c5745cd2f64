// SPDX-License-Identifier: BSD-3-Clause
//
// Cocircular points: the tie-break of inConflict is the perturbation it claims to be, on every four
// points of small lattices and on larger circles at many scales.
#include "Predicates/Predicates.h"
#include "Predicates/Stages.h"

#include "ExactSigns.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ahd::test
{
namespace
{

using Quadruple = std::array<Point, 4>;

std::string textOf(const Quadruple& p)
{
  return hexText(p[0]) + " " + hexText(p[1]) + " " + hexText(p[2]) + " | " + hexText(p[3]);
}

std::vector<Point> lattice(int side)
{
  std::vector<Point> points;
  for (int i = 0; i < side * side; ++i)
  {
    points.push_back({ double(i / side), double(i % side) });
  }
  return points;
}

/// Calls visit with every four of the points whose first three turn counterclockwise, the first
/// three in all cyclic orders, for each choice of the fourth.
template <class Visit>
void forEveryFour(const std::vector<Point>& points, Visit visit)
{
  for (const Point& a : points)
  {
    for (const Point& b : points)
    {
      for (const Point& c : points)
      {
        if (oracleOrient2d(a, b, c) <= 0)
        {
          continue;
        }
        for (const Point& d : points)
        {
          if (!(d == a || d == b || d == c))
          {
            visit(Quadruple{ a, b, c, d });
          }
        }
      }
    }
  }
}

/// The perturbation with numbers in place of infinitesimals. @pre integers of at most 7 bits,
/// which asIntegers turns into integers below 2^70, so that the coefficients of the heights are
/// below 2^143, and not below 1 where they are not 0. Heights are counted in units of 2^-1000, and
/// the point of rank k (from 0 in lexicographic order) is raised by 2^(200 k) of them: all four
/// together by too little to outweigh an unperturbed determinant, each by more than the ones before
/// it together.
bool conflictWithRaisedHeights(const Quadruple& points)
{
  const auto p = asIntegers<4>(points);
  const auto coefficient = heightCoefficients(p);
  mpz_class sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    unsigned long rank = 0;
    for (const Point& other : points)
    {
      rank += other.x < points[i].x || (other.x == points[i].x && other.y < points[i].y);
    }
    mpz_class height = (p[i][0] * p[i][0] + p[i][1] * p[i][1]) << 1000;
    height += mpz_class(1) << (200 * rank);
    sum += height * coefficient[i];
  }
  return sgn(sum) > 0;
}

TEST(PredicatesTies, EveryFourPointsOfSmallLattices)
{
  for (const int side : { 3, 4 })
  {
    int ties = 0;
    forEveryFour(lattice(side),
      [&](const Quadruple& q)
      {
        const bool answer = inConflict(q[0], q[1], q[2], q[3]);
        EXPECT_EQ(answer, conflictWithRaisedHeights(q)) << textOf(q);
        EXPECT_EQ(answer, oracleInConflict(q[0], q[1], q[2], q[3])) << textOf(q);
        EXPECT_EQ(answer, inConflictExact(q[0], q[1], q[2], q[3])) << textOf(q);
        ties += inCircle(q[0], q[1], q[2], q[3]) == 0;
      });
    EXPECT_GT(ties, 0) << side;
  }
}

/// Of the two diagonals of a cocircular quadrilateral exactly one is Delaunay, and its two
/// triangles agree on it.
TEST(PredicatesTies, OneDiagonalOfEachCocircularQuadrilateral)
{
  int quadrilaterals = 0;
  forEveryFour(lattice(4),
    [&](const Quadruple& q)
    {
      const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
      if (inCircle(a, b, c, d) != 0 || orient2d(a, c, d) <= 0)
      {
        return; // a, b, c, d is not their order around the circle
      }
      ++quadrilaterals;
      const bool acIsWrong = inConflict(a, b, c, d);
      EXPECT_EQ(inConflict(c, d, a, b), acIsWrong) << textOf(q);
      EXPECT_EQ(inConflict(b, c, d, a), !acIsWrong) << textOf(q);
      EXPECT_EQ(inConflict(d, a, b, c), !acIsWrong) << textOf(q);
    });
  EXPECT_GT(quadrilaterals, 0);
}

/// Integer points of a circle of radius 65 about the origin.
std::vector<Point> onCircleOf65()
{
  std::vector<Point> points;
  for (int x = -65; x <= 65; ++x)
  {
    for (int y = -65; y <= 65; ++y)
    {
      if (x * x + y * y == 65 * 65)
      {
        points.push_back({ double(x), double(y) });
      }
    }
  }
  return points;
}

/// Powers of two change nothing, nor does the sign of a zero, wherever the numbers remain exact.
TEST(PredicatesTies, TheSameAtEveryScale)
{
  std::vector<Point> circle;
  for (const Point& p : onCircleOf65())
  {
    if (circle.size() < 7 || p.x == 0.0 || p.y == 0.0)
    {
      circle.push_back(p);
    }
  }
  ASSERT_GE(circle.size(), 9u);
  for (const int exponent : { -1074, -1000, -300, -40, 0, 40, 300, 1000, 1016 })
  {
    forEveryFour(circle,
      [&](const Quadruple& q)
      {
        const bool expected = conflictWithRaisedHeights(q);
        Quadruple s;
        for (std::size_t i = 0; i < 4; ++i)
        {
          s[i] = { std::ldexp(q[i].x, exponent), std::ldexp(q[i].y, exponent) };
          s[i].x = s[i].x == 0.0 && i % 2 == 0 ? -0.0 : s[i].x;
          s[i].y = s[i].y == 0.0 && i % 2 == 1 ? -0.0 : s[i].y;
        }
        ASSERT_EQ(inCircle(s[0], s[1], s[2], s[3]), 0) << textOf(s);
        ASSERT_EQ(inConflict(s[0], s[1], s[2], s[3]), expected) << textOf(s);
      });
  }
}

/// The rule: of four cocircular points the largest is raised, so an edge of the
/// triangulation runs between its two neighbours on the circle.
TEST(PredicatesTies, TheLargestPointIsCutOff)
{
  const Point sw{ 0, 0 }, se{ 1, 0 }, ne{ 1, 1 }, nw{ 0, 1 };
  EXPECT_FALSE(inConflict(sw, se, nw, ne));
  EXPECT_FALSE(inConflict(se, ne, nw, sw));
  EXPECT_TRUE(inConflict(sw, se, ne, nw));
  EXPECT_TRUE(inConflict(sw, ne, nw, se));
}

} // namespace
} // namespace ahd::test
