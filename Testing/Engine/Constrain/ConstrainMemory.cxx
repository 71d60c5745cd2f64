// SPDX-License-Identifier: BSD-3-Clause
//
// The memory of constraints: the estimate and the bytes requested during insertion are no less than
// those taken, and not much more. This program's operator new counts.
#include "ConstraintMakers.h"
#include "Distributions.h"
#include "EngineRun.h"
#include "MemoryListener.h"
#include "OwnMemory.h"
#include "Shores.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

struct Taken
{
  std::size_t peak, asked;
};

/// Triangulates and constrains.
Taken takenBy(const ConstraintCase& given, MemoryListener& listener, Status expected)
{
  const std::size_t before = account.held;
  account.peak = before;
  Engine engine;
  EXPECT_EQ(engine.run(given.view(), Options(), nullptr), Status::Ok);
  EXPECT_EQ(engine.constrain(given.constraints.view(), FillRule::EvenOdd, &listener), expected);
  return { account.peak - before, listener.memory.most() };
}

std::size_t known(const ConstraintCase& given)
{
  const std::size_t n = given.points.size();
  const ConstraintView view = given.constraints.view();
  return triangulationMemoryEstimate(n, Options()) +
    knownConstraintMemory(n, std::size_t(view.offsets[view.chains]));
}

void expectAsked(const ConstraintCase& given, double atMost, const char* name)
{
  MemoryListener listener;
  const Taken taken = takenBy(given, listener, Status::Ok);
  const std::size_t all = known(given) + taken.asked;
  EXPECT_LE(taken.peak, all) << name << ": " << taken.asked << " asked";
  EXPECT_LE(double(all), atMost * double(taken.peak)) << name << ": " << taken.asked << " asked";
}

ConstraintCase shores(bool areLoops)
{
  ConstraintCase given;
  for (const std::vector<Point>& line : shoreLines(100, 0))
  {
    std::vector<std::int64_t> ids;
    for (std::size_t k = 0; k + 1 != line.size(); ++k)
    {
      ids.push_back(std::int64_t(given.points.size()));
      given.points.push_back(line[k]);
    }
    if (!areLoops)
    {
      ids.push_back(ids.front());
    }
    areLoops ? given.constraints.addLoop(ids) : given.constraints.addLine(ids);
  }
  return given;
}

TEST(ConstrainMemory, OfWhatIsLikeShoresHalfAsMuchMoreIsEstimated)
{
  expectAsked(shores(false), 1.5, "shores");
  expectAsked(shores(true), 1.5, "shores, filled");
  expectAsked(shortSegments(60000, 20000), 1.5, "short");
}

TEST(ConstrainMemory, OfTheWorstTwiceAsMuchIs)
{
  expectAsked(edgesOfOthers(40000, 20000), 2.0, "edges of others");
  expectAsked(randomSegments(40000, 400), 2.0, "random");
  expectAsked(latticeSegments(150, 20000), 2.0, "lattice");
  expectAsked(starPolygon(10000), 2.0, "star");
  expectAsked(nestedLoops(60), 2.0, "nested");
}

/// The lists of crossing segments of all territories are joined into one and freed.
TEST(ConstrainMemory, ListsThatWereGatheredAreGone)
{
  constexpr std::size_t segments = 20000;
  const ConstraintCase given = latticeSegments(150, segments);
  Engine engine;
  EXPECT_EQ(engine.run(given.view(), Options(), nullptr), Status::Ok);
  const std::size_t before = account.held;
  account.peak = before;
  EXPECT_EQ(engine.constrain(given.constraints.view(), FillRule::EvenOdd, nullptr), Status::Ok);
  EXPECT_LT(account.peak - before, 105 * segments); // 109 with them
}

TEST(ConstrainMemory, WhatIsAskedForMayBeRefused)
{
  for (const ConstraintCase& given : { shores(true), latticeSegments(150, 20000) })
  {
    MemoryListener all;
    const Taken whole = takenBy(given, all, Status::Ok);
    ASSERT_GT(whole.asked, 0u);
    for (const std::size_t most : { std::size_t(0), whole.asked / 2, whole.asked - 1 })
    {
      MemoryListener listener(most);
      const Taken taken = takenBy(given, listener, Status::OutOfMemory);
      EXPECT_TRUE(listener.memory.wasRefused());
      EXPECT_LE(taken.peak, known(given) + most) << most;
    }
    MemoryListener enough(whole.asked);
    takenBy(given, enough, Status::Ok);
  }
}

} // namespace
} // namespace test
} // namespace ahd
