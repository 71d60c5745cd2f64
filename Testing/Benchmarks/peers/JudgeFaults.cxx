// SPDX-License-Identifier: BSD-3-Clause
//
// The judge must name every kind of fault, and nothing else: each is planted here. The correct
// triangulations come from the oracle, not from the engine.
#include "Oracle.h"
#include "TriangleJudge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace ahd
{
namespace test
{
namespace
{

std::vector<std::int32_t> rightTriples(const std::vector<Point>& points)
{
  std::vector<std::int32_t> triples;
  for (const Triple& triple : delaunayByDefinition(points))
  {
    triples.insert(triples.end(), triple.begin(), triple.end());
  }
  return triples;
}

/// A hexagon, not regular, round a centre (6): six triangles about the centre.
std::vector<Point> hexagon()
{
  return { { 4, 0 }, { 2, 3 }, { -2, 3.5 }, { -4, 0 }, { -2, -3 }, { 2, -3.5 }, { 0.1, 0 } };
}

/// A quadrilateral of which the diagonal 0-2 is Delaunay and 1-3 is not.
std::vector<Point> kite()
{
  return { { 0, -1 }, { 3, 0 }, { 0, 1 }, { -3, 0 } };
}

TEST(JudgeFaults, RightTriangulationIsRight)
{
  const Verdict verdict = judge(hexagon(), rightTriples(hexagon()));
  EXPECT_TRUE(verdict.isRight()) << verdict.json();
  EXPECT_EQ(verdict.points, 7u);
  EXPECT_EQ(verdict.places, 7u);
  EXPECT_EQ(verdict.triangles, 6u);
  EXPECT_EQ(verdict.expected, 6u);
  EXPECT_EQ(verdict.border, 6u);
  EXPECT_EQ(verdict.areaShare, 1.0);
}

TEST(JudgeFaults, LostPoint)
{
  std::vector<Point> points = hexagon();
  const std::vector<std::int32_t> triples = rightTriples(points);
  points.push_back({ 0.2, 0.3 });
  const Verdict verdict = judge(points, triples);
  EXPECT_EQ(verdict.lost, 1u);
  EXPECT_TRUE(verdict.hullComplete);
  EXPECT_EQ(verdict.expected, 8u);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, ExactDuplicateIsNotLost)
{
  std::vector<Point> points = hexagon();
  std::vector<std::int32_t> triples = rightTriples(points);
  points.push_back(points[6]);
  EXPECT_TRUE(judge(points, triples).isRight());
  *std::find(triples.begin(), triples.end(), 6) = 7; // either of them may be named
  EXPECT_TRUE(judge(points, triples).isRight());
  EXPECT_EQ(judge(points, triples).places, 7u);
}

TEST(JudgeFaults, LostPointOnTheHull)
{
  std::vector<Point> points = hexagon();
  const std::vector<std::int32_t> triples = rightTriples(points);
  points.push_back({ 4, 0x1p-60 });
  const Verdict verdict = judge(points, triples);
  EXPECT_EQ(verdict.lost, 1u);
  EXPECT_FALSE(verdict.hullComplete); // by an area of 2^-60 or so
}

TEST(JudgeFaults, MissingTriangle)
{
  std::vector<std::int32_t> triples = rightTriples(hexagon());
  triples.resize(triples.size() - 3);
  const Verdict verdict = judge(hexagon(), triples);
  EXPECT_FALSE(verdict.hullComplete);
  EXPECT_LT(verdict.areaShare, 1.0);
  EXPECT_EQ(verdict.lost, 0u);
  EXPECT_EQ(verdict.triangles, 5u);
  EXPECT_EQ(verdict.border, 7u);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, TriangleTwice)
{
  std::vector<std::int32_t> triples = rightTriples(hexagon());
  const std::vector<std::int32_t> first(triples.begin(), triples.begin() + 3);
  triples.insert(triples.end(), first.begin(), first.end());
  const Verdict verdict = judge(hexagon(), triples);
  EXPECT_EQ(verdict.overlaps, 3u);
  EXPECT_GT(verdict.areaShare, 1.0);
  EXPECT_FALSE(verdict.hullComplete);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, OverlapOfTheAreaOfAHole)
{
  // One triangle missing, its neighbour's twin across the centre in its place: as many triangles.
  std::vector<std::int32_t> triples = rightTriples(hexagon());
  std::copy(triples.begin(), triples.begin() + 3, triples.end() - 3);
  const Verdict verdict = judge(hexagon(), triples);
  EXPECT_EQ(verdict.triangles, verdict.expected);
  EXPECT_EQ(verdict.overlaps, 3u);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, ClockwiseTriangle)
{
  std::vector<std::int32_t> triples = rightTriples(hexagon());
  std::swap(triples[3], triples[4]);
  const Verdict verdict = judge(hexagon(), triples);
  EXPECT_EQ(verdict.clockwise, 1u);
  EXPECT_TRUE(verdict.hullComplete);
  EXPECT_EQ(verdict.overlaps, 0u);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, AllClockwiseIsAConvention)
{
  std::vector<std::int32_t> triples = rightTriples(hexagon());
  for (std::size_t i = 0; i < triples.size(); i += 3)
  {
    std::swap(triples[i], triples[i + 1]);
  }
  const Verdict verdict = judge(hexagon(), triples);
  EXPECT_EQ(verdict.clockwise, 6u);
  EXPECT_TRUE(verdict.isRight());
}

TEST(JudgeFaults, EdgeNotDelaunay)
{
  EXPECT_TRUE(judge(kite(), { 0, 1, 2, 0, 2, 3 }).isRight());
  const Verdict verdict = judge(kite(), { 0, 1, 3, 1, 2, 3 });
  EXPECT_EQ(verdict.notDelaunay, 1u);
  EXPECT_TRUE(verdict.hullComplete);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, CocircularPointsMayBeJoinedEitherWay)
{
  const std::vector<Point> square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  EXPECT_TRUE(judge(square, { 0, 1, 2, 0, 2, 3 }).isRight());
  EXPECT_TRUE(judge(square, { 0, 1, 3, 1, 2, 3 }).isRight());
}

TEST(JudgeFaults, OneUnitInTheLastPlaceDecides)
{
  const double below = 1.0 - 0x1p-53;
  const std::vector<Point> nearlySquare = { { 0, 0 }, { 1, 0 }, { below, below }, { 0, 1 } };
  EXPECT_EQ(judge(nearlySquare, { 0, 1, 3, 1, 2, 3 }).notDelaunay, 1u);
  EXPECT_TRUE(judge(nearlySquare, { 0, 1, 2, 0, 2, 3 }).isRight());
}

TEST(JudgeFaults, TriangleWithoutArea)
{
  const std::vector<Point> points = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 3 } };
  std::vector<std::int32_t> triples = rightTriples(points);
  EXPECT_TRUE(judge(points, triples).isRight());
  triples.insert(triples.end(), { 0, 1, 2, 3, 3, 1 });
  const Verdict verdict = judge(points, triples);
  EXPECT_EQ(verdict.degenerate, 2u);
  EXPECT_TRUE(verdict.hullComplete);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, CollinearPointOnTheHullSkipped)
{
  const std::vector<Point> points = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 3 } };
  const Verdict verdict = judge(points, { 0, 2, 3 });
  EXPECT_EQ(verdict.lost, 1u);
  EXPECT_TRUE(verdict.hullComplete);
  EXPECT_EQ(verdict.expected, 2u);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, IdOfNoPoint)
{
  for (const std::int32_t id : { -1, 7, std::numeric_limits<std::int32_t>::max() })
  {
    std::vector<std::int32_t> triples = rightTriples(hexagon());
    triples[0] = id;
    const Verdict verdict = judge(hexagon(), triples);
    EXPECT_EQ(verdict.invented, 1u);
    EXPECT_FALSE(verdict.isRight());
  }
}

TEST(JudgeFaults, VerticesAreFoundByTheirCoordinates)
{
  std::vector<Point> vertices = hexagon();
  const std::vector<std::int32_t> triples = rightTriples(vertices);
  std::vector<Point> points(vertices.rbegin(), vertices.rend()); // other ids, the same places
  EXPECT_TRUE(judge(points, vertices, triples).isRight());
  vertices[6].x += 0x1p-50;
  const Verdict verdict = judge(points, vertices, triples);
  EXPECT_EQ(verdict.invented, 6u);
  EXPECT_EQ(verdict.lost, 1u);
}

TEST(JudgeFaults, NoTriangles)
{
  EXPECT_TRUE(judge({ { 0, 0 }, { 1, 2 }, { 2, 4 } }, {}).expected == 0u);
  const Verdict verdict = judge(hexagon(), {});
  EXPECT_EQ(verdict.lost, 7u);
  EXPECT_EQ(verdict.areaShare, 0.0);
  EXPECT_FALSE(verdict.isRight());
}

TEST(JudgeFaults, EveryCountSpoilsTheVerdict)
{
  const Verdict right = judge(hexagon(), rightTriples(hexagon()));
  for (std::size_t Verdict::*count : { &Verdict::lost, &Verdict::invented, &Verdict::degenerate,
         &Verdict::clockwise, &Verdict::overlaps, &Verdict::notDelaunay, &Verdict::triangles })
  {
    Verdict spoilt = right;
    ++(spoilt.*count);
    EXPECT_FALSE(spoilt.isRight()) << spoilt.json();
  }
  Verdict open = right;
  open.hullComplete = false;
  EXPECT_FALSE(open.isRight());
}

TEST(JudgeFaults, AreasAreExactFarFromTheOrigin)
{
  std::vector<Point> points;
  for (const Point& p : hexagon())
  {
    points.push_back({ 0x1p40 + p.x, -0x1p45 + p.y });
  }
  EXPECT_TRUE(judge(points, rightTriples(points)).isRight());
  points = { { 1e-300, 0 }, { 1e300, 1e-300 }, { 0, 1e300 } };
  EXPECT_TRUE(judge(points, { 0, 1, 2 }).isRight());
}

} // namespace
} // namespace test
} // namespace ahd
