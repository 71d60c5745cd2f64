// SPDX-License-Identifier: BSD-3-Clause
//
// Lines and loops leaf by leaf: triangles, their edges, and rasters are those of one run.
#include "ConstraintMakers.h"
#include "JobRun.h"
#include "Random.h"
#include "TilesRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace ahd
{
namespace test
{
namespace
{

struct Stream
{
  std::vector<std::int64_t> triangles;
  std::vector<std::uint8_t> edges;
  ConstraintReport report;
};

Stream streamOfOneRun(const ConstraintCase& given, FillRule rule)
{
  Engine engine;
  EXPECT_EQ(engine.run(viewOf(given.points)), Status::Ok);
  EXPECT_EQ(engine.constrain(given.constraints.view(), rule), Status::Ok);
  Stream stream;
  stream.triangles.resize(3 * engine.report().triangles);
  stream.edges.resize(engine.report().triangles);
  EXPECT_EQ(engine.writeTriangles(stream.triangles.data()), Status::Ok);
  EXPECT_EQ(engine.writeConstraintEdges(stream.edges.data()), Status::Ok);
  stream.report = engine.constraints();
  return stream;
}

/// Whether two corners of no length are one point, ids may say otherwise than places.
void expectTheReport(
  const std::vector<std::int64_t>& tiled, const ConstraintReport& whole, const std::string& name)
{
  ASSERT_EQ(tiled.size(), whole.segments == 0 ? tiled.size() : TileConstraints().size()) << name;
  if (!tiled.empty())
  {
    const TileConstraints wanted = constraintsOf(whole);
    EXPECT_EQ(tiled[0] - tiled[1] - tiled[2], wanted[0] - wanted[1] - wanted[2]) << name;
    EXPECT_TRUE(std::equal(tiled.begin() + 3, tiled.end(), wanted.begin() + 3))
      << name << ": " << tiled[3] << " cross, not " << wanted[3] << "; " << tiled[4]
      << " unfilled, not " << wanted[4] << "; " << tiled[5] << " edges, not " << wanted[5];
  }
}

void expectTheStream(const ConstraintCase& given, std::uint64_t most, const std::string& name)
{
  for (const FillRule rule : { FillRule::Orientation, FillRule::EvenOdd })
  {
    const Stream whole = streamOfOneRun(given, rule);
    TilesWay way;
    way.most = most;
    way.lines = linesOf(given.points, given.constraints.view(), rule);
    TilesRun run(viewOf(given.points), way);
    ASSERT_EQ(run.fault, "") << name;
    Stream tiled;
    tiled.triangles = run.triangles(&tiled.edges);
    EXPECT_EQ(run.fault, "") << name;
    EXPECT_EQ(tiled.triangles, whole.triangles)
      << name << ", " << run.plan().leaves() << " leaves, rule " << int(rule);
    EXPECT_EQ(tiled.edges, whole.edges) << name;
    expectTheReport(run.constraints, whole.report, name);
  }
}

struct Named
{
  std::string name;
  ConstraintCase given;
};

std::vector<Named> largeCases()
{
  return { { "star", starPolygon(200) }, { "short", shortSegments(2000, 300) },
    { "edges of others", edgesOfOthers(900, 400) }, { "random", randomSegments(300, 60) },
    { "lattice", latticeSegments(20, 60) }, { "nested", nestedLoops(12) },
    { "across", segmentAcross(500) }, { "spiral", spiralLine(600, 9) },
    { "through", chainsThrough(Distribution::RepeatedDraws, 800, 9, 1) },
    { "bulges", segmentAcrossBulges(200) }, { "combs", segmentAcrossCombs(200) } };
}

TEST(TilesLines, SmallCasesAreAsInOneRun)
{
  for (std::uint64_t seed = 0; seed != reduced(600); ++seed)
  {
    const ConstraintCase given = smallConstraintCase(seed);
    expectTheStream(given, 1 + seed % 4, "case " + std::to_string(seed));
  }
}

TEST(TilesLines, LargeCasesAreAsInOneRun)
{
  for (const Named& one : largeCases())
  {
    for (const std::uint64_t most : { 5, 60, 100000 })
    {
      expectTheStream(one.given, most, one.name);
    }
  }
}

/// Up to 100 points on a small lattice, so that most is cocircular, collinear or a duplicate, with
/// chains that go to neighbours, leap, come back, and loops around each other that touch.
class LatticeCase
{
public:
  explicit LatticeCase(std::uint64_t seed)
    : random_(seed)
    , columns_(1 + random_.below(9))
    , rows_(1 + random_.below(9))
  {
  }

  ConstraintCase make()
  {
    static const double kSteps[] = { 1.0, 0.1, 0x1p-1074, 1e-300, 1e299 };
    const double dx = kSteps[random_.below(5)],
                 dy = random_.below(4) != 0 ? dx : kSteps[random_.below(5)];
    const std::size_t count = 3 + random_.below(98);
    for (std::size_t i = 0; i != count; ++i)
    {
      const auto x = double(random_.below(columns_ + 1)), y = double(random_.below(rows_ + 1));
      made_.points.push_back({ x * dx, y * dy });
      places_.push_back({ x, y });
    }
    for (std::size_t lines = random_.below(6); lines-- > 0;)
    {
      made_.constraints.addLine(walk(random_.below(9)));
    }
    for (std::size_t loops = random_.below(6); loops-- > 0;)
    {
      made_.constraints.addLoop(random_.below(2) != 0 ? rectangle() : walk(random_.below(7)));
    }
    return made_;
  }

private:
  std::int64_t any() { return std::int64_t(random_.below(places_.size())); }
  /// The point nearest to a place, one of those.
  std::int64_t nearest(double x, double y) const
  {
    const auto squared = [&](const Point& p)
    { return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y); };
    return std::min_element(places_.begin(), places_.end(),
             [&](const Point& p, const Point& q) { return squared(p) < squared(q); }) -
      places_.begin();
  }
  Chain walk(std::size_t length)
  {
    Chain chain;
    while (chain.size() < length)
    {
      const Point at = places_[std::size_t(chain.empty() ? any() : chain.back())];
      const auto step = [&] { return double(random_.below(5)) - 2.0; };
      chain.push_back(random_.below(3) == 0 ? any() : nearest(at.x + step(), at.y + step()));
    }
    return chain;
  }
  Chain rectangle()
  {
    const auto x = double(random_.below(columns_)), y = double(random_.below(rows_));
    const auto xTo = x + 1.0 + double(random_.below(columns_)),
               yTo = y + 1.0 + double(random_.below(rows_));
    Chain chain = { nearest(x, y), nearest(xTo, y), nearest(xTo, yTo), nearest(x, yTo) };
    if (random_.below(2) != 0)
    {
      std::reverse(chain.begin(), chain.end());
    }
    return chain;
  }

  Random random_;
  std::size_t columns_, rows_;
  std::vector<Point> places_; ///< in steps
  ConstraintCase made_;
};

void expectLattice(std::uint64_t seed)
{
  static const std::uint64_t kMost[] = { 1, 3, 16 };
  expectTheStream(LatticeCase(seed).make(), kMost[seed % 3], "lattice " + std::to_string(seed));
}

TEST(TilesLines, LatticesAreAsInOneRun)
{
  for (std::uint64_t seed = 0; seed != reduced(150); ++seed)
  {
    expectLattice(seed);
  }
}

TEST(LongTilesLines, LatticesAreAsInOneRun)
{
  for (std::uint64_t seed = 0; seed != 20000; ++seed)
  {
    expectLattice(seed);
  }
}

/// Loops within loops in one leaf: its final triangles are in several pieces.
TEST(TilesLines, PiecesOfLeavesAreKeptOrNot)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    ConstraintCase given = nestedLoops(6);
    const std::vector<Point> more = makePoints(Distribution::Uniform, 3000, seed);
    const Point low = *std::min_element(
      given.points.begin(), given.points.end(), lexicographicallyLess);
    for (const Point& p : more)
    {
      given.points.push_back({ low.x + 13.37 * p.x - 0.1, low.y + 13.37 * p.y - 0.1 });
    }
    for (const std::uint64_t most : { 40, 300, 1500 })
    {
      expectTheStream(given, most, "nested among others");
    }
  }
}

// ------------------------------------------------------------------------------------- rasters

double heightOf(std::int64_t id)
{
  return std::sin(double(id * 7919 % 1000));
}

struct Cells
{
  std::vector<double> values;
  std::vector<std::uint8_t> mask;
};

Cells sample(JobRun& run, const std::vector<std::int64_t>& ids, const SampleRaster& raster)
{
  std::vector<double> heights;
  for (const std::int64_t id : ids)
  {
    heights.push_back(heightOf(id));
  }
  const std::size_t count = raster.columns * raster.rows;
  Cells cells{ std::vector<double>(count, -7), std::vector<std::uint8_t>(count, 77) };
  run.set("sample_first_column", std::int64_t(raster.firstColumn));
  run.set("sample_first_row", std::int64_t(raster.firstRow));
  const ahd_places places = { nullptr, 0, { raster.origin.x, raster.origin.y },
    { raster.spacing.x, raster.spacing.y }, raster.columns, raster.rows };
  const ahd_sampled array = { heights.data(), 1, cells.values.data(), nullptr };
  EXPECT_EQ(ahd_sample(run.job(), &places, &array, 1, cells.mask.data()), AHD_OK)
    << ahd_message(run.job());
  return cells;
}

ahd_array arrayOf(const void* data, std::int32_t type, std::int64_t rows, std::int32_t columns)
{
  const std::int64_t size = type == AHD_UINT8 ? 1 : 8;
  return { data, type, columns, rows, columns * size, size };
}

/// How values are made.
struct Sampling
{
  std::int64_t method;
  double longest; ///< edge; 0: no limit
};

/// The cells of a leaf by an ordinary run of its points, its list and its surface.
Cells sampleLeaf(TilesRun& run, std::size_t leaf, const SampleRaster& piece, const Sampling& how)
{
  SecondVisit visit = run.second(leaf);
  const TileOutput surface = run.surface(leaf, how.longest);
  if (surface.surface.empty())
  {
    const std::size_t count = piece.columns * piece.rows;
    return { std::vector<double>(count, std::nan("")), std::vector<std::uint8_t>(count, 0) };
  }
  const Bounds& b = run.plan().facts().bounds;
  const double all[] = { b.xmin, b.xmax, b.ymin, b.ymax };
  const auto rows = std::int64_t(surface.surfaceEdges.size());
  const ahd_array bounds = arrayOf(all, AHD_FLOAT64, 2, 2);
  const ahd_array triangles = arrayOf(surface.surface.data(), AHD_INT64, rows, 3);
  const ahd_array edges = arrayOf(surface.surfaceEdges.data(), AHD_UINT8, rows, 1);
  JobRun job;
  job.setPoints(visit.view());
  ahd_set_array(job.job(), "rank_bounds", &bounds);
  ahd_set_array(job.job(), "surface", &triangles);
  ahd_set_array(job.job(), "surface_edges", &edges);
  job.set("sample_method", how.method);
  EXPECT_EQ(job.run(), AHD_OK) << ahd_message(job.job());
  return sample(job, visit.ids, piece);
}

/// The same, leaf by leaf.
Cells sampleLeaves(TilesRun& run, const SampleRaster& raster, std::int64_t method, double longest)
{
  const std::size_t count = raster.columns * raster.rows;
  Cells tiled{ std::vector<double>(count), std::vector<std::uint8_t>(count) };
  for (std::size_t leaf = 0; leaf != run.plan().leaves(); ++leaf)
  {
    const SampleRaster piece = run.plan().pieceOf(raster, leaf);
    const Cells part = sampleLeaf(run, leaf, piece, { method, longest });
    for (std::size_t k = 0; k != part.mask.size(); ++k)
    {
      const std::size_t at = (piece.firstRow + k / piece.columns) * raster.columns +
        piece.firstColumn + k % piece.columns;
      tiled.values[at] = part.values[k];
      tiled.mask[at] = part.mask[k];
    }
  }
  return tiled;
}

/// `longest`: edge, in cells; 0: no limit.
void expectTheRaster(
  const ConstraintCase& given, std::uint64_t most, double longest, const std::string& name)
{
  Bounds bounds;
  std::vector<std::int64_t> ids;
  for (const Point& p : given.points)
  {
    ids.push_back(std::int64_t(ids.size()));
    bounds = isFinite(p) ? joined(bounds, p) : bounds;
  }
  const SampleRaster raster = rasterAround(bounds, 40);
  if (raster.rows == 0)
  {
    return;
  }
  TilesWay way;
  way.most = most;
  way.extent = boundsOf(raster);
  way.lines = linesOf(given.points, given.constraints.view(), FillRule::Orientation);
  TilesRun run(viewOf(given.points), way);
  for (const std::int64_t method :
    { AHD_SAMPLE_LINEAR, AHD_SAMPLE_NATURAL_NEIGHBOR, AHD_SAMPLE_LAPLACE })
  {
    JobRun job;
    job.setPoints(viewOf(given.points));
    job.setConstraints(given.constraints.view());
    job.set("sample_method", method);
    job.set("maximum_edge_length", longest * raster.spacing.x);
    ASSERT_EQ(job.run(), AHD_OK) << ahd_message(job.job());
    if (job.count("delaunay_triangles") == 0)
    {
      return; // constraints do nothing
    }
    const Cells whole = sample(job, ids, raster);
    const Cells tiled = sampleLeaves(run, raster, method, longest * raster.spacing.x);
    const std::size_t bytes = whole.values.size() * sizeof(double);
    EXPECT_EQ(std::memcmp(tiled.values.data(), whole.values.data(), bytes), 0)
      << name << ", method " << method << ", longest " << longest << ", " << run.plan().leaves()
      << " leaves";
    EXPECT_EQ(tiled.mask, whole.mask) << name;
  }
}

TEST(TilesLines, RastersAreThoseOfOneRun)
{
  for (const Named& one : largeCases())
  {
    for (const double longest : { 0.0, 3.0 })
    {
      expectTheRaster(one.given, 60, longest, one.name);
    }
  }
  for (std::uint64_t seed = 0; seed != reduced(150); ++seed)
  {
    expectTheRaster(smallConstraintCase(seed), 1 + seed % 3, 0.0, "case " + std::to_string(seed));
    expectTheRaster(
      LatticeCase(seed).make(), 1 + seed % 9, double(seed % 4), "lattice " + std::to_string(seed));
  }
}

} // namespace
} // namespace test
} // namespace ahd
