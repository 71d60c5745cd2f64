// SPDX-License-Identifier: BSD-3-Clause
//
// The engine against the definition: brute force in rational arithmetic (Oracle.h) on small sets,
// where every cocircular and collinear case occurs.
#include "Distributions.h"
#include "EngineRun.h"
#include "ExactSigns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

/// Places on the 3 x 3 lattice are numbered 0 to 8, a set of them is a mask of 9 bits.
using Places = std::vector<std::size_t>;

Point latticePoint(std::size_t place)
{
  return { double(place / 3), double(place % 3) };
}

std::vector<Point> pointsAt(const Places& places)
{
  std::vector<Point> points;
  for (const std::size_t place : places)
  {
    points.push_back(latticePoint(place));
  }
  return points;
}

Places placesOf(unsigned mask)
{
  Places places;
  for (std::size_t place = 0; place < 9; ++place)
  {
    if ((mask >> place & 1u) != 0)
    {
      places.push_back(place);
    }
  }
  return places;
}

std::string textOf(const Places& places)
{
  std::string text = "lattice places";
  for (const std::size_t place : places)
  {
    text += " " + std::to_string(place);
  }
  return text;
}

/// Triangles by lattice place instead of id.
std::set<Triple> byPlace(const std::set<Triple>& byId, const Places& places)
{
  std::set<Triple> result;
  for (const Triple& ids : byId)
  {
    Triple triple;
    std::transform(ids.begin(), ids.end(), triple.begin(),
      [&](std::int32_t id) { return std::int32_t(places[std::size_t(id)]); });
    result.insert(smallestFirst(triple));
  }
  return result;
}

/// The oracle's answer for a set of places, computed once.
const std::set<Triple>& expectedAt(unsigned mask)
{
  static std::map<unsigned, std::set<Triple>> known;
  const auto found = known.find(mask);
  if (found != known.end())
  {
    return found->second;
  }
  const Places places = placesOf(mask);
  return known[mask] = byPlace(delaunayByDefinition(pointsAt(places)), places);
}

unsigned maskOf(const Places& places)
{
  unsigned mask = 0;
  for (const std::size_t place : places)
  {
    mask |= 1u << place;
  }
  return mask;
}

/// Runs the engine on points at these places, in this order and repeats allowed.
void expectDelaunay(Engine& engine, const Places& places, const Options& options)
{
  const std::vector<Point> points = pointsAt(places);
  const Outcome outcome = triangulate(engine, viewOf(points), options);
  ASSERT_EQ(outcome.status, Status::Ok) << textOf(places) << "; " << describe(options);
  ASSERT_EQ(byPlace(asSet(outcome.triples), places), expectedAt(maskOf(places)))
    << textOf(places) << "; " << describe(options);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto first = std::find(places.begin(), places.end(), places[i]) - places.begin();
    ASSERT_EQ(outcome.pointStatus[i], first) << "status of point " << i << " of " << textOf(places);
  }
  // A set has no repeats: the oracle would not see a triangle written twice.
  ASSERT_EQ(outcome.triples.size(), 3 * asSet(outcome.triples).size()) << textOf(places);
}

std::vector<unsigned> masksOfUpTo(int largest)
{
  std::vector<unsigned> masks;
  for (unsigned mask = 0; mask < 512; ++mask)
  {
    if (int(placesOf(mask).size()) <= largest)
    {
      masks.push_back(mask);
    }
  }
  return masks;
}

TEST(SmallSets, OracleBreaksTheTieOfASquareByItsLargestPoint)
{
  // (1, 1) is lifted most, so it lies outside the circle of the other three.
  const std::set<Triple> expected = { { 0, 1, 2 }, { 1, 3, 2 } };
  EXPECT_EQ(delaunayByDefinition({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } }), expected);
}

TEST(SmallSets, OracleIsCertified)
{
  for (const unsigned mask : masksOfUpTo(6))
  {
    const Places places = placesOf(mask);
    const std::vector<Point> points = pointsAt(places);
    std::vector<std::int32_t> triples;
    for (const Triple& triple : delaunayByDefinition(points))
    {
      triples.insert(triples.end(), triple.begin(), triple.end());
    }
    std::vector<std::int64_t> pointStatus(points.size());
    std::iota(pointStatus.begin(), pointStatus.end(), 0);
    ASSERT_EQ(joined(certify(viewOf(points), triples, pointStatus)), "") << textOf(places);
  }
}

TEST(SmallSets, EverySetInEveryOrder)
{
  Engine engine;
  for (const unsigned mask : masksOfUpTo(6))
  {
    Places places = placesOf(mask);
    do
    {
      ASSERT_NO_FATAL_FAILURE(expectDelaunay(engine, places, Options()));
    } while (std::next_permutation(places.begin(), places.end()));
  }
}

TEST(SmallSets, EverySetInTheCallersOrder)
{
  Options options;
  options.order = InsertionOrder::AsGiven;
  Engine engine;
  for (const unsigned mask : masksOfUpTo(6))
  {
    Places places = placesOf(mask);
    do
    {
      ASSERT_NO_FATAL_FAILURE(expectDelaunay(engine, places, options));
    } while (std::next_permutation(places.begin(), places.end()));
  }
}

TEST(SmallSets, EverySequenceOfFiveWithRepeats)
{
  Engine engine;
  for (std::size_t code = 0; code < 9 * 9 * 9 * 9 * 9; ++code)
  {
    Places places;
    for (std::size_t rest = code; places.size() < 5; rest /= 9)
    {
      places.push_back(rest % 9);
    }
    ASSERT_NO_FATAL_FAILURE(expectDelaunay(engine, places, Options()));
  }
}

TEST(SmallSets, EverySetUnderEverySetting)
{
  Engine engine;
  for (const Options& options : everySetting())
  {
    for (const unsigned mask : masksOfUpTo(6))
    {
      ASSERT_NO_FATAL_FAILURE(expectDelaunay(engine, placesOf(mask), options));
    }
  }
}

void expectDelaunay(const std::vector<Point>& points)
{
  const Outcome outcome = triangulate(points);
  ASSERT_EQ(asSet(outcome.triples), delaunayByDefinition(points)) << [&]
  {
    std::string text;
    for (const Point& p : points)
    {
      text += hexText(p) + "\n";
    }
    return text;
  }();
  ASSERT_EQ(faultsOf(points, outcome), "");
}

TEST(SmallSets, FewPointsOfEveryDistribution)
{
  for (const Distribution distribution : allDistributions())
  {
    for (std::uint64_t seed = 0; seed < 12; ++seed)
    {
      SCOPED_TRACE(std::string(nameOf(distribution)) + ", seed " + std::to_string(seed));
      ASSERT_NO_FATAL_FAILURE(
        expectDelaunay(makePoints(distribution, 5 + std::size_t(seed % 8), seed)));
    }
  }
}

/// Random points of a w x w lattice with steps (dx, dy) from an origin: many ties, odd coordinates.
std::vector<Point> onLattice(
  Random& random, std::size_t count, std::size_t width, const Point& step)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = double(random.below(width));
    const double y = double(random.below(width));
    points.push_back({ x * step.x, y * step.y });
  }
  return points;
}

TEST(SmallSets, LatticesOfManyScales)
{
  Random random(7);
  const double steps[] = { 1.0, 0.1, 1e-300, 1e299, 0x1p-1074, 0x1p-1022, 0x1p1020, 1e-12 };
  for (const double x : steps)
  {
    for (const double y : steps)
    {
      for (int repeat = 0; repeat < 4; ++repeat)
      {
        ASSERT_NO_FATAL_FAILURE(expectDelaunay(onLattice(random, 9, 4, { x, y })));
      }
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
