// SPDX-License-Identifier: BSD-3-Clause
//
// The fast insertion order against a literal implementation of the paper's section 3.
#include "Distributions.h"
#include "EngineRun.h"
#include "Order/Rank.h"
#include "Order/Sequence.h"
#include "PaperOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace ahd
{
namespace test
{
namespace
{

RankedPoints ranked(const std::vector<Point>& points)
{
  RankedPoints result;
  const PointView view = viewOf(points);
  Ticker reading(nullptr, Phase::Read, view.count);
  EXPECT_EQ(readPoints(view, reading, result), Status::Ok);
  Ticker ticker(nullptr, Phase::Sort, view.count);
  EXPECT_EQ(rankPoints(view, ticker, result), Status::Ok);
  return result;
}

/// Ids in the order of insertion; empty if the sequence is not a permutation.
std::vector<Index> fastOrder(const RankedPoints& points, const Options& options)
{
  Ticker ticker(nullptr, Phase::Sort, points.count);
  Buffer<Index> sequence;
  EXPECT_EQ(makeSequence(points, options, ticker, sequence), Status::Ok);
  std::vector<Index> ids;
  std::vector<char> seen(points.count, 0);
  for (const Index rank : sequence)
  {
    if (rank >= points.count || seen[rank])
    {
      ADD_FAILURE() << describe(options) << ": rank " << rank << " is out of range or repeated";
      return {};
    }
    seen[rank] = 1;
    ids.push_back(points.id[rank]);
  }
  EXPECT_EQ(ids.size(), points.count) << describe(options);
  return ids;
}

/// The first difference of two orders, for failure messages.
std::string firstDifference(const std::vector<Index>& a, const std::vector<Index>& b)
{
  if (a.size() != b.size())
  {
    return std::to_string(a.size()) + " points against " + std::to_string(b.size());
  }
  const auto where = std::mismatch(a.begin(), a.end(), b.begin());
  return where.first == a.end() ? ""
                                : "position " + std::to_string(where.first - a.begin()) +
      ": point " + std::to_string(*where.first) + " against " + std::to_string(*where.second);
}

void expectPaperOrder(const std::vector<Point>& points, const std::vector<int>& nmax)
{
  const RankedPoints sorted = ranked(points);
  ASSERT_TRUE(sorted.duplicates.empty()) << "the oracle wants distinct points";
  for (const Options& options : everySetting(nmax))
  {
    EXPECT_EQ(firstDifference(fastOrder(sorted, options), paperOrder(points, options).sequence), "")
      << describe(options);
  }
}

std::string nameOfParam(const ::testing::TestParamInfo<Distribution>& info)
{
  return nameOf(info.param);
}

class PaperDistribution : public ::testing::TestWithParam<Distribution>
{
};

TEST_P(PaperDistribution, FastOrderIsThePapers)
{
#ifdef AHD_REDUCED_TESTS
  expectPaperOrder(makePoints(GetParam(), 700, 11), { 1, 50 });
#else
  expectPaperOrder(makePoints(GetParam(), 6000, 11), { 1, 5, 50, 200 });
#endif
}

/// Consecutive boxes of the curve touch with the genes on; with the genes off some do not.
std::size_t jumps(const std::vector<PaperBox>& boxes)
{
  std::size_t count = 0;
  const auto side = [](const PaperBox& b) { return std::int64_t(1) << (32 - b.levels); };
  for (std::size_t i = 1; i < boxes.size(); ++i)
  {
    const PaperBox& a = boxes[i - 1];
    const PaperBox& b = boxes[i];
    const std::int64_t ax = a.column * side(a), ay = a.row * side(a);
    const std::int64_t bx = b.column * side(b), by = b.row * side(b);
    const std::int64_t gapX = std::max({ bx - ax - side(a), ax - bx - side(b) });
    const std::int64_t gapY = std::max({ by - ay - side(a), ay - by - side(b) });
    // 0: they share a line; negative: they overlap in this direction.
    const bool touch = std::max(gapX, gapY) == 0 && std::min(gapX, gapY) < 0;
    count += touch ? 0 : 1;
  }
  return count;
}

TEST_P(PaperDistribution, GenesKeepTheCurveTogether)
{
  const std::vector<Point> points = makePoints(GetParam(), 5000, 12);
  Options options;
  options.nmax = 5;
  EXPECT_EQ(jumps(paperOrder(points, options).boxes), 0u);
  options.geneRotation = false;
  EXPECT_GT(jumps(paperOrder(points, options).boxes), 0u) << "no box was divided twice?";
}

INSTANTIATE_TEST_SUITE_P(
  Paper, PaperDistribution, ::testing::ValuesIn(paperDistributions()), nameOfParam);

class ClusteredDistribution : public ::testing::TestWithParam<Distribution>
{
};

TEST_P(ClusteredDistribution, FastOrderIsThePapers)
{
  // Random exponents make the oracle's boxes very deep.
  const std::size_t n = GetParam() == Distribution::AnyFinite ? 150 : 1500;
  expectPaperOrder(makePoints(GetParam(), n, 13), { 1, 50 });
}

INSTANTIATE_TEST_SUITE_P(Clustered, ClusteredDistribution,
  ::testing::Values(Distribution::KuzminDisc, Distribution::NestedClusters,
    Distribution::CrowdedBox, Distribution::Lattice, Distribution::OnCircle, Distribution::Slivers,
    Distribution::Huge, Distribution::TinyAndHuge, Distribution::AnyFinite),
  nameOfParam);

TEST(Sequence, FewPoints)
{
  for (std::size_t n = 1; n <= 20; ++n)
  {
    expectPaperOrder(makePoints(Distribution::Uniform, n, n), { 1, 2, 16, 1000 });
  }
}

TEST(Sequence, NoPoints)
{
  const std::vector<Point> none;
  const RankedPoints sorted = ranked(none);
  for (const Options& options : everySetting({ 1, 50 }))
  {
    EXPECT_TRUE(fastOrder(sorted, options).empty()) << describe(options);
  }
}

TEST(Sequence, CrowdTooSmallForTheFinestGrid)
{
  // Two far corners, and a crowd that shares a box of the finest grid.
  std::vector<Point> points = makePoints(Distribution::Uniform, 600, 3);
  for (Point& p : points)
  {
    p = { 0.25 + p.x * 0x1p-40, 0.75 + p.y * 0x1p-40 };
  }
  points.push_back({ 0.0, 0.0 });
  points.push_back({ 1.0, 1.0 });
  expectPaperOrder(points, { 1, 50, 599, 600, 1000 });
}

TEST(Sequence, BigBoxesComeInTheCallersOrder)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 20000, 4);
  const RankedPoints sorted = ranked(points);
  Options options;
  options.controlPoints = ControlPoints::Off;
  options.nmax = 20000;
  for (const InsertionOrder order :
    { InsertionOrder::AdaptiveHilbert, InsertionOrder::MultiGrid, InsertionOrder::AsGiven })
  {
    options.order = order;
    const std::vector<Index> ids = fastOrder(sorted, options);
    for (Index i = 0; i < ids.size(); ++i)
    {
      ASSERT_EQ(ids[i], i) << describe(options);
    }
  }
}

TEST(Sequence, EverySettingIsAPermutationOfManyPoints)
{
#ifdef AHD_REDUCED_TESTS
  const std::size_t n = 20000;
#else
  const std::size_t n = 70000;
#endif
  for (const Distribution d : { Distribution::Mixed, Distribution::KuzminDisc,
         Distribution::RepeatedDraws, Distribution::AllEqual, Distribution::Utm })
  {
    const RankedPoints sorted = ranked(makePoints(d, n, 5));
    for (const Options& options : everySetting({ 1, 10000 }))
    {
      SCOPED_TRACE(nameOf(d));
      fastOrder(sorted, options);
    }
  }
}

TEST(Sequence, LevelsOfDivisionFollowTheRule)
{
  EXPECT_EQ(levelsOfDivision(0), 1u);
  EXPECT_EQ(levelsOfDivision(1), 1u);
  EXPECT_EQ(levelsOfDivision(64), 1u); // 16 per box
  EXPECT_EQ(levelsOfDivision(65), 2u); // 16.25 per box with one level
  EXPECT_EQ(levelsOfDivision(256), 2u);
  EXPECT_EQ(levelsOfDivision(257), 3u);
  EXPECT_EQ(levelsOfDivision(2000000), 9u); // 7.6 per box
  EXPECT_EQ(levelsOfDivision(kMaximumPoints), 12u);
}

} // namespace
} // namespace test
} // namespace ahd
