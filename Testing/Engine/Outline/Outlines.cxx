// SPDX-License-Identifier: BSD-3-Clause
//
// outline() by its definition: each edge of the boundary once, with the polygon on its left, in
// simple rings; areas as whole numbers; figures whose rings are known.
#include "OutlineCase.h"

#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

using Corner = std::array<double, 3>;
using Directed = std::pair<Corner, Corner>;

/// The corners of a cell, counterclockwise in x, y.
std::vector<Corner> cornersOf(const OutlineCase& given, std::size_t cell)
{
  std::vector<Corner> corners;
  for (const std::int64_t id : given.cell(cell))
  {
    corners.push_back(given.points[std::size_t(id)]);
  }
  if (areaOf(corners) < 0)
  {
    std::reverse(corners.begin(), corners.end());
  }
  return corners;
}

std::vector<Directed> edgesOf(const std::vector<Corner>& ring)
{
  std::vector<Directed> edges;
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    edges.emplace_back(ring[k], ring[(k + 1) % ring.size()]);
  }
  return edges;
}

/// By brute force: which cells are joined.
struct Joined
{
  explicit Joined(const OutlineCase& given)
    : root(given.cellCount())
  {
    std::iota(root.begin(), root.end(), std::size_t(0));
    std::map<std::pair<Directed, double>, std::size_t> left;
    for (std::size_t c = 0; c < root.size(); ++c)
    {
      for (const Directed& edge : edgesOf(cornersOf(given, c)))
      {
        EXPECT_TRUE(left.emplace(std::pair(edge, given.group(c)), c).second);
      }
    }
    for (const auto& [key, cell] : left)
    {
      const Directed twin(key.first.second, key.first.first);
      const auto other = left.find({ twin, key.second });
      if (other == left.end())
      {
        boundary[key.first].push_back(cell);
      }
      else
      {
        join(cell, other->second);
      }
    }
  }

  std::size_t find(std::size_t cell) const { return root[cell] == cell ? cell : find(root[cell]); }
  void join(std::size_t a, std::size_t b)
  {
    const std::size_t p = find(a), q = find(b);
    root[std::max(p, q)] = std::min(p, q);
  }

  std::vector<std::size_t> root;
  std::map<Directed, std::vector<std::size_t>> boundary; ///< the cells on the left of each edge
};

/// @pre whole coordinates, cells that do not overlap
void expectDefinition(const OutlineCase& given)
{
  const Outline made = given.outline();
  Joined joined(given);
  std::set<std::size_t> roots;
  std::map<std::size_t, double> areas;
  for (std::size_t c = 0; c < given.cellCount(); ++c)
  {
    roots.insert(joined.find(c));
    areas[joined.find(c)] += areaOf(cornersOf(given, c));
  }
  const Polygons polygons = polygonsOf(given, made);
  ASSERT_EQ(polygons.size(), roots.size());
  for (std::size_t k = 0; k < polygons.size(); ++k)
  {
    const std::size_t root = joined.find(made.cells[k]);
    EXPECT_EQ(root, made.cells[k]) << "the first cell of its polygon";
    double area = 0.0;
    for (const auto& ring : polygons[k])
    {
      EXPECT_EQ(std::set<Corner>(ring.begin(), ring.end()).size(), ring.size());
      EXPECT_EQ(*std::min_element(ring.begin(), ring.end()), ring[0]);
      EXPECT_EQ(areaOf(ring) > 0, &ring == &polygons[k][0]);
      area += areaOf(ring);
      for (const Directed& edge : edgesOf(ring))
      {
        auto& cells = joined.boundary[edge];
        const auto cell = std::find_if(
          cells.begin(), cells.end(), [&](std::size_t c) { return joined.find(c) == root; });
        ASSERT_NE(cell, cells.end()) << "no edge of the boundary, or one that is there twice";
        cells.erase(cell);
      }
    }
    EXPECT_EQ(area, areas[root]);
  }
  for (const auto& edge : joined.boundary)
  {
    EXPECT_TRUE(edge.second.empty()) << "an edge of the boundary is missing";
  }
}

/// Rings, polygons and holes in the order that is promised.
void expectOrder(const OutlineCase& given, const Polygons& polygons, const Outline& made)
{
  const auto follows = [](const std::vector<Corner>& a, const std::vector<Corner>& b)
  { return std::pair(a[0], a[1]) < std::pair(b[0], b[1]); };
  for (std::size_t k = 0; k < polygons.size(); ++k)
  {
    for (std::size_t r = 2; r < polygons[k].size(); ++r)
    {
      EXPECT_TRUE(follows(polygons[k][r - 1], polygons[k][r]));
    }
    if (k > 0)
    {
      const double before = given.group(made.cells[k - 1]), now = given.group(made.cells[k]);
      EXPECT_TRUE(before < now || (before == now && follows(polygons[k - 1][0], polygons[k][0])));
    }
  }
}

TEST(Outlines, SomeTrianglesOfGridsAreOutlinedByDefinition)
{
  Random random(1);
  for (int round = 0; round < 400; ++round)
  {
    OutlineCase given = gridOf(2 + random.below(12), 2 + random.below(12), random);
    given.dropSome(1 + random.below(9), random);
    given.groupThem(random.below(4), random);
    ASSERT_NO_FATAL_FAILURE(expectDefinition(given)) << "round " << round;
    const Outline made = given.outline();
    const Polygons polygons = polygonsOf(given, made);
    expectOrder(given, polygons, made);
    EXPECT_EQ(made.unfitCells, 0u);
    EXPECT_EQ(made.unfitEdges, 0u);
    EXPECT_EQ(given.outline(true).corners, made.corners); // they are counterclockwise
    given.shuffle(random); // ids, cells, their directions and first corners; points of their own
    EXPECT_EQ(polygonsOf(given, given.outline()), polygons) << "round " << round;
  }
}

/// A square of unit squares, each two triangles; '.' is left out.
OutlineCase drawn(const std::vector<std::string>& rows)
{
  OutlineCase given;
  for (std::size_t y = 0; y < rows.size(); ++y)
  {
    for (std::size_t x = 0; x < rows[y].size(); ++x)
    {
      if (rows[rows.size() - 1 - y][x] != '.')
      {
        given.addSquare(double(x), double(y));
      }
    }
  }
  return given;
}

std::vector<std::size_t> ringCounts(const std::vector<std::string>& rows)
{
  std::vector<std::size_t> counts;
  const OutlineCase given = drawn(rows);
  expectDefinition(given);
  for (const auto& polygon : polygonsOf(given, given.outline()))
  {
    counts.push_back(polygon.size());
  }
  return counts;
}

TEST(Outlines, FiguresHaveTheirHolesAndIslands)
{
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(ringCounts({ "x" }), Counts({ 1 }));
  EXPECT_EQ(ringCounts({ "xxx", "x.x", "xxx" }), Counts({ 2 }));
  EXPECT_EQ(ringCounts({ "xxxxx", "x...x", "x.x.x", "x...x", "xxxxx" }), Counts({ 2, 1 }));
  EXPECT_EQ(
    ringCounts({ "xxxxxxx", "x.....x", "x.xxx.x", "x.x.x.x", "x.xxx.x", "x.....x", "xxxxxxx" }),
    Counts({ 2, 2 }));
  EXPECT_EQ(ringCounts({ ".x", "x." }), Counts({ 1, 1 }));                  // touch at a vertex
  EXPECT_EQ(ringCounts({ "xxxx", "x.xx", "xx.x", "xxxx" }), Counts({ 3 })); // holes that touch
  EXPECT_EQ(ringCounts({ "xxxx", "x.xx", "xx..", "xxx." }), Counts({ 2 })); // one touches outside
  EXPECT_EQ(ringCounts({ ".xx", "x.x", "xxx" }), Counts({ 2 }));            // a C whose ends touch
  EXPECT_EQ(ringCounts({ "x.x", ".x.", "x.x" }), Counts({ 1, 1, 1, 1, 1 }));
  EXPECT_EQ(ringCounts({ "...", "..." }), Counts());
}

/// A hole that touches the outer ring at the smallest vertex of both.
TEST(Outlines, AHoleAtTheFirstVertexIsNoOuterRing)
{
  const std::vector<std::vector<std::int64_t>> cells = { { 0, 1, 2 }, { 1, 4, 3, 2 }, { 0, 3, 4 } };
  for (std::size_t first = 0; first < 3; ++first) // either ring is found first
  {
    OutlineCase given;
    given.points = { { 0, 0, 0 }, { 9, -9, 0 }, { 5, -1, 0 }, { 5, 1, 0 }, { 9, 9, 0 } };
    for (std::size_t k = 0; k < 3; ++k)
    {
      given.addCell(cells[(first + k) % 3]);
    }
    const Outline made = given.outline();
    EXPECT_EQ(made.rings, std::vector<Index>({ 0, 3, 6 }));
    EXPECT_EQ(made.polygons, std::vector<Index>({ 0, 2 }));
    EXPECT_EQ(made.corners, std::vector<Index>({ 0, 1, 4, 0, 3, 2 }));
  }
}

TEST(Outlines, NothingHasNoRing)
{
  OutlineCase none;
  EXPECT_EQ(none.outline().rings, std::vector<Index>({ 0 }));
  EXPECT_EQ(none.outline().polygons, std::vector<Index>({ 0 }));
  OutlineCase all = drawn({ "xx", "xx" });
  all.groups.assign(all.cellCount(), std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(all.outline().corners.empty());
  EXPECT_EQ(all.outline().unfitCells, 0u) << "left out on request";
}

TEST(Outlines, UnfitCellsAreLeftOutAndCounted)
{
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  OutlineCase given = drawn({ "xx", "x." });
  const Polygons before = polygonsOf(given, given.outline());
  const auto unfit = std::int64_t(given.points.size());
  given.points.push_back({ kNan, 0, 0 });
  given.points.push_back({ 1, 1, 0 }); // a corner once more
  given.points.push_back({ 0, 1, 0 });
  for (const auto& cell : std::vector<std::vector<std::int64_t>>{ { 0, 1, unfit }, { 0, 1, -1 },
         { 0, 1, unfit + 9 }, { 0, 1 }, { 0 }, {}, { 0, 1, 0, 1 }, { unfit + 1, unfit + 2 } })
  {
    given.addCell(cell);
  }
  const Outline made = given.outline();
  EXPECT_EQ(polygonsOf(given, made), before);
  EXPECT_EQ(made.unfitCells, 8u);
  EXPECT_EQ(made.unfitEdges, 0u);
}

TEST(Outlines, IdsOfNoCellAreNotRead)
{
  OutlineCase given = drawn({ "x" });
  const std::vector<Index> corners = given.outline().corners;
  given.ids = { 9, -1, 77, 0, 1, 2, 0, 2, 3, 3, 1 };
  given.offsets = { 3, 6, 9 };
  EXPECT_EQ(given.outline().corners, corners);
  given.ids = { 0, 1, 2, 0, 2, 3, 3, 1, 2 };
  given.offsets = { 0, 3, 6, 8 }; // a third triangle, but for a corner
  EXPECT_EQ(given.outline().corners, corners);
  EXPECT_EQ(given.outline().unfitCells, 1u);
  given.offsets = { 0 };
  EXPECT_TRUE(given.outline().corners.empty());
}

TEST(Outlines, RepeatedCornersAndWaysBackAreNoEdges)
{
  OutlineCase given;
  given.points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 }, { 2, 2, 0 }, { 0, 0, 0 } };
  given.addCell({ 0, 1, 1, 2, 3, 5 }); // ends at the place where it begins
  EXPECT_EQ(given.outline().corners, std::vector<Index>({ 0, 1, 2, 3 }));
  given.addCell({ 0, 1, 2, 4, 2, 3 });
  given.groups = { 0, 1 };
  EXPECT_EQ(given.outline().corners, std::vector<Index>({ 0, 1, 2, 3, 0, 1, 2, 3 }));
  OutlineCase joined; // of two cells, at an edge that a third one passes both ways
  joined.points = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 4, 0 }, { 2, -4, 0 }, { -4, 1, 0 },
    { -4, -1, 0 } };
  joined.addCell({ 0, 1, 2 });
  joined.addCell({ 1, 0, 3 });
  joined.addCell({ 4, 0, 1, 0, 5 });
  EXPECT_EQ(joined.outline().unfitEdges, 0u);
  EXPECT_EQ(joined.outline().corners, std::vector<Index>({ 5, 0, 4, 0, 3, 1, 2 }));
}

TEST(Outlines, HeightsThatAreNoNumbersMatterNot)
{
  OutlineCase given = drawn({ "xxx", "x.x", "xxx" });
  const Outline before = given.outline();
  for (auto& point : given.points)
  {
    point[2] = point[0] == 1 ? std::numeric_limits<double>::quiet_NaN() : point[0] * point[1];
  }
  EXPECT_EQ(given.outline().corners, before.corners);
  EXPECT_EQ(given.outline().plane, OutlinePlane::Xy);
}

/// The same figure on edge, and with hills.
TEST(Outlines, WallsAreOutlinedInTheirPlane)
{
  const OutlineCase flat = drawn({ "xxxxx", "x...x", "x.x.x", "x...x", "xxxxx" });
  const Outline before = flat.outline();
  OutlineCase wall = flat;
  for (std::size_t i = 0; i < flat.points.size(); ++i)
  {
    const auto& p = flat.points[i];
    wall.points[i] = { 0.25 * double((i * 7) % 3), p[0], p[1] };
  }
  EXPECT_EQ(wall.outline().plane, OutlinePlane::Yz);
  EXPECT_EQ(wall.outline().corners, before.corners);
  for (std::size_t i = 0; i < flat.points.size(); ++i)
  {
    const auto& p = flat.points[i];
    wall.points[i] = { p[1], 0.25 * double((i * 7) % 3), p[0] };
  }
  EXPECT_EQ(wall.outline().plane, OutlinePlane::Zx);
  EXPECT_EQ(wall.outline().corners, before.corners);
}

/// A sheet that comes back above itself, further along z than along x: x, y as long as no more than
/// a tenth of its area turns the other way there.
TEST(Outlines, AFoldOfATenthChangesThePlane)
{
  const auto planeOf = [](double back)
  {
    OutlineCase sheet;
    sheet.points = { { 0, 0, 0 }, { 0, 1, 0 }, { 100, 0, 0 }, { 100, 1, 0 }, { 100 - back, 0, 200 },
      { 100 - back, 1, 200 } };
    sheet.addCell({ 0, 2, 3, 1 });
    sheet.addCell({ 2, 4, 5, 3 });
    return sheet.outline().plane;
  };
  EXPECT_EQ(planeOf(10), OutlinePlane::Xy);
  EXPECT_EQ(planeOf(12), OutlinePlane::Yz);
}

/// So many places that some have equal hashes; each is there twice, once with the other zero.
TEST(Outlines, ManyPlacesStayApart)
{
  constexpr std::size_t kSide = 250;
  Random random(3);
  OutlineCase apart;
  for (std::size_t k = 0; k < kSide * kSide; ++k)
  {
    const double x = double(3 * (k % kSide)) + random.unit(),
                 y = double(3 * (k / kSide)) + random.unit();
    const auto first = std::int64_t(apart.points.size());
    apart.points.insert(apart.points.end(),
      { { x, y, 0 }, { x + 1, y, 0 }, { x + 1, y + 1, 0 }, { x, y, -0.0 }, { x + 1, y + 1, -0.0 },
        { x, y + 1, 0 } });
    apart.addCell({ first, first + 1, first + 2 });
    apart.addCell({ first + 3, first + 4, first + 5 });
  }
  const Outline made = apart.outline();
  ASSERT_EQ(made.polygons.size(), kSide * kSide + 1);
  EXPECT_EQ(made.rings.size(), kSide * kSide + 1);
  ASSERT_EQ(made.corners.size(), 4 * kSide * kSide);
  for (std::size_t i = 0; i < made.corners.size(); ++i)
  {
    ASSERT_EQ(made.corners[i] / 6, made.corners[i - i % 4] / 6) << "a corner of another square";
  }
  EXPECT_EQ(made.unfitEdges, 0u);
}

/// More points at one place than are sorted between two polls.
TEST(Outlines, ManyPointsAtOnePlaceAreOne)
{
  constexpr std::int64_t kCells = 10000;
  OutlineCase wheel;
  for (std::int64_t k = 0; k < kCells; ++k)
  {
    const auto at = [](std::int64_t i) { return double(i) - double(kCells) / 2; };
    wheel.points.insert(wheel.points.end(),
      { { 0, 0, 0 }, { 1e8 - at(k) * at(k), at(k), 0 },
        { 1e8 - at(k + 1) * at(k + 1), at(k + 1), 0 } });
    wheel.addCell({ 3 * k, 3 * k + 1, 3 * k + 2 });
  }
  const Outline made = wheel.outline();
  EXPECT_EQ(made.rings, std::vector<Index>({ 0, Index(kCells) + 2 }));
  EXPECT_EQ(made.corners[0], 0u);
}

TEST(Outlines, EdgesThatCannotJoinAreCounted)
{
  OutlineCase fins;
  fins.points = { { 0, 0, 0 }, { 0, 1, 0 }, { 3, 0, 0 }, { -3, 0, 0 }, { 2, 0, 5 } };
  fins.addCell({ 0, 1, 2 });
  fins.addCell({ 0, 1, 3 });
  fins.addCell({ 0, 1, 4 });
  EXPECT_EQ(fins.outline().unfitEdges, 1u);
  EXPECT_EQ(fins.outline().polygons.size(), 4u);
  fins.groups = { 0, 0, 1 }; // two of one kind join
  EXPECT_EQ(fins.outline().unfitEdges, 0u);
  EXPECT_EQ(fins.outline().polygons.size(), 3u);
  OutlineCase band; // one-sided
  band.points = { { 0, 0, 0 }, { 4, 0, 1 }, { 4, 4, 0 }, { 0, 4, 1 }, { 2, 2, 3 } };
  for (std::int64_t k = 0; k < 5; ++k)
  {
    band.addCell({ k, (k + 1) % 5, (k + 2) % 5 });
  }
  EXPECT_EQ(band.outline().unfitEdges, 1u);
  OutlineCase closed;
  closed.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (const auto& cell :
    std::vector<std::vector<std::int64_t>>{ { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } })
  {
    closed.addCell(cell);
  }
  EXPECT_EQ(closed.outline().rings.size(), 1u);
}

/// A fan: one vertex has more edges than are sorted between two polls.
TEST(Outlines, ALargeFanHasOneRing)
{
  constexpr std::int64_t kLeaves = 20000;
  OutlineCase fan;
  fan.points.push_back({ 0, 0, 0 });
  for (std::int64_t k = 0; k <= kLeaves; ++k)
  {
    const double y = double(k) - double(kLeaves) / 2;
    fan.points.push_back({ 1e9 - y * y, y, 0 });
  }
  for (std::int64_t k = kLeaves; k > 0; --k)
  {
    fan.addCell({ 0, k, k + 1 });
  }
  const Outline made = fan.outline();
  EXPECT_EQ(made.rings, std::vector<Index>({ 0, Index(kLeaves) + 2 }));
  EXPECT_TRUE(std::is_sorted(made.corners.begin(), made.corners.end()));
}

/// Signs at the limit of double precision: a ring as thin as numbers get.
TEST(Outlines, DirectionsAreExact)
{
  const double y = std::nextafter(1.0, 2.0);
  for (const bool isUp : { false, true })
  {
    OutlineCase thin;
    thin.points = { { 0, 0, 0 }, { 1, isUp ? y : std::nextafter(1.0, 0.0), 0 }, { 3, 3, 0 } };
    thin.addCell({ 0, 1, 2 });
    const std::vector<Index> expected = isUp ? std::vector<Index>{ 0, 2, 1 }
                                             : std::vector<Index>{ 0, 1, 2 };
    EXPECT_EQ(thin.outline().corners, expected);
  }
}

} // namespace
} // namespace test
} // namespace ahd
