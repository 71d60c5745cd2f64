// SPDX-License-Identifier: BSD-3-Clause
//
// More points, or more ids in chains, than the engine takes: refused before anything is read, and
// nothing overflows. This program's engine has low limits (AHD_MAXIMUM_POINTS, AHD_MOST_CHAIN_IDS).
#include "Crossings/Crossings.h"
#include "Merge/Merge.h"
#include "Voronoi/Voronoi.h"

#include "EngineRun.h"
#include "Executors.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

static_assert(kMaximumPoints == 1000 && AHD_MOST_CHAIN_IDS == 100, "low limits");

/// Must not be polled: nothing was begun.
class Nobody : public Progress
{
public:
  void beginPhase(Phase) override { ADD_FAILURE() << "work has begun"; }
  bool advance(Phase, double) override { return true; }
};

/// So many points at one place that does not exist: reading any of them ends the program.
PointView unreadable(std::size_t count)
{
  return PointView(reinterpret_cast<const double*>(16), count, 0);
}

const std::size_t kTooMany[] = { kMaximumPoints + 1, std::size_t(1) << 28, std::size_t(1) << 31,
  (std::size_t(1) << 32) + 1, std::size_t(1) << 60, std::size_t(-1) };

TEST(FaultsLimits, TooManyPointsAreRefusedUnread)
{
  Engine engine;
  Nobody nobody;
  ThreadExecutor threads(3);
  for (const std::size_t count : kTooMany)
  {
    for (Options options : everyDistinctSetting({ 50 }))
    {
      options.keepOrder = options.keepBoxes = options.countWork = true;
      EXPECT_EQ(engine.run(unreadable(count), options, &nobody, &threads), Status::TooManyPoints);
      EXPECT_EQ(engine.report().triangles, 0u);
      EXPECT_EQ(engine.workspace.bytes(), 0u);
    }
    MergedPoints merged;
    EXPECT_EQ(mergeWithin(unreadable(count), 1.0, &nobody, merged), Status::TooManyPoints);
    SplitConstraints split;
    EXPECT_EQ(
      splitAtCrossings(unreadable(count), ConstraintView(), nullptr, split), Status::TooManyPoints);
  }
}

TEST(FaultsLimits, AsManyAsAllowedAreTriangulated)
{
  Engine engine;
  std::vector<Point> points = makePoints(Distribution::Mixed, kMaximumPoints, 1);
  EXPECT_EQ(faultsOf(points, triangulate(engine, viewOf(points))), "");
  points.push_back({ 0.5, 0.5 });
  EXPECT_EQ(triangulate(engine, viewOf(points)).status, Status::TooManyPoints);
  points.pop_back();
  EXPECT_EQ(faultsOf(points, triangulate(engine, viewOf(points))), "") << "once more";
}

TEST(FaultsLimits, EstimatesDoNotOverflow)
{
  const Options options;
  for (const std::size_t count : kTooMany)
  {
    EXPECT_EQ(triangulationMemoryEstimate(count, options), std::size_t(-1));
  }
  EXPECT_LT(triangulationMemoryEstimate(kMaximumPoints, options), std::size_t(1) << 30);
}

/// `rows` lines and as many columns of a lattice that cross each other everywhere, none in a point.
struct Grating
{
  explicit Grating(std::size_t rows)
  {
    for (std::size_t i = 0; i < rows; ++i)
    {
      const double at = double(i) + 0.5;
      points.insert(
        points.end(), { { -1.0, at }, { double(rows), at }, { at, -1.0 }, { at, double(rows) } });
      for (std::int64_t k = 0; k < 4; ++k)
      {
        ids.push_back(std::int64_t(4 * i) + k);
      }
      offsets.push_back(std::int64_t(4 * i) + 2);
      offsets.push_back(std::int64_t(4 * i) + 4);
    }
  }
  ConstraintView view() const
  {
    return { ids.data(), offsets.data(), offsets.size() - 1, offsets.size() - 1 };
  }
  Status split(SplitConstraints& out) const
  {
    return splitAtCrossings(viewOf(points), view(), nullptr, out);
  }

  std::vector<Point> points;
  std::vector<std::int64_t> ids, offsets{ 0 };
};

TEST(FaultsLimits, TooManyIdsInChainsAreRefused)
{
  SplitConstraints split;
  const Grating given(26); // 104 ids, and they cross 676 times
  EXPECT_EQ(given.split(split), Status::TooManyPoints);
}

TEST(FaultsLimits, IdsThatBecomeTooManyBySplittingAreRefused)
{
  SplitConstraints split;
  const Grating few(5); // 20 ids, and two more for each of 25 crossings
  EXPECT_EQ(few.split(split), Status::Ok);
  EXPECT_EQ(split.ids.size(), 70u);
  const Grating many(7); // 28 ids and two for each of 49
  EXPECT_EQ(many.split(split), Status::TooManyPoints);
}

TEST(FaultsLimits, PointsThatBecomeTooManyBySplittingAreRefused)
{
  Grating given(5);
  given.points.resize(kMaximumPoints - 25, Point{ 100.0, 100.0 });
  SplitConstraints split;
  EXPECT_EQ(given.split(split), Status::Ok);
  EXPECT_EQ(split.points.size(), 25u);
  given.points.push_back({ 100.0, 100.0 });
  EXPECT_EQ(given.split(split), Status::TooManyPoints);
}

} // namespace
} // namespace test
} // namespace ahd
