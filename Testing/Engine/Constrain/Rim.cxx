// SPDX-License-Identifier: BSD-3-Clause
//
// trim() against its definition, by brute force in exact arithmetic; and its purpose: grids in any
// plane keep the triangles of their squares, and no others.
#include "Prepare/Prepare.h"

#include "../Predicates/PredicatesOracle.h"
#include "ConstrainedRun.h"
#include "ConstraintOracle.h"
#include "Listeners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

// --- The definition

/// Triangles of a hull, and their neighbours.
struct Surface
{
  std::set<Triple> all;
  std::set<Triple> kept;
  std::set<EdgeIds> constraints;
};

EdgeIds edgeOf(const Triple& t, std::size_t e)
{
  const std::int32_t a = t[e], b = t[(e + 1) % 3];
  return { std::min(a, b), std::max(a, b) };
}

/// The number of the edge that the triangle is flat over; 3 if it is not flat.
std::size_t flatEdge(const std::vector<Point>& points, const Triple& t)
{
  const auto at = [&](std::size_t e) { return points[std::size_t(t[e % 3])]; };
  std::size_t e = 0;
  while (e < 3 && oracleFlatness(at(e), at(e + 1), at(e + 2)) >= 0)
  {
    ++e;
  }
  return e;
}

/// The triangles that trim() must leave: its definition, applied until nothing changes.
std::set<Triple> trimmedByDefinition(const std::vector<Point>& points, const Surface& surface)
{
  std::map<EdgeIds, std::vector<Triple>> sides;
  for (const Triple& t : surface.all)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      sides[edgeOf(t, e)].push_back(t);
    }
  }
  const auto beyond = [&](const Triple& t, std::size_t e)
  {
    const std::vector<Triple>& both = sides[edgeOf(t, e)];
    return both.size() < 2 ? nullptr : &both[both[0] == t ? 1 : 0];
  };
  const auto isBound = [&](const Triple& t, std::size_t e)
  { return surface.constraints.count(edgeOf(t, e)) != 0; };
  std::set<Triple> gone;
  const auto goes = [&](const Triple& t)
  {
    const std::size_t over = flatEdge(points, t);
    if (over == 3 || isBound(t, over))
    {
      return false;
    }
    for (std::size_t e = 0; e < 3; ++e)
    {
      const Triple* other = beyond(t, e);
      const bool isSafe = other && surface.kept.count(*other) != 0 &&
        (flatEdge(points, *other) == 3 || edgeOf(*other, flatEdge(points, *other)) == edgeOf(t, e));
      if (e != over && isBound(t, e) && !isSafe)
      {
        return false;
      }
    }
    const Triple* outside = beyond(t, over);
    return !outside || gone.count(*outside) != 0;
  };
  for (std::size_t before = 1; before != gone.size();)
  {
    before = gone.size();
    for (const Triple& t : surface.kept)
    {
      if (gone.count(t) == 0 && goes(t))
      {
        gone.insert(t);
        before = gone.size() + 1;
      }
    }
  }
  std::set<Triple> left;
  std::set_difference(surface.kept.begin(), surface.kept.end(), gone.begin(), gone.end(),
    std::inserter(left, left.end()));
  return left;
}

std::set<Triple> written(Triangulation& made)
{
  std::vector<std::int32_t> triples(3 * made.report().triangles);
  EXPECT_EQ(made.writeTriangles(triples.data(), Context()), Status::Ok);
  return asSet(triples);
}

std::set<std::int32_t> cornersOf(const std::set<Triple>& triangles)
{
  std::set<std::int32_t> corners;
  for (const Triple& t : triangles)
  {
    corners.insert(t.begin(), t.end());
  }
  return corners;
}

Status trimIn(Engine& engine, Progress* progress = nullptr)
{
  return trim(std::move(engine.made), { progress, nullptr }, engine.made);
}

/// Points near a curve that bends little, so that many triangles are flat.
std::vector<Point> smallSet(std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  const auto whole = [&](int most)
  { return double(int(random() % unsigned(2 * most + 1)) - most); };
  const int width = 2 + int(seed % 12), height = 1 + int(seed / 12 % 5);
  std::vector<Point> points(4 + seed % 10);
  for (Point& p : points)
  {
    const double x = whole(width);
    p = { x, whole(height) + (seed % 3 == 0 ? x * x : 0.0) };
  }
  return points;
}

TEST(Rim, SmallSetsAreTrimmedByTheDefinition)
{
  std::size_t trimmed = 0, bare = 0;
  for (std::uint64_t seed = 0; seed < 800; ++seed)
  {
    const std::vector<Point> points = smallSet(seed);
    const std::set<Triple> all = delaunayByDefinition(points);
    const std::set<Triple> expected = trimmedByDefinition(points, { all, all, {} });
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    ASSERT_EQ(trimIn(engine), Status::Ok);
    const Report report = engine.report();
    ASSERT_EQ(report.triangles, expected.size()) << "seed " << seed;
    ASSERT_EQ(report.trimmed, all.size() - expected.size());
    ASSERT_EQ(report.bareVertices, cornersOf(all).size() - cornersOf(expected).size());
    ASSERT_EQ(written(engine.made), expected) << "seed " << seed;
    trimmed += report.trimmed;
    bare += report.bareVertices;
  }
  EXPECT_GT(trimmed, 500u);
  EXPECT_GT(bare, 50u);
}

TEST(Rim, ConstraintsStayEdges)
{
  std::size_t trimmed = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed)
  {
    ConstraintCase given = smallConstraintCase(seed);
    for (Point& p : given.points)
    {
      p.y /= 8; // exact on a lattice, and flat
    }
    for (const FillRule rule : kFillRules)
    {
      const ConstrainedByDefinition defined = constrainedByDefinition(
        given.view(), given.constraints.view(), rule);
      const std::set<Triple> expected = trimmedByDefinition(
        given.points, { defined.all, defined.kept, defined.edges });
      Engine engine;
      ASSERT_EQ(engine.run(given.view()), Status::Ok);
      ASSERT_EQ(engine.constrain(given.constraints.view(), rule), Status::Ok);
      ASSERT_EQ(trimIn(engine), Status::Ok);
      ASSERT_EQ(written(engine.made), expected) << given.text();
      std::set<EdgeIds> left;
      for (const Triple& t : expected)
      {
        for (std::size_t e = 0; e < 3; ++e)
        {
          left.insert(edgeOf(t, e));
        }
      }
      for (const Triple& t : defined.kept)
      {
        for (std::size_t e = 0; e < 3; ++e)
        {
          ASSERT_TRUE(defined.edges.count(edgeOf(t, e)) == 0 || left.count(edgeOf(t, e)) != 0)
            << "a constraint was lost\n"
            << given.text();
        }
      }
      trimmed += engine.report().trimmed;
    }
  }
  EXPECT_GT(trimmed, 100u);
}

// --- Grids in space

using Place = std::array<double, 3>;

struct Grid
{
  const char* name;
  std::size_t n, m;
  double slope, noise, hills;
};

/// Row by row, turned any way, at coordinates as large as those of maps.
std::vector<Place> placesOf(const Grid& grid, unsigned seed)
{
  std::mt19937_64 random(seed);
  const auto fraction = [&] { return double(random() >> 11) * 0x1p-53; };
  const double azimuth = 6.28 * fraction(), turnX = seed == 0 ? 0.0 : 6.28 * fraction();
  const double turnZ = seed == 0 ? 0.0 : 6.28 * fraction();
  const double side = double(std::max(grid.n, grid.m));
  std::vector<Place> places;
  for (std::size_t i = 0; i < grid.n; ++i)
  {
    for (std::size_t k = 0; k < grid.m; ++k)
    {
      const double x = double(i), y = double(k);
      const double z = grid.slope * (x * std::cos(azimuth) + y * std::sin(azimuth)) +
        grid.noise * fraction() +
        grid.hills * side * std::sin(9.4 * x / side + 0.3) * std::cos(9.4 * y / side + 0.7);
      const double v = y * std::cos(turnX) - z * std::sin(turnX);
      places.push_back({ { 450000.0 + x * std::cos(turnZ) - v * std::sin(turnZ),
        5600000.0 + x * std::sin(turnZ) + v * std::cos(turnZ),
        800.0 + y * std::sin(turnX) + z * std::cos(turnX) } });
    }
  }
  return places;
}

double areaOf(const std::vector<Place>& places, const std::set<Triple>& triangles)
{
  double area = 0.0;
  for (const Triple& t : triangles)
  {
    const Place &a = places[std::size_t(t[0])], &b = places[std::size_t(t[1])],
                &c = places[std::size_t(t[2])];
    Place u, v;
    for (std::size_t k = 0; k < 3; ++k)
    {
      u[k] = b[k] - a[k];
      v[k] = c[k] - a[k];
    }
    area += 0.5 *
      std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }
  return area;
}

/// The squares cut along one diagonal, or the other.
std::set<Triple> squaresOf(const Grid& grid, bool isOther)
{
  std::set<Triple> triangles;
  for (std::size_t i = 0; i + 1 < grid.n; ++i)
  {
    for (std::size_t k = 0; k + 1 < grid.m; ++k)
    {
      const std::int32_t a = std::int32_t(i * grid.m + k), b = a + 1;
      const std::int32_t c = a + std::int32_t(grid.m), d = c + 1;
      triangles.insert(isOther ? Triple{ a, b, c } : Triple{ a, b, d });
      triangles.insert(isOther ? Triple{ b, d, c } : Triple{ a, d, c });
    }
  }
  return triangles;
}

constexpr Grid kGrids[] = {
  { "plane", 10, 10, 0.1, 0, 0 },
  { "level", 30, 40, 0, 0, 0 },
  { "slope", 40, 60, 0.5, 0, 0 },
  { "45 degrees", 100, 100, 1, 0, 0 },
  { "strip", 7, 300, 0.7, 0, 0 },
  { "two rows", 2, 50, 1, 0, 0 },
  { "little noise", 40, 60, 0, 0.1, 0 },
  { "noise", 40, 60, 0, 1, 0 },
  { "few points, noise", 10, 10, 0, 1, 0 },
  { "hills", 40, 60, 0, 0, 0.05 },
  { "hills on a slope", 40, 60, 0.5, 0, 0.04 },
  { "hills on a steep slope", 100, 100, 1, 0, 0.03 },
};

TEST(Rim, GridsInAnyPlaneKeepTheTrianglesOfTheirSquares)
{
  for (const Grid& grid : kGrids)
  {
    for (unsigned seed = 0; seed < 6; ++seed)
    {
      SCOPED_TRACE(std::string(grid.name) + ", turned by seed " + std::to_string(seed));
      const std::vector<Place> places = placesOf(grid, seed);
      InputRequest request;
      request.points = PointView(places[0].data(), places.size(), 3);
      request.fitPlane = true;
      PreparedInput prepared;
      ASSERT_EQ(prepare(request, Context(), prepared), Status::Ok);
      const Outcome whole = triangulate(prepared.points());
      ASSERT_EQ(faultsOf(prepared.points(), whole), "");
      Engine engine;
      ASSERT_EQ(engine.run(prepared.points()), Status::Ok);
      ASSERT_EQ(trimIn(engine), Status::Ok);
      EXPECT_EQ(engine.report().triangles, 2 * (grid.n - 1) * (grid.m - 1));
      EXPECT_EQ(engine.report().triangles + engine.report().trimmed, whole.report.triangles);
      EXPECT_EQ(engine.report().bareVertices, 0u);
      EXPECT_LT(engine.report().trimmedArea, 0.1);
      const double one = areaOf(places, squaresOf(grid, false));
      const double other = areaOf(places, squaresOf(grid, true));
      const double area = areaOf(places, written(engine.made));
      EXPECT_GT(area, 0.99 * std::min(one, other));
      EXPECT_LT(area, 1.01 * std::max(one, other));
    }
  }
}

// --- The result depends on the points alone

std::vector<Point> wavyStrip(std::size_t n)
{
  std::vector<Point> points = makePoints(Distribution::Uniform, n, 7);
  for (Point& p : points)
  {
    p.y = 0.03 * p.y + 0.1 * p.x * (1 - p.x);
  }
  return points;
}

std::vector<std::int32_t> trimmedTriples(
  const std::vector<Point>& points, const Options& options, Executor* executor)
{
  Engine engine;
  EXPECT_EQ(engine.run(viewOf(points), options, nullptr, executor), Status::Ok);
  EXPECT_EQ(trim(std::move(engine.made), { nullptr, executor }, engine.made), Status::Ok);
  std::vector<std::int32_t> triples(3 * engine.report().triangles);
  EXPECT_EQ(engine.writeTriangles(triples.data(), nullptr, executor), Status::Ok);
  return triples;
}

TEST(Rim, OrdersAndThreadsDoNotDecide)
{
  const std::vector<Point> points = wavyStrip(reduced(40000));
  const std::vector<std::int32_t> expected = trimmedTriples(points, Options(), nullptr);
  ASSERT_LT(expected.size(), triangulate(points).triples.size());
  ThreadExecutor threads(3);
  EXPECT_EQ(trimmedTriples(points, Options(), &threads), expected);
  for (const Options& options : everyDistinctSetting({ 50 }))
  {
    EXPECT_EQ(trimmedTriples(points, options, nullptr), expected) << describe(options);
  }
}

TEST(Rim, ScaleAndOrderOfThePointsDoNotDecide)
{
  const std::vector<Point> points = wavyStrip(2000);
  const std::vector<std::int32_t> expected = trimmedTriples(points, Options(), nullptr);
  for (const int exponent : { -900, -3, 40, 900 })
  {
    std::vector<Point> scaled = points;
    for (Point& p : scaled)
    {
      p = { std::ldexp(p.x, exponent), std::ldexp(p.y, exponent) };
    }
    EXPECT_EQ(trimmedTriples(scaled, Options(), nullptr), expected) << exponent;
  }
  std::vector<std::int32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  std::vector<Point> shuffled;
  for (const std::int32_t id : order)
  {
    shuffled.push_back(points[std::size_t(id)]);
  }
  std::vector<std::int32_t> result = trimmedTriples(shuffled, Options(), nullptr);
  for (std::int32_t& id : result)
  {
    id = order[std::size_t(id)];
  }
  EXPECT_EQ(result, expected);
}

TEST(Rim, TablesSayWhatWent)
{
  const std::vector<Point> points = wavyStrip(3000);
  for (const bool areMadeBefore : { false, true })
  {
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    if (areMadeBefore)
    {
      ASSERT_EQ(engine.made.makeNeighbors(Context()), Status::Ok);
    }
    ASSERT_EQ(trimIn(engine), Status::Ok);
    const std::set<Triple> expected = written(engine.made);
    ASSERT_EQ(engine.made.makeNeighbors(Context()), Status::Ok);
    std::set<Triple> kept;
    for (std::size_t t = 0; t < engine.made.triangleCount(); ++t)
    {
      if (engine.made.isKept(t))
      {
        Triple corners{};
        for (std::size_t e = 0; e < 3; ++e)
        {
          const HalfEdge h = HalfEdge(3 * t + e);
          corners[e] = std::int32_t(engine.made.pointOf(engine.made.origin(h)));
          EXPECT_FALSE(engine.made.isConstrained(h));
        }
        kept.insert(smallestFirst(corners));
      }
    }
    EXPECT_EQ(kept, expected);
    EXPECT_EQ(written(engine.made), expected);
    std::vector<std::int64_t> neighbors(3 * expected.size());
    ASSERT_EQ(engine.writeNeighbors(neighbors.data()), Status::Ok);
    EXPECT_LT(*std::max_element(neighbors.begin(), neighbors.end()), std::int64_t(expected.size()));
    const Report once = engine.report();
    ASSERT_EQ(trimIn(engine), Status::Ok);
    EXPECT_EQ(engine.report().triangles, once.triangles) << "what is trimmed is not trimmed again";
    EXPECT_EQ(engine.report().trimmed, once.trimmed);
  }
}

TEST(Rim, AllMayGo)
{
  Engine engine;
  const std::vector<Point> points = { { 0, 0 }, { 8, 0 }, { 4, 0.5 } };
  ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
  ASSERT_EQ(trimIn(engine), Status::Ok);
  EXPECT_EQ(engine.report().triangles, 0u);
  EXPECT_EQ(engine.report().trimmed, 1u);
  EXPECT_EQ(engine.report().bareVertices, 3u);
  EXPECT_EQ(engine.report().trimmedArea, 1.0);
  EXPECT_EQ(written(engine.made).size(), 0u);
  std::vector<std::int64_t> status(3);
  ASSERT_EQ(engine.writePointStatus(status.data()), Status::Ok);
  EXPECT_EQ(status, (std::vector<std::int64_t>{ 0, 1, 2 })) << "vertices stay vertices";
}

TEST(Rim, NothingIsTrimmedOfNothing)
{
  for (const std::vector<Point>& points :
    { std::vector<Point>{}, { { 1, 1 } }, { { 0, 0 }, { 1, 1 }, { 2, 2 } } })
  {
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    ASSERT_EQ(trimIn(engine), Status::Ok);
    EXPECT_EQ(engine.report().triangles + engine.report().trimmed, 0u);
    EXPECT_EQ(engine.report().inserted, points.size());
  }
  Triangulation none;
  EXPECT_EQ(trim(Triangulation(), Context(), none), Status::Ok);
  EXPECT_EQ(none.report().triangles, 0u);
}

TEST(Rim, ItCanBeCancelledAtEveryAsking)
{
  const std::vector<Point> points = wavyStrip(reduced(60000));
  Listener all;
  Engine engine;
  ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
  ASSERT_EQ(trimIn(engine, &all), Status::Ok);
  EXPECT_EQ(all.phases(), (std::vector<Phase>{ Phase::Outputs }));
  ASSERT_GT(all.askings(), 3u);
  for (std::size_t at = 1; at <= all.askings(); ++at)
  {
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    Listener listener(at);
    ASSERT_EQ(trimIn(engine, &listener), Status::Cancelled);
    EXPECT_EQ(listener.askings(), at);
    EXPECT_EQ(engine.made.vertexCount(), 0u);
  }
}

} // namespace
} // namespace test
} // namespace ahd
