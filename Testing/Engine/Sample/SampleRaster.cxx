// SPDX-License-Identifier: BSD-3-Clause
//
// Linear values on rasters, which are found triangle by triangle: the same bytes as cell by cell,
// for rasters that are aligned with the points or not, fine, coarse, far away or odd, and each cell
// once.
#include "Executors.h"
#include "SampleCase.h"

#include <cstring>

namespace ahd
{
namespace test
{
namespace
{

std::string difference(const SampledValues& a, const SampledValues& b)
{
  for (std::size_t k = 0; k < a.mask.size(); ++k)
  {
    if (a.mask[k] != b.mask[k] || std::memcmp(&a.values[k], &b.values[k], sizeof(double)) != 0)
    {
      return "cell " + std::to_string(k) + ": " + std::to_string(a.values[k]) + " and " +
        std::to_string(b.values[k]);
    }
  }
  return !areSame(a.gradients, b.gradients)                   ? "slopes"
    : std::memcmp(&a.report, &b.report, sizeof a.report) != 0 ? "reports"
                                                              : "";
}

/// Values that are finite, but for each `odd`-th.
std::vector<double> valuesFor(const std::vector<Point>& points, std::size_t odd)
{
  std::vector<double> values;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const double odds[] = { kNotANumber, HUGE_VAL, -HUGE_VAL };
    const bool isOdd = odd != 0 && k % odd == 3;
    values.push_back(isOdd ? odds[k / odd % 3] : std::sin(double(k * 7919 % 1000)));
  }
  return values;
}

/// @pre the sampler is prepared for Linear. Returns how many cells have values.
std::size_t expectAsCellByCell(SampledCase& given, const SampleRaster& raster)
{
  static ThreadExecutor threads(3);
  const std::vector<Point> cells = pointsOf(raster);
  std::size_t valued = 0;
  for (const std::size_t odd : { 0, 11 })
  {
    const std::vector<double> values = valuesFor(given.points, odd);
    for (const bool slopes : { false, true })
    {
      const SampledValues expected = sample(
        given.sampler, SamplePlaces(viewOf(cells)), values, {}, slopes);
      const SampledValues found = sample(given.sampler, SamplePlaces(raster), values, {}, slopes);
      EXPECT_EQ(difference(found, expected), "") << "odd " << odd << ", slopes " << slopes;
      const SampledValues shared = sample(
        given.sampler, SamplePlaces(raster), values, { nullptr, &threads }, slopes);
      EXPECT_EQ(difference(shared, expected), "") << "threads";
      valued = found.report.valued;
    }
  }
  return valued;
}

Bounds boundsOf(const std::vector<Point>& points)
{
  Bounds b{ points[0].x, points[0].x, points[0].y, points[0].y };
  for (const Point& p : points)
  {
    b = { std::min(b.xmin, p.x), std::max(b.xmax, p.x), std::min(b.ymin, p.y),
      std::max(b.ymax, p.y) };
  }
  return b;
}

TEST(SampleRaster, AsCellByCellForPointsOfEveryKind)
{
  for (const Distribution d : allDistributions())
  {
    SCOPED_TRACE(nameOf(d));
    SampledCase given(makePoints(d, reduced(400), 2));
    given.prepare(SampleMethod::Linear);
    const Bounds b = boundsOf(given.points);
    for (const std::size_t cells : { 7, 40, 83 })
    {
      const double dx = (b.xmax - b.xmin) / double(cells), dy = (b.ymax - b.ymin) / double(cells);
      const SampleRaster raster{ { b.xmin - 0.7 * dx, b.ymin - 1.2 * dy }, { dx, dy }, cells + 3,
        cells + 2 };
      expectAsCellByCell(given, raster);
    }
  }
}

/// Cells on vertices, on edges and between them, and in rows through vertices.
TEST(SampleRaster, AsCellByCellWhereItIsAlignedWithThePoints)
{
  SampledCase given(makePoints(Distribution::Lattice, 400, 1)); // 20 x 20
  given.prepare(SampleMethod::Linear);
  const Bounds b = boundsOf(given.points);
  ASSERT_EQ(b.xmax - b.xmin, 19.0);
  for (const double spacing : { 1.0, 0.5, 0.25, 0.75, 1.0 / 3.0 })
  {
    for (const double offset : { 0.0, 0.5, 0.3 })
    {
      const auto cells = std::size_t(22.0 / spacing);
      const SampleRaster raster{ { b.xmin - 1.0 + offset, b.ymin - 1.0 }, { spacing, spacing },
        cells, cells };
      EXPECT_GT(expectAsCellByCell(given, raster), 300u) << spacing << " " << offset;
    }
  }
}

TEST(SampleRaster, AsCellByCellWithHolesAndDroppedTriangles)
{
  for (const ConstraintCase& constrained : { nestedLoops(9), starPolygon(60) })
  {
    SampledCase given(constrained);
    given.prepare(SampleMethod::Linear);
    const Bounds b = boundsOf(given.points);
    const double dx = (b.xmax - b.xmin) / 72.0, dy = (b.ymax - b.ymin) / 72.0;
    EXPECT_GT(
      expectAsCellByCell(given, { { b.xmin - dx, b.ymin - dy }, { dx, dy }, 75, 75 }), 200u);
  }
  SampledCase given(makePoints(Distribution::Lattice, 400, 1));
  ASSERT_EQ(given.engine.made.makeCorners({}), Status::Ok);
  Random random(3);
  std::vector<unsigned char> kept(given.engine.made.triangleCount());
  for (unsigned char& one : kept)
  {
    one = random.below(3) != 0;
  }
  given.prepare(SampleMethod::Linear, kept.data());
  const Bounds b = boundsOf(given.points);
  for (const double spacing : { 1.0, 0.5, 0.37 })
  {
    const SampleRaster raster{ { b.xmin, b.ymin }, { spacing, spacing }, 60, 60 };
    EXPECT_GT(expectAsCellByCell(given, raster), 200u);
  }
}

/// Few large triangles, rows of many cells, columns of many rows.
TEST(SampleRaster, AsCellByCellInLargeTriangles)
{
  SampledCase given({ { 0, 0 }, { 1, 0.001 }, { 0.3, 1 }, { 0.001, 0.999 } });
  given.prepare(SampleMethod::Linear);
  for (const std::size_t columns : { 3, 20000 })
  {
    const std::size_t rows = 60000 / columns;
    const SampleRaster raster{ { -0.05, -0.05 }, { 1.1 / double(columns), 1.1 / double(rows) },
      columns, rows };
    EXPECT_GT(expectAsCellByCell(given, raster), 10000u);
  }
}

/// Degenerate rasters: spacings that are 0, negative or lost by rounding; far away, overflowing,
/// without cells, NaN.
TEST(SampleRaster, AsCellByCellWhereTheyAreOdd)
{
  SampledCase given(makePoints(Distribution::Uniform, 50, 1));
  given.prepare(SampleMethod::Linear);
  const SampleRaster odd[] = { { { 0.9, 0.9 }, { -0.07, -0.05 }, 14, 15 },
    { { 0.5, 0.1 }, { 0.0, 0.1 }, 12, 9 }, { { 0.5, 0.1 }, { 0x1p-56, 0.1 }, 30, 9 },
    { { 0.5, 0.5 }, { 0x1p-53, 0x1p-53 }, 12, 13 }, { { 0.5, 0.5 }, { 0x1p-47, 0x1p-47 }, 12, 13 },
    { { 1e300, 0.0 }, { 1e299, 0.1 }, 200, 10 }, { { kNotANumber, 0.0 }, { 0.1, 0.1 }, 10, 10 },
    { { 0.1, 0.1 }, { HUGE_VAL, 0.1 }, 9, 9 }, { { 5.0, 5.0 }, { 0.1, 0.1 }, 20, 20 },
    { { -3.0, 0.0 }, { 0.1, 0.1 }, 20, 20 }, { { 0.0, 0.0 }, { 0.1, 0.1 }, 0, 20 },
    { { 0.0, 0.0 }, { 0.1, 0.1 }, 20, 0 }, { { 0.5, 0.5 }, { 0.1, 0.1 }, 1, 1 } };
  std::size_t valued = 0;
  for (const SampleRaster& raster : odd)
  {
    SCOPED_TRACE(testing::Message() << raster.origin.x << " " << raster.spacing.x);
    valued += expectAsCellByCell(given, raster);
  }
  EXPECT_GT(valued, 400u);
}

/// Vertices on rows and columns up to rounding: crossings that only the exact predicates decide.
TEST(SampleRaster, AsCellByCellNextToEdges)
{
  Random random(9);
  std::vector<Point> points;
  for (int k = 0; k < 400; ++k)
  {
    const double x = 0.1 * double(random.below(20)), y = 0.1 * double(random.below(20));
    points.push_back({ x + 0x1p-52 * double(random.below(3)), y });
  }
  SampledCase given(points);
  given.prepare(SampleMethod::Linear);
  for (const double origin : { 0.0, 0.05, 0.1 })
  {
    EXPECT_GT(expectAsCellByCell(given, { { origin, 0.05 }, { 0.1, 0.1 }, 40, 40 }), 100u);
    EXPECT_GT(expectAsCellByCell(given, { { origin, 0.0 }, { 0.05, 0.05 }, 40, 40 }), 100u);
  }
}

/// Cells a few units in the last place from where their row crosses an edge.
TEST(SampleRaster, AsCellByCellWhereRoundingWouldMislead)
{
  Random random(4);
  const std::vector<double> values{ 1.0, 2.0, 4.0, 8.0 };
  std::size_t valued = 0;
  for (std::size_t i = 0; i < reduced(4000); ++i)
  {
    std::vector<Point> points;
    for (int k = 0; k < 4; ++k)
    {
      points.push_back({ random.unit(), random.unit() });
    }
    SampledCase given(points);
    given.prepare(SampleMethod::Linear);
    const Point &a = points[0], &b = points[1];
    const double y = a.y + random.unit() * (b.y - a.y);
    double x = a.x + (y - a.y) * ((b.x - a.x) / (b.y - a.y));
    for (std::size_t k = random.below(3); k != 0; --k)
    {
      x = std::nextafter(x, i % 2 == 0 ? 2.0 : -1.0);
    }
    const SampleRaster raster{ { x, y }, { 0.25, 0.25 }, 2, 2 };
    const std::vector<Point> cells = pointsOf(raster);
    const SampledValues found = sample(given.sampler, SamplePlaces(raster), values);
    ASSERT_EQ(difference(found, sample(given.sampler, SamplePlaces(viewOf(cells)), values)), "");
    valued += found.report.valued;
  }
  EXPECT_GT(valued, reduced(4000) / 2);
}

/// Edges so flat that x over y is more than any double.
TEST(SampleRaster, AsCellByCellAcrossEdgesWhoseSlopeOverflows)
{
  for (const double sign : { 1.0, -1.0 })
  {
    SampledCase given({ { 0, 0 }, { sign * 1e90, 2e-230 }, { sign * -1e90, 4e-230 }, { 0, -1 } });
    given.prepare(SampleMethod::Linear);
    EXPECT_GT(expectAsCellByCell(given, { { -1e90, 2e-230 }, { 5e89, 0.5 }, 5, 3 }), 2u);
    EXPECT_GT(expectAsCellByCell(given, { { -1e90, 3e-230 }, { 1e88, 0.5 }, 201, 1 }), 70u);
    EXPECT_GT(expectAsCellByCell(given, { { -1e90, -0.5 }, { 1e88, 0.5 }, 201, 2 }), 90u);
  }
}

TEST(SampleRaster, SeveralArraysOfSeveralComponentsWithoutMask)
{
  SampledCase given(makePoints(Distribution::Uniform, 200, 1));
  given.prepare(SampleMethod::Linear);
  std::vector<double> two, one;
  for (const Point& p : given.points)
  {
    two.push_back(p.x);
    two.push_back(p.y);
    one.push_back(p.x + p.y);
  }
  const SampleRaster raster{ { 0.0, 0.0 }, { 0.02, 0.02 }, 50, 50 };
  std::vector<double> outTwo(5000), outOne(2500);
  const SampleArray arrays[] = { { two.data(), 2, outTwo.data(), nullptr },
    { one.data(), 1, outOne.data(), nullptr } };
  SampleReport report;
  ASSERT_EQ(given.sampler.values(SamplePlaces(raster), arrays, 2, nullptr, report, {}), Status::Ok);
  std::vector<double> alone(2500);
  const SampleArray single{ one.data(), 1, alone.data(), nullptr };
  ASSERT_EQ(
    given.sampler.values(SamplePlaces(raster), &single, 1, nullptr, report, {}), Status::Ok);
  EXPECT_TRUE(areSame(alone, outOne));
  std::size_t valued = 0;
  for (std::size_t k = 0; k < 2500; ++k)
  {
    const Point p = SamplePlaces(raster)[k];
    const bool isIn = !std::isnan(outOne[k]);
    valued += isIn;
    ASSERT_TRUE(!isIn || std::fabs(outTwo[2 * k] - p.x) < 1e-14);
    ASSERT_TRUE(!isIn || std::fabs(outTwo[2 * k + 1] - p.y) < 1e-14);
    ASSERT_EQ(isIn, !std::isnan(outTwo[2 * k]));
  }
  EXPECT_EQ(valued, report.valued);
  EXPECT_GT(valued, 2000u);
}

} // namespace
} // namespace test
} // namespace ahd
