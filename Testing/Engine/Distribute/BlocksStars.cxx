// SPDX-License-Identifier: BSD-3-Clause
//
// Steps after the triangulation: layers of ghosts, and the trimmed rim, against their definitions
// with all triangles in one place.
#include "BlocksRun.h"
#include "ConstraintMakers.h"
#include "Distribute/BlockGhosts.h"
#include "Distribute/BlockRim.h"
#include "HashedResults.h"
#include "ThreadTransport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace ahd
{
namespace test
{
namespace
{

/// One block's triangles.
struct OwnStars
{
  BlockTriangulation made;
  std::vector<std::int32_t> corners, cornersAround;
  std::vector<std::uint8_t> edges, edgesAround;
  std::vector<Point> places;
  BlockStars stars;
};

/// All blocks' triangles.
class AllStars
{
public:
  AllStars(const PointView& points, const ConstraintView& constraints, const BlocksWay& way)
    : dealt(deal(points, way))
    , of(way.blocks)
  {
    onBlocks(way.blocks,
      [&](std::size_t b, BlockTransport& transport)
      {
        BlockInput input = dealt[b].input(b, of.size());
        input.constraints = constraints;
        EXPECT_EQ(distribute(input, transport, {}, of[b].made), Status::Ok);
        write(b, input);
      });
  }

  std::vector<OwnPoints> dealt;
  std::vector<OwnStars> of;

private:
  void write(std::size_t b, const BlockInput& input)
  {
    OwnStars& own = of[b];
    own.corners.resize(3 * own.made.triangles() + 1);
    own.edges.resize(own.made.triangles());
    own.cornersAround.resize(3 * own.made.ghostTriangles() + 1);
    own.edgesAround.resize(own.made.ghostTriangles());
    EXPECT_EQ(own.made.writeTriangles(own.corners.data(), {}), Status::Ok);
    EXPECT_EQ(own.made.writeConstraintEdges(own.edges.data(), {}), Status::Ok);
    EXPECT_EQ(own.made.writeGhostTriangles(own.cornersAround.data(), {}), Status::Ok);
    EXPECT_EQ(own.made.writeGhostConstraintEdges(own.edgesAround.data(), {}), Status::Ok);
    for (std::size_t i = 0; i < input.points.count; ++i)
    {
      own.places.push_back(input.points[i]);
    }
    for (const ForeignPoint& point : own.made.foreignPoints())
    {
      own.places.push_back(point.at);
    }
    own.stars.block = b;
    own.stars.blocks = of.size();
    own.stars.ids = input.ids;
    own.stars.points = input.points.count;
    own.stars.foreign = &own.made.foreignPoints();
    own.stars.own = { own.corners.data(), own.edges.data(), own.edges.size(),
      own.made.insideTriangles() };
    own.stars.around = { own.cornersAround.data(), own.edgesAround.data(), own.edgesAround.size(),
      0 };
  }
};

/// A triangle by global ids: corners, their owners, edges.
struct Known
{
  std::array<std::int64_t, 3> ids;
  std::array<std::uint64_t, 3> owners;
  std::uint64_t edges;

  bool operator==(const Known& other) const
  {
    return ids == other.ids && owners == other.owners && edges == other.edges;
  }
  bool has(std::uint64_t block) const
  {
    return std::find(owners.begin(), owners.end(), block) != owners.end();
  }
};

/// By number, those of block 0 first; `firsts`: of each block, and the total.
std::vector<Known> listAll(const AllStars& all, std::vector<std::size_t>& firsts)
{
  std::vector<Known> known;
  for (const OwnStars& own : all.of)
  {
    firsts.push_back(known.size());
    for (std::size_t t = 0; t < own.stars.own.count; ++t)
    {
      Known one;
      for (std::size_t e = 0; e < 3; ++e)
      {
        const BlockPoint corner = own.stars.point(own.stars.corners(t)[e]);
        one.ids[e] = corner.id;
        one.owners[e] = corner.block;
      }
      one.edges = own.stars.edges(t);
      known.push_back(one);
    }
  }
  firsts.push_back(known.size());
  return known;
}

/// The numbers of the ghosts of block b after so many layers.
std::set<std::size_t> ghostsOf(
  const std::vector<Known>& all, std::size_t b, std::size_t begin, std::size_t end, int layers)
{
  std::set<std::size_t> here;
  std::set<std::int64_t> points;
  const auto take = [&](std::size_t t)
  {
    here.insert(t);
    points.insert(all[t].ids.begin(), all[t].ids.end());
  };
  for (std::size_t t = begin; t < end; ++t)
  {
    take(t);
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    const std::set<std::int64_t> before = points;
    for (std::size_t t = 0; t < all.size(); ++t)
    {
      const bool isNear = std::any_of(all[t].ids.begin(), all[t].ids.end(),
        [&](std::int64_t id) { return before.count(id) != 0; });
      if (isNear || all[t].has(b))
      {
        take(t);
      }
    }
  }
  here.erase(here.lower_bound(begin), here.lower_bound(end));
  return here;
}

void expectLayers(AllStars& all, int layers, const std::string& name)
{
  std::vector<std::size_t> firsts;
  const std::vector<Known> known = listAll(all, firsts);
  onBlocks(all.of.size(),
    [&](std::size_t b, BlockTransport& transport)
    {
      BlockGhosts ghosts(all.of[b].stars, transport, {});
      EXPECT_EQ(ghosts.begin(firsts[b]), Status::Ok);
      for (int layer = 0; layer < layers; ++layer)
      {
        EXPECT_EQ(ghosts.ask(), Status::Ok);
        const std::size_t most = ghosts.countAll();
        EXPECT_EQ(ghosts.take(), Status::Ok);
        EXPECT_LE(ghosts.triangles().size(), most);
        const std::set<std::size_t> expected = ghostsOf(
          known, b, firsts[b], firsts[b + 1], layer + 1);
        std::vector<std::size_t> found;
        std::set<std::int64_t> foreign;
        for (const GhostTriangle& ghost : ghosts.triangles())
        {
          Known one;
          for (std::size_t e = 0; e < 3; ++e)
          {
            one.ids[e] = ghost.corners[e].id;
            one.owners[e] = ghost.corners[e].block;
            if (one.owners[e] != b)
            {
              foreign.insert(one.ids[e]);
            }
          }
          one.edges = ghost.edges;
          found.push_back(std::size_t(ghost.id));
          EXPECT_TRUE(one == known.at(found.back())) << name << ", triangle " << ghost.id;
        }
        EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()))
          << name << ", block " << b << ", layer " << layer;
        std::vector<BlockPoint> points;
        EXPECT_EQ(ghosts.addForeign(points), Status::Ok);
        EXPECT_TRUE(std::equal(points.begin(), points.end(), foreign.begin(), foreign.end(),
          [](const BlockPoint& point, std::int64_t id) { return point.id == id; }));
      }
    });
}

TEST(BlocksStars, LayersOfGhostsAreThoseOfTheDefinition)
{
  for (const Distribution d : allDistributions())
  {
    for (const std::size_t blocks : { 2, 5, 16 })
    {
      BlocksWay way;
      way.blocks = blocks;
      const std::vector<Point> points = makePoints(d, affordable(d, 400), 1);
      AllStars all(viewOf(points), ConstraintView(), way);
      expectLayers(all, 3, nameOf(d));
    }
  }
}

TEST(BlocksStars, GhostsHaveTheirConstraintEdges)
{
  const std::pair<const char*, ConstraintCase> cases[] = { { "edges", edgesOfOthers(600, 100) },
    { "star", starPolygon(100) }, { "combs", segmentAcrossCombs(300) } };
  for (const auto& named : cases)
  {
    BlocksWay way;
    way.blocks = 6;
    AllStars all(named.second.view(), named.second.constraints.view(), way);
    expectLayers(all, 2, named.first);
  }
}

/// A point of another block that is in no remaining triangle requests nothing.
TEST(BlocksStars, GhostsOfThoseThatAreKept)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, 800, 2);
  BlocksWay way;
  way.blocks = 7;
  AllStars all(viewOf(points), ConstraintView(), way);
  for (OwnStars& own : all.of)
  {
    for (BlockTriangles* const some : { &own.stars.own, &own.stars.around })
    {
      std::vector<std::uint8_t> kept;
      for (std::size_t t = 0; t < some->count; ++t)
      {
        std::int64_t sum = 0;
        for (std::size_t e = 0; e < 3; ++e)
        {
          sum += own.stars.point(some->corners[3 * t + e]).id;
        }
        kept.push_back(sum % 3 == 0 ? 0 : 1);
      }
      some->keep(kept.data());
    }
  }
  expectLayers(all, 3, "two of three");
}

// ------------------------------------------------------------------------------------------- rims

/// Triples of ids, each from its smallest one, sorted.
using Triples = std::vector<std::array<std::int64_t, 3>>;

void add(std::array<std::int64_t, 3> ids, Triples& triples)
{
  std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  triples.push_back(ids);
}

/// `hasArea`: areas are larger than rounding errors.
void expectTrimmed(
  const std::vector<Point>& points, const BlocksWay& way, const std::string& name, bool hasArea)
{
  Triangulation whole;
  Workspace workspace;
  ASSERT_EQ(triangulate(viewOf(points), Options(), workspace, {}, whole), Status::Ok);
  ASSERT_EQ(trim(std::move(whole), {}, whole), Status::Ok);
  const Report& report = whole.report();
  std::vector<std::int64_t> ids(3 * report.triangles + 1);
  ASSERT_EQ(whole.writeTriangles(ids.data(), {}), Status::Ok);
  Triples expected, found;
  for (std::size_t t = 0; t < report.triangles; ++t)
  {
    add({ { ids[3 * t], ids[3 * t + 1], ids[3 * t + 2] } }, expected);
  }
  AllStars all(viewOf(points), ConstraintView(), way);
  std::vector<BlockRim> rims(way.blocks);
  onBlocks(way.blocks,
    [&](std::size_t b, BlockTransport& transport)
    {
      OwnStars& own = all.of[b];
      EXPECT_EQ(trimBlocks(own.places, transport, {}, own.stars, rims[b]), Status::Ok);
    });
  std::vector<std::size_t> firsts;
  for (const Known& one : listAll(all, firsts))
  {
    add(one.ids, found);
  }
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(expected, found) << name << ", " << way.blocks << " blocks";
  for (const BlockRim& rim : rims)
  {
    EXPECT_EQ(rim.triangles, report.trimmed) << name;
    EXPECT_EQ(rim.bareVertices, report.bareVertices) << name;
    if (hasArea)
    {
      EXPECT_EQ(rim.area, rims[0].area) << name;
      EXPECT_NEAR(rim.area, report.trimmedArea, 1e-12 * report.trimmedArea) << name;
    }
  }
  expectLayers(all, 1, name + ", trimmed"); // the same ones were removed from those around
}

TEST(BlocksStars, RimsAreThoseOfAllPoints)
{
  for (const Distribution d : allDistributions())
  {
    for (const std::size_t blocks : { 1, 2, 5, 16 })
    {
      BlocksWay way;
      way.blocks = blocks;
      expectTrimmed(
        makePoints(d, affordable(d, 400), 1), way, nameOf(d), d == Distribution::Uniform);
    }
  }
}

/// Rows that bend a little, as a straight rim in a plane that was fitted: flat triangles in long
/// rows, each of which follows one on another block.
TEST(BlocksStars, RimsThatLeadOverManyBlocks)
{
  for (const double bend : { 1e-3, 1e-6, 0.1 })
  {
    std::vector<Point> points;
    for (int i = 0; i < 300; ++i)
    {
      const double x = i / 300.0 - 0.5;
      points.push_back({ x, bend * (0.25 - x * x) });
      points.push_back({ x + 1e-4, 1.0 - bend * x * x });
      points.push_back({ 0.9 * x, 0.2 + 0.6 * std::fabs(std::sin(double(i * i))) });
    }
    for (const std::size_t blocks : { 3, 8, 40 })
    {
      BlocksWay way;
      way.blocks = blocks;
      expectTrimmed(points, way, "bend " + std::to_string(bend), true);
      // Points at random on blocks: nearly every step leads to another block.
      way.owner = [blocks](const Point& p)
      { return std::size_t(std::fabs(p.x) * 7919.0) % blocks; };
      expectTrimmed(points, way, "scattered, bend " + std::to_string(bend), true);
    }
  }
}

/// One block that is cancelled, at any poll, ends all alike.
TEST(BlocksStars, OneThatIsToldToCancelEndsAll)
{
  const std::vector<Point> points = makePoints(Distribution::OnParabola, 300, 1);
  BlocksWay way;
  way.blocks = 3;
  const auto make = [&]
  {
    auto all = std::make_shared<AllStars>(viewOf(points), ConstraintView(), way);
    return [all](std::size_t b, BlockTransport& transport, const Context& context)
    {
      OwnStars& own = all->of[b];
      BlockRim rim;
      Status status = trimBlocks(own.places, transport, context, own.stars, rim);
      BlockGhosts ghosts(own.stars, transport, context);
      status = status == Status::Ok ? ghosts.begin(1000 * b) : status;
      status = status == Status::Ok ? ghosts.ask() : status;
      return status == Status::Ok ? ghosts.take() : status;
    };
  };
  expectThatOneEndsAll(1, 8, make);
}

} // namespace
} // namespace test
} // namespace ahd
