// SPDX-License-Identifier: BSD-3-Clause
//
// Values across blocks: each block has a part of the points, and interpolates at a part of the
// places with points from the others. The same bytes as with all points.
#include "Sample/BoxNeighbors.h"
#include "BlocksRun.h"
#include "Distribute/BlockNeeds.h"
#include "HashedResults.h"
#include "SampleCase.h"
#include "ThreadTransport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

namespace ahd
{
namespace test
{
namespace
{

using Ids = std::vector<std::int64_t>;

/// Some of all points, triangulated.
struct PointsOfBlock
{
  PointsOfBlock(
    const ConstraintCase& all, const std::set<std::int64_t>& chosen, bool constrains, FillRule rule)
    : ids(chosen.begin(), chosen.end())
  {
    for (const std::int64_t id : ids)
    {
      places.push_back(all.points[std::size_t(id)]);
    }
    EXPECT_EQ(engine.run(viewOf(places)), Status::Ok);
    if (constrains)
    {
      const ConstraintView given = all.constraints.view();
      std::vector<std::int64_t> here;
      for (std::int64_t k = 0; k != (given.chains == 0 ? 0 : given.offsets[given.chains]); ++k)
      {
        const auto found = std::lower_bound(ids.begin(), ids.end(), given.ids[k]);
        here.push_back(
          found == ids.end() || *found != given.ids[k] ? -1 : std::int64_t(found - ids.begin()));
      }
      ConstraintView view = given;
      view.ids = here.data();
      EXPECT_EQ(engine.constrain(view, rule), Status::Ok);
    }
  }

  Ids ids;
  std::vector<Point> places;
  Engine engine;
};

/// Blocks that have points of one case.
class Blocks
{
public:
  Blocks(const ConstraintCase& all, std::size_t blocks, FillRule rule, BlockNeeds::Also also)
    : all_(all)
    , rule_(rule)
    , also_(also)
  {
    BlocksWay way;
    way.blocks = blocks;
    dealt_ = deal(all.view(), way);
  }

  /// The points each block needs for the boxes of several turns: by turn, then by block.
  std::vector<std::vector<std::unique_ptr<PointsOfBlock>>> around(
    const std::vector<std::vector<std::vector<Bounds>>>& turns) const
  {
    std::vector<std::vector<std::unique_ptr<PointsOfBlock>>> result(turns.size());
    for (auto& parts : result)
    {
      parts.resize(dealt_.size());
    }
    onBlocks(dealt_.size(),
      [&](std::size_t b, BlockTransport& transport)
      {
        BlockInput input = dealt_[b].input(b, dealt_.size());
        input.constraints = all_.constraints.view();
        input.rule = rule_;
        BlockNeeds needs(input, also_, transport, {});
        EXPECT_EQ(needs.begin(), Status::Ok);
        for (std::size_t turn = 0; turn != turns.size(); ++turn)
        {
          std::vector<BlockPoint> needed;
          EXPECT_EQ(needs.find(turns[turn][b], needed), Status::Ok);
          result[turn][b] = make(needed, needs.bounds());
        }
      });
    return result;
  }

private:
  std::unique_ptr<PointsOfBlock> make(
    const std::vector<BlockPoint>& needed, const Bounds& bounds) const
  {
    EXPECT_TRUE(std::is_sorted(needed.begin(), needed.end()));
    std::set<std::int64_t> chosen;
    std::set<std::pair<double, double>> places;
    for (const BlockPoint& point : needed)
    {
      EXPECT_TRUE(chosen.insert(point.id).second);
      const Ids& theirs = dealt_.at(point.block).ids;
      EXPECT_TRUE(std::binary_search(theirs.begin(), theirs.end(), point.id));
      const Point p = all_.points[std::size_t(point.id)];
      EXPECT_TRUE(
        bounds.xmin <= p.x && p.x <= bounds.xmax && bounds.ymin <= p.y && p.y <= bounds.ymax);
      places.insert({ p.x + 0.0, p.y + 0.0 });
    }
    for (std::size_t i = 0; i != all_.points.size(); ++i)
    {
      const Point p = all_.points[i];
      const bool isAt = isFinite(p) && places.count({ p.x + 0.0, p.y + 0.0 }) != 0;
      EXPECT_EQ(isAt, chosen.count(std::int64_t(i)) != 0) << "of coincident points all or none";
    }
    const bool constrains = all_.constraints.view().chains != 0;
    return std::make_unique<PointsOfBlock>(all_, chosen, constrains, rule_);
  }

  const ConstraintCase& all_;
  const FillRule rule_;
  const BlockNeeds::Also also_;
  std::vector<OwnPoints> dealt_;
};

SampleRaster pieceOf(const SampleRaster& raster, std::size_t piece, std::size_t pieces)
{
  const std::size_t across = pieces % 2 == 0 ? 2 : 1, along = pieces / across;
  const std::size_t i = piece % across, j = piece / across;
  SampleRaster result = raster;
  result.firstColumn = raster.columns * i / across;
  result.firstRow = raster.rows * j / along;
  result.columns = raster.columns * (i + 1) / across - result.firstColumn;
  result.rows = raster.rows * (j + 1) / along - result.firstRow;
  return result;
}

std::vector<Bounds> boxOf(const SampleRaster& raster)
{
  if (raster.columns == 0 || raster.rows == 0)
  {
    return { Bounds() };
  }
  const Point low = raster.at(0, 0), high = raster.at(raster.columns - 1, raster.rows - 1);
  return { Bounds{ low.x, high.x, low.y, high.y } };
}

const SampleMethod kMethods[] = { SampleMethod::Linear, SampleMethod::NaturalNeighbor,
  SampleMethod::Laplace, SampleMethod::Nearest };

double valueOf(std::int64_t id)
{
  return std::sin(double(id * 7919 % 1000));
}

/// Compares all results at these places, of Nearest if `hasNearest`.
void expectSame(SampledCase& whole, PointsOfBlock& part, const SamplePlaces& places,
  const std::string& name, bool hasNearest)
{
  if (part.ids.size() == whole.points.size())
  {
    return; // the same once more
  }
  std::vector<double> ofAll, ofPart;
  for (std::size_t i = 0; i != whole.points.size(); ++i)
  {
    ofAll.push_back(valueOf(std::int64_t(i)));
  }
  for (const std::int64_t id : part.ids)
  {
    ofPart.push_back(valueOf(id));
  }
  for (const SampleMethod method : kMethods)
  {
    if (method == SampleMethod::Nearest && !hasNearest)
    {
      continue;
    }
    whole.prepare(method);
    Sampler sampler;
    ASSERT_EQ(sampler.prepare(part.engine.made, nullptr, method, {}), Status::Ok);
    const bool slopes = method == SampleMethod::Linear;
    EXPECT_TRUE(areSame(sample(whole.sampler, places, ofAll, {}, slopes),
      sample(sampler, places, ofPart, {}, slopes)))
      << name << ", method " << int(method) << ", " << part.ids.size() << " of "
      << whole.points.size();
  }
}

/// In, on and around the points.
std::vector<Point> oddPlaces(const std::vector<Point>& points, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Point> places;
  for (std::size_t k = 0; k != 60 && !points.empty(); ++k)
  {
    const Point a = points[random.below(points.size())], b = points[random.below(points.size())];
    places.push_back(a);
    places.push_back({ 0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y });
    places.push_back({ a.x, b.y });
    places.push_back({ 1.5 * a.x - 0.5 * b.x, 1.5 * a.y - 0.5 * b.y });
    places.push_back({ a.x + (a.x - b.x) * 0x1p-52, a.y + (a.y - b.y) * 0x1p-52 });
  }
  places.push_back({ kNotANumber, 0.0 });
  return places;
}

/// Returns how many of the blocks' points were needed, of all that there are; 0 if all are.
double expectAsOne(
  const ConstraintCase& given, FillRule rule, std::size_t blocks, const std::string& name)
{
  SampledCase whole(given, rule);
  const bool hasNearest = given.constraints.view().chains == given.constraints.view().lines;
  const Blocks all(
    given, blocks, rule, hasNearest ? BlockNeeds::Also::Nearest : BlockNeeds::Also::Nothing);
  const Bounds box = boundsOf(whole.engine.made);
  SampleRaster raster{ { box.xmin, box.ymin },
    { (box.xmax - box.xmin) / 40.0, (box.ymax - box.ymin) / 30.0 }, 41, 31 };
  const std::vector<Point> places = oddPlaces(given.points, blocks);
  std::vector<std::vector<Point>> own;
  std::vector<std::vector<std::vector<Bounds>>> turns(2);
  for (std::size_t b = 0; b != blocks; ++b)
  {
    turns[0].push_back(boxOf(pieceOf(raster, b, blocks)));
    own.emplace_back(places.begin() + std::ptrdiff_t(places.size() * b / blocks),
      places.begin() + std::ptrdiff_t(places.size() * (b + 1) / blocks));
    turns[1].emplace_back();
    EXPECT_EQ(coverByBoxes(viewOf(own[b]), 16, {}, turns[1][b]), Status::Ok);
  }
  const auto parts = all.around(turns);
  double needed = 0.0;
  for (std::size_t b = 0; b != blocks; ++b)
  {
    expectSame(
      whole, *parts[0][b], SamplePlaces(pieceOf(raster, b, blocks)), name + ", raster", hasNearest);
    expectSame(whole, *parts[1][b], SamplePlaces(viewOf(own[b])), name + ", places", hasNearest);
    needed += double(parts[0][b]->ids.size()) / double(blocks * given.points.size());
  }
  return needed < 1.0 ? needed : 0.0;
}

ConstraintCase withoutConstraints(const std::vector<Point>& points)
{
  ConstraintCase result;
  result.points = points;
  return result;
}

TEST(BoxNeighbors, EveryDistributionIsAsInOneGo)
{
  std::size_t used = 0;
  for (const Distribution d : allDistributions())
  {
    const ConstraintCase given = withoutConstraints(makePoints(d, affordable(d, 500), 1));
    for (const std::size_t blocks : { 1, 2, 5 })
    {
      used += expectAsOne(given, FillRule::EvenOdd, blocks, nameOf(d)) > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GE(used, 30u);
}

TEST(BoxNeighbors, FewPointsAreAsInOneGo)
{
  for (unsigned mask = 1; mask < 512; mask += 6)
  {
    const ConstraintCase given = withoutConstraints(someOfNine(mask));
    for (const std::size_t blocks : { 2, 3 })
    {
      expectAsOne(given, FillRule::EvenOdd, blocks, "mask " + std::to_string(mask));
    }
  }
}

TEST(BoxNeighbors, WithConstraintsAsInOneGo)
{
  const std::pair<const char*, ConstraintCase> cases[] = { { "short", shortSegments(600, 100) },
    { "edges", edgesOfOthers(600, 100) }, { "star", starPolygon(100) },
    { "nested", nestedLoops(12) }, { "spiral", spiralLine(400, 5) },
    { "parabolas", segmentAcrossParabolas(300) }, { "bulges", segmentAcrossBulges(300) },
    { "combs", segmentAcrossCombs(300) }, { "lattice", latticeSegments(20, 60) } };
  std::size_t used = 0;
  for (const auto& named : cases)
  {
    for (const FillRule rule : { FillRule::Orientation, FillRule::EvenOdd })
    {
      for (const std::size_t blocks : { 2, 4 })
      {
        used += expectAsOne(named.second, rule, blocks, named.first) > 0.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GE(used, 20u);
}

TEST(BoxNeighbors, SmallConstraintCasesAreAsInOneGo)
{
  std::size_t used = 0;
  for (std::uint64_t seed = 0; seed != reduced(100); ++seed)
  {
    ConstraintCase given = smallConstraintCase(seed);
    if (!given.skip.empty())
    {
      continue;
    }
    SCOPED_TRACE(seed);
    for (const FillRule rule : { FillRule::Orientation, FillRule::EvenOdd })
    {
      used += expectAsOne(given, rule, 3, "small") > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(used, 5u);
}

/// Between the arms of a loop lies what the hull of the loops alone would take for a region of its
/// own, which no other loop bounds. The extremes lie so that they do not prevent it.
TEST(BoxNeighbors, RegionsEndAtTheHullOfAllPoints)
{
  ConstraintCase given;
  const auto add = [&given](double s, double t)
  {
    given.points.push_back({ t + s, t - s });
    return std::int64_t(given.points.size() - 1);
  };
  given.constraints.addLoop({ add(-8, 0), add(-6, 0), add(-6, 2), add(-8, 2) });
  given.constraints.addLoop({ add(-2, 5.25), add(-1, 5.25), add(-1, 2), add(1, 2), add(1, 5.25),
    add(2, 5.25), add(2, 1), add(-2, 1) });
  add(15, 5), add(-15, 5), add(0, -10), add(0, 8);
  for (double t = 2.25; t < 5.0; t += 0.25)
  {
    add(-0.5, t), add(0.125, t), add(0.625, t);
  }
  SampledCase whole(given, FillRule::Orientation);
  const Blocks all(
    given, 1, FillRule::Orientation, BlockNeeds::Also::Nothing); // which has no extremes within
  const std::vector<Point> places{ { 2.3, 2.4 } };
  std::vector<Bounds> boxes;
  ASSERT_EQ(coverByBoxes(viewOf(places), 1, {}, boxes), Status::Ok);
  const auto parts = all.around({ { boxes } });
  ASSERT_LT(parts[0][0]->ids.size(), given.points.size());
  expectSame(whole, *parts[0][0], SamplePlaces(viewOf(places)), "between arms", false);
  whole.prepare(SampleMethod::Linear);
  const std::vector<double> values(given.points.size());
  EXPECT_EQ(sample(whole.sampler, SamplePlaces(viewOf(places)), values).report.outside, 1u);
}

TEST(BoxNeighbors, BoxesCoverAllPlaces)
{
  for (const Distribution d : allDistributions())
  {
    std::vector<Point> places = makePoints(d, 500, 2);
    places.push_back({ kNotANumber, 1.0 });
    for (const std::size_t most : { 1, 2, 7, 64 })
    {
      std::vector<Bounds> boxes;
      ASSERT_EQ(coverByBoxes(viewOf(places), most, {}, boxes), Status::Ok);
      ASSERT_LE(boxes.size(), most);
      ASSERT_GE(boxes.size(), d == Distribution::Uniform ? most : 1);
      for (const Point& p : places)
      {
        const bool isCovered = std::any_of(boxes.begin(), boxes.end(),
          [&p](const Bounds& b)
          { return b.xmin <= p.x && p.x <= b.xmax && b.ymin <= p.y && p.y <= b.ymax; });
        ASSERT_EQ(isCovered, isFinite(p)) << nameOf(d);
      }
    }
  }
  std::vector<Bounds> boxes(3);
  ASSERT_EQ(coverByBoxes(PointView(), 4, {}, boxes), Status::Ok);
  EXPECT_TRUE(boxes.empty());
}

/// A block receives only points near its places.
TEST(BoxNeighbors, FewAreNeeded)
{
  const ConstraintCase given = withoutConstraints(makePoints(Distribution::Uniform, 20000, 3));
  const double needed = expectAsOne(given, FillRule::EvenOdd, 4, "uniform");
  EXPECT_GT(needed, 0.2);
  EXPECT_LT(needed, 0.26);
}

} // namespace
} // namespace test
} // namespace ahd
