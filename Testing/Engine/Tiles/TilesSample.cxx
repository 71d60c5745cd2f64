// SPDX-License-Identifier: BSD-3-Clause
//
// Rasters leaf by leaf: no byte differs from those of one run with all points.
#include "HashedResults.h"
#include "Sample/Outside.h"
#include "Sample/Sample.h"
#include "Surface/Selection.h"
#include "TilesRun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace ahd
{
namespace test
{
namespace
{

const SampleMethod kMethods[] = { SampleMethod::Linear, SampleMethod::NaturalNeighbor,
  SampleMethod::Laplace, SampleMethod::Nearest };

double heightOf(std::int64_t id)
{
  return std::sin(double(id * 7919 % 1000));
}

/// Values, slopes and mask of a raster.
struct Cells
{
  explicit Cells(std::size_t count)
    : values(count, -7.0)
    , slopes(2 * count, -7.0)
    , mask(count, 77)
  {
  }

  std::vector<double> values, slopes;
  std::vector<unsigned char> mask;
};

/// How values are made.
struct Sampling
{
  SampleMethod method;
  double longest = 0.0; ///< edge; 0: no limit
};

/// Samples points that are numbered by ids.
Cells sample(const PointView& points, const std::vector<std::int64_t>& ids, const Options& options,
  const SampleRaster& raster, const Sampling& how)
{
  Engine engine;
  EXPECT_EQ(engine.run(points, options), Status::Ok);
  std::vector<double> heights;
  for (const std::int64_t id : ids)
  {
    heights.push_back(heightOf(id));
  }
  Selection selection;
  SizeLimits limits;
  limits.maximumEdgeLength = how.longest;
  if (how.longest > 0.0)
  {
    EXPECT_EQ(selectBySize(engine.made, limits, { points, nullptr }, {}, selection), Status::Ok);
  }
  const unsigned char* const kept = selection.kept.empty() ? nullptr : selection.kept.data();
  Cells cells(raster.columns * raster.rows);
  Sampler sampler;
  EXPECT_EQ(sampler.prepare(engine.made, kept, how.method, {}), Status::Ok);
  const SampleArray array{ heights.data(), 1, cells.values.data(),
    how.method == SampleMethod::Linear ? cells.slopes.data() : nullptr };
  SampleReport report;
  const SamplePlaces places(raster);
  EXPECT_EQ(sampler.values(places, &array, 1, cells.mask.data(), report, {}), Status::Ok);
  return cells;
}

bool areSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// The same, leaf by leaf.
Cells sampleLeaves(TilesRun& run, const SampleRaster& raster, const Sampling& how)
{
  Cells tiled(raster.columns * raster.rows);
  std::size_t cells = 0;
  for (std::size_t leaf = 0; leaf != run.plan().leaves(); ++leaf)
  {
    const SampleRaster piece = run.plan().pieceOf(raster, leaf);
    const SecondVisit visit = run.second(leaf);
    const Cells part = sample(visit.view(), visit.ids, visit.options, piece, how);
    cells += part.mask.size();
    for (std::size_t k = 0; k != part.mask.size(); ++k)
    {
      const std::size_t at = (piece.firstRow + k / piece.columns) * raster.columns +
        piece.firstColumn + k % piece.columns;
      tiled.values[at] = part.values[k];
      tiled.mask[at] = part.mask[k];
      tiled.slopes[2 * at] = part.slopes[2 * k];
      tiled.slopes[2 * at + 1] = part.slopes[2 * k + 1];
    }
  }
  EXPECT_EQ(cells, tiled.mask.size()) << "each cell once";
  return tiled;
}

void expectTheRaster(const std::vector<Point>& points, std::uint64_t most, const std::string& name)
{
  const PointView view = viewOf(points);
  std::vector<std::int64_t> ids(points.size());
  Bounds bounds;
  for (std::size_t i = 0; i != points.size(); ++i)
  {
    ids[i] = std::int64_t(i);
    bounds = joined(bounds, points[i]);
  }
  const SampleRaster raster = rasterAround(bounds, 44);
  if (raster.rows == 0)
  {
    return;
  }
  TilesWay way;
  way.most = most;
  way.extent = boundsOf(raster);
  TilesRun run(view, way);
  ASSERT_EQ(run.fault, "") << name;
  for (const SampleMethod method : kMethods)
  {
    for (const double longest : { 0.0, 2.0 * raster.spacing.x })
    {
      const Sampling how{ method, longest };
      const Cells whole = sample(view, ids, {}, raster, how);
      const Cells tiled = sampleLeaves(run, raster, how);
      EXPECT_TRUE(areSame(tiled.values, whole.values) && areSame(tiled.slopes, whole.slopes) &&
        tiled.mask == whole.mask)
        << name << ", method " << int(method) << ", longest " << longest << ", "
        << run.plan().leaves() << " leaves";
    }
  }
}

TEST(TilesSample, RastersOfEveryDistributionAreThoseOfOneRun)
{
  for (const Distribution d : allDistributions())
  {
    const std::vector<Point> points = makePoints(d, affordable(d, 700), 3);
    expectTheRaster(points, 2 * points.size() / 30 + 1, nameOf(d));
  }
}

/// A place of a leaf four units in the last place from v, a vertex of another leaf, beside which
/// only triangles that are too long lie in the leaf. The short one at v is on a circle that touches
/// the vertical line through v there: its disc misses the leaf by so little that rounding matters.
TEST(TilesSample, APlaceWithinRoundingOfTheRimInAnotherLeafHasAValue)
{
  constexpr double kRadius = 0.01, kDegree = 3.14159265358979323846 / 180;
  const double edge = TileGrid({ 0, 1, 0, 1 }).placesOf(TileBox().quarter(0)).xmax;
  Point v{ edge, 0.3 };
  for (int k = 0; k != 4; ++k)
  {
    v.x = std::nextafter(v.x, 1.0);
  }
  std::vector<Point> points = { v, { 0, 0 }, { 1, 1 }, { 0, 1 }, { 1, 0 }, { 0.2, 0.2 },
    { 0.25, 0.4 }, { 0.3, 0.3 }, { 0.5, 0.1 }, { 0.52, 0.45 } };
  const auto add = [&](double degrees, double distance)
  {
    points.push_back({ v.x + kRadius - distance * kRadius * std::cos(degrees * kDegree),
      v.y + distance * kRadius * std::sin(degrees * kDegree) });
  };
  for (const double degrees : { 70, -100 })
  {
    add(degrees, 1);
  }
  add(120, 1 - 1e-7); // the short triangle's, which only the other leaf's triangles have
  add(95, 1.3);
  add(190, 1.5);
  add(145, 1.5);
  std::vector<std::int64_t> ids(points.size());
  for (std::size_t i = 0; i != ids.size(); ++i)
  {
    ids[i] = std::int64_t(i);
  }
  SampleRaster place;
  place.origin = { edge, v.y };
  place.columns = place.rows = 1;
  const Sampling how{ SampleMethod::Linear, 1.8 * kRadius };
  const Cells whole = sample(viewOf(points), ids, {}, place, how);
  ASSERT_EQ(whole.mask[0], 1);
  TilesWay way;
  way.most = 8;
  way.extent = { 0, 1, 0, 1 };
  TilesRun run(viewOf(points), way);
  ASSERT_NE(run.plan().leafOf(place.at(0, 0)), run.plan().leafOf(v));
  const Cells tiled = sampleLeaves(run, place, how);
  EXPECT_EQ(tiled.mask, whole.mask);
  EXPECT_TRUE(areSame(tiled.values, whole.values));
}

} // namespace
} // namespace test
} // namespace ahd
