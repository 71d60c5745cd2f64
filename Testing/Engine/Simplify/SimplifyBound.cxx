// SPDX-License-Identifier: BSD-3-Clause
//
// The bound at all points, measured on what triangulate() and constrain() make of those kept.
#include "SimplifyCase.h"

#include "Predicates/Predicates.h"
#include "Sample/Sample.h"
#include "Shores.h"

#include <algorithm>
#include <limits>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// The surface of the points kept, sampled at all points.
struct Surface
{
  Surface(const SimplifyCase& given, const SimplifyResult& result)
    : values(given.count(), 0.0)
    , mask(given.count(), 0)
  {
    EXPECT_EQ(engine.run(result.without(given.view())), Status::Ok);
    EXPECT_EQ(engine.constrain(given.constraints.asLines().view(), FillRule::EvenOdd), Status::Ok);
    std::vector<double> heights;
    for (std::size_t i = 0; i < given.count(); ++i)
    {
      heights.push_back(given.height(i));
    }
    Sampler sampler;
    EXPECT_EQ(sampler.prepare(engine.made, nullptr, SampleMethod::Linear, {}), Status::Ok);
    const SampleArray array{ heights.data(), 1, values.data(), nullptr };
    SampleReport report;
    EXPECT_EQ(sampler.values(SamplePlaces(given.view()), &array, 1, mask.data(), report, Context()),
      Status::Ok);
  }

  Engine engine;
  std::vector<double> values;
  std::vector<unsigned char> mask;
};

/// The sampler rounds; its values are checked against its own limits elsewhere.
double slack(const SimplifyCase& given)
{
  double most = 0.0;
  for (std::size_t i = 0; i < given.count(); ++i)
  {
    most = std::isfinite(given.height(i)) ? std::max(most, std::fabs(given.height(i))) : most;
  }
  return 1e-9 * most;
}

/// @return the points kept
std::size_t expectWithin(const SimplifyCase& given, const SimplifyResult& result)
{
  const Surface surface(given, result);
  double largest = 0.0;
  std::size_t within = 0;
  for (std::size_t i = 0; i < given.count(); ++i)
  {
    if (result.lots[i] == PointLot::WithinError)
    {
      ++within;
      EXPECT_NE(surface.mask[i], 0) << "point " << i << " lies on no triangle";
      largest = std::max(largest, std::fabs(surface.values[i] - given.height(i)));
    }
  }
  EXPECT_GE(within, result.withinError) << "places";
  EXPECT_TRUE(result.isWithinBound);
  EXPECT_LE(result.largestError, given.settings.maximumError);
  EXPECT_NEAR(largest, result.largestError, slack(given));
  return result.kept;
}

TEST(SimplifyBound, OfHills)
{
  for (const bool secondPass : { false, true })
  {
    SimplifyCase given = hills(reduced(60000), 3);
    given.settings.secondPass = secondPass;
    std::size_t last = given.count();
    for (const double bound : { 0.001, 0.01, 0.1, 1.0 })
    {
      given.settings.maximumError = bound;
      const std::size_t kept = expectWithin(given, given.simplified());
      EXPECT_LT(kept, last);
      last = kept;
    }
    EXPECT_LT(last, 200u);
  }
}

TEST(SimplifyBound, TheSecondPassTakesSomeOut)
{
  SimplifyCase given = hills(reduced(40000), 5, 0.1);
  given.settings.maximumError = 0.05;
  const std::size_t once = given.simplified().kept;
  given.settings.secondPass = true;
  EXPECT_LT(expectWithin(given, given.simplified()), once - once / 50);
}

TEST(SimplifyBound, WithShoreLinesThatStay)
{
  SimplifyCase given = hills(reduced(20000), 4);
  for (const std::vector<Point>& line : shoreLines(20, 0))
  {
    std::vector<std::int64_t> ids;
    for (const Point& p : line)
    {
      ids.push_back(std::int64_t(given.count()));
      given.add(p, hillsAt(p));
    }
    given.constraints.addLine(ids);
  }
  given.settings.maximumError = 0.05;
  for (const bool secondPass : { false, true })
  {
    given.settings.secondPass = secondPass;
    const SimplifyResult result = given.simplified();
    expectWithin(given, result);
    for (std::size_t chain = 0; chain < given.constraints.chains(); ++chain)
    {
      for (const std::int64_t id : given.constraints.chain(chain))
      {
        EXPECT_NE(result.lots[std::size_t(id)], PointLot::WithinError);
      }
    }
  }
}

/// Segments that cross where there is a point, or is none: constrain() takes the first.
TEST(SimplifyBound, WithSegmentsThatCross)
{
  for (std::uint64_t seed = 1; seed <= reduced(100); ++seed)
  {
    SimplifyCase given;
    Random random(seed);
    for (int k = 0; k < 100; ++k)
    {
      given.add({ double(k % 10), double(k / 10) }, double(random.below(8)));
    }
    for (int k = 0; k < 12; ++k)
    {
      given.constraints.addLine(
        { std::int64_t(random.below(100)), std::int64_t(random.below(100)) });
    }
    given.settings.maximumError = 1.5;
    given.settings.secondPass = seed % 2 == 0;
    expectWithin(given, given.simplified());
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed;
  }
}

/// A loop around a hole: its triangles go, the bound holds on both sides.
TEST(SimplifyBound, AroundAHole)
{
  SimplifyCase given = hills(reduced(20000), 8);
  std::vector<std::int64_t> hole;
  for (const Point& p : { Point{ 0.4, 0.4 }, { 0.6, 0.4 }, { 0.6, 0.6 }, { 0.4, 0.6 } })
  {
    hole.push_back(std::int64_t(given.count()));
    given.add(p, hillsAt(p));
  }
  given.constraints.addLoop({ hole.rbegin(), hole.rend() });
  given.settings.maximumError = 0.05;
  const SimplifyResult result = given.simplified();
  expectWithin(given, result);
  Engine engine;
  ASSERT_EQ(engine.run(result.without(given.view())), Status::Ok);
  const std::size_t all = engine.report().triangles;
  ASSERT_EQ(engine.constrain(given.constraints.view(), FillRule::Orientation), Status::Ok);
  EXPECT_LT(engine.report().triangles, all);
  EXPECT_GT(engine.report().triangles, 0u);
}

/// Coordinates whose last bit is 1/64.
TEST(SimplifyBound, FarFromTheOrigin)
{
  SimplifyCase given;
  Random random(3);
  for (std::size_t k = 0; k < reduced(5000); ++k)
  {
    const double x = double(random.below(64 * 64)) / 64.0, y = double(random.below(64 * 64)) / 64.0;
    given.add({ 1e14 + x, 1e14 + y }, 1e9 + hillsAt({ x / 64.0, y / 64.0 }));
  }
  given.settings.maximumError = 0.25;
  given.settings.secondPass = true;
  EXPECT_LT(expectWithin(given, given.simplified()), given.count() / 10);
}

TEST(SimplifyBound, OfAPlaneFourCornersAreLeft)
{
  SimplifyCase given;
  for (int k = 0; k < 10000; ++k)
  {
    const double x = double(k % 100), y = double(k / 100);
    given.add({ x, y }, 3.0 * x - 2.0 * y + 7.0);
  }
  EXPECT_EQ(expectWithin(given, given.simplified()), 4u);
  given.numbers[3 * 5050 + 2] += 0x1p-40;
  EXPECT_EQ(expectWithin(given, given.simplified()), 9u) << "it, and those around it";
}

/// The least number above 0.1 that a height of it is wrong by is not within 0.1.
TEST(SimplifyBound, IsMeasuredInWiderArithmetic)
{
  SimplifyCase given;
  for (const double x : { 0.0, 3.0 })
  {
    for (const double y : { 0.0, 3.0 })
    {
      given.add({ x, y }, 0.3 * x);
    }
  }
  given.add({ 1.0, 1.0 }, 0.4); // 0.3 plus 0.1, rounded: 0.1 is above a tenth, and 0.3 below
  const double third = 0.3 * 3.0 / 3.0;
  given.settings.maximumError = 0.4 - third;
  const SimplifyResult result = given.simplified();
  EXPECT_LE(result.largestError, given.settings.maximumError);
  given.settings.maximumError = 0.2;
  EXPECT_EQ(given.simplified().kept, 4u);
}

TEST(SimplifyBound, PointsWithoutAHeightStayAndWhatIsBesideThem)
{
  SimplifyCase given = hills(reduced(10000), 6);
  given.settings.maximumError = 0.5;
  given.numbers[3 * 700 + 2] = kNotANumber;
  given.numbers[3 * 900 + 2] = std::numeric_limits<double>::infinity();
  const SimplifyResult result = given.simplified();
  EXPECT_EQ(result.lots[700], PointLot::Kept);
  EXPECT_EQ(result.lots[900], PointLot::Kept);
  EXPECT_LT(result.kept, given.count() / 10);
  expectWithin(given, result);
}

/// Not the many that once were in triangles with it, when these were large.
TEST(SimplifyBound, FewPointsStayForOneWithoutAHeight)
{
  constexpr int kSide = 200;
  SimplifyCase given;
  for (int k = 0; k < kSide * kSide; ++k)
  {
    const double x = double(k % kSide), y = double(k / kSide);
    given.add({ x, y }, hillsAt({ x / kSide, y / kSide }));
  }
  given.settings.maximumError = 0.5;
  const std::size_t all = given.simplified().kept;
  given.numbers[3 * (90 * kSide + 110) + 2] = kNotANumber;
  EXPECT_LT(expectWithin(given, given.simplified()), all + 30);
  given.settings.maximumError = 0.0;
  given.settings.maximumNumberOfVertices = all + 30;
  EXPECT_LT(given.simplified().largestError, 2.0) << "there are vertices left for the others";
}

/// A point on an edge of a triangle with a corner of -3.4e38, a value for "none": the edge alone
/// says how wrong it is.
TEST(SimplifyBound, ValuesForNoneDoNotHideErrorsOnEdges)
{
  std::size_t out = 0;
  for (std::uint64_t seed = 1; seed <= reduced(2000); ++seed)
  {
    Random random(seed);
    SimplifyCase given;
    for (int k = 0; k < 64; ++k)
    {
      const bool isNone = random.below(15) == 0;
      given.add({ 0.1 * (k % 8), 0.1 * (k / 8) }, // differences are rounded
        isNone ? -double(std::numeric_limits<float>::max()) : double(random.below(10)));
    }
    given.settings.maximumError = 4.0;
    const SimplifyResult result = given.simplified();
    const Surface surface(given, result);
    for (std::size_t i = 0; i < given.count(); ++i)
    {
      out += result.lots[i] == PointLot::WithinError;
      ASSERT_LE(std::fabs(surface.values[i] - given.height(i)), 4.0 + 1e-9) << seed << ", " << i;
    }
  }
  EXPECT_GT(out, reduced(2000));
}

TEST(SimplifyBound, OfDuplicatesThatOfTheRepresentativeCounts)
{
  for (const Representative representative :
    { Representative::FirstId, Representative::LowestZ, Representative::HighestZ })
  {
    SimplifyCase given;
    for (int k = 0; k < 900; ++k)
    {
      given.add({ double(k % 30), double(k / 30) }, 0.0);
    }
    const std::size_t first = given.count();
    given.add({ 7.0, 7.0 }, 5.0);
    given.add({ 9.0, 9.0 }, -5.0);
    given.settings.representative = representative;
    given.settings.maximumError = 1.0;
    const SimplifyResult result = given.simplified();
    const bool isHigh = representative == Representative::HighestZ;
    const bool isLow = representative == Representative::LowestZ;
    EXPECT_EQ(result.lots[first] == PointLot::Kept, isHigh);
    EXPECT_EQ(result.lots[first + 1] == PointLot::Kept, isLow);
    EXPECT_EQ(result.lots[7 * 30 + 7], result.lots[first]);
    EXPECT_EQ(result.kept + result.withinError, first);
  }
}

TEST(SimplifyBound, WeightsAndMarks)
{
  SimplifyCase given = hills(reduced(20000), 10);
  given.settings.maximumError = 0.5;
  std::vector<double> weights(given.count(), 1.0);
  std::vector<unsigned char> marks(given.count(), 0);
  for (std::size_t i = 0; i < given.count(); ++i)
  {
    weights[i] = given.at(i).x < 0.5 ? 10.0 : 0.1;
    marks[i] = i % 1000 == 0;
  }
  weights[7] = kNotANumber;
  weights[8] = -1.0;
  given.settings.weights.doubles = weights.data();
  given.settings.mustStay = marks.data();
  const SimplifyResult result = given.simplified();
  const Surface surface(given, result);
  const double most = 0.5 + slack(given);
  for (std::size_t i = 0; i < given.count(); ++i)
  {
    const double error = std::fabs(surface.values[i] - given.height(i));
    EXPECT_TRUE(marks[i] == 0 || result.lots[i] == PointLot::Kept);
    EXPECT_TRUE(result.lots[i] == PointLot::Kept || weights[i] * error <= most);
  }
  EXPECT_EQ(result.lots[7], PointLot::Kept);
  EXPECT_EQ(result.lots[8], PointLot::Kept);
}

TEST(SimplifyBound, OfAnyValues)
{
  SimplifyCase given = hills(reduced(20000), 11);
  std::vector<float> values(2 * given.count());
  for (std::size_t i = 0; i < given.count(); ++i)
  {
    values[2 * i] = float(given.height(i));
    values[2 * i + 1] = 77.0f;
    given.numbers[3 * i + 2] = double(values[2 * i]);
  }
  given.settings.maximumError = 0.1;
  const SimplifyResult byHeight = given.simplified();
  SimplifyCase flat = given;
  for (std::size_t i = 0; i < given.count(); ++i)
  {
    flat.numbers[3 * i + 2] = 0.0;
  }
  flat.settings.values = { nullptr, values.data(), 2 };
  const SimplifyResult byValue = flat.simplified();
  EXPECT_EQ(keptIds(byValue), keptIds(byHeight));
  EXPECT_EQ(byValue.largestError, byHeight.largestError);
}

TEST(SimplifyBound, ALimitOfVerticesLeavesTheLeastErrorOnTheWay)
{
  SimplifyCase given = hills(reduced(20000), 12, 0.5);
  given.settings.maximumError = 0.3;
  const SimplifyResult bounded = given.simplified();
  given.settings.maximumNumberOfVertices = bounded.kept;
  given.settings.maximumError = 0.0;
  for (const bool secondPass : { false, true })
  {
    given.settings.secondPass = secondPass;
    const SimplifyResult limited = given.simplified();
    EXPECT_FALSE(limited.isWithinBound);
    EXPECT_LE(limited.kept, bounded.kept);
    EXPECT_LT(limited.largestError, 0.4);
    EXPECT_GT(limited.largestError, 0.0);
  }
  given.settings.maximumNumberOfVertices = 2;
  EXPECT_GT(given.simplified().kept, 2u) << "the hull stays";
}

} // namespace
} // namespace test
} // namespace ahd
