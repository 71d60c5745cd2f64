// SPDX-License-Identifier: BSD-3-Clause
//
// Locations of places: each against its definition, on small sets at every place of a finer
// lattice and from every triangle, on large ones from near and far and from several threads; with
// constraints, where a walk could go round in circles, and by the search that follows if it does.
#include "ConstraintMakers.h"
#include "EngineRun.h"
#include "Random.h"

#include "Predicates/Predicates.h"
#include "Triangulation/Locate.h"
#include "Triangulation/State.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

namespace ahd
{
namespace test
{
namespace
{

int side(const Triangulation& made, HalfEdge h, const Point& place)
{
  return orient2d(made.at(made.origin(h)), made.at(made.target(h)), place);
}

bool isBetweenEnds(const Triangulation& made, HalfEdge h, const Point& place)
{
  const Point a = made.at(made.origin(h)), b = made.at(made.target(h));
  return side(made, h, place) == 0 &&
    lexicographicallyLess(std::min(a, b, lexicographicallyLess), place) &&
    lexicographicallyLess(place, std::max(a, b, lexicographicallyLess));
}

/// The error of the answer; empty if it is correct. Only one answer is, except for the edge of the
/// hull that a place outside lies beyond.
std::string faultOf(const Triangulation& made, const Point& place, const Location& found)
{
  const HalfEdge h = found.halfEdge;
  switch (found.kind)
  {
    case Location::InTriangle:
      return h % 3 == 0 && side(made, h, place) > 0 && side(made, h + 1, place) > 0 &&
          side(made, h + 2, place) > 0
        ? ""
        : "not inside of the triangle";
    case Location::OnEdge:
      return isBetweenEnds(made, h, place) && h < made.twin(h) ? "" : "not on the edge";
    case Location::OnVertex:
      return made.at(made.origin(h)) == place && h == made.start(made.origin(h))
        ? ""
        : "not on the vertex";
    case Location::Outside:
      return made.twin(h) == kNoHalfEdge && side(made, h, place) < 0 ? "" : "not beyond the edge";
    default:
      return made.triangleCount() == 0 || !isFinite(place) ? "" : "it is somewhere";
  }
}

/// From every triangle, and as if each walk went in circles.
void expectLocated(const Triangulation& made, const Point& place)
{
  const Location first = made.locate(place);
  ASSERT_EQ(faultOf(made, place, first), "") << place.x << " " << place.y;
  if (made.triangleCount() == 0)
  {
    return;
  }
  const auto& state = *TriangulationAccess::stateOf(made);
  const Locator locator(state.tables, state.ranked.xy.data());
  for (std::size_t hint = 0; hint <= made.triangleCount(); ++hint)
  {
    const Location found = made.locate(place, hint);
    ASSERT_EQ(found.kind, first.kind) << "from " << hint;
    ASSERT_EQ(faultOf(made, place, found), "") << "from " << hint;
    ASSERT_TRUE(found.kind == Location::Outside || found.halfEdge == first.halfEdge);
    const Location again = made.locate(place, hint);
    ASSERT_EQ(again.halfEdge, found.halfEdge);
  }
  for (const std::size_t steps : { 0, 1, 2 })
  {
    Ticker nobody(nullptr, Phase::Outputs, 0);
    const Location looked = locator.locate(place, made.triangleCount() - 1, steps, nobody);
    ASSERT_EQ(looked.kind, first.kind) << "after " << steps;
    ASSERT_EQ(faultOf(made, place, looked), "") << "after " << steps;
  }
}

void expectAllPlacesLocated(const Triangulation& made, double low, double high, double step)
{
  for (double y = low; y <= high; y += step)
  {
    for (double x = low; x <= high; x += step)
    {
      ASSERT_NO_FATAL_FAILURE(expectLocated(made, { x, y }));
    }
  }
}

TEST(Locate, AllPlacesAmongAllSmallSets)
{
  Engine engine;
  for (unsigned mask = 0; mask < 1u << 9; ++mask)
  {
    std::vector<Point> points;
    for (unsigned k = 0; k < 9; ++k)
    {
      if ((mask >> k & 1u) != 0)
      {
        points.push_back({ double(k % 3), double(k / 3) });
      }
    }
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
    SCOPED_TRACE(mask);
    ASSERT_NO_FATAL_FAILURE(expectAllPlacesLocated(engine.made, -1.0, 3.0, 0.5));
  }
}

TEST(Locate, AllPlacesAmongSmallConstrainedSets)
{
  for (std::uint64_t seed = 0; seed < reduced(300); ++seed)
  {
    const ConstraintCase given = smallConstraintCase(seed);
    Engine engine;
    ASSERT_EQ(engine.run(given.view()), Status::Ok);
    ASSERT_EQ(engine.constrain(given.constraints.view(), FillRule::EvenOdd), Status::Ok);
    ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
    SCOPED_TRACE(given.text());
    ASSERT_NO_FATAL_FAILURE(expectAllPlacesLocated(engine.made, -1.0, 6.0, 0.5));
  }
}

TEST(Locate, WhatIsNotFiniteIsNowhere)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Engine engine;
  EXPECT_EQ(engine.made.locate({ 0, 0 }).kind, Location::Nowhere) << "of no points";
  ASSERT_EQ(engine.run(viewOf(makePoints(Distribution::Uniform, 100, 1))), Status::Ok);
  ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
  for (const Point p :
    { Point{ kNaN, 0.5 }, Point{ 0.5, kNaN }, Point{ kInfinity, 0.5 }, Point{ 0.5, -kInfinity } })
  {
    EXPECT_EQ(engine.made.locate(p).kind, Location::Nowhere);
    EXPECT_EQ(engine.made.locate(p).halfEdge, kNoHalfEdge);
  }
}

/// Places near and far, on vertices and on edges, each from where the last one was found and from
/// afar.
void expectManyLocated(const Triangulation& made, const std::vector<Point>& points,
  std::uint64_t seed, std::size_t count)
{
  Random random(seed);
  std::size_t hint = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point a = points[random.below(points.size())], b = points[random.below(points.size())];
    const double t = random.below(4) == 0 ? 0.0 : 1.5 * random.unit() - 0.25;
    const Point place{ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) };
    const Location found = made.locate(place, hint);
    ASSERT_EQ(faultOf(made, place, found), "") << place.x << " " << place.y;
    hint = i % 16 == 0 ? random.below(made.triangleCount()) : found.halfEdge / 3;
  }
}

TEST(Locate, AmongManyPoints)
{
  for (const Distribution d : { Distribution::Uniform, Distribution::NestedClusters,
         Distribution::Lattice, Distribution::OnCircle, Distribution::Slivers, Distribution::Utm })
  {
    SCOPED_TRACE(nameOf(d));
    const std::vector<Point> points = makePoints(d, reduced(20000), 3);
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
    ASSERT_NO_FATAL_FAILURE(expectManyLocated(engine.made, points, 1, reduced(2000)));
  }
}

TEST(Locate, AmongConstraintsFromSeveralThreads)
{
  const ConstraintCase all[] = { starPolygon(500), shortSegments(5000, 1000),
    segmentAcrossBulges(1000), nestedLoops(30), spiralLine(2000, 20), segmentAcrossCombs(500) };
  for (const ConstraintCase& given : all)
  {
    Engine engine;
    ASSERT_EQ(engine.run(given.view()), Status::Ok);
    ASSERT_EQ(engine.constrain(given.constraints.view(), FillRule::Orientation), Status::Ok);
    ASSERT_EQ(engine.made.makeNeighbors({}), Status::Ok);
    std::vector<std::thread> threads;
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      threads.emplace_back(
        [&, seed] { expectManyLocated(engine.made, given.points, seed, reduced(2000)); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
